#!/usr/bin/env python3
"""analyze_bag: what it finds in recordings whose answers are known."""
import math
import os
import unittest

import analysis_bags as bags
import rosbag
from analysis_test_case import AnalysisTestCase, run

UNKNOWN, CLEAR, WARN, CRITICAL = range(4)


class AnalyzeBagResults(AnalysisTestCase):
    def test_approach(self):
        # Contact at 5 s, so WARN from 2.0 s and CRITICAL from 3.5 s on.
        bag = self.write('drive.bag', bags.approach(seconds=6))
        result = self.analyzed(bag, *bags.STATIC)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = bags.frames(self.output)
        self.assertEqual(len(rows), 61)
        for row in rows:
            self.assertAlmostEqual(row['time'], bags.START + row['elapsed'], delta=1e-6)
            expected = max(0.0, 5 - row['elapsed'])
            self.assertAlmostEqual(row['time_to_collision_3'], expected, delta=1e-9)
        self.assertEqual([row['level'] for row in rows[2:]],
                         [CLEAR] * 18 + [WARN] * 15 + [CRITICAL] * 26)
        event, = bags.events(self.output)
        self.assertEqual((event['start_elapsed'], event['end_elapsed']), (2.0, 6.0))
        self.assertEqual((event['level'], event['contact'], event['ended']),
                         ('CRITICAL', 1, 'recording_end'))
        self.assertEqual((event['worst_elapsed'], event['time_to_collision']), (5.0, 0.0))
        self.assertEqual((event['segment'], event['obstacle_id'], event['obstacle_index']), (3, 7, 0))
        # At 6 s its centre is at 0: 0.5 m inside, 1 m deep with its radius.
        self.assertAlmostEqual(event['closest_distance'], -1.0, delta=1e-9)
        whole, = bags.summary(self.output)['bags']
        self.assertEqual((whole['state'], whole['events'], whole['events_with_contact']),
                         ('contact', 1, 1))
        self.assertEqual(whole['seconds_at_level'],
                         {'CLEAR': self.near(1.8), 'WARN': self.near(1.5),
                          'CRITICAL': self.near(2.5), 'UNKNOWN': self.near(0.2)})
        self.assertIn('CONTACT at 5.00 s: segment 3, obstacle 7', result.stdout)

    def test_contact_that_is_predicted_and_does_not_follow(self):
        # It comes to within 1.2 s, then stands: no contact.
        messages = [m for m in bags.approach(seconds=3.8)]
        messages += [('/obstacles', t / 10, bags.obstacles(t / 10, [(7, 2.2, 0, 0, 0, 0.5)]))
                     for t in range(39, 60)]
        self.analyzed(self.write('drive.bag', messages), *bags.STATIC)
        event, = bags.events(self.output)
        self.assertEqual((event['contact'], event['ended'], event['level']), (0, 'clear', 'CRITICAL'))
        self.assertAlmostEqual(event['time_to_collision'], 1.2, delta=1e-9)
        # The level falls with the third lower message, so 4.0 s is the last one with it.
        self.assertEqual(event['end_elapsed'], 4.0)
        self.assertAlmostEqual(event['closest_distance'], 1.2, delta=1e-9)
        whole, = bags.summary(self.output)['bags']
        self.assertEqual(whole['state'], 'predicted')

    def test_nothing_there(self):
        bag = self.write('drive.bag', [('/obstacles', t / 10, bags.obstacles(t / 10))
                                       for t in range(50)])
        result = self.analyzed(bag, *bags.STATIC)
        self.assertEqual(result.returncode, 0, result.stderr)
        whole, = bags.summary(self.output)['bags']
        self.assertEqual(whole['state'], 'none')
        self.assertIsNone(whole['smallest_time_to_collision'])
        self.assertEqual(bags.events(self.output), [])
        self.assertIn('no contact was ever predicted', result.stdout)

    def test_silence_of_the_tracker_is_unknown_from_max_data_age_on(self):
        messages = [('/obstacles', t / 10, bags.obstacles(t / 10)) for t in range(11)]
        messages += [('/obstacles', 4 + t / 10, bags.obstacles(4 + t / 10)) for t in range(11)]
        result = self.analyzed(self.write('drive.bag', messages), *bags.STATIC)
        silent, = [row for row in bags.frames(self.output) if row['silence']]
        self.assertAlmostEqual(silent['elapsed'], 1.5, delta=1e-6)
        self.assertEqual(silent['level'], UNKNOWN)
        whole, = bags.summary(self.output)['bags']
        self.assertEqual(whole['silences'], 1)
        self.assertAlmostEqual(whole['unknown_percent'], 100 * 2.5 / 5.0, delta=1e-3)
        self.assertEqual(whole['state'], 'unknown')
        self.assertIn('CANNOT TELL', result.stdout)
        self.assertIn('OBSTACLES_STALE', result.stdout)

    def test_moving_robot_and_transforms(self):
        # The robot drives at 1 m/s towards what stands in the fixed frame: contact at 5 s.
        messages = []
        for i in range(31):
            t = i / 10
            messages += [('/tf', t, bags.transforms(t, x=t)), ('/odom', t, bags.odometry(t, 1.0)),
                         ('/obstacles', t, bags.obstacles(t, [(7, 6.0, 0, 0, 0, 0.5)], 'odom'))]
        result = self.analyzed(self.write('drive.bag', messages), '--footprint-polygon', bags.SQUARE)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = bags.frames(self.output)
        self.assertEqual(len(rows), 31)
        for row in rows:
            self.assertAlmostEqual(row['time_to_collision_3'], 5 - row['elapsed'], delta=1e-9)
            self.assertEqual((row['velocity_x'], row['velocity_y'], row['yaw_rate']), (1, 0, 0))

    def test_message_waits_for_a_transform_that_comes_a_little_later(self):
        messages = []
        for i in range(31):
            t = i / 10
            messages += [('/obstacles', t, bags.obstacles(t, [(7, 6.0, 0, -1, 0, 0.5)], 'odom')),
                         ('/tf', t + 0.05, bags.transforms(t))]
        self.analyzed(self.write('drive.bag', messages), *bags.STATIC)
        rows = bags.frames(self.output)
        self.assertEqual(len(rows), 31)
        self.assertEqual({row['reason'] for row in rows[2:]}, {0})
        self.assertAlmostEqual(rows[10]['elapsed'], 1.05, delta=1e-6)  # when it could be answered
        self.assertAlmostEqual(rows[10]['time'], bags.START + 1, delta=1e-6)  # what it speaks of

    def test_message_waits_no_longer_than_the_tolerance_by_the_time_of_recording(self):
        messages = [('/obstacles', t, bags.obstacles(t, [], 'odom')) for t in (0.0, 0.4, 0.8)]
        self.analyzed(self.write('drive.bag', messages), *bags.STATIC)
        waited = [row['elapsed'] for row in bags.frames(self.output)]
        self.assertEqual(waited, [self.near(t) for t in (0.1, 0.5, 0.9)])

    def test_missing_transforms_are_told_with_frames_and_share(self):
        bag = self.write('drive.bag', [('/obstacles', t / 10, bags.obstacles(t / 10, [], 'camera'))
                                       for t in range(20)])
        result = self.analyzed(bag, *bags.STATIC)
        self.assertEqual(result.returncode, 4)
        self.assertIn('TRANSFORM in 20 of 20 (100.0 %)', result.stdout)
        self.assertIn('camera', result.stdout)
        self.assertIn('base_link', result.stdout)
        self.assertEqual(bags.summary(self.output)['bags'][0]['state'], 'unknown')

    def test_footprint_from_its_topic_gives_as_many_columns_as_it_has_segments(self):
        triangle = [(1, 0), (-1, 1), (-1, -1)]
        messages = [('/obstacles', 0.0, bags.obstacles(0.0)),
                    ('/robot/footprint', 0.05, bags.footprint(0.05, triangle))]
        messages += [('/obstacles', t / 10, bags.obstacles(t / 10)) for t in range(1, 10)]
        self.analyzed(self.write('drive.bag', messages), '--ego-motion', 'static')
        rows = bags.frames(self.output)
        self.assertIn('time_to_collision_2', rows[0])
        self.assertNotIn('time_to_collision_3', rows[0])
        self.assertEqual(rows[0]['time_to_collision_2'], '')
        self.assertEqual(rows[5]['time_to_collision_2'], math.inf)

    def test_start_and_duration(self):
        bag = self.write('drive.bag', bags.approach(seconds=6))
        self.analyzed(bag, *bags.STATIC, '--start', '2.0', '--duration', '1.0')
        rows = bags.frames(self.output)
        self.assertEqual(len(rows), 11)
        self.assertAlmostEqual(rows[0]['time'], bags.START + 2, delta=1e-6)
        self.assertEqual(rows[0]['elapsed'], 0)
        self.assertAlmostEqual(rows[-1]['time'], bags.START + 3, delta=1e-6)

    def test_what_was_latched_long_before_the_start_is_known(self):
        messages = [('/tf_static', 0.0, bags.transforms(0.0, 'base_link', 'laser', x=1.0)),
                    ('/footprint', 0.0, bags.footprint(0.0, [(1, 0), (-1, 1), (-1, -1)]))]
        messages += [('/obstacles', t, bags.obstacles(t, [], 'laser')) for t in range(60)]
        bag = self.write('drive.bag', messages, latched=('/tf_static', '/footprint'))
        result = self.analyzed(bag, '--ego-motion', 'static', '--start', '50')
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_compressed_bags_give_the_same(self):
        outputs = []
        for compression in (rosbag.Compression.NONE, rosbag.Compression.BZ2, rosbag.Compression.LZ4):
            bag = self.write('drive.bag', bags.approach(), compression=compression)
            self.analyzed(bag, *bags.STATIC)
            outputs.append(self.contents('frames.csv'))
        self.assertGreater(len(outputs[0]), 1000)
        self.assertEqual(outputs[1], outputs[0])
        self.assertEqual(outputs[2], outputs[0])

    def test_several_bags_side_by_side_give_the_same_as_one_after_another(self):
        names = [self.write('%d.bag' % i, bags.approach(distance=4.0 + i)) for i in range(5)]
        outputs = []
        for jobs in ('1', '4', '4'):
            result = self.analyzed(*names, *bags.STATIC, '--jobs', jobs)
            self.assertEqual(result.returncode, 0, result.stderr)
            outputs.append([result.stdout] + [self.contents(name) for name in
                                              ('frames.csv', 'events.csv', 'summary.json',
                                               'report.html', 'reports/0005_4.html')])
        self.assertEqual(outputs[1], outputs[0])
        self.assertEqual(outputs[2], outputs[0])
        rows = bags.frames(self.output)
        self.assertEqual([row['bag'] for row in rows], [name for name in names for _ in range(31)])
        self.assertEqual(sorted(os.listdir(self.output)),
                         ['events.csv', 'frames.csv', 'report.html', 'reports', 'summary.json'])

    def test_report_left_out(self):
        bag = self.write('drive.bag', bags.approach())
        result = self.analyzed(bag, *bags.STATIC, '--no-report')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(os.listdir(self.output)), ['events.csv', 'frames.csv', 'summary.json'])

    def test_parameters_of_a_file_and_options_that_win(self):
        bag = self.write('drive.bag', bags.approach(seconds=6))
        file = self.path('predictor.yaml')
        with open(file, 'w') as out:
            out.write('footprint: "%s"\nego_motion: static\nwarn_time: 2\ncritical_time: 1.0\n'
                      'horizon: 10.0\n' % bags.SQUARE)
        self.analyzed(bag, '--params', file, '--critical', '0.5')
        used = bags.summary(self.output)['parameters']
        self.assertEqual((used['warn_time'], used['critical_time'], used['horizon']), (2, 0.5, 10))
        self.assertEqual(bags.events(self.output)[0]['start_elapsed'], 3.0)


if __name__ == '__main__':
    run('analyze_bag_results', AnalyzeBagResults)
