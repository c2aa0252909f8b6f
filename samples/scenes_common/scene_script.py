"""What a script that makes one scene does around it. Called by the scene generators that have no options but --out."""
import argparse
import os

from gltf_builder import GltfBuilder


def make_scene(script, description, build):
    """Runs build(GltfBuilder) and writes NAME.glb beside the script make_NAME.py, or where --out says."""
    folder, name = os.path.split(os.path.abspath(script))
    beside = os.path.join(folder, name.removeprefix("make_").removesuffix(".py") + ".glb")
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("--out", default=beside)
    arguments = parser.parse_args()
    scene = GltfBuilder(f"UPS {name}")
    build(scene)
    os.makedirs(os.path.dirname(os.path.abspath(arguments.out)), exist_ok=True)
    scene.write(arguments.out)
