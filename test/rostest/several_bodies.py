"""A robot with a trailer, and what its bodies are sent."""
import math

import rospy
from node_testing import BOX, transform

BASE = {'name': 'base', 'frame_id': 'base_link', 'polygon': BOX}
TRAILER = {'name': 'trailer', 'frame_id': 'trailer', 'polygon': BOX}
# The longest period, since what takes longer on a busy machine is UNKNOWN.
PATIENT_ROBOT = {'footprints': [BASE, TRAILER], 'max_data_age': 30.0, 'transform_tolerance': 20.0,
                 'clear_after': 1, 'heartbeat_rate': 10.0}
INTERVAL = rospy.Duration(0.1)  # of the transforms that a motion is taken from


def without(body, *keys, **others):
    """A body with some keys left out and others added."""
    return dict({key: value for key, value in body.items() if key not in keys}, **others)


def turned(parent, child, x, y, yaw, stamp):
    return transform(parent, child, x, y, math.sin(yaw / 2), math.cos(yaw / 2), stamp)


def straight(child, x, y, speed, stamp, parent='odom'):
    """On its way along the x axis, at (x, y) at the stamp."""
    return (turned(parent, child, x - 0.1 * speed, y, 0, stamp - INTERVAL),
            turned(parent, child, x, y, 0, stamp))


def arc(child, x, y, rate, stamp, parent='odom'):
    """On its way to the left round (x, y + 1 / rate) at 1 m/s, at (x, y) at the stamp."""
    angle, radius = 0.1 * rate, 1 / rate
    return (turned(parent, child, x - radius * math.sin(angle),
                   y + radius * (1 - math.cos(angle)), -angle, stamp - INTERVAL),
            turned(parent, child, x, y, 0, stamp))


def of(footprint, recorder, stamp=None, since=0):
    """The first message about that footprint, and of that stamp."""
    return recorder.wait_for(
        lambda m: m.footprint == footprint and stamp in (None, m.header.stamp),
        '%s at %s' % (footprint, stamp), since)
