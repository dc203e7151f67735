#!/usr/bin/env python3
"""CLEAR needs fresh data; before and after them it is UNKNOWN, and the heartbeat goes on."""
import math

from footprint_collision_predictor.msg import CollisionWarning
from node_testing import BOX, PATIENT, circle
from ros_test_case import RosTestCase, run

MAX_AGE = 0.5
HEARTBEAT = 1 / 20.0
MARGIN = 0.15  # [s] with one heartbeat, the 200 ms in which a fault must be told


class DataLoss(RosTestCase):
    def wait_clear(self, node):
        return node.warnings.wait_for(lambda w: w.level == w.CLEAR, 'CLEAR')

    def test_nothing_is_known_at_first(self):
        node = self.rig()
        warning = node.next_warning()
        self.assertUnknown(warning, warning.REASON_OBSTACLES_MISSING |
                           warning.REASON_FOOTPRINT_MISSING | warning.REASON_ODOM_MISSING)
        self.assertSays(warning, node.topic('obstacles'), node.topic('footprint'),
                        node.topic('odom'), '~footprint', '~ego_motion')
        for value in (warning.time_to_collision, warning.clearance, warning.closest_distance,
                      warning.closest_time):
            self.assertTrue(math.isnan(value), warning)
        self.assertEqual(warning.data_age, math.inf)
        self.assertEqual((warning.segment, warning.obstacle_id), (-1, -1))
        self.assertEqual(warning.footprint, 'footprint')
        self.assertEqual(warning.horizon, 5)

    def test_Fault10_clear_only_after_three_fresh_empty_lists(self):
        node = self.rig(**PATIENT)
        first, second, third = [node.warning_at(node.send()) for _ in range(3)]
        for settling in first, second:
            self.assertUnknown(settling, settling.REASON_SETTLING)
            self.assertEqual(settling.reason, settling.REASON_SETTLING)
        self.assertEqual((third.level, third.reason, third.message), (third.CLEAR, 0, ''))
        self.assertEqual(third.time_to_collision, math.inf)
        self.assertEqual(third.contact_free_time, 5)
        self.assertEqual(third.clearance, math.inf)
        before = node.warnings.messages[:node.warnings.messages.index(third)]
        self.assertFalse([w for w in before if w.level != w.UNKNOWN])

    def test_Fault18_obstacles_stop(self):
        node = self.rig(footprint=BOX, ego_motion='static', max_data_age=MAX_AGE)
        feed = self.feed(node.send)
        self.wait_clear(node)
        self.check_loss(node, feed.stop(), CollisionWarning.REASON_OBSTACLES_STALE)

    def test_Fault18_odometry_stops(self):
        node = self.rig(footprint=BOX, max_data_age=MAX_AGE)
        self.feed(node.send)
        odometry = self.feed(node.send_odometry)
        self.wait_clear(node)
        self.check_loss(node, odometry.stop(), CollisionWarning.REASON_ODOM_STALE)

    def check_loss(self, node, last, reason):
        lost = node.warnings.wait_for(
            lambda w: w.header.stamp > last and w.level == w.UNKNOWN and w.reason & reason,
            'the loss')
        self.assertUnknown(lost, reason)
        self.assertTrue(math.isnan(lost.time_to_collision), lost)
        # By the node's own stamps, so that a late delivery to this test does not count.
        delay = (lost.header.stamp - last).to_sec()
        self.assertLessEqual(delay, MAX_AGE + HEARTBEAT + MARGIN)
        self.assertGreater(lost.data_age, MAX_AGE, 'fresh data were called lost')

    def test_Fault18_loss_is_not_held_back_by_a_hit(self):
        """CRITICAL becomes UNKNOWN when the hit is no longer known."""
        node = self.rig(footprint=BOX, ego_motion='static', max_data_age=MAX_AGE)
        stamp = node.send([circle(7, (2, 0), (-1, 0))])
        self.assertEqual(node.warning_at(stamp).level, CollisionWarning.CRITICAL)
        self.check_loss(node, stamp, CollisionWarning.REASON_OBSTACLES_STALE)

    def test_heartbeat(self):
        """Without any input: 20 a second by the steady clock, numbered without a gap."""
        node = self.rig(footprint=BOX)
        mark = node.warnings.mark()
        first = node.next_warning()
        last = node.warnings.wait_for(lambda w: w.sequence >= first.sequence + 60, since=mark)
        seconds = (last.header.stamp - first.header.stamp).to_sec()
        self.assertLessEqual(seconds, 60 * HEARTBEAT + MARGIN)
        received = node.warnings.messages[mark:mark + 60]
        numbers = [w.sequence for w in received]
        self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))))
        self.assertEqual(len({w.session for w in received}), 1)
        other = self.rig(footprint=BOX)
        self.assertNotEqual(other.next_warning().session, first.session)


if __name__ == '__main__':
    run('data_loss', DataLoss)
