"""The test case that the tests of report.html derive from."""
import os

import browser
from analysis_test_case import AnalysisTestCase


@browser.needs_browser
class ReportTestCase(AnalysisTestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = browser.Browser()
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        super().setUp()
        self.browser.look()

    def report(self, *arguments):
        """Analyses, and shows the report."""
        result = self.analyzed(*arguments, '--quiet')
        self.assertIn(result.returncode, (0, 4), result.stderr)
        self.show()

    def show(self, fragment='', name='report.html'):
        self.browser.open(os.path.join(self.output, name), fragment)

    def figure(self, title):
        return self.browser.text('[data-figure="%s"]' % title)

    def moment(self, name):
        return self.browser.text('[data-moment="%s"]' % name)

    def assert_clean(self):
        """The page is content and asks nobody for anything."""
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual([url for url in self.browser.requests()
                          if not url.startswith(('file://' + self.output, 'data:', 'about:'))], [])
