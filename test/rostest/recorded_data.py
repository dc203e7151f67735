"""Recorded input, where there is any: in FCP_RECORDED_DATA, else beside the package."""
import os
import subprocess

_HERE = os.path.dirname(os.path.realpath(__file__))
FOLDER = os.path.realpath(os.environ.get('FCP_RECORDED_DATA') or
                          os.path.join(_HERE, '..', '..', '..', 'shared', 'data'))


def recording(test_case, name):
    """Path of the bag; the test is skipped when it is not there."""
    path = os.path.join(FOLDER, name)
    if not os.path.isfile(path):
        test_case.skipTest('no %s in %s (FCP_RECORDED_DATA)' % (name, FOLDER))
    return path


def play(test_case, path, topics, *options):
    """Starts the player, which waits for its subscribers; ended with the test."""
    command = ['rosbag', 'play', '--quiet', '--clock', '--hz', '1000', '--wait-for-subscribers',
               '--queue', '10000',  # a machine that is busy for a moment loses nothing
               *options, path, '--topics', *topics]
    player = subprocess.Popen(command, stdin=subprocess.DEVNULL)

    def end():
        if player.poll() is None:
            player.terminate()
        player.wait()

    test_case.addCleanup(end)
    return player
