#!/usr/bin/env python3
"""report.html in the hand of a person: keys, clicks and links do what they say."""
import analysis_bags as bags
from browser import Keys
from report_content_test import waves
from report_test_case import ReportTestCase
from ros_test_case import run


class ReportControls(ReportTestCase):
    def setUp(self):
        super().setUp()
        # Five approaches, of which the first is the worst.
        self.report(self.write('drive.bag', waves(20)), *bags.STATIC)
        self.times = [row['elapsed'] for row in bags.frames(self.output)]
        self.worst = [event['worst_elapsed'] for event in bags.events(self.output)]

    def tearDown(self):
        self.assert_clean()

    def assert_at(self, seconds):
        self.assertAlmostEqual(self.browser.seconds(), seconds, delta=1e-3)
        self.assertAlmostEqual(float(self.browser.find('#scrub').get_property('value')), seconds,
                               delta=0.051)

    def test_arrow_keys(self):
        at = self.times.index(self.worst[0])
        self.browser.press(Keys.ARROW_RIGHT)
        self.assert_at(self.times[at + 1])
        self.browser.press(Keys.ARROW_LEFT, Keys.ARROW_LEFT)
        self.assert_at(self.times[at - 1])
        self.browser.press(Keys.SHIFT, Keys.ARROW_RIGHT)
        self.assert_at(self.times[at - 1] + 1)
        self.browser.press(Keys.HOME)
        self.assert_at(0)
        self.browser.press(Keys.ARROW_LEFT)
        self.assert_at(0)
        self.browser.press(Keys.END)
        self.assert_at(self.times[-1])
        self.assertEqual(self.browser.script('return scrollY'), 0, 'the keys are not the page\'s')

    def test_what_is_said_of_a_moment_is_the_row_of_frames_csv(self):
        row = bags.frames(self.output)[self.times.index(self.worst[0]) - 5]
        self.browser.press(*5 * [Keys.ARROW_LEFT])
        self.assertEqual(self.moment('time to collision'), '%.2f s' % row['time_to_collision'])
        self.assertEqual(self.moment('clearance'), '%.3f m' % row['clearance'])
        self.assertEqual(self.moment('segment'), '%d' % row['segment'])

    def test_next_and_previous_approach(self):
        self.assert_at(self.worst[0])
        self.browser.press('n')
        self.assert_at(self.worst[1])
        self.browser.find('#next-event').click()
        self.assert_at(self.worst[2])
        self.browser.press('p')
        self.assert_at(self.worst[1])
        self.browser.find('#previous-event').click()
        self.assert_at(self.worst[0])
        self.assertFalse(self.browser.find('#previous-event').is_enabled())
        self.browser.press(Keys.END, 'p')
        self.assert_at(self.worst[4])
        self.assertFalse(self.browser.find('#next-event').is_enabled())
        self.browser.press('w')
        self.assert_at(self.worst[0])

    def test_buttons_for_one_evaluation(self):
        at = self.times.index(self.worst[0])
        self.browser.find('#forward').click()
        self.assert_at(self.times[at + 1])
        self.browser.find('#back').click()
        self.browser.find('#back').click()
        self.assert_at(self.times[at - 1])

    def test_playing(self):
        self.browser.press(Keys.HOME)
        self.browser.press(' ')
        self.assertEqual(self.browser.text('#play'), 'Pause')
        self.browser.wait(lambda: self.browser.seconds() > 0.3)
        self.browser.press(' ')
        self.assertEqual(self.browser.text('#play'), 'Play')
        paused = self.browser.seconds()
        self.browser.drawn()
        self.assertEqual(self.browser.seconds(), paused)
        self.assertLess(paused, self.times[-1])
        self.browser.script('document.getElementById("speed").value = "20";'
                            'document.getElementById("speed").dispatchEvent(new Event("change"))')
        self.browser.find('#play').click()
        self.browser.wait(lambda: self.browser.text('#play') == 'Play')  # by itself, at the end
        self.assert_at(self.times[-1])
        self.browser.find('#play').click()  # from the begin again
        self.browser.wait(lambda: self.browser.seconds() < self.times[-1])
        self.browser.wait(lambda: self.browser.text('#play') == 'Play')

    def test_keys_work_after_a_click_on_a_control(self):
        self.browser.find('#play').click()
        self.browser.find('#play').click()
        self.browser.press('w')
        self.browser.press(Keys.ARROW_RIGHT)
        self.assert_at(self.times[self.times.index(self.worst[0]) + 1])

    def test_scrubbing(self):
        self.browser.click_at('#scrub', 0.5)
        self.assertAlmostEqual(self.browser.seconds(), 10, delta=0.2)
        self.browser.press(Keys.ARROW_RIGHT)  # of the report, not of the slider
        self.assertIn(self.browser.seconds(), [self.near(t) for t in self.times])

    def test_click_on_an_approach(self):
        rows = self.browser.all('#events tbody tr')
        rows[3].click()
        self.assert_at(self.worst[3])
        self.assertIn('current', rows[3].get_attribute('class'))
        self.assertNotIn('current', rows[0].get_attribute('class'))
        rows[2].find_element('css selector', 'a').send_keys(Keys.ENTER)
        self.browser.drawn()
        self.assert_at(self.worst[2])

    def test_click_on_the_charts(self):
        for chart in '#ttc', '#strip':
            self.browser.click_at(chart + ' .u-over', 0.75)
            self.assertAlmostEqual(self.browser.seconds(), 15, delta=0.15)
            self.browser.click_at(chart + ' .u-over', 0.25)
            self.assertAlmostEqual(self.browser.seconds(), 5, delta=0.15)

    def test_zoom_of_the_charts(self):
        self.browser.press('n')
        self.browser.press('z')  # half of the recording: 1 to 11 s
        for chart in '#ttc', '#strip':
            self.browser.click_at(chart + ' .u-over', 0.5)
            self.assertAlmostEqual(self.browser.seconds(), 6, delta=0.15)
        self.browser.press(Keys.END)  # the charts go along: 10 to 20 s
        self.browser.click_at('#ttc .u-over', 0.5)
        self.assertAlmostEqual(self.browser.seconds(), 15, delta=0.15)
        self.browser.find('#zoom').click()
        self.browser.click_at('#ttc .u-over', 0.5)
        self.assertAlmostEqual(self.browser.seconds(), 10, delta=0.15)

    def test_links(self):
        self.show('#t=13.3')
        self.assert_at(13.3)
        self.browser.script('location.hash = "#t=6.05"')
        self.browser.wait(lambda: self.browser.seconds() == 6.0)  # what was last said then
        for nonsense in '#t=soon', '#events', '#t=1e', '#t=<b>':
            self.show(nonsense)
            self.assert_at(self.worst[0])
        self.show('#t=99')
        self.assert_at(self.times[-1])

    def test_address_follows(self):
        self.browser.press('n')
        self.browser.wait(lambda: self.browser.script('return location.hash') == '#t=%g' % self.worst[1])

    def test_link_of_a_figure(self):
        # At once, so that the address still names this moment when it is left and asked for again.
        self.browser.wait(lambda: self.browser.script('return location.hash') == '#t=%g' % self.worst[0])
        self.browser.script('document.getElementById("forward").click();'
                            'document.querySelector("#figures a").click()')
        self.assert_at(self.worst[0])


if __name__ == '__main__':
    run('report_controls', ReportControls)
