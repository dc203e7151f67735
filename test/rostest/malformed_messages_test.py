#!/usr/bin/env python3
"""Bytes that are not the message they claim to be are refused before memory is taken for them."""
import geometry_msgs.msg
import nav_msgs.msg
import rospy
from foreign_messages import from_costmap_converter, from_obstacle_detector
from footprint_collision_predictor.msg import CollisionWarning, ObstacleArray
from node_testing import BOX, PATIENT, circle
from raw_messages import raw, resident_memory, serialized, stamped, with_lie
from ros_test_case import RosTestCase, run

MOST_GROWTH = 10e6  # [bytes]
LONGEST_SILENCE = 0.15  # [s]
LIES = (0xffffffff, 0x7fffffff, 700000000, 3)


def some_of(wrong):
    """Not every truncation, where most would end in a long covariance."""
    def fewer(good):
        for i, data in enumerate(wrong(good)):
            if i % 7 == 0 or len(data) >= len(good):
                yield data
    return fewer


class MalformedMessages(RosTestCase):
    def check(self, topic, good, wrong, reason, **parameters):
        """Every wrong message is refused by name and harmless; after it a good one is accepted."""
        node = self.rig(None, **parameters)
        raw_class = raw(type(good))
        publisher = node.publisher(topic, raw_class)
        stamp, good = good.header.stamp, serialized(good)
        mark = node.warnings.mark()
        memory = resident_memory(node.process)
        for data in wrong(good):
            with self.subTest(length=len(data), data=data[-40:]):
                self.send(node, publisher, raw_class(data), lambda w: w.reason & reason)
                warning = node.warnings.messages[-1]
                self.assertUnknown(warning, reason)
                self.assertSays(warning, node.topic(topic), 'refused')
                self.send(node, publisher, raw_class(good), lambda w: not w.reason & reason)
        self.assertTrue(node.is_alive())
        self.assertLess(resident_memory(node.process) - memory, MOST_GROWTH)
        # By the node's own clock; answers to the good message carry its old stamp instead.
        times = [w.header.stamp for w in node.warnings.messages[mark:] if w.header.stamp != stamp]
        gaps = [(later - earlier).to_sec() for earlier, later in zip(times, times[1:])]
        self.assertLess(max(gaps), LONGEST_SILENCE)

    def send(self, node, publisher, message, condition):
        mark = node.warnings.mark()
        publisher.publish(message)
        node.warnings.wait_for(condition, 'the answer', mark)

    def every_way(self, *counts):
        """All truncations, trailing bytes, and lies at the given offsets of array lengths."""
        def wrong(good):
            for length in range(len(good)):
                yield good[:length]
            yield good + b'\0'
            yield good + good
            for offset in (12,) + counts:  # 12: the length of the frame's name
                for lie in LIES:
                    yield with_lie(good, offset, lie)
        return wrong

    OBSTACLES = CollisionWarning.REASON_OBSTACLES_INVALID
    SCENE = [circle(7, (30, 0))]
    LIST = 12 + 4 + len('base_link')  # offset of what follows the header

    def test_Fault08_Fault09_own_type(self):
        good = stamped(ObstacleArray(obstacles=self.SCENE))
        outline = len(serialized(good)) - 4
        self.check('obstacles', good, self.every_way(self.LIST, outline), self.OBSTACLES, **PATIENT)

    def test_Fault08_Fault09_obstacle_detector(self):
        good = stamped(from_obstacle_detector(self.SCENE, margin=0))
        self.check('obstacles', good, self.every_way(self.LIST, self.LIST + 4), self.OBSTACLES,
                   **PATIENT)

    def test_Fault08_Fault09_costmap_converter(self):
        good = stamped(from_costmap_converter(self.SCENE))
        polygon = self.LIST + 4 + 16
        wrong = self.every_way(self.LIST, polygon)
        self.check('obstacles', good, some_of(wrong), self.OBSTACLES, **PATIENT)

    def test_Fault08_Fault09_footprint(self):
        good = stamped(geometry_msgs.msg.PolygonStamped())
        good.polygon.points = [geometry_msgs.msg.Point32(x, y, 0) for x, y in BOX]
        self.check('footprint', good, self.every_way(self.LIST),
                   CollisionWarning.REASON_FOOTPRINT_INVALID, ego_motion='static')

    def test_Fault08_Fault09_odometry(self):
        good = stamped(nav_msgs.msg.Odometry())
        self.check('odom', good, some_of(self.every_way(self.LIST)),
                   CollisionWarning.REASON_ODOM_INVALID, footprint=BOX)


if __name__ == '__main__':
    run('malformed_messages', MalformedMessages)
