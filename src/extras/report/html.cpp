// See html.h.
#include "report/html.h"

#include "report/text_format.h"

namespace ups::report {
namespace {

bool is_allowed(uint32_t code) {
  const bool control = (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7f && code < 0xa0);
  const bool direction = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return !control && !direction && (code & 0xfffe) != 0xfffe;
}

}  // namespace

std::string html_text(const std::string& text) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const Utf8 character = utf8_at(text, i);
    if (character.length == 0 || !is_allowed(character.code)) {
      out += "\xef\xbf\xbd";
    } else if (character.code == '&') {
      out += "&amp;";
    } else if (character.code == '<') {
      out += "&lt;";
    } else if (character.code == '>') {
      out += "&gt;";
    } else if (character.code == '"') {
      out += "&quot;";
    } else if (character.code == '\'') {
      out += "&#39;";
    } else {
      out += text.substr(i, character.length);
    }
    i += character.length == 0 ? 1 : character.length;
  }
  return out;
}

std::string html_table(const HtmlTable& table, const std::string& label) {
  const auto kind = [&](size_t column) { return column >= table.first_number ? " class=\"n\"" : ""; };
  std::string html = "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"" + html_text(label) +
                     "\">\n<table>\n<caption>" + table.caption + "</caption>\n<thead><tr>";
  for (size_t i = 0; i < table.head.size(); ++i)
    html += "<th scope=\"col\"" + std::string(kind(i)) + ">" + table.head[i] + "</th>";
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (size_t i = 0; i < row.size(); ++i)
      html += i == 0 ? "<th scope=\"row\">" + row[i] + "</th>" : "<td" + std::string(kind(i)) + ">" + row[i] + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string html_facts(const std::vector<std::pair<std::string, std::string>>& facts) {
  std::string html;
  for (const auto& [name, value] : facts)
    if (!value.empty()) html += "<div><dt>" + name + "</dt><dd>" + value + "</dd></div>\n";
  return html.empty() ? "" : "<dl class=\"facts\">\n" + html + "</dl>\n";
}

std::string html_list(const std::vector<std::string>& items) {
  std::string html;
  for (const std::string& item : items) html += "<li>" + item + "</li>\n";
  return html.empty() ? "" : "<ul>\n" + html + "</ul>\n";
}

std::string html_figure(const std::string& content, const std::string& caption, const std::string& style) {
  return "<figure" + (style.empty() ? "" : " class=\"" + style + "\"") + ">\n" + content +
         (caption.empty() ? "" : "<figcaption>" + caption + "</figcaption>\n") + "</figure>\n";
}

std::string html_image(const std::string& type, const std::vector<uint8_t>& bytes, const std::string& alternative,
                       uint32_t width, uint32_t height) {
  return "<img src=\"data:" + type + ";base64," + base64(bytes) + "\" alt=\"" + html_text(alternative) + "\" width=\"" +
         std::to_string(width) + "\" height=\"" + std::to_string(height) + "\">\n";
}

std::string base64(const std::vector<uint8_t>& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
    for (size_t k = 0; k < 4; ++k) out += k <= count ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

}  // namespace ups::report
