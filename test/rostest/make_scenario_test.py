#!/usr/bin/python3
"""make_scenario: its bag and answers fit each other, and its mistakes are named."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest

import rosbag
import rostest

PACKAGE = "footprint_collision_predictor"


def make_scenario(*arguments):
    return subprocess.run(["rosrun", PACKAGE, "make_scenario", *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)


class MakeScenarioTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.bag = os.path.join(self.folder, "scenario.bag")

    def test_answers_are_for_the_obstacles_messages_of_the_bag(self):
        self.assertEqual(make_scenario("crossing", "-o", self.bag).returncode, 0)
        with open(self.bag.replace(".bag", ".json")) as file:
            answers = json.load(file)
        with rosbag.Bag(self.bag) as bag:
            messages = list(bag.read_messages())
        stamps = [m.message.header.stamp for m in messages if m.topic == "obstacles"]
        self.assertEqual(len(stamps), len(answers["messages"]))
        for stamp, answer in zip(stamps, answers["messages"]):
            self.assertAlmostEqual(stamp.to_sec(), answer["stamp"], delta=1e-6)
        odometry = {m.message.header.stamp for m in messages if m.topic == "odom"}
        transforms = {t.header.stamp for m in messages if m.topic == "/tf"
                      for t in m.message.transforms}
        self.assertLessEqual(set(stamps), odometry)
        self.assertLessEqual(set(stamps), transforms)

    def test_same_bytes_each_time(self):
        contents = []
        for _ in range(2):
            self.assertEqual(make_scenario("head_on", "-o", self.bag).returncode, 0)
            with open(self.bag, "rb") as file:
                contents.append(file.read())
        self.assertEqual(contents[0], contents[1])

    def test_unknown_scenario_is_named_with_what_was_meant(self):
        result = make_scenario("crosing", "-o", self.bag)
        self.assertEqual(result.returncode, 2)
        self.assertIn('"crosing"', result.stderr)
        self.assertIn('Did you mean "crossing"?', result.stderr)
        self.assertEqual(os.listdir(self.folder), [])

    def test_place_that_cannot_be_written_is_named(self):
        bag = os.path.join(self.folder, "missing", "scenario.bag")
        result = make_scenario("crossing", "-o", bag)
        self.assertEqual(result.returncode, 5)
        self.assertIn(bag + ": No such file or directory", result.stderr)


if __name__ == "__main__":
    rostest.rosrun(PACKAGE, "make_scenario_test", MakeScenarioTest)
