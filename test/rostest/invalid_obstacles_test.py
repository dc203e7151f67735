#!/usr/bin/env python3
"""An obstacle that cannot be is named, and UNKNOWN; a certain hit beside it is still CRITICAL."""
import math
import struct

from footprint_collision_predictor.msg import CollisionWarning, ObstacleArray
from geometry_msgs.msg import Point
from node_testing import PATIENT, circle
from raw_messages import peak_memory, raw, serialized, stamped
from ros_test_case import RosTestCase, run

NAN, INF = math.nan, math.inf
HIT = circle(7, (2.5, 0), (-1, 0))  # touches the front after 1 s
INVALID = CollisionWarning.REASON_OBSTACLES_INVALID

# name, the wrong obstacle, what the message must name besides the id
CASES = (
    ('position NaN', circle(42, (NAN, 0)), 'position'),
    ('position inf', circle(42, (0, INF)), 'position'),
    ('position 1e300', circle(42, (1e300, 0)), 'position'),
    ('velocity NaN', circle(42, (9, 9), (0, NAN)), 'velocity'),
    ('velocity -inf', circle(42, (9, 9), (-INF, 0)), 'velocity'),
    ('velocity 1e300', circle(42, (9, 9), (1e300, 0)), 'velocity'),
    ('acceleration NaN', circle(42, (9, 9), acceleration=(NAN, 0)), 'acceleration'),
    ('acceleration 1e300', circle(42, (9, 9), acceleration=(0, 1e300)), 'acceleration'),
    ('radius NaN', circle(42, (9, 9), radius=NAN), 'radius'),
    ('radius inf', circle(42, (9, 9), radius=INF), 'radius'),
    ('radius 1e300', circle(42, (9, 9), radius=1e300), 'radius'),
    ('radius negative', circle(42, (9, 9), radius=-0.001), 'radius'),
)


class InvalidObstacles(RosTestCase):
    def setUp(self):
        self.node = self.rig(**PATIENT)

    def answer(self, *obstacles):
        stamp = self.node.send(obstacles)
        return self.node.warning_at(stamp), self.node.prediction_at(stamp)

    def check_alone(self, obstacle, *words, reason=INVALID):
        warning, prediction = self.answer(circle(1, (30, 0)), obstacle)
        self.assertUnknown(warning, reason)
        self.assertSays(warning, 'id 42', 'index 1', *words)
        self.assertTrue(math.isnan(warning.time_to_collision), warning)
        self.assertTrue(math.isnan(warning.clearance), warning)
        self.assertEqual(warning.obstacle_count, 2)
        for segment in prediction.segments:
            self.assertEqual(segment.contact_free_time, 0, 'reads as free')
            self.assertFalse(segment.time_to_collision == INF, 'reads as free')

    def check_beside_a_hit(self, obstacle, *words, reason=INVALID):
        warning, prediction = self.answer(obstacle, HIT)
        self.assertEqual(warning.level, warning.CRITICAL, warning)
        self.assertEqual(warning.reason & reason, reason, warning)
        self.assertSays(warning, 'id 42', 'index 0', *words)
        self.assertAlmostEqual(warning.time_to_collision, 1.0, delta=1e-9)
        self.assertEqual((warning.segment, warning.obstacle_id), (3, 7))
        self.assertEqual(warning.contact_free_time, 0)
        self.assertEqual(prediction.segments[3].obstacle_index, 1)

    def test_Fault02_Fault05_Fault06_table(self):
        for name, obstacle, field in CASES:
            with self.subTest(name):
                self.check_alone(obstacle, field)
                self.check_beside_a_hit(obstacle, field)

    def test_radius_rate(self):
        for rate in NAN, -1.0, INF:
            with self.subTest(rate=rate):
                obstacle = circle(42, (9, 9))
                obstacle.radius_rate = rate
                self.check_alone(obstacle, 'radius_rate')
                self.check_beside_a_hit(obstacle, 'radius_rate')

    def test_outline(self):
        obstacle = circle(42, (9, 9))
        obstacle.outline = [Point(0, 0, 0), Point(NAN, 0, 0)]
        self.check_alone(obstacle)
        self.check_beside_a_hit(obstacle)

    def test_height_is_ignored_but_must_be_finite(self):
        obstacle = circle(42, (9, 9))
        obstacle.position.z = NAN
        self.check_alone(obstacle, 'position.z')

    def test_many_are_counted(self):
        warning, _ = self.answer(*[circle(i, (NAN, 0)) for i in range(42, 52)])
        self.assertSays(warning, 'id 42', 'id 43', 'id 44', '7 more')
        self.assertNotIn('id 45', warning.message)

    def test_Fault05_a_point_is_valid(self):
        warning, _ = self.answer(circle(7, (3, 0), (-1, 0), radius=0))
        self.assertEqual(warning.reason & INVALID, 0)
        self.assertAlmostEqual(warning.time_to_collision, 2.0, delta=1e-9)

    def test_Fault14_duplicate_ids_are_both_predicted(self):
        warning, prediction = self.answer(circle(42, (0, 3), (0, -1)),
                                         circle(42, (3, 0), (-1, 0), radius=0.25))
        self.assertEqual(warning.reason & ~warning.REASON_SETTLING, warning.REASON_DUPLICATE_ID)
        self.assertSays(warning, 'id 42', 'index 1')
        self.assertEqual(prediction.segments[0].obstacle_index, 0)
        self.assertEqual(prediction.segments[3].obstacle_index, 1)
        warning, _ = self.answer(circle(-1, (0, 9)), circle(-1, (9, 0)))
        self.assertEqual(warning.reason & warning.REASON_DUPLICATE_ID, 0, '-1 is never one')

    def test_Fault07_too_many(self):
        node = self.rig(**dict(PATIENT, max_obstacles=5))
        node.send([circle(i, (30, 0)) for i in range(6)])
        warning = node.warning_with(CollisionWarning.REASON_LIMIT)
        self.assertUnknown(warning, CollisionWarning.REASON_LIMIT)
        self.assertSays(warning, '6', 'max_obstacles 5')

    def test_Fault07_far_too_many_take_no_memory(self):
        """10 MB of obstacles, ten times as many as allowed, five times over."""
        node = self.rig(None, **PATIENT)
        raw_class = raw(ObstacleArray)
        publisher = node.publisher('obstacles', raw_class)
        memory = peak_memory(node.process)
        for _ in range(5):
            message = serialized(stamped(ObstacleArray(obstacles=[circle(-1, (30, 0))])))
            start = len(message) - len(serialized(circle(-1, (30, 0)))) - 4
            many = message[:start] + struct.pack('<I', 100000) + 100000 * message[start + 4:]
            mark = node.warnings.mark()
            publisher.publish(raw_class(many))
            warning = node.warning_with(CollisionWarning.REASON_LIMIT, mark)
            self.assertUnknown(warning, CollisionWarning.REASON_LIMIT)
            self.assertSays(warning, '100000 obstacles', '~max_obstacles 10000')
        # The bytes themselves are held three times on their way; obstacles would take 17 MB more.
        self.assertLess(peak_memory(node.process) - memory, 42e6)


if __name__ == '__main__':
    run('invalid_obstacles', InvalidObstacles)
