#!/usr/bin/env python3
"""second_tracker.py TOPIC RATE: publishes empty obstacles so often [Hz], or with 0 only says that it
would, until its input ends. (A signal may catch rospy holding the lock that it needs to end.)"""
import sys
import threading
import time

import rospy
from footprint_collision_predictor.msg import ObstacleArray


def end_with_input():
    sys.stdin.read()
    rospy.signal_shutdown('the input has ended')


def main():
    topic, rate = sys.argv[1], float(sys.argv[2])
    rospy.init_node('second_tracker')
    publisher = rospy.Publisher(topic, ObstacleArray, queue_size=1)
    threading.Thread(target=end_with_input).start()
    while rate and not rospy.is_shutdown():
        message = ObstacleArray()
        message.header.stamp, message.header.frame_id = rospy.Time.now(), 'base_link'
        publisher.publish(message)
        time.sleep(1 / rate)
    rospy.spin()


if __name__ == '__main__':
    main()
