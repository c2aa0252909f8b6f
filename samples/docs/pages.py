"""The repository's Markdown as Doxygen reads it: README.md, the guides, and every page that these link to.

Called by make_pages.py. Links between pages become references, images and other files that are linked come along, so
that what is built needs nothing else.
"""
import html
import os
import re
import shutil

GUIDES = ("link_it_in_an_hour", "from_a_room_to_a_report", "how_sure_is_a_number")
FIRST = ["README.md", *(f"samples/docs/{g}.md" for g in GUIDES), "samples/scene_files.md",
         "include/ups/compatibility.md", "bindings/csharp/README.md", "bindings/python/README.md", "CHANGELOG.md"]
LINK = re.compile(r"(!?)\[((?:[^][]|\[[^]]*\])*)\]\(\s*<?([^)>\s]+)>?\s*\)")
FENCE = re.compile(r"^\s*(```|~~~)")


def slug(heading):
    """The anchor that code hosts give a heading."""
    plain = re.sub(r"[`*_]", "", LINK.sub(r"\2", heading)).strip().lower()
    return re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")


def identity(path):
    if path == "README.md":
        return "mainpage"
    name = re.sub(r"(/README)?\.md$", "", path)
    return os.path.basename(name) if name.startswith(("samples/docs/", "include/ups/")) else re.sub(r"\W", "_", name)


def parts(text):
    """(text of a paragraph, a heading or code with its fences, whether it is code) of each."""
    out, fenced = [], False
    for line in text.split("\n"):
        fence = FENCE.match(line)
        code = fenced or bool(fence)
        fenced ^= bool(fence)
        if out and out[-1][1] == code and (code or line and out[-1][0][-1] and not line.startswith("#")
                                           and not out[-1][0][-1].startswith("#")):
            out[-1][0].append(line)
        else:
            out.append(([line], code))
    return [("\n".join(lines), code) for lines, code in out]


def links(text):
    """(whether an image, text, target) of each link that is not in code."""
    for part, code in parts(text):
        if not code:
            for image, words, target in LINK.findall(part):
                yield bool(image), words, target


def headings(text):
    return [slug(m[1]) for part, code in parts(text) if not code and (m := re.match(r"#+ (.*?)\s*$", part))]


def resolved(path, target):
    """(path in the repository, anchor) of a link in the page at path."""
    where, _, anchor = target.partition("#")
    return (os.path.normpath(os.path.join(os.path.dirname(path), where)) if where else path), anchor


def is_external(target):
    return re.match(r"[a-z]+:", target) is not None


class Site:
    def __init__(self, root, out, functions):
        self.root, self.out, self.functions = root, out, functions
        self.pages = {}
        waiting = list(FIRST)
        while waiting:
            path = waiting.pop(0)
            if path in self.pages:
                continue
            self.pages[path] = (root / path).read_text(encoding="utf-8")
            for image, _, target in links(self.pages[path]):
                other = self.page_of(resolved(path, target)[0]) if not image and not is_external(target) else None
                if other and other not in self.pages:
                    waiting.append(other)

    def page_of(self, path):
        if (self.root / path).is_dir():
            path = os.path.join(path, "README.md")
        return path if path.endswith(".md") and (self.root / path).is_file() else None

    def bring_file(self, path):
        """A copy in the built site; text as a page to look at."""
        source = self.root / path
        target = self.out / "files" / (path if source.suffix in (".png", ".pdf", ".glb", ".exr") else path + ".html")
        target.parent.mkdir(parents=True, exist_ok=True)
        if target.suffix == ".html":
            up = "../" * (path.count("/") + 1)
            target.write_text(f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{html.escape(path)}</title>'
                              '<meta name="viewport" content="width=device-width">'
                              f'<p><a href="{up}index.html">UPS</a> · {html.escape(path)}</p>'
                              f"<pre>{html.escape(source.read_text(encoding='utf-8'))}</pre></html>\n",
                              encoding="utf-8")
        else:
            shutil.copyfile(source, target)
        return os.path.relpath(target, self.out)

    def link(self, path, image, words, target):
        words = " ".join(words.split())  # Doxygen knows no link on two lines
        if is_external(target):
            return f"[{words}]({target})"
        where, anchor = resolved(path, target)
        page = self.page_of(where)
        if image:
            name = where.replace("/", "_")
            (self.out / "images").mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.root / where, self.out / "images" / name)
            return f"![{words}]({name})"
        if page:
            label = identity(page) + (f"__{anchor}" if anchor else "")
            return f'<a href="index.html">{words}</a>' if label == "mainpage" else f"[{words}](@ref {label})"
        if (self.root / where).is_file():
            return f'<a href="{self.bring_file(where)}">{words}</a>'
        return words  # a folder

    def function(self, name):
        return f"[{name}](@ref {name})" if name in self.functions else f"`{name}`"

    def text(self, path):
        out, first = [], True
        for part, code in parts(self.pages[path]):
            if code:
                out.append(part)
            elif m := re.match(r"(#+) (.*?)\s*$", part):
                label = identity(path) if first else f"{identity(path)}__{slug(m[2])}"
                title = re.sub("`", "", LINK.sub(lambda n: n[2], m[2])).replace("#", "&#35;")
                out.append(f"{m[1]} {title} {{#{label}}}")
                first = False
            else:
                part = LINK.sub(lambda m: self.link(path, bool(m[1]), m[2], m[3]), part)
                part = re.sub(r"`(ups_\w+)`", lambda m: self.function(m[1]), part)
                words = re.split(r"(`[^`]*`|\]\(@ref [^)]*\))", part)
                words[::2] = [re.sub(r"@(?=\w)", r"\\@", w) for w in words[::2]]
                out.append("".join(words))
        return "\n".join(out) + "\n"

    def write(self):
        for path in self.pages:
            text = self.text(path)
            if path == "README.md":
                text = text.replace("{#mainpage}\n", "{#mainpage}\n" + START, 1)
            (self.out / f"{identity(path)}.md").write_text(text, encoding="utf-8")
        others = [p for p in self.pages if p != "README.md" and identity(p) not in GUIDES]
        listed = "\n".join(f"- @ref {identity(p)} ({p})" for p in others)
        (self.out / "more.md").write_text(f"# More {{#more}}\n\n{listed}\n", encoding="utf-8")


START = """
<div class="start">**Guides**: @ref link_it_in_an_hour "Link it in an hour" ·
@ref from_a_room_to_a_report "From a room to a report" ·
@ref how_sure_is_a_number "How sure is a number"

**Reference**: [all functions, by theme](modules.html) · @ref cpp "C++ classes" ·
[structs and classes](annotated.html) · @ref rules "the rules of every function" ·
@ref samples_scene_files "scene files" · @ref compatibility "what stays"
</div>

"""
