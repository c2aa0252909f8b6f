"""Is ups.hpp whole, and does it compile everywhere? Called by ctest: check_headers.py COMPILER...

A program that includes it compiles with each compiler, as C++17 and C++20, without a warning; older C++ and a program
without exceptions are refused by a message that says so; every function of the library is within its reach.
"""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "samples/cpp/edits.cpp"
EXTRAS = "#include <ups/ups_exr.hpp>\n#include <ups/ups_gltf.hpp>\n#include <ups/ups_report.hpp>\n"
HEADERS = sorted((ROOT / "include/ups/hpp").glob("*.hpp")) + [ROOT / "include/ups/ups.hpp"]
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Wold-style-cast",
            "-Werror"]


def compile_text(compiler, text, *flags):
    """Of standard error; empty where it compiles."""
    command = [compiler, "-x", "c++", "-fsyntax-only", "-I", ROOT / "include", *flags, "-"]
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    assert done.returncode == 0 or done.stderr, f"{compiler} failed without a word"
    return done.stderr


def main():
    assert len(HEADERS) > 5 and len(sys.argv) > 1
    for compiler in sys.argv[1:]:
        for standard in ("-std=c++17", "-std=c++20"):
            errors = compile_text(compiler, EXTRAS + PROGRAM.read_text(), standard, *WARNINGS)
            assert not errors, f"{compiler} {standard}:\n{errors}"
        for flags, message in ((["-std=c++14"], "ups.hpp needs C++17"),
                               (["-std=c++17", "-fno-exceptions"], "ups.hpp reports failures by exceptions")):
            errors = compile_text(compiler, "#include <ups/ups.hpp>\n", *flags, "-E", "-o", "/dev/null")
            assert message in errors, f"{compiler} {flags}: expected '{message}', got:\n{errors}"
    code = "\n".join(re.sub("//.*", "", header.read_text()) for header in HEADERS)
    exported = (ROOT / "src/api/exports.txt").read_text().split()
    missing = [name for name in exported if not re.search(rf"\b{name}\b", code)]
    assert not missing, f"not used in ups.hpp: {missing}"
    print(f"{len(sys.argv) - 1} compilers, {len(exported)} functions in {len(HEADERS)} headers")


if __name__ == "__main__":
    main()
