#!/usr/bin/env python3
"""second_tracker.py TOPIC RATE: publishes empty obstacles so often [Hz], or with 0 only says that it
would, until its input ends. (A signal may catch rospy holding the lock that it needs to end.)"""
import sys
import threading

import rospy
from footprint_collision_predictor.msg import ObstacleArray


def main():
    topic, rate = sys.argv[1], float(sys.argv[2])
    rospy.init_node('second_tracker')
    publisher = rospy.Publisher(topic, ObstacleArray, queue_size=1)
    ended = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.read(), ended.set())).start()
    while not ended.wait(1 / rate if rate else None):
        message = ObstacleArray()
        message.header.stamp, message.header.frame_id = rospy.Time.now(), 'base_link'
        publisher.publish(message)
    rospy.signal_shutdown('the input has ended')


if __name__ == '__main__':
    main()
