"""Reads the OpenEXR images that `ups render` writes: one part, scan lines, floats, ZIP or no compression.

Called by scripts that show several images at one exposure. The format: openexr.com/en/latest/OpenEXRFileLayout.html.
"""
import struct
import zlib

import numpy as np

NO_COMPRESSION, ZIP = 0, 3
FLOAT = 2


def _text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def _header(data):
    attributes, at = {}, 8
    while data[at] != 0:
        name, at = _text(data, at)
        _, at = _text(data, at)
        size, = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def _channels(data):
    names, at = [], 0
    while data[at] != 0:
        name, at = _text(data, at)
        kind, = struct.unpack_from("<i", data, at)
        if kind != FLOAT:
            raise ValueError(f"channel {name} is not of floats")
        names.append(name)
        at += 16
    return names


def _unzipped(packed, size):
    if len(packed) == size:
        return packed  # larger when compressed, so kept as it was
    delta = np.frombuffer(zlib.decompress(packed), np.uint8).astype(np.int64)
    delta[1:] -= 128
    halves = np.cumsum(delta).astype(np.uint8)
    mixed = np.empty_like(halves)
    mixed[0::2], mixed[1::2] = halves[:(size + 1) // 2], halves[(size + 1) // 2:]
    return mixed.tobytes()


def read_channels(path):
    """(height, channels, width) floats, and the channels' names."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, at = _header(data)
    compression, names = attributes["compression"][0], _channels(attributes["channels"])
    if compression not in (NO_COMPRESSION, ZIP):
        raise ValueError(f"{path}: compression {compression} is not read here")
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height, block = x1 - x0 + 1, y1 - y0 + 1, 16 if compression == ZIP else 1
    image = np.empty((height, len(names), width), np.float32)
    for offset in struct.unpack_from(f"<{-(-height // block)}Q", data, at):
        y, length = struct.unpack_from("<ii", data, offset)
        rows = min(block, y1 + 1 - y)
        size = 4 * rows * len(names) * width
        packed = data[offset + 8:offset + 8 + length]
        values = np.frombuffer(packed if compression == NO_COMPRESSION else _unzipped(packed, size), "<f4")
        image[y - y0:y - y0 + rows] = values.reshape(rows, len(names), width)
    return image, names


def read_rgb(path):
    """(height, width, 3) floats."""
    return read_layers(path)[""]


def read_layers(path):
    """(height, width, 3) floats of each layer that has R, G, B, by its name; "" is the image itself."""
    image, names = read_channels(path)
    layers = [name[:-1].removesuffix(".") for name in names if name.rpartition(".")[2] == "R"]

    def colour(layer):
        prefix = layer + "." if layer else ""
        return image[:, [names.index(prefix + c) for c in "RGB"]].transpose(0, 2, 1)

    return {layer: colour(layer) for layer in layers}
