#!/usr/bin/env python3
"""Do links lead somewhere? Ends with 1 and a line for each that does not.

    samples/docs/check_links.py built FOLDER        every href, src and anchor of the built pages, search and navigation
    samples/docs/check_links.py functions FOLDER    every function has a page with all of its parts, and can be searched
    samples/docs/check_links.py markdown            relative links and anchors of the repository's Markdown files
"""
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

import pages
from make_pages import ROOT, read_themes

SECTIONS = ("Errors", "Lifetime", "Threads", "Example", "Declared in")


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or name == "name" and tag == "a":
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def built(folder):
    found = {p: Page(p) for p in folder.rglob("*.html")}
    links = [(p, link) for p, page in found.items() for link in page.links]
    for script in folder.rglob("*.js"):  # search results and the tree beside the pages
        text = script.read_text(encoding="utf-8")
        links += [(script, m) for m in re.findall(r"[\"']((?:\.\./)?\w+\.html(?:#\w+)?)[\"']", text)]
    broken = []
    for source, link in links:
        if pages.is_external(link):
            continue
        where, _, anchor = unquote(link).partition("#")
        target = (source.parent / where).resolve() if where else source
        if target.suffix == ".html" and target not in found or not target.exists():
            broken.append(f"{source.relative_to(folder)}: {link}: there is no such file")
        elif anchor and target in found and anchor not in found[target].anchors:
            broken.append(f"{source.relative_to(folder)}: {link}: there is no such anchor")
    return broken, len(links)


def functions(folder):
    index = "".join(p.read_text(encoding="utf-8") for p in (folder / "search").glob("*.js"))
    wrong, names = [], [name for theme in read_themes() for name in theme.functions]
    for name in names:
        path = folder / f"group__{name.replace('_', '__')}.html"
        if not path.is_file():
            wrong.append(f"{name} has no page")
            continue
        text = path.read_text(encoding="utf-8")
        missing = [s for s in SECTIONS if f"<b>{s}</b>" not in text and f">{s}</dt>" not in text]
        if missing:
            wrong.append(f"{path.name} lacks {', '.join(missing)}")
        if path.name not in index:
            wrong.append(f"the search does not find {name}")
    return wrong, len(names)


def markdown():
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"], cwd=ROOT,
                            capture_output=True, text=True)
    paths = listed.stdout.split() if listed.returncode == 0 else [
        str(p.relative_to(ROOT)) for p in ROOT.rglob("*.md") if not re.match(r"(build|out)", str(p.relative_to(ROOT)))]
    texts = {p: (ROOT / p).read_text(encoding="utf-8") for p in paths}
    broken, count = [], 0
    for path, text in texts.items():
        for _, words, target in pages.links(text):
            if pages.is_external(target):
                continue
            count += 1
            where, anchor = pages.resolved(path, target)
            if not (ROOT / where).exists():
                broken.append(f"{path}: [{words}]({target}): there is no such file")
            elif anchor and anchor not in pages.headings(texts.get(where, "")):
                broken.append(f"{path}: [{words}]({target}): there is no such heading")
    return broken, count


def main():
    checks = {"built": built, "functions": functions, "markdown": markdown}
    if len(sys.argv) < 2 or sys.argv[1] not in checks:
        sys.exit(__doc__)
    wrong, count = checks[sys.argv[1]](*(Path(a).resolve() for a in sys.argv[2:]))
    print(*wrong, sep="\n", end="\n" if wrong else "")
    if wrong or not count:
        sys.exit(f"{sys.argv[1]}: {len(wrong)} of {count} are wrong")
    print(f"{sys.argv[1]}: {count} are good")


if __name__ == "__main__":
    main()
