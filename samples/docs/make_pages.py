#!/usr/bin/env python3
"""Writes what Doxygen reads: the headers with a page a function, and the guides.

    samples/docs/make_pages.py FOLDER

A function's page has what the header says of it, and what follows by rule from its signature: units of parameters by
their names, errors, lifetime, threads; its example is the part of a program in tests/docs/examples that stands between
/* [function] */ and /* [end] */. Which themes there are, and each function in a sentence: functions.txt.
"""
import re
import sys
import textwrap
from pathlib import Path

import cpp
import headers
import pages
import rules

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
INCLUDE = ROOT / "include/ups"
EXAMPLES = ROOT / "tests/docs/examples"
sys.path.insert(0, str(ROOT / "bindings"))
import c_header  # noqa: E402

FUNCTIONS = set()  # that the headers declare: their names become links
STATUS = re.compile(r"(?<![A-Za-z_#])(?:UPS_ERROR_)?(INVALID_ARGUMENT|INVALID_STATE|OUT_OF_MEMORY|PARSE|UNSUPPORTED|"
                    r"BUFFER_TOO_SMALL|IO)\b")


def escaped(text):
    """A line of a comment as Doxygen's Markdown shows it as it is."""
    parts = re.split(r"(`[^`]*`)", text)
    for i in range(0, len(parts), 2):
        part = re.sub(r"([\\@<>*&#$%~|\[\]])", r"\\\1", parts[i]).replace(r"\*", "&lowast;").replace(r"\~", "~")
        part = part.replace(r"\[", "[").replace(r"\]", "]").replace(r"\|", "&#124;")
        part = re.sub(r"(?<=\w)\^(-?\d+)", r"<sup>\1</sup>", part)
        part = re.sub(r"\b(ups_\w+)\b(?!\(|\.h)", lambda m: m[1] + "()" * (m[1] in FUNCTIONS), part)
        part = re.sub(r'"', "&quot;", part)
        parts[i] = STATUS.sub(r"#UPS_ERROR_\1", part)
    return "".join(parts)


def marked_up(comment):
    """A comment's text: paragraphs and lists stay, what is set in columns keeps its spaces."""
    out, columns = [], []

    def end_columns():
        if columns:
            width = min(len(line) - len(line.lstrip()) for line in columns)
            out.extend(["", "@verbatim", *(line[width:] for line in columns), "@endverbatim", ""])
            columns.clear()

    in_list = False
    for line in comment.split("\n"):
        indent = len(line) - len(line.lstrip())
        if line.lstrip().startswith("- ") and indent >= 2:
            end_columns()
            in_list = True
            out.append(escaped(line[2:]))
        elif indent >= 2 and not in_list:
            columns.append(line)
        else:
            end_columns()
            in_list = in_list and indent >= 2
            out.append(escaped(line.strip()) if not in_list else "  " + escaped(line.strip()))
    end_columns()
    return "\n".join(out)


class Theme:
    def __init__(self, name, title, sources):
        self.name, self.title, self.sources, self.functions, self.about = name, title, sources, {}, ""


class Facts:
    def __init__(self, summary):
        self.summary, self.errors, self.see, self.lifetime = summary, [], [], None


def read_themes():
    themes, facts = [], None
    text = (HERE / "functions.txt").read_text(encoding="utf-8")
    for line in text[text.index("\n# "):].splitlines():
        if m := re.fullmatch(r"# (\w+) \| (.*?) \|(.*)", line):
            themes.append(Theme(m[1], m[2], m[3].split()))
        elif m := re.fullmatch(r"about: (.*)", line):
            themes[-1].about = m[1]
        elif m := re.fullmatch(r"(ups_\w+): (.*)", line):
            facts = Facts(m[2])
            if themes[-1].functions.setdefault(m[1], facts) is not facts:
                sys.exit(f"functions.txt has {m[1]} twice")
        elif m := re.fullmatch(r"  see: (.*)", line):
            facts.see = m[1].split()
        elif m := re.fullmatch(r"  lifetime: (.*)", line):
            facts.lifetime = m[1]
        elif m := re.fullmatch(r"  ([A-Z_]+): (.*)", line):
            facts.errors.append((m[1], m[2]))
        elif line.strip():
            sys.exit(f"functions.txt: {line!r}")
    return themes


def read_examples(folder=EXAMPLES):
    """function -> (program, code): each function in one snippet, which calls it."""
    found = {}
    for path in sorted(folder.glob("*.c")):
        names, code = None, []
        for line in path.read_text(encoding="utf-8").split("\n"):
            marker = re.fullmatch(r"\s*/\* \[([\w ]+)\] \*/", line)
            if not marker:
                code.append(line)
            elif (marker[1] == "end") == (names is None):
                sys.exit(f"{path.name}: a marker of an example without its other: {line.strip()}")
            elif marker[1] == "end":
                text = textwrap.dedent("\n".join(code))
                for name in names:
                    if not re.search(rf"\b{name}\(", text):
                        sys.exit(f"{path.name}: the example of {name} does not call it")
                    if name in found:
                        sys.exit(f"{name} has two examples: {found[name][0]} and {path.name}")
                    found[name] = (path.name, text)
                names = None
            else:
                names, code = marker[1].split(), []
        if names:
            sys.exit(f"{path.name}: a marker of an example without its other: {names}")
    return found


def function_page(theme, declaration, function, facts, example):
    text, errors = rules.split_errors(declaration.comment)
    errors = [*rules.errors(function, facts.errors, errors)]
    out = [f"/** @defgroup {function.name} {function.name}()", f"@ingroup {theme.name}",
           f"@brief {escaped(facts.summary)}", "@{ */", "/**", f"@brief {rules.NOTHING}", ""]
    if text:
        out += [marked_up(text), ""]
    for parameter in function.parameters:
        out.append(f"@param {parameter.name} {rules.parameter(function, parameter)}")
    if function.returns.name != "void" or function.returns.pointers:
        out.append(f"@return {rules.returns(function)}")
    out += ["", "@par Errors"]
    out += [f"- {escaped(e)}" for e in errors] if errors else ["None: it cannot fail."]
    out += ["", "@par Lifetime", escaped(facts.lifetime or rules.lifetime(function)),
            "", "@par Threads", escaped(rules.threads(function)), ""]
    out += ["@par Example", f"From tests/docs/examples/{example[0]}; `check` ends the program where a call failed.",
            "@code{.c}", example[1], "@endcode", ""]
    see = [*facts.see, *rules.related(function)]
    out += [f"@see {', '.join(s + '()' for s in dict.fromkeys(see))}", ""] if see else []
    out += [f"@par Declared in", f"<tt>ups/{function.header}</tt>", "*/", declaration.text + ";", "/** @} */", ""]
    return "\n".join(out)


def struct_page(theme, declaration, header, users, common):
    out = [f"/** @ingroup {theme}", f"@brief {escaped(rules.struct_summary(declaration))}", "",
           marked_up(declaration.comment), "", f"Declared in <tt>ups/{header}</tt>.", ""]
    out += [f"@see {', '.join(u + '()' for u in users)}", ""] if users else []
    out += ["*/", f"typedef struct {declaration.name} {{"]
    for field in declaration.fields:
        for name, text in rules.declarators(field.text):
            said = rules.field(name, field.comment, common)
            out += [f"/** @brief {said if said == rules.NOTHING else escaped(said)} */", text + ";"]
    return "\n".join([*out, f"}} {declaration.name};", ""])


def enum_page(theme, declaration):
    members = [(f.name, f.text.split("=")[1].strip(), f.comment) for f in declaration.fields]
    name = declaration.name or c_header.common_prefix(c_header.Enum(None, [(m[0], m[1]) for m in members])).rstrip("_")
    kind = ("An int32_t in every signature and struct." if declaration.name else
            "Bits of a uint32_t; the set has no C type.")
    out = [f"/** @ingroup {theme}", f"@brief {kind}", "", marked_up(declaration.comment), "*/", f"enum {name} {{"]
    for member, value, comment in members:
        out += [f"/** {value}{': ' if comment else ''}{escaped(comment)} */", f"{member} = {value},"]
    return "\n".join([*out, "};", ""])


def handle_page(theme, declaration):
    return (f"/** @ingroup {theme}\n@brief {escaped(declaration.comment)}\n*/\n"
            f"typedef struct {declaration.name} {declaration.name};\n")


HANDLES = {"ups_profile": "photometry", "ups_scene": "scene", "ups_job": "render", "ups_result": "result"}


def theme_of_types(api, themes, declared):
    """Of each struct, enumeration and handle: the theme of the first function that has it, or of what contains it."""
    of = dict(HANDLES)
    for theme in themes:
        for name in theme.functions:
            function = api.function(name)
            for t in [p.type for p in function.parameters] + [function.returns]:
                of.setdefault(t.name, theme.name)
    for struct in api.structs:
        for field in struct.fields:
            if struct.name in of:
                of.setdefault(field.type.name, of[struct.name])
    headers_theme = {h: t.name for t in themes for h in t.sources}
    for header, declarations in declared.items():
        for d in declarations:
            of.setdefault(d.name, headers_theme[header])
    return of


def checked(api, themes, examples):
    """Names of all functions; ends where one is in no theme, has no example, or is not declared."""
    listed = {name for theme in themes for name in theme.functions}
    if difference := listed ^ {f.name for f in api.functions}:
        sys.exit(f"in functions.txt or declared, but not both: {' '.join(sorted(difference))}")
    if missing := listed - examples.keys():
        sys.exit(f"{len(missing)} functions without an example in {EXAMPLES}: {' '.join(sorted(missing))}")
    if unknown := examples.keys() - listed:
        sys.exit(f"examples of functions that are not declared: {' '.join(sorted(unknown))}")
    return listed


def theme_pages(themes, remarks):
    for theme in themes:
        said = [r for h in theme.sources for r in remarks[h]]
        yield f"/** @defgroup {theme.name} {theme.title}"
        if theme.name == "base":
            yield '@brief What every other header needs; @ref rules "the rules of all functions"\n*/'
        else:
            yield f"@brief {escaped(theme.about or rules.theme_summary(said[0]))}\n"
            yield "\n".join([*(marked_up(r) + "\n" for r in rules.theme_text(said)), "*/"])
    first, *others = remarks["ups_base.h"]
    yield "/** @page rules Rules of the API\n"
    yield "\n".join([*(marked_up(r) + "\n" for r in rules.theme_text([first]) + others), "*/"])


def type_pages(api, themes, declared, remarks):
    of = theme_of_types(api, themes, declared)
    for header, declarations in declared.items():
        own = next(t.name for t in themes if header in t.sources)
        common = [c for r in remarks[header] if r.startswith("Every part") for c in rules.common_fields(r)]
        for d in declarations:
            if d.kind == "struct":
                users = [f.name for f in api.functions if any(p.type.name == d.name for p in f.parameters)]
                yield struct_page(of[d.name], d, header, users, common)
            elif d.kind == "enum":
                yield enum_page(of[d.name] if d.name else own, d)
            elif d.kind == "handle":
                yield handle_page(of[d.name], d)


def main():
    out = Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    api = c_header.parse_headers(INCLUDE, c_header.CORE_HEADERS + c_header.EXTRA_HEADERS)
    FUNCTIONS.update(f.name for f in api.functions)
    declared, remarks = {}, {}
    for header in c_header.CORE_HEADERS + c_header.EXTRA_HEADERS:
        declared[header], remarks[header] = headers.read(INCLUDE / header)
    themes, examples = read_themes(), read_examples()
    listed = checked(api, themes, examples)
    by_name = {d.name: d for declarations in declared.values() for d in declarations if d.kind == "function"}
    text = [*theme_pages(themes, remarks), *type_pages(api, themes, declared, remarks)]
    text += [function_page(theme, by_name[name], api.function(name), facts, examples[name])
             for theme in themes for name, facts in theme.functions.items()]
    text.append(cpp.page(INCLUDE, listed, escaped, marked_up))
    (out / "ups.h").write_text("\n".join(text), encoding="utf-8")
    pages.Site(ROOT, out, listed).write()


if __name__ == "__main__":
    main()
