#!/usr/bin/env python3
"""A recorded robot that turns most of the time: every message is answered, rightly."""
import cmath
import math

import nav_msgs.msg
import rospy
from approach import Body, Obstacle
from geometry_msgs.msg import Point
from node_testing import circle, transform, wait_until
from recomputation import Moment, compare
from recorded_data import play_until, recording
from ros_test_case import RosTestCase, run

HORIZON = 5.0
FOOTPRINT = [0.1 + 0.1j, -0.2 + 0.1j, -0.2 - 0.1j, 0.1 - 0.1j]
TURNING = 0.01  # [rad/s] or more moves the footprint by centimetres within the horizon
GRAZE = 2e-9  # [m]; the node itself allows 1e-9 to a robot that turns
MESSAGES = 2741  # of the recording
EVERY = 10  # of how many messages the closest approach of one is recomputed
UNANSWERED = 50  # messages, at most: of more, a busy node drops the oldest

# What stood there, and the robot drove round: the nearest came within a quarter of a metre.
PILLARS = [Obstacle(complex(x, y), radius=0.15) for x in (-1.1, 0, 1.1) for y in (-1.1, 0, 1.1)]
CART = (0.2 + 0.15j, -0.2 + 0.15j, -0.2 - 0.15j, 0.2 - 0.15j)


def pose(odometry):
    """Position and direction of the robot."""
    position, q = odometry.pose.pose.position, odometry.pose.pose.orientation
    yaw = math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))
    return complex(position.x, position.y), cmath.rect(1, yaw)


def obstacles_around(odometry):
    """Pillars; and in every third message what comes for the robot, each time from elsewhere."""
    if odometry.header.seq % 3:
        return PILLARS
    position, _ = pose(odometry)
    towards = cmath.rect(1, odometry.header.seq)
    walker = Obstacle(position - 1.5 * towards, 0.3 * towards * cmath.rect(1, 0.2),
                      -0.05 * towards, radius=0.2, radius_rate=0.02)
    cart = Obstacle(position + 1.2j * towards, -0.4j * towards, outline=CART)
    wall = Obstacle(position - 2j * towards, 0.5j * towards, radius=0.1, outline=(0, 1 + 0.5j))
    return [*PILLARS, walker, cart, wall]


def message_of(identity, o):
    message = circle(identity, *((vector.real, vector.imag) for vector in (o.position, o.velocity)),
                     o.radius, (o.acceleration.real, o.acceleration.imag))
    message.radius_rate = o.radius_rate
    message.outline = [Point(vertex.real, vertex.imag, 0) for vertex in map(complex, o.outline)]
    return message


class RecordedTurtlebot(RosTestCase):
    def test_all(self):
        bag = recording(self, 'turtlebot3.bag')
        node = self.rig(footprint=[[vertex.real, vertex.imag] for vertex in FOOTPRINT],
                        base_frame='base_footprint', clear_after=1, max_data_age=60.0,
                        transform_tolerance=60.0)
        sent, predictions = [], node.predictions.messages

        def send_surroundings(odometry):
            robot.publish(odometry)  # first: it numbers the message anew
            stamp = odometry.header.stamp
            position, direction = pose(odometry)
            half = cmath.sqrt(direction)
            node.send_transforms(transform('odom', 'base_footprint', position.real, position.imag,
                                           half.imag, half.real, stamp))
            wait_until(lambda: len(sent) - len(predictions) < UNANSWERED, 'the predictions')
            node.send(map(message_of, range(20), obstacles_around(odometry)), 'odom', stamp)
            sent.append(odometry)

        # Through here: the player waits for one subscriber only, and the node would be another.
        robot = node.publisher('odom', nav_msgs.msg.Odometry)
        node.send_transforms()  # connected before anything comes
        topic = node.topic('recorded')
        subscriber = rospy.Subscriber(topic, nav_msgs.msg.Odometry, send_surroundings)
        self.addCleanup(subscriber.unregister)
        play_until(lambda: len(predictions) >= MESSAGES, '%d predictions' % MESSAGES, bag,
                   ['/odom'], '--rate', '4', '/odom:=' + topic)
        node.warning_at(sent[-1].header.stamp)
        self.assertEqual(len(sent), MESSAGES)
        moments = [self.moment(odometry) for odometry in sent]
        turning = sum(abs(moment.body.yaw_rate) >= TURNING for moment in moments)
        self.assertGreater(turning, 2400)
        tally = compare(self, moments, node, HORIZON, GRAZE, EVERY)
        for what in 'contacts with circles', 'contacts with outlines', 'closest approaches':
            self.assertGreater(tally[what], 100, 'too few to have tested anything')

    def moment(self, odometry):
        twist = odometry.twist.twist
        body = Body(FOOTPRINT, complex(twist.linear.x, twist.linear.y), twist.angular.z)
        return Moment(odometry.header.stamp, body,
                      [obstacle.seen_from(*pose(odometry)) for obstacle in obstacles_around(odometry)])


if __name__ == '__main__':
    run('recorded_turtlebot', RecordedTurtlebot)
