"""Scenarios of make_scenario, made for a test."""
import json
import os
import subprocess

from roslib.packages import find_node

PACKAGE = 'footprint_collision_predictor'


def make_scenario(*arguments):
    """Runs it to its end; stdout, stderr and returncode are in the result."""
    return subprocess.run([find_node(PACKAGE, 'make_scenario')[0], *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)


def made(scenario, folder, *options):
    """Path of the scenario's bag, and its answers."""
    bag = os.path.join(folder, scenario + '.bag')
    result = make_scenario(scenario, '-o', bag, *options)
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    with open(os.path.join(folder, scenario + '.json')) as answers:
        return bag, json.load(answers)
