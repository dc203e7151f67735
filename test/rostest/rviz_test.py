#!/usr/bin/env python3
"""What a person sees in RViz: the right colours at once, no flicker, and nothing of a dead node.

RVIZ_PICTURE=/path/name.png keeps a picture.
"""
import os
import shutil
import subprocess
import time
import unittest

from node_testing import BOX, PACKAGE, TIMEOUT, circle
from roslib.packages import get_pkg_dir
from rospkg import get_test_results_dir
from ros_test_case import RosTestCase, run
from virtual_display import VirtualDisplay

SHOTS = 50
ENOUGH = 100  # pixels of a colour: more than any letter or edge has by chance
ROUNDING = 2  # by which a colour on the screen may differ
GREY, GREEN, BLUE = (153, 153, 153), (0, 158, 115), (86, 180, 233)
PURPLE, ORANGE, VERMILLION = (204, 121, 167), (230, 159, 0), (213, 94, 0)
ALL = {GREY, GREEN, BLUE, PURPLE, ORANGE, VERMILLION}
MISSING = [program for program in ('rviz', 'Xvfb') if not shutil.which(program)]

# The front is touched in 1 s, the left side in 2 s, the right one in 4 s, the rear and somebody
# aside never.
SCENE = [circle(1, (1.5, 0), (-0.3, 0), 0.2), circle(2, (0, 0.9), (0, -0.1), 0.2),
         circle(3, (0, -1.1), (0, 0.1), 0.2), circle(4, (-2, 1.5), (0, 0), 0.3)]


def launched(display, *arguments):
    """Names of the nodes that predictor.launch would start."""
    environment = dict(os.environ, DISPLAY=display)
    output = subprocess.check_output(
        ['roslaunch', '--nodes', PACKAGE, 'predictor.launch'] + list(arguments), env=environment,
        universal_newlines=True)
    return sorted(name.split('_')[0] for name in output.split())


def palette(shot):
    """Number of pixels by colour of the palette."""
    colours = shot.colours().items()
    return {colour: sum(number for seen, number in colours
                        if all(abs(a - b) <= ROUNDING for a, b in zip(colour, seen)))
            for colour in ALL}


class Rviz(RosTestCase):
    def show(self, node):
        """RViz with the shipped configuration, on a display of its own."""
        display = VirtualDisplay(1200, 750)
        self.addCleanup(display.close)
        config = os.path.join(get_pkg_dir(PACKAGE), 'config', 'predictor.rviz')
        rviz = subprocess.Popen(
            ['rviz', '-d', config, '-f', 'base_link', '__ns:=' + node.namespace],
            env=display.environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(rviz.wait, TIMEOUT)
        self.addCleanup(rviz.kill)
        return display

    def wait_for_colours(self, display, expected, timeout=TIMEOUT):
        """Until those of the palette are seen, and no others."""
        end = time.monotonic() + timeout
        while True:
            shot = display.shot()
            pixels = palette(shot)
            if {colour for colour in ALL if pixels[colour] >= ENOUGH} == expected:
                return
            if time.monotonic() > end:
                path = os.path.join(get_test_results_dir(), 'rviz_test.png')
                shot.save(path)
                self.fail('waited %g s in vain for the colours %s; there are %s, see %s' %
                          (timeout, sorted(expected), pixels, path))
            time.sleep(0.03)  # a frame

    @unittest.skipIf(MISSING, 'not installed: ' + ', '.join(MISSING))
    def test_picture(self):
        # When the data of this test are late, it is right that they look unknown.
        node = self.rig(footprint=BOX, ego_motion='static', max_data_age=5.0)
        feed = self.feed(lambda stamp: node.send(SCENE, stamp=stamp))
        display = self.show(node)
        self.wait_for_colours(display, ALL - {PURPLE})
        self.check_steady(display)
        if 'RVIZ_PICTURE' in os.environ:
            display.shot().save(os.environ['RVIZ_PICTURE'])
        # Without data nothing is known; what was drawn is gone although the node lives.
        feed.stop()
        self.wait_for_colours(display, {PURPLE})
        node.process.kill()
        self.wait_for_colours(display, set(), timeout=5)

    def check_steady(self, display):
        """In every shot there is about as much of each colour.

        On a busy machine the data may be half a second late, so that WARN turns CRITICAL for a
        moment; so these count together.
        """
        shots = []
        while len(shots) < SHOTS:
            shots.append(palette(display.shot()))
            time.sleep(0.03)  # a frame
        for colours in (GREY,), (GREEN,), (BLUE, ORANGE, VERMILLION):
            numbers = sorted(sum(shot[colour] for colour in colours) for shot in shots)
            self.assertGreater(numbers[0], 0.5 * numbers[SHOTS // 2],
                               '%s flickers: %s' % (colours, numbers))

    def test_launch_argument(self):
        for display, argument, with_rviz in (('', 'auto', False), (':9', 'auto', True),
                                             ('', 'true', True), (':9', 'false', False)):
            nodes = launched(display, 'rviz:=' + argument)
            self.assertEqual(nodes, ['/predictor'] + ['/rviz'] * with_rviz,
                             'display "%s", rviz:=%s' % (display, argument))
        self.assertEqual(launched(':9'), ['/predictor'], 'on a robot only when asked for')


if __name__ == '__main__':
    run('rviz', Rviz)
