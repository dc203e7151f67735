#!/usr/bin/env python3
"""The same scene gives the same answer in each of the obstacle types."""
import rospy
from foreign_messages import from_costmap_converter, from_obstacle_detector
from footprint_collision_predictor.msg import ObstacleArray, SegmentPrediction
from node_testing import PATIENT, circle, outline
from ros_test_case import RosTestCase, run

# All numbers are exact in the single precision of costmap_converter's polygons.
# The first goes for the front: 3 m to go, less its radius of 0.5 m, at 1 m/s.
# The second for the left side: 2.5 m to go, less 0.5 m.
# The third passes 0.375 m beside the corner (1, 0.5) and touches it 0.5 m before (3-4-5), at y = 1.
SCENE = [circle(7, (4, 0.25), (-1, 0)), circle(8, (0, 3), (0, -1)),
         circle(9, (1.375, 5), (0, -1), radius=0.625)]

# For a robot that drives at 1 m/s. A circle is passed at 2 m; the end of a line touches the front
# after 3 s, and the left side's corner a quarter of a second later; a wall is passed at 1 m.
LINES = [circle(7, (0, 3)), outline(8, [(5, 1.25), (4, 0.25)]), outline(9, [(-9, -1.5), (9, -1.5)])]

# The corner (1, 0.5) comes to a line whose normal is (-0.8, -0.6), and which is at x = 4.125 there.
SLANTED = [outline(8, [(3, 2), (6, -2)])]

# A square on its corner, which goes for the front from 3 m.
SQUARE = [(4, 0.25), (5, 1.25), (6, 0.25), (5, -0.75)]

# Round the robot; nearest is a corner that points inwards, 3 m before the front.
ENCLOSURE = [(9, 9), (-9, 9), (-9, -9), (9, -9), (4, 0.25)]


class ObstacleTypes(RosTestCase):
    def setUp(self):
        self.rigs = {}

    def answer(self, message, frame='base_link', driving=False, **parameters):
        """Of one node for each type and set of parameters."""
        key = (type(message), driving, *parameters.items())
        if key not in self.rigs:
            motion = {'ego_motion': 'odom', 'transform_tolerance': 20.0} if driving else {}
            self.rigs[key] = self.rig(type(message), **{**PATIENT, 'clear_after': 1, **parameters,
                                                  **motion})
        rig = self.rigs[key]
        message.header.frame_id = frame
        message.header.stamp = stamp = rospy.Time.now()
        if driving:
            rig.send_odometry((1, 0), stamp=stamp)
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

    def test_leading_slash(self):
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

    def test_lines(self):
        for message, ids in ((ObstacleArray(obstacles=LINES), (7, 8, 9)),
                             (from_costmap_converter(LINES), (7, 8, 9)),
                             (from_obstacle_detector(LINES, margin=0), (-1, -1, -1))):
            with self.subTest(type=message._type):
                warning, prediction = self.answer(message, driving=True)
                self.assertEqual((warning.reason, warning.obstacle_count), (0, 3), warning)
                self.assertAlmostEqual(warning.time_to_collision, 3, delta=1e-9)
                self.assertEqual((warning.segment, warning.obstacle_id), (3, ids[1]))
                self.assertPoint(warning.contact_point, 1, 0.25)
                self.assertAlmostEqual(warning.closing_speed, 1, delta=1e-9)
                self.assertAlmostEqual(warning.clearance, 1, delta=1e-9)
                left, _, right, front = prediction.segments
                self.check_segment(front, 3, 1, ids, SegmentPrediction.INSIDE, (1, 0.25))
                self.check_segment(left, 3.25, 1, ids, SegmentPrediction.START, (1, 0.5))
                self.assertEqual((right.collision_predicted, right.obstacle_index), (0, -1))

    def test_circles_are_counted_before_lines(self):
        """As obstacle_detector sends the lines first."""
        message = from_obstacle_detector([*LINES[1:], LINES[0], circle(6, (3, 0.25))], margin=0)
        warning, prediction = self.answer(message, driving=True)
        self.assertAlmostEqual(warning.time_to_collision, 1.5, delta=1e-9)
        self.assertEqual(prediction.segments[3].obstacle_index, 1)
        warning, prediction = self.answer(from_obstacle_detector(LINES[1:], margin=0), driving=True)
        self.assertEqual(prediction.segments[3].obstacle_index, 0)

    def test_corner_against_a_line(self):
        for message in (ObstacleArray(obstacles=SLANTED), from_costmap_converter(SLANTED),
                        from_obstacle_detector(SLANTED, margin=0)):
            with self.subTest(type=message._type):
                warning, prediction = self.answer(message, driving=True)
                self.assertAlmostEqual(warning.time_to_collision, 3.125, delta=1e-9)
                self.assertEqual(warning.segment, 0)
                self.assertPoint(warning.contact_point, 1, 0.5)
                self.assertAlmostEqual(warning.closing_speed, 0.8, delta=1e-9)
                self.assertAlmostEqual(warning.clearance, 3.125 * 0.8, delta=1e-9)
                self.assertEqual(prediction.segments[0].feature, SegmentPrediction.START)
                self.assertEqual(prediction.segments[3].feature, SegmentPrediction.END)

    def check_square(self, message, seconds, closing_speed, clearance):
        warning, prediction = self.answer(message)
        self.assertEqual((warning.reason, warning.obstacle_count), (0, 1), warning)
        self.assertAlmostEqual(warning.time_to_collision, seconds, delta=1e-9)
        self.assertEqual((warning.segment, warning.obstacle_id), (3, 8))
        self.assertPoint(warning.contact_point, 1, 0.25)
        self.assertAlmostEqual(warning.closing_speed, closing_speed, delta=1e-9)
        self.assertAlmostEqual(warning.clearance, clearance, delta=1e-9)
        self.assertEqual(warning.closest_time, warning.time_to_collision)
        self.assertEqual(prediction.segments[3].obstacle_index, 0)

    def test_polygon(self):
        """In either winding, rounded, and as costmap_converter has it: the first vertex twice."""
        for vertices in SQUARE, SQUARE[::-1], SQUARE + SQUARE[:1]:
            for radius, seconds in (0, 3), (0.5, 2.5):
                scene = [outline(8, vertices, (-1, 0), radius)]
                for message in ObstacleArray(obstacles=scene), from_costmap_converter(scene):
                    with self.subTest(type=message._type, vertices=vertices, radius=radius):
                        self.check_square(message, seconds, 1, 3 - radius)

    def test_growing_polygon(self):
        """3 m at 1 m/s and 0.5 m/s."""
        square = outline(8, SQUARE, (-1, 0))
        square.radius_rate = 0.5
        self.check_square(ObstacleArray(obstacles=[square]), 2, 1, 3)

    def test_polygon_that_passes(self):
        """Its lower corner is 1 m beside the left side, from 1 s on."""
        passing = [outline(8, [(2, 1.5), (3, 2.5), (2, 3.5), (1, 2.5)], (-1, 0))]
        for message in ObstacleArray(obstacles=passing), from_costmap_converter(passing):
            with self.subTest(type=message._type):
                warning, _ = self.answer(message)
                self.assertEqual(warning.level, warning.CLEAR, warning)
                self.assertAlmostEqual(warning.clearance, 2 ** 0.5, delta=1e-9)
                self.assertAlmostEqual(warning.closest_distance, 1, delta=1e-6)
                self.assertGreater(warning.closest_time, 1 - 1e-3)

    def test_robot_within_a_polygon(self):
        scene = [outline(8, ENCLOSURE)]
        for message in ObstacleArray(obstacles=scene), from_costmap_converter(scene):
            with self.subTest(type=message._type):
                warning, _ = self.answer(message)
                self.assertEqual((warning.level, warning.time_to_collision), (warning.CRITICAL, 0))
                self.assertEqual((warning.segment, warning.obstacle_id), (3, 8))
                self.assertPoint(warning.contact_point, 1, 0.25)
                self.assertAlmostEqual(warning.clearance, -3, delta=1e-9)


if __name__ == '__main__':
    run('obstacle_types', ObstacleTypes)
