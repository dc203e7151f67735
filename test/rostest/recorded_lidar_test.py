#!/usr/bin/env python3
"""People walk round a standing robot: every message of a real tracker is answered, rightly."""
import math

import rosbag
from circle_and_segment import Approach
from foreign_messages import ObstacleDetectorObstacles
from node_testing import wait_until
from recorded_data import play, recording
from ros_test_case import RosTestCase, run

HORIZON = 5.0
FOOTPRINT = [(0.3, 0.2), (-0.3, 0.2), (-0.3, -0.2), (0.3, -0.2)]
SEGMENTS = [(FOOTPRINT[i], FOOTPRINT[(i + 1) % 4]) for i in range(4)]
TIME_TOLERANCE = 1e-6  # [s]
GRAZE = 1e-9  # [m] within which a contact may be seen or not: time is ill-conditioned there


class RecordedLidar(RosTestCase):
    def test_all(self):
        bag = recording(self, 'lidar_obstacles.bag')
        node = self.rig(None, footprint=[list(vertex) for vertex in FOOTPRINT], base_frame='robot',
                        fixed_frame='map', ego_motion='static', max_data_age=10.0,
                        transform_tolerance=10.0)
        player = play(self, bag, ('/obstacles', '/tf_static'),
                      '/obstacles:=' + node.topic('obstacles'))
        messages = self.read(bag)
        self.assertEqual(player.wait(300), 0, 'exit status of rosbag play')
        predictions = node.predictions.messages
        wait_until(lambda: len(predictions) >= len(messages),
                   '%d predictions; %d came' % (len(messages), len(predictions)))
        self.assertEqual(len(predictions), len(messages))
        self.grazes = 0
        for index, (message, prediction) in enumerate(zip(messages, predictions)):
            self.check(index, message, prediction)
        self.report(messages, predictions)

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

    def check(self, index, message, prediction):
        self.assertEqual(prediction.header.stamp, message.header.stamp, 'message %d' % index)
        self.assertEqual(len(prediction.segments), len(SEGMENTS))
        for number, (segment, (start, end)) in enumerate(zip(prediction.segments, SEGMENTS)):
            approaches = [Approach((c.center.x, c.center.y), (c.velocity.x, c.velocity.y),
                                   c.true_radius, start, end) for c in message.circles]
            contacts = [approach.first_contact(HORIZON) for approach in approaches]
            expected = min((t for t, _ in contacts if t is not None), default=math.inf)
            found = segment.time_to_collision
            if found == expected or abs(found - expected) <= TIME_TOLERANCE:
                continue
            where = 'message %d, segment %d: found %r, expected %r' % (index, number, found,
                                                                       expected)
            self.assertTrue(self.is_graze(approaches, contacts, segment, expected), where)
            self.grazes += 1

    def is_graze(self, approaches, contacts, segment, expected):
        """Whether both answers are right to within GRAZE: what was found has that gap at that time,
        and what was not found gets no nearer than that."""
        if segment.collision_predicted:
            gap = approaches[segment.obstacle_index].gap(segment.time_to_collision)
            if abs(gap) > GRAZE:
                return False
        if expected < segment.time_to_collision:
            return all(smallest >= -GRAZE for t, smallest in contacts if t == expected)
        return True

    def report(self, messages, predictions):
        smallest, stamp = min((s.time_to_collision, p.header.stamp)
                              for p in predictions for s in p.segments)
        contacts = sum(s.collision_predicted for p in predictions for s in p.segments)
        print('\n%d messages in, %d predictions out, %d contacts, %d of them compared as grazes; '
              'smallest time to collision %.6f s, at %s.%09d' %
              (len(messages), len(predictions), contacts, self.grazes, smallest, stamp.secs,
               stamp.nsecs))
        self.assertGreater(contacts, 100, 'too few to have tested anything')


if __name__ == '__main__':
    run('recorded_lidar', RecordedLidar)
