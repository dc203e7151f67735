#!/usr/bin/env python3
"""Two nodes that publish one input: degraded and both named, but no less is known."""
import os
import subprocess
import sys

import rospy
from diagnostics_reading import OK, WARN, DiagnosticsReader, values
from node_testing import PATIENT
from ros_test_case import RosTestCase, run

SECOND_TRACKER = os.path.join(os.path.dirname(os.path.realpath(__file__)), 'second_tracker.py')


class SeveralPublishers(RosTestCase):
    def setUp(self):
        self.node = self.rig(**dict(PATIENT, diagnostic_period=0.1))
        self.diagnostics = DiagnosticsReader(self.node.namespace)
        self.addCleanup(self.diagnostics.close)
        for _ in range(3):
            self.node.warning_at(self.node.send())

    def second(self, rate):
        """Another process that publishes obstacles, or with 0 only says that it would."""
        process = subprocess.Popen(
            [sys.executable, SECOND_TRACKER, self.node.topic('obstacles'), str(rate)],
            stdin=subprocess.PIPE)
        self.addCleanup(process.communicate)  # ends its input
        return process

    def check_degraded(self):
        several = self.node.warnings.wait_for(
            lambda w: w.reason & w.REASON_SEVERAL_PUBLISHERS and w.level == w.CLEAR, 'degraded')
        self.assertEqual(several.reason % (1 << 24), 0, several)
        self.assertGreater(several.contact_free_time, 0)
        self.assertSays(several, rospy.get_name(), '/second_tracker', self.node.topic('obstacles'))
        status = self.diagnostics.wait_for('obstacles', lambda s: s.level == WARN, 'WARN')
        for text in status.message, values(status)['publishers']:
            self.assertIn(rospy.get_name(), text)
            self.assertIn('/second_tracker', text)
        self.diagnostics.wait_for('collision', lambda s: s.level == WARN, 'WARN')
        return several

    def test_Fault30_two_that_send(self):
        second = self.second(20)
        self.check_degraded()
        second.communicate()
        self.feed(self.node.send)
        self.node.warnings.wait_for(lambda w: w.reason == 0 and w.level == w.CLEAR, 'one alone',
                                    self.node.warnings.mark())
        self.diagnostics.wait_for('obstacles', lambda s: s.level == OK, 'OK',
                                  self.diagnostics.mark())

    def test_Fault30_one_that_is_silent(self):
        """The master names it: of a type that does not fit, not even a connection would come."""
        self.second(0)
        first = self.check_degraded()
        later = self.node.warnings.wait_for(lambda w: w.sequence >= first.sequence + 60,
                                            'three seconds of heartbeats')
        self.assertTrue(later.reason & later.REASON_SEVERAL_PUBLISHERS, later)


if __name__ == '__main__':
    run('several_publishers', SeveralPublishers)
