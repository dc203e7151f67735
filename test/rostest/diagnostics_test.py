#!/usr/bin/env python3
"""The diagnostics tell the level, and what is wrong. (Read raw: no diagnostic_msgs is needed.)"""
import rospy
import std_msgs.msg
from node_testing import PATIENT, Recorder, circle
from ros_test_case import RosTestCase, run


class RawMessage(rospy.AnyMsg):
    def __str__(self):
        return str(self._buff)


class Diagnostics(RosTestCase):
    def wait_for(self, node, *texts):
        diagnostics = Recorder('/diagnostics', RawMessage)
        self.addCleanup(diagnostics.close)
        texts += (node.namespace[1:] + '/predictor_node',)
        diagnostics.wait_for(lambda m: all(text.encode() in m._buff for text in texts), texts)

    def node(self, *arguments):
        return self.rig(*arguments, **dict(PATIENT, diagnostic_period=0.1))

    def test_clear(self):
        node = self.node()
        for _ in range(3):
            node.send()
        self.wait_for(node, 'clear')

    def test_hit(self):
        node = self.node()
        node.send([circle(7, (2, 0))])
        node.send([circle(7, (1.25, 0))])
        self.wait_for(node, 'contact imminent')

    def test_missing_input(self):
        node = self.node()
        self.wait_for(node, 'unknown', 'nothing has come on ' + node.topic('obstacles'))

    def test_unknown_type(self):
        node = self.node(std_msgs.msg.String)
        node.obstacles.publish('not an obstacle')
        self.wait_for(node, 'std_msgs/String', std_msgs.msg.String._md5sum,
                      'footprint_collision_predictor/ObstacleArray', 'obstacle_detector/Obstacles',
                      'costmap_converter/ObstacleArrayMsg')


if __name__ == '__main__':
    run('diagnostics', Diagnostics)
