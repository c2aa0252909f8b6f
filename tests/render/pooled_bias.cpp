// What neighbours say of a disc's bias: less noise where light curves alike, nothing where it does not. Fixed seeds.
#include "render/pooled_bias.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace ups;

constexpr size_t meters = 400;
constexpr double r2 = 0.04;

// Biases c r2 with c from a normal distribution, each known with a standard error of 1 lx.
struct Row {
  std::vector<double> truth;
  std::vector<MeterRings::Photons> photons{meters};
  Row(double mean, double deviation) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (MeterRings::Photons& p : photons) {
      truth.push_back(mean + deviation * normal(random));
      p.bias = truth.back() + normal(random);
      p.bias_error = 1;
      p.mean_radius2 = r2;
      p.lx = 100;
    }
  }
  // Mean square error over mean variance of those that are not beyond doubt by themselves.
  double pool() {
    const std::vector<NeighbourCurvature> neighbours = neighbour_curvatures(photons);
    double square = 0, variance = 0;
    for (size_t m = 0; m < meters; ++m) {
      MeterRings::Photons& p = photons[m];
      if (p.has_bias()) continue;
      pool_bias(p, neighbours[m]);
      square += std::pow(p.bias - truth[m], 2), variance += p.bias_error * p.bias_error;
    }
    return square / variance;
  }
};

// 33 neighbours leave little of the variance; that they differ by a fifth of it is not excluded.
TEST(PooledBias, NeighboursTellWhereLightCurvesAlike) {
  Row row(0.3, 0);
  EXPECT_LT(row.pool(), 1);
  size_t told = 0;
  for (const MeterRings::Photons& p : row.photons) told += p.bias_error < 0.6;
  EXPECT_GT(told, meters * 7 / 10);
}

// Where each meter's light curves otherwise, an error is at most what is stated: a chi-square ratio of 380 has a standard
// deviation of 7 %, and three of them pass 1.25 in 1 of 1,000.
TEST(PooledBias, MetersKeepTheirOwnWhereTheyDiffer) {
  for (const double deviation : {0.5, 1.0, 3.0}) EXPECT_LT(Row(0, deviation).pool(), 1.25) << deviation;
}

TEST(PooledBias, ANarrowDiscIsNotToldByWideOnes) {
  Row row(0, 0);
  row.photons[200].mean_radius2 = r2 / 4;
  const double own = row.photons[200].bias;
  row.pool();
  EXPECT_EQ(row.photons[200].bias, own);
  EXPECT_EQ(row.photons[200].bias_error, 1);
}

TEST(PooledBias, WhatIsBeyondDoubtStays) {
  Row row(0, 0);
  row.photons[200].bias = 4;
  row.pool();
  EXPECT_EQ(row.photons[200].bias, 4);
}

TEST(PooledBias, FewMetersAreAlone) {
  Row row(0, 0);
  row.photons.resize(4);
  for (const NeighbourCurvature& n : neighbour_curvatures(row.photons)) EXPECT_FALSE(std::isfinite(n.between));
}

}  // namespace
