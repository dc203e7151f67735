#!/usr/bin/env python3
"""How large report.html is, what making it takes, and what it is made of."""
import hashlib
import os
import subprocess
import sys

import analysis_bags as bags
from report_content_test import waves
from report_test_case import ReportTestCase
from ros_test_case import run
from scenario_bags import make_scenario

UPLOT = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'third_party', 'uplot')


# A process begins with the size of the one that starts it, so a small one has to.
MEASURE = '''
import os, sys
child = os.fork()
if child == 0:
    os.execv(sys.argv[1], sys.argv[1:])
_, status, usage = os.wait4(child, 0)
print(usage.ru_maxrss)
sys.exit(status)
'''


def contents_of(name):
    with open(os.path.join(UPLOT, name), 'rb') as file:
        return file.read()


class ReportSize(ReportTestCase):
    def crowd(self, *options):
        bag = self.path('crowd.bag')
        result = make_scenario('crowd', '-o', bag, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return bag

    def memory(self, *arguments):
        """The largest resident memory [MB] of one run."""
        command = bags.command(*arguments, '--quiet', '-o', self.output)
        measured = subprocess.run([sys.executable, '-c', MEASURE, *command], timeout=120,
                                  stdout=subprocess.PIPE, universal_newlines=True)
        self.assertEqual(measured.returncode, 0)
        return int(measured.stdout.splitlines()[-1]) / 1024

    def test_ten_minutes_among_many_are_under_10_MB(self):
        bag = self.crowd('--count', '60', '--rate', '20', '--duration', '600')
        self.assertLess(self.memory(bag, '--footprint-polygon', bags.SQUARE), 200)
        self.assertLess(os.path.getsize(os.path.join(self.output, 'report.html')), 10e6)
        self.show()
        data = self.browser.data()
        whole, = bags.summary(self.output)['bags']
        rows = bags.frames(self.output)
        self.assertTrue(data['thinned'])
        self.assertLess(len(data['frames']), len(rows))
        # The worst moment is there, and everything around approaches.
        self.assertAlmostEqual(self.browser.seconds(), whole['smallest_time_to_collision']['elapsed'],
                               delta=1e-3)
        kept = {frame[0] for frame in data['frames']}
        for event in bags.events(self.output):
            near = {row['elapsed'] for row in rows
                    if event['start_elapsed'] - 2 < row['elapsed'] < event['end_elapsed'] + 2}
            self.assertLessEqual(near, kept)
        steps = [b[0] - a[0] for a, b in zip(data['frames'], data['frames'][1:])]
        self.assertLess(max(steps), 5)
        self.assert_clean()

    def test_near_all_the_time(self):
        # Nothing is away from an approach, so everything is thinned; the worst stays.
        others = bags.obstacles(0, [(100 + i, -20, i, 0, 0, 0.3) for i in range(59)]).obstacles
        messages = list(waves(1000))
        for _, _, message in messages:
            message.obstacles += others
        bag = self.write('drive.bag', messages)
        self.assertLess(self.memory(bag, *bags.STATIC), 200)
        self.assertLess(os.path.getsize(os.path.join(self.output, 'report.html')), 10e6)
        self.show()
        whole, = bags.summary(self.output)['bags']
        self.assertAlmostEqual(self.browser.seconds(), whole['smallest_time_to_collision']['elapsed'],
                               delta=1e-3)
        self.assertGreater(len(self.browser.data()['frames']), 1000)
        self.assertEqual(self.figure('Approaches'), str(whole['events']))
        self.assertEqual(len(self.browser.all('#events tbody tr')), whole['events'])
        self.assert_clean()

    def test_same_on_every_run(self):
        bag = self.crowd('--count', '60', '--rate', '20', '--duration', '300')
        other = self.write('drive.bag', waves(20))
        pages = []
        for jobs in '1', '2':
            self.analyzed(bag, other, '--footprint-polygon', bags.SQUARE, '--ego-motion', 'static',
                          '--jobs', jobs)
            pages.append([self.contents(name) for name in
                          ('report.html', 'reports/0001_crowd.html', 'reports/0002_drive.html')])
        self.assertEqual(pages[0], pages[1])

    def test_vendored_charts(self):
        sums = [line.split() for line in contents_of('SHA256SUMS').decode().splitlines()]
        self.assertEqual({name for _, name in sums}, {'LICENSE', 'uPlot.iife.min.js', 'uPlot.min.css'})
        for checksum, name in sums:
            self.assertEqual(hashlib.sha256(contents_of(name)).hexdigest(), checksum, name)
        # Nobody changed both.
        self.assertEqual(dict(map(reversed, sums))['uPlot.iife.min.js'],
                         '19c8d4c6ad88929a79f4ae49d6f7161566dfd0ba3d15cc495e974f787eb78f1f')
        self.analyzed(self.write('drive.bag', bags.approach()), *bags.STATIC)
        page = self.contents('report.html')
        for _, name in sums:
            self.assertIn(contents_of(name), page, name)


if __name__ == '__main__':
    run('report_size', ReportSize)
