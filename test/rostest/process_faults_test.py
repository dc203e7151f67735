#!/usr/bin/env python3
"""What the system round the node can do to it: garbage, stops, load, deaf consumers, full disks."""
import math
import os
import signal
import socket
import struct
import subprocess
import time
import xmlrpc.client
from urllib.parse import urlparse

import rosgraph
import rospy
from feed import Feed
from footprint_collision_predictor.msg import CollisionPrediction, CollisionWarning
from node_testing import BOX, NODE, PACKAGE, Rig, circle
from raw_messages import resident_memory
from roslib.packages import find_node
from ros_test_case import RosTestCase, run

MAX_AGE = 0.5
STANDING = {'footprint': BOX, 'ego_motion': 'static', 'max_data_age': MAX_AGE}
GARBAGE = (b'\0' * 1000, b'\xff' * 1000, b'\xff\xff\xff\x7f', b'GET / HTTP/1.0\r\n\r\n',
           b'POST /RPC2 HTTP/1.1\r\nContent-Length: 999999999\r\n\r\n<methodCall>',
           b'POST /RPC2 HTTP/1.1\r\nContent-Length: -5\r\n\r\n', struct.pack('<I', 900000000),
           struct.pack('<II', 8, 700000000), bytes(range(256)) * 40)


class FullDiskRig(Rig):
    """Its log and its output go where nothing fits any more."""

    def _start(self):
        with open('/dev/full', 'w') as full:
            return subprocess.Popen(
                [find_node(PACKAGE, NODE)[0], '__ns:=' + self.namespace, '__name:=' + NODE,
                 '__log:=/dev/full'], stdout=full, stderr=full)


class ClosedOutputRig(Rig):
    """Nobody reads its output any more."""

    def _start(self):
        reader, writer = os.pipe()
        os.close(reader)
        try:
            return subprocess.Popen([find_node(PACKAGE, NODE)[0], '__ns:=' + self.namespace,
                                     '__name:=' + NODE], stdout=writer, stderr=writer)
        finally:
            os.close(writer)


class ProcessFaults(RosTestCase):
    def fed(self, rig_class=Rig, **parameters):
        """A node that is CLEAR, with obstacles coming."""
        rig = rig_class(**dict(STANDING, **parameters))
        self.addCleanup(rig.close)
        feed = Feed(rig.send)
        self.addCleanup(feed.stop)
        rig.warnings.wait_for(lambda w: w.level == w.CLEAR, 'CLEAR')
        return rig

    def ports(self, node):
        """Of the node's XMLRPC server, and of its TCPROS server."""
        name = node.topic(NODE)
        uri = rosgraph.Master(rospy.get_name()).lookupNode(name)
        _, _, (_, host, port) = xmlrpc.client.ServerProxy(uri).requestTopic(
            rospy.get_name(), node.topic('collision_warning'), [['TCPROS']])
        xmlrpc_address = urlparse(uri)
        return (xmlrpc_address.hostname, xmlrpc_address.port), (host, port)

    def check_beating(self, node, mark, longest):
        """By the sequence and by the clock with which the node stamps what it repeats."""
        messages = node.warnings.messages[mark:]
        self.assertGreater(len(messages), 20)
        numbers = [w.sequence for w in messages]
        self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))))
        times = sorted(w.header.stamp.to_sec() for w in messages)
        gaps = [later - earlier for earlier, later in zip(times, times[1:])]
        self.assertLess(max(gaps), longest)
        self.assertTrue(node.is_alive())

    def wait_beats(self, node, count):
        mark = node.warnings.mark()
        first = node.next_warning()
        node.warnings.wait_for(lambda w: w.sequence >= first.sequence + count, since=mark)

    def test_Fault29_garbage_and_idle_connections_on_its_ports(self):
        node = self.fed()
        addresses = self.ports(node)
        mark = node.warnings.mark()
        connections = [socket.create_connection(addresses[i % 2], timeout=10)
                       for i in range(200)]
        for address in addresses:
            for garbage in GARBAGE:
                with socket.create_connection(address, timeout=10) as connection:
                    connection.sendall(garbage)
        self.wait_beats(node, 40)
        for connection in connections:
            connection.close()
        self.wait_beats(node, 40)
        self.check_beating(node, mark, 0.15)
        self.ports(node)  # it still answers

    def test_Fault31_stopped_for_three_seconds(self):
        """After it, a level is known only from messages that are fresh."""
        node = self.fed()
        before = node.next_warning()
        node.process.send_signal(signal.SIGSTOP)
        os.waitpid(node.process.pid, os.WUNTRACED)
        time.sleep(3)  # the fault itself
        mark = node.warnings.mark()
        continued = rospy.Time.now()
        node.process.send_signal(signal.SIGCONT)
        unknown = node.warnings.wait_for(
            lambda w: w.sequence > before.sequence and w.level == w.UNKNOWN, 'UNKNOWN', mark)
        self.assertUnknown(unknown, 0)
        node.warnings.wait_for(lambda w: w.level == w.CLEAR and w.header.stamp > continued,
                               'fresh data', mark)
        oldest = continued - rospy.Duration.from_sec(MAX_AGE)
        for warning in node.warnings.messages[mark:]:
            if warning.level != warning.UNKNOWN:
                self.assertGreater(warning.header.stamp, oldest)
                self.assertLessEqual(warning.data_age, MAX_AGE)

    def deaf(self, address, node, topic, message_class):
        """Subscribes by hand, and never reads."""
        connection = socket.socket()
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.connect(address)
        fields = [b'callerid=/deaf', b'topic=' + node.topic(topic).encode(),
                  b'type=' + message_class._type.encode(),
                  b'md5sum=' + message_class._md5sum.encode()]
        header = b''.join(struct.pack('<I', len(field)) + field for field in fields)
        connection.sendall(struct.pack('<I', len(header)) + header)
        self.addCleanup(connection.close)

    def test_Fault33_consumers_that_do_not_read(self):
        """A prediction of 500 segments has 60 kB: the deaf one misses far more than sockets hold."""
        polygon = [[math.cos(2 * math.pi * i / 500), math.sin(2 * math.pi * i / 500)]
                   for i in range(500)]
        node = self.fed(footprint=polygon)
        node.predictions.close()
        _, address = self.ports(node)
        self.wait_beats(node, 100)
        memory = resident_memory(node.process)
        for topic, kind in (('collision_warning', CollisionWarning),
                            ('collision_prediction', CollisionPrediction)):
            self.deaf(address, node, topic, kind)
        mark = node.warnings.mark()
        self.wait_beats(node, 1000)
        self.check_beating(node, mark, 0.15)
        self.assertLess(resident_memory(node.process) - memory, 15e6)

    def test_Fault34_busy_machine(self):
        node = self.fed()
        loops = [subprocess.Popen(['sh', '-c', 'while :; do :; done'])
                 for _ in range(8 * os.cpu_count())]
        try:
            mark = node.warnings.mark()
            self.wait_beats(node, 200)
        finally:
            for loop in loops:
                loop.kill()
                loop.wait()
        self.check_beating(node, mark, 0.25)

    def test_Fault38_log_and_disk_full(self):
        for rig_class in FullDiskRig, ClosedOutputRig:
            with self.subTest(rig_class.__name__):
                node = self.fed(rig_class)
                mark = node.warnings.mark()
                for obstacle in circle(7, (0, 0)), circle(8, (float('nan'), 0)):
                    node.warning_at(node.send([obstacle]))  # each is worth a line
                self.wait_beats(node, 20)
                self.check_beating(node, mark, 0.15)


if __name__ == '__main__':
    run('process_faults', ProcessFaults)
