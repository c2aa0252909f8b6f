"""Are the package's types right, and do they find a program's mistakes? Asked of mypy, which a user would ask."""
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent

MISTAKES = '''
import numpy as np
import ups

context = ups.Context()
scene = ups.Scene(context)
mesh = scene.add_mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], np.array([(0, 1, 2)]), scene.add_material(roughness=0.5))
scene.add_material(rougness=0.5)  # E: Unexpected keyword argument "rougness"
scene.add_material(roughness="matt")  # E: Argument "roughness" to "add_material"
scene.add_instance(mesh, to_world=np.eye(4))
scene.add_luminaire(mesh)  # E: Argument 1 to "add_luminaire"
scene.render(iteration_count=1.5)  # E: Argument "iteration_count" to "render"
with scene.start(iteration_count=4) as job:
    status: ups.Status = job.watch(lambda p: print(p.fraction))
    reveal_type(job.poll().fraction)  # E: builtins.float
    result = job.result()
result.meters("desk")  # E: Argument 1 to "meters"
reveal_type(result.image(scene.add_camera(4, 4)))  # E: numpy.dtype[numpy.float
reveal_type(result.info.elapsed_s)  # E: builtins.float
reveal_type(ups.read_exr("a.exr").channels)  # E: builtins.list[builtins.str]
'''


def test_mypy_finds_no_mistake_of_ours_and_each_of_theirs(tmp_path):
    program = tmp_path / "mistakes.py"
    program.write_text(MISTAKES)
    asked = subprocess.run([sys.executable, "-m", "mypy", "--config-file", ROOT / "bindings/python/pyproject.toml",
                            "--cache-dir", tmp_path, "--no-error-summary", ROOT / "bindings/python/ups",
                            ROOT / "samples/python/first_room.py", program],
                           capture_output=True, text=True, cwd=tmp_path,
                           env={"MYPYPATH": str(ROOT / "bindings/python")})
    # Later versions of mypy warn that what the configuration asks for is on anyway.
    complaints = [line for line in asked.stderr.splitlines() if "already enabled" not in line]
    assert complaints == []
    found = {}
    for line in asked.stdout.splitlines():
        match = re.fullmatch(r"mistakes\.py:(\d+): (?:error|note): (.*)", line)
        assert match or line.endswith("defined here"), f"not of the program with mistakes: {line}"
        if match:
            found.setdefault(int(match[1]), []).append(match[2])
    wanted = {i: line.split("# E: ")[1] for i, line in enumerate(MISTAKES.splitlines(), 1) if "# E: " in line}
    assert all(any(text in message for message in found.get(i, [])) for i, text in wanted.items()), found
    assert set(found) == set(wanted), found
