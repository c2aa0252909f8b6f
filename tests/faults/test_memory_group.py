"""A control group of Linux whose memory is limited: a render that would need more ends with an error that names the limit,
before the kernel ends it; a smaller one is as it is elsewhere. Left out where this user may not make a group, or has less
memory: of the second version of groups that is nearly everywhere, as one that holds processes passes no limits on.
Usage: test_memory_group.py PATH_TO_UPS [unittest options]"""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import faults

LIMIT = 1 << 30
LIMITS = ("memory.limit_in_bytes", "memory.max")  # of the first and the second version


def place_of_this_process():
    """Folder of its group that limits memory, or None."""
    for line in Path("/proc/self/cgroup").read_text().splitlines():
        _, controllers, place = line.split(":", 2)
        roots = ["/sys/fs/cgroup/memory"] if "memory" in controllers.split(",") else (
            ["/sys/fs/cgroup", "/sys/fs/cgroup/unified"] if not controllers else [])
        for root in roots:
            folder = Path(root + place)
            if (folder / LIMITS[0]).exists() or "memory" in words_of(folder / "cgroup.controllers"):
                return folder
    return None


def free_bytes(group):
    """What the machine has, and groups from this one up leave."""
    free = [1024 * int(line.split()[1]) for line in Path("/proc/meminfo").read_text().splitlines()
            if line.startswith("MemAvailable:")]
    for folder in (group, *group.parents):
        for limit, usage in zip(LIMITS, ("memory.usage_in_bytes", "memory.current")):
            words = words_of(folder / limit)
            if words and words[0].isdigit():
                free.append(int(words[0]) - int(words_of(folder / usage)[0]))
    return min(free)


def words_of(path):
    try:
        return path.read_text().split()
    except OSError:
        return []


class MemoryGroup(faults.FaultTest):
    def setUp(self):
        super().setUp()
        try:
            above = place_of_this_process()
            if above is None:
                self.skipTest("no group here limits memory")
            self.group = Path(tempfile.mkdtemp(prefix="ups-test-", dir=above))
            self.addCleanup(self.group.rmdir)
            limit = next((self.group / name for name in LIMITS if (self.group / name).exists()), None)
            if limit is None:
                self.skipTest("groups here pass no limit of memory on")
            limit.write_text(str(LIMIT))
            subprocess.run(["true"], preexec_fn=self.enter, check=True)
            if free_bytes(above) < 2 * LIMIT:
                self.skipTest("another limit is reached before that of the group")
        except (OSError, subprocess.SubprocessError) as e:
            self.skipTest(f"no group with a limit of memory can be made: {e}")

    def enter(self):
        (self.group / "cgroup.procs").write_text(str(os.getpid()))

    def test_what_needs_more_is_refused_and_names_the_limit(self):
        scene, _ = self.write_scene()
        done = self.run_program(self.command(scene, self.folder / "large", size="8000x8000"), code=1,
                                preexec_fn=self.enter)
        self.assertIn("the control group's limit", done.stderr)
        self.assertIn(self.group.name, done.stderr)
        self.assertFalse((self.folder / "large").exists() and os.listdir(self.folder / "large"))

    def test_what_needs_less_is_as_it_is_elsewhere(self):
        scene, _ = self.write_scene()
        self.run_program(self.command(scene, self.folder / "outside"))
        self.run_program(self.command(scene, self.folder / "inside"), preexec_fn=self.enter)
        self.assertEqual(self.results(self.folder / "inside"), self.results(self.folder / "outside"))


if __name__ == "__main__":
    faults.main()
