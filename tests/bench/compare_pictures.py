#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares csgcast's pictures with POV-Ray's, pixel by pixel, on the standard scenes.

usage: compare_pictures.py CSGCAST OUTPUT_FOLDER [SCENE ..]      (default: angel die flange flush sponge)

Both draw a scene at 512x512 with one ray a pixel; NAME-pair.png in the output folder has csgcast's picture on the left and
POV-Ray's on the right, NAME-difference.png is white where a compared pixel differs and grey where pixels are not compared.

A pixel is compared if csgcast's picture of ids (the leaf that each ray hits) shows one id in the 3x3 pixels around it and
no shadow edge passes through them. Shadow edges come from a third picture by csgcast: the same solid, black but for a
light so bright that whatever it reaches is white; a shadow edge passes where that picture is not all black or all white.
Neither picture to be judged has a say in what is compared, and shadows that POV-Ray draws elsewhere count as differences.
A pixel differs if a channel does by more than 2 of 255; the last column counts all that do, edges included. Exits with 1 if that is more than 0.1 % on angel, die or flange.
"""
import dataclasses
import os
import struct
import subprocess
import sys
import tempfile
import zlib

import scenes

SIZE = 512
TOLERANCE = 2  # of 255
LARGEST_SHARE = {"angel": 1e-3, "die": 1e-3, "flange": 1e-3}


def paeth(left, up, corner):
    estimate = left + up - corner
    distances = abs(estimate - left), abs(estimate - up), abs(estimate - corner)
    return (left, up, corner)[distances.index(min(distances))]


def unfilter(kind, line, above, step):
    """One row of a PNG, in place: see the PNG specification, clause 9."""
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        up = above[i]
        line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth(left, up, corner))[kind]) & 255


def read_png(path):
    """Rows of (r, g, b) from a PNG with 8 bits a channel, grey or RGB, alpha ignored, not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    position, packed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        chunk = data[position + 8:position + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color_type, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
        elif kind == b"IDAT":
            packed += chunk
        position += length + 12
    channels = {0: 1, 2: 3, 4: 2, 6: 4}.get(color_type)
    if bits != 8 or interlaced or channels is None:
        raise ValueError(f"{path}: only plain PNG files of 8 bits a channel are read")
    raw = zlib.decompress(packed)
    stride = width * channels
    rows, above = [], bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        line = bytearray(raw[start + 1:start + 1 + stride])
        if raw[start]:
            unfilter(raw[start], line, above, channels)
        above = line
        pixels = [line[i:i + channels] for i in range(0, stride, channels)]
        rows.append([(p[0], p[1], p[2]) if channels > 2 else (p[0],) * 3 for p in pixels])
    return rows


def write_png(path, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    raw = b"".join(b"\0" + bytes(value for pixel in row for value in pixel) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9)) +
                   chunk(b"IEND", b""))


def draw_csgcast(program, picture, folder, mode="shaded"):
    scene, image = os.path.join(folder, "scene.csg"), os.path.join(folder, "csgcast.png")
    with open(scene, "w", encoding="utf-8") as file:
        file.write(scenes.csg(picture))
    subprocess.run([program, "render", scene, "-o", image, "--size", f"{SIZE}x{SIZE}", "--mode", mode], check=True)
    return read_png(image)


def draw_pov(picture, folder):
    scene, image = os.path.join(folder, "scene.pov"), os.path.join(folder, "pov.png")
    with open(scene, "w", encoding="utf-8") as file:
        file.write(scenes.pov(picture))
    subprocess.run(["povray", "-GA", f"+I{scene}", f"+O{image}", f"+W{SIZE}", f"+H{SIZE}", "-D", "-A"], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return read_png(image)


def where_light_falls(picture):
    return dataclasses.replace(picture, ambient=0, diffuse=1, specular=0, color=(1, 1, 1), background=(0, 0, 0),
                               brightness=1e9)


def uniform_around(rows, x, y):
    around = (rows[j][i] for j in range(max(y - 1, 0), min(y + 2, SIZE)) for i in range(max(x - 1, 0), min(x + 2, SIZE)))
    return all(pixel == rows[y][x] for pixel in around)


def compare(ours, theirs, ids, lit):
    """How many pixels are compared, how many of these differ, how many differ anywhere; and a picture of those that do."""
    compared = differing = anywhere = 0
    marks = []
    for y in range(SIZE):
        row = []
        for x in range(SIZE):
            differs = max(abs(a - b) for a, b in zip(ours[y][x], theirs[y][x])) > TOLERANCE
            anywhere += differs
            if not (uniform_around(ids, x, y) and uniform_around(lit, x, y)):
                row.append((96, 96, 96))
                continue
            compared += 1
            differing += differs
            row.append((255, 255, 255) if differs else (0, 0, 0))
        marks.append(row)
    return compared, differing, anywhere, marks


def main(arguments):
    if len(arguments) < 2 or any(name not in scenes.SCENES for name in arguments[2:]):
        sys.exit(__doc__.strip())
    program, output = arguments[:2]
    os.makedirs(output, exist_ok=True)
    too_many = []
    print(f"{'scene':10} {'compared':>10} {'differing':>10} {'share':>9} {'anywhere':>10}")
    for name in arguments[2:] or ["angel", "die", "flange", "flush", "sponge"]:
        picture = scenes.SCENES[name]()
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = draw_csgcast(program, picture, folder), draw_pov(picture, folder)
            ids = draw_csgcast(program, picture, folder, "id")
            lit = draw_csgcast(program, where_light_falls(picture), folder)
        compared, differing, anywhere, marks = compare(ours, theirs, ids, lit)
        write_png(os.path.join(output, f"{name}-pair.png"), [a + b for a, b in zip(ours, theirs)])
        write_png(os.path.join(output, f"{name}-difference.png"), marks)
        print(f"{name:10} {compared:10} {differing:10} {differing / compared:9.4%} {anywhere:10}", flush=True)
        if differing > compared * LARGEST_SHARE.get(name, 1):
            too_many.append(name)
    if too_many:
        sys.exit("more pixels differ than may: " + ", ".join(too_many))


if __name__ == "__main__":
    main(sys.argv[1:])
