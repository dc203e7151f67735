#!/usr/bin/env python3
"""A message that is no footprint is refused whole, by name, and the last good one is kept."""
import geometry_msgs.msg
import rospy
from footprint_collision_predictor.msg import CollisionWarning
from node_testing import BOX, circle
from ros_test_case import RosTestCase, run

NAN = float('nan')


class FootprintRefused(RosTestCase):
    def setUp(self):
        self.node = self.rig(ego_motion='static', max_data_age=30.0)
        self.topic = self.node.publisher('footprint', geometry_msgs.msg.PolygonStamped)

    def send(self, vertices, frame='base_link'):
        message = geometry_msgs.msg.PolygonStamped()
        message.header.frame_id, message.header.stamp = frame, rospy.Time.now()
        message.polygon.points = [geometry_msgs.msg.Point32(x, y, 0) for x, y in vertices]
        mark = self.node.warnings.mark()
        self.topic.publish(message)
        return mark

    def check_refused(self, vertices, *words, reason=CollisionWarning.REASON_FOOTPRINT_INVALID):
        with self.subTest(vertices=vertices):
            warning = self.node.warning_with(reason, since=self.send(vertices))
            self.assertUnknown(warning, reason)
            self.assertSays(warning, self.node.topic('footprint'), *words)
            mark = self.send(BOX)
            self.node.warnings.wait_for(lambda w: not w.reason & reason, 'acceptance', mark)

    def test_Fault01_Fault03_Fault06_each_rule(self):
        self.check_refused([(1, 1), (NAN, 1), (0, 0)], 'vertex 1', 'nan')
        self.check_refused([(1, 1), (float('inf'), 1), (0, 0)], 'vertex 1', 'inf')
        self.check_refused([], 'at least 3', '0')
        self.check_refused([(1, 1), (0, 0)], 'at least 3', '2')
        self.check_refused([(0, 0), (1, 0), (2, 0)], 'area')
        self.check_refused([(1, 1), (-1, -1), (-1, 1), (1, -1)], 'cross')
        self.check_refused([(1, 1), (1, 1), (0, 1), (0, 0)], 'repeated')
        self.check_refused([(2e4, 0), (0, 2e4), (0, 0)], '10000')
        self.check_refused([(1e9, 0), (0, 1e9), (0, 0)], '1e+08')

    def test_Fault07_too_many_vertices(self):
        self.check_refused([(i, i * i) for i in range(1001)], '1001 vertices', 'max_vertices 1000',
                           reason=CollisionWarning.REASON_LIMIT)

    def test_the_last_good_one_is_kept(self):
        """A certain hit on it stays CRITICAL, what is not certain is UNKNOWN."""
        mark = self.send(BOX)
        self.node.warnings.wait_for(
            lambda w: not w.reason & CollisionWarning.REASON_FOOTPRINT_MISSING, 'the box', mark)
        mark = self.send([(1, 1), (0, 0)])
        self.node.warning_with(CollisionWarning.REASON_FOOTPRINT_INVALID, mark)
        stamp = self.node.send([circle(7, (3, 0), (-1, 0))])
        warning, prediction = self.node.warning_at(stamp), self.node.prediction_at(stamp)
        self.assertEqual(warning.level, warning.CRITICAL, warning)
        self.assertTrue(warning.reason & warning.REASON_FOOTPRINT_INVALID, warning)
        self.assertEqual(warning.reason & warning.REASON_FOOTPRINT_MISSING, 0, warning)
        self.assertAlmostEqual(warning.time_to_collision, 1.5, delta=1e-9)
        self.assertEqual(warning.contact_free_time, 0)
        self.assertEqual(len(prediction.segments), 4)
        far = self.node.warning_at(self.node.send([circle(7, (30, 0))]))
        self.assertUnknown(far, CollisionWarning.REASON_FOOTPRINT_INVALID)


if __name__ == '__main__':
    run('footprint_refused', FootprintRefused)
