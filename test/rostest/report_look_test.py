#!/usr/bin/env python3
"""What report.html looks like: to everybody, in light and dark, on a phone and on paper."""
import math
import re

import analysis_bags as bags
from browser import PHONE, WIDE, Keys
from report_content_test import waves
from report_test_case import ReportTestCase
from ros_test_case import run

# Okabe and Ito, "Color universal design", 2008.
ORANGE, SKY_BLUE, GREEN = (230, 159, 0), (86, 180, 233), (0, 158, 115)
VERMILLION, PURPLE = (213, 94, 0), (204, 121, 167)
TOLERANCE = 12  # by which a colour may differ
LIGHT, DARK = False, True

# Of the text and of what lies behind it.
COLOURS = '''
const probe = arguments[0];
let behind = probe;
while (getComputedStyle(behind).backgroundColor === 'rgba(0, 0, 0, 0)') behind = behind.parentElement;
return [getComputedStyle(probe).color, getComputedStyle(behind).backgroundColor];
'''

# Elements that stick out of the page, apart from what may be scrolled by itself.
STICKING_OUT = '''
const width = document.documentElement.clientWidth;
return Array.from(document.querySelectorAll('body *')).filter((e) =>
  e.getBoundingClientRect().right > width + 1 && !e.closest('.wide-table, noscript')).map((e) => e.outerHTML.slice(0, 80));
'''


def luminance(colour):
    """Relative luminance of "rgb(r, g, b)", as WCAG 2 has it."""
    parts = [int(part) / 255 for part in re.findall(r'\d+', colour)[:3]]
    red, green, blue = [p / 12.92 if p <= 0.03928 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(a, b):
    lighter, darker = sorted((luminance(a), luminance(b)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def like(a, b, tolerance=TOLERANCE):
    return all(abs(x - y) <= tolerance for x, y in zip(a, b))


class ReportLook(ReportTestCase):
    def open_waves(self, **look):
        self.browser.look(**look)
        self.report(self.write('drive.bag', waves(20)), *bags.STATIC)

    def count(self, selector, colour, begin=0.0):
        """How many pixels of a canvas have the colour; from a share of the width on."""
        return sum(self.browser.rows(selector, colour, TOLERANCE, begin))

    def metre(self):
        """Shares of the scene's width and height that a metre takes: segment 1, the rear of the
        footprint, lies 0.5 m left of its middle."""
        width, height = self.browser.script(
            'const c = document.getElementById("scene"); return [c.width, c.height]')
        row = self.browser.pixels('#scene', [(x / (width - 1), 0.5) for x in range(width // 2)])
        rear = [x for x, pixel in enumerate(row) if like(pixel, GREEN) or like(pixel, SKY_BLUE)]
        self.assertTrue(rear, 'the rear of the footprint is not to be seen')
        pixels = 2 * (width / 2 - sum(rear) / len(rear))
        return pixels / width, pixels / height

    def circle(self, x, y, radius, colour):
        """Share of a circle's points [m], in the footprint's frame, that have the colour."""
        across, along = self.metre()
        points = [(0.5 + across * (x + radius * math.cos(i / 20)), 0.5 - along * (y + radius * math.sin(i / 20)))
                  for i in range(126)]
        inside = [p for p in points if 0 < p[0] < 1 and 0 < p[1] < 1]
        self.assertGreater(len(inside), 60, 'the circle is out of sight')
        return sum(like(pixel, colour) for pixel in self.browser.pixels('#scene', inside)) / len(inside)

    def test_scene_and_ghosts_at_contact(self):
        # 3 m before the front, so contact in 3 s: WARN.
        self.report(self.write('drive.bag', bags.approach(seconds=2)), *bags.STATIC)
        self.assertEqual(self.moment('time to collision'), '3.00 s')
        for name, x, least, most in (('obstacle', 4, 0.35, 0.9), ('ghost', 1, 0.25, 0.9),
                                     ('nothing', 2.5, 0, 0.1)):
            share = self.circle(x, 0, 0.5, ORANGE)
            self.assertTrue(least <= share <= most, '%s: %g is orange' % (name, share))

    def test_ghost_of_a_robot_that_drives(self):
        messages = []
        for i in range(21):
            t = i / 10
            messages += [('/tf', t, bags.transforms(t, x=t)), ('/odom', t, bags.odometry(t, 1.0)),
                         ('/obstacles', t, bags.obstacles(t, [(7, 6.0, 0, 0, 0, 0.5)], 'odom'))]
        self.report(self.write('drive.bag', messages), '--footprint-polygon', bags.SQUARE)
        self.assertEqual(self.moment('time to collision'), '3.00 s')
        across, along = self.metre()
        for name, y in ('left side', 0.5), ('right side', -0.5):
            points = [(0.5 + across * (2.55 + 0.9 * i / 50), 0.5 - along * y) for i in range(51)]
            share = sum(like(p, ORANGE, 60) for p in self.browser.pixels('#scene', points)) / len(points)
            self.assertGreater(share, 0.3, 'its %s 3 m ahead' % name)

    def test_ghost_of_a_robot_that_turns(self):
        speed, turning = 0.3, 0.4
        messages = []
        for i in range(5):
            odometry = bags.odometry(i / 10, speed)
            odometry.twist.twist.angular.z = turning
            messages += [('/odom', i / 10, odometry),
                         ('/obstacles', i / 10, bags.obstacles(i / 10, [(7, 1.6, 0.5, 0, 0, 0.5)]))]
        self.report(self.write('drive.bag', messages), '--footprint-polygon', bags.SQUARE)
        time = bags.summary(self.output)['bags'][0]['smallest_time_to_collision']['time_to_collision']
        angle = turning * time
        self.assertGreater(angle, 0.2)
        place = speed / turning * math.sin(angle), speed / turning * (1 - math.cos(angle))
        across, along = self.metre()
        rear = [(-0.5, 0.4 - i / 50) for i in range(41)]  # of the body, where nothing else is drawn
        points = [(0.5 + across * (place[0] + x * math.cos(angle) - y * math.sin(angle)),
                   0.5 - along * (place[1] + x * math.sin(angle) + y * math.cos(angle))) for x, y in rear]
        share = sum(like(p, VERMILLION, 60) or like(p, ORANGE, 60)
                    for p in self.browser.pixels('#scene', points)) / len(points)
        self.assertGreater(share, 0.3)

    def test_none_has_a_lane_of_its_own_above_the_curve(self):
        self.open_waves()
        rows = self.browser.rows('#ttc canvas', GREEN, TOLERANCE, 0.07)
        lane = [y for y, number in enumerate(rows) if number > 5]
        self.assertTrue(lane)
        self.assertLess(max(lane), 0.25 * len(rows))

    def test_colours_of_the_markers(self):
        self.open_waves()
        for level, colour in ('WARN', ORANGE), ('CRITICAL', VERMILLION), ('CLEAR', GREEN), \
                ('UNKNOWN', PURPLE):
            style = self.browser.script(
                'return getComputedStyle(Array.from(document.querySelectorAll(".shares .chip")).find('
                '(chip) => chip.textContent === arguments[0]), "::before").backgroundColor', level)
            self.assertEqual(tuple(int(p) for p in re.findall(r'\d+', style)[:3]), colour)
        for selector, colours in ('#scene', (VERMILLION,)), \
                ('#strip canvas', (ORANGE, VERMILLION, SKY_BLUE, GREEN)), ('#ttc canvas', (GREEN,)):
            for colour in colours:
                self.assertGreater(self.count(selector, colour), 20, (selector, colour))

    def strip_of(self, messages):
        self.report(self.write('drive.bag', messages), *bags.STATIC)
        return {name: self.count('#strip canvas', colour, begin=0.5)
                for name, colour in (('green', GREEN), ('purple', PURPLE))}

    def test_none_and_unknown_look_different(self):
        none = self.strip_of([('/obstacles', t / 10, bags.obstacles(t / 10)) for t in range(40)])
        self.assertEqual(self.count('#ttc canvas', PURPLE, begin=0.5), 0)
        for frame in '', 'base_link':  # unknown from the begin, or later
            messages = [('/obstacles', t / 10, bags.obstacles(t / 10, [], frame if t < 10 else ''))
                        for t in range(40)]
            unknown = self.strip_of(messages)
            self.assertGreater(unknown['purple'], 300)
            self.assertEqual(unknown['green'], 0)
            self.assertGreater(self.count('#ttc canvas', PURPLE, begin=0.5), 300)
        self.assertGreater(none['green'], 300)
        self.browser.press(Keys.END)
        self.assertGreater(self.count('#scene', PURPLE), 5, 'the footprint of which nothing is known')
        signs = {chip.get_attribute('data-sign') for chip in self.browser.all('.shares .chip')}
        self.assertEqual(len(signs), 4, 'levels differ in more than colour')

    def test_dark_and_light(self):
        self.open_waves()
        for dark in (LIGHT, DARK, LIGHT):  # changes under the open page
            self.browser.look(dark=dark)
            self.browser.drawn()
            ground = self.browser.script(COLOURS, self.browser.find('#verdict'))[1]
            self.assertEqual(luminance(ground) < 0.05, dark, ground)
            corner, = self.browser.pixels('#scene', [(0.003, 0.003)])
            self.assertEqual(corner, (0, 0, 0), 'the scene has no ground of its own')
            for selector in ('#verdict', '#figures p', '#figures h2', '#events td', '#events th', '.hint',
                             '#moment dt', '#moment dd', '#play', '#figures a', '#program'):
                text, behind = self.browser.script(COLOURS, self.browser.find(selector))
                self.assertGreaterEqual(contrast(text, behind), 4.5, (selector, text, behind, dark))
            line = (236, 239, 242) if dark else (22, 25, 29)
            self.assertGreater(self.count('#ttc canvas', line), 20, 'the curve is drawn anew')
        self.assert_clean()

    def test_two_widths(self):
        for width in (WIDE, PHONE):
            self.open_waves(width=width)
            self.assertLessEqual(self.browser.script('return document.documentElement.scrollWidth'), width)
            self.assertEqual(self.browser.script(STICKING_OUT), [])
            for selector in '#scene', '#ttc .u-wrap', '#strip .u-wrap', '#play', '#moment', '#events':
                box = self.browser.find(selector).rect
                self.assertGreater(box['width'], 60, selector)
                self.assertLessEqual(box['x'] + box['width'], width, selector)
            self.browser.press('n', Keys.ARROW_RIGHT)
            self.assert_clean()
        self.assertEqual(self.browser.find('#scene').rect['x'], self.browser.find('#moment').rect['x'],
                         'on a phone one is below the other')

    def test_turning_a_phone(self):
        self.open_waves(width=PHONE)
        self.browser.look(width=800, height=PHONE)
        self.browser.wait(lambda: self.browser.find('#ttc .u-wrap').rect['width'] > 700)
        self.browser.wait(lambda: self.browser.script(
            'const c = document.getElementById("scene"); return c.width === c.clientWidth'))
        self.assertEqual(self.browser.script(STICKING_OUT), [])

    def test_print(self):
        self.open_waves(dark=DARK)
        pdf = self.browser.printed()
        self.assertEqual(pdf[:5], b'%PDF-')
        self.assertIn(len(re.findall(rb'/Type\s*/Page\b', pdf)), (1, 2, 3))
        # Afterwards it is as it was before.
        ground = self.browser.script(COLOURS, self.browser.find('#verdict'))[1]
        self.assertLess(luminance(ground), 0.05)
        self.browser.driver.execute_cdp_cmd('Emulation.setEmulatedMedia', {'media': 'print'})
        for selector in '#play', '#scrub', '#zoom':
            self.assertFalse(self.browser.find(selector).is_displayed(), selector)
        for selector in '#verdict', '#scene', '#ttc', '#strip', '#events':
            self.assertTrue(self.browser.find(selector).is_displayed(), selector)
        self.browser.driver.execute_cdp_cmd('Emulation.setEmulatedMedia', {'media': ''})
        self.assert_clean()


if __name__ == '__main__':
    run('report_look', ReportLook)
