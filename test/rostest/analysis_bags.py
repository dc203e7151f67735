"""Recordings for the tests of analyze_bag, written message by message, and how it is run on them."""
import json
import math
import os
import subprocess

import genpy
import geometry_msgs.msg
import nav_msgs.msg
import rosbag
import rospy
import tf2_msgs.msg
from footprint_collision_predictor.msg import Obstacle, ObstacleArray
from roslib.packages import find_node

PACKAGE = 'footprint_collision_predictor'
SQUARE = '[[0.5, 0.5], [-0.5, 0.5], [-0.5, -0.5], [0.5, -0.5]]'  # front: segment 3
STATIC = ('--footprint-polygon', SQUARE, '--ego-motion', 'static')
START = 1000  # [s] of every bag


def command(*arguments):
    return [find_node(PACKAGE, 'analyze_bag')[0], *arguments]


def analyze(*arguments, **options):
    """Runs it to its end; stdout, stderr and returncode are in the result."""
    return subprocess.run(command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, errors='replace', timeout=120, **options)


def obstacles(t, circles=(), frame='base_link'):
    """An ObstacleArray at START + t; circles are (id, x, y, vx, vy, radius)."""
    message = ObstacleArray()
    message.header.stamp = stamp(t)
    message.header.frame_id = frame
    for identity, x, y, vx, vy, radius in circles:
        obstacle = Obstacle(id=identity, radius=radius)
        obstacle.position.x, obstacle.position.y = x, y
        obstacle.velocity.x, obstacle.velocity.y = vx, vy
        message.obstacles.append(obstacle)
    return message


def odometry(t, speed):
    message = nav_msgs.msg.Odometry(child_frame_id='base_link')
    message.header.stamp = stamp(t)
    message.header.frame_id = 'odom'
    message.twist.twist.linear.x = speed
    return message


def footprint(t, vertices, frame='base_link'):
    message = geometry_msgs.msg.PolygonStamped()
    message.header.stamp = stamp(t)
    message.header.frame_id = frame
    message.polygon.points = [geometry_msgs.msg.Point32(x, y, 0) for x, y in vertices]
    return message


def transforms(t, parent='odom', child='base_link', x=0.0):
    message = geometry_msgs.msg.TransformStamped(child_frame_id=child)
    message.header.stamp = stamp(t)
    message.header.frame_id = parent
    message.transform.translation.x = x
    message.transform.rotation.w = 1
    return tf2_msgs.msg.TFMessage([message])


def stamp(t):
    return rospy.Time(START) + rospy.Duration(0, int(round(t * 1e9)))


def write(path, messages, compression='none', latched=()):
    """Messages are (topic, time, message); topics of `latched` are marked so."""
    with rosbag.Bag(path, 'w', compression=compression) as bag:
        for topic, t, message in messages:
            header = {'topic': topic, 'type': message._type, 'md5sum': message._md5sum,
                      'message_definition': message._full_text, 'latching': '1'}
            bag.write(topic, message, stamp(t), connection_header=header if topic in latched else None)
    return path


def approach(seconds=3.0, rate=10, speed=1.0, distance=5.0):
    """A circle of 0.5 m radius that comes straight to the front, 0.5 m ahead of the origin, from
    `distance` before it: contact at distance / speed."""
    count = int(round(seconds * rate))
    for i in range(count + 1):
        t = i / rate
        x = 1.0 + distance - speed * t
        yield '/obstacles', t, obstacles(t, [(7, x, 0, -speed, 0, 0.5)])


def frames(folder):
    """The rows of frames.csv, numbers as numbers."""
    return _rows(os.path.join(folder, 'frames.csv'))


def events(folder):
    return _rows(os.path.join(folder, 'events.csv'))


def summary(folder):
    with open(os.path.join(folder, 'summary.json')) as file:
        return json.load(file, parse_constant=_refuse)


def _refuse(constant):
    raise AssertionError('%s is not JSON' % constant)


def _rows(path):
    with open(path) as file:
        lines = file.read().splitlines()
    names = lines[0].split(',')
    rows = []
    for line in lines[1:]:
        fields = line.split(',')
        if len(fields) != len(names):
            raise AssertionError('%d fields under %d names: %s' % (len(fields), len(names), line))
        rows.append({name: _value(field) for name, field in zip(names, fields)})
    return rows


def _value(field):
    try:
        return float(field)
    except ValueError:
        return field


def stamp_of(row):
    """Exactly, which a float cannot."""
    return genpy.Time.from_sec(row['time'])


def same(a, b):
    return a == b or (math.isnan(a) and math.isnan(b))
