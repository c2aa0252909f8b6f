// See files.h.
#include "platform/files.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>

#include "platform/windows/system.h"

namespace ups::platform {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail_to_write(const std::string& path, const std::error_code& error) {
  const std::error_condition condition = error.default_error_condition();
  const bool known = condition.category() == std::generic_category();  // else the number is Windows' own
  throw std::system_error(known ? condition.value() : EIO, std::generic_category(),
                          "cannot write '" + path + "'" +
                              (known ? "" : " (Windows error " + std::to_string(error.value()) + ")"));
}

// Where a path leads to.
struct Destination {
  fs::path file;            // what a link leads to
  bool replaceable = true;  // false: a device or a pipe, which takes bytes

  fs::path folder() const {
    const auto parent = file.parent_path();
    return parent.empty() ? fs::path(".") : parent;
  }
};

HANDLE open_existing(const fs::path& file, DWORD access) {
  constexpr DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  return CreateFileW(file.c_str(), access, shared, nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
}

// Without access to its bytes, so that a file is not held and a pipe is not connected.
Destination destination_of(const std::string& path) {
  Destination to;
  to.file = native_path(path);
  const DWORD attributes = GetFileAttributesW(to.file.c_str());
  const bool exists = attributes != INVALID_FILE_ATTRIBUTES;
  if (exists && attributes & FILE_ATTRIBUTE_DIRECTORY)
    fail_to_write(path, std::make_error_code(std::errc::is_a_directory));
  const FileHandle found(open_existing(to.file, 0));
  if (!found.is_open()) return to;
  to.replaceable = GetFileType(found.get()) == FILE_TYPE_DISK;
  if (!to.replaceable || !exists || !(attributes & FILE_ATTRIBUTE_REPARSE_POINT)) return to;
  const DWORD size = GetFinalPathNameByHandleW(found.get(), nullptr, 0, FILE_NAME_NORMALIZED);
  std::wstring target(size, L'\0');
  if (size > 0 && GetFinalPathNameByHandleW(found.get(), target.data(), size, FILE_NAME_NORMALIZED) == size - 1) {
    target.resize(size - 1);
    to.file = target;
  }
  return to;
}

bool write_all(HANDLE to, const void* bytes, size_t size) {
  const char* from = static_cast<const char*>(bytes);
  while (size > 0) {
    DWORD written = 0;
    if (!WriteFile(to, from, DWORD(std::min<size_t>(size, 1u << 30)), &written, nullptr)) return false;
    from += written, size -= written;
  }
  return true;
}

// A new file in a folder, of a name that no other thread or process has; removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& folder) : handle(create(folder)) {}
  ~TemporaryFile() {
    handle.close();
    if (!path_.empty()) DeleteFileW(path_.c_str());
  }
  // Closed before. Security and attributes are the folder's, not those of the file that is replaced.
  bool rename_to(const fs::path& file) {
    if (!MoveFileExW(path_.c_str(), file.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH)) return false;
    path_.clear();
    return true;
  }

 private:
  HANDLE create(const fs::path& folder) {
    static std::atomic<unsigned> counter{0};
    while (true) {  // other libraries count too, and a process that broke down may have left names behind
      const std::string process = std::to_string(GetCurrentProcessId());
      path_ = folder / native_path("ups." + process + "." + std::to_string(counter++) + ".tmp");
      const HANDLE made =
          CreateFileW(path_.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
      if (made != INVALID_HANDLE_VALUE) return made;
      const DWORD error = GetLastError();
      path_.clear();
      SetLastError(error);
      if (error != ERROR_FILE_EXISTS) return made;
    }
  }
  fs::path path_;

 public:
  FileHandle handle;  // not open: GetLastError() tells why
};

}  // namespace

std::ifstream open_to_read(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(native_path(path), error);
  std::ifstream file;
  if (fs::is_directory(status) || fs::is_character_file(status))
    file.setstate(std::ios::failbit);
  else
    file.open(native_path(path), std::ios::binary);
  return file;
}

void replace_file(const std::string& path, const void* bytes, size_t size) {
  const Destination to = destination_of(path);
  if (!to.replaceable) {
    std::fflush(stdout);  // what was printed before comes first, should the path be the console
    FileHandle out(open_existing(to.file, GENERIC_WRITE));
    if (!out.is_open() || !write_all(out.get(), bytes, size) || !out.close()) fail_to_write(path, last_error());
    return;
  }
  TemporaryFile temporary(to.folder());
  FileHandle& out = temporary.handle;
  if (!out.is_open() || !write_all(out.get(), bytes, size) || !FlushFileBuffers(out.get()) || !out.close() ||
      !temporary.rename_to(to.file))
    fail_to_write(path, last_error());
}

std::optional<std::string> folder_written_in(const std::string& path) {
  const Destination to = destination_of(path);
  return to.replaceable ? std::optional(utf8_of(to.folder())) : std::nullopt;
}

std::error_code try_folder(const std::string& folder) {
  const TemporaryFile probe(native_path(folder));
  return probe.handle.is_open() ? std::error_code() : last_error();
}

// The system's own words are in its language and code page.
std::string message_of(const std::error_code& error) { return error.default_error_condition().message(); }

}  // namespace ups::platform
