#!/usr/bin/env python3
"""An integrating sphere of radius 1 m with a point source: sphere_<reflectance>.glb, and the answer in closed form.

In a closed room of one reflectance rho, E averaged over the walls is flux / (A (1 - rho)) whatever the shape; in a
sphere with the source at its centre it is that everywhere. A is the area of the mesh, not of the ideal sphere.
"""
import argparse
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
from gltf_builder import Frame, GltfBuilder  # noqa: E402
from shapes import Mesh, icosphere  # noqa: E402


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reflectance", type=float, nargs="?", default=0.9)
    parser.add_argument("--flux", type=float, default=10000.0, help="lm")
    parser.add_argument("--level", type=int, default=4, help="subdivisions of the icosahedron")
    parser.add_argument("--meters", type=int, default=128)
    parser.add_argument("--offset", type=float, default=0.0, help="of the source from the centre, m")
    parser.add_argument("--out", help="default: sphere_<reflectance>.glb beside this script")
    arguments = parser.parse_args()
    if not 0 <= arguments.reflectance < 1:
        parser.error(f"reflectance {arguments.reflectance} is not in [0, 1)")
    if not 0 <= arguments.offset < 0.9:
        parser.error(f"offset {arguments.offset} is not in [0, 0.9)")

    # Flat triangles, turned inwards.
    outward = icosphere(1.0, arguments.level, smooth=False)
    wall = Mesh(outward.positions, outward.triangles[:, ::-1])
    area = wall.area()
    chosen = np.linspace(0, len(wall.triangles), arguments.meters, endpoint=False).astype(int)
    centroids = wall.positions[wall.triangles[chosen]].mean(axis=1)
    inward = wall.face_vectors()[chosen]
    inward /= np.linalg.norm(inward, axis=1, keepdims=True)

    scene = GltfBuilder("UPS make_sphere.py")
    paint = scene.material("wall", {"model": "matte", "reflectance": arguments.reflectance})
    scene.shape("sphere", wall, paint)
    scene.point_light("source", (arguments.offset, 0, 0), arguments.flux / (4 * math.pi))
    # With this frame a node's local axes are the world's.
    scene.meters("wall", Frame.upright((0, 0, 0)), points_m=np.round(centroids, 7).tolist(),
                 normals=np.round(inward, 7).tolist())
    scene.write(arguments.out or os.path.join(here, f"sphere_{arguments.reflectance:g}.glb"))
    print(f"area {area:.6f} m2, expected mean {arguments.flux / (area * (1 - arguments.reflectance)):.4f} lx")


if __name__ == "__main__":
    main()
