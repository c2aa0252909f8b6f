// How glTF names files and embeds their bytes. Included by the import, and by the program, which must know what files a
// scene names.
#pragma once
#include <string>

namespace ups::gltf {

inline bool is_data_uri(const std::string& uri) { return uri.rfind("data:", 0) == 0; }

// A URI's text: "%20" is a blank.
inline std::string percent_decoded(const std::string& uri) {
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
  };
  std::string result;
  for (size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
      result += char(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
      i += 2;
    } else {
      result += uri[i];
    }
  }
  return result;
}

}  // namespace ups::gltf
