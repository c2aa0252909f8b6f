// What must not change a result: the number of threads, not by a bit. The unit of length and the place of the scene:
// tests/stability/units_test.cpp.
#include <algorithm>
#include <cstring>

#include "../support/mixed_room.h"
#include "../support/processors.h"

namespace ups::test {
namespace {

class Invariance : public ::testing::TestWithParam<ups_method> {};
INSTANTIATE_TEST_SUITE_P(Methods, Invariance, ::testing::ValuesIn(every_method), name_of_method);

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST_P(Invariance, ThreadsDoNotChangeABit) {
  MixedRoom one(1, 1, {}, true), two(2, 1, {}, true);
  const RenderOptions options{.method = GetParam(), .iterations = 6, .seed = 42, .flux_paths = 65536};
  const Result a = one.scene.render(options), b = two.scene.render(options);
  EXPECT_EQ(a.info().threads, 1);
  EXPECT_EQ(b.info().threads, std::min(2, processors()));
  EXPECT_TRUE(same_bits(a.readings(one.points), b.readings(two.points)));
  EXPECT_TRUE(same_bits(a.readings(one.cells), b.readings(two.cells)));
  EXPECT_TRUE(same_bits(a.image(one.camera).luminance, b.image(two.camera).luminance));
  EXPECT_TRUE(same_bits(a.image(one.camera).standard_error, b.image(two.camera).standard_error));
  EXPECT_EQ(a.info().rays, b.info().rays);
  EXPECT_EQ(a.info().absorbed_flux_lm, b.info().absorbed_flux_lm);
  EXPECT_GT(a.statistics(one.cells).mean_lx, 0);

  const Result repeated = one.scene.render(options),
               other = one.scene.render({.method = GetParam(), .iterations = 6, .seed = 43});
  EXPECT_TRUE(same_bits(a.readings(one.cells), repeated.readings(one.cells))) << "the same seed once more";
  EXPECT_FALSE(same_bits(a.readings(one.cells), other.readings(one.cells))) << "another seed";
}

}  // namespace
}  // namespace ups::test
