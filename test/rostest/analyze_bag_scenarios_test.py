#!/usr/bin/env python3
"""analyze_bag on every scenario, with many choices: for every segment and message the exact answer."""
import math
import os
import unittest

import analysis_bags as bags
import yaml
from analysis_test_case import AnalysisTestCase, run
from scenario_bags import made

TOLERANCE = 1e-9  # [s]


class AnalyzeBagScenarios(AnalysisTestCase):
    def check(self, scenario, *options):
        bag, answers = made(scenario, self.folder, '--duration', '10', *options)
        parameters = self.path('parameters.yaml')
        with open(parameters, 'w') as file:
            yaml.safe_dump(answers['parameters'], file)
        result = self.analyzed(bag, '--params', parameters)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        rows = [row for row in bags.frames(self.output) if not row['silence']]
        messages = answers['messages'] * (2 if answers['looped'] else 1)
        self.contacts = 0
        if 'footprints' not in answers['parameters']:
            self.check_rows(scenario, options, rows, messages)
            return answers
        for name in [body['name'] for body in answers['parameters']['footprints']]:
            self.check_rows(scenario, options, [row for row in rows if row['footprint'] == name],
                            [message['footprints'][name] for message in messages])
        return answers

    def check_rows(self, scenario, options, rows, messages):
        self.assertEqual(len(rows), len(messages))
        for row, message in zip(rows, messages):
            for i, exact in enumerate(message['segments']):
                self.compare(scenario, options, row, row['time_to_collision_%d' % i], exact)

    def compare(self, scenario, options, row, found, exact):
        exact = math.inf if exact is None else exact
        self.contacts += math.isfinite(exact)
        self.assertTrue(found == exact or abs(found - exact) <= TOLERANCE,
                        '%s %s: found %r, exactly %r in %r' % (scenario, options, found, exact, row))

    def test_each(self):
        for scenario in ('crossing', 'head_on', 'overtaking', 'cut_in', 'brake', 'stale_tracker',
                         'looped_clock', 'trailer'):
            self.check(scenario)
            self.assertGreater(self.contacts, 20, scenario)
            self.check(scenario, '--speed', '0.3', '--radius', '0.5', '--rate', '13')

    def test_those_that_touch_nothing_or_almost(self):
        self.check('near_miss')
        self.check('none')
        self.assertEqual(self.contacts, 0)
        self.check('graze')
        self.assertGreater(self.contacts, 100)

    def test_crowds(self):
        contacts = 0
        for seed in range(1, 6):
            self.check('crowd', '--seed', str(seed), '--count', '40', '--noise', '0.1')
            contacts += self.contacts
        self.assertGreater(contacts, 500)

    def test_verdict_fits(self):
        # The moments of the first WARN and of the contact, as the answers have them.
        answers = self.check('crossing')
        event, = bags.events(self.output)
        self.assertAlmostEqual(event['start'], answers['first_warn_stamp'], delta=1e-6)
        self.assertEqual((event['segment'], event['obstacle_id']),
                         (answers['segment'], answers['obstacle_id']))
        self.assertAlmostEqual(event['worst_elapsed'],
                               math.ceil(10 * answers['contact_after']) / 10, delta=1e-6)

    def test_each_body_has_a_verdict(self):
        answers = self.check('trailer')
        event, = bags.events(self.output)
        self.assertEqual((event['footprint'], event['segment']), ('trailer', answers['segment']))
        summary = bags.summary(self.output)
        self.assertEqual([(bag['footprint'], bag['state']) for bag in summary['bags']],
                         [('base', 'none'), ('trailer', 'contact')])

    def test_silent_tracker_is_unknown_from_half_a_second_on(self):
        answers = self.check('stale_tracker')
        silent, = [row for row in bags.frames(self.output) if row['silence']]
        self.assertAlmostEqual(silent['elapsed'], answers['silence']['after'] + 0.5, delta=1e-6)
        self.assertEqual(silent['level'], 0)


if __name__ == '__main__':
    run('analyze_bag_scenarios', AnalyzeBagScenarios)
