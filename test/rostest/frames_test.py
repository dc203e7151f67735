#!/usr/bin/env python3
"""Obstacles in a frame that is turned and shifted: velocities and outlines are turned, and not
shifted."""
from geometry_msgs.msg import Point
from node_testing import PATIENT, circle, transform
from ros_test_case import RosTestCase, run

# Turned by 90 degrees and shifted: base_link (x, y) is (5 - y, 7 + x) in `quarter`.
QUARTER = transform('quarter', 'base_link', 5, 7, qz=0.5 ** 0.5, qw=0.5 ** 0.5)
# Turned by the angle of the 3-4-5 triangle: the x axis of base_link is (0.6, 0.8) in `pythagoras`.
PYTHAGORAS = transform('pythagoras', 'quarter', -11, 2, qz=-(0.1 ** 0.5), qw=0.9 ** 0.5)

FAR = 20.0  # [s] longer than a busy machine may take to deliver a transform


class Frames(RosTestCase):
    def node(self, *transforms, **parameters):
        node = self.rig(**dict(PATIENT, transform_tolerance=FAR, **parameters))
        node.send_static_transforms(*transforms)
        return node

    def check(self, node, obstacle, frame, seconds, segment, point):
        stamp = node.send([obstacle], frame)
        warning = node.warning_at(stamp)
        self.assertEqual(warning.header.frame_id, 'base_link')
        self.assertAlmostEqual(warning.time_to_collision, seconds, delta=1e-9)
        self.assertEqual(warning.segment, segment)
        self.assertPoint(warning.contact_point, *point)

    def test_quarter_turn(self):
        """In base_link the obstacle is at (4, 0.25) and comes at (-1, 0)."""
        node = self.node(QUARTER)
        self.check(node, circle(7, (4.75, 11), (0, -1)), 'quarter', 2.5, 3, (1, 0.25))

    def test_acceleration_is_turned_too(self):
        """In base_link from (4, 0) at rest with (-1, 0): 2.5 m = t^2 / 2."""
        node = self.node(QUARTER)
        self.check(node, circle(7, (5, 11), acceleration=(0, -1)), 'quarter', 5 ** 0.5, 3, (1, 0))

    def test_pythagorean_angle(self):
        """quarter's x axis is (0.8, -0.6) in `pythagoras`: base_link (x, y) is
        (-11, 2) + (5 - y)(0.8, -0.6) + (7 + x)(0.6, 0.8)."""
        node = self.node(PYTHAGORAS, QUARTER)
        x, y = 4, 0.25
        position = (-11 + (5 - y) * 0.8 + (7 + x) * 0.6, 2 - (5 - y) * 0.6 + (7 + x) * 0.8)
        self.check(node, circle(7, position, (-0.6, -0.8)), 'pythagoras', 2.5, 3, (1, 0.25))

    def test_outline(self):
        """In base_link a line from (4, 0.25) to (5, 1.25) comes at (-1, 0), told from (4, -3)."""
        line = circle(7, (8, 11), (0, -1), radius=0)
        line.outline = [Point(-3.25, 0, 0), Point(-4.25, 1, 0)]
        self.check(self.node(QUARTER), line, 'quarter', 3, 3, (1, 0.25))

    def test_outline_at_a_pythagorean_angle(self):
        """In base_link a square stands on its corner (0.5, -2), the others being 1 m to the left,
        below and to the right of its centre, and comes at (0, 1). base_link's x axis is (0.6, 0.8)
        in `pythagoras`, its y axis (-0.8, 0.6)."""
        x, y = 0.5, -3
        position = (-11 + (5 - y) * 0.8 + (7 + x) * 0.6, 2 - (5 - y) * 0.6 + (7 + x) * 0.8)
        square = circle(7, position, (-0.8, 0.6), radius=0)
        square.outline = [Point(0.6, 0.8, 0), Point(-0.8, 0.6, 0), Point(-0.6, -0.8, 0),
                          Point(0.8, -0.6, 0)]
        self.check(self.node(PYTHAGORAS, QUARTER), square, 'pythagoras', 1.5, 2, (0.5, -0.5))

    def test_own_motion_in_a_turned_world(self):
        """The robot drives (1, 0) in its own axes, the obstacle stands still at (4, 0.25) there."""
        node = self.node(QUARTER, ego_motion='odom')
        stamp = node.send_odometry(linear=(1, 0))
        node.send([circle(7, (4.75, 11))], 'quarter', stamp)
        warning, prediction = node.warning_at(stamp), node.prediction_at(stamp)
        self.assertAlmostEqual(warning.time_to_collision, 2.5, delta=1e-9)
        self.assertAlmostEqual(prediction.twist.linear.x, 1, delta=1e-12)

    def test_odometry_of_a_turned_child_frame(self):
        """The encoder's x axis is base_link's y axis: its (-1, 0) is a drive to the right."""
        node = self.node(transform('base_link', 'encoder', 0.3, 0, qz=0.5 ** 0.5, qw=0.5 ** 0.5),
                         ego_motion='odom')
        stamp = node.send_odometry(linear=(-1, 0), child='encoder')
        node.send([circle(7, (0, -3))], stamp=stamp)
        warning, prediction = node.warning_at(stamp), node.prediction_at(stamp)
        self.assertAlmostEqual(warning.time_to_collision, 2.0, delta=1e-9)  # 3 - 0.5 - 0.5
        self.assertEqual(warning.segment, 2)
        self.assertAlmostEqual(prediction.twist.linear.x, 0, delta=1e-12)
        self.assertAlmostEqual(prediction.twist.linear.y, -1, delta=1e-12)

    def test_odometry_of_a_shifted_child_frame(self):
        """Turning at 1e-5 rad/s about base_link moves a frame at (100, 0) by 1e-3 m/s to the left:
        that is all of what the encoder there measures, and base_link itself does not move."""
        node = self.node(transform('base_link', 'encoder', 100, 0), ego_motion='odom')
        stamp = node.send_odometry(linear=(0, 1e-3), angular=1e-5, child='encoder')
        node.send([], stamp=stamp)
        twist = node.prediction_at(stamp).twist
        self.assertAlmostEqual(twist.linear.x, 0, delta=1e-12)
        self.assertAlmostEqual(twist.linear.y, 0, delta=1e-12)
        self.assertAlmostEqual(twist.angular.z, 1e-5, delta=1e-17)


if __name__ == '__main__':
    run('frames', Frames)
