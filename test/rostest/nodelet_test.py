#!/usr/bin/env python3
"""The nodelet gives the node's warnings, refuses bad parameters without harm, and leaves nothing."""
import math
import os
import signal
import subprocess

import rosgraph_msgs.msg
import rospy
from diagnostics_reading import OK, DiagnosticsReader
from node_testing import (BOX, NODE, PACKAGE, PATIENT, TIMEOUT, Recorder, Rig, circle,
                          wait_until)
from roslib.packages import find_node
from ros_test_case import RosTestCase, run
from several_bodies import BASE, of

NODELET = find_node('nodelet', 'nodelet')[0]
PLUGIN = 'footprint_collision_predictor/Predictor'
PER_PUBLICATION = ('header', 'sequence', 'session', 'data_age')
SCENES = [
    [],
    [circle(7, (3, 0), (-1, 0))],
    [circle(7, (9, 0), (-2, 0)), circle(8, (0, 4), (0, -2), acceleration=(0, -1))],
    [circle(7, (1.25, 0.2))],
    [circle(7, (math.nan, 0)), circle(8, (4, 0), (-1, 0))],
    [circle(7, (30, 0)), circle(7, (4, 0))],
]


def threads(process):
    return len(os.listdir('/proc/%d/task' % process.pid))


class ManagedRig(Rig):
    """The predictor in a manager; the process is the manager's."""

    def _start(self):
        manager = self.run(NODELET, 'manager', name='manager')
        self.loader = self.load(NODE)
        return manager

    def load(self, name):
        return self.run(NODELET, 'load', PLUGIN, 'manager', name=name)

    def unload(self):
        """Ended by an interrupt, the loader unloads what it has loaded."""
        self.loader.send_signal(signal.SIGINT)
        self.loader.wait(TIMEOUT)

    def close(self):
        self.loader.send_signal(signal.SIGINT)
        super().close()
        self.loader.wait(TIMEOUT)


class LaunchedRig(Rig):
    """As the launch file starts it; the process is roslaunch's."""

    def _start(self):
        arguments = {'nodelet': 'true', 'manager': 'manager', 'footprint': str(BOX),
                     'ego_motion': 'static'}
        manager = self.run(NODELET, 'manager', name='manager')
        self._kept(Ended(manager))
        return subprocess.Popen(
            ['roslaunch', PACKAGE, 'predictor.launch'] +
            ['%s:=%s' % item for item in arguments.items()],
            env=dict(os.environ, ROS_NAMESPACE=self.namespace))


class Ended:
    """Closes by ending a process."""

    def __init__(self, process):
        self._process = process

    def close(self):
        self._process.terminate()
        self._process.wait(TIMEOUT)


class Nodelet(RosTestCase):
    def managed(self, **parameters):
        rig = ManagedRig(**parameters)
        self.addCleanup(rig.close)
        return rig

    def comparable(self, warning):
        return {name: str(getattr(warning, name)) for name in warning.__slots__
                if name not in PER_PUBLICATION}

    def test_the_same_warnings_as_the_node(self):
        nodelet, node = self.managed(**PATIENT), self.rig(**PATIENT)
        for scene in SCENES:
            stamp = node.send(scene)
            nodelet.send(scene, stamp=stamp)
            ours = self.comparable(nodelet.warning_at(stamp))
            theirs = self.comparable(node.warning_at(stamp))
            ours['message'] = ours['message'].replace(nodelet.namespace, node.namespace)
            self.assertEqual(ours, theirs)

    def test_several_bodies(self):
        """The base has 2 m to go, the load on it 1 m, both at 1 m/s."""
        load = dict(BASE, name='load', polygon=[[x + 1, y] for x, y in BOX])
        rig = self.managed(footprints=[BASE, load], ego_motion='static', max_data_age=30.0)
        stamp = rig.send([circle(7, (3.5, 0), (-1, 0))])
        for name, seconds in ('base', 2), ('load', 1):
            warning = of(name, rig.warnings, stamp)
            self.assertAlmostEqual(warning.time_to_collision, seconds, delta=1e-9)

    def test_by_the_launch_file(self):
        rig = LaunchedRig()
        self.addCleanup(rig.close)
        stamp = rig.send([circle(7, (3, 0), (-1, 0))])
        self.assertAlmostEqual(rig.warning_at(stamp).time_to_collision, 1.5, delta=1e-9)

    def test_bad_parameters_refuse_to_load_and_harm_nobody(self):
        """Neither the manager nor the predictor that it runs already."""
        rig = self.managed(**PATIENT)
        log = Recorder('/rosout', rosgraph_msgs.msg.Log)
        self.addCleanup(log.close)
        log.wait_connected(3)  # the manager, its loader, and this test itself
        rospy.set_param(rig.topic('other/footprint'), BOX)
        rospy.set_param(rig.topic('other/waring_time'), 3.0)
        self.assertNotEqual(rig.load('other').wait(TIMEOUT), 0)
        log.wait_for(lambda e: 'unknown parameter ~waring_time; did you mean ~warn_time?' in e.msg,
                     'the message')
        self.assertTrue(rig.is_alive())
        stamp = rig.send([circle(7, (3, 0), (-1, 0))])
        self.assertAlmostEqual(rig.warning_at(stamp).time_to_collision, 1.5, delta=1e-9)

    def test_its_first_diagnostics_are_not_ok(self):
        """Here somebody listens from the start: the manager's other nodelet publishes there too."""
        rig = self.managed(**dict(PATIENT, diagnostic_period=0.1))
        first, other = (DiagnosticsReader(rig.namespace, node) for node in (NODE, 'other'))
        self.addCleanup(first.close)
        self.addCleanup(other.close)
        first.next('collision')
        rospy.set_param(rig.topic('other/diagnostic_period'), 0.1)
        loader = rig.load('other')
        self.addCleanup(loader.wait)
        self.addCleanup(loader.terminate)
        for _ in range(3):
            other.next('collision')
        good = {s.name.split(': ')[1] for s in other.all() if s.level == OK}
        self.assertLessEqual(good, {'clock', 'master', 'configuration'})

    def test_unloading_leaves_no_thread(self):
        rig = self.managed(**PATIENT)
        rig.warning_at(rig.send())
        loaded = threads(rig.process)
        rig.unload()
        wait_until(lambda: threads(rig.process) <= loaded - 3, 'worker, heartbeat and watch to end')
        bare = threads(rig.process)
        for _ in range(5):
            rig.loader = rig.load(NODE)
            rig.warnings.wait_for(lambda w: True, 'a heartbeat', rig.warnings.mark())
            rig.unload()
            wait_until(lambda: threads(rig.process) <= bare, '%d threads' % bare)
        self.assertTrue(rig.is_alive())


if __name__ == '__main__':
    run('nodelet', Nodelet)
