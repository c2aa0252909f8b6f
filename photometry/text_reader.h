// Lines and numbers from the bytes of a text file, with the line of each. Reads what writers of photometric files leave
// behind: byte order marks, UTF-16, Latin-1, any line ends, Ctrl-Z, commas between or inside numbers. Never asks the
// locale. Used by the readers of photometric formats.
#pragma once
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "photometry/photometry.h"

namespace photometry {

inline std::string at_line(size_t line, std::string what) {
  std::replace(what.begin(), what.end(), '\0', '?');  // quoted from a file; what a C string says would end there
  return "line " + std::to_string(line) + ": " + what;
}
[[noreturn]] inline void fail_at(size_t line, const std::string& what) { throw ParseError(at_line(line, what)); }

inline std::string_view trimmed(std::string_view s) {
  const char* blank = " \t\r\n\v\f";
  const size_t first = s.find_first_not_of(blank);
  return first == s.npos ? std::string_view() : s.substr(first, s.find_last_not_of(blank) - first + 1);
}

// Its beginning, of whole characters of UTF-8: to quote in a message.
inline std::string cut(std::string_view text, size_t most_bytes = 40) {
  size_t size = std::min(text.size(), most_bytes);
  while (size > 0 && size < text.size() && (text[size] & 0xc0) == 0x80) --size;
  return std::string(text.substr(0, size));
}

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

inline std::string upper_case(std::string_view s) {
  std::string out(s);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
  return out;
}

// The whole of the token as a number; a leading + is allowed. False where it is none or out of a double's range.
inline bool parse_number(std::string_view token, double& value) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc() && end == token.data() + token.size();
}

// As few digits as read back to the same number.
inline std::string shortest(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

// Six digits, for messages.
inline std::string shown(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr);
}

// "1 value is", "2 values are"; for messages.
inline std::string counted(size_t n, const char* one, const char* several) {
  return std::to_string(n) + " " + (n == 1 ? one : several);
}

// The warning where ReadOptions::tilt_deg asks for what the file does not have.
inline std::string no_tilt_table(double tilt_deg) {
  return "there is no TILT table; the tilt of " + shown(tilt_deg) + " degrees changes nothing";
}

// The character's UTF-8; U+FFFD for what is none.
void append_utf8(std::string& out, uint32_t c);

// RFC 3629, section 4: without overlong forms, surrogates and what is beyond U+10FFFF.
bool is_utf8(const void* bytes, size_t size);

// UTF-8 from bytes that are UTF-8, UTF-16 with its mark, or else taken as Latin-1.
std::string decode_text(const void* bytes, size_t size);

class TextReader {
 public:
  explicit TextReader(std::string text) : text_(std::move(text)) {}

  // False at the end. The line comes without its end.
  bool next_line(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    const size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    line = std::string_view(text_).substr(at_, end - at_);
    line_ = next_line_++;
    at_ = std::min(end + (text_.compare(end, 2, "\r\n") == 0 ? 2 : 1), text_.size());
    return true;
  }
  size_t line() const { return line_; }  // of the last line or token, from 1

  struct Mark {
    size_t at, line, next_line;
  };
  Mark mark() const { return {at_, line_, next_line_}; }
  void go_to(const Mark& m) { at_ = m.at, line_ = m.line, next_line_ = m.next_line; }

  // Decides what commas in the rest of the text are: decimal where no number has a point and none more than one comma,
  // else separators. Throws ParseError for a line that has a comma inside a number and blanks alone between others, and
  // where all commas may be thousands marks. True: decimal.
  bool detect_decimal_commas();

  // The next blank- or comma-separated token, over line ends. False at the end or at Ctrl-Z.
  bool next_token(std::string_view& token) {
    while (at_ < text_.size() && is_separator(text_[at_])) {
      if (text_[at_] == '\n' || (text_[at_] == '\r' && !(at_ + 1 < text_.size() && text_[at_ + 1] == '\n')))
        ++next_line_;
      ++at_;
    }
    if (at_ >= text_.size() || text_[at_] == end_of_text) return false;
    const size_t first = at_;
    while (at_ < text_.size() && !is_separator(text_[at_]) && text_[at_] != end_of_text) ++at_;
    token = std::string_view(text_).substr(first, at_ - first);
    line_ = next_line_;
    return true;
  }
  // `name` says what is expected here, for the message.
  double number(const std::string& name);
  // The same for the i-th of many, "name i of n".
  double number(const char* name, size_t i, size_t n);
  // A whole number, which may be written 1.0, of at least `least` and at most 4000000.
  size_t count(const std::string& name, size_t least);

 private:
  static constexpr char end_of_text = '\x1a';
  bool next_number(double& value, std::string_view& token);
  [[noreturn]] void fail_number(std::string_view token, const std::string& name) const;
  bool is_separator(char c) const {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f' || c == '\0' || c == ';' ||
           (c == ',' && !decimal_commas_);
  }

  std::string text_;
  size_t at_ = 0, line_ = 1, next_line_ = 1;
  bool decimal_commas_ = false;
};

}  // namespace photometry
