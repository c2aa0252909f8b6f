#!/usr/bin/env python3
"""Is what differs between operating systems in src/platform alone? Called by ctest.

Elsewhere no source includes a system's header or asks which system it is, none opens a file or takes a path apart by
the standard library, whose narrow names are not UTF-8 everywhere, and no CMake file tells the linker what one system's
alone understands. ups_base.h must mark what a Windows library exports.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = r"""
  \#\s*include\s*<(?:sys/|unistd\.h|fcntl\.h|dlfcn\.h|pthread\.h|sched\.h|signal\.h|csignal|windows\.h|mach|io\.h
    |dirent\.h|termios\.h|poll\.h|spawn\.h|pwd\.h|filesystem|fstream)
  | \b(?:_WIN32|WIN32|_MSC_VER|__MINGW\w*|__APPLE__|__MACH__|__linux__|__unix__|_POSIX\w*)\b
  | \b(?:std::filesystem|[io]?fstream\s+\w|fopen|freopen|tmpfile|gmtime_r|localtime_r|strerror_r|lgamma_r|strtok_r
    |isatty|mmap|fork|execv\w*|popen|setenv|dlopen)\b
  | /proc/ | /sys/fs | /dev/\w+"
"""
BUILD = r"-Wl,|\$ORIGIN|@loader_path|--version-script|\b(?:WIN32|APPLE|UNIX|LINUX|MSVC|MINGW)\b"
ALLOWED = {"include/ups/ups_base.h": {"_WIN32"}}


def without_comments(text, is_cpp):
    if not is_cpp:
        return re.sub(r"(?m)#.*", "", text)
    return re.sub(r"/\*.*?\*/", lambda m: "\n" * m[0].count("\n"), re.sub(r"(?m)(?<!:)//.*", "", text), flags=re.S)


def main():
    folders = ("include", "photometry", "src")
    files = [f for folder in folders for f in sorted((ROOT / folder).rglob("*")) if f.is_file()]
    files = [ROOT / "CMakeLists.txt"] + [f for f in files if ROOT / "src/platform" not in f.parents]
    found, read = [], 0
    for file in files:
        is_cpp = file.suffix in (".h", ".hpp", ".cpp")
        if not is_cpp and file.name != "CMakeLists.txt" and file.suffix != ".cmake":
            continue
        read += 1
        name = file.relative_to(ROOT).as_posix()
        pattern = re.compile(SOURCES, re.X) if is_cpp else re.compile(BUILD)
        for number, line in enumerate(without_comments(file.read_text(), is_cpp).splitlines(), 1):
            words = {m[0].strip() for m in pattern.finditer(line)} - ALLOWED.get(name, set())
            found += [f"{name}:{number}: {word}" for word in sorted(words)]
    assert read > 300, f"only {read} files were read"
    if found:
        sys.exit("\n".join(found) + "\nWhat differs between operating systems belongs into src/platform")
    print(f"{read} files use src/platform and nothing of a system's own")


if __name__ == "__main__":
    main()
