// The light of ray files, against what their rays add up to. Rays are drawn with fixed seeds; where a meter's expected
// value is summed over the file's own rays, the file's noise is in both and the standard error of the render decides:
// at 4 of them, from 16 batches, one comparison fails a right engine with probability 0.12 %.
#include <functional>
#include <random>

#include "../support/expect_lx.h"
#include "../support/image_mean.h"
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

// Rays that cross a cell of the plane `depth` below.
struct Crossing {
  size_t count = 0;
  double lx = 0;
};
Crossing crossing(const std::vector<FileRay>& rays, const Cell& c, double depth) {
  Crossing out;
  for (const FileRay& r : rays) {
    const double t = -depth / r.direction[2];
    const double x = 1e-3 * r.p_mm[0] + t * r.direction[0] - c.x, y = 1e-3 * r.p_mm[1] + t * r.direction[1] - c.y;
    if (2 * std::max(std::abs(x), std::abs(y)) > c.width) continue;
    ++out.count;
    out.lx += r.flux_lm / (c.width * c.width);
  }
  return out;
}

TEST(RayEmitter, LightsCellsAsItsRaysDoAndAsTheClosedFormWithinTheirNoise) {
  const auto rays = lambertian_disc(200000, 0.2, 1000, 1);
  Scene scene;
  const Profile profile = parse_rays(scene.context(), rays);
  scene.add_luminaire(profile.get(), {0, 0, 2}, {0, 0, -1}, true);
  const std::vector<Cell> places = {{0, 0, 0.5}, {1, 0, 0.5}, {-1, 1, 0.5}, {0, -2, 0.5}};
  std::vector<P3> centers;
  for (const Cell& c : places) centers.push_back({c.x, c.y, 0});
  const Sensor cells = scene.add_cells(centers, std::vector<P3>(4, {0, 0, 1}), std::vector<P3>(4, {1, 0, 0}), 0.5, 0.5);
  for (ups_method method : {UPS_METHOD_UPS, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_PPM}) {
    const auto readings = scene.render({.method = method, .iterations = 128}).readings(cells);
    for (size_t i = 0; i < places.size(); ++i) {
      const Crossing own = crossing(rays, places[i], 2);
      const std::string what = std::string(method_name(method)) + ", cell " + std::to_string(i);
      EXPECT_LE(std::abs(readings[i].illuminance_lx - own.lx), sigmas * readings[i].standard_error_lx) << what;
      EXPECT_LE(readings[i].standard_error_lx, 0.03 * own.lx) << what;
      const double exact =
          mean_over(places[i], [](double x, double y) { return disc_lx(1000, 0.2, 2, std::hypot(x, y)); });
      EXPECT_NEAR(own.lx / exact, 1, sigmas / std::sqrt(double(own.count))) << what;
    }
  }
}

// A point meter merges the rays within a radius: of 16 of them each has the noise of at least 800 rays, 3.5 %, their
// mean 0.9 %; 4 of those, and a bias of density estimation that the meters state themselves.
TEST(RayEmitter, LightsPointMetersWithinTheNoiseOfItsRays) {
  Scene scene;
  const Profile profile = parse_rays(scene.context(), lambertian_disc(200000, 0.2, 1000, 2));
  scene.add_luminaire(profile.get(), {0, 0, 2}, {0, 0, -1}, true);
  std::vector<P3> points;
  for (int i = 0; i < 16; ++i) points.push_back({0.25 * (i % 4), 0.25 * (i / 4), 0});
  const Sensor meters = scene.add_meters(points, {0, 0, 1});
  const auto readings =
      scene.render({.method = UPS_METHOD_UPS, .iterations = 16, .merge_radius_m = 0.2}).readings(meters);
  double ratio = 0, bias = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double exact = disc_lx(1000, 0.2, 2, std::hypot(points[i].x, points[i].y));
    EXPECT_NEAR(readings[i].illuminance_lx / exact, 1, 4 * 0.035 + 4 * readings[i].standard_error_lx / exact) << i;
    ratio += readings[i].illuminance_lx / exact / 16;
    bias += std::abs(readings[i].bias_lx) / exact / 16;
  }
  EXPECT_NEAR(ratio, 1, 4 * 0.009 + bias);
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
                            {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, 1, 1);
    camera = scene.add_camera({0.5, 0.5, 1.5}, {1, 1, -0.4}, 8, 8, 0.8);
  }
};

// With a ray emitter no technique is gated off: the point light's light keeps its weights, and the two add up. Cells by
// path tracing and light tracing, which share no technique with each other; cameras by splats alone against all, over 8
// seeds: P(|t_7| > 4) = 0.5 %.
TEST(RayEmitter, MethodsAgreeAndOtherEmittersKeepTheirLight) {
  Room rays(true, false), point(false, true), both(true, true);
  const Result by_light = rays.scene.render({.method = UPS_METHOD_LIGHT_TRACING, .iterations = 64, .seed = 5});
  const Result by_eye = point.scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 64, .seed = 6});
  const Result together = both.scene.render({.method = UPS_METHOD_UPS, .iterations = 64, .seed = 7});
  const Result alone = rays.scene.render({.method = UPS_METHOD_UPS, .iterations = 64, .seed = 8});
  const auto lt = by_light.readings(rays.cells), pt = by_eye.readings(point.cells), sum = together.readings(both.cells),
             ups = alone.readings(rays.cells);
  for (size_t i = 0; i < sum.size(); ++i) {
    const auto noise = [&](std::initializer_list<float> errors) {
      double s2 = 0;
      for (float e : errors) s2 += double(e) * e;
      return sigmas * std::sqrt(s2);
    };
    EXPECT_NEAR(ups[i].illuminance_lx, lt[i].illuminance_lx,
                noise({ups[i].standard_error_lx, lt[i].standard_error_lx}) + 0.005 * lt[i].illuminance_lx)
        << i;
    const double expected = lt[i].illuminance_lx + pt[i].illuminance_lx;
    EXPECT_NEAR(sum[i].illuminance_lx, expected,
                noise({sum[i].standard_error_lx, lt[i].standard_error_lx, pt[i].standard_error_lx}) + 0.005 * expected)
        << i;
    EXPECT_LT(sum[i].standard_error_lx, 0.03 * expected);
  }
  const Mean splats = image_mean(rays.scene, rays.camera, {.method = UPS_METHOD_LIGHT_TRACING, .iterations = 8});
  const Mean all = image_mean(rays.scene, rays.camera, {.method = UPS_METHOD_UPS, .iterations = 8});
  EXPECT_NEAR(splats.value, all.value,
              sigmas * std::hypot(splats.standard_error, all.standard_error) + 0.005 * all.value);
  EXPECT_LT(all.standard_error, 0.02 * all.value);
  const ups_result_info info = together.info();
  EXPECT_NEAR(info.emitted_flux_lm, 3000 + 400 * pi_d, 1);
  EXPECT_NEAR(info.absorbed_flux_lm + info.escaped_flux_lm, info.emitted_flux_lm, 0.01 * info.emitted_flux_lm);
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

// From a point its light is the far field's, which next-event estimation finds without noise.
TEST(RayEmitter, FromAPointItIsItsFarField) {
  Scene scene;
  const Profile profile = parse_rays(scene.context(), lambertian_disc(20000, 0.1, 3000, 4));
  scene.add_luminaire(profile.get(), {0, 0, 5}, {0, 0, -1}, false);
  const float down[3] = {0, 0, -1};
  float intensity = 0;
  check(ups_profile_eval(profile.get(), down, 1, &intensity), "ups_profile_eval");
  EXPECT_NEAR(intensity, 3000 / pi_d, 0.15 * 3000 / pi_d);
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
