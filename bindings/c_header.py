"""What do the C headers declare? Reads include/ups/ups_*.h into plain data.

Called by generate.py (the bindings) and by tests/abi (layout, exports, ABI baseline). It understands only the style
that those headers are written in, C declarations without function pointers, unions or bit-fields, and stops with file
and text at anything else, so a header that leaves the style is noticed and not skipped.
"""
import re
from collections import namedtuple
from pathlib import Path

CORE_HEADERS = ("ups_base.h", "ups_photometry.h", "ups_scene.h", "ups_fixture.h", "ups_sensor.h", "ups_render.h",
                "ups_replay.h", "ups_statistics.h", "ups_glare.h")
EXTRA_HEADERS = ("ups_gltf.h", "ups_exr.h", "ups_ocio.h", "ups_report.h")  # each of a library of its name
ALL_HEADERS = CORE_HEADERS + EXTRA_HEADERS

# C type: name without const, whether const, how many stars, elements of an array (0: no array).
Type = namedtuple("Type", "name const pointers count")
Variable = namedtuple("Variable", "name type")
Function = namedtuple("Function", "name returns parameters header")
Struct = namedtuple("Struct", "name fields")
Enum = namedtuple("Enum", "name members")  # name None: a set of flags without a type of its own; members: (name, value)


class HeaderError(Exception):
    pass


class Api:
    """Everything that some headers declare, in order."""

    def __init__(self):
        self.version = {}     # MAJOR, MINOR, PATCH
        self.aliases = {}     # enumeration types: name -> underlying type
        self.enums = []
        self.handles = []     # opaque structs
        self.structs = []
        self.functions = []

    def ids(self):
        return [s.name for s in self.structs if s.name.endswith("_id")]

    def struct(self, name):
        return next((s for s in self.structs if s.name == name), None)

    def function(self, name):
        return next((f for f in self.functions if f.name == name), None)


def parse_headers(folder, names=CORE_HEADERS):
    api = Api()
    for name in names:
        _parse_file(api, Path(folder) / name)
    return api


def common_prefix(enum):
    """UPS_JOB_ of UPS_JOB_RUNNING, UPS_JOB_FAILED: what every member of the enumeration starts with, whole words."""
    words = [name.split("_") for name, _ in enum.members]
    length = 1  # always UPS_
    while len(words) > 1 and all(len(w) > length + 1 for w in words) and len({w[length] for w in words}) == 1:
        length += 1
    return "_".join(words[0][:length]) + "_"


def _parse_file(api, path):
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    for part, value in re.findall(r"^#define UPS_VERSION_(\w+) (\d+)", text, flags=re.M):
        api.version[part] = int(value)
    text = re.sub(r"^#.*$", "", text, flags=re.M)  # the headers' own preprocessor lines declare nothing else
    for statement in _statements(text):
        _parse_statement(api, " ".join(statement.split()), path.name)


def _statements(text):
    depth, start = 0, 0
    for i, c in enumerate(text):
        depth += (c == "{") - (c == "}")
        if c == ";" and depth == 0:
            yield text[start:i]
            start = i + 1
    if text[start:].strip():
        raise HeaderError(f"text after the last declaration: {text[start:].strip()[:80]!r}")


def _parse_statement(api, s, header):
    if m := re.fullmatch(r"typedef (u?int\d+_t) (ups_\w+)", s):
        api.aliases[m[2]] = m[1]
    elif m := re.fullmatch(r"enum \{(.*)\}", s):
        _parse_enum(api, m[1], header)
    elif m := re.fullmatch(r"typedef struct (ups_\w+) (ups_\w+)", s):
        api.handles.append(m[2])
    elif m := re.fullmatch(r"typedef struct(?: \w+)? \{(.*)\} (ups_\w+)", s):
        fields = [v for line in m[1].split(";") if line.strip() for v in _variables(line.strip(), header)]
        api.structs.append(Struct(m[2], fields))
    elif m := re.fullmatch(r"UPS_API (.*?)(\w+)\((.*)\)", s):
        parameters = [] if m[3] in ("", "void") else [_variables(p.strip(), header)[0] for p in m[3].split(",")]
        api.functions.append(Function(m[2], _variables(m[1] + " result", header)[0].type, parameters, header))
    else:
        raise HeaderError(f"{header}: not in the style of these headers: {s!r}")


def _parse_enum(api, body, header):
    members = []
    for item in filter(None, (i.strip() for i in body.split(","))):
        m = re.fullmatch(r"(UPS_\w+) = (-?\d+)", item)
        if not m:
            raise HeaderError(f"{header}: an enumerator needs an explicit value: {item!r}")
        members.append((m[1], int(m[2])))
    named = {e.name for e in api.enums}
    last = list(api.aliases)[-1] if api.aliases else None  # `typedef int32_t ups_x;` comes right before its enum
    flags = all(v > 0 and v & (v - 1) == 0 for _, v in members)
    if (last is None or last in named) and not flags:
        raise HeaderError(f"{header}: an enum without its typedef: {members[0][0]}")
    api.enums.append(Enum(None if flags or last in named else last, members))


def _variables(s, header):
    """`const float *a, *b[3]` is two variables; each declarator has its own stars and its own array length."""
    m = re.fullmatch(r"(const )?(\w+) ?(.*)", s)
    variables = []
    for declarator in m[3].split(",") if m else []:
        d = re.fullmatch(r"(\**) ?(\w+)(?:\[(\d+)\])?", declarator.strip())
        if not d:
            break
        variables.append(Variable(d[2], Type(m[2], bool(m[1]), len(d[1]), int(d[3] or 0))))
    if not m or len(variables) != len(m[3].split(",")):
        raise HeaderError(f"{header}: not a declaration in the style of these headers: {s!r}")
    return variables
