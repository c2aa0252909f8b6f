// A file that appears whole or not at all: written beside its place, then renamed. Called by the writers of the extras
// and by the program's output.
#pragma once
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "common/boundary.h"

namespace ups::extras {

class AtomicFile {
 public:
  explicit AtomicFile(std::string path) : path_(std::move(path)) {
    require(!path_.empty(), "the path of the file to write is empty");
    temporary_ = path_ + "." + std::to_string(::getpid()) + ".tmp";
  }
  ~AtomicFile() {
    std::error_code ignored;
    if (!done_) std::filesystem::remove(temporary_, ignored);
  }
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::string& temporary() const { return temporary_; }  // where to write

  void commit() {
    std::error_code error;
    std::filesystem::rename(temporary_, path_, error);
    if (error) throw Error(UPS_ERROR_IO, "cannot write '" + path_ + "': " + error.message());
    done_ = true;
  }

 private:
  std::string path_, temporary_;
  bool done_ = false;
};

inline void write_file(const std::string& path, const void* bytes, size_t size) {
  AtomicFile file(path);
  std::FILE* out = std::fopen(file.temporary().c_str(), "wb");
  if (!out) throw Error(UPS_ERROR_IO, "cannot write '" + path + "': " + std::strerror(errno));
  const bool written = std::fwrite(bytes, 1, size, out) == size;
  const int write_errno = errno;
  const bool closed = std::fclose(out) == 0;
  if (!written || !closed) {
    throw Error(UPS_ERROR_IO, "cannot write '" + path + "': " + std::strerror(written ? errno : write_errno));
  }
  file.commit();
}

}  // namespace ups::extras
