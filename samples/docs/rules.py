"""What follows from a function's signature by the rules of the API: parameters and units, errors, lifetime, threads.

Called by make_pages.py. The rules stand in ups_base.h; where one does not fit a function, functions.txt or the header
says what is so.
"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bindings"))
import c_header  # noqa: E402

UNITS = {"_cd_m2": "cd/m²", "_per_m": "1/m", "_m2": "m²", "_m": "m", "_cd": "cd", "_lm": "lm", "_lx": "lx", 
         "_rad": "rad", "_deg": "degrees", "_s": "s", "_ms": "ms", "_w": "W", "_k": "K", "_sr": "sr",
         "_bytes": "bytes", "_ev100": "EV"}
NO_UNIT = {"ior_k"}  # the imaginary part of an index

HANDLES = {"ups_context": "The context", "ups_profile": "The profile", "ups_scene": "The scene", "ups_job": "The job",
           "ups_result": "The result", "ups_fixture": "The fixture", "ups_path": "The path",
           "ups_exr_image": "The image", "ups_gltf_import": "What was imported"}

# A parameter by its name; {} is its noun where one is told below.
PARAMETERS = {
    "struct_size": "`sizeof` the struct, of the header that the program was built with.",
    "desc": "What it is to be: filled by {init} first, then changed.",
    "id": "Of what is meant.",
    "capacity": "How much the memory before it holds: elements, of text bytes. 0 to ask for the size alone.",
    "needed": "Gets how much there is: elements, of text bytes with the final zero. NULL where nobody asks.",
    "text": "Gets the text, UTF-8 with a final zero; NULL with capacity 0 to ask for its size.",
    "bytes": "The file's bytes.", "size": "How many bytes.", "format": "How the file is written.",
    "to_world": "3x4, row-major, object to world; m.",
    "index": "From 0, below the count.",
    "count": "How many elements the array has.",
    "sensor": "A sensor of the scene that was rendered.", "camera": "A camera of the scene that was rendered.",
    "observer": "An observer of the scene that was rendered.", "meters": "A set of meters.",
    "numerator": "A set of meters.", "denominator": "A set of meters.",
    "topic": "Which text.", "path": "Of the file, UTF-8.", "name": "Which, UTF-8 with a final zero.",
    "value": "A line of UTF-8 with a final zero.", "part": "Which part.", "kind": "Which kind.",
    "width": "Pixels.", "height": "Pixels.", "channel": "Which channel.",
    "row_stride_bytes": "From one row to the next; 0: tight.", "size_bytes": "Of the memory at `out`.",
    "dimming": "Multiplies the flux, at least 0; 1 is full light.", "factor": "Above 0, at most 1.",
    "relative_error": "Above 0 and finite; 0.01 is 1 %.", "timeout_ms": "How long to wait at most; 0: only look.",
    "fraction": "Of the peak, above 0, at most 1.", "c_deg": "The plane, any finite angle.",
    "front_c_deg": "Where the front of an outdoor luminaire faces, finite.",
    "directions_xyz": "3 values a direction, any length above 0.",
    "exposure": "Factor from cd/m² to the view's scene-linear values, above 0.",
    "ev100": "Finite, within -100 and 100.",
    "luminance_rgb": "3 floats a pixel, cd/m², linear Rec.709, row 0 at the top.",
    "rgb": "3 bytes a pixel, sRGB, row 0 at the top.", "out_rgb": "Gets 3 floats a pixel; may be the image itself.",
    "threshold_lx": "Finite.", "share": "0 to 1.", "depth_m": "Above 0; infinite: all.",
    "point_m": "Of the plane.", "normal": "Of the plane, any length above 0.",
    "vertex_count": "As many as the mesh has.", "source": "Index of the source, below the count.",
    "position_index": "Of each source; below 0: left out.", "solid_angle_sr": "Of each source.",
    "background_cd_m2": "Above 0.", "contribution": "Weighted or not.", "level": "Gets the level; may be NULL.",
    "sample": "Which sample: its value and share are not read.", "status": "Any value.",
    "channels": "The channels, `channel_count` of them.", "channel_count": "At least 1.",
    "attributes": "Strings for the file's header, `attribute_count` of them.", "attribute_count": "May be 0.",
    "c_count": "How many planes the array holds.", "gamma_count": "How many angles the array holds.",
}
# By function and name, where the name alone does not say it.
OF_FUNCTION = {
    "ups_profile_write.bytes": "Gets the file's text; NULL with capacity 0 to ask for its size.",
    "ups_profile_get_beam.beam": None, "ups_context_create.desc": "What it is to be; NULL: all defaults.",
    "ups_gltf_import_file.desc": "How to import; NULL: all defaults.",
    "ups_glare_get_position_index.index": "Gets an index for each direction.",
    "ups_glare_get_position_index.kind": "The table of CIE 117 or Guth's formula.",
    "ups_glare_get_ugr.luminance_cd_m2": "Of each source.", "ups_glare_get_ugr.ugr": "Gets the rating.",
    "ups_profile_get_luminance.luminance_cd_m2": "Gets a luminance for each direction.",
    "ups_profile_eval.intensity_cd": "Gets an intensity for each direction.",
    "ups_profile_get_zonal_flux.flux_lm": "Gets count - 1 values.",
    "ups_profile_get_zonal_flux.gamma_deg": "Ascending, within 0 and 180.",
    "ups_profile_get_zonal_flux.count": "How many angles, at least 2.",
    "ups_result_get_goniometer_angles.c_deg": "Gets the planes.",
    "ups_result_get_goniometer_angles.gamma_deg": "Gets the angles from the nadir.",
    "ups_result_read_image.out": "Gets the rows; how many floats a pixel and of what: ups_channel.",
    "ups_result_view_meters.readings": "Gets where they are, `count` of them.",
    "ups_result_view_meters.count": "Gets how many there are.",
    "ups_result_view_image.pixels": "Gets where they are, tight rows; how many floats a pixel and of what: ups_channel.",
    "ups_result_view_image.width": "Gets the pixels in a row.",
    "ups_result_view_image.height": "Gets the rows.",
    "ups_result_read_technique.out": "Gets the rows; 3 floats a pixel, cd/m².",
    "ups_exr_get_size.width": "Gets the pixels in a row.", "ups_exr_get_size.height": "Gets the rows.",
    "ups_gltf_get_source_name.id": "The `v` of its ups_luminaire_id or ups_instance_id.",
    "ups_gltf_get_source_file.id": "The `v` of its ups_luminaire_id.",
    "ups_gltf_get_place.id": "The `v` of its id, or the number that a message names.",
    "ups_gltf_read_meters.positions_m": "Gets 3 values a meter; may be NULL.",
    "ups_gltf_read_meters.normals": "Gets 3 values a meter, of length 1; may be NULL.",
    "ups_scene_set_mesh_vertices.positions_m": "3 values a vertex, tight.",
    "ups_scene_set_mesh_vertices.normals": "3 values a vertex, tight; NULL: as they are.",
    "ups_replay.desc": "As of the render that the sample is of; seed and limits are not read.",
    "ups_ocio_write_png.exposure": "Factor from cd/m² to the view's scene-linear values; 0: chosen from the image.",
}
NOTHING = "<span></span>"  # the name says it
OPTIONAL = ("info", "level", "needed", "normals", "positions_m")  # pointers that may be NULL
READS_SCENE = {"ups_render", "ups_job_start", "ups_replay", "ups_scene_estimate_memory"}


def unit(name):
    base = re.sub(r"_(rgb|rz)$", "", name)
    if base in NO_UNIT:
        return ""
    return next((u for suffix, u in UNITS.items() if base.endswith(suffix) or base.startswith(suffix[1:] + "_")), "")


def _noun(type_name):
    return type_name.removeprefix("ups_").removesuffix("_desc").replace("_", " ")


def parameter(function, p):
    t, key = p.type, f"{function.name}.{p.name}"
    if OF_FUNCTION.get(key):
        said = OF_FUNCTION[key]
    elif t.name in HANDLES and t.pointers == 1:
        said = HANDLES[t.name] + ("; NULL: nothing is done." if function.returns.name == "void" else ".")
    elif t.name in HANDLES and t.pointers == 2:
        said = f"Gets the {_noun(t.name)}; as it was where the call fails."
    elif t.name.endswith("_desc") and not t.const:
        said = ("Gets the defaults." if function.name.endswith("_init") else
                "Its struct_size is set by the caller; the rest is written, at most that many bytes.")
    elif t.name.startswith("ups_") and t.pointers and not t.const and p.name not in ("sample", "desc"):
        said = _output(function, p)
    elif p.name == "out":
        said = "Gets the answer; as it was where the call fails."
    elif p.name in ("texels",):
        said = "Gets the texels; NULL with capacity 0 to ask for their number."
    elif p.name == "id":
        said = f"The {_noun(t.name.removesuffix('_id'))}, of this scene."
    else:
        said = PARAMETERS[p.name]
    said = said.replace("{init}", t.name + "_init()" if t.name.endswith("_desc") else "")
    return f"[{unit(p.name)}] {said}" if unit(p.name) and p.name not in ("size_bytes", "row_stride_bytes") else said


def _output(function, p):
    names = {q.name for q in function.parameters}
    if p.type.name.endswith("_id"):
        return "Gets the id." if "part" not in p.type.name else "Gets the part's number; may be NULL."
    if "capacity" in names and p.name != "info":
        return (PARAMETERS["level"] if p.name == "level" else
                "Gets the elements; NULL with capacity 0 to ask for their number.")
    if "count" in names:
        return "Gets count elements."
    if p.type.name == "ups_interval":
        return "Gets value and interval."
    return ("Its struct_size is set by the caller; the rest is written, at most that many bytes."
            + (" May be NULL." if function.name == "ups_en12464_grid" else ""))


def returns(function):
    if function.name == "ups_version":
        return "10000 times the major version, 100 times the minor one and the patch, added up."
    if function.returns.pointers:
        return "A string with a final zero, never NULL."
    if function.name == "ups_job_wait":
        return "UPS_OK, UPS_TIMEOUT, UPS_CANCELLED, or the error that ended the job."
    if function.name == "ups_context_pop_log":
        return "UPS_OK, also where the log is empty; else a status below 0."
    if any(p.name == "capacity" for p in function.parameters):
        return "UPS_OK, or a status below 0; then the outputs are as they were, but for needed."
    return "UPS_OK, or a status below 0; then the outputs are as they were."


def split_errors(comment):
    """(the rest of the text, what stands behind "Errors:")."""
    m = re.search(r"\s*\bErrors: (.*?)(?=\n(?![ \w])|\Z)", comment, re.S)
    if not m:
        return comment, []
    return (comment[:m.start()] + comment[m.end():]).strip(), [" ".join(m[1].split())]


def faults(function):
    """(parameter, kind, when) for each INVALID_ARGUMENT that the parameters tell. kind: null; id, one that names nothing;
    desc, without its struct_size; size, an output without; memory, of which there is none; index, beyond the last.
    Each is tried by tests/docs/errors.py."""
    names = {p.name for p in function.parameters}
    rendered = any(p.type.name == "ups_result" for p in function.parameters)
    for p in function.parameters:
        t = p.type
        if t.name in HANDLES and t.pointers == 1:
            yield p, "null", f"{p.name} is NULL" + ("" if function.header in c_header.EXTRA_HEADERS else
                                                    " or of another copy of the library")
        elif t.name.endswith("_id") and not t.pointers:
            yield p, "id", (f"{p.name} names nothing of that kind in what was rendered" if rendered else
                            f"{p.name} is of another scene, of another kind, or was removed")
        elif t.name.endswith("_desc") and t.const:
            yield p, "desc", "a field of desc is out of its range or struct_size is not set"
        elif p.name == "capacity":
            yield p, "memory", "capacity is not 0 and the memory is NULL"
        elif t.pointers and not t.const and "capacity" not in names and p.name not in OPTIONAL and (
                t.name != "ups_fixture_part_id"):
            yield p, "null", f"{p.name} is NULL" + (", or its struct_size is not set" if _sized(t) else "")
            if _sized(t):
                yield p, "size", f"{p.name} is NULL, or its struct_size is not set"
        elif t.pointers and t.const and (t.name == "char" or "_view_" in function.name):
            yield p, "null", f"{p.name} is NULL"
        elif p.name in ("index", "source") and not t.pointers:
            yield p, "index", f"{p.name} is not below the count"


def can_fail(function):
    return function.returns.name == "ups_status" and not function.returns.pointers


def errors(function, listed, said):
    """Lines: what the table says, what the header says, what the parameters tell."""
    if not can_fail(function):
        return
    if function.name in ("ups_job_wait",):
        yield "Those of the render or commit that the job is, such as OUT_OF_MEMORY."
    yield from (f"{status}: {when}." for status, when in listed)
    yield from (s[0].upper() + s[1:] for s in said)
    wrong = [when for _, _, when in faults(function)]
    if wrong:
        yield "INVALID_ARGUMENT: " + "; ".join(dict.fromkeys(wrong)) + "."
    if any(p.name == "capacity" for p in function.parameters) and "BUFFER_TOO_SMALL" not in " ".join(said):
        yield "BUFFER_TOO_SMALL: there is more than capacity; needed tells how much."
    if any(p.type.name.endswith("_desc") and p.type.const for p in function.parameters):
        yield "UNSUPPORTED: desc has a field of a later version, and it is set."
    if function.name.startswith("ups_scene_add_"):
        yield "UNSUPPORTED: there are 16,777,215 of the kind already."
    if not any("OUT_OF_MEMORY" in status for status, _ in listed):
        yield "OUT_OF_MEMORY: there is no memory for what the call needs; nothing is held."


def _sized(t):
    """Whether it is a struct that begins with struct_size."""
    plain = re.search(r"_(id|interval|reading|segment|point|sample|vertex|contribution|place)$", t.name)
    return t.name.startswith("ups_") and t.pointers == 1 and t.name not in HANDLES and (
        not plain or t.name in ("ups_observer_reading", "ups_curve_point"))


def lifetime(function):
    name, types = function.name, [(p.type.name, p.type.pointers) for p in function.parameters]
    made = next((t for t, stars in types if t in HANDLES and stars == 2), None)
    if name.endswith("_init"):
        return "Nothing is kept and nothing is allocated: desc is the caller's."
    if name.endswith("_destroy"):
        return ("The handle is not valid afterwards. What others still need of it stays, in whatever order things are "
                "destroyed.")
    if made:
        return (f"The caller owns *out and gives it up by {made}_destroy(). It keeps alive what it needs; what was "
                "passed in may be destroyed.")
    if function.returns.pointers:
        return "Static, never to be freed." if name == "ups_status_name" else (
            "The text is the library's, until this thread's next failing call.")
    if "_add_" in name:
        kind = "part" if name.startswith("ups_fixture_add") else "thing"
        said = "What desc points to is copied and may go after the call. "
        return said + ("The number names the part as long as there is the fixture." if kind == "part" else
                       "The id names the thing until it is removed or the scene ends, and is never handed out again.")
    if name.startswith("ups_scene_get_") and any(t.endswith("_desc") for t, _ in types):
        return "Arrays in desc are the scene's own: valid until that thing is set or removed or the scene is destroyed."
    if name.startswith(("ups_scene_set_", "ups_fixture_set")):
        return "What is passed in is copied and may go after the call. It takes effect at the next commit."
    if name.startswith("ups_scene_remove_"):
        return ("The id is never handed out again. The memory comes back after the next commit, once no render and no "
                "result of earlier ones is left.")
    if "_view_" in name:
        return "What is handed out is the result's own, not to be written to, and goes with it: copy what shall stay."
    if any(p.type.pointers and not p.type.const and p.type.name not in HANDLES for p in function.parameters):
        return "What is written is the caller's own copy: it stays when the handle goes."
    return "Nothing is handed out."


def threads(function):
    name = function.name
    handles = [p.type for p in function.parameters if p.type.name in HANDLES and p.type.pointers == 1]
    if name.endswith("_destroy"):
        return "Any, as the last call on that handle: nothing else may run on it, or come after."
    first = next((t for t in handles), None)
    changed = next((t.name for t in handles if not t.const and t.name in ("ups_scene", "ups_fixture")), None)
    if name in ("ups_last_error", "ups_gltf_last_error", "ups_exr_last_error", "ups_ocio_last_error",
                "ups_report_last_error"):
        return "Any: each thread has its own."
    if changed == "ups_fixture":
        return "One call at a time on a fixture."
    if changed == "ups_scene":
        extra = " Jobs that were started and results go on meanwhile."
        if name.startswith("ups_scene_start_commit"):
            extra = " Edits and renders of the scene may go on while the job runs."
        if "ups_fixture" in (t.name for t in handles):
            extra += " Nothing may change the fixture meanwhile."
        return "One call at a time on a scene." + extra
    if first is None:
        return "Any, at the same time as any other call."
    if first.name == "ups_scene":
        if name in READS_SCENE:
            return ("Any, at the same time as other calls that only read the scene, other renders among them; not "
                    "beside one that changes it. A render that has started goes on with what was committed.")
        return "Any, at the same time as other calls that only read the scene; not beside one that changes it."
    if first.name == "ups_fixture":
        return "Any, at the same time as other calls that only read the fixture."
    return "Any, at the same time as any other call on the same handle."


def related(function):
    """The function that fills its desc."""
    for p in function.parameters:
        if p.type.name.endswith("_desc") and p.type.const and p.type.name != "ups_material_desc" or p.name == "desc":
            if not function.name.endswith("_init"):
                yield p.type.name + "_init"


def struct_summary(declaration):
    name = declaration.name
    if name.endswith("_id"):
        return f"Names a {_noun(name.removesuffix('_id'))}; v 0 is the null id."
    if name.endswith("_desc"):
        return f"Filled with defaults by {name}_init; then a program changes what differs."
    first = re.split(r"(?<=[.:])\s", " ".join(declaration.comment.split()), maxsplit=1)[0]
    return first or "Written by the library."


def declarators(statement):
    """(name, declaration) of each variable of `const float *a, *b[3]`."""
    base, rest = re.match(r"((?:const )?\w+) ?(.*)", statement).groups()
    for d in rest.split(","):
        d = d.strip()
        yield re.search(r"\w+", d)[0], f"{base} {d}"


def common_fields(remark):
    """(pattern of names, text) of what a remark says of fields that several structs have, a line or more each."""
    found = []
    for line in remark.split("\n"):
        if m := re.match(r"  (\w[\w*, ]*?)  +(.*)", line):
            found.append([m[1], m[2]])
        elif found and line.startswith("      "):
            found[-1][1] += " " + line.strip()
        elif found:
            break
    return [(re.compile("|".join(n.replace("*", r"\w+") for n in names.split(", "))), text) for names, text in found]


def field(name, comment, common):
    if name == "struct_size":
        return "sizeof the struct; comment".replace("; comment", "; " + comment if comment else "")
    if name.startswith("reserved") and not comment:
        return "0."
    u = unit(name)
    said = " ".join(comment.split()) or next((text for names, text in common if names.fullmatch(name)), "")
    return (f"[{u}] " if u else "") + said or NOTHING


def theme_summary(remark):
    """The first sentence of a header's first comment, without what says of which project and library it is."""
    first = remark.split("\n\n")[0].replace("\n", " ")
    first = re.sub(r"^UPS(?: extra)?: ", "", first)
    return first[0].upper() + first[1:]


def theme_text(remarks):
    """Of the header's first comment what follows its first paragraph, and all others."""
    if not remarks:
        return []
    rest = remarks[0].split("\n\n", 1)
    return rest[1:] + remarks[1:]
