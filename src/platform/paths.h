// Names of files and folders, in UTF-8 everywhere: std::filesystem takes a std::string for something else on some
// systems, so it is used within this folder alone. Where std::filesystem tells an error these say no, or nothing.
#pragma once
#include <string>
#include <system_error>
#include <vector>

namespace ups::platform {

// Parts of a name: "a/b.c" has the folder "a", the file name "b.c", the stem "b" and the extension ".c".
std::string folder_of(const std::string& path);
std::string file_name_of(const std::string& path);
std::string stem_of(const std::string& path);
std::string extension_of(const std::string& path);

// The name as seen from the folder; the name alone, where it is absolute.
std::string joined(const std::string& folder, const std::string& name);
// The same place without "..", as far as the text tells.
std::string simplified(const std::string& path);
// The other way: from a folder to what is in it.
std::string relative_to(const std::string& folder, const std::string& path);

bool is_folder(const std::string& path);
bool is_regular_file(const std::string& path);
// Why open_to_read() of files.h has failed: "there is no such file".
std::string why_not_open(const std::string& path);
// Links are followed first: what counts is where the bytes lie. A path that does not resolve is no file: true.
bool lies_within(const std::string& path, const std::string& folder);

// The one name of what is there, with all links followed; empty where there is nothing.
std::string resolved(const std::string& path);

// With those that it lies in; no error where it is there already.
std::error_code make_folder(const std::string& folder);

struct FolderEntry {
  std::string path, name;               // the path begins with the folder's
  bool is_folder, is_file, is_link;     // of a link the first two tell what it leads to
};
// In no order; "" is the working folder. With an error, what came before it.
std::vector<FolderEntry> entries_of(const std::string& folder, std::error_code& error);
// The file of that name in the folder, in any case of ASCII letters; empty where there is none. Of a name with folders
// the last part alone: they are of the machine that wrote it.
std::string find_in_any_case(const std::string& folder, const std::string& name);

}  // namespace ups::platform
