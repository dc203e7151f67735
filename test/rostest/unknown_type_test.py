#!/usr/bin/env python3
"""A type that the node does not know is named, and does not keep out the right one."""
import std_msgs.msg
from footprint_collision_predictor.msg import CollisionWarning, ObstacleArray
from node_testing import PATIENT, circle
from ros_test_case import RosTestCase, run


class UnknownType(RosTestCase):
    def setUp(self):
        self.node = self.rig(std_msgs.msg.String, **PATIENT)
        self.node.obstacles.publish('not an obstacle')
        self.warning = self.node.warning_with(CollisionWarning.REASON_OBSTACLES_TYPE)

    def test_it_is_named_with_those_that_fit(self):
        self.assertUnknown(self.warning, CollisionWarning.REASON_OBSTACLES_TYPE)
        self.assertSays(self.warning, self.node.topic('obstacles'), 'std_msgs/String',
                        std_msgs.msg.String._md5sum,
                        'footprint_collision_predictor/ObstacleArray', ObstacleArray._md5sum,
                        'obstacle_detector/Obstacles', '043bbf49c7775f8111e850268dbcf2e3',
                        'costmap_converter/ObstacleArrayMsg', '8a1bdcde72c65ca7d3ce8ebf52d43516')

    def test_it_goes_on_being_named(self):
        for _ in range(5):
            self.assertUnknown(self.node.next_warning(), CollisionWarning.REASON_OBSTACLES_TYPE)

    def test_the_right_one_is_taken_when_the_wrong_one_has_gone(self):
        self.node.obstacles.close()
        self.node.obstacles = self.node.publisher('obstacles', ObstacleArray)
        warning = self.node.warning_at(self.node.send([circle(7, (3, 0), (-1, 0))]))
        self.assertEqual(warning.reason & CollisionWarning.REASON_OBSTACLES_TYPE, 0, warning)
        self.assertAlmostEqual(warning.time_to_collision, 1.5, delta=1e-9)


if __name__ == '__main__':
    run('unknown_type', UnknownType)
