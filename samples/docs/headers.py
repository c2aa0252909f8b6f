"""The C headers with their comments: what each declaration is, and what is said of it.

Called by make_pages.py. The declarations are read by bindings/c_header.py; here comments are found and put to them, by
the style of these headers: a comment before a declaration is of that; of all functions up to an empty line or the next
comment where it begins with a word that says so, such as "Each" or "Both"; one behind a declaration is of that; one
between empty lines, or under a heading (---- edits ----), is a remark of the whole header.
"""
import re
from collections import namedtuple

Declaration = namedtuple("Declaration", "name kind text comment fields")  # kind: function, struct, enum, handle, alias
Field = namedtuple("Field", "name text comment")

TOKEN = re.compile(r"/\*(.*?)\*/|\n[ \t]*\n|[;{}]|#[^\n]*(?:\\\n[^\n]*)*", re.S)
HEADING = re.compile(r"^---- .* ----\n?")
OF_SEVERAL = re.compile(r"(Each|Both|By the rules|Edits|As those of)\b")


def plain(comment):
    """The lines of a comment without its decoration, further lines as far in as they were from its text."""
    lines = comment.strip("\n").split("\n")
    lines = [lines[0].strip()] + [re.sub(r"^\s*\* ?", "", line).rstrip() for line in lines[1:]]
    text = "\n".join(lines).strip()
    return HEADING.sub("", text)


def _split(text):
    """([leading comment, declaration with its comments, trailing comment], ...), [remarks]."""
    out, remarks = [], []
    leading = ""  # and whether it was used by a declaration yet
    used = True
    start = depth = end = 0  # end: of the last declaration
    pieces = []  # of the declaration so far

    def drop():
        nonlocal leading, used
        if leading and not used:
            remarks.append(plain(leading))
        leading, used = "", True

    for token in TOKEN.finditer(text):
        code, word = text[start:token.start()], token[0]
        start = token.end()
        if code.strip() or pieces:
            pieces.append(code)
        if word.startswith("#"):
            continue
        if pieces and word[0] != ";":
            pieces.append(word)
            depth += (word == "{") - (word == "}")
        elif word.startswith("/*") and out and re.fullmatch(r"[ \t]*", text[end:token.start()]):
            out[-1][2], end = token[1], token.end()
        elif word.startswith("/*"):
            drop()
            leading, used = token[1], False
            if HEADING.match(leading.strip().split("\n")[0]):
                drop()
        elif word[0] == "\n":
            drop()
        elif depth:
            pieces.append(word)
        else:
            out.append([leading, "".join(pieces), "", used])
            pieces, used, end = [], True, token.end()
    return [(plain(lead), code, plain(trail), again) for lead, code, trail, again in out], [r for r in remarks if r]


def _members(body, separator):
    """The fields of a struct or the members of an enumeration with what is said of each."""
    fields, before = [], ""
    position = 0
    for piece in re.finditer(r"/\*(.*?)\*/|[^/%s]+%s?|%s" % (separator, separator, separator), body, re.S):
        word = piece[0]
        if word.startswith("/*"):
            same_line = fields and "\n" not in body[position:piece.start()] and not before
            if same_line:
                fields[-1] = fields[-1]._replace(comment="\n".join(filter(None, [fields[-1].comment, plain(piece[1])])))
            else:
                before = plain(piece[1])
        elif word.strip(separator + " \n"):
            statement = " ".join(word.strip(separator + " \n").split())
            fields.append(Field(re.findall(r"\w+", statement.split("=")[0])[-1], statement, before))
            before = ""
            position = piece.start() + len(word.rstrip())
        elif word == separator:
            position = piece.end()
    return fields


def _declaration(path, bare, code, said, alias):
    if m := re.fullmatch(r"UPS_API .*?(ups_\w+)\(.*\)", bare):
        return Declaration(m[1], "function", bare.removeprefix("UPS_API "), said, [])
    if m := re.fullmatch(r"typedef struct(?: \w+)? \{.*\} (ups_\w+)", bare):
        return Declaration(m[1], "struct", bare, said, _members(code[code.index("{") + 1:code.rindex("}")], ";"))
    if bare.startswith("enum {"):
        fields = _members(code[code.index("{") + 1:code.rindex("}")], ",")
        return Declaration(alias.name if alias else "", "enum", bare, alias.comment if alias else said, fields)
    if m := re.fullmatch(r"typedef struct (ups_\w+) ups_\w+", bare):
        return Declaration(m[1], "handle", bare, said, [])
    if m := re.fullmatch(r"typedef u?int\d+_t (ups_\w+)", bare):
        return Declaration(m[1], "alias", bare, said, [])
    raise SystemExit(f"{path.name}: not in the style of these headers: {bare!r}")


def read(path):
    """(declarations in order, remarks: the comments of the whole header, its first one first)."""
    text = re.sub(r"^#ifdef __cplusplus.*?^#endif\n", "", path.read_text(encoding="utf-8"), flags=re.S | re.M)
    statements, remarks = _split(text)
    declarations = []
    for leading, code, trailing, again in statements:
        bare = " ".join(re.sub(r"/\*.*?\*/", " ", code, flags=re.S).split())
        if again and not (OF_SEVERAL.match(leading) and bare.startswith("UPS_API ups_status")):
            leading = ""
        alias = declarations.pop() if declarations and declarations[-1].kind == "alias" else None
        said = "\n\n".join(filter(None, [leading, trailing]))
        declarations.append(_declaration(path, bare, code, said, alias))
    return declarations, remarks
