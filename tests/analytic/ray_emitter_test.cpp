// The light of ray files, against what their rays add up to. Rays are drawn with fixed seeds; where a meter's expected
// value is summed over the file's own rays, the file's noise is in both and the standard error of the render decides.
// Readings of much of the light, or their means, are judged by expect_lx.h, with its false alarms: 1 % is found. Single
// small ones beside them show what is wrong in one place, by 5 to 15 %.
#include <functional>
#include <numeric>
#include <random>

#include "../support/expect_same.h"
#include "../support/ray_bytes.h"
#include "ies_text.h"

namespace ups::test {
namespace {

Profile parse_rays(ups_context* context, const std::vector<FileRay>& rays) {
  const std::string bytes = tm25_bytes(rays);
  ups_profile* profile = nullptr;
  check(ups_profile_parse(context, bytes.data(), bytes.size(), UPS_PROFILE_AUTO, &profile), "ups_profile_parse");
  return {profile, ups_profile_destroy};
}

// From a disc about the origin, cosine-distributed towards -z; together `lumens`.
std::vector<FileRay> lambertian_disc(int count, double radius_m, double lumens, uint32_t seed) {
  std::mt19937 engine(seed);
  const auto uniform = [&] { return std::generate_canonical<double, 53>(engine); };
  std::vector<FileRay> rays;
  for (int i = 0; i < count; ++i) {
    const double r = 1000 * radius_m * std::sqrt(uniform()), a = 2 * pi_d * uniform();
    const double s = std::sqrt(uniform()), phi = 2 * pi_d * uniform();
    rays.push_back({{r * std::cos(a), r * std::sin(a), 0},
                    {s * std::cos(phi), s * std::sin(phi), -std::sqrt(1 - s * s)},
                    lumens / count});
  }
  return rays;
}

// The same with a noise of next to nothing where many rays count: points of a lattice in four dimensions.
std::vector<FileRay> even_lambertian_disc(int count, double radius_m, double lumens) {
  const double root = 1.1673039782614187;  // of x^5 = x + 1
  const double steps[4] = {1 / root, std::pow(root, -2), std::pow(root, -3), std::pow(root, -4)};
  std::vector<FileRay> rays;
  for (int i = 0; i < count; ++i) {
    const auto place = [&](int k) { return std::fmod(0.5 + i * steps[k], 1.0); };
    const double r = 1000 * radius_m * std::sqrt(place(0)), a = 2 * pi_d * place(1), s = std::sqrt(place(2)),
                 phi = 2 * pi_d * place(3);
    rays.push_back({{r * std::cos(a), r * std::sin(a), 0},
                    {s * std::cos(phi), s * std::sin(phi), -std::sqrt(1 - s * s)},
                    lumens / count});
  }
  return rays;
}

// Illuminance of the plane at a depth below a Lambertian disc, off its axis (view factor of a disc from a parallel
// element; Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-13).
double disc_lx(double lumens, double a, double depth, double off) {
  const double h2 = depth * depth, r2 = off * off, x = h2 + r2 + a * a;
  return lumens / (pi_d * a * a) * 0.5 * (1 - (h2 + r2 - a * a) / std::sqrt(x * x - 4 * a * a * r2));
}

struct Cell {
  double x, y, width;
};

double mean_over(const Cell& c, const std::function<double(double, double)>& f) {
  constexpr int n = 32;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) sum += f(c.x + c.width * ((i + 0.5) / n - 0.5), c.y + c.width * ((j + 0.5) / n - 0.5));
  return sum / (n * n);
}

// Where a ray crosses the plane `depth` below.
P3 crossing(const FileRay& r, double depth) {
  const double t = -depth / r.direction[2];
  return {1e-3 * r.p_mm[0] + t * r.direction[0], 1e-3 * r.p_mm[1] + t * r.direction[1], 0};
}
struct Crossing {
  size_t count = 0;
  double lx = 0;
};
Crossing crossing(const std::vector<FileRay>& rays, const Cell& c, double depth) {
  Crossing out;
  for (const FileRay& r : rays) {
    const P3 at = crossing(r, depth);
    if (2 * std::max(std::abs(at.x - c.x), std::abs(at.y - c.y)) > c.width) continue;
    ++out.count;
    out.lx += r.flux_lm / (c.width * c.width);
  }
  return out;
}

// Four cells of 0.5 m, and one of 5 m that two thirds of the light fall on. The file's own noise, of a binomial count,
// is 0.15 % there: four of it are 0.6 %, and an error of 1 % would be found in 99 cases of 100. It is part of the errors
// that are told; the reading itself is of all of the file's rays, each as often as the others, and differs from theirs
// by what the paths' numbers leave, less than 0.12 %: four of it are allowed.
TEST(RayEmitter, LightsCellsAsItsRaysDoAndAsTheClosedFormWithinTheirNoise) {
  const auto rays = lambertian_disc(200000, 0.2, 1000, 1);
  Scene scene;
  const Profile profile = parse_rays(scene.context(), rays);
  scene.add_luminaire(profile.get(), {0, 0, 2}, {0, 0, -1}, true);
  const std::vector<Cell> places = {{0, 0, 0.5}, {1, 0, 0.5}, {-1, 1, 0.5}, {0, -2, 0.5}, {0, 0, 5}};
  std::vector<Sensor> cells;
  for (const Cell& c : places)
    cells.push_back(scene.add_cells({{c.x, c.y, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, c.width, c.width));
  for (ups_method method : {UPS_METHOD_UPS, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_PPM}) {
    const Result result = scene.render({.method = method, .iterations = 128});
    for (size_t i = 0; i < places.size(); ++i) {
      const Crossing own = crossing(rays, places[i], 2);
      const std::string what = std::string(method_name(method)) + ", cell " + std::to_string(i);
      const ups_meter_reading r = result.readings(cells[i])[0];
      const double of_file = std::sqrt((1 - double(own.count) / double(rays.size())) / double(own.count));
      expect_lx(r, own.lx, one_of(i == 4 ? 2 * of_file : 0.05), what);
      EXPECT_NEAR(r.illuminance_lx / own.lx, 1, i == 4 ? 0.005 : 0.1) << what;
      EXPECT_GE(r.standard_error_lx, 0.5 * of_file * own.lx) << what << ": the file's noise is part of it";
    }
  }
  for (const Cell& place : places) {
    const Crossing own = crossing(rays, place, 2);
    const double exact = mean_over(place, [](double x, double y) { return disc_lx(1000, 0.2, 2, std::hypot(x, y)); });
    const double left_out = 1 - double(own.count) / double(rays.size());
    EXPECT_NEAR(own.lx / exact, 1, sigmas * std::sqrt(left_out / double(own.count))) << place.width;
  }
}

// A disc of rays, 0.2 m in radius and 1000 lm, above 64 meters that merge them within 0.2 m.
struct LitMeters {
  Scene scene;
  Sensor meters;
  std::vector<double> exact;
  double mean = 0;
  LitMeters(const std::vector<FileRay>& rays, double height) {
    const Profile profile = parse_rays(scene.context(), rays);
    scene.add_luminaire(profile.get(), {0, 0, height}, {0, 0, -1}, true);
    std::vector<P3> points;
    for (int i = 0; i < 64; ++i) points.push_back({0.4 * (i % 8) - 1.4, 0.4 * (i / 8) - 1.4, 0});
    meters = scene.add_meters(points, {0, 0, 1});
    for (const P3& p : points) exact.push_back(disc_lx(1000, 0.2, height, std::hypot(p.x, p.y)));
    mean = std::accumulate(exact.begin(), exact.end(), 0.0) / double(exact.size());
  }
  Result render(uint32_t iterations) {
    return scene.render(
        {.method = UPS_METHOD_UPS, .iterations = iterations, .merge_radius_m = 0.2, .light_paths = 1u << 15});
  }
};

// Light paths that are eight times as many as the file's rays repeat each eight times: a meter's disc must not be
// narrowed to few of them, as if there were more light. Bounds of a few hundred rays, 3 to 5 %; the mean over 64 meters
// has 0.2 %, measured over 20 sets of rays that lie evenly, of which 3.3 are allowed (a false alarm in 250; what is
// told takes them for random, and is more): 1 % is found in 95 cases of 100 (before: 8.8 % more, one meter seven times
// its light, and bounds of 500 %).
TEST(RayEmitter, PathsThatRepeatItsRaysNarrowNoMetersDisc) {
  LitMeters lit(even_lambertian_disc(200000, 0.2, 1000), 2);
  const Result result = lit.render(48);
  const auto readings = result.readings(lit.meters);
  for (size_t i = 0; i < readings.size(); ++i) {
    const double exact = lit.exact[i], bound = readings[i].error_bound_lx;
    EXPECT_LE(std::abs(readings[i].illuminance_lx - exact), std::min(2 * bound, 0.25 * exact)) << i;
  }
  const auto s = result.statistics(lit.meters);
  EXPECT_LE(s.median_relative_error_bound, 0.2);
  EXPECT_NEAR(s.mean_lx / lit.mean, 1, 0.0066);
  EXPECT_GE(s.mean_standard_error_lx, 0.002 * lit.mean);
  EXPECT_LE(s.mean_standard_error_lx, 0.006 * lit.mean);
}

// A point meter merges the rays within a radius: each has the noise of some hundred rays, 5 %; the mean of 64 of them,
// which take half of the light, finds 1 %: these rays lie more evenly than by chance, so that their mean has 0.12 %,
// measured over sets of rays, of which five are allowed; what is told takes them for random, and is more.
TEST(RayEmitter, LightsPointMetersWithinTheNoiseOfItsRays) {
  LitMeters lit(even_lambertian_disc(1000000, 0.2, 1000), 1);
  const Result result = lit.render(32);
  const auto readings = result.readings(lit.meters);
  for (size_t i = 0; i < readings.size(); ++i)
    EXPECT_NEAR(readings[i].illuminance_lx / lit.exact[i], 1,
                4 * 0.05 + 4 * readings[i].standard_error_lx / lit.exact[i]) << i;
  const auto s = result.statistics(lit.meters);
  expect_lx(s.mean_lx, s.mean_standard_error_lx, lit.mean, one_of(0.006), "mean");
  EXPECT_NEAR(s.mean_lx / lit.mean, 1, 0.006);
}

// Luminaire at 1 m; the ray leaves it sideways and down, meets the mirror floor at x = 0.75 and the plane z = 1 at 1.5.
TEST(RayEmitter, OneRayLandsWhereTheMirrorSendsIt) {
  Scene scene;
  scene.add(quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), mirror(0.9));
  const Profile profile = parse_rays(scene.context(), {{{0, 0, 0}, {0.6, 0, -0.8}, 5}});
  scene.add_luminaire(profile.get(), {0, 0, 1}, {0, 0, -1}, true);
  const Sensor cells = scene.add_cells({{1.5, 0, 1}, {-1.5, 0, 1}, {0, 1.5, 1}}, std::vector<P3>(3, {0, 0, -1}),
                                       std::vector<P3>(3, {1, 0, 0}), 0.2, 0.2);
  for (ups_method method : {UPS_METHOD_UPS, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_SPPM}) {
    const Result result = scene.render({.method = method, .iterations = 16});
    const auto readings = result.readings(cells);
    EXPECT_NEAR(readings[0].illuminance_lx, 5 * 0.9 / 0.04, 1e-3) << method_name(method);
    EXPECT_EQ(readings[1].illuminance_lx, 0);
    EXPECT_EQ(readings[2].illuminance_lx, 0);
    const ups_result_info info = result.info();
    EXPECT_NEAR(info.emitted_flux_lm, 5, 1e-5);
    EXPECT_NEAR(info.absorbed_flux_lm, 0.5, 1e-5);
    EXPECT_NEAR(info.escaped_flux_lm, 4.5, 1e-5);
  }
}

// A room with the rays of a disc, a point light, or both.
struct Room {
  Scene scene;
  Profile profile{nullptr, ups_profile_destroy};
  Sensor cells, meters, camera;
  Room(bool rays, bool point) {
    scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.6));
    profile = parse_rays(scene.context(), lambertian_disc(20000, 0.1, 3000, 3));
    if (rays) scene.add_luminaire(profile.get(), {2.5, 2, 2.5}, {0.2, 0, -1}, true);
    if (point) scene.add_point_light({1, 1, 2}, 100);
    cells = scene.add_cells({{1, 1, 0}, {3, 2, 0}, {2, 4, 1.5}}, {{0, 0, 1}, {0, 0, 1}, {0, -1, 0}},
                            {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, 2, 2);
    camera = scene.add_camera({0.5, 0.5, 1.5}, {1, 1, -0.4}, 8, 8, 0.8);
  }
};

// With a ray emitter no technique is gated off: the point light's light keeps its weights, and the two add up. Cells by
// path tracing and light tracing, which share no technique with each other, by the mean over them. All have the same
// rays, and 16 iterations take each of them: over 8 seeds their noise is that of the paths alone, at most 0.15 %
// (expect_same.h: 1 % is found in 95 cases of 100, a false alarm has P(|t_14| > 3) = 1 %, both at that limit). Cameras
// by splats alone against all, over 8 seeds: P(|t_14| > 4) = 0.13 %; the error of the difference is at most 0.3 %, so
// that 2 % of the picture are found in 99 cases of 100.
TEST(RayEmitter, MethodsAgreeAndOtherEmittersKeepTheirLight) {
  Room rays(true, false), point(false, true), both(true, true);
  const auto mean_of_cells = [](const char* name, Room& room, ups_method method, uint64_t first) {
    std::vector<double> found;
    for (uint64_t seed = first; seed < first + less_with_effort(8, 2); ++seed)
      found.push_back(
          room.scene.render({.method = method, .iterations = 16, .seed = seed}).statistics(room.cells).mean_lx);
    return estimate(name, mean_of(found));
  };
  // Each with seeds of its own: they have no noise in common.
  const Estimate of_rays = mean_of_cells("rays by light tracing", rays, UPS_METHOD_LIGHT_TRACING, 1),
                 of_point = mean_of_cells("point by path tracing", point, UPS_METHOD_PATH_TRACING, 11),
                 sum = mean_of_cells("both by UPS", both, UPS_METHOD_UPS, 21),
                 ups = mean_of_cells("rays by UPS", rays, UPS_METHOD_UPS, 31);
  expect_same({of_rays, ups}, 0, "rays");
  const double error = std::hypot(of_rays.standard_error, of_point.standard_error);
  expect_same({sum, {"rays and point apart", of_rays.mean + of_point.mean, error}}, 0, "sum");
  const Mean splats = image_mean(rays.scene, rays.camera, {.method = UPS_METHOD_LIGHT_TRACING, .iterations = 8});
  const Mean all = image_mean(rays.scene, rays.camera, {.method = UPS_METHOD_UPS, .iterations = 8});
  const double noise = std::hypot(splats.standard_error, all.standard_error);
  EXPECT_LE(noise, 0.003 * all.value) << "too noisy to judge";
  EXPECT_NEAR(splats.value, all.value, std::max(sigmas * noise, 0.005 * all.value));
  const Result together = both.scene.render({.method = UPS_METHOD_UPS, .iterations = 64, .seed = 7});
  const ups_result_info info = together.info();
  EXPECT_NEAR(info.emitted_flux_lm, 3000 + 400 * pi_d, 1);
  expect_lx(info.absorbed_flux_lm + info.escaped_flux_lm, info.flux_balance_standard_error_lm, info.emitted_flux_lm,
            quiet, "flux, lm");
}

// Two paths that draw the same ray begin at the same place, and where floors are dark most photons are those: the
// radius of merging is found from photons apart (before: 1.4 times the light). Meters look down at what the floor sends
// back, which is known ray by ray: flux rho / pi h^2 / d^4. Of 16 iterations each has a share of the rays, together
// all: over 12 seeds their noise is that of the paths alone. P(|t_11| > 4) = 0.2 % where it decides; 1 % is found in 95
// cases of 100 or more.
TEST(RayEmitter, PhotonsInOnePlaceSayNothingOfHowDenseTheyAre) {
  constexpr double rho = 0.15, above = 0.7;
  Scene scene;
  scene.add(quad({-8, -4, 0}, {16, 0, 0}, {0, 8, 0}), matte(rho));
  const auto rays = even_lambertian_disc(20000, 0.2, 3000);
  const Profile lamp = parse_rays(scene.context(), rays);
  scene.add_luminaire(lamp.get(), {0, 0, 2}, {0, 0, -1}, true);
  std::vector<P3> places;
  for (int i = 0; i < 60; ++i) places.push_back({0.1 * (i - 29.5), 0.6, above});
  const Sensor meters = scene.add_meters(places, {0, 0, -1});
  double expected = 0;
  for (const FileRay& r : rays) {
    const P3 at = crossing(r, 2);
    if (std::abs(at.x) > 8 || std::abs(at.y) > 4) continue;
    for (const P3& p : places)
      expected += r.flux_lm * rho / pi_d * std::pow(above / dot(p - at, p - at), 2) / double(places.size());
  }
  std::vector<double> found;
  for (uint64_t seed = 1; seed <= less_with_effort(12, 2); ++seed)
    found.push_back(
        scene.render({.method = UPS_METHOD_UPS, .iterations = 16, .seed = seed}).statistics(meters).mean_lx);
  const Mean mean = mean_of(found);
  expect_lx(mean.value, mean.standard_error, expected, quiet, "mean");
}

TEST(RayEmitter, PathTracingSaysThatItIsDark) {
  Room room(true, false);
  const Result pt = room.scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 4});
  for (const auto& r : pt.readings(room.cells)) EXPECT_EQ(r.illuminance_lx, 0);
  const std::string warnings = pt.text(UPS_TEXT_WARNINGS);
  for (const char* sensor : {"camera", "area meter"})
    EXPECT_NE(warnings.find(std::string(" - ") + sensor + " is missing"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("rays of a file"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("20000 rays of a file"), std::string::npos) << warnings;
  const Result automatic = room.scene.render({.method = UPS_METHOD_AUTO, .iterations = 4});
  for (const auto& r : automatic.readings(room.cells)) EXPECT_GT(r.illuminance_lx, 0);
  EXPECT_EQ(automatic.text(UPS_TEXT_WARNINGS).find("is missing"), std::string::npos);
}

// From a point its light is the far field's, which next-event estimation finds without noise. Over the 60 degrees about
// the nadir the mean of its table, weighed as flux is, is that of Lambert's law but for 0.1 %, which steps blur of rays
// that lie evenly: 1 % is found for certain.
TEST(RayEmitter, FromAPointItIsItsFarField) {
  Scene scene;
  const Profile profile = parse_rays(scene.context(), even_lambertian_disc(20000, 0.1, 3000));
  scene.add_luminaire(profile.get(), {0, 0, 5}, {0, 0, -1}, false);
  const float down[3] = {0, 0, -1};
  float intensity = 0;
  check(ups_profile_eval(profile.get(), down, 1, &intensity), "ups_profile_eval");
  double mean = 0;
  for (int i = 0; i < 256; ++i) {
    const double sine = std::sqrt(0.75 * (i + 0.5) / 256), c = 2.4 * i, cosine = std::sqrt(1 - sine * sine);
    const float direction[3] = {float(sine * std::cos(c)), float(sine * std::sin(c)), float(-cosine)};
    float cd = 0;
    check(ups_profile_eval(profile.get(), direction, 1, &cd), "ups_profile_eval");
    mean += double(cd) / cosine / (3000 / pi_d) / 256;
  }
  EXPECT_NEAR(mean, 1, 0.005);
  EXPECT_NEAR(intensity, 3000 / pi_d, 0.015 * 3000 / pi_d);  // the table's first step blurs 0.7 % of it
  const Sensor meter = scene.add_meters({{0, 0, 0}}, {0, 0, 1});
  const Result result = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 4});
  EXPECT_NEAR(result.readings(meter)[0].illuminance_lx, intensity / 25, 1e-5 * intensity);
  EXPECT_NEAR(result.info().emitted_flux_lm, 3000, 0.01);
}

TEST(RayEmitter, TakesFluxDimmingColourAndPlace) {
  Scene scene;
  const Profile profile = parse_rays(scene.context(), {{{100, 0, 0}, {0, 0, -1}, 5}, {{100, 0, 0}, {0, 0, 1}, 5}});
  auto d = make_desc<ups_luminaire_desc>(ups_luminaire_desc_init);
  d.profile = profile.get();
  d.flux_lm = 80;
  d.dimming = 0.5;
  d.color_rgb[0] = 2;
  const auto m = facing({1, 2, 3}, {1, 0, 0});  // local -z along x; the rays start 100 mm along local x
  std::copy(m.begin(), m.end(), d.to_world);
  ups_luminaire_id id;
  check(ups_scene_add_luminaire(scene.get(), &d, &id), "ups_scene_add_luminaire");
  const P3 start = P3{1, 2, 3} + P3{m[0], m[4], m[8]} * 0.1;
  const Sensor cells = scene.add_cells({start + P3{1, 0, 0}, start - P3{1, 0, 0}}, {{-1, 0, 0}, {1, 0, 0}},
                                       {{0, 1, 0}, {0, 1, 0}}, 0.02, 0.02);
  const auto r = scene.render({.method = UPS_METHOD_UPS, .iterations = 16}).readings(cells);
  EXPECT_NEAR(r[0].illuminance_lx, 20 / 0.0004, 1e-3 * 20 / 0.0004);
  EXPECT_NEAR(r[1].illuminance_lx, 20 / 0.0004, 1e-3 * 20 / 0.0004);
}

}  // namespace
}  // namespace ups::test
