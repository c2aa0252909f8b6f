"""Files that another process changes while they are read, of every kind that is read: an error that says which file, or
what can be read, which may be a mixture that a careless writer left; never a crash, and never half an output.
Usage: test_changing_files.py PATH_TO_UPS [unittest options]"""
import collections
import contextlib
import json
import os
import re
import struct
import subprocess
import threading
import zlib
from pathlib import Path

import faults
from test_compare import write_exr
from test_info import narrow_rays, tm25

TESTS = Path(__file__).resolve().parents[1]
PROFILES, CORPUS, TARGETS = TESTS / "photometry/data", TESTS / "fuzz/corpus", TESTS.parent / "samples/targets"
PADDING = 300000  # more than a block of any reader, so that reading takes more than one step


def padded_png(png):
    """With a chunk that readers skip, behind the header's."""
    chunk = b"teXt" + bytes(PADDING)
    return png[:33] + struct.pack(">I", PADDING) + chunk + struct.pack(">I", zlib.crc32(chunk)) + png[33:]


def grey_jpeg():
    """A block of 8 x 8 pixels in one grey, behind comments. Each Huffman table has one word: a difference of 0, an
    end of block (ITU-T T.81, annex B)."""
    def segment(marker, data):
        return bytes([0xff, marker]) + struct.pack(">H", 2 + len(data)) + data

    word = bytes([1] + 15 * [0] + [0])
    frame = segment(0xdb, b"\0" + 64 * b"\1") + segment(0xc0, struct.pack(">BHHBBBB", 8, 8, 8, 1, 1, 0x11, 0))
    tables = segment(0xc4, b"\0" + word) + segment(0xc4, b"\x10" + word)
    comments = segment(0xfe, bytes(65000)) * (PADDING // 65000)
    return b"\xff\xd8" + comments + frame + tables + segment(0xda, bytes([1, 1, 0, 0, 63, 0])) + b"\x3f\xff\xd9"


def binary_gltf(document, data):
    chunks = b""
    for kind, content in ((b"JSON", json.dumps(document).encode()), (b"BIN\0", data)):
        content += (b" " if kind == b"JSON" else b"\0") * (-len(content) % 4)
        chunks += struct.pack("<I4s", len(content), kind) + content
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


class ChangingFiles(faults.FaultTest):
    def setUp(self):
        super().setUp()
        self.seen = collections.Counter()  # runs by their exit codes

    def disturb(self, path, content, stop):
        """In place, as careless programs do: shorter, other bytes, longer, gone, another file, back again."""
        while not stop.is_set():
            kind = self.random.randrange(6)
            try:
                if kind == 0:
                    os.truncate(path, self.random.randrange(len(content)))
                elif kind == 1:
                    with open(path, "r+b") as file:
                        file.seek(self.random.randrange(len(content)))
                        file.write(bytes(self.random.randrange(256) for _ in range(16)))
                elif kind == 2:
                    with open(path, "ab") as file:
                        file.write(content[:5000])
                elif kind == 3:
                    path.unlink()
                elif kind == 4:
                    other = path.with_name("other")
                    other.write_bytes(content[:self.random.randrange(len(content))])
                    other.replace(path)
                else:
                    with open(path, "wb") as file:  # in two parts
                        half = self.random.randrange(len(content))
                        file.write(content[:half])
                        file.flush()
                        file.write(content[half:])
            except OSError:
                pass
            if self.random.random() < 0.5:
                path.write_bytes(content)
                stop.wait(self.random.uniform(0, 0.1))

    @contextlib.contextmanager
    def changing(self, path):
        content, stop = path.read_bytes(), threading.Event()
        thread = threading.Thread(target=self.disturb, args=(path, content, stop))
        thread.start()
        try:
            yield
        finally:
            stop.set()
            thread.join()
            path.write_bytes(content)

    def run_on_changing(self, name, command, names):
        """Whether it was read whole; else nothing is printed but an error that holds one of the names."""
        done = subprocess.run([faults.program, *command], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              cwd=self.folder, timeout=faults.HANG_S)
        told = done.stderr.decode(errors="replace")
        what = f"{name}: {command}: {faults.died_of(done.returncode)}\n{told}"
        self.assertIn(done.returncode, (0, 1), msg=what)
        if done.returncode == 1:
            self.assertEqual(done.stdout, b"", msg=what)
            self.assertRegex(told, "|".join(map(re.escape, names)), msg=what)
        self.seen[done.returncode] += 1
        return done.returncode == 0

    def expect_refused_when_cut(self, name, command):
        path = self.folder / name
        content = path.read_bytes()
        path.write_bytes(content[:8])
        self.run_program([faults.program, *command], code=1, cwd=self.folder)
        path.write_bytes(content)
        self.run_program([faults.program, *command], cwd=self.folder)

    def tell(self):
        print(f"read whole {self.seen[0]} times, refused {self.seen[1]} times")  # as chance has it

    def test_a_whole_scene_or_an_error(self):
        _, files = self.write_scene()
        large = {"room.bin": files["room.bin"] + bytes(PADDING),
                 "lamp.ies": files["lamp.ies"].replace(b"[TEST] none", b"[TEST] none\n[MORE] " + b"x" * 100 +
                                                       b"\n[MORE] y" * 5000)}
        for name, content in large.items():
            (self.folder / name).write_bytes(content)
        info = ["info", "room.gltf"]
        for name in files:
            with self.changing(self.folder / name):
                for k in range(faults.rounds(20, 300)):
                    self.run_on_changing(name, info if k % 4 else
                                         ["render", "room.gltf", "--iterations", "1", "--size", "8x8"], files)
        self.tell()
        for name in files:
            self.expect_refused_when_cut(name, info)

    def write_painted_scenes(self, png):
        """The room with a floor of two images, which are files, and as a .glb that holds the first of them."""
        scene = json.loads((self.folder / "room.gltf").read_bytes())
        scene["accessors"].append({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2"})  # any will do
        scene["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = len(scene["accessors"]) - 1
        pbr = {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}, "metallicFactor": 0}
        scene["materials"] = [{"pbrMetallicRoughness": pbr}]
        scene["textures"] = [{"source": 0}, {"source": 1}]
        scene["images"] = [{"uri": "paint.png"}, {"uri": "gloss.jpg"}]
        data = (self.folder / "room.bin").read_bytes()
        written = {"paint.png": png, "gloss.jpg": grey_jpeg(), "painted.gltf": json.dumps(scene).encode()}
        scene["images"][0] = {"bufferView": len(scene["bufferViews"]), "mimeType": "image/png"}
        scene["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(png)})
        scene["buffers"] = [{"byteLength": len(data + png)}]
        return written | {"painted.glb": binary_gltf(scene, data + png)}

    def write_files(self):
        """One of each kind that is read beside the scene's own; what reads it."""
        scene, _ = self.write_scene()
        self.run_program(self.command(scene, self.folder / "out", size="60x40"))
        out = {name: (self.folder / "out" / name).read_bytes() for name in ("view.exr", "view.png", "work_plane.csv")}
        blank = b"\n" * 8000  # behind texts, as they are shorter than a stream's buffer
        area = {"name": "desks", "row": "office.writing", "meters": ["work*"]}
        written = self.write_painted_scenes(padded_png(out.pop("view.png"))) | out | {
            "lamp.ldt": (PROFILES / "l03_isym0_asym.ldt").read_bytes(),
            "tilted.ies": (PROFILES / "s07_tilt_file.ies").read_bytes() + blank,
            "mh400.tlt": (PROFILES / "mh400.tlt").read_bytes(),  # which it names
            "lamp.xml": (CORPUS / "tm33/none.xml").read_bytes() + blank,
            "lamp.tm25ray": tm25(narrow_rays(300)),
            "lamp.sdf": (CORPUS / "rays/zemax_lumens").read_bytes(),
            "lamp.ray": (CORPUS / "rays/lighttools_lumens").read_bytes(),
            "targets.json": json.dumps({"include": "rows.json", "areas": [area]}).encode() + blank,
            "rows.json": (TARGETS / "en12464-1.json").read_bytes() + blank}
        for name, content in written.items():
            (self.folder / name).write_bytes(content)
        write_exr(self.folder / "reference.exr", 60, 40, {channel: [100.0] * 2400 for channel in "RGB"})
        compare = ["compare", "view.exr", "reference.exr"]
        judge = ["render", "room.gltf", "--iterations", "2", "--size", "8x8", "--targets", "targets.json"]
        return [("painted.glb", ["info", "painted.glb"]), ("paint.png", ["info", "painted.gltf"]),
                ("gloss.jpg", ["info", "painted.gltf"]), ("lamp.ldt", ["convert", "lamp.ldt", "new.ies"]),
                ("tilted.ies", ["info", "tilted.ies"]), ("mh400.tlt", ["info", "tilted.ies"]),
                *((name, ["info", name]) for name in ("lamp.xml", "lamp.tm25ray", "lamp.sdf", "lamp.ray")),
                ("view.exr", compare), ("reference.exr", compare), ("view.exr", ["map", "view.exr", "new.svg"]),
                ("work_plane.csv", ["map", "work_plane.csv", "new.svg"]), ("targets.json", judge), ("rows.json", judge)]

    def expect_whole_or_older(self, output, is_new):
        if not is_new:
            self.assertEqual(output.read_bytes(), b"older")
        elif output.suffix == ".svg":
            self.assertTrue(output.read_bytes().rstrip().endswith(b"</svg>"), msg=output)
        else:
            self.run_program([faults.program, "info", str(output)])

    def test_every_other_kind_of_file(self):
        for name, command in self.write_files():
            # A scene's images, a profile's TILT, a table's included rows: who names them may be named instead. A file
            # with a change in it may have no form in what it is converted to.
            names = {name, *(word for word in command if Path(word).suffix)}
            outputs = [self.folder / word for word in command if word.startswith("new.")]
            self.expect_refused_when_cut(name, command)
            with self.changing(self.folder / name):
                for _ in range(faults.rounds(4, 150)):
                    for output in outputs:
                        output.write_bytes(b"older")
                    is_new = self.run_on_changing(name, command, names)
                    for output in outputs:
                        self.expect_whole_or_older(output, is_new)
        self.assertEqual(list(self.folder.glob("*.tmp")), [])
        self.tell()


if __name__ == "__main__":
    faults.main()
