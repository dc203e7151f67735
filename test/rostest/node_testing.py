"""A predictor_node in a namespace of its own, the sensors round it, and a record of its answers.

Nothing here sleeps for a guessed time: every wait ends with the event it waits for.
"""
import itertools
import signal
import subprocess
import threading
import time

import geometry_msgs.msg
import nav_msgs.msg
import rospy
import tf2_msgs.msg
from footprint_collision_predictor.msg import (CollisionPrediction, CollisionWarning, Obstacle,
                                               ObstacleArray)
from roslib.packages import find_node

PACKAGE = 'footprint_collision_predictor'
NODE = 'predictor_node'
TIMEOUT = 30.0  # [s] for what should take milliseconds, on a machine that is busy with other things
UNKNOWN_REASONS = (1 << 24) - 1

# 2 m x 1 m. Segments: 0 is the left side (y = 0.5), 1 the rear, 2 the right side, 3 the front.
BOX = [[1.0, 0.5], [-1.0, 0.5], [-1.0, -0.5], [1.0, -0.5]]

# For tests that are not about age: a busy machine must not make their data stale.
PATIENT = {'footprint': BOX, 'ego_motion': 'static', 'max_data_age': 30.0}


def circle(identity, position, velocity=(0, 0), radius=0.5, acceleration=(0, 0)):
    obstacle = Obstacle(id=identity, radius=radius)
    obstacle.position.x, obstacle.position.y = position
    obstacle.velocity.x, obstacle.velocity.y = velocity
    obstacle.acceleration.x, obstacle.acceleration.y = acceleration
    return obstacle


def outline(identity, vertices, velocity=(0, 0), radius=0):
    """Told from its first vertex."""
    obstacle = circle(identity, vertices[0], velocity, radius)
    obstacle.outline = [geometry_msgs.msg.Point(x - vertices[0][0], y - vertices[0][1], 0)
                        for x, y in vertices]
    return obstacle


def transform(parent, child, x, y, qz=0.0, qw=1.0, stamp=rospy.Time()):
    message = geometry_msgs.msg.TransformStamped()
    message.header.frame_id, message.header.stamp = parent, stamp
    message.child_frame_id = child
    message.transform.translation.x, message.transform.translation.y = x, y
    message.transform.rotation.z, message.transform.rotation.w = qz, qw
    return message


def wait_until(condition, what, timeout=TIMEOUT):
    """For conditions that no callback announces, such as connections."""
    end = time.monotonic() + timeout
    while not condition():
        if time.monotonic() > end:
            raise AssertionError('waited %g s in vain for %s' % (timeout, what))
        time.sleep(0.005)


class Recorder:
    """The messages of a topic in the order of their arrival."""

    def __init__(self, topic, message_class):
        self.messages = []
        self.arrivals = []  # steady time [s] of each
        self._condition = threading.Condition()
        self._topic = topic
        self._subscriber = rospy.Subscriber(topic, message_class, self._add, tcp_nodelay=True)

    def _add(self, message):
        with self._condition:
            self.messages.append(message)
            self.arrivals.append(time.monotonic())
            self._condition.notify_all()

    def mark(self):
        """For `since`: only what comes from now on."""
        return len(self.messages)

    def wait_for(self, predicate, what='a message', since=0, timeout=TIMEOUT):
        """The first message from `since` on for which the predicate holds."""
        end = time.monotonic() + timeout
        with self._condition:
            for i in itertools.count(since):
                while i == len(self.messages):
                    if not self._condition.wait(end - time.monotonic()):
                        last = self.messages[-1] if self.messages else 'nothing came'
                        raise AssertionError('waited %g s in vain for %s on %s; the last:\n%s' %
                                             (timeout, what, self._topic, last))
                if predicate(self.messages[i]):
                    return self.messages[i]

    def wait_connected(self, publishers=1):
        wait_until(lambda: self._subscriber.get_num_connections() >= publishers,
                   '%d publishers of %s' % (publishers, self._topic))

    def close(self):
        self._subscriber.unregister()


class Publisher:
    """Connected from the start, so that nothing published is lost."""

    def __init__(self, topic, message_class, connections=1, **options):
        self._publisher = rospy.Publisher(topic, message_class, queue_size=1000, tcp_nodelay=True,
                                          **options)
        wait_until(lambda: self._publisher.get_num_connections() >= connections,
                   'a subscriber of ' + topic)
        self.publish = self._publisher.publish
        self.close = self._publisher.unregister


class Rig:
    """A running node with the given private parameters, and its surroundings.

    obstacles_class None: somebody else publishes the obstacles.
    """

    _numbers = itertools.count(1)

    def __init__(self, obstacles_class=ObstacleArray, **parameters):
        self.namespace = '/rig_%d' % next(Rig._numbers)
        self._open = []
        self._publishers = {}
        for name, value in parameters.items():
            rospy.set_param('/'.join((self.namespace, NODE, name)), value)
        try:
            self._listen()
            self.start()
            self._connect(obstacles_class)
        except BaseException:
            self.close()
            raise

    def start(self):
        """Also again, after the process has ended: as a respawned node starts."""
        self.process = self._start()

    def _start(self):
        """The process that the node lives in."""
        return self.run(find_node(PACKAGE, NODE)[0], name=NODE)

    def run(self, *command, name):
        return subprocess.Popen([*command, '__ns:=' + self.namespace, '__name:=' + name])

    def _listen(self):
        """Before the node starts: rospy may take the master's answer to a subscription, which lacks
        a publisher that comes just then, for newer than the news of that publisher."""
        self.warnings = self._kept(Recorder(self.topic('collision_warning'), CollisionWarning))
        self.predictions = self._kept(
            Recorder(self.topic('collision_prediction'), CollisionPrediction))

    def _connect(self, obstacles_class):
        self.predictions.wait_connected()
        self.warnings.wait_for(lambda w: True, 'the first heartbeat')
        if obstacles_class:
            self.obstacles = self.publisher('obstacles', obstacles_class)

    def topic(self, name):
        return name if name.startswith('/') else self.namespace + '/' + name

    def _kept(self, closable):
        self._open.append(closable)
        return closable

    def publisher(self, topic, message_class, **options):
        return self._kept(Publisher(self.topic(topic), message_class, **options))

    def send(self, obstacles=(), frame='base_link', stamp=None):
        """Publishes an ObstacleArray; returns its stamp."""
        message = ObstacleArray(obstacles=list(obstacles))
        message.header.frame_id = frame
        message.header.stamp = rospy.Time.now() if stamp is None else stamp
        self.obstacles.publish(message)
        return message.header.stamp

    def send_odometry(self, linear=(0, 0), angular=0, stamp=None, child='base_link'):
        message = nav_msgs.msg.Odometry(child_frame_id=child)
        message.header.frame_id = 'odom'
        message.header.stamp = rospy.Time.now() if stamp is None else stamp
        message.twist.twist.linear.x, message.twist.twist.linear.y = linear
        message.twist.twist.angular.z = angular
        self._cached('odom', nav_msgs.msg.Odometry).publish(message)
        return message.header.stamp

    def send_transforms(self, *transforms):
        self._cached('/tf', tf2_msgs.msg.TFMessage).publish(list(transforms))

    def send_static_transforms(self, *transforms):
        self._cached('/tf_static', tf2_msgs.msg.TFMessage).publish(list(transforms))

    def _cached(self, topic, message_class):
        if topic not in self._publishers:
            self._publishers[topic] = self.publisher(topic, message_class)
        return self._publishers[topic]

    def warning_at(self, stamp):
        return self.warnings.wait_for(lambda w: w.header.stamp == stamp, 'stamp %s' % stamp)

    def prediction_at(self, stamp):
        return self.predictions.wait_for(lambda p: p.header.stamp == stamp, 'stamp %s' % stamp)

    def warning_with(self, reason, since=0):
        return self.warnings.wait_for(lambda w: w.reason & reason, 'reason %d' % reason, since)

    def next_warning(self):
        return self.warnings.wait_for(lambda w: True, since=self.warnings.mark())

    def is_alive(self):
        return self.process.poll() is None

    def close(self):
        for closable in self._open:
            closable.close()
        if self.is_alive():
            self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(TIMEOUT)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
