"""Two machines joined by a cable, in network namespaces; and programs on them.

Run as a program it is such a program: machines.py tracker | observer, which print what they see.
"""
import json
import os
import shutil
import subprocess
import sys
import threading
import time

TIMEOUT = 30.0  # [s]


def run_ip(*arguments):
    subprocess.run(('ip',) + arguments, check=True, stderr=subprocess.PIPE)


def missing():
    """Why there can be no namespaces here; nothing when there can."""
    if not shutil.which('ip'):
        return 'ip (iproute2) is not installed'
    if os.geteuid() != 0:
        return 'network namespaces need root'
    name = 'fcp_try_%d' % os.getpid()
    try:
        run_ip('netns', 'add', name)
        run_ip('-n', name, 'link', 'add', 'fcp0', 'type', 'veth', 'peer', 'name', 'fcp1')
    except subprocess.CalledProcessError as error:
        return 'network namespaces are not permitted here: %s' % error.stderr.decode().strip()
    finally:
        subprocess.run(['ip', 'netns', 'del', name], stderr=subprocess.DEVNULL)
    return None


class Machine:
    def __init__(self, number, master='10.77.0.1'):
        self.address = '10.77.0.%d' % number
        self.device = 'fcp%d' % number
        self.name = 'fcp_%d_%d' % (os.getpid(), number)
        self._environment = dict(os.environ, ROS_IP=self.address,
                                 ROS_MASTER_URI='http://%s:11311' % master)
        run_ip('netns', 'add', self.name)
        run_ip('-n', self.name, 'link', 'set', 'lo', 'up')

    def connect(self):
        run_ip('-n', self.name, 'addr', 'add', self.address + '/24', 'dev', self.device)
        self.ip('link', 'set', self.device, 'up')

    def ip(self, *arguments):
        run_ip('-n', self.name, *arguments)

    def start(self, *command, **options):
        return subprocess.Popen(('ip', 'netns', 'exec', self.name) + command,
                                env=self._environment, **options)

    def remove(self):
        run_ip('netns', 'del', self.name)


class Cable:
    """Between two machines; a cut one swallows everything without a word, or is seen to be out."""

    def __init__(self, *machines):
        self._machines = machines
        a, b = machines
        run_ip('link', 'add', a.device, 'netns', a.name, 'type', 'veth', 'peer', 'name', b.device,
               'netns', b.name)
        a.connect()
        b.connect()

    def swallow(self):
        for machine, other in zip(self._machines, self._machines[::-1]):
            machine.ip('neigh', 'replace', other.address, 'lladdr', '02:00:00:00:00:01', 'dev',
                       machine.device, 'nud', 'permanent')

    def stop_swallowing(self):
        for machine, other in zip(self._machines, self._machines[::-1]):
            machine.ip('neigh', 'del', other.address, 'dev', machine.device)

    def pull(self):
        self._machines[0].ip('link', 'set', self._machines[0].device, 'down')

    def plug(self):
        self._machines[0].ip('link', 'set', self._machines[0].device, 'up')


class Report:
    """The lines that a program on a machine prints: JSON objects."""

    def __init__(self, machine, what):
        self.lines = []
        self._condition = threading.Condition()
        self._process = machine.start(sys.executable, os.path.abspath(__file__), what,
                                      stdout=subprocess.PIPE, universal_newlines=True)
        self._thread = threading.Thread(target=self._read)
        self._thread.start()

    def _read(self):
        for line in self._process.stdout:
            if not line.startswith('{'):  # rospy's own, while the master is not there yet
                continue
            with self._condition:
                self.lines.append(json.loads(line))
                self._condition.notify_all()

    def wait_for(self, predicate, what, since=0):
        """The first line from `since` on for which the predicate holds."""
        end = time.monotonic() + TIMEOUT
        with self._condition:
            while True:
                for line in self.lines[since:]:
                    if predicate(line):
                        return line
                if not self._condition.wait(end - time.monotonic()):
                    raise AssertionError('waited %g s in vain for %s; the last: %s' %
                                         (TIMEOUT, what, self.lines[-3:]))

    def close(self):
        self._process.kill()
        self._process.wait()
        self._thread.join()


def tell(**values):
    print(json.dumps(values) + '\n', end='', flush=True)  # at once: others print, too


def run_tracker():
    """Nothing is near, 50 times a second; commands go through the guard, and come back or not."""
    import rospy
    from footprint_collision_predictor.msg import ObstacleArray
    from geometry_msgs.msg import Twist
    rospy.init_node('tracker')
    obstacles = rospy.Publisher('obstacles', ObstacleArray, queue_size=1, tcp_nodelay=True)
    commands = rospy.Publisher('cmd_vel_in', Twist, queue_size=1, tcp_nodelay=True)
    rospy.Subscriber('cmd_vel', Twist, lambda t: tell(going=t.linear.x == 1, sent=t.linear.z))
    while not rospy.is_shutdown():
        message = ObstacleArray()
        message.header.frame_id = 'base_link'
        message.header.stamp = rospy.Time.now()
        obstacles.publish(message)
        command = Twist()
        command.linear.x, command.linear.z = 1, time.time()
        commands.publish(command)
        time.sleep(0.02)


def run_observer():
    import rospy
    from footprint_collision_predictor.msg import CollisionWarning
    rospy.init_node('observer')
    rospy.Subscriber('collision_warning', CollisionWarning,
                     lambda w: tell(level=w.level, reason=w.reason, seen=time.time()))
    rospy.spin()


if __name__ == '__main__':
    {'tracker': run_tracker, 'observer': run_observer}[sys.argv[1]]()
