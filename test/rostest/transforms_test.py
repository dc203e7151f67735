#!/usr/bin/env python3
"""A transform that is missing or late: waited for, then UNKNOWN by name."""
import math

import rospy
from footprint_collision_predictor.msg import CollisionWarning
from node_testing import PATIENT, circle, transform
from ros_test_case import RosTestCase, run

TRANSFORM = CollisionWarning.REASON_TRANSFORM
AHEAD = circle(7, (3, 0), (-1, 0))  # in base_link: touches the front after 1.5 s


class Transforms(RosTestCase):
    def check_refused(self, node, frame, *words, reason=TRANSFORM):
        mark = node.warnings.mark()
        node.send([AHEAD], frame)
        warning = node.warning_with(reason, mark)
        self.assertUnknown(warning, reason)
        self.assertSays(warning, *words)
        self.assertTrue(math.isnan(warning.time_to_collision), warning)
        return warning

    def test_Fault11_empty_frame(self):
        node = self.rig(**PATIENT)
        self.check_refused(node, '', node.topic('obstacles'), 'empty frame_id')

    def test_Fault11_unknown_frame(self):
        node = self.rig(**PATIENT)
        self.check_refused(node, 'atlantis', '"atlantis"', '"base_link"', 'none at any time')

    def test_Fault24_split_tree(self):
        node = self.rig(**dict(PATIENT, transform_tolerance=1.0))
        node.send_static_transforms(transform('map', 'tower', 1, 2),
                                    transform('odom', 'base_link', 1, 2))
        self.check_refused(node, 'tower', '"tower"', '"base_link"')

    def test_Fault24_newest_there_is(self):
        """An old transform is no answer for now; its time is told."""
        node = self.rig(**dict(PATIENT, transform_tolerance=1.0))
        stamp = node.send()
        node.warning_at(stamp)
        node.send_transforms(transform('map', 'base_link', 1, 2, stamp=stamp))
        warning = self.check_refused(node, 'map', '"map"', '"base_link"', 'the newest there is')
        self.assertIn('%d.' % stamp.secs, warning.message)

    def test_Fault26_infinite_translation(self):
        node = self.rig(**dict(PATIENT, transform_tolerance=20.0))
        node.send_static_transforms(transform('map', 'base_link', math.inf, 0))
        self.check_refused(node, 'map', '"map"', '"base_link"', 'not finite')

    def test_Fault27_tilted_frame(self):
        """40 degrees of roll."""
        tilted = transform('map', 'base_link', 0, 0)
        tilted.transform.rotation.x = math.sin(math.radians(20))
        tilted.transform.rotation.w = math.cos(math.radians(20))
        node = self.rig(**dict(PATIENT, transform_tolerance=20.0))
        node.send_static_transforms(tilted)
        self.check_refused(node, 'map', 'tilted', '30 degrees')

    def test_Fault25_late_transform_is_waited_for(self):
        """No answer comes until the transform has, and then it is the right one."""
        node = self.rig(**dict(PATIENT, transform_tolerance=25.0))
        mark = node.warnings.mark()
        stamp = node.send([circle(7, (4, 2), (-1, 0))], 'map')
        waiting_for = node.next_warning().sequence + 5  # heartbeats
        last = node.warnings.wait_for(lambda w: w.sequence >= waiting_for, since=mark)
        self.assertUnknown(last, last.REASON_OBSTACLES_MISSING)
        self.assertEqual(last.reason & TRANSFORM, 0)
        self.assertFalse(node.predictions.messages)
        node.send_static_transforms(transform('map', 'base_link', 1, 2))
        self.assertAlmostEqual(node.warning_at(stamp).time_to_collision, 1.5, delta=1e-9)

    def test_the_last_good_one_stays_predicted(self):
        node = self.rig(**PATIENT)
        node.warning_at(node.send([circle(7, (2, 0))]))
        mark = node.warnings.mark()
        node.send([circle(8, (0, 0))], 'atlantis')
        warning = node.warning_with(TRANSFORM, mark)
        self.assertUnknown(warning, TRANSFORM)
        self.assertEqual(warning.obstacle_count, 1)
        good = node.warning_at(node.send())
        self.assertEqual(good.reason, good.REASON_SETTLING, good)

    def test_stamps_that_tf2_cannot_compute_with(self):
        """They end neither the process nor its other transforms."""
        node = self.rig(**dict(PATIENT, transform_tolerance=20.0))
        for seconds in (100, 2**32 - 1, 2**32 - 1):
            node.send_transforms(transform('map', 'balloon', 1, 2, stamp=rospy.Time(seconds)))
        node.send_static_transforms(transform('map', 'base_link', 1, 2))
        stamp = node.send([circle(7, (4, 2), (-1, 0))], 'map')
        self.assertAlmostEqual(node.warning_at(stamp).time_to_collision, 1.5, delta=1e-9)
        self.assertTrue(node.is_alive())

    def test_Fault25_nothing_piles_up(self):
        """200 messages that nothing can answer are each refused in their turn; then all is well."""
        node = self.rig(**PATIENT)
        for _ in range(200):
            node.send([AHEAD], 'atlantis')
        stamp = node.send([AHEAD])
        self.assertAlmostEqual(node.warning_at(stamp).time_to_collision, 1.5, delta=1e-9)


if __name__ == '__main__':
    run('transforms', Transforms)
