#!/usr/bin/env bash
# Builds the documentation as HTML that needs no network: the guides, a page for each function, the C++ classes, search.
#   samples/docs/build.sh [FOLDER]     into FOLDER/index.html (out/docs)
# Needs doxygen and python3 (samples/setup.sh test). Fails at Doxygen's warnings, at a function without an example, and at
# links that lead nowhere.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=$(realpath -m "${1:-$here/../../out/docs}")
if ! command -v doxygen >/dev/null; then
  echo "no doxygen: apt-get install doxygen, or samples/setup.sh test" >&2
  exit 1
fi
python=$(command -v /usr/bin/python3 || command -v python3)
if [ -e "$out" ] && [ ! -e "$out/doxygen.css" ] && [ -n "$(ls -A "$out")" ]; then
  echo "$out has something else in it" >&2
  exit 1
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$python" "$here/make_pages.py" "$work/input"
export UPS_DOCS_INPUT=$work/input UPS_DOCS_OUTPUT=$work UPS_DOCS_SOURCE=$here
UPS_DOCS_VERSION=$(sed -n 's/^project(ups VERSION \([0-9.]*\) .*/\1/p' "$here/../../CMakeLists.txt")
export UPS_DOCS_VERSION

# What later versions call otherwise: groups are topics, and there is a dark style, which style.css does not know.
cp "$here/Doxyfile" "$here/layout.xml" "$work"
since() { [ "$(printf '%s\n' "$1" "$(doxygen --version)" | sort -V | head -1)" = "$1" ]; }
if since 1.9.5; then echo "HTML_COLORSTYLE = LIGHT" >>"$work/Doxyfile"; fi
if since 1.9.8; then
  sed -i 's/type="modules"/type="topics"/' "$work/layout.xml"
  sed -i 's/(modules\.html)/(topics.html)/' "$work/input/mainpage.md"
fi
doxygen "$work/Doxyfile" 2>"$work/warnings" || { cat "$work/warnings" >&2; exit 1; }
if [ -s "$work/warnings" ]; then
  cat "$work/warnings" >&2
  exit 1
fi
if [ -d "$work/input/files" ]; then cp -r "$work/input/files" "$work/html/files"; fi
"$python" "$here/check_links.py" built "$work/html"
"$python" "$here/check_links.py" functions "$work/html"
rm -rf "$out"
mkdir -p "$(dirname "$out")"
cp -r "$work/html" "$out"
echo "$out/index.html"
