#!/usr/bin/env python3
"""Writes the raw layer of both bindings from include/ups/*.h: python/ups/_ffi.py, _fields.py and csharp/Ups.Native.cs.

    bindings/generate.py            writes these files
    bindings/generate.py --check    fails when they are not what the headers say (a test runs this)

What people use stands on top, written by hand: the other files of both folders.
"""
import difflib
import re
import sys
import textwrap
from pathlib import Path

import c_header

HERE = Path(__file__).resolve().parent

# The C scalars that these headers use: ctypes' name and C#'s.
CTYPES = {"void": None, "char": "c_char", "float": "c_float", "double": "c_double", "size_t": "c_size_t",
          "int32_t": "c_int32", "uint8_t": "c_uint8", "uint32_t": "c_uint32", "uint64_t": "c_uint64"}
CSHARP = {"void": "void", "char": "byte", "float": "float", "double": "double", "size_t": "UIntPtr", "int32_t": "int",
          "uint8_t": "byte", "uint32_t": "uint", "uint64_t": "ulong"}


def pascal(name):
    """to_world and PATH_TRACING become ToWorld and PathTracing; a type's own prefix goes: ups_mesh_desc is MeshDesc."""
    return "".join(w[:1].upper() + w[1:] for w in re.sub("^ups_", "", name.lower()).split("_"))


def enum_members(enum):
    """(name without the common prefix, value) of each member."""
    prefix = c_header.common_prefix(enum)
    return [(name[len(prefix):], value) for name, value in enum.members]


def enum_name(enum):
    return pascal(enum.name or c_header.common_prefix(enum).rstrip("_"))


# ---- Python


def ctypes_type(api, t, in_struct=False):
    if t.name in api.handles:  # a handle is an address; out-parameters are the address of one
        base, stars = "c_void_p", t.pointers - 1
    elif t.name == "void" and t.pointers:
        base, stars = "c_void_p", t.pointers - 1
    elif t.name == "char" and t.pointers:
        base, stars = "c_char_p", t.pointers - 1
    elif t.name in api.aliases:
        base, stars = CTYPES[api.aliases[t.name]], t.pointers
    else:
        base, stars = CTYPES[t.name] if t.name in CTYPES else pascal(t.name), t.pointers
    if t.count and not in_struct:  # an array parameter is a pointer
        stars += 1
    for _ in range(stars):
        base = f"POINTER({base})"
    return f"{base} * {t.count}" if t.count and in_struct else str(base)


def python_type(api, t):
    """Of a field of a struct, as a type checker sees it."""
    if t.name == "char" and t.pointers == 1:
        return "bytes | None"
    if t.pointers:
        return "Any"
    if t.count:
        return f"Array[{ctypes_type(api, t._replace(count=0), in_struct=True)}]"
    if t.name in CTYPES or t.name in api.aliases:
        return "float" if t.name in ("float", "double") else "int"
    return pascal(t.name)


def python_struct(api, struct):
    base = "Id, Structure" if struct.name in api.ids() else "Structure"
    out = ["", f"class {pascal(struct.name)}({base}):"]
    out += [f"    {f.name}: {python_type(api, f.type)}" for f in struct.fields]
    out += ["    _fields_ = ["]
    out += [f'        ("{f.name}", {ctypes_type(api, f.type, in_struct=True)}),' for f in struct.fields]
    return out + ["    ]", ""]


def python_integer(api, parameter):
    """Whether a program's own number may go there; sizes and counts are those of arrays."""
    t = parameter.type
    integer = t.name in api.aliases or t.name in ("int32_t", "uint32_t")
    return integer and not t.pointers and not t.count and parameter.name != "struct_size"


def python_prototypes(api, header_names):
    out = []
    for f in api.functions:
        if f.header in header_names:
            parameters = ", ".join(ctypes_type(api, p.type) for p in f.parameters)
            integers = ",\0".join(f'{i}:\0"{p.name}"' for i, p in enumerate(f.parameters) if python_integer(api, p))
            line = f'        "{f.name}": ({ctypes_type(api, f.returns)}, [{parameters}], {{{integers}}}),'
            out += [part.replace("\0", " ") for part in textwrap.wrap(line, 120, subsequent_indent=" " * 12)]
    return out


def python_source(api):
    v = api.version
    out = ['"""The C API of UPS as ctypes. Written by bindings/generate.py from include/ups; do not edit."""',
           "from __future__ import annotations", "", "import enum",
           "from ctypes import (POINTER, Array, Structure, c_char_p, c_double, c_float, c_int32, c_size_t, c_uint8,",
           "                    c_uint32, c_uint64, c_void_p)", "from typing import Any", "", "from ._id import Id", "",
           f"HEADER_VERSION = ({v['MAJOR']}, {v['MINOR']}, {v['PATCH']})", ""]
    for enum in api.enums:
        out += ["", f"class {enum_name(enum)}(enum.{'IntEnum' if enum.name else 'IntFlag'}):"]
        out += [f"    {name} = {value}" for name, value in enum_members(enum)] + [""]
    for struct in api.structs:
        out += python_struct(api, struct)
    out += ["", "# Of each library: result and parameters of each function, and which are integers that need a check.",
            "PROTOTYPES: dict[str, dict[str, tuple[Any, list[Any], dict[int, str]]]] = {", '    "ups": {',
            *python_prototypes(api, c_header.CORE_HEADERS), "    },"]
    for header in c_header.EXTRA_HEADERS:
        out += [f'    "{Path(header).stem}": {{', *python_prototypes(api, (header,)), "    },"]
    out += ["}", "", "# Function that fills each description with its defaults.", "INIT: dict[Any, str] = {"]
    out += [f'    {pascal(s.name)}: "{s.name}_init",' for s in api.structs if api.function(s.name + "_init")]
    out += ["}", ""]
    return "\n".join(out)


# Fields that the methods have as parameters of their own, or count by themselves.
PYTHON_PARAMETERS = {
    "ups_profile_desc": ("c_count", "gamma_count"),
    "ups_profile_parse_desc": ("format", "size", "tilt_file_size"),
    "ups_material_desc": ("pane_angle_count",),
    "ups_instance_desc": ("mesh",),
    "ups_camera_desc": ("width", "height"),
    "ups_meter_desc": ("count",),
    "ups_surface_meters_desc": ("instance_count",),
    "ups_lightmap_desc": ("instance_count", "width", "height"),
    "ups_reflector_desc": ("profile_point_count",),
    "ups_collimator_desc": ("wall_point_count",),
}


def keyword_type(api, t):
    """Of a keyword argument for such a field. None: it has none, the functions that take it have arrays or handles."""
    if t.pointers:
        return None
    if t.count:
        return "ArrayLike"
    kind = python_type(api, t)
    return {"int": "SupportsIndex", "float": "SupportsFloat"}.get(kind, f"_ffi.{kind}")


def python_fields_source(api):
    out = ['"""The keyword arguments that stand for C descriptions, for type checkers alone: no program imports this.',
           "Written by bindings/generate.py from include/ups; do not edit.", '"""',
           "from typing import SupportsFloat, SupportsIndex, TypedDict", "", "from numpy.typing import ArrayLike", "",
           "from . import _ffi", ""]
    for struct in api.structs:
        if not api.function(struct.name + "_init"):
            continue
        out += ["", f"class {pascal(struct.name)}Fields(TypedDict, total=False):"]
        fields = [(f.name, keyword_type(api, f.type)) for f in struct.fields
                  if f.name not in ("struct_size", *PYTHON_PARAMETERS.get(struct.name, ()))
                  and not f.name.startswith("reserved")]
        out += [f"    {name}: {kind}" for name, kind in fields if kind] + [""]
    return "\n".join(out)


# ---- C#

CSHARP_KEYWORDS = {"out", "in", "ref", "params", "object", "string", "fixed", "event", "checked"}


def csharp_value_type(api, t, in_struct):
    if t.name in api.handles:
        if in_struct:
            return "IntPtr"
        return f"{pascal(t.name)}Handle" if t.pointers == 1 else f"out {pascal(t.name)}Handle"
    base = CSHARP[t.name] if t.name in CSHARP else pascal(t.name)
    stars = t.pointers + (1 if t.count and not in_struct else 0)
    return base + "*" * stars


def csharp_array_type(kind, count):
    return f"{pascal(kind)}{count}"


def csharp_array(kind, count):
    """An array inside a struct: a struct itself, which stands in a field, so that its elements are set in place."""
    name = csharp_array_type(kind, count)
    pin = f"fixed ({kind}* p = values_)"
    return ["/// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole."
            "</summary>",
            "[StructLayout(LayoutKind.Sequential)]", f"public unsafe struct {name} : IEnumerable<{kind}>", "{",
            f"    private fixed {kind} values_[{count}];",
            f"    public int Length {{ get {{ return {count}; }} }}",
            f"    public {kind} this[int index]", "    {",
            f"        get {{ {pin} return p[Elements.Index(index, {count})]; }}",
            f"        set {{ {pin} p[Elements.Index(index, {count})] = value; }}",
            "    }",
            f"    public {kind}[] ToArray() {{ {pin} return Elements.Copy(p, {count}); }}",
            f"    public static implicit operator {kind}[]({name} from) {{ return from.ToArray(); }}",
            f"    public static implicit operator {name}({kind}[] from) {{ return new ReadOnlySpan<{kind}>(from); }}",
            f"    public static implicit operator {name}(ReadOnlySpan<{kind}> from)", "    {",
            f"        var to = new {name}();",
            f'        Elements.Set(to.values_, {count}, from, "{name}");',
            "        return to;", "    }",
            f"    public IEnumerator<{kind}> GetEnumerator() "
            f"{{ return ((IEnumerable<{kind}>)ToArray()).GetEnumerator(); }}",
            "    IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }", "}", ""]


def csharp_struct(api, struct):
    name = pascal(struct.name)
    of_addresses = all(f.type.pointers or f.name.endswith("_bytes") for f in struct.fields)
    out = ["[StructLayout(LayoutKind.Sequential)]",
           f"{'internal' if of_addresses else 'public'} unsafe struct {name}", "{"]
    for f in struct.fields:
        kind = csharp_value_type(api, f.type, in_struct=True)
        if not f.type.count:
            access = "internal" if f.type.pointers else "public"  # the written classes pin what an address is of
            out.append(f"    {access} {kind} {pascal(f.name)};")
            continue
        out.append(f"    public {csharp_array_type(kind, f.type.count)} {pascal(f.name)};")
    if api.function(struct.name + "_init"):
        out += ["    /// <summary>With the library's defaults.</summary>",
                f"    public static {name} Create()", "    {", f"        var d = new {name}();",
                f"        Native.{struct.name}_init(&d, (uint)sizeof({name}));", "        return d;", "    }"]
    elif struct.fields[0].name == "struct_size":
        out += [f"    internal static {name} Sized()", "    {",
                f"        return new {name} {{ StructSize = (uint)sizeof({name}) }};", "    }"]
    return out + ["}", ""]


def csharp_library(library):
    """The constant with the file name of a library: Library of the core, GltfLibrary."""
    return ("" if library == "ups" else pascal(library)) + "Library"


def csharp_parameter(api, p, destroys):
    kind = "IntPtr" if destroys else csharp_value_type(api, p.type, in_struct=False)
    return f"{kind} {'@' if p.name in CSHARP_KEYWORDS else ''}{p.name}"


def csharp_source(api):
    v = api.version
    out = ["// The C API of UPS as P/Invoke. Written by bindings/generate.py from include/ups; do not edit.",
           "using System;", "using System.Collections;", "using System.Collections.Generic;",
           "using System.Runtime.InteropServices;", "", "namespace Ups", "{"]
    body = []
    for enum in api.enums:
        body += ["[Flags]"] if enum.name is None else []
        body += [f"public enum {enum_name(enum)} : {'int' if enum.name else 'uint'}", "{"]
        body += [f"    {pascal(name)} = {value}," for name, value in enum_members(enum)] + ["}", ""]
    for kind, count in sorted({(csharp_value_type(api, f.type, in_struct=True), f.type.count)
                               for struct in api.structs for f in struct.fields if f.type.count}):
        body += csharp_array(kind, count)
    for struct in api.structs:
        body += csharp_struct(api, struct)
    for handle in api.handles:
        name = pascal(handle)
        body += [f"public sealed class {name}Handle : NativeHandle", "{",
                 f"    protected override bool ReleaseHandle() {{ Native.{handle}_destroy(handle); return true; }}",
                 "}", ""]
    abi = f"{v['MAJOR']}" + (f".{v['MINOR']}" if v["MAJOR"] == 0 else "")
    body += ["internal static unsafe class Native", "{"]
    for library in ("ups", *(Path(h).stem for h in c_header.EXTRA_HEADERS)):
        body.append(f'    private const string {csharp_library(library)} = "lib{library}.so.{abi}";')
    body += [f"    internal const uint HeaderVersion = {v['MAJOR'] * 10000 + v['MINOR'] * 100 + v['PATCH']};", ""]
    for f in api.functions:
        destroys = any(f.name == h + "_destroy" for h in api.handles)
        returns = "IntPtr" if f.returns.pointers else csharp_value_type(api, f.returns, in_struct=False)
        parameters = ", ".join(csharp_parameter(api, p, destroys) for p in f.parameters)
        library = "ups" if f.header in c_header.CORE_HEADERS else Path(f.header).stem
        body.append(f"    [DllImport({csharp_library(library)}, CallingConvention = CallingConvention.Cdecl, "
                    "ExactSpelling = true)]")
        line = f"    internal static extern {returns} {f.name}({parameters});"
        body += [line] if len(line) <= 116 else textwrap.wrap(line, 116, subsequent_indent=" " * 8)
    body += ["}"]
    out += [("    " + line if line else "") for line in "\n".join(body).split("\n")]
    return "\n".join(out + ["}", ""])


def main():
    include = HERE.parent / "include" / "ups"
    api = c_header.parse_headers(include, c_header.CORE_HEADERS + c_header.EXTRA_HEADERS)
    stale = 0
    for path, text in ((HERE / "python" / "ups" / "_ffi.py", python_source(api)),
                       (HERE / "python" / "ups" / "_fields.py", python_fields_source(api)),
                       (HERE / "csharp" / "Ups.Native.cs", csharp_source(api))):
        if sys.argv[1:] == ["--check"]:
            committed = path.read_text(encoding="utf-8") if path.exists() else ""
            difference = list(difflib.unified_diff(committed.splitlines(), text.splitlines(),
                                                   str(path.relative_to(HERE)), "from the headers", lineterm=""))
            print(*difference, sep="\n", end="\n" if difference else "")
            stale += bool(difference)
        else:
            path.write_text(text, encoding="utf-8")
    if stale:
        sys.exit("The bindings are older than the headers: run bindings/generate.py and commit what it writes.")


if __name__ == "__main__":
    main()
