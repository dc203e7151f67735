#!/usr/bin/env python3
"""A type that the node does not know is named, and does not keep out the right one afterwards."""
import subprocess

import rospy
import std_msgs.msg
from footprint_collision_predictor.msg import CollisionWarning, ObstacleArray
from foreign_messages import from_costmap_converter
from node_testing import PATIENT, Publisher, circle
from ros_test_case import RosTestCase, run

AHEAD = circle(7, (3, 0), (-1, 0))  # touches the front after 1.5 s


class UnknownType(RosTestCase):
    def setUp(self):
        self.node = self.rig(None, **PATIENT)

    def publish_strings(self):
        """From a process of its own, as a wrong tracker would."""
        process = subprocess.Popen(['rostopic', 'pub', '-r', '20', self.node.topic('obstacles'),
                                    'std_msgs/String', 'not an obstacle'])
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        self.warning = self.node.warning_with(CollisionWarning.REASON_OBSTACLES_TYPE)
        return process

    def test_Fault13_it_is_named_with_those_that_fit(self):
        self.publish_strings()
        for warning in self.warning, self.node.next_warning(), self.node.next_warning():
            self.assertUnknown(warning, CollisionWarning.REASON_OBSTACLES_TYPE)
            self.assertSays(warning, self.node.topic('obstacles'), 'std_msgs/String',
                            std_msgs.msg.String._md5sum,
                            'footprint_collision_predictor/ObstacleArray', ObstacleArray._md5sum,
                            'obstacle_detector/Obstacles', '043bbf49c7775f8111e850268dbcf2e3',
                            'costmap_converter/ObstacleArrayMsg',
                            '8a1bdcde72c65ca7d3ce8ebf52d43516')

    def check_taken(self, message):
        publisher = Publisher(self.node.topic('obstacles'), type(message))
        self.addCleanup(publisher.close)
        message.header.frame_id, message.header.stamp = 'base_link', rospy.Time.now()
        publisher.publish(message)
        warning = self.node.warning_at(message.header.stamp)
        self.assertEqual(warning.reason & CollisionWarning.REASON_OBSTACLES_TYPE, 0, warning)
        self.assertAlmostEqual(warning.time_to_collision, 1.5, delta=1e-9)
        return publisher

    def test_the_right_one_is_taken_when_the_wrong_one_has_gone(self):
        wrong = self.publish_strings()
        wrong.terminate()
        wrong.wait()
        self.check_taken(ObstacleArray(obstacles=[AHEAD]))

    def test_one_good_type_after_the_other(self):
        self.check_taken(ObstacleArray(obstacles=[AHEAD])).close()
        self.check_taken(from_costmap_converter([AHEAD])).close()
        self.check_taken(ObstacleArray(obstacles=[AHEAD]))


if __name__ == '__main__':
    run('unknown_type', UnknownType)
