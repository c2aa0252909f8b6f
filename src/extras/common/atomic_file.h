// How a file is written: it appears whole or not at all, beside its place first and then renamed. A symbolic link stays
// one, and the file that it leads to is replaced; a device, a pipe or an open descriptor (/dev/stdout) is written to.
// Called by the writers of the extras and by the program's output.
#pragma once
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>

#include "common/boundary.h"

namespace ups::extras {

[[noreturn]] inline void fail_to_write(const std::string& path, int error) {
  throw Error(UPS_ERROR_IO, "cannot write '" + path + "': " + std::strerror(error));
}

// Where a path leads to.
struct Destination {
  std::filesystem::path file;  // the last link's target, which need not exist
  bool exists = false;
  bool replaceable = true;     // false: a device or the like, which takes bytes
  int descriptor = -1;         // of this process, where the path names one
  struct stat status {};       // where it exists

  std::filesystem::path folder() const {
    const auto parent = file.parent_path();
    return parent.empty() ? std::filesystem::path(".") : parent;
  }
};

// Follows symbolic links. Those in /proc/self/fd, to which /dev/stdout and /dev/fd/N lead, stand for what is open: it
// need not have a name, and a file to which output was redirected must not be replaced under those who write to it.
inline Destination destination_of(const std::string& path) {
  require(!path.empty(), "the path of the file to write is empty");
  Destination to;
  to.file = path;
  std::error_code error;
  const auto descriptors = std::filesystem::canonical("/proc/self/fd", error);
  constexpr int most_links = 40;  // as the kernel's
  for (int links = 0; std::filesystem::is_symlink(to.file, error); ++links) {
    if (links == most_links) fail_to_write(path, ELOOP);
    if (!descriptors.empty() && std::filesystem::canonical(to.folder(), error) == descriptors) {
      to.descriptor = std::atoi(to.file.filename().c_str());
      to.replaceable = false;
      return to;
    }
    const auto target = std::filesystem::read_symlink(to.file, error);
    if (error) fail_to_write(path, error.value());
    to.file = to.folder() / target;  // the target alone, where it is absolute
  }
  to.exists = ::stat(to.file.c_str(), &to.status) == 0;
  if (to.exists && S_ISDIR(to.status.st_mode)) fail_to_write(path, EISDIR);
  to.replaceable = !to.exists || S_ISREG(to.status.st_mode);
  return to;
}

// An open file; the functions set errno where they return false.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  bool close() { return !is_open() || ::close(std::exchange(descriptor_, -1)) == 0; }
  bool sync() { return ::fsync(descriptor_) == 0 || errno == EINVAL; }  // EINVAL: a file system without it
  bool write(const void* bytes, size_t size) {
    const char* from = static_cast<const char*>(bytes);
    while (size > 0) {
      const ssize_t n = ::write(descriptor_, from, size);
      if (n < 0 && errno != EINTR) return false;
      if (n > 0) from += n, size -= size_t(n);
    }
    return true;
  }
  // Those of a file that this one will replace; only who may give files away keeps the owner.
  bool take_permissions(const struct stat& of) {
    if (::fchown(descriptor_, of.st_uid, of.st_gid) != 0 && errno != EPERM) return false;
    return ::fchmod(descriptor_, of.st_mode & 0777) == 0;
  }

 private:
  int descriptor_;
};

// A new file in a folder, of a name that no other thread or process has; removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& folder) : descriptor(create(folder)) {}
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  bool rename_to(const std::filesystem::path& file) {
    if (::rename(path_.c_str(), file.c_str()) != 0) return false;
    path_.clear();
    return true;
  }

 private:
  int create(const std::filesystem::path& folder) {
    static std::atomic<unsigned> counter{0};
    while (true) {  // other libraries count too, and a process that broke down may have left names behind
      path_ = folder / ("ups." + std::to_string(::getpid()) + "." + std::to_string(counter++) + ".tmp");
      const int opened = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (opened >= 0) return opened;
      const int error = errno;
      path_.clear();
      errno = error;
      if (error != EEXIST) return opened;
    }
  }
  std::filesystem::path path_;

 public:
  Descriptor descriptor;  // not open: errno tells why
};

inline void write_file(const std::string& path, const void* bytes, size_t size) {
  const Destination to = destination_of(path);
  if (!to.replaceable) {
    std::fflush(stdout);  // what was printed before comes first, should the path be standard output
    const int flags = O_WRONLY | O_CLOEXEC | O_NOCTTY;
    Descriptor out(to.descriptor >= 0 ? ::dup(to.descriptor) : ::open(to.file.c_str(), flags));
    if (!out.is_open() || !out.write(bytes, size) || !out.close()) fail_to_write(path, errno);
    return;
  }
  TemporaryFile temporary(to.folder());
  Descriptor& out = temporary.descriptor;
  if (!out.is_open() || (to.exists && !out.take_permissions(to.status)) || !out.write(bytes, size) || !out.sync() ||
      !out.close() || !temporary.rename_to(to.file))
    fail_to_write(path, errno);
  Descriptor folder(::open(to.folder().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) folder.sync();  // the new name; the file is whole either way
}

}  // namespace ups::extras
