"""Imported first by the scripts that make scenes: where the python3 that runs one has no numpy, the system's runs
it."""
import os
import sys

SYSTEM = "/usr/bin/python3"

try:
    import numpy  # noqa: F401
except ImportError:
    if os.path.realpath(sys.executable) == os.path.realpath(SYSTEM) or not os.path.exists(SYSTEM):
        raise
    os.execv(SYSTEM, [SYSTEM, *sys.argv])
