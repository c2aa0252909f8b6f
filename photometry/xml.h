// A pull reader of XML for files of measured data: elements, attributes, text, CDATA, the five entities and character
// references; comments, processing instructions and a document type are passed over, and no entity is ever expanded
// from one. Used by tm33_elements.cpp. Names lose their namespace prefix.
//
//   XmlReader xml(text);
//   xml.enter_root();
//   while (xml.enter_child())            // each child must be left by one of the three:
//     if (xml.name() == "Header") ...    //   loop over its children,
//     else if (...) xml.text();          //   take its text,
//     else xml.skip();                   //   or pass it over
#pragma once
#include "photometry/text_reader.h"

namespace photometry {

class XmlReader {
 public:
  static constexpr size_t max_size = size_t(1) << 28, max_depth = 64, max_attributes = 64, max_name = 256;

  // UTF-8. Throws ParseError where it is larger than max_size; the other functions where it is not well-formed.
  explicit XmlReader(std::string text);

  void enter_root();
  // Goes to the next child of the element that was entered last, past text; false at its end, which leaves it.
  bool enter_child();
  // All text up to the element's end, which leaves it; that of children is left out.
  std::string text();
  void skip() { text(); }
  // After the root: whether anything but comments follows it, which line() then tells.
  bool has_more();

  std::string_view name() const;  // of the element that was entered last; "" before the first and after the last
  // Its attribute, or null; good until the next element is entered.
  const std::string* attribute(std::string_view name) const;
  size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }

 private:
  enum class Event { start, end, text, finished };
  Event next();
  bool starts_with(std::string_view s) const { return std::string_view(text_).substr(at_, s.size()) == s; }
  std::string_view up_to(std::string_view mark, const char* what);
  void pass_aside();
  void pass_doctype();
  void pass_blank();
  std::string read_name();
  void read_start();
  void read_end();
  void read_attribute(std::vector<std::string>& names);
  std::string decoded(std::string_view raw) const;
  void advance(size_t n);

  std::string text_;
  size_t at_ = 0, line_ = 1;
  std::vector<std::string> open_;
  std::vector<Keyword> attributes_;
  bool empty_element_ = false;  // <a/> was entered: its end comes next
  std::string event_text_;
};

}  // namespace photometry
