"""The test case that the tests of analyze_bag derive from: a folder of its own, and no master."""
import os
import shutil
import tempfile
import unittest

import analysis_bags as bags
import rostest


class _Near:
    def __init__(self, value):
        self._value = value

    def __eq__(self, other):
        return abs(other - self._value) <= 1e-6

    def __repr__(self):
        return 'about %r' % self._value


class AnalysisTestCase(unittest.TestCase):
    longMessage = True
    maxDiff = None

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.output = self.path('out')

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, messages, **options):
        """Path of a new bag."""
        return bags.write(self.path(name), messages, **options)

    def analyzed(self, *arguments):
        return bags.analyze(*arguments, '-o', self.output)

    def contents(self, name):
        with open(os.path.join(self.output, name), 'rb') as file:
            return file.read()

    @staticmethod
    def near(value):
        return _Near(value)


def run(name, test_case):
    rostest.rosrun(bags.PACKAGE, name, test_case)
