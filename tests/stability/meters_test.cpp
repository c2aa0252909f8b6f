// Meters where photons' discs do not fit: beside walls, on edges and in corners, over bent surfaces, under what casts
// caustics. Light comes by photons alone (PPM), and its truth is known. A bound is a 95 % statement: of the readings
// that are judged together no more may miss theirs than a right engine's would in 95 of 100 cases (2 of 16, 3 of 24, 4
// of 36), and none twice theirs, 4 standard errors, P = 1e-4 each. Their mean must be right to half a percent at a
// standard error of at most 0.15 %, asserted: 1 % is found in 99.9 of 100 cases, and a false alarm takes 3 of them,
// P(|t_15| > 3) = 0.9 % at that limit.
#include <algorithm>

#include "../analytic/ies_text.h"
#include "../support/expect_same.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

struct Known {
  std::vector<P3> at, normals;
  std::vector<double> lx;
  void add(const P3& p, const P3& n, double e) { at.push_back(p), normals.push_back(n), lx.push_back(e); }
};

double lamp_lx(const P3& lamp, double candela, const P3& p, const P3& n) {
  const P3 d = lamp - p;
  return candela * std::max(0.0, dot(d, n)) / std::pow(length(d), 3);
}

// The most that miss 95 % bounds in 95 of 100 cases: P(more) is at most 5 %.
int most_misses(size_t readings) {
  double p = std::pow(0.95, double(readings)), sum = p;  // of k misses, of k at most
  int k = 0;
  for (; sum < 0.95; ++k, sum += p) p *= 0.05 / 0.95 * double(readings - size_t(k)) / (k + 1);
  return k;
}

struct Judged {
  double mean_error = 0, worst_error = 0, widest_bound = 0;  // relative
  int held = 0;
};
// widest: that a bound may be, relative.
Judged judge(const Result& result, const Sensor& meters, const Known& known, const std::string& what, double widest,
             bool by_mean = true) {
  const auto readings = result.readings(meters);
  const auto all = result.statistics(meters);
  Judged j;
  for (size_t i = 0; i < readings.size(); ++i) {
    const double error = readings[i].illuminance_lx - known.lx[i], bound = readings[i].error_bound_lx;
    EXPECT_GT(bound, 0) << what << ", meter " << i;
    EXPECT_LE(std::abs(error), 2 * bound)
        << what << ", meter " << i << ": " << readings[i].illuminance_lx << " of " << known.lx[i];
    j.held += std::abs(error) <= bound;
    j.mean_error += error / known.lx[i] / double(readings.size());
    j.worst_error = std::max(j.worst_error, std::abs(error) / known.lx[i]);
    j.widest_bound = std::max(j.widest_bound, bound / known.lx[i]);
  }
  EXPECT_GE(j.held, int(readings.size()) - most_misses(readings.size())) << what;
  EXPECT_LE(j.widest_bound, widest) << what;
  if (by_mean) {
    EXPECT_LE(all.mean_standard_error_lx, 0.0015 * all.mean_lx) << what << ": too noisy to judge";
    EXPECT_NEAR(j.mean_error, 0, 0.005) << what;
  }
  measured("%s: mean error %+.2f (+- %.2f) %%, worst %.2f %%, widest bound %.2f %%, %d of %zu held", what.c_str(),
           100 * j.mean_error, 100 * all.mean_standard_error_lx / std::max(all.mean_lx, 1e-9), 100 * j.worst_error,
           100 * j.widest_bound, j.held, readings.size());
  return j;
}

// A black room with one lamp. `at`: meters with their truth; light straight from the lamp, by photons.
Judged judge_in_black_room(const Known& known, const P3& lamp, double candela, const std::string& what) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0));
  scene.add_point_light(lamp, candela);
  const Sensor meters = scene.add_meters(known.at, known.normals);
  const Result r = scene.render({.method = UPS_METHOD_PPM, .iterations = 96, .light_paths = 1u << 18});
  return judge(r, meters, known, what, 0.08);
}

TEST(Hazard19, MetersTwoCentimetresFromAWallHoldTheirBound) {
  const P3 lamp{1.5, 1.2, 2};
  Known known;
  for (int i = 0; i < 16; ++i) {
    const P3 p{0.02, 0.3 + 0.2 * i, i % 2 ? 0.0 : 0.75};
    known.add(p, {0, 0, 1}, lamp_lx(lamp, 100, p, {0, 0, 1}));
  }
  judge_in_black_room(known, lamp, 100, "2 cm from a wall");
}

// Pixels that see the floor right beside a wall, by photons alone: discs there hang beyond the floor's edge, and half of
// the light is missing at the wall, as the bias says. Bounds alone are judged (pixels share photons). Known limit: where
// the camera sees nothing but what lies within a wide radius of the wall, one bound in eight does not hold.
TEST(Hazard19, PixelsBesideAWallHoldTheirBound) {
  constexpr uint32_t side = 16;
  constexpr double rho = 0.5, half = 0.045;
  const P3 lamp{1.5, 1.2, 2};
  Scene scene;
  scene.add(quad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), matte(rho));
  scene.add(quad({0, 0, 0}, {0, 4, 0}, {0, 0, 3}), matte(0));
  scene.add_point_light(lamp, 100);
  const Sensor camera = scene.add_camera({0.05, 2, 0.5}, {0, 0, -1}, side, side, 2 * std::atan(half / 0.5));
  for (const double radius : {0.0, 0.02, 0.05}) {
    const Image image =
        scene.render({.method = UPS_METHOD_PPM, .iterations = 64, .merge_radius_m = radius, .light_paths = 1u << 17})
            .image(camera);
    int held = 0;
    double worst = 0, widest = 0;
    for (uint32_t p = 0; p < side * side; ++p) {
      const P3 at{0.05 + ((p % side + 0.5) / 8 - 1) * half, 2 + (1 - (p / side + 0.5) / 8) * half, 0};
      const double truth = rho / pi_d * lamp_lx(lamp, 100, at, {0, 0, 1});
      held += std::abs(image.luminance[3 * p] - truth) <= image.error_bound[p];
      worst = std::max(worst, std::abs(image.luminance[3 * p] / truth - 1));
      widest = std::max(widest, image.error_bound[p] / truth);
    }
    measured("radius %g m: worst %.1f %%, widest bound %.1f %%, %d of %u pixels held", radius, 100 * worst,
             100 * widest, held, side * side);
    EXPECT_GE(held, radius < 0.05 ? int(side * side) - most_misses(side * side) : 0.85 * side * side) << radius;
  }
}

// Where walls meet, and up to 2 cm beside. Next-event estimation has no chance there: the closed form to 1e-4. Photons
// find discs as wide as the corner leaves them, none right in it: their bounds hold all the same, and their mean says
// nothing. Spots from one place, one for each corner and edge, send them nowhere else: bounds are at most 10 % at 2 cm,
// 20 % at 5 mm, of which three times as much is found at a single meter; at 0.5 mm a few photons come, and
// bounds are as large as readings and larger.
TEST(Taught, MetersOnEdgesAndInCorners) {
  const double distances[] = {0.0, 0.0005, 0.005, 0.02}, widest[] = {INFINITY, INFINITY, 0.2, 0.1};
  const P3 lamp{1.5, 1.2, 1.6};
  Known known;
  const auto add = [&](const P3& p, const P3& n) { known.add(p, n, lamp_lx(lamp, 100, p, n)); };
  for (const double d : distances) {
    add({d, d, 0}, {0, 0, 1});  // in the corner of the floor
    add({d, d, d}, {0, 0, 1});
    add({d, 2, 0}, {0, 0, 1});      // on the edge of floor and wall
    add({0, 2, d}, {1, 0, 0});      // the same, on the wall
    add({4 - d, d, 1}, {0, 1, 0});  // where two walls meet
    add({d, d, 3 - d}, normalize({1, 1, -1}));
  }
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0));
  for (const P3& at : {P3{0, 0, 0}, P3{0, 2, 0}, P3{4, 0, 1}, P3{0, 0, 3}})
    scene.add_spot(lamp, normalize(at - lamp), 100, 0.05, 0.052);
  const Sensor meters = scene.add_meters(known.at, known.normals);
  const auto exact = scene.render({.method = UPS_METHOD_UPS, .iterations = 16}).readings(meters);
  for (size_t i = 0; i < exact.size(); ++i)
    expect_ratio(exact[i].illuminance_lx, known.lx[i], 1e-4, "meter " + std::to_string(i));
  const Result photons = scene.render(
      {.method = UPS_METHOD_PPM, .iterations = 32, .merge_radius_m = 0.03, .light_paths = 1u << 16});
  judge(photons, meters, known, "edges and corners", widest[0], false);
  const auto readings = photons.readings(meters);
  for (size_t i = 0; i < readings.size(); ++i) {
    const size_t k = i * std::size(distances) / readings.size();
    EXPECT_LE(readings[i].error_bound_lx, widest[k] * known.lx[i]) << distances[k] << ", meter " << i;
  }
}

// On a table's top, at its edge and at its corner, beyond which the disc hangs in the air, over a floor.
TEST(Taught, MetersOnATablesEdge) {
  const P3 lamp{0.1, -0.2, 1.5};
  Scene scene;
  scene.add(quad({-3, -3, -0.7}, {6, 0, 0}, {0, 6, 0}), matte(0));
  scene.add(box({-0.5, -0.4, -0.03}, {0.5, 0.4, 0}), matte(0));
  scene.add_point_light(lamp, 100);
  Known known;
  for (const double d : {0.0, 0.001, 0.01, 0.05})
    for (const P3& p : {P3{0.5 - d, 0, 0}, P3{0.5 - d, 0.4 - d, 0}, P3{-0.2, -0.4 + d, 0}, P3{0.3, 0.4 - d, 0}})
      known.add(p, {0, 0, 1}, lamp_lx(lamp, 100, p, {0, 0, 1}));
  const Sensor meters = scene.add_meters(known.at, known.normals);
  judge(scene.render({.method = UPS_METHOD_PPM, .iterations = 64, .light_paths = 1u << 18}), meters, known,
        "a table's edge", 0.02);
}

// Discs ten times as wide as the surface's radius of curvature: on top of rods and balls of 1 cm.
TEST(Hazard20, DiscsWiderThanASurfaceIsBentHoldTheirBound) {
  const P3 lamp{0.4, 0.3, 1.5};
  Scene scene;
  scene.add(quad({-3, -3, -0.5}, {6, 0, 0}, {0, 6, 0}), matte(0));
  Known known;
  for (int i = 0; i < 16; ++i) {
    const P3 center{0.5 * (i % 4) - 0.8, 0.5 * (i / 4) - 0.8, 0};
    const Shape ball = icosphere(center, 0.01, 2);
    scene.add(ball, matte(0));
    const P3 n{0, 0, 1}, top = center + n * 0.01;  // a vertex of the mesh is at most rounding below it
    known.add(top, n, lamp_lx(lamp, 100, top, n));
  }
  scene.add_point_light(lamp, 100);
  const Sensor meters = scene.add_meters(known.at, known.normals);
  const Result r =
      scene.render({.method = UPS_METHOD_PPM, .iterations = 48, .merge_radius_m = 0.1, .light_paths = 1u << 17});
  judge(r, meters, known, "balls of 1 cm", 0.1);
}

// What a camera sees of a rod of 1 cm, by photons alone: the bounds of its pixels hold, with the radius that the scene
// calls for and with one of 1 mm (bounds alone are judged; pixels share photons). With discs of 10 cm, which most of
// the rod's light cannot fill, they cannot: that is said.
TEST(Hazard20, PixelsOfABentSurfaceHoldTheirBoundOrAreWarnedOf) {
  constexpr uint32_t side = 16;
  constexpr double radius = 0.01, rho = 0.8, lx = 1000, half = 0.004;
  Scene scene;
  Shape rod;
  constexpr int sides = 256;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * pi_d * i / sides, b = 2 * pi_d * (i + 1) / sides;
    const P3 from{radius * std::cos(a), -1, radius * std::sin(a)}, to{radius * std::cos(b), -1, radius * std::sin(b)};
    rod.append(quad(from, {0, 2, 0}, to - from));
  }
  scene.add(rod, matte(rho));
  scene.add_directional({0, 0, -1}, lx);
  const Sensor camera = scene.add_camera({0, 0, 1}, {0, 0, -1}, side, side, 2 * std::atan(half / (1 - radius)));
  for (const double r : {0.0, 0.001, 0.1}) {
    const Result result =
        scene.render({.method = UPS_METHOD_PPM, .iterations = 64, .merge_radius_m = r, .light_paths = 1u << 16});
    const Image image = result.image(camera);
    int held = 0;
    double mean = 0;  // over the truth
    for (uint32_t p = 0; p < side * side; ++p) {
      const double x = ((p % side + 0.5) / side * 2 - 1) * half,
                   truth = rho / pi_d * lx * std::sqrt(1 - x * x / (radius * radius));
      held += std::abs(image.luminance[3 * p] - truth) <= image.error_bound[p];
      mean += image.luminance[3 * p] / truth / (side * side);
    }
    const bool told = result.text(UPS_TEXT_WARNINGS).find("camera 1: the merge radius that was asked for is wider") !=
                      std::string::npos;
    EXPECT_EQ(told, r == 0.1) << r;
    EXPECT_TRUE(told || held >= int(side * side) - most_misses(side * side)) << r << ": " << held;
    measured("a rod of 1 cm, radius %g m: mean %+.2f %%, %d of %u pixels held", r, 100 * (mean - 1), held,
             side * side);
  }
}

// Under a slab of glass 1 mm above the floor, in the sun: 2 n / (n^2 + 1) of it, with all reflections inside, and all
// of it 5 cm beyond the slab's edge.
TEST(Taught, MetersUnderACaster) {
  constexpr double n = 1.5, lx = 1000, inside = lx * 2 * n / (n * n + 1);
  Scene scene;
  scene.add(quad({-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0}), matte(0));
  scene.add(box({-0.2, -0.2, 0.001}, {0.2, 0.2, 0.021}), glass(n));
  scene.add_directional({0, 0, -1}, lx);
  Known under, beside;
  for (const P3& p : grid_about({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.3, 6)) under.add(p, {0, 0, 1}, inside);
  for (const P3& p : grid_about({0.35, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.2, 6)) beside.add(p, {0, 0, 1}, lx);
  const Sensor a = scene.add_meters(under.at, under.normals), b = scene.add_meters(beside.at, beside.normals);
  for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_PPM}) {
    const Result r = scene.render({.method = method, .iterations = 64, .light_paths = 1u << 16});
    const std::string what = method_name(method);
    judge(r, a, under, what + " under a slab", 0.03);
    judge(r, b, beside, what + " beside it", 0.03);
  }
}

// A slab that lies on the floor: whether there is air between the two is a matter of rounding, and what is read lies
// between both, 2 n / (n^2 + 1) and, without that face, 4 n / (n + 1)^2, with 0.5 % beyond them for five
// standard errors of at most 0.1 %: what is 0.7 % beyond is found in 97 of 100 cases.
TEST(Taught, MetersUnderACasterThatTouchesThem) {
  constexpr double n = 1.5, lx = 1000, air = lx * 2 * n / (n * n + 1), contact = lx * 4 * n / ((n + 1) * (n + 1));
  Scene scene;
  scene.add(quad({-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0}), matte(0));
  scene.add(box({-0.2, -0.2, 0}, {0.2, 0.2, 0.02}), glass(n));
  scene.add_directional({0, 0, -1}, lx);
  const Sensor meters = scene.add_meters(grid_about({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.2, 6), {0, 0, 1});
  const auto s = scene.render({.method = UPS_METHOD_UPS, .iterations = 256, .light_paths = 1u << 16}).statistics(meters);
  measured("slab in contact: %.1f lx, with air %.1f, without %.1f", s.mean_lx, air, contact);
  EXPECT_LE(s.mean_standard_error_lx, 0.001 * s.mean_lx);
  EXPECT_GE(s.mean_lx, air * 0.995);
  EXPECT_LE(s.mean_lx, contact * 1.005);
}

// A luminous opening of 0.6 mm, of an LED or of a file in another unit, is a point from half a metre on:
// its intensity by the inverse square to 0.1 % at a standard error of at most 0.02 %, five of which make a false alarm
// (P(|t_15| > 5) = 1.6e-4), by next-event estimation and hits.
TEST(Taught, OpeningsOf600MicrometresAreAsPoints) {
  const double intensity = 100;
  for (const char* opening :
       {"0.0006 0.0006 0", "-0.0006 -0.0006 0", "-0.0006 -0.0006 -0.0006", "0.0006 0.0006 0.0006"}) {
    Scene scene;
    const bool flat = std::string(opening).back() == '0' && opening[std::string(opening).size() - 2] == ' ';
    const auto lambertian = [=](double, double gamma) {
      return intensity * (flat ? std::max(0.0, std::cos(gamma)) : 1);
    };
    const Profile profile = parse(scene.context(), ies_text(lambertian, {0}, steps(1, 180), opening));
    scene.add_luminaire(profile.get(), {0, 0, 2}, {0, 0, -1}, true);
    scene.add(quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), matte(0));
    std::vector<double> expected;
    std::vector<P3> at;
    for (const P3& p : {P3{0, 0, 1.2}, P3{0, 0, 1.5}, P3{0, 0, 0}, P3{1, 0.5, 0.5}, P3{0.3, -0.4, 1}}) {
      const P3 d = P3{0, 0, 2} - p;
      at.push_back(p);
      expected.push_back(intensity * (flat ? d.z / length(d) : 1) * d.z / std::pow(length(d), 3));
    }
    const Sensor meters = scene.add_meters(at, {0, 0, 1});
    for (const ups_method method : eye_methods) {
      const auto r = scene.render({.method = method, .iterations = 64, .light_paths = 1u << 12}).readings(meters);
      for (size_t i = 0; i < at.size(); ++i) {
        expect_within(r[i].illuminance_lx, r[i].standard_error_lx, expected[i], 1e-3, 2e-4,
                      opening + (method_name(method) + (", meter " + std::to_string(i))));
      }
    }
  }
}

}  // namespace
}  // namespace ups::test
