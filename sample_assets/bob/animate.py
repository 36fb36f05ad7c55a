#!/usr/bin/env python3
"""Writes the moving picture of the project's front page: the sample shaking its head, as an animated PNG.

  sample_assets/bob/animate.py COIF ASSET BODY OUT.png

COIF draws each frame (`coif render --motion turn --time T`); this script only lays the frames one after the other, in one
palette of a few colours, which take a small part of the bytes of all.
"""
import collections
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

# The motion repeats at 1.54 Hz, and after two rounds so does the hair.
FRAMES, SIZE = 13, 256
FIRST, STEP = 2 / 1.54, 1 / 1.54 / FRAMES
COLOURS = 96
VIEW = "35,8"


def chunks(data):
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + length]
        at += 12 + length


def unfiltered(data):
    """Rows of (r, g, b) of an 8-bit PNG with or without alpha."""
    parts = list(chunks(data))
    width, height, depth, kind = struct.unpack(">IIBB", parts[0][1][:10])
    channels = {2: 3, 6: 4}[kind]
    raw = zlib.decompress(b"".join(part for name, part in parts if name == b"IDAT"))
    above, rows, stride = bytearray(width * channels), [], width * channels
    for y in range(height):
        rule, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up = (row[i - channels] if i >= channels else 0), above[i]
            corner = above[i - channels] if i >= channels else 0
            if rule == 1:
                row[i] = row[i] + left & 255
            elif rule == 2:
                row[i] = row[i] + up & 255
            elif rule == 3:
                row[i] = row[i] + (left + up) // 2 & 255
            elif rule == 4:
                near = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))
                row[i] = row[i] + near[2] & 255
        rows.append([tuple(row[x * channels:x * channels + 3]) for x in range(width)])
        above = row
    return rows


def median_cut(counts, wanted):
    """Means of `wanted` boxes of colours, each cut in turn where the one with most pixels and the longest side is longest."""
    def sides(box):
        return [max(c[k] for c in box) - min(c[k] for c in box) for k in range(3)]

    def weight_of(box):  # A face's few hues get more colours than a dark background's many pixels.
        return sum(counts[c] for c in box) * max(sides(box)) ** 2

    boxes = [list(counts)]
    weights = [weight_of(boxes[0])]
    while len(boxes) < wanted:
        at = max((i for i, b in enumerate(boxes) if len(b) > 1), key=lambda i: weights[i], default=None)
        if at is None:
            break
        box = boxes[at]
        axis = max(range(3), key=lambda k: sides(box)[k])
        box.sort(key=lambda c: c[axis])
        half, seen, cut = sum(counts[c] for c in box) / 2, 0, 1
        for i, colour in enumerate(box[:-1], 1):
            seen, cut = seen + counts[colour], i
            if seen >= half:
                break
        boxes.append(box[cut:])
        del box[cut:]
        weights[at] = weight_of(box)
        weights.append(weight_of(boxes[-1]))
    means = []
    for box in boxes:
        weight = sum(counts[c] for c in box)
        means.append(tuple(round(sum(c[k] * counts[c] for c in box) / weight) for k in range(3)))
    return means


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def animated(frames, palette, index_of):
    size = len(frames[0])
    out = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 3, 0, 0, 0))
    out += chunk(b"acTL", struct.pack(">II", len(frames), 0)) + chunk(b"PLTE", b"".join(bytes(c) for c in palette))
    number = 0
    for k, rows in enumerate(frames):
        out += chunk(b"fcTL", struct.pack(">IIIIIHHBB", number, size, size, 0, 0, round(1000 * STEP), 1000, 0, 0))
        packed = zlib.compress(b"".join(b"\0" + bytes(index_of[c] for c in row) for row in rows), 9)
        out += chunk(b"IDAT", packed) if k == 0 else chunk(b"fdAT", struct.pack(">I", number + 1) + packed)
        number += 1 if k == 0 else 2
    return out + chunk(b"IEND", b"")


def main():
    coif, asset, body, out = sys.argv[1:]
    frames = []
    with tempfile.TemporaryDirectory() as place:
        picture = pathlib.Path(place) / "frame.png"
        for k in range(FRAMES):
            subprocess.run([coif, "render", asset, "--body", body, "--view", VIEW, "--size", f"{SIZE}x{SIZE}", "--motion", "turn",
                            "--time", f"{FIRST + k * STEP:.3f}", "-o", picture], check=True, capture_output=True)
            frames.append(unfiltered(picture.read_bytes()))
    counts = collections.Counter(colour for rows in frames for row in rows for colour in row)
    palette = median_cut(counts, COLOURS)
    nearest = {c: min(range(len(palette)), key=lambda i: sum((a - b) ** 2 for a, b in zip(c, palette[i]))) for c in counts}
    pathlib.Path(out).write_bytes(animated(frames, palette, nearest))


main()
