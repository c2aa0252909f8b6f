// See paths.h.
#include "platform/paths.h"

#include <algorithm>

#include "platform/files.h"
#include "platform/native_path.h"

namespace ups::platform {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) { return utf8_of(native_path(path).parent_path()); }
std::string file_name_of(const std::string& path) { return utf8_of(native_path(path).filename()); }
std::string stem_of(const std::string& path) { return utf8_of(native_path(path).stem()); }
std::string extension_of(const std::string& path) { return utf8_of(native_path(path).extension()); }

std::string joined(const std::string& folder, const std::string& name) {
  return utf8_of(native_path(folder) / native_path(name));
}

std::string simplified(const std::string& path) { return utf8_of(native_path(path).lexically_normal()); }

std::string relative_to(const std::string& folder, const std::string& path) {
  return utf8_of(native_path(path).lexically_relative(native_path(folder)));
}

bool is_folder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(native_path(path), error);
}

bool is_regular_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(native_path(path), error);
}

std::string why_not_open(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(native_path(path), error);
  if (status.type() == fs::file_type::not_found) return "there is no such file";
  if (error) return message_of(error);
  if (fs::is_directory(status)) return "it is a folder, not a file";
  return fs::is_regular_file(status) ? "it may not be read" : "it is a device or a pipe, not a file";
}

bool lies_within(const std::string& path, const std::string& folder) {
  std::error_code error;
  const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : native_path(folder), error);
  if (error) return true;
  const fs::path whole = fs::absolute(native_path(path), error);  // what is not there stays as it is given
  if (error) return true;
  const fs::path file = fs::weakly_canonical(whole, error);
  return error || std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first == root.end();
}

std::string resolved(const std::string& path) {
  std::error_code error;
  const fs::path file = fs::canonical(native_path(path), error);
  return error ? std::string() : utf8_of(file);
}

std::error_code make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(native_path(folder), error);
  return error;
}

std::vector<FolderEntry> entries_of(const std::string& folder, std::error_code& error) {
  std::vector<FolderEntry> entries;
  const fs::path place = folder.empty() ? fs::path(".") : native_path(folder);
  for (fs::directory_iterator at(place, error), end; !error && at != end; at.increment(error)) {
    std::error_code none;
    entries.push_back({utf8_of(at->path()), utf8_of(at->path().filename()), at->is_directory(none),
                       at->is_regular_file(none), at->is_symlink(none)});
  }
  return entries;
}

std::string find_in_any_case(const std::string& folder, const std::string& name) {
  const auto lower = [](std::string text) {
    for (char& c : text)
      if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
  };
  const std::string wanted = lower(name.substr(name.find_last_of("/\\") + 1));
  std::string found;
  std::error_code error;
  for (const FolderEntry& entry : entries_of(folder, error))
    if (entry.is_file && lower(entry.name) == wanted && (found.empty() || entry.path < found)) found = entry.path;
  return found;
}

}  // namespace ups::platform
