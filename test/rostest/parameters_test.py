#!/usr/bin/env python3
"""A wrong parameter ends the node with a status other than 0 and a message that helps."""
import itertools
import math
import subprocess

import rospy
from node_testing import BOX, NODE, PACKAGE, TIMEOUT
from roslib.packages import find_node
from ros_test_case import RosTestCase, run
from several_bodies import BASE, TRAILER, without

ORDER = ('0 < critical_time <= warn_time <= horizon',)
FORMS = ('[[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2]]', '"[[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2]]"')
LIST = ('~footprints', 'allowed is a list with {name: trailer, frame_id: trailer, polygon: [[')
BOW_TIE = [[1.0, 1.0], [-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0]]

# Times that must be positive, rates and counts: every way to get one wrong.
NUMBERS = [(name, value)
           for name in ('horizon', 'warn_time', 'critical_time', 'max_data_age', 'heartbeat_rate',
                        'diagnostic_period')
           for value in ('1e-3', math.nan, math.inf, -1.0, 0.0, 0, 1e300, True, [1.0], {'a': 1.0})]
NUMBERS += [('transform_tolerance', value) for value in ('1e-3', math.nan, -0.1, False)]
NUMBERS += [(name, value) for name in ('clear_after', 'max_obstacles', 'max_vertices')
            for value in ('3', math.nan, -1, 0, 3.5, True)]
NUMBERS += [('heartbeat_rate', 9.0), ('heartbeat_rate', 1001.0)]

# parameters, what the message must contain
CASES = [({name: value}, ('~' + name, 'allowed is', 'number from')) for name, value in NUMBERS]
CASES += [
    ({'warn_time': '1e-3'}, ('YAML', '1e-3', '0.001')),
    ({'critical_time': 3.5}, ('~critical_time 3.5', '~warn_time 3') + ORDER),
    ({'warn_time': 6.0}, ('~warn_time 6', '~horizon 5') + ORDER),
    ({'horizon': 2.0}, ('~warn_time 3', '~horizon 2') + ORDER),
    ({'transform_tolerance': 1.0}, ('~transform_tolerance 1', '~max_data_age 0.5')),
    ({'waring_time': 3.0}, ('unknown parameter ~waring_time', 'did you mean ~warn_time?')),
    ({'foot_print': BOX}, ('unknown parameter ~foot_print', 'did you mean ~footprint?')),
    ({'xyzzy': 1}, ('unknown parameter ~xyzzy',)),
    ({'ego_motion': 'tf'}, ('~ego_motion', 'tf', 'odom', 'static')),
    ({'ego_motion': 1}, ('~ego_motion', 'odom', 'static')),
    ({'obstacle_velocity': 'absolute'}, ('~obstacle_velocity', 'over_ground', 'relative')),
    ({'obstacle_detector_radius': 'big'}, ('~obstacle_detector_radius', 'true_radius', 'radius')),
    ({'base_frame': ''}, ('~base_frame', 'frame')),
    ({'fixed_frame': 7}, ('~fixed_frame', '7', 'frame')),
    ({'footprint': 'a box'}, ('~footprint', 'a box') + FORMS),
    ({'footprint': 3.0}, ('~footprint',) + FORMS),
    ({'footprint': [1.0, 2.0, 3.0]}, ('~footprint', 'vertex 0') + FORMS),
    ({'footprint': [[1.0, 2.0, 3.0]]}, ('~footprint', 'vertex 0') + FORMS),
    ({'footprint': [[1, 1], [0, 'x'], [0, 0]]}, ('~footprint', 'vertex 1') + FORMS),
    ({'footprint': '[[1, 1], [0, x], [0, 0]]'}, ('~footprint',) + FORMS),
    ({'footprint': '[[1, 1], [0, 1], [0, 0]'}, ('~footprint',) + FORMS),
    ({'footprint': '[[1, 1], [.nan, 1], [0, 0]]'}, ('~footprint', 'vertex 1', 'nan', 'finite')),
    ({'footprint': [[1, 1], [math.inf, 1], [0, 0]]}, ('~footprint', 'vertex 1', 'inf', 'finite')),
    ({'footprint': []}, ('~footprint', 'at least 3', 'there are 0')),
    ({'footprint': [[1, 1], [0, 0]]}, ('~footprint', 'at least 3', 'there are 2')),
    ({'footprint': '[[1, 1], [0, 0]]'}, ('~footprint', 'at least 3', 'there are 2')),
    ({'footprint': [[0, 0], [1, 0], [2, 0]]}, ('~footprint', 'area')),
    ({'footprint': BOW_TIE}, ('~footprint', 'cross', '(1, 1)')),
    ({'footprint': str(BOW_TIE)}, ('~footprint', 'cross', '(1, 1)')),
    ({'footprint': BOX, 'max_vertices': 3}, ('~footprint', '4 vertices', '~max_vertices 3')),
    ({'footprints': 'trailer'}, LIST),
    ({'footprints': []}, LIST),
    ({'footprints': [BASE, 'trailer']}, ('~footprints[1] is trailer',) + LIST),
    ({'footprints': [BASE], 'footprint': BOX}, ('~footprint and ~footprints are both set',)),
    ({'footprints': [BASE, dict(TRAILER, name='base')]},
     ('~footprints[1].name is base', '~footprints[0]')),
    ({'footprints': [BASE, dict(TRAILER, name='my trailer')]},
     ('~footprints[1].name', 'my trailer', 'allowed is')),
    ({'footprints': [BASE, without(TRAILER, 'frame_id')]}, ('~footprints[1].frame_id is missing',)),
    ({'footprints': [BASE, without(TRAILER, 'frame_id', frame='x')]},
     ('unknown parameter ~footprints[1].frame;', 'did you mean ~footprints[1].frame_id?')),
    ({'footprints': [BASE, without(TRAILER, 'polygon')]},
     ('~footprints[1] has neither polygon nor topic',)),
    ({'footprints': [BASE, dict(TRAILER, topic='x')]}, ('~footprints[1] has both polygon and topic',)),
    ({'footprints': [BASE, without(TRAILER, 'polygon', topic='a b')]},
     ('~footprints[1].topic', 'a b', 'the name of a topic')),
    ({'footprints': [BASE, dict(TRAILER, motion='map')]},
     ('~footprints[1].motion is map', 'odom or static or tf')),
    ({'footprints': [BASE, dict(TRAILER, motion='odom')], 'ego_motion': 'static'},
     ('~footprints[1].motion is odom', '~ego_motion is static')),
    ({'footprints': [BASE, dict(TRAILER, polygon=BOW_TIE)]},
     ('~footprints[1].polygon is refused', 'cross', '(1, 1)')),
    ({'footprints': [dict(BASE, polygon=[[1, 1], [math.nan, 1], [0, 0]])]},
     ('~footprints[0].polygon is refused', 'vertex 1', 'nan')),
    ({'footprints': [BASE], 'max_vertices': 3},
     ('~footprints[0].polygon is refused', '4 vertices', '~max_vertices 3')),
]


class Parameters(RosTestCase):
    numbers = itertools.count(1)

    def start(self, parameters):
        namespace = '/case_%d' % next(self.numbers)
        for name, value in parameters.items():
            rospy.set_param('/'.join((namespace, NODE, name)), value)
        return subprocess.Popen(
            [find_node(PACKAGE, NODE)[0], '__ns:=' + namespace, '__name:=' + NODE],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def check(self, parameters, *words):
        with self.subTest(**{'parameters': parameters}):
            process = self.start(parameters)
            try:
                output, _ = process.communicate(timeout=TIMEOUT)
            except subprocess.TimeoutExpired:
                process.kill()
                self.fail('it runs, having said:\n' + process.communicate()[0])
            self.assertGreater(process.returncode, 0, 'a signal, or success:\n' + output)
            for word in words:
                self.assertIn(word, output)

    def test_Fault39_Fault40_Fault42_table(self):
        for parameters, words in CASES:
            self.check(parameters, *words)

    def test_all_are_told_at_once(self):
        self.check({'horizon': -1.0, 'waring_time': 2.0, 'footprint': []},
                   '~horizon', '~waring_time', '~footprint')

    def test_limits_themselves_are_allowed(self):
        rig = self.rig(horizon=3.0, warn_time=3, critical_time=3.0, heartbeat_rate=10,
                       clear_after=1, max_data_age=0.1, transform_tolerance=0.1, max_vertices=3,
                       max_obstacles=1, diagnostic_period=0.5,
                       footprint='[[1, 0], [0, 1.5e0], [-1, 0]]', ego_motion='odom',
                       obstacle_velocity='relative', base_frame='/base')
        self.assertEqual(rig.next_warning().header.frame_id, 'base')
        self.assertTrue(rig.is_alive())


if __name__ == '__main__':
    run('parameters', Parameters)
