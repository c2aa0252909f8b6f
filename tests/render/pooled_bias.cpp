// What neighbours say of a disc's bias: less noise where light curves alike, nothing where it does not. Fixed seeds.
#include "render/pooled_bias.h"

#include "render/meter_sums.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace ups;

constexpr size_t meters = 400;
constexpr double r2 = 0.04;

// Biases c r2 with c from a normal distribution, each known with a standard error of 1 lx.
struct Row {
  std::vector<double> truth;
  std::vector<OwnBias> own;
  std::vector<Spread> pooled;
  Row(double mean, double deviation) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (size_t m = 0; m < meters; ++m) {
      truth.push_back(mean + deviation * normal(random));
      own.push_back({{truth.back() + normal(random), 1}, 100, r2});
    }
  }
  // Mean square error over mean variance of those that are not beyond doubt by themselves.
  double pool() {
    const std::vector<NeighbourCurvature> neighbours = neighbour_curvatures(own);
    double square = 0, variance = 0;
    for (size_t m = 0; m < own.size(); ++m) {
      const Spread& b = pooled.emplace_back(pooled_bias(own[m], neighbours[m], meters));
      if (own[m].is_beyond_doubt(meters)) continue;
      square += std::pow(b.mean - truth[m], 2), variance += b.standard_error * b.standard_error;
    }
    return square / variance;
  }
};

// 33 neighbours leave little of the variance; that they differ by a fifth of it is not excluded.
TEST(PooledBias, NeighboursTellWhereLightCurvesAlike) {
  Row row(0.3, 0);
  EXPECT_LT(row.pool(), 1);
  size_t told = 0;
  for (const Spread& b : row.pooled) told += b.standard_error < 0.6;
  EXPECT_GT(told, meters * 7 / 10);
}

// Where each meter's light curves otherwise, an error is at most what is stated: a chi-square ratio of 380 has a
// standard deviation of 7 %, and three of them pass 1.25 in 1 of 1,000.
TEST(PooledBias, MetersKeepTheirOwnWhereTheyDiffer) {
  for (const double deviation : {0.5, 1.0, 3.0}) EXPECT_LT(Row(0, deviation).pool(), 1.25) << deviation;
}

// Few photons may cancel to rounding: such a meter seems to know its bias to 1e-17 of its light. It tells the others
// nothing, and one that knows a million times better than they outweighs them without leaving nothing but rounding.
TEST(PooledBias, AMeterThatSeemsToKnowAllButExactlyUpsetsNoOther) {
  for (double error = 1e-3; error > 1e-20; error *= 0.37) {
    Row row(0.3, 0);
    row.own[200].bias.standard_error = error;
    row.own[200].bias.mean = row.truth[200];
    row.pool();
    for (size_t m = 184; m <= 216; ++m) {
      const Spread& b = row.pooled[m];
      ASSERT_TRUE(std::isfinite(b.mean) && std::isfinite(b.standard_error)) << error << ' ' << m;
      EXPECT_LT(std::abs(b.mean - row.truth[m]), 4) << error << ' ' << m;
    }
  }
}

TEST(PooledBias, ANarrowDiscIsNotToldByWideOnes) {
  Row row(0, 0);
  row.own[200].bias_scale = r2 / 4;
  row.pool();
  EXPECT_EQ(row.pooled[200].mean, row.own[200].bias.mean);
  EXPECT_EQ(row.pooled[200].standard_error, 1);
}

// A corner's is whole as theirs are.
TEST(PooledBias, ADiscThatWallsLeaveNarrowIsToldByWideOnes) {
  for (const bool chosen : {false, true}) {
    Row row(0, 0);
    for (OwnBias& own : row.own) own.widest_scale = r2;
    row.own[200].bias_scale = r2 / 4;
    if (!chosen) row.own[200].widest_scale = r2 / 4;
    row.pool();
    EXPECT_EQ(row.pooled[200].standard_error < 0.2, !chosen);
  }
}

// Of a set of 400 meters chance alone makes some of 4 standard errors, of 25 hardly any.
TEST(PooledBias, WhatIsBeyondDoubtStays) {
  for (const double bias : {4.0, 6.0}) {
    Row row(0, 0);
    row.own[200].bias.mean = bias;
    row.pool();
    EXPECT_EQ(row.pooled[200].mean == bias, bias > 5);
    EXPECT_TRUE(row.own[200].is_beyond_doubt(25));
  }
}

// 2,000 lx beside 2 lx, each biased by 1 %: the bias is told relative to the light.
TEST(PooledBias, BrightAndDarkMetersTellEachOther) {
  Row row(0, 0);
  for (size_t m = 0; m < meters; ++m) {
    OwnBias& own = row.own[m];
    own.lx = m % 2 ? 2000 : 2;
    own.bias = {0.01 * own.lx, 0.02 * own.lx};
  }
  row.pool();
  for (size_t m = 0; m < meters; ++m) {
    EXPECT_NEAR(row.pooled[m].mean, 0.01 * row.own[m].lx, 1e-9);
    EXPECT_LT(row.pooled[m].standard_error, 0.01 * row.own[m].lx);
  }
}

TEST(PooledBias, FewMetersAreAlone) {
  Row row(0, 0);
  row.own.resize(4);
  for (const NeighbourCurvature& n : neighbour_curvatures(row.own)) EXPECT_FALSE(n.tell());
}

// A shadow beside bright light straight from a lamp that no photon brings: curvature is told as a share of what photons
// bring, which is alike. By all light the lit meters' seemed a twentieth of it, and the shadow's bias went with it.
TEST(PooledBias, OnlyLightThatMayBeMergedIsBlurred) {
  MeterLight light{};
  light.visits = batch_count;
  for (uint32_t b = 0; b < batch_count; ++b) light.sums.value[b] = 1000, light.sums.direct[b] = 940;
  EXPECT_DOUBLE_EQ(light.own_bias().lx, 60);
  light.sums.exact_mirrored = 10 * batch_count;
  EXPECT_DOUBLE_EQ(light.own_bias().lx, 50);
  light.merges_direct = true, light.sums.exact = 100 * batch_count;
  EXPECT_DOUBLE_EQ(light.own_bias().lx, 900);
  light.visits = 0;
  EXPECT_EQ(light.own_bias().lx, 0);
}

}  // namespace
