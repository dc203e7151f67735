#!/usr/bin/env python3
"""What this version cannot compute exactly is said, never answered as something simpler."""
import math

from footprint_collision_predictor.msg import CollisionWarning
from node_testing import PATIENT, circle
from ros_test_case import RosTestCase, run

NOT_SUPPORTED = CollisionWarning.REASON_NOT_SUPPORTED
TOUCHING = circle(8, (1.25, 0))  # 0.25 m deep in the front


class NotSupported(RosTestCase):
    def driving(self, yaw_rate, *obstacles):
        """The answers of a robot that drives at 1 m/s, and turns."""
        node = self.rig(**dict(PATIENT, ego_motion='odom', transform_tolerance=20.0))
        stamp = node.send_odometry(linear=(1, 0), angular=yaw_rate)
        node.send(obstacles, stamp=stamp)
        return node.warning_at(stamp), node.prediction_at(stamp), node.next_warning()

    def test_growing_radius(self):
        growing = circle(42, (9, 9))
        growing.radius_rate = 0.1
        node = self.rig(**PATIENT)
        warning = node.warning_at(node.send([growing]))
        self.assertUnknown(warning, NOT_SUPPORTED)
        self.assertSays(warning, 'id 42', 'radius_rate')
        hit = node.warning_at(node.send([growing, circle(7, (2.5, 0), (-1, 0))]))
        self.assertEqual((hit.level, hit.obstacle_id), (hit.CRITICAL, 7))
        self.assertEqual(hit.reason & NOT_SUPPORTED, NOT_SUPPORTED)

    def test_turning(self):
        """No straight-line answer, neither at the stamp nor later: the obstacle lies dead ahead,
        where the straight line would touch it after 1 s."""
        at_stamp, prediction, later = self.driving(0.5, circle(7, (2.5, 0)))
        for warning in at_stamp, later:
            self.assertUnknown(warning, NOT_SUPPORTED)
            self.assertSays(warning, '0.5 rad/s')
            self.assertTrue(math.isnan(warning.time_to_collision), warning)
            self.assertEqual(warning.collision_predicted, 0)
        for segment in prediction.segments:
            self.assertTrue(math.isnan(segment.time_to_collision), segment)
            self.assertEqual(segment.contact_free_time, 0)
        self.assertEqual(prediction.twist.angular.z, 0.5)

    def test_turning_the_other_way(self):
        at_stamp, _, _ = self.driving(-0.5, circle(7, (2.5, 0)))
        self.assertUnknown(at_stamp, NOT_SUPPORTED)

    def test_touching_now_while_turning(self):
        at_stamp, _, _ = self.driving(0.5, TOUCHING)
        self.assertEqual((at_stamp.level, at_stamp.time_to_collision), (at_stamp.CRITICAL, 0))
        self.assertEqual(at_stamp.obstacle_id, 8)

    def test_a_turn_without_effect_is_predicted(self):
        """1e-6 rad/s moves nothing by more than a tenth of a millimetre within the horizon."""
        at_stamp, _, _ = self.driving(1e-6, circle(7, (2.5, 0)))
        self.assertEqual(at_stamp.reason & NOT_SUPPORTED, 0, at_stamp)
        self.assertEqual(at_stamp.level, at_stamp.CRITICAL)
        self.assertAlmostEqual(at_stamp.time_to_collision, 1.0, delta=1e-4)

    def test_touching_now_without_odometry(self):
        """Where the robot is does not depend on how it moves."""
        node = self.rig(**dict(PATIENT, ego_motion='odom'))
        warning = node.warning_at(node.send([circle(7, (2.5, 0), (-1, 0)), TOUCHING]))
        self.assertEqual((warning.level, warning.time_to_collision), (warning.CRITICAL, 0))
        self.assertEqual(warning.obstacle_id, 8)
        self.assertEqual(warning.contact_free_time, 0)
        self.assertEqual(warning.reason & warning.REASON_ODOM_MISSING, warning.REASON_ODOM_MISSING)
        self.assertSays(warning, node.topic('odom'), '~ego_motion')

    def test_no_hit_is_claimed_without_odometry(self):
        node = self.rig(**dict(PATIENT, ego_motion='odom'))
        warning = node.warning_at(node.send([circle(7, (2.5, 0), (-1, 0))]))
        self.assertUnknown(warning, warning.REASON_ODOM_MISSING)
        self.assertTrue(math.isnan(warning.time_to_collision), warning)


if __name__ == '__main__':
    run('not_supported', NotSupported)
