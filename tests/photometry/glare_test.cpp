// Position indices against Levin's closed form, cell by cell, and UGR by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "photometry/position_index.h"
#include "photometry/ugr.h"

namespace photometry {
namespace {

double table(double t, double h) { return position_index(PositionIndex::table, t, h, 1); }
double guth(double t, double h) { return position_index(PositionIndex::guth, t, h, 1); }

// A cell that was mistyped by 4 % stands out of its neighbours: the ratio to the closed form changes slowly, by less
// than 3 % between a cell and the mean of those beside it.
TEST(PositionIndex, TableFollowsTheClosedFormCellByCell) {
  const auto ratio = [](int i, int j) { return position_index_cell(i, j) / guth(i / 10.0, j / 10.0); };
  double sum = 0;
  int count = 0;
  for (int i = 0; i <= 30; ++i) {
    for (int j = 0; j <= 19; ++j) {
      if (position_index_cell(i, j) < 0) {
        EXPECT_TRUE(j >= 18 && i <= 8) << i << " " << j;
        continue;
      }
      if (position_index_cell(i, j) > 15.9) continue;  // capped in the closed form
      EXPECT_NEAR(ratio(i, j), 1, 0.1) << i << " " << j;
      sum += std::abs(ratio(i, j) - 1);
      ++count;
      double beside = 0;
      int n = 0;
      for (const auto& [a, b] : {std::pair(i - 1, j), {i + 1, j}, {i, j - 1}, {i, j + 1}})
        if (a >= 0 && a <= 30 && b >= 0 && b <= 19 && position_index_cell(a, b) > 0 && position_index_cell(a, b) < 15.9)
          beside += ratio(a, b), ++n;
      EXPECT_NEAR(ratio(i, j) / (beside / n), 1, 0.03) << i << " " << j;
    }
  }
  EXPECT_NEAR(sum / count, 0.045, 0.005);
}

TEST(PositionIndex, InterpolatesBetweenCells) {
  EXPECT_EQ(table(0, 0), 1);
  EXPECT_NEAR(table(1, 1), 7, 1e-12);
  EXPECT_NEAR(table(-1, 1), 7, 1e-12);
  EXPECT_NEAR(table(0.55, 0.55), (2.91 + 3.10 + 3.40 + 3.60) / 4, 1e-12);
  EXPECT_NEAR(position_index(PositionIndex::table, 2, 1, 2), table(1, 0.5), 1e-12);
  EXPECT_NEAR(table(3, 1.9), 16, 1e-9);
  EXPECT_NEAR(table(0, 1.7), 16.2, 1e-9);  // the last cell of its row that is there
}

TEST(PositionIndex, IgnoresWhatIsBeyondTheTableOrBehind) {
  EXPECT_LT(table(3.01, 1), 0);
  EXPECT_LT(table(1, 1.91), 0);
  EXPECT_LT(table(0, 1.75), 0);  // beside an empty cell
  EXPECT_LT(position_index(PositionIndex::table, 0, 1, 0), 0);
  EXPECT_LT(position_index(PositionIndex::guth, 0, 1, -1), 0);
}

TEST(PositionIndex, ClosedFormAtKnownPlaces) {
  EXPECT_EQ(guth(0, 0), 1);
  const auto tan_deg = [](double d) { return std::tan(d * 3.14159265358979323846 / 180); };
  // Straight above, s = 30, t = 0: (35.2 - 1.22) 1e-3 * 30 + 21e-5 * 900.
  EXPECT_NEAR(guth(0, tan_deg(30)), std::exp(1.0194 + 0.189), 1e-9);
  // Beside, s = 30, t = 90: (35.2 - 28.7001) 1e-3 * 30 + (21 + 24.0003 - 24.0003) 1e-5 * 900.
  EXPECT_NEAR(guth(tan_deg(30), 0), std::exp(0.194997 + 0.189), 1e-5);
  // Below, both kinds: beta = atan(tan 30 sqrt(1.3225)), 1.15 times as far.
  const double beta = std::atan(tan_deg(30) * 1.15) * 180 / 3.14159265358979323846;
  for (const auto kind : {PositionIndex::table, PositionIndex::guth})
    EXPECT_NEAR(position_index(kind, 0, -tan_deg(30), 1), std::exp(6.49e-3 * beta + 2.1e-4 * beta * beta), 1e-9);
  EXPECT_EQ(guth(0, 30), 16);
  // No step at the height of the eye.
  EXPECT_NEAR(guth(0.5, 1e-9), position_index(PositionIndex::guth, 0.5, -1e-9, 1), 0.02);
}

TEST(GreatGlareRating, ByHand) {
  // A ceiling that is all luminous: 8 log10(2.55 * 2 / 5) more.
  EXPECT_NEAR(great_glare_rating(18, 1, 220, 55), 18 + 8 * std::log10(1.02), 1e-12);
  EXPECT_NEAR(great_glare_rating(18, 7, 220, 55), 18 + 8 * std::log10(1.02), 1e-12);
  EXPECT_NEAR(great_glare_rating(18, 0.36, 220, 55), 18 + 0.68 * 8 * std::log10(1.02), 1e-12);
  for (const double coverage : {0.0, 0.1, 0.18 / 1.18}) EXPECT_NEAR(great_glare_rating(18, coverage, 500, 50), 18, 1e-12);
}

// A luminous ceiling over a floor of reflectance 0.25: half of E falls on the eye straight, an eighth from the floor.
// CIE 147 allows 300, 600, 1000 and 1600 lx for ratings of 13, 16, 19 and 22.
TEST(GreatGlareRating, RisesAsTheLimitsOfLuminousCeilings) {
  const auto rating = [](double lx) {
    const double luminance = lx / 3.14159265358979323846, background = lx / 8 / 3.14159265358979323846;
    return great_glare_rating(ugr(luminance * luminance, background), 1, lx / 2, lx / 8);
  };
  const double lx[] = {300, 600, 1000, 1600};
  for (int i = 1; i < 4; ++i) EXPECT_NEAR(rating(lx[i]) - rating(300), 3 * i, 0.7) << lx[i];
}

TEST(Ugr, ByHand) {
  // 1000 cd/m2 of 0.01 sr at p = 2 before 10 cd/m2: 8 log10(0.025 * 2500).
  GlareSource s{1000, 0.01, 40, 2, 2};
  EXPECT_NEAR(glare_term(s), 2500, 1e-9);
  EXPECT_NEAR(ugr(glare_term(s), 10), 8 * std::log10(62.5), 1e-12);
  s.position_index = -1;
  EXPECT_EQ(glare_term(s), 0);
}

TEST(Ugr, SmallSourcesHaveTheGlareOfTheirIntensity) {
  // CIE 147: 200 I^2 / (r^2 p^2); at 0.005 m2 the two formulas meet.
  const double r = 3, intensity = 40, area = small_source_m2;
  GlareSource s{intensity / area, area / (r * r), intensity, r, 1.5, true};
  EXPECT_NEAR(glare_term(s), 200 * intensity * intensity / (r * r * 2.25), 1e-9);
  s.is_small = false;
  EXPECT_NEAR(glare_term(s), 200 * intensity * intensity / (r * r * 2.25), 1e-9);
}

}  // namespace
}  // namespace photometry
