// Names of files in UTF-8: beyond the code pages, in parts and joined, found in folders.
#include "platform/paths.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "platform/files.h"
#include "scratch_folder.h"

namespace ups::platform {
namespace {

// Latin, Greek, Chinese, and a character beyond the first plane.
const std::string strange = "Büro Φ 照明 💡";

TEST(Paths, PartsOfAName) {
  const std::string path = "a/" + strange + ".tar.ies";
  EXPECT_EQ(folder_of(path), "a");
  EXPECT_EQ(file_name_of(path), strange + ".tar.ies");
  EXPECT_EQ(stem_of(path), strange + ".tar");
  EXPECT_EQ(extension_of(path), ".ies");
  EXPECT_EQ(folder_of("bare"), "");
  EXPECT_EQ(extension_of("folder.d/bare"), "");
}

TEST(Paths, JoinedAndApart) {
  EXPECT_EQ(file_name_of(joined(strange, "b")), "b");
  EXPECT_EQ(folder_of(joined(strange, "b")), strange);
  EXPECT_EQ(joined("", strange), strange);
  const ScratchFolder scratch;
  EXPECT_EQ(joined("elsewhere", scratch.path("b")), scratch.path("b"));  // an absolute name
  EXPECT_EQ(simplified("a/../" + strange), strange);
  EXPECT_EQ(relative_to("a", "a/" + strange), strange);
}

TEST(Paths, FoldersAreMadeAndListed) {
  const ScratchFolder scratch;
  const std::string folder = joined(scratch.path(strange), strange);
  EXPECT_FALSE(is_folder(folder));
  EXPECT_FALSE(make_folder(folder));
  EXPECT_TRUE(is_folder(folder));
  EXPECT_FALSE(make_folder(folder)) << "it was there";
  replace_file(joined(folder, strange + ".ies"), "x", 1);
  EXPECT_TRUE(make_folder(joined(folder, strange + ".ies"))) << "a file is in the way";
  std::error_code error;
  const auto entries = entries_of(folder, error);
  EXPECT_FALSE(error);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].name, strange + ".ies");
  EXPECT_EQ(entries[0].path, joined(folder, strange + ".ies"));
  EXPECT_TRUE(entries[0].is_file && !entries[0].is_folder && !entries[0].is_link);
  EXPECT_TRUE(is_regular_file(entries[0].path));
  EXPECT_FALSE(is_regular_file(folder));
  EXPECT_TRUE(entries_of(scratch.path("none"), error).empty());
  EXPECT_TRUE(error);
}

TEST(Paths, FoundInAnyCase) {
  const ScratchFolder scratch;
  replace_file(scratch.path(strange + ".TLT"), "x", 1);
  EXPECT_EQ(find_in_any_case(scratch.path(""), "C:\\tilt\\" + strange + ".tlt"), scratch.path(strange + ".TLT"));
  EXPECT_EQ(find_in_any_case(scratch.path(""), "other.tlt"), "");
  EXPECT_EQ(find_in_any_case(scratch.path(""), "folder/"), "");
}

TEST(Paths, WithinAFolder) {
  const ScratchFolder scratch;
  EXPECT_FALSE(make_folder(scratch.path(strange)));
  EXPECT_TRUE(lies_within(scratch.path(strange + "/a"), scratch.path(strange)));
  EXPECT_FALSE(lies_within(scratch.path(strange + "/../a"), scratch.path(strange)));
  EXPECT_FALSE(lies_within(scratch.path(strange + "b"), scratch.path(strange)));
  EXPECT_TRUE(lies_within("none.ies", "")) << "not there, in the working folder";
  EXPECT_TRUE(lies_within("none/none.ies", ""));
  EXPECT_FALSE(lies_within("../none.ies", ""));
}

TEST(Paths, OneNameOfAFile) {
  const ScratchFolder scratch;
  EXPECT_FALSE(make_folder(scratch.path(strange)));
  const std::string file = scratch.path(strange + "/a");
  replace_file(file, "x", 1);
  EXPECT_NE(resolved(file), "");
  EXPECT_EQ(resolved(scratch.path(strange + "/../" + strange + "/./a")), resolved(file));
  EXPECT_EQ(resolved(scratch.path(strange + "/b")), "") << "not there";
  EXPECT_EQ(resolved(""), "");
}

}  // namespace
}  // namespace ups::platform
