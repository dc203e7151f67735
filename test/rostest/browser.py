"""A headless Chromium that shows report.html, and what a test wants to know of it."""
import base64
import json
import os
import shutil
import unittest

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    webdriver = Keys = None

TIMEOUT = 30  # [s] for what follows at once on an idle machine
WIDE = 1280
PHONE = 390
MISSING = [program for program in ('chromium', 'chromedriver') if not shutil.which(program)] + (
    [] if webdriver else ['python3-selenium'])

needs_browser = unittest.skipIf(MISSING, 'not installed: ' + ', '.join(MISSING))

# Resolves once what has been asked for is drawn.
DRAWN = 'const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));'

# A copy, since reading from a canvas changes how the browser keeps it.
_IMAGE = '''
const canvas = document.querySelector(arguments[0]);
const copy = document.createElement('canvas');
const [width, height] = [copy.width, copy.height] = [canvas.width, canvas.height];
const pen = copy.getContext('2d', {willReadFrequently: true});
pen.drawImage(canvas, 0, 0);
const data = pen.getImageData(0, 0, width, height).data;
const at = (x, y) => Array.from(data.slice(4 * (y * width + x), 4 * (y * width + x) + 3));
'''

# The colours [r, g, b] at points that are given in shares of the canvas's size.
PIXELS = _IMAGE + '''
return arguments[1].map(([x, y]) => at(Math.round(x * (width - 1)), Math.round(y * (height - 1))));
'''

# How many pixels of each row have a colour, from a share of the width on.
ROWS = _IMAGE + '''
const [, colour, tolerance, begin] = arguments;
const rows = [];
for (let y = 0; y < height; ++y) {
  rows.push(0);
  for (let i = 4 * (y * width + Math.round(begin * width)); i < 4 * (y + 1) * width; i += 4)
    rows[y] += colour.every((c, k) => Math.abs(c - data[i + k]) <= tolerance);
}
return rows;
'''


def _options():
    options = webdriver.ChromeOptions()
    for argument in ('--headless=new', '--disable-gpu', '--disable-dev-shm-usage'):
        options.add_argument(argument)
    if os.geteuid() == 0:
        options.add_argument('--no-sandbox')
    options.set_capability('goog:loggingPrefs', {'browser': 'ALL', 'performance': 'ALL'})
    return options


class Browser:
    def __init__(self):
        self.driver = webdriver.Chrome(service=Service(shutil.which('chromedriver')),
                                       options=_options())
        self.driver.set_script_timeout(TIMEOUT)

    def close(self):
        self.driver.quit()

    def look(self, width=WIDE, height=900, dark=False):
        """As which the next pages are shown; the one that is open changes too."""
        self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {
            'width': width, 'height': height, 'deviceScaleFactor': 1, 'mobile': width < 500})
        self.driver.execute_cdp_cmd('Emulation.setEmulatedMedia', {'features': [
            {'name': 'prefers-color-scheme', 'value': 'dark' if dark else 'light'}]})

    def open(self, path, fragment=''):
        """Shows the page and waits until it says that it is ready."""
        self.driver.get('about:blank')
        self.driver.get_log('browser'), self.driver.get_log('performance')  # of the page before
        self.driver.get('file://%s%s' % (path, fragment))
        self.wait(lambda: self.script('return document.documentElement.dataset.ready') == 'yes')
        self.drawn()

    def wait(self, condition):
        WebDriverWait(self.driver, TIMEOUT, poll_frequency=0.02).until(lambda _: condition())

    def drawn(self):
        self.driver.execute_async_script(DRAWN)

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def find(self, selector):
        return self.driver.find_element('css selector', selector)

    def all(self, selector):
        return self.driver.find_elements('css selector', selector)

    def text(self, selector):
        return self.find(selector).text

    def press(self, *keys):
        self.find('body').send_keys(*keys)
        self.drawn()

    def click_at(self, selector, x, y=0.5):
        """A real click on a place given in shares of the element's size."""
        self.script('arguments[0].scrollIntoView({block: "center"})', self.find(selector))
        box = self.script('return arguments[0].getBoundingClientRect().toJSON()', self.find(selector))
        place = {'x': box['left'] + x * box['width'], 'y': box['top'] + y * box['height'],
                 'button': 'left', 'clickCount': 1}
        for kind in 'mouseMoved', 'mousePressed', 'mouseReleased':
            self.driver.execute_cdp_cmd('Input.dispatchMouseEvent', dict(place, type=kind))
        self.drawn()

    def seconds(self):
        """The moment that is shown."""
        # At one stroke: while it plays, the elements are replaced all the time.
        return float(self.script('return document.getElementById("clock").textContent').split()[0])

    def pixels(self, selector, points):
        return [tuple(pixel) for pixel in self.script(PIXELS, selector, points)]

    def rows(self, selector, colour, tolerance, begin):
        """Of each row of a canvas, how many pixels have the colour."""
        return self.script(ROWS, selector, colour, tolerance, begin)

    def complaints(self):
        """Everything on the console since the page was opened."""
        return [entry['message'] for entry in self.driver.get_log('browser')]

    def requests(self):
        """Addresses that the page asked for, its own included."""
        messages = [json.loads(entry['message'])['message']
                    for entry in self.driver.get_log('performance')]
        return [message['params']['request']['url'] for message in messages
                if message['method'] == 'Network.requestWillBeSent']

    def printed(self):
        """The bytes of the page as PDF."""
        made = self.driver.execute_cdp_cmd('Page.printToPDF', {'printBackground': False})
        return base64.b64decode(made['data'])

    def data(self):
        """The JSON in the page."""
        return json.loads(self.script('return document.getElementById("data").textContent'))
