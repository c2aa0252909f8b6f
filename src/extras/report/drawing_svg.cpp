// A drawing as an SVG document: Cairo's elements, with title and words for those who cannot see it.
#include "report/drawing_svg.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>
#include <string_view>

namespace ups::report {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : writable(text)) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else {
      out += c;
    }
  }
  return out;
}

// Cairo's six decimals of coordinates cut to three; those of matrices, which multiply, stay.
std::string with_short_numbers(const std::string& svg) {
  constexpr std::string_view matrix = "matrix(";
  std::string out;
  for (size_t i = 0; i < svg.size();) {
    if (svg.compare(i, matrix.size(), matrix) == 0) {
      const size_t end = std::min(svg.find(')', i), svg.size());
      out.append(svg, i, end - i);
      i = end;
      continue;
    }
    const bool decimal = svg[i] == '.' && i > 0 && std::isdigit(static_cast<unsigned char>(svg[i - 1]));
    out += svg[i++];
    for (int digits = 0; decimal && i < svg.size() && std::isdigit(static_cast<unsigned char>(svg[i])); ++i)
      if (++digits <= 3) out += svg[i];
  }
  return out;
}

// Each id by a name that follows from this document alone: `begin` and a number.
std::string with_own_ids(const std::string& svg, const std::string& begin) {
  constexpr std::string_view marks[] = {" id=\"", "href=\"#", "url(#"};
  std::map<std::string, std::string> names;
  std::string out;
  for (size_t i = 0; i < svg.size();) {
    size_t length = 0;
    for (const std::string_view mark : marks)
      if (svg.compare(i, mark.size(), mark) == 0) length = mark.size();
    if (length == 0) {
      out += svg[i++];
      continue;
    }
    out.append(svg, i, length);
    i += length;
    std::string id;
    while (i < svg.size() && svg[i] != '"' && svg[i] != ')') id += svg[i++];
    const auto [place, is_new] = names.try_emplace(id);
    if (is_new) place->second = begin + std::to_string(names.size());
    out += place->second;
  }
  return out;
}

std::string labels_of(const Drawing& drawing) {
  std::string labels;
  for (const auto& part : drawing.parts)
    if (const auto* label = std::get_if<Label>(&part)) labels += escaped(label->text) + "\n";
  return labels;
}

}  // namespace

std::string to_svg(const Drawing& drawing, const Words& words, const std::string& ids_begin) {
  const std::string begin = ids_begin + "i";  // ids must not begin with a digit
  std::string svg = with_own_ids(with_short_numbers(to_svg_elements(drawing)), begin);
  const size_t root = svg.find("<svg"), end = svg.find('>', root);
  if (root == std::string::npos || end == std::string::npos) throw std::runtime_error("Cairo wrote no SVG document");
  const std::string title = begin + "title", description = begin + "desc";
  const std::string said = words.description.empty() ? labels_of(drawing) : escaped(words.description);
  svg.insert(end + 1, "\n<title id=\"" + title + "\">" + escaped(words.title) + "</title>\n<desc id=\"" + description +
                          "\">" + said + "</desc>");
  svg.insert(end, " role=\"img\" aria-labelledby=\"" + title + " " + description + "\"");
  return svg;
}

}  // namespace ups::report
