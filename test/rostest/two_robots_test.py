#!/usr/bin/env python3
"""Two robots of several bodies in two namespaces, with one tf tree: neither disturbs the other."""
import rospy
from diagnostics_reading import ERROR, OK, DiagnosticsReader
from node_testing import BOX, NODE, Recorder, circle
from ros_test_case import RosTestCase, run
from several_bodies import PATIENT_ROBOT, of, straight
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

FAR = circle(9, (0, 80))


def robot(name):
    """Bodies have the same names on both, frames have not."""
    return dict(PATIENT_ROBOT, base_frame=name + '/base_link', diagnostic_period=0.1, footprints=[
        {'name': 'base', 'frame_id': name + '/base_link', 'polygon': BOX},
        {'name': 'trailer', 'frame_id': name + '/trailer', 'polygon': BOX}])


class TwoRobots(RosTestCase):
    def setUp(self):
        self.first, self.second = self.rig(**robot('r1')), self.rig(**robot('r2'))
        self.first.publisher('/tf', TFMessage, connections=2)  # both hear what is sent to either

    def send(self, node, name, y, obstacles):
        """A robot that drives along y = const at 1 m/s, its trailer's frame 4 m behind."""
        stamp = node.send_odometry((1, 0), child=name + '/base_link')
        node.send_transforms(*straight(name + '/base_link', 0, y, 1, stamp),
                             *straight(name + '/trailer', -4, y, 1, stamp))
        return node.send(obstacles, 'odom', stamp)

    def check(self, node, stamp, base, trailer):
        """Times to collision."""
        for name, seconds in ('base', base), ('trailer', trailer):
            warning = of(name, node.warnings, stamp)
            self.assertEqual(warning.reason, 0, warning)
            self.assertAlmostEqual(warning.time_to_collision, seconds, delta=1e-9)

    def test_warnings_diagnostics_and_markers(self):
        infinity = float('inf')
        readers = [DiagnosticsReader(node.namespace) for node in (self.first, self.second)]
        pictures = [Recorder(node.topic(NODE + '/markers'), MarkerArray)
                    for node in (self.first, self.second)]
        for closable in readers + pictures:
            self.addCleanup(closable.close)
        # The first one's base has 2.5 m to go at 1 m/s; the second one's trailer is run into from
        # 2 m beside it at 2 m/s.
        beside = circle(8, (-4, 23), (1, -2))
        first = self.send(self.first, 'r1', 0, [circle(7, (4, 0)), FAR])
        second = self.send(self.second, 'r2', 20, [beside, FAR])
        self.check(self.first, first, 2.5, infinity)
        self.check(self.second, second, infinity, 1)
        for picture, frames in zip(pictures, ({'r1/base_link', 'r1/trailer'},
                                              {'r2/base_link', 'r2/trailer'})):
            found = picture.wait_for(lambda a: True)
            self.assertEqual({m.header.frame_id for m in found.markers}, frames)
        first = self.send(self.first, 'r1', 0, [FAR])
        second = self.send(self.second, 'r2', 20, [circle(8, (-4, 20))])  # inside of the trailer
        self.check(self.first, first, infinity, infinity)
        self.check(self.second, second, infinity, 0)
        marks = [reader.mark() for reader in readers]
        readers[0].wait_for('collision', lambda s: s.level == OK, 'OK', marks[0])
        readers[1].wait_for('collision', lambda s: s.level == ERROR, 'ERROR', marks[1])
        self.assertEqual(readers[0].next('collision trailer').level, OK)

    def test_one_that_ends_leaves_the_other(self):
        self.first.process.kill()
        self.first.process.wait()
        mark = self.second.warnings.mark()
        stamp = self.send(self.second, 'r2', 20, [circle(7, (4, 20))])
        self.check(self.second, stamp, 2.5, float('inf'))
        silent = self.first.warnings.mark()
        for name in 'base', 'trailer':
            last = of(name, self.second.warnings, since=mark).sequence
            self.second.warnings.wait_for(
                lambda w: w.footprint == name and w.sequence == last + 20, 'a second of heartbeats')
        self.assertEqual(self.first.warnings.mark(), silent)

    def test_refused_input_of_one_is_none_of_the_others(self):
        first = self.send(self.first, 'r1', 0, [circle(7, (float('nan'), 0))])
        second = self.send(self.second, 'r2', 20, [FAR])
        for name in 'base', 'trailer':
            bad = of(name, self.first.warnings, first)
            self.assertUnknown(bad, bad.REASON_OBSTACLES_INVALID)
        self.check(self.second, second, float('inf'), float('inf'))


if __name__ == '__main__':
    run('two_robots', TwoRobots)
