#!/usr/bin/env python3
"""The master, the tracker and the robot's controller on one machine, the predictor on another.

Each moment is of the one clock that both machines share here.
"""
import time
import unittest

import machines
from footprint_collision_predictor.msg import CollisionWarning
from machines import Cable, Machine, Report
from node_testing import BOX, PACKAGE
from roslib.packages import find_node
from ros_test_case import RosTestCase, run

SAFE_WITHIN = 0.3    # [s] for the controller, by the shipped watchdog
UNKNOWN_WITHIN = 0.75  # [s] max_data_age, a heartbeat, and 200 ms
CUT_FOR = 3.0        # [s]
WHY_NOT = machines.missing()


def says_stale(line):
    return (line['level'] == CollisionWarning.UNKNOWN and
            line['reason'] & CollisionWarning.REASON_OBSTACLES_STALE)


@unittest.skipIf(WHY_NOT, WHY_NOT)
class TwoMachines(RosTestCase):
    def setUp(self):
        self.here, self.there = [self.kept(Machine(number), Machine.remove) for number in (1, 2)]
        self.cable = Cable(self.here, self.there)
        self.start(self.here, 'rosmaster', '--core', '-p', '11311')
        self.robot = self.kept(Report(self.here, 'tracker'), Report.close)
        self.start(self.here, find_node(PACKAGE, 'cmd_vel_guard')[0])
        self.start(self.there, find_node(PACKAGE, 'predictor_node')[0], '_footprint:=%s' % BOX,
                   '_ego_motion:=static')
        self.node = self.kept(Report(self.there, 'observer'), Report.close)
        self.wait_going()

    def kept(self, thing, close):
        self.addCleanup(close, thing)
        return thing

    def start(self, machine, *command):
        process = machine.start(*command)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)

    def wait_going(self):
        """Until warnings cross, so that the controller goes on, and are CLEAR on the other side."""
        self.robot.wait_for(lambda line: line['going'], 'a command handed on',
                            len(self.robot.lines))
        self.node.wait_for(lambda line: line['level'] == CollisionWarning.CLEAR, 'CLEAR',
                           len(self.node.lines))

    def test_link_that_swallows_everything(self):
        self.check(self.cable.swallow, self.cable.stop_swallowing)

    def test_link_that_is_pulled(self):
        self.check(self.cable.pull, self.cable.plug)

    def check(self, cut, restore):
        for _ in range(3):
            before = len(self.node.lines)
            cut()
            start = time.time()
            lost = self.node.wait_for(says_stale, 'UNKNOWN beside the predictor', before)
            self.assertLess(lost['seen'] - start, UNKNOWN_WITHIN)
            self.robot.wait_for(lambda _: time.time() > start + CUT_FOR, 'the end of the cut',
                                len(self.robot.lines))
            end = time.time()
            restore()
            self.wait_going()
            self.check_between(start, end)

    def check_between(self, start, end):
        went = [line for line in self.robot.lines
                if line['going'] and start + SAFE_WITHIN < line['sent'] < end]
        self.assertFalse(went, 'commands were handed on while the link was cut at %f' % start)
        known = [line for line in self.node.lines if line['level'] != CollisionWarning.UNKNOWN and
                 start + UNKNOWN_WITHIN < line['seen'] < end]
        self.assertFalse(known, 'the link was cut at %f' % start)


if __name__ == '__main__':
    run('two_machines', TwoMachines)
