#!/usr/bin/python3
"""watch_warnings: what it prints, and how it ends, for warnings that agree, disagree, or never come."""

import json
import os
import shutil
import subprocess
import tempfile
import threading
import unittest

import genpy
import rospy
import rostest
from footprint_collision_predictor.msg import CollisionWarning

PACKAGE = "footprint_collision_predictor"


class Connected(rospy.SubscribeListener):
    def __init__(self):
        super().__init__()
        self.event = threading.Event()

    def peer_subscribe(self, *_):
        self.event.set()


def warning_for(answers, message, error):
    """What a predictor would say to one message, wrong by `error` seconds."""
    warning = CollisionWarning(footprint="footprint", horizon=5.0, segment=-1, obstacle_id=-1)
    warning.header.stamp = genpy.Time(answers["start"], int(round(message["t"] * 1e9)))
    warning.header.stamp.canon()
    warning.level = CollisionWarning.CLEAR
    warning.time_to_collision = float("inf")
    time = message["time_to_collision"]
    if time is not None:
        warning.collision_predicted = 1
        warning.time_to_collision = time + error
        warning.segment = answers["segment"]
        warning.obstacle_id = answers["obstacle_id"]
        warning.level = (CollisionWarning.CRITICAL if time <= 1.5 else
                         CollisionWarning.WARN if time <= 3 else CollisionWarning.CLEAR)
    return warning


class WatchWarningsTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def watch(self, scenario, error=0.0, publish=True, change=None):
        """Runs it on the scenario's own answers; returns its output and exit status."""
        bag = os.path.join(self.folder, scenario + ".bag")
        subprocess.check_call(["rosrun", PACKAGE, "make_scenario", scenario, "-o", bag],
                              stdout=subprocess.DEVNULL)
        expect = bag.replace(".bag", ".json")
        with open(expect) as file:
            answers = json.load(file)
        connected = Connected()
        publisher = rospy.Publisher("collision_warning", CollisionWarning, queue_size=1000,
                                    subscriber_listener=connected)
        self.addCleanup(publisher.unregister)
        process = subprocess.Popen(
            ["rosrun", PACKAGE, "watch_warnings", "--expect", expect, "--timeout",
             "30" if publish else "0.5"],
            stdout=subprocess.PIPE, universal_newlines=True)
        self.addCleanup(process.kill)
        if publish:
            self.assertTrue(connected.event.wait(30))
            for message in answers["messages"]:
                warning = warning_for(answers, message, error)
                if change:
                    change(warning)
                publisher.publish(warning)
        output, _ = process.communicate(timeout=60)
        publisher.unregister()
        return output, process.returncode

    def test_agreement(self):
        output, status = self.watch("crossing")
        self.assertEqual(status, 0, output)
        self.assertIn("t=  4.60 s  WARN      contact in 2.96 s  segment 3  obstacle 7\n", output)
        self.assertIn("t=  6.10 s  CRITICAL  contact in 1.46 s  segment 3  obstacle 7\n", output)
        self.assertIn("t=  7.60 s  CRITICAL  contact now  segment 3  obstacle 7\n", output)
        self.assertIn("CLEAR     nothing within 5.0 s\n", output)
        self.assertIn("difference 0.000000000 s", output)
        self.assertNotIn("\033", output)

    def test_no_contact_where_none_is_expected(self):
        output, status = self.watch("near_miss")
        self.assertEqual(status, 0, output)

    def test_wrong_moment(self):
        output, status = self.watch("crossing", error=1e-5)
        self.assertEqual(status, 1, output)
        self.assertIn("DISAGREES in: the moment of contact", output)

    def test_wrong_obstacle(self):
        def other(warning):
            if warning.obstacle_id == 7:
                warning.obstacle_id = 3
        output, status = self.watch("crossing", change=other)
        self.assertEqual(status, 1, output)
        self.assertIn("DISAGREES in: the obstacle", output)

    def test_unknown_shows_its_message_and_is_no_warning(self):
        def unknown(warning):
            warning.level = CollisionWarning.UNKNOWN
            warning.collision_predicted = 0
            warning.message = "odometry is missing"
        output, status = self.watch("head_on", change=unknown)
        self.assertEqual(status, 3, output)
        self.assertIn("UNKNOWN   odometry is missing\n", output)

    def test_nothing_ever_comes(self):
        output, status = self.watch("crossing", publish=False)
        self.assertEqual(status, 3, output)
        self.assertIn("NO WARNING CAME", output)

    def test_answers_that_are_missing(self):
        result = subprocess.run(["rosrun", PACKAGE, "watch_warnings", "--expect", "/no/such.json"],
                                stderr=subprocess.PIPE, universal_newlines=True)
        self.assertEqual(result.returncode, 4)
        self.assertIn("/no/such.json", result.stderr)


if __name__ == "__main__":
    rospy.init_node("watch_warnings_test")
    rostest.rosrun(PACKAGE, "watch_warnings_test", WatchWarningsTest)
