#!/usr/bin/env python3
"""More work than fits a period of the heartbeat is UNKNOWN, never a late answer as if in time."""
import math
import re
import struct

from footprint_collision_predictor.msg import CollisionWarning, ObstacleArray
from node_testing import PATIENT, circle, outline
from raw_messages import raw, serialized, stamped
from ros_test_case import RosTestCase, run
from several_bodies import BASE, of

DEADLINE = CollisionWarning.REASON_DEADLINE
MANY = 50000  # each of them takes some 100 ns; the period is 1 ms


def around(x, radius, count):
    angles = [2 * math.pi * i / count for i in range(count)]
    return [[x + radius * math.cos(angle), radius * math.sin(angle)] for angle in angles]


class Deadline(RosTestCase):
    def setUp(self):
        self.start(PATIENT)

    def start(self, parameters):
        self.node = self.rig(None, **dict(parameters, heartbeat_rate=1000.0,
                                          max_obstacles=MANY + 1))
        self.message = raw(ObstacleArray)
        self.publisher = self.node.publisher('obstacles', self.message)

    def send(self, obstacle, count):
        """That obstacle so many times. Returns the stamp."""
        message = stamped(ObstacleArray(obstacles=[obstacle]))
        one = serialized(obstacle)
        head = serialized(message)[:-len(one) - 4]
        self.publisher.publish(self.message(head + struct.pack('<I', count) + count * one))
        return message.header.stamp

    def test_Fault35_too_much_work(self):
        stamp = self.send(circle(-1, (30, 0)), MANY)
        late = self.node.warning_at(stamp)
        self.assertUnknown(late, DEADLINE)
        self.assertSays(late, '%d obstacles' % MANY, 'longer than the period', '~heartbeat_rate')
        took, period = [float(n) for n in re.findall(r'(\d+\.\d+) s', late.message)[:2]]
        self.assertGreater(took, period)
        self.assertEqual(period, 0.001)

    def test_Fault35_too_much_work_for_several_bodies(self):
        """Whichever is evaluated last, what all take must fit the period."""
        self.start({'footprints': [BASE, dict(BASE, name='load')], 'ego_motion': 'static',
                    'max_data_age': 30.0})
        stamp = self.send(circle(-1, (30, 0)), MANY)
        for name in 'base', 'load':
            late = of(name, self.node.warnings, stamp)
            self.assertUnknown(late, DEADLINE)
            self.assertSays(late, '%d obstacles' % MANY, 'longer than the period')

    def test_Fault35_no_end_of_work_for_several_bodies(self):
        """Outlines of 300 corners round one of 1000, which take far more than 0.1 s."""
        self.start({'footprints': [dict(BASE, name=name, polygon=around(0, 1, 1000))
                                   for name in ('base', 'load')],
                    'max_data_age': 30.0, 'transform_tolerance': 20.0})
        self.send(outline(-1, around(3, 0.5, 300), (-0.1, 0)), 3000)
        self.node.send_odometry((1, 0), 0.5)
        for name in 'base', 'load':
            hung = self.node.warnings.wait_for(
                lambda w: w.footprint == name and 'no evaluation has finished' in w.message, name)
            self.assertUnknown(hung, DEADLINE)

    def test_Fault35_a_certain_hit_is_still_critical(self):
        late = self.node.warning_at(self.send(circle(-1, (3, 0), (-1, 0)), MANY))
        self.assertEqual(late.level, late.CRITICAL)
        self.assertEqual(late.reason & DEADLINE, DEADLINE)
        self.assertEqual(late.contact_free_time, 0)

    def test_Fault35_all_is_well_when_there_is_less_to_do(self):
        self.node.warning_at(self.send(circle(-1, (30, 0)), MANY))
        for _ in range(3000):
            self.send(circle(-1, (30, 0)), 1)
            try:
                self.node.warnings.wait_for(lambda w: w.level == w.CLEAR, 'CLEAR', timeout=0.01)
                return
            except AssertionError:
                continue
        self.fail(self.node.next_warning())


if __name__ == '__main__':
    run('deadline', Deadline)
