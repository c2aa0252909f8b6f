"""A room that the Python binding's tests render, and that programs run from them import."""
import numpy as np
import ups


def box(context, reflectance=0.5):
    """A closed cube of 4 m, a point of 400 cd in its middle, four meters: (scene, meters)."""
    scene = ups.Scene(context)
    corners = np.array([[4.0 * (c >> axis & 1) for axis in range(3)] for c in range(8)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (1, 5, 7, 3), (3, 7, 6, 2), (2, 6, 4, 0)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    material = scene.add_material(reflectance_rgb=[reflectance] * 3)
    scene.add_instance(scene.add_mesh(corners, triangles, material))
    scene.add_light(intensity_rgb=[400] * 3, to_world=ups.translation(2, 2, 2))
    meters = scene.add_meters([(1, 1, 0.5), (3, 1, 0.5), (1, 3, 0.5), (3, 3, 0.5)], (0, 0, 1))
    scene.commit()
    return scene, meters
