"""PNG bytes of an 8-bit RGB image, for the textures that the sample scenes carry inside their .glb files; sRGB.

Called by the scene generators, and by scripts that show images. Only zlib is needed, and the bytes are the same on
every machine with the same zlib.
"""
import struct
import zlib

import numpy as np


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _filtered(rows):
    """The five PNG filters of every row; the one with the least sum of absolute differences is kept (PNG 12.8)."""
    height, width, channels = rows.shape
    flat = rows.reshape(height, width * channels).astype(np.int16)
    left = np.zeros_like(flat)
    left[:, channels:] = flat[:, :-channels]
    up = np.zeros_like(flat)
    up[1:] = flat[:-1]
    corner = np.zeros_like(flat)
    corner[1:, channels:] = flat[:-1, :-channels]
    estimate = left + up - corner
    away = np.abs(np.stack([estimate - left, estimate - up, estimate - corner]))
    paeth = np.choose(np.argmin(away, axis=0), [left, up, corner])
    candidates = np.stack([flat, flat - left, flat - up, flat - (left + up) // 2, flat - paeth]).astype(np.uint8)
    cost = np.abs(candidates.view(np.int8).astype(np.int32)).sum(axis=2)
    best = np.argmin(cost, axis=0)
    lines = candidates[best, np.arange(height)]
    return np.concatenate([best.astype(np.uint8)[:, None], lines], axis=1).tobytes()


def encode(image):
    """`image`: (height, width, 3) uint8, first row at the top."""
    image = np.asarray(image)
    if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] != 3:
        raise ValueError(f"an RGB image of bytes is wanted, got {image.dtype} {image.shape}")
    height, width, _ = image.shape
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header)
            + _chunk(b"IDAT", zlib.compress(_filtered(image), 9)) + _chunk(b"IEND", b""))


def srgb(linear):
    """Linear values, cut to [0, 1], as sRGB values there (IEC 61966-2-1)."""
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.power(linear, 1 / 2.4) - 0.055)


def srgb_bytes(linear):
    return linear_bytes(srgb(linear))


def linear_bytes(values):
    return np.floor(np.clip(values, 0.0, 1.0) * 255 + 0.5).astype(np.uint8)
