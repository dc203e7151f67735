#!/usr/bin/env python3
"""Input with faults mixed in, for SOAK_SECONDS (120): memory and file descriptors stay as they are."""
import itertools
import math
import os
import random
import time

import rospy
import std_msgs.msg
from footprint_collision_predictor.msg import CollisionPrediction, CollisionWarning, ObstacleArray
from node_testing import BOX, Publisher, Recorder, circle, transform
from raw_messages import raw, resident_memory, serialized, stamped
from ros_test_case import RosTestCase, run

SECONDS = float(os.environ.get('SOAK_SECONDS', 120))
SETTLED = 60.0  # [s] after which memory is not to grow any more
MOST_GROWTH = 5e6  # [bytes]
SEED = 1


def descriptors(process):
    return len(os.listdir('/proc/%d/fd' % process.pid))


class Soak(RosTestCase):
    def setUp(self):
        self.node = self.rig(None, footprint=BOX, transform_tolerance=0.05)
        self.raw = raw(ObstacleArray)
        self.publisher = self.node.publisher('obstacles', self.raw)
        self.random = random.Random(SEED)
        # The rig keeps all that it hears, which would be this test's own growth.
        self.node.warnings.close()
        self.node.predictions.close()

    def obstacles(self):
        return [circle(i % 90, (self.random.uniform(-20, 20), self.random.uniform(-20, 20)),
                       (self.random.gauss(0, 2), self.random.gauss(0, 2)))
                for i in range(self.random.randint(0, 100))]

    def good(self):
        return serialized(stamped(ObstacleArray(obstacles=self.obstacles())))

    def bad(self):
        """One of many ways to be wrong."""
        message = stamped(ObstacleArray(obstacles=self.obstacles() + [circle(7, (9, 9))]))
        way = self.random.randrange(7)
        if way == 0:
            message.header.stamp = rospy.Time()
        elif way == 1:
            message.header.stamp += rospy.Duration(self.random.choice((-60, 60)))
        elif way == 2:
            message.header.frame_id = self.random.choice(('', 'atlantis', 'map'))
        elif way == 3:
            message.obstacles[0].velocity.x = self.random.choice((math.nan, math.inf, 1e300))
        elif way == 4:
            return serialized(message)[:self.random.randrange(100)]
        elif way == 5:
            return serialized(message) + b'x'
        else:
            message.obstacles = message.obstacles * 120  # some of them more than are allowed
        return serialized(message)

    def step(self, i):
        self.publisher.publish(self.raw(self.bad() if i % 5 == 0 else self.good()))
        self.node.send_odometry((self.random.uniform(-1, 1), 0),
                                stamp=rospy.Time() if i % 37 == 0 else None)
        self.node.send_transforms(transform('map', 'base_link', i, 2, stamp=rospy.Time.now()))
        if i % 101 == 0:
            self.come_and_go()

    def come_and_go(self):
        """A consumer, and a second publisher of the wrong type."""
        consumer = Recorder(self.node.topic('collision_prediction'), CollisionPrediction)
        consumer.wait_connected()
        consumer.close()
        rospy.Publisher(self.node.topic('odom'), std_msgs.msg.String, queue_size=1).unregister()

    def test_Fault36_memory_and_descriptors_stay(self):
        begin, settled, rate = time.monotonic(), None, rospy.Rate(50)
        for i in itertools.count():
            self.step(i)
            rate.sleep()
            passed = time.monotonic() - begin
            if settled is None and passed >= min(SETTLED, SECONDS / 2):
                settled = resident_memory(self.node.process), descriptors(self.node.process)
            if passed >= SECONDS:
                break
        growth = resident_memory(self.node.process) - settled[0]
        print('memory %d kB after %.0f s, %+d kB since; descriptors %d, then %d; %d messages' %
              (settled[0] / 1000, min(SETTLED, SECONDS / 2), growth / 1000, settled[1],
               descriptors(self.node.process), i + 1))
        self.assertLess(growth, MOST_GROWTH)
        self.assertLessEqual(abs(descriptors(self.node.process) - settled[1]), 2)
        self.assertTrue(self.node.is_alive())
        warnings = Recorder(self.node.topic('collision_warning'), CollisionWarning)
        self.addCleanup(warnings.close)
        warnings.wait_for(lambda w: True, 'a heartbeat')


if __name__ == '__main__':
    run('soak', Soak)
