#!/usr/bin/env python3
"""People walk round a robot between walls: every message of a real tracker is answered, rightly."""
import cmath
import math

import rosbag
import rospy
from approach import Body, Obstacle
from foreign_messages import ObstacleDetectorObstacles
from recomputation import Moment, compare
from recorded_data import play_until, recording
from ros_test_case import RosTestCase, run

HORIZON = 5.0
FOOTPRINT = [0.3 + 0.2j, -0.3 + 0.2j, -0.3 - 0.2j, 0.3 - 0.2j]
GRAZE = {'static': 1e-9, 'odom': 2e-9}  # [m]; the node itself allows 1e-9 to a robot that turns
EVERY = 5  # of how many messages the closest approach of one is recomputed


def point(p):
    return complex(p.x, p.y)


def obstacles_of(message):
    """Circles first, then segments, which stand still."""
    circles = [Obstacle(point(c.center), point(c.velocity), radius=c.true_radius)
               for c in message.circles]
    return circles + [Obstacle(point(s.first_point),
                               outline=(0, point(s.last_point) - point(s.first_point)))
                      for s in message.segments]


def standing(_stamp):
    return 0j, 0.0


def driving(stamp):
    """A curve of its own for each moment: velocity and yaw rate."""
    return cmath.rect(0.6, stamp.to_sec() % 100), 0.5 * math.sin(stamp.to_sec() % 7)


class RecordedLidar(RosTestCase):
    def test_standing(self):
        self.check('static', standing)

    def test_driving(self):
        """As if the robot had driven away just then: towards the walls, too."""
        tally = self.check('odom', driving)
        self.assertGreater(tally['contacts with outlines'], 100, 'too few to have tested anything')

    def check(self, ego_motion, twist_at):
        bag = recording(self, 'lidar_obstacles.bag')
        messages = self.read(bag)
        node = self.rig(None, footprint=[[vertex.real, vertex.imag] for vertex in FOOTPRINT],
                        base_frame='robot', fixed_frame='map', ego_motion=ego_motion,
                        clear_after=1, max_data_age=60.0, transform_tolerance=60.0)
        topic = self.drive(node) if ego_motion == 'odom' else node.topic('obstacles')
        predictions = node.predictions.messages
        play_until(lambda: len(predictions) >= len(messages), '%d predictions' % len(messages), bag,
                   ('/obstacles', '/tf_static'), '--rate', '3', '/obstacles:=' + topic)
        self.assertEqual(len(predictions), len(messages))
        node.warning_at(messages[-1].header.stamp)
        moments = [Moment(message.header.stamp, Body(FOOTPRINT, *twist_at(message.header.stamp)),
                          obstacles_of(message)) for message in messages]
        tally = compare(self, moments, node, HORIZON, GRAZE[ego_motion], EVERY)
        self.assertGreater(tally['contacts with circles'], 100, 'too few to have tested anything')
        self.assertGreater(tally['closest approaches'], 20, 'too few to have tested anything')
        return tally

    def drive(self, node):
        """Where to play to. The player waits for one subscriber only: with the node as another
        one the first messages might reach just one of them."""
        obstacles = node.publisher('obstacles', ObstacleDetectorObstacles)

        def send_on(message):
            velocity, yaw_rate = driving(message.header.stamp)
            node.send_odometry((velocity.real, velocity.imag), yaw_rate, message.header.stamp,
                               'robot')
            obstacles.publish(message)

        node.send_odometry(stamp=rospy.Time(1), child='robot')  # connected before anything comes
        topic = node.topic('recorded')
        subscriber = rospy.Subscriber(topic, ObstacleDetectorObstacles, send_on)
        self.addCleanup(subscriber.unregister)
        return topic

    def read(self, bag):
        messages = []
        for topic, message, _ in rosbag.Bag(bag).read_messages(['/obstacles', '/tf_static']):
            if topic == '/obstacles':
                self.assertEqual(message._md5sum, ObstacleDetectorObstacles._md5sum)
                self.assertEqual(message.header.frame_id, 'map')
                messages.append(message)
                continue
            for pose in message.transforms:
                if pose.child_frame_id == 'robot':  # so the recomputation needs no transform
                    self.assertEqual(pose.header.frame_id, 'map')
                    self.assertEqual(pose.transform.rotation.w, 1)
                    self.assertPoint(pose.transform.translation, 0, 0, tolerance=0)
        self.assertEqual(len(messages), 661)
        return messages


if __name__ == '__main__':
    run('recorded_lidar', RecordedLidar)
