"""A display in memory (Xvfb), of which pictures are taken without any further program."""
import collections
import mmap
import os
import shutil
import struct
import subprocess
import tempfile
import zlib


class VirtualDisplay:
    """Ended by close()."""

    def __init__(self, width, height):
        self._folder = tempfile.mkdtemp()
        reader, writer = os.pipe()
        self._process = subprocess.Popen(
            ['Xvfb', '-displayfd', str(writer), '-fbdir', self._folder, '-nolisten', 'tcp',
             '-screen', '0', '%dx%dx24' % (width, height)],
            pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as file:
            self.name = ':' + file.readline().strip()  # once it is ready
        with open(os.path.join(self._folder, 'Xvfb_screen0'), 'rb') as file:
            self._memory = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        # The format of xwd: a header, a colour map, then lines of 4 bytes (B G R -) a pixel.
        header = struct.unpack('>25I', self._memory[:100])
        self.width, self.height, self._line = header[4], header[5], header[12]
        self._start = header[0] + 12 * header[19]

    def environment(self):
        return dict(os.environ, DISPLAY=self.name, LIBGL_ALWAYS_SOFTWARE='1',
                    QT_X11_NO_MITSHM='1', XDG_RUNTIME_DIR=self._folder)

    def shot(self):
        return Shot(self.width, self.height, self._line,
                    self._memory[self._start:self._start + self._line * self.height])

    def close(self):
        self._process.terminate()
        self._process.wait()
        self._memory.close()
        shutil.rmtree(self._folder, ignore_errors=True)


class Shot:
    def __init__(self, width, height, line, pixels):
        self._width, self._height, self._line, self._pixels = width, height, line, pixels

    def colours(self):
        """Number of pixels by (red, green, blue)."""
        counted = collections.Counter(memoryview(self._pixels).cast('I'))
        result = collections.Counter()
        for pixel, number in counted.items():
            result[pixel >> 16 & 255, pixel >> 8 & 255, pixel & 255] += number
        return result

    def save(self, path):
        """As PNG."""
        rows = bytearray()
        for y in range(self._height):
            row = self._pixels[y * self._line:y * self._line + 4 * self._width]
            rgb = bytearray(3 * self._width)
            rgb[0::3], rgb[1::3], rgb[2::3] = row[2::4], row[1::4], row[0::4]
            rows += b'\0' + rgb
        header = struct.pack('>2I5B', self._width, self._height, 8, 2, 0, 0, 0)
        with open(path, 'wb') as file:
            file.write(b'\x89PNG\r\n\x1a\n')
            for kind, data in ((b'IHDR', header), (b'IDAT', zlib.compress(rows, 9)), (b'IEND', b'')):
                file.write(struct.pack('>I', len(data)) + kind + data +
                           struct.pack('>I', zlib.crc32(kind + data)))
