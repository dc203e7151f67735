#!/usr/bin/env python3
"""analyze_bag: its exit statuses, and what it says when it cannot do what was asked."""
import json
import os
import pty
import signal
import struct
import subprocess
import unittest

import analysis_bags as bags
import foreign_messages
import rosbag
import sensor_msgs.msg
from analysis_test_case import AnalysisTestCase, run


class AnalyzeBagStatus(AnalysisTestCase):
    def check(self, status, *words, result):
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def drive(self, **options):
        return self.write('drive.bag', bags.approach(**options))

    # The command line

    def test_help_has_examples_and_statuses(self):
        result = bags.analyze('--help')
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        for word in ('Examples:', '--fail-under', 'Exit status:', '130'):
            self.assertIn(word, result.stdout)

    def test_version(self):
        result = bags.analyze('--version')
        self.assertEqual((result.returncode, result.stdout), (0, 'analyze_bag 0.1.0\n'))

    def test_misspelt_option(self):
        self.check(2, 'unknown option --warm; did you mean --warn?',
                   result=bags.analyze('drive.bag', '--warm', '2'))

    def test_no_bag(self):
        self.check(2, 'which bag?', result=bags.analyze())

    def test_value_that_is_no_number(self):
        self.check(2, '--horizon', 'soon', result=bags.analyze('drive.bag', '--horizon', 'soon'))

    def test_thresholds_that_contradict(self):
        self.check(2, '~critical_time 2.5 is above ~warn_time 2',
                   result=bags.analyze(self.drive(), *bags.STATIC, '--warn', '2', '--critical', '2.5'))

    def test_parameter_file_that_is_missing_and_one_with_a_misspelt_name(self):
        self.check(2, '/no/such.yaml', result=bags.analyze(self.drive(), '--params', '/no/such.yaml'))
        file = self.path('predictor.yaml')
        with open(file, 'w') as out:
            out.write('waring_time: 2.0\n')
        self.check(2, 'unknown parameter ~waring_time; did you mean ~warn_time?',
                   result=bags.analyze(self.drive(), '--params', file))

    def test_number_that_yaml_reads_as_text(self):
        file = self.path('predictor.yaml')
        with open(file, 'w') as out:
            out.write('warn_time: 1e-1\n')
        self.check(2, '~warn_time is 1e-1', 'YAML', result=bags.analyze(self.drive(), '--params', file))

    def test_start_beyond_the_end(self):
        self.check(2, '--start 9', '3.0',
                   result=bags.analyze(self.drive(), *bags.STATIC, '--start', '9'))

    # Topics

    def test_no_obstacles(self):
        bag = self.write('drive.bag', [('/scan', 0.0, sensor_msgs.msg.LaserScan())])
        self.check(2, 'no topic of it carries obstacles', 'obstacle_detector/Obstacles',
                   '/scan   sensor_msgs/LaserScan', result=bags.analyze(bag, *bags.STATIC))

    def test_several_topics_of_obstacles(self):
        bag = self.write('drive.bag', [('/left', 0.0, bags.obstacles(0.0)),
                                       ('/right', 0.0, bags.obstacles(0.0))])
        self.check(2, 'several topics of it carry obstacles', '--obstacles /left',
                   '--obstacles /right', result=bags.analyze(bag, *bags.STATIC))
        self.check(0, result=bags.analyze(bag, *bags.STATIC, '--obstacles', '/left'))

    def test_named_topic_that_is_not_there_or_carries_something_else(self):
        bag = self.write('drive.bag', [('/obstacles', 0.0, bags.obstacles(0.0)),
                                       ('/scan', 0.0, sensor_msgs.msg.LaserScan())])
        self.check(2, 'it has no topic /obstacle; did you mean /obstacles?',
                   result=bags.analyze(bag, *bags.STATIC, '--obstacles', '/obstacle'))
        self.check(2, '/scan carries sensor_msgs/LaserScan; --obstacles takes',
                   result=bags.analyze(bag, *bags.STATIC, '--obstacles', '/scan'))

    def test_no_odometry(self):
        self.check(2, 'no topic of it carries odometry', '--ego-motion static',
                   result=bags.analyze(self.drive(), '--footprint-polygon', bags.SQUARE))

    def test_no_footprint(self):
        self.check(2, 'no topic of it carries footprint', '--footprint-polygon',
                   result=bags.analyze(self.drive(), '--ego-motion', 'static'))

    def test_other_version_of_a_type(self):
        message = foreign_messages.ObstacleDetectorObstacles()
        path = self.path('drive.bag')
        with rosbag.Bag(path, 'w') as bag:
            header = {'topic': '/obstacles', 'type': 'obstacle_detector/Obstacles',
                      'md5sum': '0123456789abcdef0123456789abcdef', 'message_definition': 'int8 x'}
            bag.write('/obstacles', message, bags.stamp(0), connection_header=header)
        # The Python writer keeps the sum of the class, so it is changed in the file.
        with open(path, 'rb') as file:
            data = file.read()
        with open(path, 'wb') as file:
            file.write(data.replace(message._md5sum.encode(), b'0123456789abcdef0123456789abcdef'))
        self.check(3, 'another version of obstacle_detector/Obstacles',
                   '0123456789abcdef0123456789abcdef', '043bbf49c7775f8111e850268dbcf2e3',
                   result=bags.analyze(path, *bags.STATIC))

    def test_dry_run(self):
        result = bags.analyze(self.drive(), *bags.STATIC, '--dry-run', '-o', self.output)
        self.assertEqual(result.returncode, 0, result.stderr)
        for word in ('3.0 s', '/obstacles (footprint_collision_predictor/ObstacleArray)',
                     'the robot stands still', 'given as a polygon', 'base_link'):
            self.assertIn(word, result.stdout)
        self.assertEqual(os.listdir(self.output), [])
        self.check(2, '--ego-motion static', result=bags.analyze(
            self.drive(), '--footprint-polygon', bags.SQUARE, '--dry-run'))

    # Bags that cannot be read

    def test_no_such_file(self):
        self.check(3, '/no/such.bag: No such file or directory',
                   result=bags.analyze('/no/such.bag', *bags.STATIC))

    def test_folder(self):
        self.check(3, self.folder, result=bags.analyze(self.folder, *bags.STATIC))

    def test_not_a_ros_1_bag(self):
        path = self.path('drive.bag')
        with open(path, 'wb') as file:
            file.write(b'SQLite format 3\0' * 100)
        self.check(3, 'not a ROS 1 bag', result=bags.analyze(path, *bags.STATIC))
        open(path, 'w').close()
        self.check(3, 'not a ROS 1 bag', result=bags.analyze(path, *bags.STATIC))

    def test_bag_without_messages(self):
        self.check(3, 'no message in it', result=bags.analyze(self.write('a.bag', []), *bags.STATIC))

    def unindexed(self, name):
        """As a recorder that was killed leaves it: where the index is has not been filled in."""
        source = self.drive()
        with open(source, 'rb') as file:
            data = bytearray(file.read())
        field = data.index(b'index_pos=') + len(b'index_pos=')
        data[field:field + 8] = struct.pack('<Q', 0)
        with open(self.path(name), 'wb') as file:
            file.write(data)
        return self.path(name)

    def test_unindexed(self):
        path = self.unindexed('killed.bag')
        self.check(3, 'no index', 'rosbag reindex ' + path, result=bags.analyze(path, *bags.STATIC))

    def test_active(self):
        path = self.unindexed('drive.bag.active')
        self.check(3, 'still being recorded', 'rosbag reindex ' + path,
                   result=bags.analyze(path, *bags.STATIC))

    def test_truncated_anywhere(self):
        bag = self.drive()
        with open(bag, 'rb') as file:
            data = file.read()
        for share in (0.01, 0.3, 0.5, 0.9, 0.999):
            cut = self.path('cut.bag')
            with open(cut, 'wb') as file:
                file.write(data[:int(share * len(data))])
            self.check(3, cut + ':', 'rosbag reindex ' + cut, result=bags.analyze(cut, *bags.STATIC))

    def test_damage_in_the_middle_keeps_what_came_before(self):
        path = self.write('drive.bag', bags.approach(seconds=600), compression='bz2')
        with open(path, 'r+b') as file:
            data = file.read()
            middle = data.index(b'BZh', len(data) // 2)  # where the data of a chunk begin
            file.seek(middle)
            file.write(b'no bz2 at all')
        result = self.analyzed(path, *bags.STATIC)
        self.check(3, 'damaged', result=result)
        self.assertIn('partial', result.stdout)
        self.assertTrue(bags.summary(self.output)['partial'])
        self.assertGreater(len(bags.frames(self.output)), 100)

    def test_others_are_analysed_beside_one_that_cannot_be_read(self):
        result = self.analyzed('/no/such.bag', self.drive(), *bags.STATIC)
        self.check(3, '/no/such.bag', result=result)
        self.assertEqual(len(bags.frames(self.output)), 31)
        self.assertEqual([b['state'] for b in bags.summary(self.output)['bags']],
                         ['unknown', 'predicted'])

    # Limits

    def test_limit(self):
        bag = self.drive()  # time to collision falls to 2 s
        self.check(1, result=bags.analyze(bag, *bags.STATIC, '--fail-under', '2.05'))
        self.check(0, result=bags.analyze(bag, *bags.STATIC, '--fail-under', '1.95'))

    def half_unknown(self, distance):
        messages = list(bags.approach(distance=distance))
        return self.write('drive.bag', messages + [('/scan', 6.0, sensor_msgs.msg.LaserScan())])

    def test_too_much_is_unknown_for_a_limit(self):
        bag = self.half_unknown(distance=20.0)
        self.check(0, result=bags.analyze(bag, *bags.STATIC))
        result = bags.analyze(bag, *bags.STATIC, '--fail-under', '0.5')
        self.check(4, result=result)
        self.assertIn('LIMIT NOT PROVEN', result.stdout)
        self.check(0, result=bags.analyze(bag, *bags.STATIC, '--fail-under', '0.5',
                                          '--max-unknown', '45'))

    def test_broken_limit_wins_over_unknown(self):
        self.check(1, result=bags.analyze(self.half_unknown(distance=5.0), *bags.STATIC,
                                          '--fail-under', '2.5'))

    def test_nothing_usable(self):
        bag = self.write('drive.bag', [('/obstacles', 0.0, bags.obstacles(0.0, [], ''))])
        self.check(4, result=bags.analyze(bag, *bags.STATIC))

    # Writing

    def test_place_that_cannot_be_written_is_seen_before_reading(self):
        file = self.path('file')
        open(file, 'w').close()
        self.check(5, file, result=bags.analyze('/no/such.bag', *bags.STATIC, '-o', file + '/out'))

    def test_full_disk(self):
        # A limit on the size of files is what a test can have of it.
        bag = self.write('drive.bag', bags.approach(seconds=100))
        program = ['bash', '-c', 'ulimit -f 8; trap "" XFSZ; exec "$0" "$@"',
                   *bags.command(bag, *bags.STATIC, '-o', self.output)]
        result = subprocess.run(program, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                universal_newlines=True)
        self.check(5, 'cannot write', result=result)
        self.assertEqual(os.listdir(self.output), [])

    # Progress and interruption

    def test_progress_goes_to_stderr_line_by_line_and_quiet_leaves_it_out(self):
        bag = self.drive()
        result = bags.analyze(bag, *bags.STATIC)
        self.assertEqual(result.stderr, ''.join('%d %%\n' % p for p in range(10, 101, 10)))
        quiet = bags.analyze(bag, *bags.STATIC, '--quiet')
        self.assertEqual((quiet.stderr, quiet.stdout), ('', result.stdout))

    def test_bar_on_a_terminal(self):
        ours, theirs = pty.openpty()
        subprocess.run(bags.command(self.drive(), *bags.STATIC), stdout=subprocess.DEVNULL,
                       stderr=theirs, timeout=60)
        os.close(theirs)
        shown = b''
        try:
            while True:
                shown += os.read(ours, 10000)
        except OSError:  # how the end of a terminal reads
            os.close(ours)
        self.assertIn(b'[#', shown)
        self.assertTrue(shown.endswith(b'\r\033[K'), 'the bar is taken away')

    def test_interruption_keeps_what_is_done(self):
        # Its output is not read, so that it is sure to be at work when it is interrupted.
        path = self.write('drive.bag', bags.approach(seconds=3000))
        read, write = os.pipe()
        process = subprocess.Popen(bags.command(path, *bags.STATIC, '-o', self.output), stderr=write,
                                   stdout=subprocess.PIPE, universal_newlines=True)
        os.close(write)
        self.addCleanup(process.kill)
        self.assertEqual(os.read(read, 4), b'10 %')  # it has begun
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=60)
        with os.fdopen(read) as rest:
            said = rest.read()
        self.assertEqual(process.returncode, 130)
        self.assertIn('partial', said)
        self.assertIn('partial: only', output)
        whole = bags.summary(self.output)
        self.assertTrue(whole['partial'])
        rows = bags.frames(self.output)
        self.assertEqual(whole['bags'][0]['evaluations'], len(rows))
        self.assertTrue(0 < len(rows) < 30001, len(rows))


if __name__ == '__main__':
    run('analyze_bag_status', AnalyzeBagStatus)
