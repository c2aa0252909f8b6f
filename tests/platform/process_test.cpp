// The process: its memory, its file, its words.
#include "platform/process.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "platform/memory.h"
#include "platform/numbers.h"
#include "platform/paths.h"

namespace ups::platform {
namespace {

TEST(Process, MemoryGrowsByWhatIsTaken) {
  constexpr size_t mb = 1 << 20, taken = 64 * mb;
  EXPECT_GT(available_memory().bytes, mb);
  EXPECT_FALSE(available_memory().limit.empty());
  const uint64_t before = resident_bytes();
  EXPECT_GT(before, mb / 2);
  std::vector<char> bytes(taken);
  std::memset(bytes.data(), 1, taken);
  const uint64_t within = resident_bytes();
  EXPECT_GT(within, before + taken * 9 / 10);
#ifndef __SANITIZE_THREAD__  // its shadow is three times as large
  EXPECT_LT(within, before + taken * 2);
#endif
  EXPECT_EQ(bytes[taken / 2], 1);
  bytes = {};
  EXPECT_GE(peak_resident_bytes(), within * 9 / 10);
}

TEST(Process, ItsFile) {
  EXPECT_TRUE(is_regular_file(program_file())) << program_file();
  EXPECT_EQ(stem_of(program_file()), "platform_tests");
}

#ifdef _WIN32
// Not those of argv, which are in the code page. wine.sh gives the last.
TEST(Process, ItsWords) {
  const std::vector<std::string> words = program_arguments(0, nullptr);
  ASSERT_FALSE(words.empty());
  EXPECT_EQ(words.back(), "Büro Φ 照明 💡");
}
#else
TEST(Process, ItsWords) {
  char name[] = "program", first[] = "Büro 照明", second[] = "";
  char* argv[] = {name, first, second, nullptr};
  EXPECT_EQ(program_arguments(3, argv), (std::vector<std::string>{"Büro 照明", ""}));
  EXPECT_TRUE(program_arguments(0, argv + 3).empty());
}
#endif

TEST(Numbers, LogGamma) {
  EXPECT_NEAR(log_gamma(5), 3.1780538303479458, 1e-14);     // log 24
  EXPECT_NEAR(log_gamma(0.5), 0.57236494292470009, 1e-15);  // log sqrt(pi)
}

}  // namespace
}  // namespace ups::platform
