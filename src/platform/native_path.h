// Between UTF-8 and std::filesystem, within this folder.
#pragma once
#include <filesystem>
#include <string>

namespace ups::platform {

inline std::filesystem::path native_path(const std::string& text) { return std::u8string(text.begin(), text.end()); }

inline std::string utf8_of(const std::filesystem::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

}  // namespace ups::platform
