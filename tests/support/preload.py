"""Libraries that stand before all others of a program (LD_PRELOAD)."""
import os


def preloaded(*libraries):
    """The environment with them, behind those that are there already: the run time of a sanitizer has to be the first."""
    paths = [os.environ.get("LD_PRELOAD"), *map(str, libraries)]
    return {**os.environ, "LD_PRELOAD": ":".join(filter(None, paths))}
