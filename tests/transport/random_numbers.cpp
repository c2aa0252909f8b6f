// Are the random numbers what they claim: Philox's known answers, stratified Sobol points, fixed addresses?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "transport/sampler.h"

namespace {

using namespace ups;

// Known-answer vectors of Random123 (Salmon et al. 2011).
TEST(Philox, KnownAnswers) {
  using A4 = std::array<uint32_t, 4>;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (A4{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  const uint32_t f = 0xffffffff;
  EXPECT_EQ(philox({f, f, f, f}, {f, f}), (A4{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (A4{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Sobol, EveryDimensionFillsEveryIntervalOnce) {
  for (int d = 0; d < sobol_dimensions; ++d)
    for (uint32_t n : {16u, 256u, 4096u}) {
      std::vector<int> count(n);
      for (uint32_t i = 0; i < n; ++i) ++count[uint64_t(sobol_owen(i, d, 0x1234567u + uint32_t(d))) * n >> 32];
      for (int c : count) ASSERT_EQ(c, 1) << "dimension " << d << ", " << n << " points";
    }
}

// The point of a digit of an index is the sum of those of its bits.
TEST(Sobol, TablesHoldEveryBitOfAnIndex) {
  using namespace sobol_detail;
  for (int d = 0; d < sobol_dimensions; ++d)
    for (int k = 0; k < 8; ++k)
      for (uint32_t digit = 0; digit < 16; ++digit) {
        uint32_t sum = 0;
        for (uint32_t bit = 1; bit < 16; bit *= 2)
          if (digit & bit) sum ^= table[d][k][bit];
        ASSERT_EQ(table[d][k][digit], sum) << "dimension " << d << ", digit " << k;
      }
}

// The first two dimensions are a (0, 2)-sequence: 2^8 points put one into each cell of any 2^a x 2^b grid, a + b = 8.
TEST(Sobol, FirstTwoDimensionsAreStratifiedTogether) {
  for (int a = 0; a <= 8; ++a) {
    std::vector<int> count(256);
    for (uint32_t i = 0; i < 256; ++i) {
      const uint32_t x = a ? sobol_owen(i, 0, 77) >> (32 - a) : 0,
                     y = a < 8 ? sobol_owen(i, 1, 78) >> (32 - (8 - a)) : 0;
      ++count[x << (8 - a) | y];
    }
    for (int c : count) ASSERT_EQ(c, 1) << "grid 2^" << a << " x 2^" << 8 - a;
  }
}

TEST(PathSampler, NumbersDependOnTheirAddressAlone) {
  PathSampler a(1, {Stream::camera, 2}, 3, 4, 5, 6), b(1, {Stream::camera, 2}, 3, 4, 5, 6);
  std::vector<float> first;
  for (uint32_t v = 0; v < 12; ++v)
    for (int s = 0; s < int(Slot::count); ++s) first.push_back(a.get(v, Slot(s)));
  size_t i = first.size();
  for (uint32_t v = 12; v-- > 0;)
    for (int s = int(Slot::count); s-- > 0;) EXPECT_EQ(b.get(v, Slot(s)), first[--i]);
}

TEST(PathSampler, AddressesDoNotCollide) {
  PathSampler a(1, {Stream::camera, 2}, 3, 4, 5, 6);
  std::vector<float> all;
  for (uint32_t v = 0; v < 64; ++v)
    for (int s = 0; s < int(Slot::count); ++s) all.push_back(a.get(v, Slot(s)));
  std::sort(all.begin(), all.end());
  int equal = 0;
  for (size_t i = 1; i < all.size(); ++i) equal += all[i] == all[i - 1];
  EXPECT_LE(equal, 1);  // 576 numbers of 24 bits: 0.01 expected pairs
}

// One number decides all games of a path: of 2^12 paths with the same chances as many go on each time as should, within
// one for the stratum that is cut.
TEST(PathSampler, LengthsOfPathsAreStratified) {
  constexpr uint32_t paths = 1 << 12;
  for (const float q : {0.05f, 0.5f, 0.9f, 0.98f}) {
    std::vector<uint32_t> alive(64);
    for (uint32_t path = 0; path < paths; ++path) {
      PathSampler rng(7, Stream::light, 3, path, 5, path);
      double u = rng.roulette();
      ASSERT_TRUE(u >= 0 && u < 1);
      for (uint32_t k = 0; k < alive.size() && u < q; ++k) u /= q, ++alive[k];
    }
    for (uint32_t k = 0; k < alive.size(); ++k)
      EXPECT_NEAR(alive[k], paths * std::pow(double(q), k + 1), 1.01) << q << " " << k;
  }
}

TEST(PathSampler, FineNumbersHaveMoreBits) {
  PathSampler rng(1, {Stream::camera, 2}, 3, 4, 5, 6);
  int finer = 0;
  for (uint32_t v = 0; v < 64; ++v)
    for (int s = 0; s < int(Slot::count); ++s) {
      const double fine = rng.get_fine(v, Slot(s)), coarse = double(rng.get(v, Slot(s)));
      ASSERT_TRUE(fine >= coarse && fine < coarse + 0x1p-24);
      finer += fine > coarse;
    }
  EXPECT_GT(finer, 700);  // of 768: by chance all but 3
}

// As in a render of a day: points of a sequence would come again, with the rest of the path another.
TEST(PathSampler, AnotherSequenceBeginsAfterTheLastPoint) {
  const auto numbers = [](uint64_t index) {
    PathSampler rng(1, Stream::light, 3, index, 5, 6);
    std::vector<float> out;
    for (uint32_t v = 0; v < 3; ++v)
      for (const Slot s : {Slot::choice, Slot::direction_x, Slot::direction_y}) out.push_back(rng.get(v, s));
    return out;
  };
  for (const uint64_t index : {0ull, 77ull, 0xffffffffull})
    for (const uint64_t later : {1ull, 2ull}) {
      const auto first = numbers(index), again = numbers(index + (later << 32));
      for (size_t i = 0; i < first.size(); ++i) EXPECT_NE(first[i], again[i]) << index << " " << i;
    }
}

// Seeds as people and programs choose them: small ones, powers of two, steps of the constant that hashes are made of.
std::vector<uint64_t> related_seeds() {
  std::vector<uint64_t> seeds;
  for (uint64_t i = 0; i < 64; ++i) seeds.insert(seeds.end(), {i, ~i, i * 0x9e3779b97f4a7c15ull, 1ull << i});
  std::sort(seeds.begin(), seeds.end());
  seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
  return seeds;
}
std::vector<Stream> streams() {
  std::vector<Stream> all;
  for (uint32_t kind = 0; kind < Stream::kinds; ++kind)
    for (const uint32_t index : {0u, 1u, 2u, 3u, 7u, 8u, 255u, 65535u, 65536u})
      all.push_back({Stream::Kind(kind), index});
  return all;
}

// 15000 pairs of 64 bits each: equal ones by chance 6e-12.
TEST(Stream, NoTwoOfAnySeedsShareNumbers) {
  std::vector<uint64_t> numbers, scrambles;
  for (const uint64_t seed : related_seeds())
    for (const Stream& s : streams()) {
      const auto n = s.numbers(seed, 0, 0, 0);
      numbers.push_back(uint64_t(n[0]) << 32 | n[1]);
      scrambles.push_back(s.scramble(seed, 0));
    }
  for (auto* all : {&numbers, &scrambles}) {
    EXPECT_GT(all->size(), 15000u);
    std::sort(all->begin(), all->end());
    EXPECT_EQ(std::adjacent_find(all->begin(), all->end()), all->end());
  }
}

// 2016 pairs of (seed, stream), each by 65,536 paths' numbers beyond the stratified ones: the correlation of
// independent numbers has a standard deviation of 1/256; 5.5 of them are passed by chance with probability
// 2016 * 3.8e-8 = 8e-5. A correlation of 3 % in one pair is found in 98 of 100 cases.
TEST(Stream, NumbersOfRelatedSeedsAndStreamsAreUncorrelated) {
  constexpr uint32_t paths = 65536;
  std::vector<std::vector<double>> rows;
  for (uint64_t seed = 0; seed < 8; ++seed)
    for (uint32_t i = 0; i < 8; ++i) {
      std::vector<double>& row = rows.emplace_back();
      for (uint32_t path = 0; path < paths; ++path) {
        PathSampler rng(seed, {i % 2 ? Stream::camera : Stream::light, i / 2}, path, 0, 0, path);
        row.push_back((double(rng.get(4, Slot::direction_x)) - 0.5) * std::sqrt(12.0));
      }
    }
  double largest = 0;
  for (size_t a = 0; a < rows.size(); ++a)
    for (size_t b = 0; b < a; ++b) {
      double r = 0;
      for (uint32_t path = 0; path < paths; ++path) r += rows[a][path] * rows[b][path] / paths;
      largest = std::max(largest, std::abs(r));
    }
  EXPECT_LT(largest, 5.5 / std::sqrt(double(paths)));
}

}  // namespace
