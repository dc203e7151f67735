#!/usr/bin/env python3
"""An obstacle whose radius grows (its place becoming less certain) is predicted exactly."""
from node_testing import PATIENT, circle, outline
from ros_test_case import RosTestCase, run


def growing(rate, *arguments, **fields):
    obstacle = circle(7, *arguments, **fields)
    obstacle.radius_rate = rate
    return obstacle


class GrowingRadius(RosTestCase):
    def setUp(self):
        self.node = self.rig(**dict(PATIENT, clear_after=1))

    def answer(self, *obstacles):
        return self.node.warning_at(self.node.send(obstacles))

    def check(self, obstacle, seconds, segment, point, closing_speed):
        """The closing speed is the obstacle's own: what grows comes no nearer by that."""
        warning = self.answer(obstacle)
        self.assertEqual(warning.reason, 0, warning)
        self.assertAlmostEqual(warning.time_to_collision, seconds, delta=1e-9)
        self.assertEqual((warning.segment, warning.obstacle_id), (segment, 7))
        self.assertPoint(warning.contact_point, *point)
        self.assertAlmostEqual(warning.closing_speed, closing_speed, delta=1e-9)
        self.assertEqual((warning.closest_distance, warning.closest_time),
                         (0, warning.time_to_collision))

    def test_standing(self):
        """2 m before the front, of which its radius covers 0.5 m."""
        self.check(growing(0.5, (3, 0.25)), 3, 3, (1, 0.25), 0)

    def test_approaching(self):
        """1.5 m at 1 m/s and 0.5 m/s."""
        self.check(growing(0.5, (3, 0.25), (-1, 0)), 1, 3, (1, 0.25), 1)

    def test_going_away_slower_than_it_grows(self):
        """0.5 m at 0.5 m/s less 0.25 m/s."""
        self.check(growing(0.5, (2, 0.25), (0.25, 0)), 2, 3, (1, 0.25), 0)

    def test_accelerating(self):
        """1.5 m = 1 m/s t + 1 m/s^2 t^2 / 2, after 1 s."""
        self.check(growing(1, (3, 0.25), acceleration=(-1, 0)), 1, 3, (1, 0.25), 1)

    def test_corner(self):
        """5 m from the corner (3-4-5), less 1 m, at 1 m/s."""
        self.check(growing(1, (4, 4.5), radius=1), 4, 0, (1, 0.5), 0)

    def test_outline(self):
        """A line that becomes thicker; its lower end is 2 m before the front."""
        line = outline(7, [(3, 0.25), (4, 1.25)])
        line.radius_rate = 0.5
        self.check(line, 4, 3, (1, 0.25), 0)

    def test_turning_robot(self):
        """In place by the angle of 7-24-25 in 1 s, when it has grown to 0.2 m: as in turning_test."""
        node = self.rig(**dict(PATIENT, ego_motion='odom', transform_tolerance=20.0))
        stamp = node.send_odometry(angular=0.2837941092083278)
        node.send([growing(0.125, (1.25, 0), radius=0.075)], stamp=stamp)
        warning = node.warning_at(stamp)
        self.assertAlmostEqual(warning.time_to_collision, 1, delta=1e-7)
        self.assertPoint(warning.contact_point, 1, -0.35, tolerance=1e-7)

    def test_too_slow_to_be_touched(self):
        """1.5 m, and 0.5 m less at the horizon."""
        warning = self.answer(growing(0.1, (3, 0)))
        self.assertEqual((warning.level, warning.reason), (warning.CLEAR, 0), warning)
        self.assertAlmostEqual(warning.clearance, 1.5, delta=1e-9)
        self.assertAlmostEqual(warning.closest_distance, 1, delta=1e-6)
        self.assertAlmostEqual(warning.closest_time, 5, delta=1e-5)

    def test_the_countdown_is_live(self):
        """Between messages it goes on growing: stamp + time to collision stays."""
        at_stamp = self.answer(growing(0.5, (2.5, 0.25)))
        mark = self.node.warnings.mark()
        self.node.warnings.wait_for(lambda w: w.time_to_collision < 1.5, since=mark)
        for repeat in self.node.warnings.messages[mark:]:
            passed = (repeat.header.stamp - at_stamp.header.stamp).to_sec()
            self.assertGreater(passed, 0)
            self.assertAlmostEqual(passed + repeat.time_to_collision, 2, delta=1e-6)


if __name__ == '__main__':
    run('growing_radius', GrowingRadius)
