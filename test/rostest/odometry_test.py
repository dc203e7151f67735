#!/usr/bin/env python3
"""Which odometry a message is evaluated with, and odometry that cannot be used."""
import math

import rospy
from footprint_collision_predictor.msg import CollisionWarning
from node_testing import PATIENT, circle
from ros_test_case import RosTestCase, run

STANDING = circle(7, (4, 0))  # 2.5 m before the front
APPROACHING = circle(7, (2.5, 0), (-1, 0))
INVALID = CollisionWarning.REASON_ODOM_INVALID


def ago(seconds):
    return rospy.Time.now() - rospy.Duration.from_sec(seconds)


class Odometry(RosTestCase):
    def driving(self, **parameters):
        return self.rig(**dict(PATIENT, ego_motion='odom', **parameters))

    def test_Fault23_the_newest_at_or_before_the_stamp(self):
        """It drives 1 m/s before, 2 m/s after; at the stamp itself the new speed counts."""
        node = self.driving(transform_tolerance=20.0)
        first, between, second = ago(0.3), ago(0.2), ago(0.1)
        node.send_odometry((1, 0), stamp=first)
        node.send_odometry((2, 0), stamp=second)
        node.send([STANDING], stamp=between)
        self.assertAlmostEqual(node.warning_at(between).time_to_collision, 2.5, delta=1e-9)
        node.send([STANDING], stamp=second)
        self.assertAlmostEqual(node.warning_at(second).time_to_collision, 1.25, delta=1e-9)

    def test_Fault22_an_older_one_is_ignored(self):
        node = self.driving(transform_tolerance=20.0)
        older, newer = ago(0.2), ago(0.1)
        node.send_odometry((1, 0), stamp=newer)
        node.send_odometry((2, 0), stamp=older)
        node.send([STANDING], stamp=newer)
        self.assertAlmostEqual(node.warning_at(newer).time_to_collision, 2.5, delta=1e-9)

    def test_touching_now_without_any(self):
        """Where the robot is does not depend on how it moves."""
        node = self.driving()
        touching = circle(8, (1.25, 0))  # 0.25 m deep in the front
        warning = node.warning_at(node.send([APPROACHING, touching]))
        self.assertEqual((warning.level, warning.time_to_collision), (warning.CRITICAL, 0))
        self.assertEqual(warning.obstacle_id, 8)
        self.assertEqual(warning.contact_free_time, 0)
        self.assertEqual(warning.reason & warning.REASON_ODOM_MISSING, warning.REASON_ODOM_MISSING)
        self.assertSays(warning, node.topic('odom'), '~ego_motion')

    def test_no_hit_is_claimed_without_any(self):
        node = self.driving()
        warning = node.warning_at(node.send([APPROACHING]))
        self.assertUnknown(warning, warning.REASON_ODOM_MISSING)
        for value in warning.time_to_collision, warning.closest_distance, warning.closest_time:
            self.assertTrue(math.isnan(value), warning)

    def test_none_before_the_stamp(self):
        node = self.driving()
        before, first = ago(0.2), ago(0.1)
        node.send_odometry((1, 0), stamp=first)
        warning = node.warning_at(node.send([STANDING], stamp=before))
        self.assertUnknown(warning, warning.REASON_ODOM_MISSING)

    def test_Fault23_stale_at_the_stamp(self):
        node = self.driving(transform_tolerance=2.0)  # in which the odometry has come
        node.send_odometry((1, 0), stamp=ago(31))
        warning = node.warning_at(node.send([STANDING]))
        self.assertUnknown(warning, warning.REASON_ODOM_STALE)
        self.assertSays(warning, 'odometry', 'max_data_age')

    def test_frame_names(self):
        """An empty child_frame_id is base_frame, and a leading slash is stripped."""
        for child in '', '/base_link':
            with self.subTest(child):
                node = self.driving(transform_tolerance=20.0)
                stamp = node.send_odometry((1, 0), child=child)
                node.send([STANDING], stamp=stamp)
                self.assertAlmostEqual(node.warning_at(stamp).time_to_collision, 2.5, delta=1e-9)

    def test_unknown_frame(self):
        node = self.driving(transform_tolerance=2.0)
        stamp = node.send_odometry((1, 0), child='atlantis')
        node.send([STANDING], stamp=stamp)
        warning = node.warning_at(stamp)
        self.assertUnknown(warning, warning.REASON_TRANSFORM)
        self.assertSays(warning, '"atlantis"', '"base_link"')

    def check_refused(self, reason, *words, **odometry):
        """UNKNOWN by name until a good one comes; the last good one stays in use."""
        node = self.driving(transform_tolerance=20.0)
        node.warning_at(node.send([STANDING], stamp=node.send_odometry((1, 0))))
        mark = node.warnings.mark()
        node.send_odometry(**odometry)
        warning = node.warning_with(reason, mark)
        self.assertUnknown(warning, reason)
        self.assertSays(warning, node.topic('odom'), *words)
        self.assertEqual(warning.collision_predicted, 1)
        mark = node.warnings.mark()
        node.send_odometry((1, 0))
        node.warnings.wait_for(lambda w: not w.reason & reason, 'acceptance', mark)

    def test_numbers(self):
        for linear, angular, word in (((math.nan, 0), 0, 'nan'), ((0, math.inf), 0, 'inf'),
                                      ((0, 0), math.nan, 'nan'), ((1e300, 0), 0, '1e+300')):
            with self.subTest(linear=linear, angular=angular):
                self.check_refused(INVALID, 'finite', word, linear=linear, angular=angular)

    def test_stamps(self):
        self.check_refused(CollisionWarning.REASON_STAMP, 'stamp 0', stamp=rospy.Time())
        self.check_refused(CollisionWarning.REASON_STAMP, 'ahead of the clock', stamp=ago(-3600))


if __name__ == '__main__':
    run('odometry', Odometry)
