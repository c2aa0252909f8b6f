"""Are the libraries that an installed package loads those that it should? Run in its own environment by python.sh:

    python_libraries.py ENVIRONMENT system|inside

Where Embree and the others are to be inside, every library that importing the package and using each extra loads has to be,
but for the C and C++ run time; and who asks for a library of the system must get the system's all the same. A licence has to
stand beside what was taken from packages.
"""
import ctypes
import re
import sys
import tempfile
from pathlib import Path

import numpy as np

OF_THE_SYSTEM = re.compile(r"lib(stdc\+\+|gcc_s|z|asan|tsan|ubsan)\.so\.\d+.*")


def mapped():
    return {line.split()[-1] for line in open("/proc/self/maps") if ".so" in line}


def use_extras(ups):
    with tempfile.TemporaryDirectory() as folder:
        ups.write_exr(f"{folder}/a.exr", {"Y": np.ones((2, 3))})
        assert np.array_equal(ups.read_exr(f"{folder}/a.exr")["Y"], np.ones((2, 3)))
        ups.write_png(f"{folder}/a.png", np.ones((2, 3, 3)))
        ups.write_image_map(f"{folder}/b.png", np.ones((2, 3)))
        Path(folder, "a.gltf").write_text('{"asset": {"version": "2.0"}}')
        scene = ups.Scene(ups.Context())
        assert scene.import_gltf(f"{folder}/a.gltf").sensors == []
        scene.add_instance(scene.add_mesh(np.eye(3), [(0, 1, 2)], scene.add_material()))
        scene.commit()  # Embree builds, for which oneTBB loads its allocator


def main():
    environment, kind = Path(sys.argv[1]).resolve(), sys.argv[2]
    before = mapped()
    import ups
    assert environment in Path(ups.__file__).resolve().parents, ups.__file__
    use_extras(ups)
    loaded = {Path(p) for p in mapped() - before}
    package = Path(ups.__file__).resolve().parent
    outside = {p.name for p in loaded if package not in p.parents and "lib-dynload" not in p.parts}
    own = {p.name for p in loaded if package in p.parents}
    assert {"ups", "ups_gltf", "ups_exr", "ups_ocio", "ups_report"} == {
        n[3:].split(".")[0] for n in own if n.startswith("libups")}, own
    if kind == "inside":
        assert all(OF_THE_SYSTEM.fullmatch(name) for name in outside), outside
        assert any(n.startswith("libembree") for n in own) and "libtbbmalloc.so.2" in own, own
        for name in ("libtbb.so.12", "libcairo.so.2", "libX11.so.6"):
            ctypes.CDLL(name)
            assert any(Path(p).name.startswith(name) and package not in Path(p).parents for p in mapped()), name
        licences = {p.name for p in (package / "licences").iterdir()}
        assert {"UPS", "THIRD-PARTY.md", "libtbb12"} < licences and any(n.startswith("libembree") for n in licences), licences
        assert all((package / "licences" / n).stat().st_size > 500 for n in licences)
    else:
        assert any(n.startswith("libembree") for n in outside) and not any(n.startswith("libembree") for n in own)
    print(f"{kind}: {len(own)} libraries of the package are loaded, of the system: {', '.join(sorted(outside))}")


if __name__ == "__main__":
    main()
