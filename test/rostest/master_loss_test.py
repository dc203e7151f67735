#!/usr/bin/env python3
"""The master is killed: warnings go on, and the diagnostics say so.

The master is one of this test's own. A second process, its far side, feeds the node that lives
there, and prints a line of JSON for all that it hears.
"""
import json
import os
import queue
import signal
import socket
import subprocess
import sys
import threading
import time

import rosgraph
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from footprint_collision_predictor.msg import CollisionWarning, ObstacleArray
from node_testing import NODE, PACKAGE, TIMEOUT, wait_until
from roslib.packages import find_node
from ros_test_case import RosTestCase, run


def far_side():
    rospy.init_node('far_side', disable_signals=True)

    def tell(**heard):
        print(json.dumps(heard) + '\n', end='', flush=True)  # at once: others print, too

    def hear_diagnostics(message):
        for status in message.status:
            if status.name.endswith(': master'):
                tell(master=status.level, message=status.message)

    rospy.Subscriber('/collision_warning', CollisionWarning,
                     lambda w: tell(level=w.level, sequence=w.sequence))
    rospy.Subscriber('/diagnostics', DiagnosticArray, hear_diagnostics)
    obstacles = rospy.Publisher('/obstacles', ObstacleArray, queue_size=1)
    tell(ready=True)
    while True:
        message = ObstacleArray()
        message.header.frame_id, message.header.stamp = 'base_link', rospy.Time.now()
        obstacles.publish(message)
        time.sleep(0.05)


class MasterLoss(RosTestCase):
    def setUp(self):
        with socket.socket() as free:
            free.bind(('', 0))
            port = free.getsockname()[1]
        self.environment = dict(os.environ, ROS_MASTER_URI='http://localhost:%d' % port)
        self.master = self.start('rosmaster', '--core', '-p', str(port))
        master = rosgraph.Master(rospy.get_name(), self.environment['ROS_MASTER_URI'])
        wait_until(master.is_online, 'the master')
        self.lines = queue.Queue()
        far = self.start(sys.executable, __file__, '--far-side', stdout=subprocess.PIPE, text=True)
        reader = threading.Thread(target=lambda: [self.lines.put(line) for line in far.stdout])
        reader.start()
        self.addCleanup(reader.join)
        self.addCleanup(far.kill)
        self.wait_for(lambda h: 'ready' in h, 'the far side, before it can miss the node')
        self.node = self.start(
            find_node(PACKAGE, NODE)[0], '_footprint:=[[1, 1], [-1, 1], [-1, -1], [1, -1]]',
            '_ego_motion:=static', '_diagnostic_period:=0.1', '_max_data_age:=5.0')

    def start(self, *command, **options):
        process = subprocess.Popen(command, env=self.environment, **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, condition, what):
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            heard = json.loads(self.lines.get(timeout=TIMEOUT))
            if condition(heard):
                return heard
        raise AssertionError('in vain for ' + what)

    def test_Fault28_the_master_is_killed(self):
        self.wait_for(lambda h: h.get('level') == 1, 'CLEAR')
        self.wait_for(lambda h: h.get('master') == 0, 'a master that answers')
        self.master.send_signal(signal.SIGKILL)
        self.master.wait()
        said = self.wait_for(lambda h: h.get('master') == 2, 'the diagnostics to say so')
        self.assertIn('master', said['message'])
        first = self.wait_for(lambda h: 'sequence' in h, 'a warning')
        last = self.wait_for(lambda h: h.get('sequence', 0) >= first['sequence'] + 100,
                             'a hundred more')
        self.assertEqual(last['level'], 1)
        self.assertIsNone(self.node.poll())


if __name__ == '__main__':
    if '--far-side' in sys.argv:
        far_side()
    run('master_loss', MasterLoss)
