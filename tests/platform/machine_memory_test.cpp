// Memory that is left, read from files like the system's: control groups of both versions, nested, seen from within a
// container or not at all.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "platform/linux/machine_memory.h"

namespace ups::platform {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t mb = 1 << 20;

class MachineMemory : public testing::Test {
 protected:
  MachineMemory() : root_(fs::temp_directory_path() / ("ups-machine-" + std::to_string(getpid()))) {
    fs::remove_all(root_);
    write("proc/meminfo", "MemTotal:       8388608 kB\nMemFree:  1 kB\nMemAvailable:    4194304 kB\nSwapFree: 0 kB\n");
  }
  ~MachineMemory() override { fs::remove_all(root_); }
  void write(const fs::path& file, const std::string& text) {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  void write_group(const fs::path& folder, const std::string& limit, uint64_t used, uint64_t files) {
    write(folder / "memory.max", limit + "\n");
    write(folder / "memory.current", std::to_string(used) + "\n");
    write(folder / "memory.stat", "anon 5\nfile 7\ninactive_file " + std::to_string(files) + "\nactive_file 0\n");
  }
  AvailableMemory available() const { return available_memory_below(root_.string()); }

 private:
  fs::path root_;
};

TEST_F(MachineMemory, OfTheMachine) {
  EXPECT_EQ(available().bytes, 4096 * mb);
  EXPECT_EQ(available().limit, "what the machine has free");
  write("proc/meminfo", "MemAvailable:    4194304 kB\nSwapFree: 1048576 kB\n");
  EXPECT_EQ(available().bytes, 5120 * mb);
  write("proc/meminfo", "MemAvailable: 0 kB\nSwapFree: 1048576 kB\n");  // next to none, not unknown
  EXPECT_EQ(available().bytes, 1024 * mb);
  write("proc/meminfo", "MemAvailable: 0 kB\n");
  EXPECT_EQ(available().bytes, 0);
}

TEST_F(MachineMemory, NothingCanBeRead) {
  write("proc/meminfo", "");
  EXPECT_EQ(available().bytes, UINT64_MAX);
}

TEST_F(MachineMemory, GroupOfVersion2AndThoseThatItLiesIn) {
  write("proc/self/cgroup", "0::/user/job\n");
  write("proc/self/mountinfo",
        "23 1 8:1 / / rw - ext4 /dev/sda rw\n31 23 0:28 / /sys/fs/cgroup rw,relatime shared:4 - cgroup2 cgroup2 rw\n");
  write_group("sys/fs/cgroup/user/job", "max", 300 * mb, 0);
  EXPECT_EQ(available().bytes, 4096 * mb);
  write_group("sys/fs/cgroup/user/job", std::to_string(1000 * mb), 300 * mb, 0);
  EXPECT_EQ(available().bytes, 700 * mb);
  EXPECT_EQ(available().limit, "the control group's limit, /sys/fs/cgroup/user/job/memory.max,");
  write_group("sys/fs/cgroup/user", std::to_string(1200 * mb), 900 * mb, 100 * mb);  // cached files do not count
  EXPECT_EQ(available().bytes, 400 * mb);
  EXPECT_EQ(available().limit, "the control group's limit, /sys/fs/cgroup/user/memory.max,");
  write_group("sys/fs/cgroup/user", std::to_string(1200 * mb), 1300 * mb, 0);
  EXPECT_EQ(available().bytes, 0u);
}

// Above memory.high a group is slowed down.
TEST_F(MachineMemory, SlowGroupsOfVersion2) {
  write("proc/self/cgroup", "0::/user/job\n");
  write("proc/self/mountinfo", "31 23 0:28 / /sys/fs/cgroup rw - cgroup2 cgroup2 rw\n");
  write_group("sys/fs/cgroup/user/job", std::to_string(1000 * mb), 300 * mb, 100 * mb);
  write("sys/fs/cgroup/user/job/memory.high", "max\n");
  EXPECT_EQ(available().bytes, 800 * mb);
  write("sys/fs/cgroup/user/job/memory.high", std::to_string(900 * mb) + "\n");
  EXPECT_EQ(available().bytes, 700 * mb);
  EXPECT_EQ(available().limit, "the control group's limit, /sys/fs/cgroup/user/job/memory.high,");
  write_group("sys/fs/cgroup/user", "max", 500 * mb, 0);
  write("sys/fs/cgroup/user/memory.high", std::to_string(600 * mb) + "\n");
  EXPECT_EQ(available().bytes, 100 * mb);
  write("sys/fs/cgroup/user/memory.high", std::to_string(2000 * mb) + "\n");
  write("sys/fs/cgroup/user/job/memory.high", std::to_string(1100 * mb) + "\n");
  EXPECT_EQ(available().bytes, 800 * mb) << "the limit is the less";
}

TEST_F(MachineMemory, SwapThatGroupsAllow) {
  write("proc/meminfo", "MemAvailable:    4194304 kB\nSwapFree: 1048576 kB\n");
  write("proc/self/cgroup", "0::/user/job\n");
  write("proc/self/mountinfo", "31 23 0:28 / /sys/fs/cgroup rw - cgroup2 cgroup2 rw\n");
  write("sys/fs/cgroup/user/job/memory.swap.max", "max\n");
  write("sys/fs/cgroup/user/job/memory.swap.current", "0\n");
  EXPECT_EQ(available().bytes, 5120 * mb);
  write("sys/fs/cgroup/user/job/memory.swap.max", std::to_string(900 * mb) + "\n");
  write("sys/fs/cgroup/user/job/memory.swap.current", std::to_string(200 * mb) + "\n");
  EXPECT_EQ(available().bytes, 4796 * mb);
  EXPECT_EQ(available().limit, "what the machine has free");
  write("sys/fs/cgroup/user/memory.swap.max", std::to_string(500 * mb) + "\n");
  write("sys/fs/cgroup/user/memory.swap.current", std::to_string(300 * mb) + "\n");
  EXPECT_EQ(available().bytes, 4296 * mb);
  write("sys/fs/cgroup/user/memory.swap.max", "0\n");
  EXPECT_EQ(available().bytes, 4096 * mb);
  write("sys/fs/cgroup/user/memory.swap.max", std::to_string(5000 * mb) + "\n");
  write("sys/fs/cgroup/user/job/memory.swap.max", "max\n");
  EXPECT_EQ(available().bytes, 5120 * mb) << "there is no more than the machine has";
}

TEST_F(MachineMemory, GroupOfVersion1) {
  write("proc/self/cgroup", "5:cpu,cpuacct:/other\n4:memory:/job\n0::/\n");
  write("proc/self/mountinfo",
        "34 31 0:31 / /sys/fs/cgroup/cpu rw - cgroup cgroup rw,cpu,cpuacct\n"
        "35 31 0:32 / /sys/fs/cgroup/memory rw,relatime - cgroup cgroup rw,memory\n"
        "41 31 0:38 / /sys/fs/cgroup/unified rw,relatime - cgroup2 cgroup2 rw\n");
  const fs::path folder = "sys/fs/cgroup/memory/job";
  write(folder / "memory.limit_in_bytes", std::to_string(800 * mb));
  write(folder / "memory.usage_in_bytes", std::to_string(500 * mb));
  write(folder / "memory.stat", "inactive_file 1\ntotal_inactive_file " + std::to_string(150 * mb) +
                                    "\ntotal_active_file " + std::to_string(50 * mb) + "\n");
  EXPECT_EQ(available().bytes, 500 * mb);
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712");  // none
  EXPECT_EQ(available().bytes, 500 * mb);
}

// The mount shows the container's own group as its root; the process's path is the host's, or is hidden.
TEST_F(MachineMemory, WithinAContainer) {
  write("proc/self/mountinfo", "35 31 0:32 /docker/abc /sys/fs/cgroup ro - cgroup2 cgroup rw\n");
  write_group("sys/fs/cgroup", std::to_string(600 * mb), 100 * mb, 0);
  for (const char* group : {"0::/docker/abc\n", "0::/\n", "0::/docker/abc/../other\n"}) {
    write("proc/self/cgroup", group);
    EXPECT_EQ(available().bytes, 500 * mb) << group;
  }
  write("proc/self/cgroup", "0::/docker/abc/below\n");
  write_group("sys/fs/cgroup/below", std::to_string(50 * mb), 10 * mb, 0);
  EXPECT_EQ(available().bytes, 40 * mb);
}

}  // namespace
}  // namespace ups::platform
