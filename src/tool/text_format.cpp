// See text_format.h: UTF-8, and what a terminal would obey instead of showing.
#include "tool/text_format.h"

namespace ups::tool {
namespace {

bool steers_terminal(uint32_t code) {
  const bool control = (code < 0x20 && code != '\n') || (code >= 0x7f && code <= 0x9f);
  const bool direction = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return control || direction;
}

// escape(code, is_byte): what replaces a character that steers, or a byte that is no UTF-8.
template <class Escape>
std::string escaped(const std::string& text, const Escape& escape) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const Utf8 character = utf8_at(text, i);
    if (character.length == 0) {
      out += escape(uint8_t(text[i++]), true);
      continue;
    }
    out += steers_terminal(character.code) ? escape(character.code, false) : text.substr(i, character.length);
    i += character.length;
  }
  return out;
}

}  // namespace

std::string printable(const std::string& text) {
  return escaped(text, [](uint32_t code, bool) { return format(code < 0x100 ? "\\x%02x" : "\\u%04x", code); });
}

std::string printable_json(const std::string& json) {
  return escaped(json, [](uint32_t code, bool is_byte) { return format("\\u%04x", is_byte ? 0xfffdu : code); });
}

std::string one_line(std::string text) {
  for (size_t i = 0; i < text.size();) {
    const Utf8 character = utf8_at(text, i);
    if (character.length == 0 || character.code < 0x20 || character.code == 0x7f) text[i] = '_';
    i += std::max<size_t>(1, character.length);
  }
  return text;
}

void put(std::FILE* stream, const std::string& text) { std::fputs(printable(text).c_str(), stream); }

void put_error(const std::string& message) { put(stderr, "ups: error: " + message + "\n"); }

void put_warning(const std::string& message) { put(stderr, "ups: warning: " + message + "\n"); }

}  // namespace ups::tool
