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
    }
  }
  void pool() {
    const std::vector<NeighbourCurvature> neighbours = neighbour_curvatures(photons);
    for (size_t m = 0; m < meters; ++m) pool_bias(photons[m], neighbours[m]);
  }
  double mean_square_error() const {
    double sum = 0;
    for (size_t m = 0; m < meters; ++m) sum += std::pow(photons[m].bias - truth[m], 2) / meters;
    return sum;
  }
  double mean_variance() const {
    double sum = 0;
    for (const MeterRings::Photons& p : photons) sum += p.bias_error * p.bias_error / meters;
    return sum;
  }
};

// 33 neighbours leave 1/33 of the variance and what they scatter by chance; the 5 % that are beyond doubt by themselves
// keep their own, of more than 2 standard errors: 0.26 of the variance in all.
TEST(PooledBias, NeighboursTellWhereLightCurvesAlike) {
  Row row(0.3, 0);
  row.pool();
  EXPECT_LT(row.mean_square_error(), 0.5);
  size_t told = 0;
  for (const MeterRings::Photons& p : row.photons) told += p.bias_error < 0.6;
  EXPECT_GT(told, meters * 8 / 10);
}

// Where each meter's light curves otherwise, what is stated is what is made: a chi-square ratio of 400 has a standard
// deviation of 7 %.
TEST(PooledBias, MetersKeepTheirOwnWhereTheyDiffer) {
  for (const double deviation : {0.5, 1.0, 3.0}) {
    Row row(0, deviation);
    row.pool();
    EXPECT_NEAR(row.mean_square_error() / row.mean_variance(), 1, 0.3) << deviation;
    EXPECT_LT(row.mean_square_error(), 1.05);
  }
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
