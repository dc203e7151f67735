#!/usr/bin/env python3
"""The footprint as a string, as a list (both from the launch file), and from a topic."""
import geometry_msgs.msg
import rospy
from footprint_collision_predictor.msg import CollisionWarning
from node_testing import BOX, PATIENT, circle, transform
from ros_test_case import RosTestCase, run

# base_link in odom: at (10, 20), its x axis along (0.6, 0.8).
BASE = transform('odom', 'base_link', 10, 20, qz=0.2 ** 0.5, qw=0.8 ** 0.5)


def in_odom(x, y):
    return 10 + 0.6 * x - 0.8 * y, 20 + 0.8 * x + 0.6 * y


class FootprintSources(RosTestCase):
    def check(self, node, tolerance=1e-9):
        """The box is touched in front after 1.5 s, and the prediction shows it vertex by vertex."""
        stamp = node.send([circle(7, (3, 0), (-1, 0))])
        warning, prediction = node.warning_at(stamp), node.prediction_at(stamp)
        self.assertAlmostEqual(warning.time_to_collision, 1.5, delta=tolerance)
        self.assertEqual((warning.segment, warning.obstacle_id), (3, 7))
        self.assertPoint(warning.contact_point, 1, 0, tolerance)
        self.assertAlmostEqual(prediction.area, 2, delta=10 * tolerance)
        self.assertPoint(prediction.centroid, 0, 0, tolerance)
        self.assertEqual(len(prediction.segments), 4)
        for i, segment in enumerate(prediction.segments):
            self.assertPoint(segment.start, *BOX[i], tolerance=tolerance)
            self.assertPoint(segment.end, *BOX[(i + 1) % 4], tolerance=tolerance)

    def test_Fault42_string(self):
        text = rospy.get_param('/as_string')
        self.assertIsInstance(text, str)
        self.check(self.rig(**dict(PATIENT, footprint=text)))

    def test_Fault42_list(self):
        vertices = rospy.get_param('/as_list')
        self.assertIsInstance(vertices, list)
        self.check(self.rig(**dict(PATIENT, footprint=vertices)))

    def test_Fault42_list_of_whole_numbers(self):
        node = self.rig(**dict(PATIENT, footprint=[[1, 1], [-1, 1], [-1, -1], [1, -1]]))
        warning = node.warning_at(node.send([circle(7, (3, 0), (-1, 0))]))
        self.assertAlmostEqual(warning.time_to_collision, 1.5, delta=1e-9)

    def test_topic_in_the_fixed_frame(self):
        """As costmap_2d publishes it: in the global frame, and in single precision."""
        node = self.rig(ego_motion='static', max_data_age=30.0, transform_tolerance=25.0)
        self.assertUnknown(node.next_warning(), CollisionWarning.REASON_FOOTPRINT_MISSING)
        topic = node.publisher('footprint', geometry_msgs.msg.PolygonStamped)
        message = geometry_msgs.msg.PolygonStamped()
        message.header.frame_id, message.header.stamp = 'odom', rospy.Time.now()
        message.polygon.points = [geometry_msgs.msg.Point32(*in_odom(x, y), 0) for x, y in BOX]
        node.send_static_transforms(BASE)
        topic.publish(message)
        node.warnings.wait_for(lambda w: not w.reason & CollisionWarning.REASON_FOOTPRINT_MISSING,
                               'the footprint to be taken', since=node.warnings.mark())
        self.check(node, tolerance=5e-6)  # coordinates near 20 m have single precision 2e-6 m


if __name__ == '__main__':
    run('footprint_sources', FootprintSources)
