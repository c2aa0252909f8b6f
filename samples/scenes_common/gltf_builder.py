"""Writes a scene as one glTF 2.0 file (.glb or .gltf), with `extras.ups` for what glTF has no words for.

Called by the scene generators. They work in the world of the results, metres and +Z up; this module turns everything
into glTF's +Y up: (x, y, z) becomes (x, z, -y). The same calls give the same bytes.
"""
import base64
import json
import math
import struct

import numpy as np

from shapes import unit

TO_GLTF = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
FLOAT, UINT16, UINT32 = 5126, 5123, 5125
VERTEX_BUFFER, INDEX_BUFFER = 34962, 34963


class Frame:
    """Where a device stands in the world: its local x and y axes; z is their cross product."""

    def __init__(self, origin, x_axis, y_axis):
        self.origin = np.asarray(origin, float)
        x, y = unit(np.asarray(x_axis, float)), unit(np.asarray(y_axis, float))
        self.axes = np.stack([x, y, np.cross(x, y)], 1)
        if not np.allclose(self.axes.T @ self.axes, np.eye(3), atol=1e-9):
            raise ValueError("the axes of a frame must be perpendicular")

    @staticmethod
    def upright(origin):
        return Frame(origin, (1, 0, 0), (0, 1, 0))

    @staticmethod
    def facing(origin, direction):
        """Local z along `direction`, which is not vertical; local y as far up as can be."""
        z = unit(np.asarray(direction, float))
        x = unit(np.cross((0, 0, 1), z))
        return Frame(origin, x, np.cross(z, x))

    @staticmethod
    def along(z):
        """Local z along any direction; the others as they come."""
        z = unit(np.asarray(z, float))
        x = unit(np.cross(np.eye(3)[np.argmin(np.abs(z))], z))
        return Frame((0, 0, 0), x, np.cross(z, x))

    @staticmethod
    def camera(eye, target):
        """A camera looks along its local -z."""
        return Frame.facing(eye, np.asarray(eye, float) - np.asarray(target, float))

    def properties(self):
        """Translation and rotation of the glTF node."""
        m = TO_GLTF @ self.axes
        # Quaternion of a rotation by its largest component (Shepperd 1978).
        squares = np.array([1 + m[0, 0] - m[1, 1] - m[2, 2], 1 - m[0, 0] + m[1, 1] - m[2, 2],
                            1 - m[0, 0] - m[1, 1] + m[2, 2], 1 + m[0, 0] + m[1, 1] + m[2, 2]])
        rows = [[squares[0], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0], m[2, 1] - m[1, 2]],
                [m[0, 1] + m[1, 0], squares[1], m[1, 2] + m[2, 1], m[0, 2] - m[2, 0]],
                [m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], squares[2], m[1, 0] - m[0, 1]],
                [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], squares[3]]]
        quaternion = unit(np.array(rows[int(np.argmax(squares))]))
        if quaternion[3] < 0:
            quaternion = -quaternion
        return {"translation": _numbers(TO_GLTF @ self.origin), "rotation": _numbers(quaternion)}


def _numbers(values):
    """Single precision in the shortest form; no -0."""
    return [float(f"{v:.7g}") + 0.0 for v in np.asarray(values, float).reshape(-1)]


class GltfBuilder:
    def __init__(self, generator):
        self._json = {"asset": {"version": "2.0", "generator": generator}, "scene": 0, "scenes": [{"nodes": []}]}
        self._bytes = bytearray()
        self._extensions = set()

    def _add(self, kind, value):
        items = self._json.setdefault(kind, [])
        items.append(value)
        return len(items) - 1

    def _view(self, data, target=None):
        while len(self._bytes) % 4:
            self._bytes.append(0)
        view = {"buffer": 0, "byteOffset": len(self._bytes), "byteLength": len(data)}
        if target:
            view["target"] = target
        self._bytes += data
        return self._add("bufferViews", view)

    def _vertices(self, array, limits=False):
        array = np.ascontiguousarray(array, "<f4")
        accessor = {"bufferView": self._view(array.tobytes(), VERTEX_BUFFER), "componentType": FLOAT,
                    "count": len(array), "type": f"VEC{array.shape[1]}"}
        if limits:
            accessor["min"], accessor["max"] = ([float(v) for v in f(axis=0)] for f in (array.min, array.max))
        return self._add("accessors", accessor)

    def texture(self, name, png_bytes):
        """A PNG inside the file, repeating in both directions."""
        if "samplers" not in self._json:
            self._add("samplers", {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497})
        image = self._add("images", {"name": name, "mimeType": "image/png", "bufferView": self._view(png_bytes)})
        return self._add("textures", {"sampler": 0, "source": image})

    def material(self, name, ups=None, luminance=None, both_sides=False, **gltf):
        """`ups`: extras.ups, which sets how the surface scatters. `luminance` in cd/m2, one number or R, G, B, makes a
        Lambertian emitter. Other keywords are glTF's own properties of a material."""
        material = {"name": name, **gltf}
        if ups is not None:
            material["extras"] = {"ups": ups}
        if luminance is not None:
            strength = float(np.max(luminance))
            material["emissiveFactor"] = _numbers(np.broadcast_to(luminance, 3) / strength)
            material["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": strength}}
            self._extensions.add("KHR_materials_emissive_strength")
        if both_sides:
            material["doubleSided"] = True
        return self._add("materials", material)

    def textured(self, name, colour, normal, roughness_factor, tint=(1, 1, 1), roughness=None):
        """glTF's dielectric: a diffuse base under a glossy coat; the arguments are textures of this builder."""
        pbr = {"baseColorTexture": {"index": colour}, "baseColorFactor": [*tint, 1.0], "metallicFactor": 0.0,
               "roughnessFactor": roughness_factor}
        if roughness is not None:
            pbr["metallicRoughnessTexture"] = {"index": roughness}
        more = {} if normal is None else {"normalTexture": {"index": normal}}
        return self.material(name, pbrMetallicRoughness=pbr, **more)

    def mesh(self, name, *parts):
        """`parts`: (Mesh, material) pairs."""
        primitives = []
        for shape, material in parts:
            if len(shape.triangles) == 0 or shape.triangles.max() >= len(shape.positions):
                raise ValueError(f"mesh {name}: no triangles, or an index past the vertices")
            attributes = {"POSITION": self._vertices(shape.positions @ TO_GLTF.T, limits=True)}
            if shape.normals is not None:
                attributes["NORMAL"] = self._vertices(shape.normals @ TO_GLTF.T)
            if shape.uvs is not None:
                attributes["TEXCOORD_0"] = self._vertices(shape.uvs)
            if shape.tangents is not None:
                turned = np.concatenate([shape.tangents[:, :3] @ TO_GLTF.T, shape.tangents[:, 3:]], axis=1)
                attributes["TANGENT"] = self._vertices(turned)
            small = len(shape.positions) < 65535
            data = np.ascontiguousarray(shape.triangles, "<u2" if small else "<u4").tobytes()
            indices = self._add("accessors", {"bufferView": self._view(data, INDEX_BUFFER), "type": "SCALAR",
                                              "componentType": UINT16 if small else UINT32,
                                              "count": int(shape.triangles.size)})
            primitives.append({"attributes": attributes, "indices": indices, "material": material})
        return self._add("meshes", {"name": name, "primitives": primitives})

    def node(self, name, **properties):
        self._json["scenes"][0]["nodes"].append(self._add("nodes", {"name": name, **properties}))

    def place(self, name, mesh, at=None):
        """An instance of a mesh, moved by `at`."""
        where = {} if at is None else {"translation": _numbers(TO_GLTF @ np.asarray(at, float))}
        self.node(name, mesh=mesh, **where)

    def shape(self, name, shape, material):
        self.place(name, self.mesh(name, (shape, material)))

    def camera(self, name, eye, target, vertical_fov_degrees, width, height):
        camera = self._add("cameras", {"type": "perspective", "perspective": {
            "yfov": math.radians(vertical_fov_degrees), "aspectRatio": width / height, "znear": 0.01}})
        self.node(name, camera=camera, **Frame.camera(eye, target).properties(),
                  extras={"ups": {"width": width, "height": height}})

    def meters(self, name, frame, **meters):
        """`meters`: the words of extras.ups.meters, in the frame's local axes."""
        self.node(name, **frame.properties(), extras={"ups": {"meters": {"name": name, **meters}}})

    def observer(self, name, eye, target):
        """An eye whose glare is rated."""
        self.node(name, **Frame.camera(eye, target).properties(), extras={"ups": {"observer": {"name": name}}})

    def luminaire(self, name, frame, **luminaire):
        self.node(name, **frame.properties(), extras={"ups": {"luminaire": luminaire}})

    def fixture(self, name, frame, parts, **fixture):
        """A luminaire modelled down to its emitters; `parts` and the rest are the words of extras.ups.fixture. Light
        goes along local -z."""
        self.node(name, **frame.properties(), extras={"ups": {"fixture": {"parts": parts, **fixture}}})

    def _light(self, name, kind, intensity, cone=None, **where):
        lights = self._json.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append({"name": name, "type": kind, "intensity": float(intensity), **({"spot": cone} if cone else {})})
        self._extensions.add("KHR_lights_punctual")
        self.node(name, **where, extensions={"KHR_lights_punctual": {"light": len(lights) - 1}})

    def point_light(self, name, at, candela):
        self._light(name, "point", candela, translation=_numbers(TO_GLTF @ np.asarray(at, float)))

    def spot_light(self, name, at, direction, candela, inner_radians, outer_radians):
        """Full intensity up to the inner angle from the axis, none beyond the outer one."""
        where = Frame.along(-np.asarray(direction, float))
        self._light(name, "spot", candela, {"innerConeAngle": inner_radians, "outerConeAngle": outer_radians},
                    translation=_numbers(TO_GLTF @ np.asarray(at, float)), rotation=where.properties()["rotation"])

    def directional_light(self, name, direction, lux):
        """Light that travels along `direction`; the illuminance of a surface that faces it."""
        where = Frame.along(-np.asarray(direction, float))
        self._light(name, "directional", lux, rotation=where.properties()["rotation"])

    def _write_text(self, path, document):
        """For scenes that people read: what is binary is embedded."""
        if self._bytes:
            data = base64.b64encode(bytes(self._bytes)).decode()
            document["buffers"] = [{"byteLength": len(self._bytes),
                                    "uri": "data:application/octet-stream;base64," + data}]
        if self._extensions:
            document["extensionsUsed"] = sorted(self._extensions)
        with open(path, "w", encoding="utf-8") as file:
            json.dump(document, file, indent=1, allow_nan=False)
            file.write("\n")
        print(path)

    def write(self, path):
        while len(self._bytes) % 4:
            self._bytes.append(0)
        document = dict(self._json)
        if path.endswith(".gltf"):
            self._write_text(path, document)
            return
        if self._bytes:
            document["buffers"] = [{"byteLength": len(self._bytes)}]
        if self._extensions:
            document["extensionsUsed"] = sorted(self._extensions)
        text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as file:
            chunks = struct.pack("<I4s", len(text), b"JSON") + text
            if self._bytes:
                chunks += struct.pack("<I4s", len(self._bytes), b"BIN\0") + self._bytes
            file.write(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
        triangles = {m: sum(document["accessors"][p["indices"]]["count"] // 3 for p in mesh["primitives"])
                     for m, mesh in enumerate(document.get("meshes", []))}
        count = sum(triangles[n["mesh"]] for n in document["nodes"] if "mesh" in n)
        print(f"{path}: {count} triangles, {12 + len(chunks)} bytes")
