// Do tables of types A and B answer like the same lamp in type C, without resampling: intensity, both fluxes, sampling,
// peak, mirror images? Chi-square tests: fixed seeds, false-alarm rate 1e-4 each; densities that are off by 1.6 %, root
// mean square, are found in 97.7 of 100 cases.
#include <algorithm>
#include <random>

#include "photometry/c_gamma.h"
#include "photometry/files.h"
#include "support/chi_square.h"

namespace photometry {
namespace {

using namespace test;

constexpr double pi = 3.14159265358979323846;

struct Direction {
  double x, y, z;
};

// Seen along forward (-z), up (+x) at the top, right is -y.
Direction of_type(PhotometricType type, double h_deg, double v_deg) {
  const double h = rad(h_deg), v = rad(v_deg);
  if (type == PhotometricType::b) return {std::cos(h) * std::sin(v), -std::sin(h), -std::cos(h) * std::cos(v)};
  return {std::sin(v), -std::cos(v) * std::sin(h), -std::cos(v) * std::cos(h)};
}

// I = 1000 f (1 + 0.25 a + 0.5 b): f forward, a towards C0, b towards C90; the files round to 0.001.
TEST(Types, NodesOfAAndBAreTheLampOfTypeC) {
  for (const auto& [file, type] : {std::pair{"s09_typeB_asym.ies", PhotometricType::b},
                                   std::pair{"s10_typeA_asym.ies", PhotometricType::a}}) {
    const Photometry p = read_file(file);
    EXPECT_EQ(p.type, type);
    EXPECT_EQ(p.distribution.type(), type);
    EXPECT_TRUE(p.warnings.empty()) << p.warnings[0];
    EXPECT_EQ(p.symmetry, Symmetry::none);
    for (double h = -85; h <= 85; h += 5)
      for (double v = -85; v <= 85; v += 5) {
        const Direction d = of_type(type, h, v);
        EXPECT_NEAR(p.distribution.eval(d.x, d.y, d.z), std::max(0.0, -1000 * d.z * (1 + 0.25 * d.x + 0.5 * d.y)), 1e-3)
            << file << " " << h << " " << v;
      }
  }
}

TEST(Types, FluxIsTheTablesOwn) {
  for (const char* file : {"s09_typeB_asym.ies", "s10_typeA_asym.ies"}) {
    const Distribution d = read_file(file).distribution;
    EXPECT_NEAR(d.band_flux_lm(), 3135.62, 0.01) << file;  // 5 degree bands about the table's axis; exactly 3141.59
    double sum = 0;  // of eval over the hemisphere, midpoint rule in C-gamma
    constexpr int n = 1500;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double g = (i + 0.5) * 90 / n;
        sum += eval_at(d, (j + 0.5) * 360 / n, g) * std::sin(rad(g));
      }
    EXPECT_NEAR(sum * pi * pi / n / n / d.interpolated_flux_lm(), 1, 1e-6) << file;
    EXPECT_EQ(d.eval(0, 0, 1), 0);
    EXPECT_EQ(d.eval(0.5, 0.3, 0.01), 0) << "no light behind the planes -90 and 90";
  }
}

TEST(Types, PeakIsInCGamma) {
  for (const char* file : {"s09_typeB_asym.ies", "s10_typeA_asym.ies"}) {
    const Distribution d = read_file(file).distribution;
    EXPECT_NEAR(eval_at(d, d.peak_c_deg(), d.peak_gamma_deg()), d.peak_cd(), 1e-9 * d.peak_cd());
  }
  const std::vector<double> two = {-90, 90}, row = {-90, 0, 90};
  const Distribution forward(PhotometricType::b, {-90, 0, 90}, row, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  EXPECT_EQ(forward.peak_gamma_deg(), 0);
  const Distribution right(PhotometricType::b, two, row, {0, 0, 1, 0, 0, 1}),
      up(PhotometricType::a, two, row, {0, 0, 1, 0, 0, 1});
  EXPECT_EQ(right.peak_c_deg(), 270);
  EXPECT_EQ(right.peak_gamma_deg(), 90);
  EXPECT_EQ(right.eval(0, -1, 0), 1);
  EXPECT_EQ(up.peak_c_deg(), 0);
  EXPECT_EQ(up.peak_gamma_deg(), 90);
  EXPECT_EQ(up.eval(1, 0, 0), 1);
}

// Samples in cells of gamma and C, against quadrature of eval.
void expect_exact_sampling(const Distribution& d, uint32_t seed) {
  constexpr int rows = 12, columns = 18, fine = 64, samples = 600000;
  std::vector<double> expected(rows * columns, 0.0), observed(rows * columns, 0.0);
  for (int i = 0; i < rows * fine; ++i)
    for (int j = 0; j < columns * fine; ++j) {
      const double g = (i + 0.5) * 180 / (rows * fine), c = (j + 0.5) * 360 / (columns * fine);
      expected[size_t(i / fine * columns + j / fine)] += eval_at(d, c, g) * std::sin(rad(g)) * samples *
                                                         (pi / (rows * fine)) * (2 * pi / (columns * fine)) /
                                                         d.interpolated_flux_lm();
    }
  std::mt19937 random(seed);
  for (int i = 0; i < samples; ++i) {
    const Distribution::Sample s = d.sample(random() * 0x1p-32, random() * 0x1p-32);
    ASSERT_NEAR(s.x * s.x + s.y * s.y + s.z * s.z, 1, 1e-14);
    ASSERT_NEAR(d.eval(s.x, s.y, s.z), s.intensity_cd, 1e-9 * d.peak_cd());
    ASSERT_NEAR(d.pdf_w(s.x, s.y, s.z), s.pdf_w, 1e-9 * d.peak_cd() / d.interpolated_flux_lm());
    double c = std::atan2(s.y, s.x) / (2 * pi);
    if (c < 0) c += 1;
    const double g = std::acos(std::clamp(-s.z, -1.0, 1.0)) / pi;
    observed[std::min(size_t(g * rows), size_t(rows - 1)) * columns +
             std::min(size_t(c * columns), size_t(columns - 1))] += 1;
  }
  const auto result = ups::test::chi_square_test(observed, expected);
  ASSERT_GT(result.degrees_of_freedom, 20);
  EXPECT_GT(result.p_value, 1e-4) << result.statistic << " / " << result.degrees_of_freedom;
  EXPECT_LE(ups::test::smallest_found(samples, result.degrees_of_freedom, 1e-4), 0.016);
}

TEST(Types, SamplingIsExact) {
  expect_exact_sampling(read_file("s09_typeB_asym.ies").distribution, 1);
  expect_exact_sampling(read_file("s10_typeA_asym.ies").distribution, 2);
  // Beyond the hemisphere, with a gap, dark within.
  std::vector<double> table;
  const std::vector<double> plane = {-150, -100, -20, 40, 110}, row = {-60, -10, 30, 80};
  for (size_t i = 0; i < plane.size() * row.size(); ++i) table.push_back(i % 7 == 3 ? 0 : 10 + double(i % 5) * 20);
  expect_exact_sampling(Distribution(PhotometricType::b, plane, row, table), 3);
  expect_exact_sampling(Distribution(PhotometricType::a, plane, row, table), 4);
}

// Vertical and horizontal angles given from 0: the mirror image is the other half.
TEST(Types, HalvesAreMirrored) {
  const auto file = [](int type, const char* v, const char* h, const char* cd) {
    const auto count = [](const std::string& s) { return std::to_string(std::count(s.begin(), s.end(), ' ') + 1); };
    return read_text("IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 -1 1 " + count(v) + " " + count(h) + " " +
                     std::to_string(type) + " 2 0 0 0\n1 1 5\n" + v + "\n" + h + "\n" + cd + "\n");
  };
  for (int type : {2, 3}) {
    const PhotometricType t = type == 2 ? PhotometricType::b : PhotometricType::a;
    const auto at = [&](const Photometry& p, double h, double v) {
      const Direction d = of_type(t, h, v);
      return p.distribution.eval(d.x, d.y, d.z);
    };
    const Photometry lateral = file(type, "-90 0 90", "0 45 90", "1 2 3 4 5 6 7 8 9");
    EXPECT_EQ(lateral.symmetry, Symmetry::c0_c180);
    EXPECT_NEAR(at(lateral, 45, 0), 5, 1e-12);
    EXPECT_NEAR(at(lateral, -45, 0), 5, 1e-12);
    EXPECT_NEAR(at(lateral, -45, -45), 4.5, 1e-12);
    EXPECT_TRUE(lateral.warnings.empty());
    const Photometry both = file(type, "0 60 90", "0 45 90", "1 2 3 4 5 6 7 8 9");
    EXPECT_EQ(both.symmetry, Symmetry::quadrants);
    for (double h : {-45, 45})
      for (double v : {-60, 60}) EXPECT_NEAR(at(both, h, v), 5, 1e-12);
    const Photometry upright = file(type, "0 60 90", "-90 0 90", "1 2 3 4 5 6 7 8 9");
    EXPECT_EQ(upright.symmetry, Symmetry::c90_c270);
    EXPECT_NEAR(at(upright, 0, -60), 5, 1e-12);
    const Photometry narrow = file(type, "-30 0 30", "0 10 20", "1 2 3 4 5 6 7 8 9");
    EXPECT_TRUE(has_warning(narrow, "line 6: vertical angles from -30 to 30"));
    EXPECT_TRUE(has_warning(narrow, "line 7: horizontal angles from 0 to 20"));
    EXPECT_NEAR(at(narrow, -10, 0), 5, 1e-12);
    EXPECT_EQ(at(narrow, 0, 31), 0);
    EXPECT_EQ(at(narrow, 21, 0), 0);
  }
  EXPECT_NE(refusal<ParseError>("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 2 2 0 0 0\n1 1 5\n0 90\n0\n1 1\n")
                .find("line 6: there is"),
            std::string::npos);
  EXPECT_NE(refusal<ParseError>("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 2 2 2 0 0 0\n1 1 5\n-90 90\n-95 90\n1 1 1 1\n")
                .find("line 6"),
            std::string::npos);
}

// The opening of a type A file: its (0, 0) is horizontal, so width, length, height are -y, forward, up.
TEST(Types, OpeningOfTypeAFacesForward) {
  const std::string head = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 2 ", tail = "\n1 1 5\n-90 90\n-90 90\n1 1 1 1\n";
  const Opening a = read_text(head + "3 2 -.2 0 -.3" + tail).opening;
  EXPECT_EQ(a.shape, OpeningShape::disc);
  EXPECT_FLOAT_EQ(a.size_m[0], .3f);
  EXPECT_FLOAT_EQ(a.size_m[1], .2f);
  EXPECT_FLOAT_EQ(a.size_m[2], 0);
  const Opening face = read_file("s10_typeA_asym.ies").opening;  // without height: as in types B and C
  EXPECT_FLOAT_EQ(face.size_m[0], .3f);
  EXPECT_FLOAT_EQ(face.size_m[1], .6f);
  EXPECT_FLOAT_EQ(face.size_m[2], 0);
  const Opening b = read_text(head + "2 2 .2 .3 0" + tail).opening;
  EXPECT_FLOAT_EQ(b.size_m[0], .3f);
  EXPECT_FLOAT_EQ(b.size_m[1], .2f);
}

TEST(Types, ResamplesOntoACGammaGrid) {
  for (const char* file : {"s09_typeB_asym.ies", "s10_typeA_asym.ies"}) {
    const Distribution d = read_file(file).distribution, r = in_c_gamma(d);
    EXPECT_EQ(r.type(), PhotometricType::c);
    EXPECT_EQ(r.c_deg().size(), 144u);
    EXPECT_EQ(r.gamma_deg().size(), 37u);
    EXPECT_EQ(r.gamma_deg().back(), 90);
    for (size_t i = 0; i < r.c_deg().size(); i += 7)
      for (size_t j = 0; j + 1 < r.gamma_deg().size(); ++j)
        ASSERT_NEAR(r.at(i, j), eval_at(d, r.c_deg()[i], r.gamma_deg()[j]), 1e-9) << file;
    EXPECT_NEAR(r.interpolated_flux_lm() / d.interpolated_flux_lm(), 1, 1e-3);
  }
  const Distribution c({0}, {0, 90}, {1, 1});
  EXPECT_EQ(in_c_gamma(c).gamma_deg(), c.gamma_deg());
  EXPECT_EQ(c.resampled({0, 120, 240}, {0, 45, 90}).at(2, 1), 1);
}

TEST(Types, NamesWhatIsInvalid) {
  const auto refused = [](std::vector<double> planes, std::vector<double> rows) -> std::string {
    try {
      std::vector<double> table(planes.size() * rows.size(), 1.0);
      Distribution(PhotometricType::a, std::move(planes), std::move(rows), std::move(table));
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refused({-90, 90}, {-90, 90}), "accepted");
  EXPECT_NE(refused({0}, {-90, 90}).find("plane_deg has fewer than 2"), std::string::npos);
  EXPECT_NE(refused({-90, 90}, {0}).find("row_deg has fewer than 2"), std::string::npos);
  EXPECT_NE(refused({-181, 90}, {-90, 90}).find("plane_deg[0]"), std::string::npos);
  EXPECT_NE(refused({-90, 90}, {-90, 91}).find("row_deg[1]"), std::string::npos);
}

}  // namespace
}  // namespace photometry
