"""Messages as bytes, right or wrong, and what they cost."""
import io
import struct

import genpy
import rospy


def raw(message_class):
    """Published as that type, but what goes over the wire is just these bytes."""
    class Raw(genpy.Message):
        __slots__ = ['data']
        _slot_types = ['string']
        _type, _md5sum = message_class._type, message_class._md5sum
        _full_text, _has_header = message_class._full_text, False

        def serialize(self, buff):
            buff.write(self.data)

        def deserialize(self, data):
            self.data = data
            return self
    return Raw


def serialized(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def stamped(message):
    message.header.frame_id, message.header.stamp = 'base_link', rospy.Time.now()
    return message


def with_lie(data, offset, lie):
    return data[:offset] + struct.pack('<I', lie) + data[offset + 4:]


def resident_memory(process):
    with open('/proc/%d/statm' % process.pid) as file:
        return 4096 * int(file.read().split()[1])


def peak_memory(process):
    """The most that it has had so far [bytes]."""
    with open('/proc/%d/status' % process.pid) as file:
        return next(1024 * int(line.split()[1]) for line in file if line.startswith('VmHWM'))
