"""The entries of one node in /diagnostics."""
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from node_testing import NODE, Recorder

OK, WARN, ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR


class DiagnosticsReader:
    def __init__(self, namespace, node=NODE):
        self._prefix = namespace[1:] + '/' + node + ': '
        self._recorder = Recorder('/diagnostics', DiagnosticArray)
        self.close = self._recorder.close

    def _named(self, message, name):
        for status in message.status:
            if status.name == self._prefix + name:
                return status
        return None

    def wait_for(self, name, condition, what='a status', since=0):
        """The first entry of that name for which the condition holds."""
        def matches(message):
            status = self._named(message, name)
            return status is not None and condition(status)
        found = self._recorder.wait_for(matches, '%s of %s' % (what, name), since)
        return self._named(found, name)

    def next(self, name):
        return self.wait_for(name, lambda s: True, since=self._recorder.mark())

    def mark(self):
        return self._recorder.mark()

    def all(self):
        """Every entry of this node so far."""
        return [status for message in self._recorder.messages for status in message.status
                if status.name.startswith(self._prefix)]


def values(status):
    return {item.key: item.value for item in status.values}
