// Is the density that renderers look up, in single precision, that of the distribution? Of every file of the repository
// and of tables that ask much of the look-up: to 1e-5 of the peak, in random directions, in those of the table's nodes,
// close to the poles, on axes, and where light is sampled.
//
// A rounded angle may fall on the other side of a step, or elsewhere on a steep slope: there the density must be one
// that the distribution has within 5e-7 rad of the direction, to 1e-5 of the peak again.
#include <algorithm>
#include <cfenv>
#include <filesystem>
#include <random>

#include "photometry/files.h"

namespace photometry::test {
namespace {

constexpr size_t random_directions = 10000;

struct Unit {
  float x, y, z;
};

Unit unit(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {float(x / length), float(y / length), float(z / length)};
}

Unit unit_of_angles(double c_deg, double gamma_deg) {
  const double c = rad(c_deg), g = rad(gamma_deg);
  return unit(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
}

std::vector<Unit> directions(const Distribution& d) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto uniform = [&] { return random() * 0x1p-32; };
  std::vector<Unit> out;
  for (size_t i = 0; i < random_directions; ++i) out.push_back(unit(normal(random), normal(random), normal(random)));
  for (int i = 0; i < 2000; ++i) {
    const double small = std::pow(10, -10 * uniform());
    out.push_back(unit(small * normal(random), small * normal(random), i % 2 ? 1 : -1));  // poles of type C
    out.push_back(unit(small * normal(random), i % 2 ? 1 : -1, small * normal(random)));  // of type B
    out.push_back(unit(i % 2 ? 1 : -1, small * normal(random), small * normal(random)));  // of type A
    const Distribution::Sample s = d.sample(uniform(), uniform());
    out.push_back(unit(s.x, s.y, s.z));
  }
  for (const float zero : {0.0f, -0.0f})
    for (const float one : {1.0f, -1.0f}) {
      out.insert(out.end(), {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}});
      for (const float other : {0.6f, -0.6f})
        out.insert(out.end(), {{0.8f * one, other, zero}, {zero, 0.8f * one, other}, {other, zero, 0.8f * one}});
    }
  const size_t nodes = d.c_deg().size() * d.gamma_deg().size();
  for (size_t i = 0; i < nodes; i += 1 + nodes / 5000) {
    double c, g;
    d.node_direction(i / d.gamma_deg().size(), i % d.gamma_deg().size(), c, g);
    for (const double beside : {0.0, 1e-5, -1e-5}) out.push_back(unit_of_angles(c + beside, g - beside));
  }
  return out;
}

// Angles of the table: C and gamma, or of type A H and V, of type B V and H (distribution.h).
struct Angles {
  double plane_deg, row_deg;
};

Angles angles_of(PhotometricType type, const Unit& u) {
  const double x = u.x, y = u.y, forward = 0 - double(u.z), right = 0 - y;
  const auto degrees = [](double a, double b) { return std::atan2(a, b) / rad(1); };
  if (type == PhotometricType::a) return {degrees(right, forward), degrees(x, std::hypot(forward, right))};
  if (type == PhotometricType::b) return {degrees(x, forward), degrees(right, std::hypot(forward, x))};
  return {degrees(y, x), degrees(std::hypot(x, y), forward)};
}

double eval_in_table(const Distribution& d, const Angles& a) {
  const double p = rad(a.plane_deg), r = rad(a.row_deg), across = std::cos(r);
  if (d.type() == PhotometricType::c) return eval_at(d, a.plane_deg, a.row_deg);
  if (d.type() == PhotometricType::a) return d.eval(std::sin(r), -across * std::sin(p), -across * std::cos(p));
  return d.eval(across * std::sin(p), -std::sin(r), -across * std::cos(p));
}

// `angle`, what is `reach` to both sides of it, and the nodes between.
std::vector<double> nearby(double angle, double reach, const std::vector<double>& nodes) {
  std::vector<double> out = {angle - reach, angle, angle + reach};
  for (const double node : nodes)
    if (std::abs(std::remainder(node - angle, 360)) < reach) out.push_back(node);
  return out;
}

// How far `value` is from what the distribution has within 5e-7 rad of u: extremes of what is bilinear are at nodes.
double off_nearby(const Distribution& d, const Unit& u, double value) {
  const Angles at = angles_of(d.type(), u);
  const double polar = rad(d.type() == PhotometricType::c ? at.row_deg : at.row_deg + 90);
  const double reach = 5e-7 / rad(1), turned = std::min(360.0, reach / std::abs(std::sin(polar)));
  double least = INFINITY, most = -INFINITY;
  for (const double row : nearby(at.row_deg, reach, d.gamma_deg()))
    for (const double plane : nearby(at.plane_deg, turned, d.c_deg())) {
      const double there = eval_in_table(d, {plane, row});
      least = std::min(least, there), most = std::max(most, there);
    }
  return std::max({0.0, least - value, value - most});
}

// Returns how many of the random directions are beside a step, or on a slope so steep that 1e-5 of the peak is missed.
int expect_density(const Distribution& d) {
  const double flux = d.interpolated_flux_lm(), allowed = 1e-5 * d.peak_cd();
  const std::vector<Unit> all = directions(d);
  int beside = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    const Unit& u = all[i];
    const double value = double(d.fast_pdf_w(u.x, u.y, u.z)) * flux;
    if (std::abs(value - d.eval(u.x, u.y, u.z)) <= allowed) continue;
    EXPECT_LE(off_nearby(d, u, value), allowed) << u.x << " " << u.y << " " << u.z << " has " << value;
    if (i < random_directions) ++beside;
  }
  return beside;
}

TEST(DensityTable, IsTheDistributionOfEveryFile) {
  int files = 0;
  for (const char* folder : {TEST_DATA, PROFILE_DATA, FUZZ_CORPUS})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string path = entry.path().string(), bytes = entry.is_regular_file() ? contents(path) : "";
      Distribution d({0}, {0, 180}, {1, 1});
      try {
        d = read_text(bytes).distribution;
      } catch (const std::exception&) {
        continue;  // a file that is wrong on purpose, a script, a folder
      }
      SCOPED_TRACE(path);
      ++files;
      if (d.interpolated_flux_lm() > 0) EXPECT_EQ(expect_density(d), 0);
      else EXPECT_EQ(d.fast_pdf_w(0, 0, -1), 0);
    }
  EXPECT_GE(files, 60);
}

std::vector<double> random_values(size_t count) {
  std::mt19937 random(6);
  std::vector<double> out;
  for (size_t i = 0; i < count; ++i) out.push_back(random() % 3 == 0 ? 0 : random() * 0x1p-32);
  return out;
}

TEST(DensityTable, FindsUnevenAnglesStepsAndNeedles) {
  const std::vector<double> c = {0, 1e-6, 0.01, 37, 90, 200, 200.001, 359.99};
  std::vector<double> gamma = {0, 0.001, 0.5, 30, 30.0001, 89.9, 90, 90 + 1e-9, 179.999, 180};
  const auto check = [](const char* name, const Distribution& d) {
    SCOPED_TRACE(name);
    EXPECT_LE(expect_density(d), 10);
  };
  check("round", Distribution({0}, gamma, random_values(gamma.size())));
  check("type C", Distribution(c, gamma, random_values(c.size() * gamma.size())));
  std::vector<double> plane = {-180, -90, -89.999, -1e-9, 0, 3, 180}, row = {-90, -30, 0, 1e-9, 2, 90};
  for (const PhotometricType type : {PhotometricType::a, PhotometricType::b})
    check("all around", Distribution(type, plane, row, random_values(plane.size() * row.size())));
  plane = {-40, -3, 12, 12.5}, row = {-60, -10, 0, 33};
  for (const PhotometricType type : {PhotometricType::a, PhotometricType::b})
    check("a part", Distribution(type, plane, row, random_values(plane.size() * row.size())));
  // A hundred rows within a hundredth of a degree; a needle of a few rounding errors.
  gamma = {0, 20};
  for (int i = 1; i <= 100; ++i) gamma.push_back(20 + 1e-4 * i);
  gamma.insert(gamma.end(), {60, 180});
  check("crowded", Distribution({0}, gamma, random_values(gamma.size())));
  check("needle", Distribution({0}, {0, 2e-5, 4e-5}, {1, 1, 0}));
  check("one thin ring", Distribution({0}, {90, 90.001}, {1, 1}));
  std::fenv_t traps;
  std::feholdexcept(&traps);  // of a build that has some
  EXPECT_EQ(Distribution({0}, {0, 180}, {1, 1}).fast_pdf_w(NAN, 0, 1), 0);
  std::fesetenv(&traps);
}

}  // namespace
}  // namespace photometry::test
