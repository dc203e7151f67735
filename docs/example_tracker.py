#!/usr/bin/env python3
"""The least that a tracker must do: who is where, how fast, how large, in which frame, and when."""
import rospy
from footprint_collision_predictor.msg import Obstacle, ObstacleArray


def person(seconds):
    """Walks towards the sensor at 1 m/s, again and again; contact when 0.8 m away."""
    obstacle = Obstacle()
    obstacle.id = 1  # the same for the same person, from message to message
    obstacle.radius = 0.3  # [m]
    obstacle.position.x = 4.8 - seconds % 4  # [m] in header.frame_id
    obstacle.velocity.x = -1.0  # [m/s] over ground
    return obstacle


rospy.init_node('example_tracker')
publisher = rospy.Publisher('obstacles', ObstacleArray, queue_size=1)
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    message = ObstacleArray()
    message.header.stamp = rospy.Time.now()  # when it was measured, not when it is sent
    message.header.frame_id = 'base_link'
    message.obstacles.append(person(message.header.stamp.to_sec()))
    publisher.publish(message)  # also when nobody is there: an empty list says so, silence does not
    rate.sleep()
