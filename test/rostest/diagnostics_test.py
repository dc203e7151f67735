#!/usr/bin/env python3
"""The diagnostics: OK needs fresh and valid input, numbers stand alone, and faults are named."""
import math
import re

import geometry_msgs.msg
import nav_msgs.msg
import rospy
import std_msgs.msg
from diagnostic_msgs.msg import DiagnosticArray
from diagnostics_reading import ERROR, OK, WARN, DiagnosticsReader, values
from footprint_collision_predictor.msg import ObstacleArray
from node_testing import BOX, NODE, PATIENT, Recorder, circle, transform
from ros_test_case import RosTestCase, run

BARE_NUMBER = re.compile(r'-?(\d+(\.\d+)?(e[-+]\d+)?|inf|nan)$')
EVERY = dict(PATIENT, diagnostic_period=0.1)


class Diagnostics(RosTestCase):
    def start(self, *arguments, **parameters):
        node = self.rig(*arguments, **(parameters or EVERY))
        reader = DiagnosticsReader(node.namespace)
        self.addCleanup(reader.close)
        return node, reader

    def settle(self, node):
        for _ in range(3):
            node.warning_at(node.send())

    def test_clear(self):
        node, diagnostics = self.start()
        self.settle(node)
        for name in 'collision', 'obstacles', 'transforms', 'computation', 'clock', 'master':
            diagnostics.wait_for(name, lambda s: s.level == OK, 'OK')

    def test_hit(self):
        node, diagnostics = self.start()
        node.send([circle(7, (2, 0))])
        node.send([circle(7, (1.25, 0))])
        hit = diagnostics.wait_for('collision', lambda s: s.message == 'contact imminent')
        self.assertEqual(hit.level, ERROR)
        said = values(hit)
        self.assertEqual(said['level'], '3')
        self.assertEqual(float(said['time to collision [s]']), 0)
        self.assertEqual(said['segment'], '3')
        self.assertEqual(said['obstacle id'], '7')

    def test_never_ok_without_input(self):
        """From its first word on; only what needs no input may be well."""
        node, diagnostics = self.start(diagnostic_period=0.1)
        for name in 'obstacles', 'footprint', 'odom':
            status = diagnostics.next(name)
            self.assertEqual(status.level, ERROR, status)
            self.assertIn(node.topic(name), status.message)
            self.assertEqual(values(status)['age [s]'], 'inf')
        self.assertIn('nothing has come on ' + node.topic('obstacles'),
                      diagnostics.next('collision').message)
        for _ in range(5):
            diagnostics.next('collision')
        good = {s.name.split(': ')[1] for s in diagnostics.all() if s.level == OK}
        self.assertLessEqual(good, {'clock', 'master', 'configuration'})

    def test_input_that_ceases(self):
        node, diagnostics = self.start(footprint=BOX, ego_motion='static', diagnostic_period=0.1)
        self.settle(node)
        diagnostics.wait_for('obstacles', lambda s: s.level == OK, 'OK')
        for name in 'obstacles', 'collision':
            old = diagnostics.wait_for(name, lambda s: s.level == ERROR, 'ERROR',
                                       diagnostics.mark())
            self.assertIn('old', old.message)
        for name in 'transforms', 'computation':
            diagnostics.wait_for(name, lambda s: s.level == WARN, 'WARN', diagnostics.mark())

    def test_every_input_has_an_entry(self):
        node, diagnostics = self.start(diagnostic_period=0.1, max_data_age=30.0)
        footprint = node.publisher('footprint', geometry_msgs.msg.PolygonStamped)
        message = geometry_msgs.msg.PolygonStamped()
        message.header.frame_id, message.header.stamp = 'base_link', rospy.Time.now()
        message.polygon.points = [geometry_msgs.msg.Point32(x, y, 0) for x, y in BOX]
        footprint.publish(message)
        node.send_odometry()
        node.send()
        for name, kind in (('obstacles', ObstacleArray), ('odom', nav_msgs.msg.Odometry),
                           ('footprint', geometry_msgs.msg.PolygonStamped)):
            status = diagnostics.wait_for(name, lambda s: s.level == OK, 'OK')
            said = values(status)
            self.assertEqual(said['type'], kind._type)
            self.assertEqual(said['md5'], kind._md5sum)
            self.assertEqual(said['publishers'], rospy.get_name())
            self.assertEqual((said['received'], said['accepted'], said['rejected']),
                             ('1', '1', '0'))
            self.assertLess(float(said['age [s]']), 30)

    def test_rate(self):
        node, diagnostics = self.start()
        rate = rospy.Rate(20)
        for _ in range(40):
            node.send()
            rate.sleep()
        said = values(diagnostics.next('obstacles'))
        self.assertTrue(10 < float(said['rate [Hz]']) < 25, said)

    def test_refusals_are_counted_and_explained(self):
        node, diagnostics = self.start()
        self.settle(node)
        node.send([circle(7, (math.nan, 0))])
        for name in 'collision', 'obstacles':
            bad = diagnostics.wait_for(name, lambda s: 'position.x' in s.message)
            self.assertEqual(bad.level, ERROR)
        node.send(stamp=rospy.Time(0))
        refused = diagnostics.wait_for('obstacles', lambda s: 'stamp 0' in s.message)
        self.assertEqual(refused.level, ERROR)
        self.assertEqual(values(refused)['rejected'], '1')
        self.settle(node)
        again = diagnostics.wait_for('obstacles', lambda s: s.level == OK, 'OK',
                                     diagnostics.mark())
        self.assertIn('stamp 0', values(again)['last rejection'])
        self.assertLess(float(values(again)['since last rejection [s]']), 30)

    def test_Fault13_unknown_type(self):
        node, diagnostics = self.start(std_msgs.msg.String)
        node.obstacles.publish('not an obstacle')
        status = diagnostics.wait_for('obstacles', lambda s: 'std_msgs/String' in s.message)
        for text in (std_msgs.msg.String._md5sum, 'footprint_collision_predictor/ObstacleArray',
                     'obstacle_detector/Obstacles', 'costmap_converter/ObstacleArrayMsg'):
            self.assertIn(text, status.message)
        self.assertEqual(values(status)['type'], 'std_msgs/String')

    def test_transforms(self):
        node, diagnostics = self.start()
        node.send_transforms(transform('map', 'base_link', 1, 2, stamp=rospy.Time.now()))
        node.send([], 'map', rospy.Time.now())
        lost = diagnostics.wait_for('transforms', lambda s: s.level == ERROR, 'ERROR')
        self.assertIn('"map"', lost.message)
        self.assertIn('"base_link"', lost.message)
        said = values(lost)
        self.assertEqual((said['from'], said['to']), ('map', 'base_link'))
        self.assertGreater(float(said['delay [s]']), 0)
        self.assertGreaterEqual(float(said['waited for by the last message [s]']), 0.1)

    def test_computation(self):
        node, diagnostics = self.start()
        self.settle(node)
        said = values(diagnostics.wait_for('computation', lambda s: s.level == OK, 'OK'))
        self.assertEqual(float(said['period [s]']), 0.05)
        self.assertLess(0, float(said['p50 [s]']))
        self.assertLessEqual(float(said['p50 [s]']), float(said['p99 [s]']))

    def test_numbers_stand_alone(self):
        """A key that names a unit has nothing but a number as its value."""
        node, diagnostics = self.start()
        self.settle(node)
        diagnostics.wait_for('computation', lambda s: s.level == OK, 'OK')
        found = [(item.key, item.value) for s in diagnostics.all() for item in s.values
                 if item.key.endswith(']')]
        self.assertTrue(found)
        for key, value in found:
            self.assertRegex(value, BARE_NUMBER, key)

    def test_the_aggregator_sorts_them(self):
        """As config/diagnostics_aggregator.yaml says."""
        node, diagnostics = self.start()
        self.settle(node)
        aggregated = Recorder('/diagnostics_agg', DiagnosticArray)
        self.addCleanup(aggregated.close)
        entry = '%s %s: ' % (node.namespace[1:], NODE)  # its paths cannot hold a slash
        wanted = {'/Collision prediction/%s/%s%s' % (group, entry, name)
                  for group, name in (('Collision', 'collision'), ('Inputs', 'obstacles'),
                                      ('Inputs', 'transforms'), ('Node', 'computation'),
                                      ('Node', 'clock'), ('Node', 'master'))}
        aggregated.wait_for(lambda m: wanted <= {s.name for s in m.status}, wanted)


if __name__ == '__main__':
    run('diagnostics', Diagnostics)
