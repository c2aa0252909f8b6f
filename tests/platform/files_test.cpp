// Files of names in UTF-8, written whole or not at all. What links, pipes and permissions of POSIX call for is in
// tests/tool/test_files.cpp, seen through the writers of images.
#include "platform/files.h"

#include <gtest/gtest.h>

#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

#include <iterator>

#include "scratch_folder.h"

namespace ups::platform {
namespace {

const std::string strange = "Büro Φ 照明 💡.exr";

std::string text_of(const std::string& path) {
  auto in = open_to_read(path);
  EXPECT_TRUE(in.is_open()) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

size_t count_in(const std::string& folder) {
  std::error_code error;
  return entries_of(folder, error).size();
}

TEST(Files, WrittenReadAndReplaced) {
  const ScratchFolder scratch;
  const std::string path = scratch.path(strange), bytes("a\r\nb\n\0c\x1a", 8);
  EXPECT_FALSE(open_to_read(path).is_open());
  replace_file(path, bytes.data(), bytes.size());
  EXPECT_EQ(text_of(path), bytes);
  replace_file(path, "new", 3);
  EXPECT_EQ(text_of(path), "new");
  EXPECT_EQ(count_in(scratch.path("")), 1u) << "a temporary file is left";
}

TEST(Files, WhatMayNotEndIsNotOpened) {
  const ScratchFolder scratch;
  EXPECT_FALSE(open_to_read(scratch.path(strange)));
  EXPECT_EQ(why_not_open(scratch.path(strange)), "there is no such file");
  EXPECT_FALSE(open_to_read(scratch.path("")));
  EXPECT_EQ(why_not_open(scratch.path("")), "it is a folder, not a file");
#ifndef _WIN32
  const std::string pipe = scratch.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, std::string("/dev/zero")}) {
    EXPECT_FALSE(open_to_read(path));
    EXPECT_EQ(why_not_open(path), "it is a device or a pipe, not a file");
  }
#endif
}

#ifndef _WIN32  // where a file that is open cannot be replaced
// As a shell's <(command) and /dev/stdin are.
TEST(Files, APipeThatIsOpenIsRead) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "through", 7), 7);
  ::close(ends[1]);
  EXPECT_EQ(text_of("/dev/fd/" + std::to_string(ends[0])), "through");
  ::close(ends[0]);
}

// A reader that opened the file before sees the old bytes to their end.
TEST(Files, AReaderKeepsWhatItOpened) {
  const ScratchFolder scratch;
  const std::string path = scratch.path(strange), old(1 << 16, 'o');
  replace_file(path, old.data(), old.size());
  auto in = open_to_read(path);
  char first = 0;
  in.get(first);
  replace_file(path, "new", 3);
  EXPECT_EQ(first + std::string(std::istreambuf_iterator<char>(in), {}), old);
}
#endif

TEST(Files, WhatCannotBeWrittenLeavesNothing) {
  const ScratchFolder scratch;
  const std::string folder = scratch.path("folder"), none = joined(scratch.path("none"), strange);
  ASSERT_FALSE(make_folder(folder));
  for (const std::string& path : {folder, none}) {
    try {
      replace_file(path, "x", 1);
      ADD_FAILURE() << path << " was written";
    } catch (const std::system_error& e) {
      EXPECT_EQ(std::string(e.what()).find("cannot write '" + path + "': "), 0u) << e.what();
    }
  }
  EXPECT_EQ(count_in(scratch.path("")), 1u) << "a temporary file is left";
  EXPECT_EQ(count_in(folder), 0u);
}

TEST(Files, FoldersAreTried) {
  const ScratchFolder scratch;
  EXPECT_FALSE(try_folder(scratch.path("")));
  EXPECT_EQ(count_in(scratch.path("")), 0u);
  const std::error_code error = try_folder(scratch.path("none"));
  EXPECT_TRUE(error);
  EXPECT_EQ(message_of(error), "No such file or directory");
}

TEST(Files, WhereAFileIsWritten) {
  const ScratchFolder scratch;
  EXPECT_EQ(folder_written_in(scratch.path(strange)), folder_of(scratch.path(strange)));
  EXPECT_EQ(folder_written_in("bare.exr"), ".");
#ifdef _WIN32
  const char* const nowhere = "NUL";
#else
  const char* const nowhere = "/dev/null";
#endif
  EXPECT_FALSE(folder_written_in(nowhere));
  replace_file(nowhere, "x", 1);
  EXPECT_FALSE(folder_written_in(nowhere)) << "the device was replaced by a file";
}

}  // namespace
}  // namespace ups::platform
