#!/usr/bin/python3
"""make_scenario: its bag and answers fit each other, and its mistakes are named."""

import json
import os
import shutil
import tempfile
import unittest

import rosbag
import rostest
from scenario_bags import PACKAGE, made, make_scenario

SCENARIOS = ["crossing", "head_on", "overtaking", "near_miss", "graze", "cut_in", "brake",
             "turn_in_place", "arc_past_pillar", "crowd", "trailer", "stale_tracker",
             "looped_clock", "none"]


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

    def test_list_names_every_scenario(self):
        lines = make_scenario("--list").stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], SCENARIOS)
        for line in lines:
            self.assertGreater(len(line.split()), 3, line)

    def test_every_scenario_has_answers_for_every_message_and_a_derivation(self):
        for scenario in SCENARIOS:
            bag, answers = made(scenario, self.folder)
            with rosbag.Bag(bag) as messages:
                count = messages.get_message_count("obstacles")
            rounds = 2 if answers["looped"] else 1
            self.assertEqual(count, rounds * len(answers["messages"]), scenario)
            self.assertGreater(len(answers["derivation"]), 50, scenario)
            self.assertEqual(answers["scenario"], scenario)

    def test_same_bytes_each_time(self):
        for scenario in SCENARIOS:
            contents = []
            for _ in range(2):
                arguments = (scenario, "-o", self.bag, "--noise", "0.05", "--seed", "3")
                self.assertEqual(make_scenario(*arguments).returncode, 0)
                for path in (self.bag, self.bag.replace(".bag", ".json")):
                    with open(path, "rb") as file:
                        contents.append(file.read())
            self.assertEqual(contents[:2], contents[2:], scenario)

    def test_choices(self):
        bag, answers = made("crowd", self.folder, "--count", "7", "--rate", "20", "--duration",
                            "3.5", "--radius", "0.4", "--speed", "0.9")
        self.assertEqual(len(answers["messages"]), 71)
        with rosbag.Bag(bag) as messages:
            for topic, message, _ in messages.read_messages():
                if topic == "obstacles":
                    self.assertEqual([o.radius for o in message.obstacles], [0.4] * 7)
                if topic == "odom":
                    self.assertEqual(message.twist.twist.linear.x, 0.9)

    def test_seed_decides_where_the_crowd_is(self):
        places = set()
        for seed in ("1", "2", "2"):
            bag, _ = made("crowd", self.folder, "--seed", seed)
            with rosbag.Bag(bag) as messages:
                _, first, _ = next(messages.read_messages("obstacles"))
            places.add(first.obstacles[0].position.x)
        self.assertEqual(len(places), 2)

    def test_tracker_of_stale_tracker_says_nothing_for_two_seconds(self):
        _, answers = made("stale_tracker", self.folder)
        times = [message["t"] for message in answers["messages"]]
        gaps = [(a, b) for a, b in zip(times, times[1:]) if b - a > 0.11]
        self.assertEqual(gaps, [(2.0, 4.0)])

    def test_clock_of_looped_clock_jumps_back_once(self):
        bag, _ = made("looped_clock", self.folder)
        with rosbag.Bag(bag) as messages:
            clock = [m.clock for _, m, _ in messages.read_messages("/clock")]
        jumps = [(a, b) for a, b in zip(clock, clock[1:]) if b < a]
        self.assertEqual([(a.secs - b.secs) for a, b in jumps], [8])

    def test_mistakes_are_named(self):
        for arguments, words in (((), "which scenario?"),
                                 (("crossing", "--sped", "1"), "did you mean --speed?"),
                                 (("crossing", "--speed", "fast"), "--speed"),
                                 (("crossing", "--rate", "0"), "--rate"),
                                 (("turn_in_place", "--speed", "1"), "has no --speed"),
                                 (("crossing", "-o", "x.txt"), "must end in .bag")):
            result = make_scenario(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn(words, result.stderr)

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
