#!/usr/bin/env python3
"""Every scenario, replayed through the node, gives its exact answers for every segment and message."""
import math
import subprocess
import tempfile

import rospy
from node_testing import wait_until
from recorded_data import play_until
from ros_test_case import RosTestCase, run
from scenario_bags import made

TOLERANCE = 1e-6  # [s]


def expected(seconds):
    return math.inf if seconds is None else seconds


class Scenarios(RosTestCase):
    def test_crossing(self):
        self.check('crossing')

    def test_head_on(self):
        self.check('head_on')

    def test_overtaking(self):
        self.check('overtaking')

    def test_near_miss(self):
        self.check('near_miss')

    def test_graze(self):
        self.check('graze')

    def test_cut_in(self):
        self.check('cut_in')

    def test_brake(self):
        self.check('brake')

    def test_turn_in_place(self):
        self.check('turn_in_place')

    def test_arc_past_pillar(self):
        self.check('arc_past_pillar')

    def test_crowd_with_noise(self):
        self.check('crowd', '--count', '30', '--seed', '5', '--noise', '0.05')

    def test_stale_tracker(self):
        self.check('stale_tracker')

    def test_none(self):
        self.check('none')

    def test_trailer(self):
        """Each of its bodies, by odometry and by tf."""
        self.check('trailer')

    def test_looped_clock(self):
        """The bag has the clock itself, which jumps back."""
        with tempfile.TemporaryDirectory() as folder:
            bag, answers = made('looped_clock', folder)
            node = self.patient_rig(answers)
            player = subprocess.Popen(
                ['rosbag', 'play', '--quiet', '--wait-for-subscribers', bag,
                 'obstacles:=' + node.topic('obstacles'), 'odom:=' + node.topic('odom')],
                stdin=subprocess.DEVNULL)
            self.addCleanup(player.kill)
            self.assertEqual(player.wait(120), 0, 'exit status of rosbag play')
        self.check_predictions(node, answers, answers['messages'] * 2)

    def check(self, scenario, *options):
        with tempfile.TemporaryDirectory() as folder:
            bag, answers = made(scenario, folder, *options)
            node = self.patient_rig(answers)
            bodies = len(answers['messages'][0].get('footprints', ['footprint']))
            count = bodies * len(answers['messages'])
            play_until(lambda: len(node.predictions.messages) >= count, '%d predictions' % count,
                       bag, ('obstacles', 'odom', '/tf'), '--rate', '4',
                       'obstacles:=' + node.topic('obstacles'), 'odom:=' + node.topic('odom'))
        self.check_predictions(node, answers, answers['messages'])

    def patient_rig(self, answers):
        return self.rig(None, transform_tolerance=10.0, max_data_age=10.0, **answers['parameters'])

    def check_predictions(self, node, answers, messages):
        for name in messages[0].get('footprints', ['footprint']):
            answer = [dict(m, **m['footprints'][name]) if 'footprints' in m else m
                      for m in messages]
            self.check_body(node, name, answers['start'], answer)

    def check_body(self, node, name, start, messages):
        def predictions():
            return [p for p in node.predictions.messages if p.footprint == name]

        wait_until(lambda: len(predictions()) >= len(messages), '%d predictions' % len(messages))
        self.assertEqual(len(predictions()), len(messages))
        for message, prediction in zip(messages, predictions()):
            self.compare(start, message, prediction)
        last = predictions()[-1].header.stamp
        warning = node.warnings.wait_for(
            lambda w: w.footprint == name and w.header.stamp == last, 'the last answer')
        self.assertEqual(warning.collision_predicted,
                         int(messages[-1]['time_to_collision'] is not None))

    def compare(self, start, message, prediction):
        stamp = prediction.header.stamp - rospy.Time(start)
        self.assertAlmostEqual(stamp.to_sec(), message['t'], delta=1e-9)
        times = [segment.time_to_collision for segment in prediction.segments]
        for found, exact in zip(times, map(expected, message['segments'])):
            self.assertTrue(found == exact or abs(found - exact) <= TOLERANCE,
                            'at %r: found %r, exactly %r' % (message['t'], times, message))


if __name__ == '__main__':
    run('scenarios', Scenarios)
