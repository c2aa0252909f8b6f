"""Runs `ups render` and `ups compare` for the scripts beside it and for the validation, and keeps references."""
import csv
import hashlib
import json
import os
import resource
import subprocess
import sys
from dataclasses import dataclass
from typing import Optional


def cpu_s():
    """Of all programs that were run so far."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stderr.strip()}")
    return json.loads(done.stdout)


def read_table(folder, name):
    """The meters of the set `name` that a render left in `folder`: a {column: number} each."""
    with open(os.path.join(folder, name + ".csv"), newline="", encoding="utf-8") as file:
        return [{column: float(value) for column, value in row.items()} for row in csv.DictReader(file)]


def squared_errors(compared):
    """Of `ups compare`, without the reference's own noise, so that they can be negative."""
    c = compared["channels"]
    return {"rmse": c["mse"] - max(c["noise_b"], 0), "trimmed_rmse": c["trimmed_mse"] - max(c["trimmed_noise_b"], 0),
            "relative_mse": c["relative_mse"] - max(c["relative_noise_b"], 0)}


@dataclass
class Renderer:
    """One scene, rendered by one program."""
    ups: str
    scene: str
    threads: Optional[int] = None
    size: Optional[str] = None  # WxH of the cameras
    more: tuple = ()            # further words of `ups render`

    def render(self, method, seed, limit, out=None):
        """limit: words of the program, as ["--time", "10"]; out: folder for the images, the tables and render.json. The
        summary gets cpu_s, what the whole program took."""
        command = [self.ups, "render", self.scene, "--method", method, "--seed", str(seed), "--json", *limit,
                   *self.more]
        for option, value in (("--threads", self.threads), ("--size", self.size), ("--out", out)):
            if value:
                command += [option, str(value)]
        before = cpu_s()
        summary = run(command)
        summary["cpu_s"] = cpu_s() - before
        if out:
            with open(os.path.join(out, "render.json"), "w", encoding="utf-8") as file:
                json.dump(summary, file, indent=1)
        return summary

    def reference(self, method, seed, limit, out):
        """The summary of the reference in `out`; an earlier one is used again only where the same words made it of the
        same scene."""
        with open(self.scene, "rb") as file:
            recipe = [hashlib.sha256(file.read()).hexdigest(), method, seed, limit, self.size, list(self.more)]
        note = os.path.join(out, "recipe.json")
        if os.path.exists(note):
            with open(note, encoding="utf-8") as file:
                if json.load(file) == recipe:
                    with open(os.path.join(out, "render.json"), encoding="utf-8") as summary:
                        return json.load(summary)
        print(f"reference: {method}, seed {seed}, {' '.join(limit)}", file=sys.stderr)
        summary = self.render(method, seed, limit, out)
        with open(note, "w", encoding="utf-8") as file:
            json.dump(recipe, file)
        return summary

    def compare(self, camera, out, reference_dir):
        """`ups compare` of a camera's image with the reference's."""
        return run([self.ups, "compare", *(os.path.join(folder, camera + ".exr") for folder in (out, reference_dir)),
                    "--json"])
