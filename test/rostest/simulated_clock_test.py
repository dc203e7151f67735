#!/usr/bin/env python3
"""A simulated clock that never starts, stands still, or jumps: UNKNOWN by the steady clock."""
import threading
import time

import rosgraph_msgs.msg
import rospy
from footprint_collision_predictor.msg import CollisionWarning
from node_testing import PATIENT, Publisher, Recorder, circle, transform
from ros_test_case import RosTestCase, run
from several_bodies import PATIENT_ROBOT, straight

CLOCK = CollisionWarning.REASON_CLOCK
DEADLINE = CollisionWarning.REASON_DEADLINE
LAG = 0.25  # [s] by which messages are stamped behind the clock, since /clock may come after them
PARAMETERS = dict(PATIENT, max_data_age=2.0)


class Clock:
    """Publishes /clock in real time, 100 times a second, while it runs."""

    def __init__(self, start):
        self._publisher = Publisher('/clock', rosgraph_msgs.msg.Clock)
        self._lock = threading.Lock()
        self._halt = threading.Event()
        self.jump(start)
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def jump(self, seconds):
        with self._lock:
            self._start, self._since = seconds, time.monotonic()

    def now(self):
        with self._lock:
            return self._start + time.monotonic() - self._since

    def stamp(self):
        return rospy.Time.from_sec(self.now() - LAG)

    def _run(self):
        while not self._halt.wait(0.01):
            self._publisher.publish(rospy.Time.from_sec(self.now()))

    def halt(self):
        self._halt.set()
        self._thread.join()

    def close(self):
        self.halt()
        self._publisher.close()


class SimulatedClock(RosTestCase):
    def setUp(self):
        self.node = self.rig(**PARAMETERS)

    def started(self, start):
        clock = Clock(start)
        self.addCleanup(clock.close)
        self.node.warnings.wait_for(lambda w: not w.reason & CLOCK, 'the clock to start',
                                    self.node.warnings.mark())
        return clock

    def send_until(self, clock, condition, what, obstacles=(), frame='base_link'):
        """Sends with fresh stamps until a warning is as wanted; returns that."""
        mark = self.node.warnings.mark()
        for _ in range(1500):
            self.node.send(obstacles, frame, clock.stamp())
            try:
                return self.node.warnings.wait_for(condition, what, mark, timeout=0.02)
            except AssertionError:
                continue
        raise AssertionError('in vain for ' + what + '\n%s' % self.node.warnings.messages[-1])

    def check_beating(self, reason):
        """Two seconds' worth of heartbeats come, all of them UNKNOWN for that reason, or because the
        machine was busy with other things."""
        mark = self.node.warnings.mark()
        begin = time.monotonic()
        first = self.node.next_warning()
        self.node.warnings.wait_for(lambda w: w.sequence == first.sequence + 40, since=mark)
        self.assertLess(time.monotonic() - begin, 2.25, '20 heartbeats a second')
        warnings = self.node.warnings.messages[mark:]
        self.assertTrue(any(warning.reason & reason for warning in warnings))
        for warning in warnings:
            self.assertUnknown(warning, reason if warning.reason != DEADLINE else DEADLINE)

    def test_Fault21_never_starts(self):
        self.check_beating(CLOCK)
        self.assertSays(self.node.next_warning(), '/clock', '--clock', 'use_sim_time')
        self.node.send(stamp=rospy.Time(100))
        self.check_beating(CLOCK)
        self.assertFalse(self.node.predictions.messages)

    def test_Fault21_stands_still(self):
        clock = self.started(1000)
        self.send_until(clock, lambda w: w.level == w.CLEAR, 'CLEAR')
        clock.halt()
        still = self.node.warning_with(CLOCK, self.node.warnings.mark())
        self.assertUnknown(still, CLOCK)
        self.assertSays(still, 'stood still')
        self.check_beating(CLOCK)
        again = self.started(clock.now())
        self.send_until(again, lambda w: w.level == w.CLEAR, 'CLEAR')

    def test_a_hit_is_not_known_when_the_clock_stands_still(self):
        clock = self.started(1000)
        self.send_until(clock, lambda w: w.level == w.CRITICAL, 'CRITICAL', [circle(7, (1.25, 0))])
        clock.halt()
        still = self.node.warning_with(CLOCK, self.node.warnings.mark())
        self.assertUnknown(still, CLOCK)

    def test_Fault19_jumps_back(self):
        """What was known of the old time is gone; fresh data of the new time are right at once."""
        log = Recorder('/rosout', rosgraph_msgs.msg.Log)
        self.addCleanup(log.close)
        log.wait_connected(2)  # the node, and this test itself
        clock = self.started(1000)
        self.send_until(clock, lambda w: w.level == w.CRITICAL, 'CRITICAL', [circle(7, (1.25, 0))])
        clock.jump(500)
        mark = self.node.warnings.mark()
        back = self.node.warnings.wait_for(lambda w: w.header.stamp.to_sec() < 900, since=mark)
        self.assertUnknown(back, back.REASON_OBSTACLES_MISSING)
        self.assertEqual((back.collision_predicted, back.obstacle_count), (0, 0))
        stamp = clock.stamp()
        self.node.send([circle(8, (3, 0), (-1, 0))], stamp=stamp)
        fresh = self.node.warning_at(stamp)
        self.assertEqual((fresh.level, fresh.obstacle_id), (fresh.CRITICAL, 8))
        self.assertAlmostEqual(fresh.time_to_collision, 1.5, delta=1e-9)
        said = log.wait_for(lambda entry: 'jumped back' in entry.msg, 'the log to say so')
        self.assertEqual(said.level, said.WARN)
        self.send_until(clock, lambda w: w.level == w.CLEAR, 'CLEAR')
        self.assertEqual(len([e for e in log.messages if 'jumped back' in e.msg]), 1)

    def test_Fault19_jumps_back_for_every_body(self):
        """A motion that is taken from tf is known again only from transforms of the new time."""
        self.node.close()
        self.node = self.rig(**dict(PATIENT_ROBOT, ego_motion='static', max_data_age=2.0,
                                    transform_tolerance=0.1))
        log = Recorder('/rosout', rosgraph_msgs.msg.Log)
        self.addCleanup(log.close)
        log.wait_connected(2)  # the node, and this test itself
        clock = self.started(1000)
        self.send_trailer_until(clock, lambda w: w.level == w.CLEAR, 'CLEAR')
        mark = self.node.warnings.mark()
        clock.jump(500)
        for name in 'base', 'trailer':
            back = self.node.warnings.wait_for(
                lambda w: w.footprint == name and w.header.stamp.to_sec() < 900, since=mark)
            self.assertUnknown(back, back.REASON_OBSTACLES_MISSING)
        stamp = clock.stamp()
        self.node.send([], 'trailer', stamp)
        lost = self.node.warnings.wait_for(
            lambda w: w.footprint == 'trailer' and w.header.stamp >= stamp and w.reason ==
            w.REASON_TRANSFORM, 'an unknown motion', mark)
        self.assertUnknown(lost, lost.REASON_TRANSFORM)
        self.send_trailer_until(clock, lambda w: w.level == w.CLEAR, 'CLEAR')
        self.assertEqual(len([e for e in log.messages if 'jumped back' in e.msg]), 1)

    def send_trailer_until(self, clock, condition, what):
        """With transforms over ground; what the base says does not count."""
        def send(obstacles, frame, stamp):
            self.node.send_transforms(*straight('trailer', 0, 0, 1, stamp),
                                      *straight('base_link', 4, 0, 1, stamp))
            self.node.send(obstacles, frame, stamp)

        mark = self.node.warnings.mark()
        for _ in range(1500):
            send([], 'odom', clock.stamp())
            try:
                return self.node.warnings.wait_for(
                    lambda w: w.footprint == 'trailer' and condition(w), what, mark, timeout=0.02)
            except AssertionError:
                continue
        raise AssertionError('in vain for ' + what + '\n%s' % self.node.warnings.messages[-1])

    def test_Fault19_transforms_of_the_old_time_are_dropped(self):
        """The clock jumps back to where the tf buffer still had an answer, of the old time."""
        clock = self.started(1000)
        self.node.send_transforms(
            *[transform('map', 'base_link', 1, 2, stamp=rospy.Time(t)) for t in (998, 1008)])
        self.send_until(clock, lambda w: w.level == w.CLEAR, 'CLEAR', frame='map')
        clock.jump(1006)
        self.node.warnings.wait_for(lambda w: w.header.stamp.to_sec() > 1005.9)
        clock.jump(1002)
        self.node.warnings.wait_for(lambda w: 1001 < w.header.stamp.to_sec() < 1005,
                                    since=self.node.warnings.mark())
        mark = self.node.warnings.mark()
        stamp = clock.stamp()
        self.node.send(frame='map', stamp=stamp)
        answer = self.node.warnings.wait_for(
            lambda w: w.header.stamp == stamp or not w.reason & w.REASON_OBSTACLES_MISSING,
            'the answer', mark)
        self.assertUnknown(answer, answer.REASON_TRANSFORM)

    def test_Fault20_jumps_forward(self):
        clock = self.started(1000)
        self.send_until(clock, lambda w: w.level == w.CLEAR, 'CLEAR')
        mark = self.node.warnings.mark()
        clock.jump(2000)
        lost = self.node.warnings.wait_for(lambda w: w.header.stamp.to_sec() > 1900, since=mark)
        self.assertUnknown(lost, lost.REASON_OBSTACLES_STALE)
        self.send_until(clock, lambda w: w.level == w.CLEAR, 'CLEAR')


if __name__ == '__main__':
    run('simulated_clock', SimulatedClock)
