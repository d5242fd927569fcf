# SPDX-License-Identifier: MIT
"""Reads the EXR files that csgcast writes: floats of 32 bits, ZIP, lines from the top. The format: OpenEXR's "File Layout"."""
import array
import itertools
import struct
import sys
import zlib

MAGIC = 20000630
ZIP, LINES = 3, 16  # the number of the compression, and the lines that it packs together


def header(data):
    """Attributes by name, and where what follows them starts."""
    attributes, at = {}, 8
    while data[at]:
        name_end = data.index(0, at)
        kind_end = data.index(0, name_end + 1)
        size, = struct.unpack_from("<I", data, kind_end + 1)
        start = kind_end + 5
        attributes[data[at:name_end].decode()] = data[start:start + size]
        at = start + size
    return attributes, at + 1


def channel_names(channels):
    names, at = [], 0
    while channels[at]:
        end = channels.index(0, at)
        if struct.unpack_from("<I", channels, end + 1)[0] != 2:
            raise ValueError("only floats are read")
        names.append(channels[at:end].decode())
        at = end + 17
    return names


def unpacked(packed, size):
    """Bytes were split into those of even and odd places, and each replaced by its difference from the one before, plus 128."""
    if len(packed) == size:
        return packed
    sums = bytes(itertools.accumulate(zlib.decompress(packed), lambda before, step: (before + step - 128) & 255))
    result = bytearray(size)
    result[0::2], result[1::2] = sums[:(size + 1) // 2], sums[(size + 1) // 2:]
    return bytes(result)


def read(path):
    """Width, height, and by channel its floats: rows from the top, pixels from the left."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, at = header(data)
    if struct.unpack_from("<I", data)[0] != MAGIC or attributes["compression"][0] != ZIP:
        raise ValueError(f"{path} is no EXR file as csgcast writes them")
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    names = channel_names(attributes["channels"])
    channels = {name: array.array("f") for name in names}
    blocks = -(-height // LINES)
    for offset in struct.unpack_from(f"<{blocks}Q", data, at):
        y, size = struct.unpack_from("<iI", data, offset)
        lines = min(LINES, bottom + 1 - y)
        floats = array.array("f", unpacked(data[offset + 8:offset + 8 + size], 4 * width * len(names) * lines))
        if sys.byteorder == "big":
            floats.byteswap()
        for line in range(lines):
            for i, name in enumerate(names):
                start = (line * len(names) + i) * width
                channels[name].extend(floats[start:start + width])
    return width, height, channels
