// A drawing as an SVG document.
#include <cstdio>

#include "tool/drawing.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

std::string coordinate(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string s = text;
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

std::string hex(const Ink& ink) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", ink[0], ink[1], ink[2]);
  return text;
}

// Bytes of a UTF-8 sequence that XML allows at this place; 0: none does.
size_t sequence(const std::string& text, size_t at) {
  const Utf8 character = utf8_at(text, at);
  const bool banned = (character.code < 0x20 && character.code != '\t') || character.code == 0xfffe ||
                      character.code == 0xffff;
  return banned ? 0 : character.length;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const size_t length = sequence(text, i);
    const char c = text[i];
    if (length == 0) {
      out += '?';
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  return out;
}

std::string path_of(const std::vector<Point>& points) {
  std::string d;
  for (const Point& p : points) {
    d += d.empty() ? 'M' : 'L';
    d += coordinate(p.x) + " " + coordinate(p.y);
  }
  return d;
}

std::string element(const Line& line) {
  std::string s =
      "<path fill=\"none\" stroke=\"" + hex(line.ink) + "\" stroke-width=\"" + coordinate(line.width) + "\"";
  if (line.dash > 0) {
    s += " stroke-linecap=\"butt\" stroke-dasharray=\"" + coordinate(line.dash) + " " +
         coordinate(line.dash * Line::gap) + "\"";
  }
  return s + " d=\"" + path_of(line.points) + "\"/>\n";
}

std::string element(const Area& area) {
  std::string s = "<path stroke=\"none\" fill-rule=\"evenodd\" fill=\"" + hex(area.ink) + "\"";
  if (area.opacity < 1) s += " fill-opacity=\"" + coordinate(area.opacity) + "\"";
  return s + " d=\"" + path_of(area.points) + "Z\"/>\n";
}

std::string element(const Label& label) {
  constexpr const char* anchors[] = {"start", "middle", "end"};
  return "<text x=\"" + coordinate(label.at.x) + "\" y=\"" + coordinate(label.at.y) + "\" font-size=\"" +
         coordinate(label.size) + "\" fill=\"" + hex(label.ink) + "\" text-anchor=\"" + anchors[int(label.anchor)] +
         "\"" + (label.bold ? " font-weight=\"bold\"" : "") + ">" + escaped(label.text) + "</text>\n";
}

}  // namespace

std::string to_svg(const Drawing& drawing, const std::string& title) {
  const std::string w = coordinate(drawing.width), h = coordinate(drawing.height);
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                    w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h +
                    "\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" stroke-linejoin=\"round\" "
                    "stroke-linecap=\"round\">\n<title>" +
                    escaped(title) + "</title>\n<rect width=\"" + w + "\" height=\"" + h + "\" fill=\"#ffffff\"/>\n";
  for (const auto& part : drawing.parts) svg += std::visit([](const auto& p) { return element(p); }, part);
  return svg + "</svg>\n";
}

}  // namespace ups::tool
