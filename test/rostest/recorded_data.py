"""Recorded input, where there is any: in FCP_RECORDED_DATA, else beside the package."""
import os
import subprocess

from node_testing import wait_until

_HERE = os.path.dirname(os.path.realpath(__file__))
FOLDER = os.path.realpath(os.environ.get('FCP_RECORDED_DATA') or
                          os.path.join(_HERE, '..', '..', '..', 'shared', 'data'))

PLAYING = 300.0  # [s] and answering all of it, at most


def recording(test_case, name):
    """Path of the bag; the test is skipped when it is not there."""
    path = os.path.join(FOLDER, name)
    if not os.path.isfile(path):
        test_case.skipTest('no %s in %s (FCP_RECORDED_DATA)' % (name, FOLDER))
    return path


def play_until(done, what, path, topics, *options):
    """Plays with the clock, when its subscribers are there, until done(). Not until the player ends:
    that takes with it what it has not sent yet, and the clock stops short of the last message."""
    command = ['rosbag', 'play', '--quiet', '--clock', '--hz', '1000', '--wait-for-subscribers',
               '--keep-alive', '--queue', '10000', *options, path, '--topics', *topics]
    player = subprocess.Popen(command, stdin=subprocess.DEVNULL)
    try:
        wait_until(lambda: done() or player.poll() is not None, what, PLAYING)
        if player.poll() is not None:
            raise AssertionError('rosbag play ended with exit status %d' % player.poll())
    finally:
        player.terminate()
        player.wait()
