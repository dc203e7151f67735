#!/usr/bin/env python3
"""The level rises at once and falls after three lower messages in a row; the count-down is live."""
from footprint_collision_predictor.msg import CollisionWarning
from node_testing import PATIENT, circle
from ros_test_case import RosTestCase, run

UNKNOWN, CLEAR, WARN, CRITICAL = (CollisionWarning.UNKNOWN, CollisionWarning.CLEAR,
                                  CollisionWarning.WARN, CollisionWarning.CRITICAL)


class LevelHolding(RosTestCase):
    def setUp(self):
        self.node = self.rig(**dict(PATIENT, max_data_age=60.0))

    def levels(self, *scenes):
        """Of one message for each scene, sent one after the other."""
        return [self.node.warning_at(self.node.send(scene)).level for scene in scenes]

    def ahead(self, seconds):
        """Touches the front after that time."""
        return [circle(7, (1.5 + seconds, 0), (-1, 0))]

    def test_rises_at_once_and_falls_after_three(self):
        far, near = [], self.ahead(1.0)
        self.assertEqual(self.levels(far, far, far, near, far, far, far),
                         [UNKNOWN, UNKNOWN, CLEAR, CRITICAL, CRITICAL, CRITICAL, CLEAR])

    def test_the_first_message_may_be_critical(self):
        self.assertEqual(self.levels(self.ahead(1.0)), [CRITICAL])

    def test_a_hit_in_between_restarts_the_count(self):
        far, near = [], self.ahead(1.0)
        self.assertEqual(self.levels(near, far, far, near, far, far, far),
                         [CRITICAL] * 6 + [CLEAR])

    def test_falls_to_the_worst_of_the_last_three(self):
        self.assertEqual(self.levels(self.ahead(1.0), self.ahead(2.5), [], [], []),
                         [CRITICAL, CRITICAL, CRITICAL, WARN, CLEAR])

    def test_thresholds_are_inclusive(self):
        """1.5 and 3.0 s are touched exactly, all numbers being exact in binary."""
        self.assertEqual(self.levels(self.ahead(3.0078125), self.ahead(3.0078125),
                                     self.ahead(3.0078125)), [UNKNOWN, UNKNOWN, CLEAR])
        self.assertEqual(self.levels(self.ahead(3.0), self.ahead(1.5078125), self.ahead(1.5)),
                         [WARN, WARN, CRITICAL])

    def test_a_held_level_says_so(self):
        self.levels(self.ahead(1.0))
        held = self.node.warning_at(self.node.send())
        self.assertEqual((held.level, held.reason), (CRITICAL, 0))
        self.assertSays(held, 'held', 'clear_after')

    def test_the_countdown_is_live(self):
        """Between messages stamp + time to collision stays, and the hit is named throughout."""
        contact = 2.75
        stamp = self.node.send(self.ahead(contact))
        at_stamp = self.node.warning_at(stamp)
        self.assertAlmostEqual(at_stamp.time_to_collision, contact, delta=1e-9)
        mark = self.node.warnings.mark()
        self.node.warnings.wait_for(lambda w: w.time_to_collision < contact - 0.5, since=mark)
        repeats = [w for w in self.node.warnings.messages[mark:]
                   if not w.reason & w.REASON_DEADLINE]  # the machine was busy with other things
        self.assertGreater(len(repeats), 5)
        for repeat in repeats:
            passed = (repeat.header.stamp - stamp).to_sec()
            self.assertGreater(passed, 0)
            self.assertAlmostEqual(passed + repeat.time_to_collision, contact, delta=1e-6)
            self.assertEqual((repeat.segment, repeat.obstacle_id), (3, 7))

    def test_the_countdown_ends_in_contact(self):
        """WARN turns into CRITICAL between messages, and the contact is a collision now."""
        self.node.send(self.ahead(1.625))
        touching = self.node.warnings.wait_for(lambda w: w.time_to_collision == 0, 'contact')
        self.assertEqual(touching.level, CRITICAL)


if __name__ == '__main__':
    run('level_holding', LevelHolding)
