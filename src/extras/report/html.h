// Pieces of an HTML page: escaped texts, tables and figures that people and their readers aloud can follow. Called by
// the page of a render; knows nothing of light.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace ups::report {

// A text of files and users as HTML, in an element or an attribute; what HTML cannot hold becomes U+FFFD.
std::string html_text(const std::string& text);

struct HtmlTable {
  std::string caption;  // HTML, as all cells are
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  // the first cell of each is the row's head
  size_t first_number = 1;                     // from this column on cells are numbers, set to the right
};
// Scrolls by itself where it is wider than the page; label: of that region, a plain text.
std::string html_table(const HtmlTable& table, const std::string& label);

// Of names and values, two columns; rows without a value are left out.
std::string html_facts(const std::vector<std::pair<std::string, std::string>>& facts);

std::string html_list(const std::vector<std::string>& items);  // of HTML

// content: an svg or img element.
std::string html_figure(const std::string& content, const std::string& caption, const std::string& style = "");
std::string html_image(const std::string& type, const std::vector<uint8_t>& bytes, const std::string& alternative,
                       uint32_t width, uint32_t height);

std::string base64(const std::vector<uint8_t>& bytes);

}  // namespace ups::report
