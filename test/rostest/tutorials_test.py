#!/usr/bin/env python3
"""The tutorials' commands do what the tutorials say: every block marked `sh` is run, in order, and its
output is what the block marked `text` below it shows, where `...` stands for anything."""
import os
import re
import shutil
import subprocess
import tempfile

import rospy
from ros_test_case import RosTestCase, run

DOCS = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'docs')
BLOCK = re.compile(r'^```(sh|text)\n(.*?)^```$', re.MULTILINE | re.DOTALL)


def blocks(tutorial):
    """Pairs of commands and the output to expect, None where nothing is said of it."""
    with open(os.path.join(DOCS, tutorial)) as file:
        found = BLOCK.findall(file.read())
    pairs = []
    for kind, text in found:
        if kind == 'sh':
            pairs.append([text, None])
        else:
            pairs[-1][1] = text
    return pairs


def pattern(text):
    """Lines of only `...` stand for any lines, also none."""
    expression = ''
    for line in text.splitlines():
        expression += r'(?:.*\n)*?' if line == '...' else (
            '.*'.join(re.escape(part) for part in line.split('...')) + r'\n')
    return re.compile(expression + r'\Z')


class Tutorials(RosTestCase):
    def setUp(self):
        rospy.set_param('/use_sim_time', False)
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def check(self, tutorial):
        found = blocks(tutorial)
        self.assertTrue(found, 'no commands in ' + tutorial)
        for commands, expected in found:
            result = subprocess.run(['bash', '-c', commands], cwd=self.folder, timeout=120,
                                    stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, universal_newlines=True)
            if expected is None:
                self.assertEqual(result.returncode, 0, commands + result.stdout)
            else:
                self.assertRegex(result.stdout, pattern(expected), commands)

    def test_every_tutorial_is_run_and_listed(self):
        tutorials = {name for name in os.listdir(DOCS) if name.startswith('tutorial_')}
        tested = {name.replace('test_', 'tutorial_') + '.md' for name in dir(self)
                  if name.startswith('test_') and name != 'test_every_tutorial_is_run_and_listed'}
        self.assertEqual(tutorials, tested)
        with open(os.path.join(DOCS, 'README.md')) as file:
            listed = set(re.findall(r'\((tutorial_\w+\.md)\)', file.read()))
        self.assertEqual(tutorials, listed)

    def test_demo(self):
        self.check('tutorial_demo.md')

    def test_footprint(self):
        self.check('tutorial_footprint.md')

    def test_obstacles(self):
        self.check('tutorial_obstacles.md')

    def test_rviz(self):
        self.check('tutorial_rviz.md')

    def test_plotting(self):
        self.check('tutorial_plotting.md')

    def test_analysis(self):
        self.check('tutorial_analysis.md')

    def test_thresholds(self):
        self.check('tutorial_thresholds.md')

    def test_ci(self):
        self.check('tutorial_ci.md')


if __name__ == '__main__':
    run('tutorials', Tutorials)
