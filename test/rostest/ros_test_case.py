"""The test case that all tests of the running node derive from, and how they are run.

rostest's own runner writes a skipped test into the JUnit file as a passed one; this one says so.
"""
import math
import sys
import time
import traceback
import unittest
import xml.etree.ElementTree as ElementTree

import rospy
from feed import Feed
from node_testing import UNKNOWN_REASONS, Rig

_OUTPUT_FLAG = '--gtest_output=xml:'


class RosTestCase(unittest.TestCase):
    longMessage = True

    def rig(self, *arguments, **parameters):
        """A node of this test's own, ended with the test."""
        rig = Rig(*arguments, **parameters)
        self.addCleanup(self.check_words, rig)
        self.addCleanup(rig.close)
        return rig

    def check_words(self, rig):
        """From the first heartbeat on UNKNOWN always says why, and a time always says with what."""
        for warning in rig.warnings.messages:
            if warning.level == warning.UNKNOWN:
                self.assertUnknown(warning, 0)
            if math.isfinite(warning.time_to_collision):
                self.assertGreaterEqual(warning.segment, 0, warning)

    def feed(self, send):
        """Fresh messages until it is stopped, at the latest with the test."""
        feed = Feed(send)
        self.addCleanup(feed.stop)
        return feed

    def assertUnknown(self, warning, reason):
        """What UNKNOWN must say of itself, besides its reason."""
        self.assertEqual(warning.level, warning.UNKNOWN, warning)
        self.assertEqual(warning.reason & reason, reason, warning)
        self.assertTrue(warning.reason & UNKNOWN_REASONS, warning)
        self.assertTrue(warning.message, warning)
        self.assertEqual(warning.contact_free_time, 0, warning)
        self.assertNotEqual(warning.time_to_collision, float('inf'), warning)

    def assertSays(self, warning, *words):
        for word in words:
            self.assertIn(word, warning.message, 'in the message')

    def assertPoint(self, point, x, y, tolerance=1e-9):
        self.assertAlmostEqual(point.x, x, delta=tolerance)
        self.assertAlmostEqual(point.y, y, delta=tolerance)


class _JUnitResult(unittest.TextTestResult):
    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.suite = ElementTree.Element('testsuite')

    def startTest(self, test):
        super().startTest(test)
        classname, name = test.id().rsplit('.', 1)
        self._case = ElementTree.SubElement(self.suite, 'testcase', classname=classname, name=name)
        self._started = time.monotonic()

    def stopTest(self, test):
        self._case.set('time', '%.3f' % (time.monotonic() - self._started))
        super().stopTest(test)

    def _note(self, tag, error):
        note = ElementTree.SubElement(self._case, tag, type=error[0].__name__)
        note.text = ''.join(traceback.format_exception(*error))

    def addError(self, test, error):
        super().addError(test, error)
        self._note('error', error)

    def addFailure(self, test, error):
        super().addFailure(test, error)
        self._note('failure', error)

    def addSubTest(self, test, subtest, error):
        super().addSubTest(test, subtest, error)
        if error is not None:
            self._note('failure', error)

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        ElementTree.SubElement(self._case, 'skipped', message=reason)

    def write(self, path):
        counts = {'tests': self.testsRun, 'failures': len(self.failures),
                  'errors': len(self.errors), 'skipped': len(self.skipped)}
        for name, count in counts.items():
            self.suite.set(name, str(count))
        ElementTree.ElementTree(self.suite).write(path, encoding='utf-8', xml_declaration=True)


def run(name, test_case):
    """Runs the case as a ROS node and ends the process; status 0 when nothing failed."""
    rospy.init_node(name)
    runner = unittest.TextTestRunner(stream=sys.stdout, verbosity=2, resultclass=_JUnitResult)
    result = runner.run(unittest.defaultTestLoader.loadTestsFromTestCase(test_case))
    result.suite.set('name', name)
    for argument in sys.argv:
        if argument.startswith(_OUTPUT_FLAG):
            result.write(argument[len(_OUTPUT_FLAG):])
    rospy.signal_shutdown('tests finished')
    sys.exit(not result.wasSuccessful())
