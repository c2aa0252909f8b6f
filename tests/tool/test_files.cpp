// How files are written, as seen through the writer of images: links, pipes and permissions stay, a file is whole or
// what it was before, two threads do not meet. No device is touched: a defect would replace it.
#include <fcntl.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ups/ups_exr.h"
#include "ups/ups_ocio.h"

namespace fs = std::filesystem;

namespace {

std::mutex mutex;
std::string calls;  // of the writers to the two functions below, in their order

void record(const char* name) {
  const std::lock_guard lock(mutex);
  calls += name;
}

}  // namespace

// In place of the system's, for the whole program.
extern "C" __attribute__((visibility("default"))) int fsync(int descriptor) {
  struct stat status {};
  record(fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode) ? "sync folder;" : "sync file;");
  return int(syscall(SYS_fsync, descriptor));
}
extern "C" __attribute__((visibility("default"))) int rename(const char* from, const char* to) noexcept {
  record("rename;");
  return int(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace {

// The exit code of a process of its own.
int in_child(const std::function<int()>& run) {
  const pid_t child = fork();
  if (child == 0) _exit(run());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class Files : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string path(const char* name) const { return (folder / name).string(); }
  static ups_status write(const std::string& file, uint32_t size = 4) {
    const std::vector<float> values(size * size, 1);
    const ups_exr_channel channel = {"Y", values.data(), 0, 0};
    return ups_exr_write(file.c_str(), size, size, &channel, 1, nullptr, 0);
  }
  static bool is_image(const std::string& file) {
    ups_exr_image* image = nullptr;
    const bool read = ups_exr_read(file.c_str(), &image) == UPS_OK;
    ups_exr_image_destroy(image);
    return read;
  }
  static mode_t mode_of(const std::string& file) {
    struct stat status {};
    EXPECT_EQ(stat(file.c_str(), &status), 0);
    return status.st_mode & 07777;
  }
  static void put(const std::string& file, const std::string& text) { std::ofstream(file) << text; }
  static std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  size_t file_count() const { return size_t(std::distance(fs::directory_iterator(folder), {})); }

  const fs::path folder = fs::path(testing::TempDir()) / ("ups-files-" + std::to_string(::getpid()));
};

TEST_F(Files, ALinkStaysAndItsTargetIsWritten) {
  fs::create_directory(folder / "there");
  put(path("there/target.exr"), "old");
  fs::create_symlink("there/target.exr", path("near"));         // relative to the link's folder
  fs::create_symlink(fs::absolute(path("near")), path("far"));  // a link to a link
  fs::create_symlink("there/none.exr", path("dangling"));
  ASSERT_EQ(write(path("far")), UPS_OK) << ups_exr_last_error();
  EXPECT_TRUE(fs::is_symlink(path("far")) && fs::is_symlink(path("near")));
  EXPECT_TRUE(is_image(path("there/target.exr")));
  ASSERT_EQ(write(path("dangling")), UPS_OK) << ups_exr_last_error();
  EXPECT_TRUE(fs::is_symlink(path("dangling")) && is_image(path("there/none.exr")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "there"), {}), 2) << "a temporary file is left";
  EXPECT_EQ(file_count(), 4u);
}

TEST_F(Files, ALoopOfLinksAndAFolderAreErrors) {
  fs::create_symlink("b", path("a"));
  fs::create_symlink("a", path("b"));
  EXPECT_EQ(write(path("a")), UPS_ERROR_IO);
  EXPECT_EQ(write(folder.string()), UPS_ERROR_IO);
  EXPECT_NE(std::string(ups_exr_last_error()).find("cannot write '" + folder.string() + "'"), std::string::npos);
  EXPECT_EQ(write(""), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(file_count(), 2u);
}

TEST_F(Files, APipeIsWrittenTo) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", path("link"));
  std::string read;
  std::thread reader([&] { read = text_of(path("pipe")); });
  EXPECT_EQ(write(path("link"), 256), UPS_OK) << ups_exr_last_error();
  reader.join();
  put(path("read.exr"), read);
  EXPECT_TRUE(is_image(path("read.exr")));
  EXPECT_TRUE(fs::is_fifo(path("pipe")) && fs::is_symlink(path("link")));
}

// As /dev/stdout is one: a link to what is open.
TEST_F(Files, AnOpenDescriptorIsWrittenToWhereItStands) {
  const int descriptor = ::open(path("output").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_GE(descriptor, 0);
  ASSERT_EQ(::write(descriptor, "before;", 7), 7);
  EXPECT_EQ(write("/dev/fd/" + std::to_string(descriptor)), UPS_OK) << ups_exr_last_error();
  ASSERT_EQ(::write(descriptor, ";after", 6), 6);
  ::close(descriptor);
  ASSERT_EQ(write(path("alone")), UPS_OK);
  EXPECT_EQ(text_of(path("output")), "before;" + text_of(path("alone")) + ";after");
}

// Not what the number of its name, 0, would be.
TEST_F(Files, TheFolderOfDescriptorsIsAFolder) {
  const int kept = ::dup(0), stand_in = ::open(path("input").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(::dup2(stand_in, 0), 0);
  for (const char* folder_of_descriptors : {"/dev/fd/", "/dev/fd/.", "/proc/self/fd/"})
    EXPECT_EQ(write(folder_of_descriptors), UPS_ERROR_IO) << folder_of_descriptors;
  if (kept >= 0) ::dup2(kept, 0), ::close(kept);
  else ::close(0);
  ::close(stand_in);
  EXPECT_EQ(text_of(path("input")), "");
}

// By default the system ends a process that writes there.
TEST_F(Files, APipeThatNobodyReadsAnyMoreIsAnError) {
  EXPECT_EQ(in_child([&] {
    int ends[2];
    if (::pipe(ends) != 0) return 2;
    ::close(ends[0]);
    std::signal(SIGPIPE, SIG_DFL);
    if (write("/dev/fd/" + std::to_string(ends[1]), 64) != UPS_ERROR_IO) return 3;
    sigset_t pending, blocked;
    sigpending(&pending);
    pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
    return sigismember(&pending, SIGPIPE) || sigismember(&blocked, SIGPIPE) ? 4 : 0;
  }), 0);
}

TEST_F(Files, AnImageIsNotReadFromAPipe) {
  ASSERT_EQ(write(path("a.exr")), UPS_OK);
  const std::string bytes = text_of(path("a.exr"));
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], bytes.data(), bytes.size()), ssize_t(bytes.size()));
  ::close(ends[1]);
  ups_exr_image* image = nullptr;
  EXPECT_EQ(ups_exr_read(("/dev/fd/" + std::to_string(ends[0])).c_str(), &image), UPS_ERROR_IO);
  EXPECT_NE(std::string(ups_exr_last_error()).find("it is a pipe"), std::string::npos) << ups_exr_last_error();
  ::close(ends[0]);
}

TEST_F(Files, PermissionsAreTheMasksOrThoseOfTheFileReplaced) {
  const mode_t mask = umask(027);
  EXPECT_EQ(write(path("new")), UPS_OK);
  umask(077);
  put(path("old"), "old");
  ASSERT_EQ(chmod(path("old").c_str(), 0646), 0);
  EXPECT_EQ(write(path("old")), UPS_OK);
  umask(mask);
  EXPECT_EQ(mode_of(path("new")), 0640u);
  EXPECT_EQ(mode_of(path("old")), 0646u);
  EXPECT_TRUE(is_image(path("old")));
}

// As another user; 0: it was written.
int written_by(const std::string& file, const std::function<bool()>& become) {
  return in_child([&] {
    const std::vector<float> values(16, 1);
    const ups_exr_channel channel = {"Y", values.data(), 0, 0};
    return !become() ? 2 : ups_exr_write(file.c_str(), 4, 4, &channel, 1, nullptr, 0) == UPS_OK ? 0 : 1;
  });
}

// Another user cannot be tried where root has one id alone, or where the folder for temporary files is root's own.
bool reaches(const fs::path& folder, uid_t user, gid_t group) {
  return in_child([&] {
    const bool other = setgroups(0, nullptr) == 0 && setgid(group) == 0 && setuid(user) == 0;
    return other && access(folder.c_str(), W_OK | X_OK) == 0 ? 0 : 1;
  }) == 0;
}

// A member of the file's group keeps the group, who cannot keep it gives its rights to no other; a name space that does
// not know the group refuses to set it with another error.
TEST_F(Files, WhoMayNotGiveAFileAwayKeepsItsGroupOrNoRightsOfOne) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become others";
  constexpr uid_t owner = 61001, other = 61002;
  constexpr gid_t shared = 62001, own = 62002;
  fs::permissions(folder, fs::perms::all);
  if (!reaches(folder, other, own)) GTEST_SKIP() << "no other user can use " << folder;
  const std::string file = path("a.exr");
  const auto prepare = [&] {
    ASSERT_EQ(write(file), UPS_OK);
    ASSERT_EQ(chown(file.c_str(), owner, shared), 0);
    ASSERT_EQ(chmod(file.c_str(), 0662), 0);
  };
  const auto as_other = [=](bool member) {
    return setgroups(member ? 1 : 0, &shared) == 0 && setgid(own) == 0 && setuid(other) == 0;
  };
  struct stat found;
  prepare();
  ASSERT_EQ(written_by(file, [&] { return as_other(true); }), 0);
  ASSERT_EQ(stat(file.c_str(), &found), 0);
  EXPECT_EQ(found.st_gid, shared);
  EXPECT_EQ(found.st_mode & 0777, 0662u);
  prepare();
  ASSERT_EQ(written_by(file, [&] { return as_other(false); }), 0);
  ASSERT_EQ(stat(file.c_str(), &found), 0);
  EXPECT_EQ(found.st_gid, own);
  EXPECT_EQ(found.st_mode & 0777, 0622u) << "another group has what everybody has";
  prepare();
  const int in_name_space = written_by(file, [&] { return as_other(false) && unshare(CLONE_NEWUSER) == 0; });
  EXPECT_TRUE(in_name_space == 0 || in_name_space == 2) << "2: there are no name spaces of users";
}

// Its owner has said so; that the folder takes new files does not matter. Root may write all the same.
TEST_F(Files, OneThatMayNotBeWrittenIsNotReplaced) {
  constexpr uid_t owner = 61001;
  constexpr gid_t group = 62001;
  fs::permissions(folder, fs::perms::all);
  if (geteuid() == 0 && !reaches(folder, owner, group)) GTEST_SKIP() << "no other user can use " << folder;
  put(path("kept"), "old");
  ASSERT_EQ(chmod(path("kept").c_str(), 0444), 0);
  if (geteuid() == 0) {
    ASSERT_EQ(chown(path("kept").c_str(), owner, group), 0);
    const auto become = [=] { return setgroups(0, nullptr) == 0 && setgid(group) == 0 && setuid(owner) == 0; };
    EXPECT_EQ(written_by(path("kept"), become), 1);
    EXPECT_EQ(written_by(path("new"), become), 0);
  } else {
    EXPECT_NE(write(path("kept")), UPS_OK);
    EXPECT_NE(std::string(ups_exr_last_error()).find("Permission denied"), std::string::npos) << ups_exr_last_error();
    EXPECT_EQ(write(path("new")), UPS_OK);
  }
  EXPECT_EQ(text_of(path("kept")), "old");
  EXPECT_EQ(mode_of(path("kept")), 0444u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2) << "a temporary file is left";
}

// A few bytes may claim an image that would fill the memory.
TEST_F(Files, ASmallFileThatClaimsALargeImageIsRefused) {
  ASSERT_EQ(write(path("a.exr"), 64), UPS_OK);
  std::ifstream from(path("a.exr"), std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(from), {}};
  const std::string name("dataWindow\0box2i\0", 17);
  const size_t at = bytes.find(name);
  ASSERT_NE(at, bytes.npos);
  const int32_t corner = 32767;
  for (size_t k : {8, 12}) std::memcpy(&bytes[at + name.size() + 4 + k], &corner, 4);
  std::ofstream(path("b.exr"), std::ios::binary) << bytes << std::string(100000, '\0');  // room for a table of chunks
  ups_exr_image* image = nullptr;
  EXPECT_EQ(ups_exr_read(path("b.exr").c_str(), &image), UPS_ERROR_PARSE);
  EXPECT_NE(std::string(ups_exr_last_error()).find("32768 x 32768 pixels and 1 channels is not in a file of"),
            std::string::npos) << ups_exr_last_error();
}

TEST_F(Files, AWriteThatFailsLeavesTheOldFile) {
  put(path("a.exr"), "old");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 100;
  const auto handler = std::signal(SIGXFSZ, SIG_DFL);  // ends the process
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const ups_status status = write(path("a.exr"), 64);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(status, UPS_ERROR_IO);
  EXPECT_EQ(text_of(path("a.exr")), "old");
  EXPECT_EQ(file_count(), 1u) << "a temporary file is left";
}

TEST_F(Files, TheFileIsOnTheDiskBeforeItHasItsName) {
  calls.clear();
  EXPECT_EQ(write(path("a.exr")), UPS_OK);
  EXPECT_EQ(calls, "sync file;rename;sync folder;");
}

TEST_F(Files, ThreadsThatWriteTheSamePathDoNotMeet) {
  std::vector<std::thread> threads;
  std::vector<int> failures(8, 0);
  for (size_t t = 0; t < failures.size(); ++t)
    threads.emplace_back([&, t] {
      const std::vector<float> grey(12, 1);
      for (int i = 0; i < 25; ++i) {
        if (t % 2 == 0)
          failures[t] += write(path("same"), 8) != UPS_OK;
        else
          failures[t] += ups_ocio_write_png(path("same").c_str(), grey.data(), 2, 2, 1) != UPS_OK;
      }
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(failures, std::vector<int>(8, 0));
  EXPECT_TRUE(is_image(path("same")) || text_of(path("same")).compare(1, 3, "PNG") == 0);
  EXPECT_EQ(file_count(), 1u);
}

}  // namespace
