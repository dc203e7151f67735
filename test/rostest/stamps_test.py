#!/usr/bin/env python3
"""Stamps that cannot be used are refused by name, and a refused stamp never becomes the newest."""
import rospy
from footprint_collision_predictor.msg import CollisionWarning
from node_testing import PATIENT, circle
from ros_test_case import RosTestCase, run


def ago(seconds):
    return rospy.Time.now() - rospy.Duration.from_sec(seconds)


class Stamps(RosTestCase):
    def clear_node(self, **parameters):
        node = self.rig(**dict(PATIENT, **parameters))
        for _ in range(3):
            stamp = node.send()
        self.assertEqual(node.warning_at(stamp).level, CollisionWarning.CLEAR)
        return node

    def check_refused(self, node, stamp, reason, *words):
        mark = node.warnings.mark()
        node.send(stamp=stamp)
        warning = node.warning_with(reason, mark)
        self.assertUnknown(warning, reason)
        self.assertSays(warning, node.topic('obstacles'), *words)
        self.assertUnknown(node.next_warning(), reason)  # until a good one comes
        good = node.warning_at(node.send())
        self.assertEqual(good.reason, good.REASON_SETTLING, good)

    def test_Fault15_zero(self):
        self.check_refused(self.clear_node(), rospy.Time(), CollisionWarning.REASON_STAMP,
                           'stamp 0', 'source')

    def test_Fault16_future(self):
        self.check_refused(self.clear_node(), ago(-3600), CollisionWarning.REASON_STAMP,
                           'ahead of the clock', '--hz 1000')

    def test_little_in_the_future_is_tolerated(self):
        """50 ms are; half of that is tested, so that reading the clock twice does not matter."""
        node = self.clear_node()
        stamp = node.send(stamp=ago(-0.025))
        self.assertEqual(node.warning_at(stamp).level, CollisionWarning.CLEAR)

    def test_Fault17_older_than_max_data_age(self):
        self.check_refused(self.clear_node(), ago(60), CollisionWarning.REASON_OBSTACLES_STALE,
                           'old when it came', 'max_data_age 30 s')

    def test_Fault17_years_old(self):
        self.check_refused(self.clear_node(), ago(9 * 365.25 * 86400),
                           CollisionWarning.REASON_OBSTACLES_STALE,
                           '9 years', '--clock', 'use_sim_time')

    def test_Fault12_old_latched_message(self):
        """What a latched publisher sent before the node started is not taken for fresh."""
        node = self.rig(**dict(PATIENT, max_data_age=0.5))
        node.send(stamp=ago(10))
        self.assertUnknown(node.warning_with(CollisionWarning.REASON_OBSTACLES_STALE),
                           CollisionWarning.REASON_OBSTACLES_STALE)

    def test_Fault22_out_of_order(self):
        """The older one is ignored, whatever it says; the newer one stays predicted."""
        node = self.rig(**PATIENT)
        newest = node.send([circle(7, (30, 0))])
        node.warning_at(newest)
        mark = node.warnings.mark()
        older = newest - rospy.Duration.from_sec(0.001)
        node.send([circle(8, (0, 0)), circle(9, (1, 0))], stamp=older)
        ignored = node.warning_with(CollisionWarning.REASON_OUT_OF_ORDER, mark)
        self.assertSays(ignored, node.topic('obstacles'), 'older')
        self.assertEqual(ignored.obstacle_count, 1)
        self.assertNotEqual(ignored.level, ignored.CRITICAL)
        self.assertFalse([p for p in node.predictions.messages if p.header.stamp == older])
        after = node.warning_at(node.send())
        self.assertEqual(after.reason & after.REASON_OUT_OF_ORDER, 0)

    def test_Fault22_equal_stamp_replaces(self):
        node = self.rig(**PATIENT)
        stamp = node.send([circle(7, (30, 0))])
        node.send([circle(8, (3, 0), (-1, 0))], stamp=stamp)
        second = node.warnings.wait_for(lambda w: w.obstacle_id == 8, 'the second message')
        self.assertEqual(second.header.stamp, stamp)
        self.assertEqual(second.level, second.CRITICAL)
        self.assertEqual(node.next_warning().obstacle_id, 8)


if __name__ == '__main__':
    run('stamps', Stamps)
