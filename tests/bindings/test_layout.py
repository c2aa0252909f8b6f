"""Do ctypes' structs and enumerations lie in memory as the C compiler's? Read from tests/abi/layout.txt, which the ABI
tests tie to the headers. And does a class of either binding call each function?"""
import ctypes
import re
import sys
from pathlib import Path

import pytest
from ups import _ffi

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bindings"))
import c_header  # noqa: E402
import generate  # noqa: E402

API = c_header.parse_headers(ROOT / "include" / "ups", c_header.ALL_HEADERS)
LINES = [line.split() for line in (ROOT / "tests/abi/layout.txt").read_text().splitlines()]


def structs():
    found = {}
    for line in LINES:
        if len(line) == 2 and not line[0].isupper():
            fields = found.setdefault(line[0], (int(line[1]), []))[1]
        elif len(line) == 3:
            fields.append((line[0], int(line[1]), int(line[2])))
    return found


@pytest.mark.parametrize("name", structs())
def test_struct_is_laid_out_as_in_c(name):
    size, fields = structs()[name]
    python = getattr(_ffi, generate.pascal(name))
    assert ctypes.sizeof(python) == size
    assert [(f, getattr(python, f).offset, getattr(python, f).size) for f, _ in python._fields_] == fields


def test_every_struct_of_the_headers_is_in_the_layout():
    assert set(structs()) == {s.name for s in API.structs}


def test_enumerators_have_their_c_values():
    values = {line[0]: int(line[1]) for line in LINES if len(line) == 2 and line[0].isupper()}
    assert len(values) == sum(len(e.members) for e in API.enums)
    for enum in API.enums:
        prefix = c_header.common_prefix(enum)
        python = getattr(_ffi, generate.enum_name(enum))
        assert {prefix + m.name: m.value for m in python} == {name: values[name] for name, _ in enum.members}


@pytest.mark.parametrize("folder, call", [("python/ups", r"\blib\.(ups_\w+)"), ("csharp", r"\bNative\.(ups_\w+)")])
def test_each_function_is_called_by_a_class(folder, call):
    files = [p for p in (ROOT / "bindings" / folder).iterdir() if p.suffix in (".py", ".cs")]
    called = {name for p in files for name in re.findall(call, p.read_text(encoding="utf-8"))}
    # _with takes what the others take; Status has the names; descriptions are made by way of _ffi.INIT or Create().
    left_out = {"ups_profile_parse", "ups_scene_start_commit", "ups_status_name"}
    if folder == "python/ups":  # its render waits for a job, so that Ctrl-C gets through; messages are any library's;
        left_out |= {"ups_render", "ups_last_error", "ups_result_read_meters"}  # it copies the view
    functions = {f.name for f in API.functions
                 if f.header in c_header.CORE_HEADERS and not f.name.endswith("_desc_init")}
    assert functions - called == left_out


def test_each_function_of_the_extras_is_called_in_csharp():
    extras = c_header.parse_headers(ROOT / "include" / "ups", c_header.CORE_HEADERS + c_header.EXTRA_HEADERS)
    functions = {f.name for f in extras.functions if f.header in c_header.EXTRA_HEADERS}
    assert len(functions) > 30
    text = "".join(p.read_text(encoding="utf-8") for p in (ROOT / "bindings" / "csharp").glob("*.cs"))
    assert {f for f in functions if f"Native.{f}(" not in text} == set()


@pytest.mark.parametrize("text", ["typedef void (*ups_callback)(void);", "enum { UPS_A };",
                                  "typedef struct { int bits : 3; } ups_b;", "UPS_API int (*ups_f(void))(int);"])
def test_a_header_in_another_style_is_refused(tmp_path, text):
    (tmp_path / "ups_base.h").write_text(text)
    with pytest.raises(c_header.HeaderError):
        c_header.parse_headers(tmp_path, ["ups_base.h"])
