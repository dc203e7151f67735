"""Sensors that go on by themselves while a test does something else."""
import threading

import rospy


class Feed:
    """Calls a function with fresh stamps, 50 times a second, until it is stopped."""

    def __init__(self, send):
        self._send = send
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self):
        while not self._stopped.is_set():
            self.last = self._send(stamp=rospy.Time.now())
            self._stopped.wait(0.02)

    def stop(self):
        """Returns the last stamp sent."""
        self._stopped.set()
        self._thread.join()
        return self.last
