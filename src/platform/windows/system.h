// <windows.h> without what it defines beside, and the system's texts, which are UTF-16.
#pragma once
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#ifndef _WIN32_WINNT
#define _WIN32_WINNT 0x0A00  // Windows 10
#endif
#include <windows.h>

#include <string>
#include <system_error>

#include "platform/native_path.h"

namespace ups::platform {

inline std::string utf8_of(const wchar_t* text) { return utf8_of(std::filesystem::path(text)); }

// Of the last call that failed.
inline std::error_code last_error() { return {int(GetLastError()), std::system_category()}; }

// A handle of an open file, or none.
class FileHandle {
 public:
  explicit FileHandle(HANDLE handle) : handle_(handle) {}
  ~FileHandle() { close(); }
  FileHandle(const FileHandle&) = delete;
  FileHandle& operator=(const FileHandle&) = delete;

  bool is_open() const { return handle_ != INVALID_HANDLE_VALUE; }
  HANDLE get() const { return handle_; }
  bool close() {
    const HANDLE handle = handle_;
    handle_ = INVALID_HANDLE_VALUE;
    return handle == INVALID_HANDLE_VALUE || CloseHandle(handle) != 0;
  }

 private:
  HANDLE handle_;
};

}  // namespace ups::platform
