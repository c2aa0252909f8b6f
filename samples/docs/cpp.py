"""The C++ classes as Doxygen reads them: declarations without bodies, each with its comment and the C
functions that it calls.

Called by make_pages.py. It understands the style of include/ups/ups.hpp and hpp/ alone: // comments before or behind a
declaration, one indentation a level, a namespace `detail` that is nobody's business.
"""
import re

NOTHING = "<span></span>"  # its name says it
PARTS = ("base", "transform", "profile", "descs", "fixture", "replay", "result", "job", "scene", "standards")


def _without(text, opening):
    """Without each block that opens so, by counting braces."""
    while m := re.search(opening, text):
        depth, end = 0, m.end() - 1
        while True:
            depth += (text[end] == "{") - (text[end] == "}")
            end += 1
            if depth == 0:
                break
        text = text[:m.start()] + text[end:]
    return text


def _signature(chunk):
    """What a chunk declares, without a function's body or a constructor's initialisers."""
    text = re.sub(r"\s*//.*", "", chunk)
    depth = opened = angle = 0
    for i, c in enumerate(text):
        depth += (c == "(") - (c == ")")
        opened += c == "("
        if depth or not opened:
            continue
        if c == "{" or re.match(r"\)\s*(const )?(noexcept )?\s*:\s", text[i:]):
            keep = i if c == "{" else i + re.match(r"\)\s*(?:const )?(?:noexcept)?", text[i:]).end()
            return text[:keep].strip() + ";"
    return text.strip()


def _complete(chunk):
    code = re.sub(r"//.*", "", chunk).rstrip()
    balanced = code.count("{") == code.count("}") and code.count("(") == code.count(")")
    return balanced and code.endswith((";", "}"))


def _documented(comment, chunk, known):
    said = " ".join(filter(None, [comment, *re.findall(r"// (.*)", chunk.split("\n")[0])]))
    used = [n for n in dict.fromkeys(re.findall(r"\bups_\w+", re.sub(r"//.*", "", chunk))) if n in known]
    return said, used


def declarations(header, text, known, escaped):
    """Lines of a header with documentation comments."""
    text = re.sub(r"^#.*(?:\\\n.*)*\n", "", text, flags=re.M)
    text = _without(text, r"namespace detail \{")
    text = re.sub(r"^(inline )?namespace \w+ \{\n|^\}  // namespace \w+\n", "", text, flags=re.M)
    text = re.sub(r"\A(//.*\n)+", "", text)
    out, comment, chunk, scope, hidden = [], [], "", [], False
    for line in text.split("\n"):
        bare = line.strip()
        if not chunk:
            if re.match(r"// ----|//\s*$", bare):
                comment = []
                continue
            if bare.startswith("//"):
                comment.append(bare[2:].strip())
                continue
            if bare in ("public:", "private:", "protected:"):
                hidden = bare != "public:"
                out.append(bare)
                continue
            if bare == "};":
                scope.pop()
                out.append(bare)
                hidden, comment = False, []
                continue
            if not bare or bare.startswith("using "):
                comment = []
                continue
        chunk += line + "\n"
        opens = re.match(r"(?:template <[^>]*>\s*)?(?:class|struct) (\w+)[^({;]*\{$", chunk.strip())
        if opens and not hidden:
            base = re.search(r": (ups_\w+_desc)", chunk)
            said = " ".join(comment) or (f"{base[1]}, filled with the defaults." if base else opens[1])
            out += [f"/** @ingroup cpp\n@brief {escaped(said)}\n",
                    f"Declared in <tt>ups/{header}</tt>, in namespace ups. */", re.sub(r"\s*//.*", "", chunk).strip()]
            if chunk.strip().startswith(("struct", "template")) and "struct" in chunk:
                out.append("public:")
            scope.append(opens[1])
            hidden = not re.search(r"\bstruct\b", chunk)
            comment, chunk = [], ""
        elif _complete(chunk):
            if not hidden:
                said, used = _documented(" ".join(comment), chunk, known)
                group = "@brief " if scope else "@ingroup cpp\n"
                calls = f" C: {', '.join(n + '()' for n in used)}." if used else ""
                out += [f"/** {group}{(escaped(said) + calls).strip() or NOTHING} */", _signature(chunk)]
            comment, chunk = [], ""
    return "\n".join(out)


def page(include, known, escaped, marked_up):
    first = re.match(r"(?://.*\n)+", (include / "ups.hpp").read_text(encoding="utf-8"))[0]
    said = re.sub(r"^// ?", "", first, flags=re.M)
    summary, rest = said.split("\n\n", 1)
    brief = escaped(" ".join(summary.split(": ", 1)[1].split()))
    out = ["/** @defgroup cpp C++17 classes", f"@brief {brief}", "", marked_up(rest), "*/", "namespace ups {"]
    for name in [f"hpp/{p}.hpp" for p in PARTS] + ["ups_gltf.hpp", "ups_exr.hpp", "ups_report.hpp"]:
        out.append(declarations(name, (include / name).read_text(encoding="utf-8"), known, escaped))
    return "\n".join([*out, "}", ""])
