#!/usr/bin/env python3
"""Changes of parameters while the node runs: taken as a whole, or refused as a whole."""
import math
import queue
import threading

import rosgraph_msgs.msg
import rospy
from diagnostics_reading import OK, WARN, DiagnosticsReader, values
from dynamic_reconfigure.client import Client
from node_testing import NODE, PATIENT, TIMEOUT, Recorder, circle
from ros_test_case import RosTestCase, run

AHEAD = circle(7, (5.5, 0), (-1, 0))  # touches the front after 4 s
DEFAULTS = {'horizon': 5.0, 'warn_time': 3.0, 'critical_time': 1.5, 'clear_after': 3,
            'transform_tolerance': 0.1, 'heartbeat_rate': 20.0, 'max_obstacles': 10000}
CONTRADICTIONS = [
    ({'warn_time': 6.0}, ('~warn_time 6', '~horizon 5')),
    ({'horizon': 8.0, 'warn_time': 9.0, 'critical_time': 1.0}, ('~warn_time 9', '~horizon 8')),
    ({'critical_time': 3.5, 'clear_after': 1}, ('~critical_time 3.5', '~warn_time 3')),
    ({'max_data_age': 0.05}, ('~transform_tolerance 0.1', '~max_data_age 0.05')),
    ({'horizon': math.nan}, ('~horizon', 'nan')),
    ({'horizon': math.inf}, ('~horizon', 'inf')),
    ({'critical_time': 0.0}, ('~critical_time', '0')),
    ({'critical_time': -1.0}, ('~critical_time', '-1')),
    ({'clear_after': 0}, ('~clear_after', '0')),
    ({'heartbeat_rate': 5.0}, ('~heartbeat_rate', '5')),
    ({'max_obstacles': -1}, ('~max_obstacles', '-1')),
]


class Reconfiguration(RosTestCase):
    def setUp(self):
        self.node = self.rig(**dict(PATIENT, diagnostic_period=0.1))
        self.diagnostics = DiagnosticsReader(self.node.namespace)
        self.addCleanup(self.diagnostics.close)
        self.updates = queue.Queue()
        self.client = Client(self.node.topic(NODE), timeout=TIMEOUT,
                             config_callback=self.updates.put)
        self.addCleanup(self.client.close)
        self.next_update()  # the latched one

    def next_update(self):
        return self.updates.get(timeout=TIMEOUT)

    def change(self, **values):
        """What the service answers, and what it then tells every client, also when it refuses."""
        returned = self.client.update_configuration(values)
        return returned, self.next_update()

    def on_server(self):
        return {name: rospy.get_param(self.node.topic(NODE) + '/' + name) for name in DEFAULTS}

    def check_change(self, values, expected):
        """What everybody holds after an attempt to change to `values`."""
        returned, told = self.change(**values)
        self.assertEqual({n: returned[n] for n in DEFAULTS}, expected)
        self.assertEqual({n: told[n] for n in DEFAULTS}, expected)
        self.assertEqual(self.on_server(), expected)

    def test_Fault41_a_contradiction_is_refused_whole(self):
        log = Recorder('/rosout', rosgraph_msgs.msg.Log)
        self.addCleanup(log.close)
        log.wait_connected(2)  # the node, and this test itself
        for change, words in CONTRADICTIONS:
            with self.subTest(change=change):
                self.check_change(change, DEFAULTS)
                self.assertEqual(self.node.warning_at(self.node.send([AHEAD])).horizon, 5.0)
                says = lambda text: all(word in text for word in words)  # noqa: E731
                log.wait_for(lambda entry: 'refused' in entry.msg and says(entry.msg), words)
                status = self.diagnostics.wait_for('configuration', lambda s: says(s.message))
                self.assertEqual(status.level, WARN)
                self.assertEqual(values(status)['horizon [s]'], '5')

    def test_a_good_change_counts_from_the_next_message(self):
        before = self.node.warning_at(self.node.send([AHEAD]))
        self.assertAlmostEqual(before.time_to_collision, 4, delta=1e-9)
        self.change(warn_time=9.0)  # refused, and forgiven below
        change = {'horizon': 10.0, 'warn_time': 8.0, 'critical_time': 6.0, 'heartbeat_rate': 50.0}
        self.check_change(change, dict(DEFAULTS, **change))
        self.diagnostics.wait_for('configuration', lambda s: s.level == OK and
                                  values(s)['horizon [s]'] == '10', 'OK', self.diagnostics.mark())
        self.diagnostics.wait_for('computation', lambda s: values(s)['period [s]'] == '0.02')
        after = self.node.warning_at(self.node.send([AHEAD]))
        self.assertEqual((after.level, after.horizon), (after.CRITICAL, 10.0))

    def test_a_message_right_after_a_change(self):
        """Also one that comes while the node waits for its next heartbeat."""
        for horizon in range(6, 26):
            self.change(horizon=horizon)
            warning = self.node.warning_at(self.node.send([AHEAD]))
            self.assertEqual(warning.horizon, horizon)

    def test_without_messages_a_change_counts_at_once(self):
        self.change(horizon=10.0)
        self.node.warnings.wait_for(lambda w: w.horizon == 10, 'the new horizon')

    def test_no_change_interrupts_what_is_known(self):
        """While messages come, tuning does not make a moving robot stop."""
        for _ in range(3):
            self.node.warning_at(self.node.send())
        mark = self.node.warnings.mark()
        stop = threading.Event()

        def feed():
            while not stop.wait(0.02):
                self.node.send()
        feeder = threading.Thread(target=feed)
        feeder.start()
        try:
            for horizon in 6.0, 4.0, 5.0:
                self.change(horizon=horizon, clear_after=int(horizon))
                self.node.warnings.wait_for(lambda w, h=horizon: w.horizon == h, horizon, mark)
        finally:
            stop.set()
            feeder.join()
        for warning in self.node.warnings.messages[mark:]:
            self.assertEqual(warning.level, warning.CLEAR, warning)

    def test_clear_after(self):
        self.node.warning_at(self.node.send([circle(7, (1.25, 0))]))
        self.change(clear_after=1)
        levels = []
        for _ in range(3):
            levels.append(self.node.warning_at(self.node.send()).level)
        self.assertEqual(levels[-1], 1, levels)
        self.node.warning_at(self.node.send([circle(7, (1.25, 0))]))
        self.assertEqual(self.node.warning_at(self.node.send()).level, 1, 'CLEAR at the first')


if __name__ == '__main__':
    run('reconfiguration', Reconfiguration)
