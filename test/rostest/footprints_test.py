#!/usr/bin/env python3
"""A robot of several bodies: each by its own motion, with warnings of its own; none holds up another."""
import math

import geometry_msgs.msg
import rospy
from diagnostics_reading import ERROR, OK, DiagnosticsReader, values
from dynamic_reconfigure.client import Client
from node_testing import BOX, NODE, Recorder, circle
from ros_test_case import RosTestCase, run
from several_bodies import BASE, PATIENT_ROBOT, TRAILER, arc, of, straight, turned, without
from visualization_msgs.msg import Marker, MarkerArray

RATE = 0.5  # [rad/s]

# The base drives along the x axis at 1 m/s; 2.5 m before its front is a circle of 0.5 m.
AHEAD = circle(7, (4, 0))

# The trailer, whose frame is at (-4, 0), turns round a centre 2 m to the left. From there a circle
# of 0.5 m at (-1.5, 2) is 2.5 m off, and touches the middle of its front after a turn by this angle
# (3-4-5). A straight line would pass it.
PILLAR = circle(8, (-1.5, 2))
TO_PILLAR = math.atan2(4, 3)


class Footprints(RosTestCase):
    def robot(self, **parameters):
        return self.rig(**dict(PATIENT_ROBOT, **parameters))

    def send(self, node, obstacles=(AHEAD, PILLAR), trailer=arc):
        """Everything of one moment; without the trailer's transforms where it is None."""
        stamp = node.send_odometry((1, 0))
        node.send_transforms(*straight('base_link', 0, 0, 1, stamp))
        if trailer == arc:
            node.send_transforms(*arc('trailer', -4, 0, RATE, stamp))
        elif trailer == straight:
            node.send_transforms(*straight('trailer', -4, 0, 1, stamp))
        return node.send(obstacles, 'odom', stamp)

    def check_hit(self, warning, frame, seconds, obstacle, tolerance=1e-9):
        self.assertEqual(warning.reason, 0, warning)
        self.assertEqual(warning.header.frame_id, frame)
        self.assertAlmostEqual(warning.time_to_collision, seconds, delta=tolerance)
        self.assertEqual((warning.segment, warning.obstacle_id), (3, obstacle))
        self.assertPoint(warning.contact_point, 1, 0, 1e-7)

    def test_each_by_its_own_motion(self):
        """A touch on an arc may be reported while there is 1e-9 m left to go."""
        node = self.robot()
        stamp = self.send(node)
        self.check_hit(of('base', node.warnings, stamp), 'base_link', 2.5, 7)
        self.check_hit(of('trailer', node.warnings, stamp), 'trailer', TO_PILLAR / RATE, 8, 1e-7)
        base = of('base', node.predictions, stamp)
        trailer = of('trailer', node.predictions, stamp)
        self.assertEqual((base.twist.linear.x, base.twist.angular.z), (1, 0))
        for found, exact in ((trailer.twist.linear.x, 1), (trailer.twist.linear.y, 0),
                             (trailer.twist.angular.z, RATE)):
            self.assertAlmostEqual(found, exact, delta=1e-9)
        self.assertEqual([p.header.frame_id for p in (base, trailer)], ['base_link', 'trailer'])

    def test_the_countdown_of_each_is_live(self):
        node = self.robot()
        stamp = self.send(node)
        for name, contact, tolerance in ('base', 2.5, 1e-9), ('trailer', TO_PILLAR / RATE, 1e-7):
            repeat = node.warnings.wait_for(
                lambda w: w.footprint == name and w.reason == 0 and
                w.header.stamp > stamp + rospy.Duration(0.3))
            passed = (repeat.header.stamp - stamp).to_sec()
            self.assertAlmostEqual(repeat.time_to_collision, contact - passed, delta=tolerance)

    def test_each_counts_its_own_messages_in_one_session(self):
        node = self.robot()
        mark = node.warnings.mark()
        for name in 'base', 'trailer':
            node.warnings.wait_for(lambda w: w.footprint == name and w.sequence >= 20)
        heard = node.warnings.messages[mark:]
        self.assertEqual(len({w.session for w in heard}), 1)
        for name in 'base', 'trailer':
            numbers = [w.sequence for w in heard if w.footprint == name]
            self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))))

    def test_a_body_without_transforms_is_unknown_and_holds_up_nobody(self):
        """The trailer's message waits for 20 s; the base is answered at once."""
        node = self.robot()
        stamp = self.send(node, trailer=None)
        self.check_hit(of('base', node.warnings, stamp), 'base_link', 2.5, 7)
        mark = node.warnings.mark()
        waiting = of('trailer', node.warnings, since=mark)
        self.assertUnknown(waiting, waiting.REASON_OBSTACLES_MISSING)

    def test_a_body_without_transforms_says_so_until_they_come(self):
        node = self.robot(transform_tolerance=0.1)
        stamp = self.send(node, trailer=None)
        lost = node.warnings.wait_for(
            lambda w: w.footprint == 'trailer' and w.reason & w.REASON_TRANSFORM, 'TRANSFORM')
        self.assertUnknown(lost, lost.REASON_TRANSFORM)
        self.assertSays(lost, '"odom" and "trailer"')
        self.check_hit(of('base', node.warnings, stamp), 'base_link', 2.5, 7)
        for _ in range(100):
            stamp = self.send(node)
            found = of('trailer', node.warnings, stamp)
            if found.reason == 0:
                return self.check_hit(found, 'trailer', TO_PILLAR / RATE, 8, 1e-7)
        self.fail(found)

    def test_transforms_that_cease(self):
        """The obstacles are in the trailer's frame, so that only its motion is missed."""
        node = self.rig(footprints=[TRAILER], clear_after=1)

        def send(stamp):
            node.send([circle(7, (30, 0))], 'trailer', stamp)
            return stamp

        moving = self.feed(lambda stamp: node.send_transforms(
            turned('odom', 'trailer', 0, 0, 0, stamp)))
        self.feed(send)
        node.warnings.wait_for(lambda w: w.level == w.CLEAR, 'CLEAR')
        moving.stop()
        last = rospy.Time.now()
        lost = node.warnings.wait_for(lambda w: w.level == w.UNKNOWN, 'UNKNOWN', node.warnings.mark())
        self.assertUnknown(lost, lost.REASON_TRANSFORM)
        self.assertSays(lost, '"odom" and "trailer"', 'old', 'motion')
        self.assertLess((lost.header.stamp - last).to_sec(), 0.5 + 0.2)

    def test_a_footprint_that_is_missing_on_its_topic(self):
        node = self.robot(footprints=[BASE, without(TRAILER, 'polygon', topic='shape')])
        stamp = self.send(node, trailer=straight)
        self.check_hit(of('base', node.warnings, stamp), 'base_link', 2.5, 7)
        missing = of('trailer', node.warnings, stamp)
        self.assertUnknown(missing, missing.REASON_FOOTPRINT_MISSING)
        self.assertSays(missing, node.topic('shape'), '~footprints')
        self.assertEqual(missing.reason, missing.REASON_FOOTPRINT_MISSING, missing)
        shape = geometry_msgs.msg.PolygonStamped()
        shape.header.stamp, shape.header.frame_id = rospy.Time.now(), 'trailer'
        shape.polygon.points = [geometry_msgs.msg.Point32(x, y, 0) for x, y in BOX]
        node.publisher('shape', geometry_msgs.msg.PolygonStamped, latch=True).publish(shape)
        node.warnings.wait_for(lambda w: w.footprint == 'trailer' and
                               not w.reason & w.REASON_FOOTPRINT_MISSING, 'the footprint')
        # Its front is at -3, so that the circle, at 4 - 0.5, is 6.5 m ahead: beyond the horizon.
        stamp = self.send(node, [AHEAD], trailer=straight)
        self.assertEqual(of('trailer', node.warnings, stamp).level, missing.CLEAR)

    def test_a_load_that_is_rigid_to_the_base(self):
        """1 m ahead of its middle, from a base that turns on the spot: to the left at RATE m/s."""
        load = {'name': 'load', 'frame_id': 'load', 'polygon': BOX, 'motion': 'odom'}
        node = self.robot(footprints=[BASE, load])
        node.send_static_transforms(turned('base_link', 'load', 1, 0, 0, rospy.Time()))
        stamp = node.send_odometry((0, 0), RATE)
        node.send([], 'base_link', stamp)
        twist = of('load', node.predictions, stamp).twist
        self.assertAlmostEqual(twist.linear.y, RATE, delta=1e-12)
        self.assertEqual((twist.linear.x, twist.angular.z), (0, RATE))

    def test_the_diagnostics_have_the_worst_level_and_each(self):
        node = self.robot(diagnostic_period=0.1)
        diagnostics = DiagnosticsReader(node.namespace)
        self.addCleanup(diagnostics.close)
        far = circle(9, (0, 40))

        def levels():
            mark = diagnostics.mark()
            return [diagnostics.wait_for(name, lambda s: True, since=mark)
                    for name in ('collision', 'collision base', 'collision trailer')]

        stamp = self.send(node, [far])
        of('trailer', node.warnings, stamp)
        diagnostics.wait_for('collision', lambda s: s.level == OK, 'OK')
        self.assertEqual([s.level for s in levels()], [OK, OK, OK])
        mark = diagnostics.mark()
        stamp = self.send(node, [far, circle(8, (-2.6, 0))])  # touches the trailer's front
        self.assertEqual(of('trailer', node.warnings, stamp).level, 3)
        worst = diagnostics.wait_for('collision', lambda s: s.level == ERROR, 'ERROR', mark)
        self.assertEqual(values(worst)['footprint'], 'trailer')
        self.assertEqual(values(worst)['obstacle id'], '8')
        found = levels()
        self.assertEqual([s.level for s in found], [ERROR, OK, ERROR])
        for entry in 'transforms base', 'transforms trailer':
            diagnostics.next(entry)

    def test_markers_of_one_do_not_replace_those_of_another(self):
        node = self.robot()
        pictures = Recorder(node.topic(NODE + '/markers'), MarkerArray)
        self.addCleanup(pictures.close)
        self.send(node)

        def drawn(array):
            return {m.ns: m.header.frame_id for m in array.markers if m.action == Marker.ADD}

        picture = pictures.wait_for(
            lambda a: {'base/contact', 'trailer/contact'} <= set(drawn(a)), 'both contacts')
        names = [(m.ns, m.id) for m in picture.markers]
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual(drawn(picture)['base/contact'], 'base_link')
        self.assertEqual(drawn(picture)['trailer/contact'], 'trailer')
        texts = [m.text.split(':')[0] for m in picture.markers if m.text]
        self.assertEqual(texts, ['base', 'trailer'])

    def test_a_live_change_is_for_all(self):
        node = self.robot()
        client = Client(node.topic(NODE), timeout=30)
        self.addCleanup(client.close)
        client.update_configuration({'horizon': 2.0, 'warn_time': 2.0})
        stamp = self.send(node)
        self.assertEqual(of('base', node.warnings, stamp).horizon, 2)
        self.assertEqual(of('base', node.warnings, stamp).collision_predicted, 0)
        trailer = of('trailer', node.warnings, stamp)
        self.assertEqual((trailer.horizon, trailer.collision_predicted), (2, 1))


if __name__ == '__main__':
    run('footprints', Footprints)
