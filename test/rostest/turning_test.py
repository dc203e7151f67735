#!/usr/bin/env python3
"""A robot that turns, in place or along an arc, is predicted exactly.

Seen from the robot, what stands still goes round its centre of rotation the other way. That circle
meets the footprint where triangles with whole sides have their corners.
"""
import math

from approach import Approach, Body, Obstacle, closest_approach
from footprint_collision_predictor.msg import SegmentPrediction
from node_testing import BOX, PATIENT, circle, outline, transform
from ros_test_case import RosTestCase, run

RATE = 0.5  # [rad/s]
SECONDS = 1e-7  # a touch may be reported while there is 1e-9 m left to go
CORNER = math.hypot(1, 0.5)  # [m] from the middle of the box
TO_CORNER = math.atan2(0.5, 1)

# In place: 7-24-25, a circle of 0.2 m at (1.25, 0) is at (1.2, -0.35) after a turn by this angle.
TO_FRONT = math.atan2(7, 24)
PILLAR = circle(7, (1.25, 0), radius=0.2)

# Ahead at 1 m/s, turning left at RATE: round a centre that is 2 m to the left. From there a circle
# of 0.5 m at (2.5, 2) is 2.5 m off, and comes to (1.5, 0) after a turn by this angle (3-4-5).
ALONG_ARC = math.atan2(4, 3)
BESIDE = circle(7, (2.5, 2))


def mirrored(obstacle):
    """To the right what was to the left."""
    obstacle.position.y *= -1
    return obstacle


class Turning(RosTestCase):
    def driving(self, **parameters):
        return self.rig(**dict(PATIENT, ego_motion='odom', transform_tolerance=20.0, clear_after=1,
                               **parameters))

    def answer(self, node, obstacles, linear, angular, child='base_link'):
        stamp = node.send_odometry(linear, angular, child=child)
        node.send(obstacles, stamp=stamp)
        return node.warning_at(stamp), node.prediction_at(stamp)

    def check(self, warning, seconds, segment, point, closing_speed):
        self.assertEqual(warning.reason, 0, warning)
        self.assertAlmostEqual(warning.time_to_collision, seconds, delta=SECONDS)
        self.assertEqual((warning.segment, warning.obstacle_id), (segment, 7))
        self.assertPoint(warning.contact_point, *point, tolerance=1e-8)
        self.assertAlmostEqual(warning.closing_speed, closing_speed, delta=1e-7)
        self.assertEqual(warning.closest_distance, 0)
        self.assertEqual(warning.closest_time, warning.time_to_collision)

    def test_in_place_into_a_pillar_ahead(self):
        """At (x, y) = (1.2, -0.35) it comes nearer with RATE y; a turn to the right mirrors it."""
        node = self.driving()
        for side in -1, 1:
            warning, prediction = self.answer(node, [PILLAR], (0, 0), -side * RATE)
            self.check(warning, TO_FRONT / RATE, 3, (1, side * 0.35), RATE * 0.35)
            self.assertEqual(prediction.segments[3].feature, SegmentPrediction.INSIDE)
            self.assertEqual(prediction.twist.angular.z, -side * RATE)

    def test_in_place_into_a_pillar_beside(self):
        """It meets a corner: the sides to the middle are 1.25 and CORNER, the third is 0.2 m."""
        at_corner = math.acos((1.25 ** 2 + CORNER ** 2 - 0.2 ** 2) / (2 * 1.25 * CORNER))
        # Along the line from the corner to the centre; by the law of sines.
        closing_speed = RATE * CORNER * 1.25 / 0.2 * math.sin(at_corner)
        seconds = (math.pi / 2 - TO_CORNER - at_corner) / RATE
        beside = circle(7, (0, 1.25), radius=0.2)
        node = self.driving()
        warning, prediction = self.answer(node, [beside], (0, 0), RATE)
        self.check(warning, seconds, 0, (1, 0.5), closing_speed)
        self.assertEqual(prediction.segments[0].feature, SegmentPrediction.START)
        self.assertEqual(prediction.segments[3].feature, SegmentPrediction.END)
        warning, prediction = self.answer(node, [beside], (0, 0), -RATE)
        self.check(warning, seconds, 0, (-1, 0.5), closing_speed)
        self.assertEqual(prediction.segments[0].feature, SegmentPrediction.END)
        self.assertEqual(prediction.segments[1].feature, SegmentPrediction.START)

    def test_along_an_arc_into_a_pillar(self):
        """A straight line would pass it by 1 m."""
        node = self.driving()
        warning, _ = self.answer(node, [BESIDE], (1, 0), RATE)
        self.check(warning, ALONG_ARC / RATE, 3, (1, 0), 1)
        warning, _ = self.answer(node, [mirrored(circle(7, (2.5, 2)))], (1, 0), -RATE)
        self.check(warning, ALONG_ARC / RATE, 3, (1, 0), 1)

    def test_along_an_arc_past_a_pillar(self):
        """It stands dead ahead, where a straight line would touch it after 2.5 s. The front corner
        on the outside passes it when both lie in one direction from the centre of rotation."""
        node = self.driving(horizon=2.0, warn_time=2.0)
        distance = math.hypot(4, 2) - math.hypot(1, 2.5) - 0.5
        seconds = (math.atan2(2.5, 1) - math.atan2(2, 4)) / RATE
        for side in 1, -1:
            warning, prediction = self.answer(node, [circle(7, (4, 0))], (1, 0), side * RATE)
            self.assertEqual((warning.level, warning.reason), (warning.CLEAR, 0), warning)
            self.assertEqual(warning.time_to_collision, math.inf)
            self.assertEqual(warning.contact_free_time, 2)
            self.assertAlmostEqual(warning.clearance, 2.5, delta=1e-9)
            self.assertAlmostEqual(warning.closest_distance, distance, delta=1e-6)
            self.assertAlmostEqual(warning.closest_time, seconds, delta=1e-3)
            for segment in prediction.segments:
                self.assertEqual(segment.time_to_collision, math.inf)

    def test_several_turns(self):
        """A pillar is never touched that stands farther off than the corners reach."""
        node = self.driving(horizon=20.0)
        for angular in 3.0, -3.0:
            warning, _ = self.answer(node, [circle(7, (-2, 0.25))], (0, 0), angular)
            self.assertEqual(warning.level, warning.CLEAR, warning)
            self.assertAlmostEqual(warning.closest_distance, math.hypot(2, 0.25) - CORNER - 0.5,
                                   delta=1e-6)

    def test_closest_approach_of_what_comes_and_goes(self):
        """It is near once, farther off, and partly nearer again. (Recomputed: approach.py.)"""
        node = self.driving()
        corners = [complex(*vertex) for vertex in BOX]
        for yaw_rate, speed, position, velocity, acceleration in (
                (1, 1, (-0.5, 2.5), (0, -1), (0, 0)), (-0.5, 1, (4.5, 1.5), (-1, 1), (0, -0.5)),
                (1, 0, (-3.5, -1.5), (0, 0), (0, 0.5))):
            with self.subTest(position=position):
                obstacle = circle(7, position, velocity, acceleration=acceleration)
                warning, _ = self.answer(node, [obstacle], (speed, 0), yaw_rate)
                body = Body(corners, speed, yaw_rate)
                moving = Obstacle(complex(*position), complex(*velocity), complex(*acceleration), 0.5)
                gap, time = closest_approach([Approach(body, segment, moving, warning.horizon)
                                              for segment in body.segments], warning.horizon)
                self.assertEqual(warning.reason, 0, warning)
                self.assertAlmostEqual(warning.closest_distance, gap, delta=1e-6)
                self.assertAlmostEqual(warning.closest_time, time, delta=1e-2)

    def check_wheels(self, place, linear):
        """Of the odometry's frame on the robot `place` has y, and z and w of the quaternion."""
        node = self.driving()
        node.send_static_transforms(transform('base_link', 'wheels', 0, *place))
        warning, prediction = self.answer(node, [BESIDE], linear, RATE, 'wheels')
        self.assertAlmostEqual(prediction.twist.linear.x, 1, delta=1e-12)
        self.assertAlmostEqual(prediction.twist.linear.y, 0, delta=1e-12)
        self.check(warning, ALONG_ARC / RATE, 3, (1, 0), 1)

    def test_odometry_of_the_middle_of_the_arc(self):
        """The wheels only turn there."""
        self.check_wheels((2, 0, 1), (0, 0))

    def test_odometry_of_another_frame(self):
        """Half way there, and looking to the left, what is half as fast ahead goes to the right."""
        self.check_wheels((1, 0.5 ** 0.5, 0.5 ** 0.5), (0, -0.5))

    def test_velocities_as_seen_on_board(self):
        """What stands still seems to go round the centre of rotation: at (2.5, 0) from there with
        RATE times 2.5 m to the right."""
        node = self.driving(obstacle_velocity='relative')
        warning, _ = self.answer(node, [circle(7, (2.5, 2), (0, -1.25))], (1, 0), RATE)
        self.check(warning, ALONG_ARC / RATE, 3, (1, 0), 1)

    def test_obstacles_that_move(self):
        """In the direction of the pillar, and there when it would be hit: after 1 s."""
        node = self.driving()
        for obstacle in (circle(7, (2, 0), (-0.75, 0), radius=0.2),
                         circle(7, (1.75, 0), radius=0.2, acceleration=(-1, 0))):
            warning, _ = self.answer(node, [obstacle], (0, 0), TO_FRONT)
            # It comes with 0.75 or 1 m/s from 7-24-25, beside what the turn does.
            speed = 0.75 if obstacle.velocity.x else 1
            self.check(warning, 1, 3, (1, -0.35), speed * 24 / 25 + TO_FRONT * 0.35)

    def test_an_outline_does_not_turn_along(self):
        """A wall across, as thick as 0.1 m round a line at x = 1.2; the corner meets it when its own
        x, as it turns, is 1.1."""
        wall = outline(7, [(1.2, -9), (1.2, 9)], radius=0.1)
        turn = TO_CORNER - math.acos(1.1 / CORNER)
        closing_speed = RATE * math.sqrt(CORNER ** 2 - 1.1 ** 2)
        node = self.driving()
        warning, _ = self.answer(node, [wall], (0, 0), RATE)
        self.check(warning, turn / RATE, 2, (1, -0.5), closing_speed)
        warning, _ = self.answer(node, [wall], (0, 0), -RATE)
        self.check(warning, turn / RATE, 0, (1, 0.5), closing_speed)

    def test_touching_now(self):
        warning, _ = self.answer(self.driving(), [circle(7, (1.25, 0))], (1, 0), RATE)
        self.assertEqual((warning.level, warning.time_to_collision), (warning.CRITICAL, 0))
        self.assertEqual((warning.segment, warning.obstacle_id), (3, 7))
        self.assertPoint(warning.contact_point, 1, 0)
        self.assertAlmostEqual(warning.clearance, -0.25, delta=1e-9)

    def test_a_slow_turn_joins_the_straight_line(self):
        """At 1 s the pillar lies aside by the angle times 2.5 m, less what the arc is bent by then:
        half of the angle times 1 m. The time changes with the square of the angle only."""
        node = self.driving()
        for angular in 0, 1e-6, -1e-6, 1e-12, 1e-300, -1e-300:
            with self.subTest(angular=angular):
                warning, _ = self.answer(node, [circle(7, (2.5, 0))], (1, 0), angular)
                self.check(warning, 1, 3, (1, -2 * angular), 1)

    def test_a_slow_turn_is_not_neglected(self):
        """Round a centre 1e6 m to the left, the left side's middle comes nearer to what is passed
        after 5 s than a straight line by 12.5 micrometres."""
        node = self.driving(horizon=6.0)
        passed = circle(7, (5, 1.25))
        for angular, gained in (0, 0), (1e-6, 12.5e-6), (-1e-6, -12.5e-6):
            with self.subTest(angular=angular):
                warning, _ = self.answer(node, [passed], (1, 0), angular)
                self.assertAlmostEqual(warning.closest_distance, 0.25 - gained, delta=1e-6)

    def test_the_countdown_is_live(self):
        """Between messages the robot is carried on along its arc: stamp + time to collision stays,
        and so does what is touched, and where."""
        node = self.driving()
        at_stamp, _ = self.answer(node, [BESIDE], (1, 0), RATE)
        mark = node.warnings.mark()
        node.warnings.wait_for(lambda w: w.time_to_collision < ALONG_ARC / RATE - 0.5, since=mark)
        repeats = node.warnings.messages[mark:]
        self.assertGreater(len(repeats), 2)
        for repeat in repeats:
            passed = (repeat.header.stamp - at_stamp.header.stamp).to_sec()
            self.assertGreater(passed, 0)
            self.check(repeat, ALONG_ARC / RATE - passed, 3, (1, 0), 1)


if __name__ == '__main__':
    run('turning', Turning)
