"""Textures of the bathroom: glazed wall tiles, hexagonal floor tiles, oak. Each repeats without a seam.

Called by make_bathroom.py. Random numbers come from fixed seeds. Colours are linear reflectances until they are
written; normals are tangent-space, x right, y up.
"""
import numpy as np

from png import encode, linear_bytes, srgb_bytes

WALL_PERIOD_M = (0.8, 0.8)   # what one image covers
FLOOR_PERIOD_M = (0.96, 0.96 * 3 ** 0.5 / 2)
OAK_PERIOD_M = (0.8, 0.4)


def _pixel_centres(size, period):
    """x to the right and y upwards, metres, for an image whose first row is the top."""
    width, height = size
    x = (np.arange(width) + 0.5) / width * period[0]
    y = (height - np.arange(height) - 0.5) / height * period[1]
    return np.meshgrid(x, y)


def _normal_image(slope_x, slope_y):
    """From the slopes dz/dx and dz/dy of the surface."""
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], -1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return encode(linear_bytes(normal * 0.5 + 0.5))


def _tile_images(distance, outward_x, outward_y, tile, shade, rng, grout_half, bevel, roughness, grout_colour):
    """Colour, roughness and normal images of flat tiles with rounded edges.

    `distance` of each pixel to the middle of the joint, `outward`: unit vector to the nearest joint, `tile`: its
    number, `shade`: reflectance of each tile.
    """
    grout = distance < grout_half
    colour = np.where(grout[..., None], np.asarray(grout_colour), shade[tile])
    rough = np.where(grout, 0.85, roughness)
    # glTF reads roughness from green and metallic from blue.
    packed = np.stack([np.zeros_like(rough), rough, np.zeros_like(rough)], -1)
    edge = np.clip((grout_half + bevel - distance) / bevel, 0, 1)
    fall = np.where(grout, 0.0, -0.45 * edge ** 2)
    tilt = rng.normal(0, 0.004, (len(shade), 2))  # hand-set tiles are not quite level: reflections break at the joints
    lean = np.where(grout[..., None], 0.0, tilt[tile])
    return (encode(srgb_bytes(colour)), encode(linear_bytes(packed)),
            _normal_image(fall * outward_x + lean[..., 0], fall * outward_y + lean[..., 1]))


def wall_tiles():
    """Tiles of 200 mm x 100 mm in running bond, glazed white."""
    size, columns, rows = (512, 512), 4, 8
    x, y = _pixel_centres(size, WALL_PERIOD_M)
    tile_w, tile_h = WALL_PERIOD_M[0] / columns, WALL_PERIOD_M[1] / rows
    row = np.floor(y / tile_h).astype(int)
    shifted = x / tile_w + 0.5 * (row % 2)
    column = np.floor(shifted).astype(int) % columns
    u, v = (shifted % 1 - 0.5) * tile_w, (y / tile_h - row - 0.5) * tile_h
    to_side, to_level = tile_w / 2 - np.abs(u), tile_h / 2 - np.abs(v)
    sideways = to_side < to_level
    rng = np.random.default_rng(7)
    shade = np.array([0.80, 0.79, 0.765]) * (1 + rng.uniform(-0.03, 0.02, (columns * rows, 1)))
    return _tile_images(np.minimum(to_side, to_level), np.where(sideways, np.sign(u), 0.0),
                        np.where(sideways, 0.0, np.sign(v)), row * columns + column, shade, rng,
                        grout_half=0.0016, bevel=0.004, roughness=0.09, grout_colour=(0.55, 0.54, 0.52))


def floor_tiles():
    """Hexagonal tiles 120 mm across, matt greys with a few dark ones."""
    size, columns, rows = (512, 448), 8, 8
    x, y = _pixel_centres(size, FLOOR_PERIOD_M)
    across = FLOOR_PERIOD_M[0] / columns
    row_step = FLOOR_PERIOD_M[1] / rows
    best = np.full(x.shape, np.inf)
    tile = np.zeros(x.shape, int)
    offset_x, offset_y = np.zeros_like(x), np.zeros_like(x)
    for r in range(-1, rows + 2):
        for c in range(-1, columns + 2):
            dx = x - (c + 0.5 * (r % 2)) * across
            dy = y - r * row_step
            closer = dx ** 2 + dy ** 2 < best
            best = np.where(closer, dx ** 2 + dy ** 2, best)
            tile = np.where(closer, (r % rows) * columns + c % columns, tile)
            offset_x, offset_y = np.where(closer, dx, offset_x), np.where(closer, dy, offset_y)
    angle = np.arange(6) * np.pi / 3
    reach = np.stack([offset_x * np.cos(a) + offset_y * np.sin(a) for a in angle])
    side = np.argmax(reach, axis=0)
    rng = np.random.default_rng(11)
    grey = np.where(rng.random(columns * rows) < 0.16, 0.10, rng.uniform(0.26, 0.38, columns * rows))
    shade = grey[:, None] * np.array([1.0, 0.99, 0.96])
    return _tile_images(across / 2 - reach.max(axis=0), np.cos(angle)[side], np.sin(angle)[side], tile, shade, rng,
                        grout_half=0.0018, bevel=0.003, roughness=0.32, grout_colour=(0.20, 0.20, 0.19))


def oak():
    """Oak with the grain along u: colour alone."""
    size = (256, 256)
    x, y = _pixel_centres(size, OAK_PERIOD_M)
    rng = np.random.default_rng(3)
    height = y / OAK_PERIOD_M[1]
    along = x / OAK_PERIOD_M[0]
    grain = np.zeros_like(x)
    for frequency in (5, 9, 16, 31, 53, 90):
        phase, sway = rng.uniform(0, 2 * np.pi, 2)
        bend = 0.5 * np.sin(2 * np.pi * along + sway)  # whole periods in both directions: no seam
        grain += np.sin(2 * np.pi * frequency * height + phase + bend * 9 / frequency ** 0.5) / frequency ** 0.4
    grain /= np.abs(grain).max()
    levels = np.round((grain * 0.5 + 0.5) * 24) / 24  # few levels keep the file small
    light, dark = np.array([0.52, 0.36, 0.21]), np.array([0.33, 0.20, 0.10])
    return encode(srgb_bytes(dark + (light - dark) * levels[..., None]))
