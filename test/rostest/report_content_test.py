#!/usr/bin/env python3
"""What report.html says: the numbers of summary.json, and nothing that a recording could slip in."""
import os
import shutil
import signal
import subprocess

import analysis_bags as bags
import rosbag
from report_test_case import ReportTestCase
from ros_test_case import run

LEVELS = ('CLEAR', 'WARN', 'CRITICAL', 'UNKNOWN')
HOSTILE = '</script><script>window.hacked=1</script><img src=x onerror=window.hacked=1>"\'&\u2028\u00e4'


def waves(seconds):
    """Somebody who comes near and goes again every 4 s, the first time the nearest."""
    for i in range(int(10 * seconds)):
        t = i / 10
        phase = t % 4
        x, speed = (3.6 - phase, -1) if phase < 2 else (phase - 0.4, 1)
        if t < 4:
            x -= 0.1
        yield '/obstacles', t, bags.obstacles(t, [(7, x, 0, speed, 0, 0.5)])


def without_bytes(path, text, other):
    """Replaces bytes of a file; the lengths are equal, so that lengths and indices stay right."""
    assert len(text) == len(other)
    with open(path, 'rb') as file:
        data = file.read()
    assert text in data
    with open(path, 'wb') as file:
        file.write(data.replace(text, other))


class ReportContent(ReportTestCase):
    def check_numbers(self):
        """The figures are those of summary.json, in digits for a person."""
        whole, = bags.summary(self.output)['bags']
        worst = whole['smallest_time_to_collision']
        if worst:
            value = worst['time_to_collision']
            self.assertEqual(self.figure('Smallest time to collision'),
                             '%.2f s' % value if value > 0 else '0 s: contact')
            self.assertIn('%.2f s, segment %d, obstacle %d' % (
                worst['elapsed'], worst['segment'], worst['obstacle_id']),
                self.browser.text('#figures'))
        self.assertEqual(self.figure('Smallest clearance'), '%.3f m' % whole['smallest_clearance'])
        self.assertEqual(self.figure('Approaches'), str(whole['events']))
        self.assertEqual(self.figure('Data quality'), '%.1f %% usable' % (100 - whole['unknown_percent']))
        for level in LEVELS:
            self.assertEqual(self.browser.text('[data-seconds="%s"]' % level),
                             '%.1f s' % whole['seconds_at_level'][level])
        self.assertEqual(self.browser.data()['bag'], whole)
        return whole

    def test_contact(self):
        self.report(self.write('drive.bag', bags.approach(seconds=6)), *bags.STATIC)
        whole = self.check_numbers()
        self.assertEqual(whole['state'], 'contact')
        self.assertEqual(self.browser.text('#verdict'), 'CONTACT at 5.00 s: segment 3, obstacle 7.')
        self.assert_clean()

    def test_opens_at_the_worst_moment(self):
        self.report(self.write('drive.bag', bags.approach(seconds=6)), *bags.STATIC)
        self.assertEqual(self.browser.seconds(), 5.0)
        self.assertEqual(self.moment('time to collision'), '0 s: contact')
        self.assertEqual(self.browser.text('#moment .chip'), 'CRITICAL')

    def test_prediction_without_contact(self):
        self.report(self.write('drive.bag', bags.approach(seconds=3)), *bags.STATIC)
        self.check_numbers()
        self.assertEqual(self.browser.text('#verdict'), 'No contact; nearest to one at 3.00 s: time to '
                         'collision 2.00 s, segment 3, obstacle 7.')
        self.assertEqual(self.moment('time to collision'), '2.00 s')
        self.assertEqual(self.moment('segment'), '3')
        self.assertEqual(self.moment('obstacle'), '7')
        self.assertEqual(self.moment('closing speed'), '1.00 m/s')
        self.assertEqual(self.moment('clearance'), '2.000 m')

    def test_none_is_not_unknown(self):
        passing = [('/obstacles', t / 10, bags.obstacles(t / 10, [(7, 2 - t / 10, 2, -1, 0, 0.5)]))
                   for t in range(40)]
        self.report(self.write('drive.bag', passing), *bags.STATIC)
        self.check_numbers()
        self.assertEqual(self.figure('Smallest time to collision'), 'none')
        self.assertEqual(self.browser.text('#verdict'), 'No contact was ever predicted.')
        self.assertEqual(self.moment('time to collision'), 'none')
        self.assertEqual(self.moment('clearance'), '1.000 m', 'opens where it was nearest')
        self.report(self.write('drive.bag', [('/obstacles', t / 10, bags.obstacles(t / 10, [], ''))
                                             for t in range(40)]), *bags.STATIC)
        self.assertEqual(self.figure('Smallest time to collision'), 'unknown')
        self.assertIn('CANNOT TELL', self.browser.text('#verdict'))
        self.assertEqual(self.moment('time to collision'), 'unknown')
        self.assertIn('TRANSFORM', self.browser.text('#moment'))
        self.assertIn('TRANSFORM', self.browser.text('#reasons'))
        self.assert_clean()

    def test_table_of_approaches(self):
        self.report(self.write('drive.bag', waves(20)), *bags.STATIC)
        self.check_numbers()
        events = bags.events(self.output)
        rows = self.browser.all('#events tbody tr')
        self.assertEqual(len(rows), 5)
        for row, event in zip(rows, events):
            for text in ('%.2f s' % event['start_elapsed'], '%.2f s' % event['end_elapsed'],
                         event['level'], '%.2f s' % event['worst_elapsed'],
                         '%.3f m' % event['closest_distance']):
                self.assertIn(text, row.text)

    def test_levels_over_time_add_up_to_the_seconds_at_each(self):
        self.report(self.write('drive.bag', waves(20)), *bags.STATIC)
        data = self.browser.data()
        ends = [begin for begin, _ in data['levels'][1:]] + [data['bag']['seconds']]
        seconds = dict.fromkeys(LEVELS, 0.0)
        for (begin, level), end in zip(data['levels'], ends):
            seconds[('UNKNOWN', 'CLEAR', 'WARN', 'CRITICAL')[level]] += end - begin
        for level in LEVELS:
            self.assertAlmostEqual(seconds[level], data['bag']['seconds_at_level'][level], delta=1e-6)

    def test_limit(self):
        bag = self.write('drive.bag', bags.approach())
        for limit, said in (('2.05', 'Limit broken: a time to collision is under 2.05 s.'), ('1.95', '')):
            self.analyzed(bag, *bags.STATIC, '--fail-under', limit)
            self.show()
            self.assertEqual(self.browser.text('#limit'), said)
        blind = self.write('drive.bag', [('/obstacles', t / 10, bags.obstacles(t / 10, [], ''))
                                         for t in range(20)])
        self.analyzed(blind, *bags.STATIC, '--fail-under', '0.5')
        self.show()
        self.assertEqual(self.browser.text('#limit'),
                         'Limit not proven: more than 5 % of the time is unknown.')

    def test_bag_that_cannot_be_read(self):
        self.analyzed('/no/such.bag', *bags.STATIC)
        self.show()
        self.assertIn('No such file', self.browser.text('#problem'))
        self.assertEqual(self.browser.text('#figures'), '')
        self.assertFalse(self.browser.find('#drive').is_displayed())
        self.assert_clean()

    def test_hostile_names(self):
        name = '/x' + HOSTILE
        frame = HOSTILE.replace('/', '.')
        messages = [(name, t / 10, bags.obstacles(t / 10, [(7, 3, 0, 0, 0, 0.5)], frame))
                    for t in range(20)]
        bag = self.write("a'<img src=x onerror=window.hacked=1>\".bag", messages)
        self.report(bag, *bags.STATIC)
        self.assertEqual(self.browser.text('#bag'), bag)
        self.assertEqual(self.browser.data()['bag']['topics']['obstacles'], name)
        self.assertIn(frame.split('\u2028')[0], self.browser.text('#reasons'))
        self.assertIsNone(self.browser.script('return window.hacked'))
        self.assertEqual(self.browser.all('img'), [])
        self.assert_clean()

    def test_names_that_are_not_utf_8(self):
        messages = [('/obstacles', t / 10, bags.obstacles(t / 10, [], 'camera')) for t in range(20)]
        bag = self.write('drive.bag', messages)
        without_bytes(bag, b'camera', b'c\xff\xfe\x80ra')
        self.report(bag, *bags.STATIC)
        self.assertEqual(bags.summary(self.output)['bags'][0]['state'], 'unknown')
        self.assertIn('ra"', self.browser.text('#reasons'))
        self.assert_clean()

    def test_interrupted(self):
        path = self.write('drive.bag', bags.approach(seconds=3000))
        read, write = os.pipe()
        process = subprocess.Popen(bags.command(path, *bags.STATIC, '-o', self.output), stderr=write,
                                   stdout=subprocess.DEVNULL)
        os.close(write)
        self.addCleanup(process.kill)
        with os.fdopen(read) as said:
            self.assertEqual(said.read(4), '10 %')  # it has begun, and cannot end: nobody reads on
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(timeout=60), 130)
        self.show()
        whole, = bags.summary(self.output)['bags']
        self.assertEqual(self.browser.text('#partial').split(' of ')[0],
                         'Partial: only %.2f s' % whole['seconds'])
        self.check_numbers()
        self.report(self.write('drive.bag', bags.approach()), *bags.STATIC)
        self.assertEqual(self.browser.text('#partial'), '', 'the whole is not partial')

    def test_several_bags(self):
        folder = self.path('other')
        os.mkdir(folder)
        names = [self.write('drive.bag', bags.approach(distance=20.0)),
                 self.write('other/drive.bag', bags.approach(seconds=6)),
                 self.write("a b'<.bag", bags.approach(distance=4.0))]
        self.report(*names, *bags.STATIC)
        links = self.browser.all('#bags a')
        self.assertEqual([link.text for link in links], [names[1], names[2], names[0]])
        self.assertEqual(self.browser.text('#verdict'), '3 recordings: 1 with contact, 1 with a contact '
                         'predicted, 1 without')
        self.assert_clean()
        links[1].click()
        self.browser.wait(lambda: self.browser.all('#clock'))
        self.assertEqual(self.browser.text('#bag'), names[2])
        self.browser.find('#all-bags').click()
        self.browser.wait(lambda: self.browser.all('#bags a'))
        # A folder can be moved.
        shutil.move(self.output, self.path('moved'))
        self.output = self.path('moved')
        self.show()
        self.browser.all('#bags a')[0].click()
        self.browser.wait(lambda: self.browser.all('#clock'))
        self.assertEqual(self.browser.text('#bag'), names[1])

    def test_compressed_bag_gives_the_same_page(self):
        pages = []
        for compression in (rosbag.Compression.NONE, rosbag.Compression.LZ4):
            self.analyzed(self.write('drive.bag', waves(20), compression=compression), *bags.STATIC)
            pages.append(self.contents('report.html'))
        self.assertEqual(pages[0], pages[1])


if __name__ == '__main__':
    run('report_content', ReportContent)
