#!/usr/bin/env python3
"""analyze_bag gives what the live node gives when the same bag is replayed through it."""
import json
import math
import os
import tempfile

import analysis_bags as bags
import yaml
from recorded_data import play_until, recording
from ros_test_case import RosTestCase, run
from scenario_bags import made

TOLERANCE = 1e-9  # [s]
# The replay must not lose a message when the machine is busy.
PATIENCE = {'transform_tolerance': 10.0, 'max_data_age': 10.0}


class AnalysisAgreement(RosTestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_driving_robot(self):
        bag, answers = made('crossing', self.folder)
        self.compare(bag, {'obstacles': 'obstacles', 'odom': 'odom', '/tf': '/tf'},
                     dict(answers['parameters'], **PATIENCE))

    def test_recorded_people(self):
        self.compare(recording(self, 'lidar_obstacles.bag'),
                     {'/obstacles': 'obstacles', '/tf_static': '/tf_static'},
                     dict(PATIENCE, base_frame='robot', fixed_frame='map', ego_motion='static',
                          footprint=[[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2], [0.3, -0.2]]))

    def compare(self, bag, topics, parameters):
        rows = self.analyzed(bag, parameters)
        node = self.rig(None, **parameters)
        renamed = ['%s:=%s' % (name, node.topic(to)) for name, to in topics.items()
                   if not to.startswith('/')]
        predictions = node.predictions.messages
        play_until(lambda: len(predictions) >= len(rows), '%d predictions' % len(rows), bag,
                   list(topics), *renamed)
        self.assertEqual(len(predictions), len(rows))
        differences = [self.difference(row, prediction)
                       for row, prediction in zip(rows, predictions)]
        contacts = sum(math.isfinite(s.time_to_collision) for p in predictions for s in p.segments)
        print('\n%s: %d evaluations, %d contacts, worst difference %.3g s' %
              (os.path.basename(bag), len(rows), contacts, max(differences)))
        self.assertGreater(contacts, 50, 'too few to have compared anything')
        self.assertLessEqual(max(differences), TOLERANCE)

    def analyzed(self, bag, parameters):
        file = os.path.join(self.folder, 'parameters.yaml')
        with open(file, 'w') as out:
            yaml.safe_dump(json.loads(json.dumps(parameters)), out)
        output = os.path.join(self.folder, 'out')
        result = bags.analyze(bag, '--params', file, '-o', output)
        self.assertEqual(result.returncode, 0, result.stderr)
        return bags.frames(output)

    def difference(self, row, prediction):
        """The largest of all segments [s]."""
        self.assertAlmostEqual(row['time'], prediction.header.stamp.to_sec(), delta=1e-6)
        largest = 0.0
        for i, segment in enumerate(prediction.segments):
            live, offline = segment.time_to_collision, row['time_to_collision_%d' % i]
            if not bags.same(live, offline):
                self.assertTrue(math.isfinite(live) and math.isfinite(offline), (live, offline))
                largest = max(largest, abs(live - offline))
        return largest


if __name__ == '__main__':
    run('analysis_agreement', AnalysisAgreement)
