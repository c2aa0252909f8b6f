// Light that only light paths can bring: from a source without extent over a mirror or through glass straight onto a
// meter. Photons merged at a point carry it (UPS), or photons that land on a cell (UPS, LT); path tracing sees none.
#include <functional>

#include "../support/expect_lx.h"

namespace ups::test {
namespace {

constexpr uint32_t light_paths = 1u << 15;

// Mean over a square centred on (x, y): Gauss-Legendre, 5 x 5 points.
double mean_over_cell(const std::function<double(double, double)>& lx, double x, double y, double side) {
  static constexpr double t[5] = {-0.906179845938664, -0.538469310105683, 0, 0.538469310105683, 0.906179845938664};
  static constexpr double w[5] = {0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                                  0.236926885056189};
  double sum = 0;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) sum += w[i] * w[j] / 4 * lx(x + t[i] * side / 2, y + t[j] * side / 2);
  return sum;
}

// 64 points over a square of side 0.2 about (x, y). Each holds twice its own bound, of at most 6 % (alone it finds 12 %);
// their mean is right to 0.5 % (or 4 standard errors, which are at most 0.15 %): an error of 1 % is found in 99 of 100
// cases; false alarms: expect_lx.h.
struct Grid {
  static constexpr int across = 8;
  std::vector<P3> at;
  std::vector<double> lx;
  Grid(const std::function<double(double, double)>& truth, double x, double y, double z) {
    for (int i = 0; i < across * across; ++i) {
      const double u = x + ((i % across + 0.5) / across - 0.5) * 0.2, v = y + ((i / across + 0.5) / across - 0.5) * 0.2;
      at.push_back({u, v, z}), lx.push_back(truth(u, v));
    }
  }
  void expect(const Result& result, const Sensor& meters, const std::string& what) const {
    const auto readings = result.readings(meters);
    const auto s = result.statistics(meters);
    double mean = 0;
    for (size_t i = 0; i < lx.size(); ++i) {
      mean += lx[i] / double(lx.size());
      expect_inside_bound(readings[i], lx[i], 0.06, what + ", meter " + std::to_string(i));
    }
    expect_lx(s.mean_lx, s.mean_standard_error_lx, mean, 0.0015, what);
  }
};

void expect_unseen_by_path_tracing(Scene& scene, const Sensor& meters) {
  for (const auto& r : scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 16}).readings(meters))
    EXPECT_EQ(r.illuminance_lx, 0);
}

// The mirror z = 0 of reflectance rho shows the source at (x, y, -z): E = rho I cos / d'^2.
class MirrorImage : public ::testing::Test {
 protected:
  static constexpr double intensity = 1000, rho = 0.8, side = 0.4;
  static double lx(double x, double y) {  // on the plane z = 1.5, facing down
    const P3 d{x + 1, y, 1.5 + 1.5};
    return rho * intensity * d.z / std::pow(length(d), 3);
  }
  void SetUp() override {
    scene.add(quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), photon_mirror(rho));
    scene.add(quad({0, -3, 0.8}, {0, 6, 0}, {0, 0, 3}),
              matte(0));  // in the way of direct light, outside the cone as well
    scene.add_spot({-1, 0, 1.5}, {1, 0, -1.5}, intensity, 0.35, 0.4);  // full intensity towards all that is measured
  }
  Scene scene;
};

TEST_F(MirrorImage, ReachesAPointByMerging) {
  const Grid below(lx, 1, 0, 1.5), aside(lx, 1.4, 0.4, 1.5);
  const Sensor a = scene.add_meters(below.at, {0, 0, -1}), b = scene.add_meters(aside.at, {0, 0, -1});
  const Result result =
      scene.render({.method = UPS_METHOD_UPS, .iterations = 16, .merge_radius_m = 0.2, .light_paths = light_paths});
  below.expect(result, a, "below the axis");
  aside.expect(result, b, "off axis");
  expect_unseen_by_path_tracing(scene, a);
}

TEST_F(MirrorImage, LandsOnACellWithoutBias) {
  const Sensor cells = scene.add_cells({{1, 0, 1.5}}, {{0, 0, -1}}, {{1, 0, 0}}, side, side);
  for (ups_method method : {UPS_METHOD_UPS, UPS_METHOD_LIGHT_TRACING}) {
    const auto readings =
        scene.render({.method = method, .iterations = 32, .light_paths = light_paths}).readings(cells);
    expect_lx(readings[0], mean_over_cell(lx, 1, 0, side), 0.0015, method_name(method));
    EXPECT_EQ(readings[0].bias_lx, 0);
  }
}

// A spot h above flat water, a meter d below its surface. A ray that leaves at the angle a and goes on at a', with
// sin a = n sin a', arrives at rho = h tan a + d tan a'. Flux I T(a) sin a da dphi arrives on rho drho dphi, so that
//   E(rho) = I T(a) sin a / (rho drho/da),   drho/da = h / cos^2 a + d cos a / (n cos^3 a').
// On the axis sin a -> a, a' -> a / n, rho -> a (h + d / n):   E(0) = I T(0) / (h + d / n)^2.
class Water : public ::testing::Test {
 protected:
  static constexpr double n = 1.33, h = 1.5, d = 1, intensity = 1000;

  static double transmittance(double a) {
    const double c = std::cos(a), c_in = std::sqrt(1 - std::pow(std::sin(a) / n, 2));
    const double s = (c - n * c_in) / (c + n * c_in), p = (n * c - c_in) / (n * c + c_in);
    return 1 - (s * s + p * p) / 2;
  }
  static double arrival(double a) { return h * std::tan(a) + d * std::tan(std::asin(std::sin(a) / n)); }
  static double lx(double x, double y) {
    const double rho = std::hypot(x, y);
    if (rho < 1e-9) return intensity * transmittance(0) / std::pow(h + d / n, 2);
    double low = 0, high = 1.5;
    for (int i = 0; i < 60; ++i) (arrival((low + high) / 2) < rho ? low : high) = (low + high) / 2;
    const double c_in = std::sqrt(1 - std::pow(std::sin(low) / n, 2));
    const double slope = h / std::pow(std::cos(low), 2) + d * std::cos(low) / (n * std::pow(c_in, 3));
    return intensity * transmittance(low) * std::sin(low) / (rho * slope);
  }
  void SetUp() override {
    scene.add(quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}), glass(n));
    scene.add_spot({0, 0, h}, {0, 0, -1}, intensity, 0.35, 0.4);  // full intensity over all that is measured
  }
  // Meters at the depth d, on the axis, which are returned, and beside it.
  Sensor expect_closed_form() {
    const Grid on(lx, 0, 0, -d), off(lx, 0.3, 0.1, -d);
    const Sensor a = scene.add_meters(on.at, {0, 0, 1}), b = scene.add_meters(off.at, {0, 0, 1});
    const Result result =
        scene.render({.method = UPS_METHOD_UPS, .iterations = 16, .merge_radius_m = 0.1, .light_paths = light_paths});
    on.expect(result, a, "axis");
    off.expect(result, b, "off axis");
    return a;
  }
  Scene scene;
};

TEST_F(Water, ReferenceIsContinuousOnTheAxis) { EXPECT_NEAR(lx(1e-4, 0) / lx(0, 0), 1, 1e-6); }

TEST_F(Water, LitFromAboveReachesAFloatingMeter) {
  expect_unseen_by_path_tracing(scene, expect_closed_form());
}

TEST_F(Water, LitFromAboveReachesAMeterOnTheFloor) {
  scene.add(quad({-5, -5, -d}, {10, 0, 0}, {0, 10, 0}), matte(0));
  expect_closed_form();
}

TEST_F(Water, LitFromAboveLandsOnCells) {
  const double side = 0.3;
  scene.add(quad({-5, -5, -d}, {10, 0, 0}, {0, 10, 0}), matte(0));
  const Sensor cells =
      scene.add_cells({{0, 0, -d}, {0.2, 0.1, -d}}, {{0, 0, 1}, {0, 0, 1}}, {{1, 0, 0}, {0, 1, 0}}, side, side);
  for (ups_method method : {UPS_METHOD_UPS, UPS_METHOD_LIGHT_TRACING}) {
    const auto readings =
        scene.render({.method = method, .iterations = 32, .light_paths = light_paths}).readings(cells);
    expect_lx(readings[0], mean_over_cell(lx, 0, 0, side), 0.0015, std::string(method_name(method)) + ", axis");
    expect_lx(readings[1], mean_over_cell(lx, 0.2, 0.1, side), 0.0015, std::string(method_name(method)) + ", off axis");
  }
}

}  // namespace
}  // namespace ups::test
