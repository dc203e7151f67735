#!/usr/bin/env python3
"""A recorded robot that turns most of the time: never a straight-line answer while it does."""
import math

import nav_msgs.msg
import rospy
from node_testing import circle
from recorded_data import play, recording
from ros_test_case import RosTestCase, run

SECONDS = 15
TURNING = 0.01  # [rad/s] or more moves the footprint by centimetres within the horizon
AHEAD = circle(7, (3, 0))


class RecordedTurtlebot(RosTestCase):
    def test_turning(self):
        bag = recording(self, 'turtlebot3.bag')
        node = self.rig(footprint=[[0.1, 0.1], [-0.2, 0.1], [-0.2, -0.1], [0.1, -0.1]],
                        base_frame='base_footprint', max_data_age=10.0, transform_tolerance=10.0)
        yaw_rates = {}  # by the stamps at which obstacles were sent: those of the odometry

        def send_obstacles(message):
            stamp = message.header.stamp
            yaw_rates[stamp] = message.twist.twist.angular.z
            node.send([AHEAD], 'base_footprint', stamp)

        subscriber = rospy.Subscriber(node.topic('odom'), nav_msgs.msg.Odometry, send_obstacles)
        self.addCleanup(subscriber.unregister)
        player = play(self, bag, ['/odom'], '-u', str(SECONDS), '/odom:=' + node.topic('odom'))
        self.assertEqual(player.wait(200), 0, 'exit status of rosbag play')
        node.warning_at(max(yaw_rates))
        self.check(node, yaw_rates)

    def check(self, node, yaw_rates):
        answers = [w for w in node.warnings.messages if w.header.stamp in yaw_rates]
        self.assertGreaterEqual({w.header.stamp for w in answers}, set(yaw_rates))
        turning = 0
        for warning in answers:
            if abs(yaw_rates[warning.header.stamp]) < TURNING:
                continue
            turning += 1
            self.assertUnknown(warning, warning.REASON_NOT_SUPPORTED)
            self.assertTrue(math.isnan(warning.time_to_collision), warning)
        self.assertGreater(turning, 300)
        for prediction in node.predictions.messages:
            if abs(yaw_rates[prediction.header.stamp]) < TURNING:
                continue
            for segment in prediction.segments:
                self.assertTrue(math.isnan(segment.time_to_collision), segment)
                self.assertEqual(segment.contact_free_time, 0)
        print('\n%d messages, %d of them while turning' % (len(yaw_rates), turning))


if __name__ == '__main__':
    run('recorded_turtlebot', RecordedTurtlebot)
