#!/usr/bin/env python3
"""A robot behind the shipped watchdog (cmd_vel_guard) stops when the predictor is stopped or killed.

Each command carries the moment at which it was sent, so that what the guard hands on can be judged
without regard to how late it is seen here.
"""
import os
import signal
import subprocess
import time

import geometry_msgs.msg
import rospy
from footprint_collision_predictor.msg import CollisionWarning
from node_testing import BOX, PACKAGE, TIMEOUT, Publisher, Recorder, circle
from roslib.packages import find_node
from ros_test_case import RosTestCase, run

SAFE_WITHIN = 0.3  # [s] of the promise
STOP = geometry_msgs.msg.Twist()
RESTARTS = int(os.environ.get('WATCHDOG_RESTARTS', 100))
STOPPED_FOR = 3.0  # [s]
NOTHING = []
AHEAD = [circle(7, (2.5, 0), (-1, 0))]  # contact in 1 s
TOUCHING = [circle(8, (1.2, 0))]


def is_command(twist):
    return twist.linear.x == 1


class Guarded:
    """A predictor, a guard, and commands that it hands on or not."""

    def __init__(self, case):
        self.node = case.rig(footprint=BOX, ego_motion='static')
        self.seen = NOTHING
        case.feed(lambda stamp: self.node.send(self.seen, stamp=stamp))
        guard = subprocess.Popen([find_node(PACKAGE, 'cmd_vel_guard')[0],
                                  '__ns:=' + self.node.namespace])
        case.addCleanup(guard.wait, TIMEOUT)
        case.addCleanup(guard.send_signal, signal.SIGINT)
        self.output = Recorder(self.node.topic('cmd_vel'), geometry_msgs.msg.Twist)
        case.addCleanup(self.output.close)
        self._commands = Publisher(self.node.topic('cmd_vel_in'), geometry_msgs.msg.Twist)
        case.addCleanup(self._commands.close)
        case.feed(self._command)

    def _command(self, stamp):
        twist = geometry_msgs.msg.Twist()
        twist.linear.x = 1
        twist.linear.z = time.monotonic()
        twist.linear.y, twist.angular.x, twist.angular.y, twist.angular.z = -0.2, 0.3, 0.4, -0.5
        self._commands.publish(twist)
        return stamp

    def wait_going(self, since=0):
        return self.output.wait_for(is_command, 'a command handed on', since)

    def wait_stopping(self, until):
        """A stop is commanded after this steady time [s]."""
        output = self.output
        output.wait_for(lambda t: t == STOP and time.monotonic() > until, 'a stop', output.mark())

    def handed_on(self, after, before):
        """Commands sent between two steady times [s] that reached the robot."""
        return [t for t in self.output.messages if is_command(t) and after < t.linear.z < before]


class Watchdog(RosTestCase):
    def test_hands_commands_on_while_safe_and_stops_otherwise(self):
        robot = Guarded(self)
        twist = robot.wait_going()
        self.assertEqual((twist.linear.y, twist.angular.x, twist.angular.y, twist.angular.z),
                         (-0.2, 0.3, 0.4, -0.5))
        before = robot.output.messages[:robot.output.messages.index(twist)]
        self.assertIn(STOP, before, 'before anything is known it must stop')
        robot.seen = AHEAD
        critical = robot.node.warnings.wait_for(lambda w: w.level == w.CRITICAL, 'CRITICAL')
        robot.wait_stopping(time.monotonic())
        mark = robot.output.mark()
        stopped = time.monotonic()
        robot.wait_stopping(stopped + 0.3)
        self.assertFalse([t for t in robot.output.messages[mark:] if t != STOP], critical)
        robot.seen = NOTHING
        robot.wait_going(since=robot.output.mark())

    def test_Fault31_stopped_while_clear(self):
        self.check_stopped(NOTHING, CollisionWarning.CLEAR, TOUCHING, CollisionWarning.CRITICAL)

    def test_Fault31_stopped_while_critical(self):
        self.check_stopped(TOUCHING, CollisionWarning.CRITICAL, NOTHING, CollisionWarning.CLEAR)

    def check_stopped(self, before, level_before, after, level_after):
        """While the process is stopped, the world changes: the old world must not be told again.

        What it had handed to its sockets' thread before the stop may still go out, with its old
        stamp; the watchdog must not take that for the present.
        """
        robot = Guarded(self)
        node = robot.node
        self.addCleanup(node.process.send_signal, signal.SIGCONT)
        for _ in range(3):
            robot.seen = before
            node.warnings.wait_for(lambda w: w.level == level_before, 'the level before',
                                   node.warnings.mark())
            if level_before == CollisionWarning.CLEAR:
                robot.wait_going(since=robot.output.mark())
            node.process.send_signal(signal.SIGSTOP)
            stopped, stop_stamp = time.monotonic(), rospy.Time.now()
            robot.seen = after
            robot.wait_stopping(until=stopped + STOPPED_FOR)
            mark = node.warnings.mark()
            end = time.monotonic()
            node.process.send_signal(signal.SIGCONT)
            node.warnings.wait_for(lambda w: w.level == level_after, 'the level after', mark)
            told = [w for w in node.warnings.messages[mark:]
                    if w.level == level_before and w.header.stamp > stop_stamp]
            self.assertFalse(told, 'told as of after the stop, but no longer so')
            if level_after == CollisionWarning.CRITICAL:
                robot.wait_stopping(until=time.monotonic())
                end = time.monotonic()
            self.assertFalse(robot.handed_on(stopped + SAFE_WITHIN, end))

    def test_Fault32_killed_and_respawned(self):
        robot = Guarded(self)
        sessions = set()
        for i in range(RESTARTS):
            robot.wait_going(since=robot.output.mark())
            session = robot.node.next_warning().session
            self.assertNotIn(session, sessions)
            sessions.add(session)
            robot.node.process.kill()
            killed = time.monotonic()
            robot.node.process.wait()
            robot.wait_stopping(until=killed + SAFE_WITHIN + 0.1)
            respawned = time.monotonic()
            self.assertFalse(robot.handed_on(killed + SAFE_WITHIN, respawned), 'restart %d' % i)
            robot.node.restart()


if __name__ == '__main__':
    run('watchdog', Watchdog)
