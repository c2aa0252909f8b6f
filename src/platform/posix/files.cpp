// See files.h.
#include "platform/files.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "platform/native_path.h"

namespace ups::platform {

namespace fs = std::filesystem;

namespace {

// Whose entries stand for what the process has open; /dev/fd and /dev/stdout lead there.
#ifdef __APPLE__
constexpr const char* descriptor_folder = "/dev/fd";
#else
constexpr const char* descriptor_folder = "/proc/self/fd";
#endif

[[noreturn]] void fail_to_write(const std::string& path, int error) {
  throw std::system_error(error, std::generic_category(), "cannot write '" + path + "'");
}

// Where a path leads to.
struct Destination {
  fs::path file;            // the last link's target, which need not exist
  bool exists = false;
  bool replaceable = true;  // false: a device or the like, which takes bytes
  int descriptor = -1;      // of this process, where the path names one
  struct stat status {};    // where it exists

  fs::path folder() const {
    const auto parent = file.parent_path();
    return parent.empty() ? fs::path(".") : parent;
  }
};

// Follows symbolic links, but for what is open: it need not have a name, and a file to which output was redirected must
// not be replaced under those who write to it.
Destination destination_of(const std::string& path) {
  Destination to;
  to.file = native_path(path);
  std::error_code error;
  const auto descriptors = fs::canonical(descriptor_folder, error);
  constexpr int most_links = 40;  // as Linux's
  for (int links = 0; fs::exists(fs::symlink_status(to.file, error)); ++links) {
    const std::string name = to.file.filename().string();
    const bool is_number = !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
    if (is_number && !descriptors.empty() && fs::canonical(to.folder(), error) == descriptors) {
      to.descriptor = std::atoi(name.c_str());
      to.replaceable = false;
      return to;
    }
    if (!fs::is_symlink(to.file, error)) break;
    if (links == most_links) fail_to_write(path, ELOOP);
    const auto target = fs::read_symlink(to.file, error);
    if (error) fail_to_write(path, error.value());
    to.file = to.folder() / target;  // the target alone, where it is absolute
  }
  to.exists = ::stat(to.file.c_str(), &to.status) == 0;
  if (to.exists && S_ISDIR(to.status.st_mode)) fail_to_write(path, EISDIR);
  to.replaceable = !to.exists || S_ISREG(to.status.st_mode);
  return to;
}

// Of a file that will be replaced: who may not write into it must not, though the folder would let them.
Destination writable_destination_of(const std::string& path) {
  Destination to = destination_of(path);
  if (to.exists && to.replaceable && ::faccessat(AT_FDCWD, to.file.c_str(), W_OK, AT_EACCESS) != 0)
    fail_to_write(path, errno);
  return to;
}

// See open_to_read; of folders, too.
bool may_not_end(const std::string& path) {
  struct stat status;
  if (::stat(native_path(path).c_str(), &status) != 0 || S_ISREG(status.st_mode)) return false;
  return !S_ISFIFO(status.st_mode) || destination_of(path).descriptor < 0;
}

// Signals that end a process by default where a pipe has no reader any more, or a file grows beyond its limit: while
// this lives, the calling thread takes none, and those that came meanwhile are gone after it. Keeps errno.
#ifdef __APPLE__  // where the signal is the process's: a pipe can be told to send none
struct WriteSignalsHeld {
  explicit WriteSignalsHeld(int descriptor) { ::fcntl(descriptor, F_SETNOSIGPIPE, 1); }
};
#else
class WriteSignalsHeld {
 public:
  explicit WriteSignalsHeld(int) {
    sigset_t ours;
    sigemptyset(&ours);
    sigpending(&before_);
    for (const int number : numbers) sigaddset(&ours, number);
    pthread_sigmask(SIG_BLOCK, &ours, &mask_);
  }
  ~WriteSignalsHeld() {
    const int error = errno;
    sigset_t now;
    sigpending(&now);
    for (const int number : numbers)
      if (sigismember(&now, number) == 1 && sigismember(&before_, number) != 1) take(number);
    pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
    errno = error;
  }
  WriteSignalsHeld(const WriteSignalsHeld&) = delete;
  WriteSignalsHeld& operator=(const WriteSignalsHeld&) = delete;

 private:
  static constexpr int numbers[] = {SIGPIPE, SIGXFSZ};
  static void take(int number) {
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, number);
    const timespec at_once{0, 0};
    sigtimedwait(&one, nullptr, &at_once);
  }
  sigset_t mask_, before_;
};
#endif

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
    const WriteSignalsHeld held(descriptor_);
    const char* from = static_cast<const char*>(bytes);
    while (size > 0) {
      const ssize_t n = ::write(descriptor_, from, size);
      if (n < 0 && errno != EINTR) return false;
      if (n > 0) from += n, size -= size_t(n);
    }
    return true;
  }
  // Those of a file that this one will replace; only who may give files away keeps the owner. Where not even the group
  // can be kept, another one has no more than everybody: the file systems and name spaces that refuse it are many.
  bool take_permissions(const struct stat& of) {
    const bool same_group =
        ::fchown(descriptor_, of.st_uid, of.st_gid) == 0 || ::fchown(descriptor_, uid_t(-1), of.st_gid) == 0;
    const mode_t of_others = of.st_mode & 0007, of_group = same_group ? of.st_mode & 0070 : of_others << 3;
    return ::fchmod(descriptor_, (of.st_mode & 0700) | of_group | of_others) == 0;
  }

 private:
  int descriptor_;
};

// A new file in a folder, of a name that no other thread or process has; removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& folder) : descriptor(create(folder)) {}
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  bool rename_to(const fs::path& file) {
    if (::rename(path_.c_str(), file.c_str()) != 0) return false;
    path_.clear();
    return true;
  }

 private:
  int create(const fs::path& folder) {
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
  fs::path path_;

 public:
  Descriptor descriptor;  // not open: errno tells why
};

void write_into(const Destination& to, const std::string& path, const void* bytes, size_t size) {
  std::fflush(stdout);  // what was printed before comes first, should the path be standard output
  const int flags = O_WRONLY | O_CLOEXEC | O_NOCTTY;
  Descriptor out(to.descriptor >= 0 ? ::dup(to.descriptor) : ::open(to.file.c_str(), flags));
  if (!out.is_open() || !out.write(bytes, size) || !out.close()) fail_to_write(path, errno);
}

}  // namespace

std::ifstream open_to_read(const std::string& path) {
  std::ifstream file;
  if (may_not_end(path))
    file.setstate(std::ios::failbit);
  else
    file.open(native_path(path), std::ios::binary);
  return file;
}

void replace_file(const std::string& path, const void* bytes, size_t size) {
  const Destination to = writable_destination_of(path);
  if (!to.replaceable) return write_into(to, path, bytes, size);
  TemporaryFile temporary(to.folder());
  Descriptor& out = temporary.descriptor;
  if (!out.is_open() || (to.exists && !out.take_permissions(to.status)) || !out.write(bytes, size) || !out.sync() ||
      !out.close() || !temporary.rename_to(to.file))
    fail_to_write(path, errno);
  Descriptor folder(::open(to.folder().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) folder.sync();  // the new name; the file is whole either way
}

std::optional<std::string> folder_written_in(const std::string& path) {
  const Destination to = writable_destination_of(path);
  return to.replaceable ? std::optional(utf8_of(to.folder())) : std::nullopt;
}

std::error_code try_folder(const std::string& folder) {
  const TemporaryFile probe(native_path(folder));
  return probe.descriptor.is_open() ? std::error_code() : std::error_code(errno, std::generic_category());
}

std::string message_of(const std::error_code& error) { return error.message(); }

}  // namespace ups::platform
