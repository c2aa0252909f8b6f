// See xml.h.
#include "photometry/xml.h"

namespace photometry {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
// Bytes of a name, any of UTF-8's beyond ASCII among them.
bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.' || c == ':' || (c & 0x80);
}
bool is_name_start(char c) { return is_name_character(c) && c != '-' && c != '.' && !(c >= '0' && c <= '9'); }

std::string_view without_prefix(std::string_view name) {
  const size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

}  // namespace

XmlReader::XmlReader(std::string text) : text_(std::move(text)) {
  if (text_.size() > max_size) fail("an XML file of more than 256 MiB is not read");
}

std::string_view XmlReader::name() const { return open_.empty() ? std::string_view() : without_prefix(open_.back()); }

// Counts lines: \r\n, \n, and \r alone.
void XmlReader::advance(size_t n) {
  for (size_t end = at_ + n; at_ < end; ++at_)
    if (text_[at_] == '\n' || (text_[at_] == '\r' && !(at_ + 1 < text_.size() && text_[at_ + 1] == '\n'))) ++line_;
}

void XmlReader::pass_blank() {
  size_t n = 0;
  while (at_ + n < text_.size() && is_blank(text_[at_ + n])) ++n;
  advance(n);
}

// What stands before the mark, which is passed too.
std::string_view XmlReader::up_to(std::string_view mark, const char* what) {
  const size_t end = text_.find(mark, at_);
  if (end == text_.npos) fail(std::string("the file ends inside ") + what);
  const std::string_view out = std::string_view(text_).substr(at_, end - at_);
  advance(end + mark.size() - at_);
  return out;
}

// A comment or a processing instruction.
void XmlReader::pass_aside() {
  if (starts_with("<?")) return void(up_to("?>", "a processing instruction"));
  advance(4);
  up_to("-->", "a comment");
}

// A document type and its internal declarations, unread.
void XmlReader::pass_doctype() {
  int depth = 0;
  for (char quote = 0; at_ < text_.size(); advance(1)) {
    while (!quote && (starts_with("<!--") || starts_with("<?"))) pass_aside();  // whose quotes are none
    if (at_ >= text_.size()) break;
    const char c = text_[at_];
    if (quote) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '<' || c == '[') {
      ++depth;
    } else if (c == '>' || c == ']') {
      if (--depth == 0) return advance(1);
    }
  }
  fail("the file ends inside a document type");
}

std::string XmlReader::read_name() {
  size_t n = 0;
  while (at_ + n < text_.size() && is_name_character(text_[at_ + n])) ++n;
  if (n == 0 || n > max_name || !is_name_start(text_[at_]))
    fail("a name of an element or attribute of 1 to 256 characters is expected here");
  const std::string name = text_.substr(at_, n);
  at_ += n;
  return name;
}

std::string XmlReader::decoded(std::string_view raw) const {
  std::string out;
  for (size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] != '&') {
      out += raw[i];
      continue;
    }
    const size_t end = raw.substr(0, std::min(raw.size(), i + 12)).find(';', i);
    const std::string_view name = end == raw.npos ? std::string_view() : raw.substr(i + 1, end - i - 1);
    static constexpr std::string_view names[] = {"lt", "gt", "amp", "quot", "apos"};
    const auto* known = std::find(std::begin(names), std::end(names), name);
    if (known != std::end(names)) {
      out += "<>&\"'"[known - names];
    } else if (name.size() > 1 && name[0] == '#') {
      const bool hex = name[1] == 'x';
      const std::string_view digits = name.substr(hex ? 2 : 1);
      uint32_t c = 0;
      const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), c, hex ? 16 : 10);
      if (error != std::errc() || stop != digits.data() + digits.size() || c == 0)
        fail("\"&" + std::string(name) + ";\" is no character reference");
      append_utf8(out, c);
    } else {
      fail("\"&" + cut(raw.substr(i + 1), 10) +
           "\": only &lt; &gt; &amp; &quot; &apos; and character references are known");
    }
    i = end;
  }
  return out;
}

// names: of the element's attributes before, with their prefixes.
void XmlReader::read_attribute(std::vector<std::string>& names) {
  if (attributes_.size() >= max_attributes) fail("<" + open_.back() + "> has more than 64 attributes");
  const std::string attribute = read_name();
  if (std::find(names.begin(), names.end(), attribute) != names.end())
    fail("<" + open_.back() + "> has the attribute \"" + attribute + "\" twice");
  names.push_back(attribute);
  pass_blank();
  if (!starts_with("="))
    fail("the attribute \"" + attribute + "\" of <" + open_.back() + "> has no value: = is missing");
  advance(1);
  pass_blank();
  if (!starts_with("\"") && !starts_with("'"))
    fail("the value of the attribute \"" + attribute + "\" of <" + open_.back() + "> is not in quotes");
  const std::string quote(1, text_[at_]);
  advance(1);
  attributes_.push_back({std::string(without_prefix(attribute)), decoded(up_to(quote, "an attribute's value"))});
}

// After "<".
void XmlReader::read_start() {
  if (open_.size() >= max_depth) fail("elements lie more than 64 deep");
  open_.push_back(read_name());
  attributes_.clear();
  std::vector<std::string> names;
  for (;;) {
    const size_t before = at_;
    pass_blank();
    if (starts_with("/>") || starts_with(">")) break;
    if (at_ == before || at_ >= text_.size()) fail("the start of <" + open_.back() + "> does not end with \">\"");
    read_attribute(names);
  }
  empty_element_ = starts_with("/>");
  advance(empty_element_ ? 2 : 1);
}

// After "</".
void XmlReader::read_end() {
  const std::string closed = read_name();
  pass_blank();
  if (open_.empty()) fail("</" + closed + "> ends an element that was not begun");
  if (closed != open_.back()) fail("</" + closed + "> stands where </" + open_.back() + "> is expected");
  if (!starts_with(">")) fail("</" + closed + " does not end with \">\"");
  advance(1);
}

XmlReader::Event XmlReader::next() {
  if (empty_element_) {
    empty_element_ = false;
    return Event::end;
  }
  while (at_ < text_.size()) {
    if (text_[at_] != '<') {
      const size_t end = std::min(text_.find('<', at_), text_.size());
      event_text_ = decoded(std::string_view(text_).substr(at_, end - at_));
      advance(end - at_);
      return Event::text;
    }
    if (starts_with("<![CDATA[")) {
      advance(9);
      event_text_ = up_to("]]>", "CDATA");
      return Event::text;
    }
    if (starts_with("<!--") || starts_with("<?")) {
      pass_aside();
    } else if (starts_with("<!")) {
      pass_doctype();
    } else if (starts_with("</")) {
      advance(2);
      read_end();
      return Event::end;
    } else {
      advance(1);
      read_start();
      return Event::start;
    }
  }
  if (!open_.empty()) fail("the file ends inside <" + open_.back() + ">");
  return Event::finished;
}

void XmlReader::enter_root() {
  for (;;) switch (next()) {
      case Event::start:
        return;
      case Event::text:
        if (!trimmed(event_text_).empty()) fail("text stands before the first element: this is not XML");
        break;
      default:
        fail("the file has no element: this is not XML");
    }
}

bool XmlReader::enter_child() {
  for (;;) switch (next()) {
      case Event::start:
        return true;
      case Event::end:
        open_.pop_back();
        return false;
      case Event::text:
        break;
      case Event::finished:
        return false;
    }
}

std::string XmlReader::text() {
  std::string out;
  for (const size_t depth = open_.size(); open_.size() >= depth;) switch (next()) {
      case Event::start:
        break;
      case Event::end:
        open_.pop_back();
        break;
      case Event::text:
        if (open_.size() == depth) out += event_text_;
        break;
      case Event::finished:
        return out;
    }
  return out;
}

bool XmlReader::has_more() {
  for (pass_blank(); starts_with("<!--") || starts_with("<?"); pass_blank()) pass_aside();
  return at_ < text_.size();
}

const std::string* XmlReader::attribute(std::string_view name) const {
  for (const Keyword& a : attributes_)
    if (a.name == name) return &a.value;
  return nullptr;
}

}  // namespace photometry
