#!/usr/bin/env python3
"""The same scene gives the same answer in each of the obstacle types."""
import rospy
from foreign_messages import from_costmap_converter, from_obstacle_detector
from footprint_collision_predictor.msg import CollisionWarning, ObstacleArray, SegmentPrediction
from node_testing import PATIENT, circle
from ros_test_case import RosTestCase, run

# All numbers are exact in the single precision of costmap_converter's polygons.
# The first goes for the front: 3 m to go, less its radius of 0.5 m, at 1 m/s.
# The second for the left side: 2.5 m to go, less 0.5 m.
# The third passes 0.375 m beside the corner (1, 0.5) and touches it 0.5 m before (3-4-5), at y = 1.
SCENE = [circle(7, (4, 0.25), (-1, 0)), circle(8, (0, 3), (0, -1)),
         circle(9, (1.375, 5), (0, -1), radius=0.625)]
LINES = [((9, 9), (9, 8)), ((-9, 9), (-9, 8))]


class ObstacleTypes(RosTestCase):
    def answer(self, message, frame='base_link', **parameters):
        rig = self.rig(type(message), **dict(PATIENT, **parameters))
        message.header.frame_id = frame
        message.header.stamp = stamp = rospy.Time.now()
        rig.obstacles.publish(message)
        return rig.warning_at(stamp), rig.prediction_at(stamp)

    def check(self, warning, prediction, ids):
        self.assertAlmostEqual(warning.time_to_collision, 2.0, delta=1e-9)
        self.assertEqual((warning.segment, warning.obstacle_id), (0, ids[1]))
        self.assertPoint(warning.contact_point, 0, 0.5)
        self.assertAlmostEqual(warning.closing_speed, 1.0, delta=1e-9)
        left, rear, right, front = prediction.segments
        self.check_segment(left, 2.0, 1, ids, SegmentPrediction.INSIDE, (0, 0.5))
        self.check_segment(front, 2.5, 0, ids, SegmentPrediction.INSIDE, (1, 0.25))
        # What lies behind is told as if the way to it were free.
        self.check_segment(rear, 4.5, 0, ids, SegmentPrediction.INSIDE, (-1, 0.25))
        self.check_segment(right, 3.0, 1, ids, SegmentPrediction.INSIDE, (0, -0.5))

    def check_segment(self, segment, seconds, index, ids, feature, point):
        self.assertAlmostEqual(segment.time_to_collision, seconds, delta=1e-9)
        self.assertEqual(segment.obstacle_index, index)
        self.assertEqual(segment.obstacle_id, ids[index])
        self.assertEqual(segment.feature, feature)
        self.assertPoint(segment.contact_point, *point)

    def test_own_type(self):
        warning, prediction = self.answer(ObstacleArray(obstacles=SCENE))
        self.check(warning, prediction, (7, 8, 9))
        self.assertEqual(warning.obstacle_count, 3)

    def test_obstacle_detector(self):
        self.check(*self.answer(from_obstacle_detector(SCENE, margin=0.25)), ids=(-1, -1, -1))

    def test_obstacle_detector_with_its_margin(self):
        warning, _ = self.answer(from_obstacle_detector(SCENE, margin=0.25),
                                 obstacle_detector_radius='radius')
        self.assertAlmostEqual(warning.time_to_collision, 1.75, delta=1e-9)

    def test_costmap_converter(self):
        self.check(*self.answer(from_costmap_converter(SCENE)), ids=(7, 8, 9))

    def test_Fault11_leading_slash(self):
        self.check(*self.answer(from_costmap_converter(SCENE), frame='/base_link'), ids=(7, 8, 9))

    def test_corner_alone(self):
        """A corner belongs to two segments; the lower index is named."""
        for message in (ObstacleArray(obstacles=SCENE[2:]), from_costmap_converter(SCENE[2:]),
                        from_obstacle_detector(SCENE[2:], margin=0)):
            with self.subTest(type=message._type):
                warning, prediction = self.answer(message)
                self.assertAlmostEqual(warning.time_to_collision, 4.0, delta=1e-9)
                self.assertEqual(warning.segment, 0)
                self.assertPoint(warning.contact_point, 1, 0.5)
                self.assertAlmostEqual(warning.closing_speed, 0.8, delta=1e-9)
                self.assertEqual(prediction.segments[0].feature, SegmentPrediction.START)
                self.assertEqual(prediction.segments[3].feature, SegmentPrediction.END)

    def test_outlines_are_named(self):
        for message in (from_obstacle_detector(SCENE, margin=0.25, segments=LINES),
                        from_costmap_converter(SCENE, polygons=LINES)):
            with self.subTest(type=message._type):
                warning, prediction = self.answer(message)
                self.assertTrue(warning.reason & CollisionWarning.REASON_NOT_PREDICTED, warning)
                self.assertSays(warning, '2 lines or polygons', 'circles only')
                self.assertEqual(warning.obstacle_count, 5)
                self.assertAlmostEqual(warning.time_to_collision, 2.0, delta=1e-9)
                self.assertEqual(prediction.segments[0].obstacle_index, 1)


if __name__ == '__main__':
    run('obstacle_types', ObstacleTypes)
