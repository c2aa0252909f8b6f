// Means over discs, over triangles of surfaces and over texels of a lightmap, beneath a square Lambertian lamp, whose
// illuminance at a point has a closed form: by each technique that can find a cell's light, alone. And in a closed room
// what all surfaces receive together, for any shape: flux / (1 - reflectance).
#include <cstring>
#include <functional>

#include "../support/expect_lx.h"

namespace ups::test {
namespace {

struct Way {
  const char* name;
  uint32_t techniques;
  uint32_t iterations = 192;
};
// A lamp's light straight to a meter. Eye paths meet the lamp by chance; they cost the least.
constexpr Way direct_ways[] = {{"emitter hits", UPS_TECHNIQUE_EMITTER_HIT, 1344},
                               {"light samples", UPS_TECHNIQUE_LIGHT_SAMPLE, 512},
                               {"landings", UPS_TECHNIQUE_SENSOR_HIT, 448},
                               {"all", 0}};

Result render(Scene& scene, const Way& way, uint32_t share = 1, uint32_t light_paths = 1u << 15) {
  return scene.render({.method = UPS_METHOD_UPS,
                       .iterations = way.iterations / share,
                       .light_paths = light_paths,
                       .techniques = way.techniques});
}

class UnderALamp : public ::testing::Test {
 protected:
  static constexpr double luminance = 5000;
  const std::vector<P3> lamp = {{-0.8, -0.8, 1}, {-0.8, 0.8, 1}, {0.8, 0.8, 1}, {0.8, -0.8, 1}};  // faces down

  void SetUp() override { scene.add(quad(lamp[0], lamp[1] - lamp[0], lamp[3] - lamp[0]), emitter(luminance)); }
  double lx_at(const P3& p, const P3& n) const { return luminance * polygon_irradiance_factor(lamp, p, n); }
  double mean_over_triangle(const P3& a, const P3& b, const P3& c) const {
    constexpr int n = 60;
    const P3 normal = normalize(cross(b - a, c - a));
    double sum = 0;
    int count = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
        for (const double at : {1 / 3.0, 2 / 3.0}) {  // a small triangle, and its neighbour that makes up the square
          if (at > 0.5 && i + j + 1 >= n) continue;
          sum += lx_at(a + (b - a) * ((i + at) / n) + (c - a) * ((j + at) / n), normal);
          ++count;
        }
    return sum / count;
  }
  // By expect_lx.h, with its false alarms and what it finds. Shapes that are larger than texels need a quarter of the
  // iterations for it.
  static constexpr double noise = quiet;
  static constexpr uint32_t large = 4;
  void expect_means(const Sensor& meters, const std::vector<double>& expected, uint32_t share) {
    for (const Way& way : direct_ways) {
      const auto readings = render(scene, way, share).readings(meters);
      for (size_t i = 0; i < expected.size(); ++i)
        expect_lx(readings[i], expected[i], noise, std::string(way.name) + ", meter " + std::to_string(i));
    }
  }
  Scene scene;
};

TEST_F(UnderALamp, DiscsMeasureTheirMean) {
  constexpr double radius = 0.35;
  const std::vector<P3> centers = {{0.2, 0.1, 0.2}, {-0.5, 0.3, 0.4}},
                        normals = {{0, 0, 1}, normalize({0.5, -0.2, 1})};
  const Sensor discs = scene.add_discs(centers, normals, 2 * radius);
  std::vector<double> expected;
  for (size_t i = 0; i < centers.size(); ++i) {
    constexpr int rings = 40, sectors = 80;
    const P3 s = normalize(cross({0, 1, 0}, normals[i])), t = cross(normals[i], s);
    double sum = 0;
    for (int r = 0; r < rings; ++r)
      for (int k = 0; k < sectors; ++k) {
        const double distance = radius * std::sqrt((r + 0.5) / rings), phi = 2 * pi_d * (k + 0.5) / sectors;
        sum += lx_at(centers[i] + s * (distance * std::cos(phi)) + t * (distance * std::sin(phi)), normals[i]);
      }
    expected.push_back(sum / (rings * sectors));
  }
  expect_means(discs, expected, large);
  const auto places = scene.places(discs);
  EXPECT_EQ(places[1].position_m[0], centers[1].x);
  EXPECT_NEAR(double(places[1].area_m2), pi_d * radius * radius, 1e-6);
  EXPECT_EQ(places[1].valid, 1);
  EXPECT_EQ(places[1].triangle, UINT32_MAX);
}

// Two triangles that lean against each other, long and slanting, and one of no area between them.
Shape roof() {
  return {.vertices = {{-0.7, -0.3, 0.1}, {0.6, -0.5, 0.05}, {0.1, 0.6, 0.4}, {0.9, 0.5, 0.2}},
          .triangles = {{0, 1, 2}, {1, 1, 3}, {2, 1, 3}},
          .uvs = {{0.05f, 0.1f}, {0.9f, 0.2f}, {0.3f, 0.8f}, {0.95f, 0.9f}}};
}

TEST_F(UnderALamp, TrianglesMeasureTheirMeanWhereverTheirInstanceGoes) {
  const Shape shape = roof();
  const ups_instance_id instance = scene.add(shape, matte(0));
  const Sensor meters = scene.add_surface_meters({instance}, 3), backs = scene.add_surface_meters({instance}, 3, true);
  const auto expect_at = [&](const std::function<P3(const P3&)>& place, bool mirrored) {
    std::vector<double> expected;
    const auto corner = [&](size_t t, int k) { return place(shape.corner(t, mirrored && k > 0 ? 3 - k : k)); };
    for (const size_t t : {size_t(0), size_t(2)})
      expected.push_back(mean_over_triangle(corner(t, 0), corner(t, 1), corner(t, 2)));
    for (const Way& way : direct_ways) {
      const Result result = render(scene, way, large);
      const auto readings = result.readings(meters);
      expect_lx(readings[0], expected[0], noise, std::string(way.name) + ", triangle 0");
      expect_lx(readings[2], expected[1], noise, std::string(way.name) + ", triangle 2");
      EXPECT_EQ(readings[1].illuminance_lx, 0);
      EXPECT_EQ(readings[1].standard_error_lx, 0);
      for (const auto& r : result.readings(backs)) EXPECT_EQ(r.illuminance_lx, 0) << "the lamp shines on fronts alone";
      EXPECT_EQ(result.statistics(meters).count, 3u);
      EXPECT_NEAR(result.statistics(meters).min_lx, std::min(expected[0], expected[1]), 0.02 * expected[0]);
    }
    const auto places = scene.places(meters);
    for (const size_t t : {size_t(0), size_t(2)}) {
      const P3 n = cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)) * 0.5,
               center = (corner(t, 0) + corner(t, 1) + corner(t, 2)) * (1 / 3.0);
      EXPECT_NEAR(double(places[t].area_m2), length(n), 1e-6);
      EXPECT_NEAR(places[t].position_m[2], center.z, 1e-6);
      EXPECT_NEAR(double(places[t].normal[0]), normalize(n).x, 1e-6);
      EXPECT_EQ(places[t].triangle, t);
    }
    EXPECT_EQ(places[1].valid, 0);
    EXPECT_EQ(places[1].area_m2, 0);
  };
  expect_at([](const P3& p) { return p; }, false);
  // Mirrored, stretched and moved: the front stays in front.
  const double m[12] = {-1.3, 0, 0, 0.2, 0, 0.8, 0, -0.1, 0, 0, 1, -0.2};
  check(ups_scene_set_transform(scene.get(), instance, m), "ups_scene_set_transform");
  expect_at([](const P3& p) { return P3{-1.3 * p.x + 0.2, 0.8 * p.y - 0.1, p.z - 0.2}; }, true);
}

// Of the texels that triangles lie in, by points spread evenly over each in UV. An error of 1 % of any is found.
TEST_F(UnderALamp, TexelsMeasureTheMeanOverWhatLiesInThem) {
  constexpr uint32_t width = 4, height = 3;
  constexpr int n = 200;
  const Shape shape = roof();
  const Sensor map = scene.add_lightmap({scene.add(shape, matte(0))}, width, height);
  std::vector<double> flux(width * height), area(width * height);
  for (uint32_t texel = 0; texel < width * height; ++texel)
    for (int i = 0; i < n * n; ++i) {
      const double u = (texel % width + (i % n + 0.5) / n) / width, v = (texel / width + (i / n + 0.5) / n) / height;
      for (const size_t t : {size_t(0), size_t(2)}) {
        const auto uv = [&](int k) {
          const auto& at = shape.uvs[shape.triangles[t][size_t(k)]];
          return P3{double(at[0]), double(at[1]), 0};
        };
        const P3 p{u, v, 0};
        const double whole = cross(uv(1) - uv(0), uv(2) - uv(0)).z, b = cross(p - uv(0), uv(2) - uv(0)).z / whole,
                     c = cross(uv(1) - uv(0), p - uv(0)).z / whole;
        if (b < 0 || c < 0 || b + c > 1) continue;
        const P3 at = shape.corner(t, 0) * (1 - b - c) + shape.corner(t, 1) * b + shape.corner(t, 2) * c;
        const double part = length(shape.area_normal(t)) * 2 / std::abs(whole) / (width * height * n * n);
        area[texel] += part;
        flux[texel] += part * lx_at(at, normalize(shape.area_normal(t)));
      }
    }
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  const auto places = scene.places(map);
  double all = 0;
  size_t invalid = 0, shared = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    all += double(places[i].area_m2);
    invalid += places[i].valid == 0;
    shared += places[i].valid && std::abs(double(places[i].normal[2])) < 1 && area[i] > 0;
    EXPECT_NEAR(double(places[i].area_m2), area[i], 2e-3 * (area[i] + 0.1)) << i;
  }
  EXPECT_NEAR(all, shape.area(), 1e-6);
  EXPECT_GE(invalid, 1u) << "a texel in the corner holds nothing";
  EXPECT_GE(shared, 6u);
  double whole_flux = 0, whole_area = 0;
  for (size_t i = 0; i < places.size(); ++i) whole_flux += flux[i], whole_area += area[i];
  for (const Way& way : direct_ways) {
    const Result result = render(scene, {way.name, way.techniques, 3 * way.iterations});
    const auto s = result.statistics(map);  // by area
    expect_lx(s.mean_lx, s.mean_standard_error_lx, whole_flux / whole_area, noise, std::string(way.name) + ", mean");
    const auto readings = result.readings(map);
    for (size_t i = 0; i < readings.size(); ++i)
      if (!places[i].valid)
        EXPECT_EQ(readings[i].illuminance_lx, 0) << i;
      else if (places[i].area_m2 > 0.01f)
        expect_lx(readings[i], flux[i] / area[i], quiet,
                  std::string(way.name) + ", texel " + std::to_string(i));
  }
}

// Six walls, their places in UV apart from each other.
Shape unwrapped_room() {
  Shape room;
  const P3 size{3, 2, 2.5}, ends[] = {{0, 0, 0}, size};
  const auto add = [&](const P3& corner, const P3& a, const P3& b) {  // faces inwards
    const size_t wall = room.vertices.size() / 4;
    const double u = double(wall % 3) / 3, v = double(wall / 3) / 2, wide = 0.3, high = 0.46;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      room.vertices.push_back(corner + a * x + b * y);
      room.uvs.push_back({float(u + x * wide + 0.01), float(v + y * high + 0.01)});
    }
    const uint32_t i = uint32_t(4 * wall);
    room.triangles.insert(room.triangles.end(), {{i, i + 1, i + 2}, {i, i + 2, i + 3}});
  };
  const P3 x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
  add(ends[0], x, y), add(ends[0], y, z), add(ends[0], z, x);
  add(ends[1], y * -1, x * -1), add(ends[1], z * -1, y * -1), add(ends[1], x * -1, z * -1);
  return room;
}

// Each reading's share of the flux is its area's: the mean by area is as sure as the flux. Ten comparisons by
// expect_lx.h, with its false alarms and what it finds.
TEST(ClosedRoom, SurfacesReceiveTheLampsFluxAndWhatTheyReflect) {
  constexpr double rho = 0.5, candela = 100;
  constexpr uint32_t few = 16;  // batches of one iteration each
  constexpr Way ways[] = {{"light samples", UPS_TECHNIQUE_LIGHT_SAMPLE, few},
                          {"connections", UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT, few},
                          {"merges", UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_MERGE, few},
                          {"landings", UPS_TECHNIQUE_SENSOR_HIT, few},
                          {"all", 0, few}};
  const Shape room = unwrapped_room();
  const double expected = 4 * pi_d * candela / (1 - rho) / room.area();
  for (const bool texels : {false, true}) {  // apart: fewer meters have more eye paths each
    Scene scene;
    const ups_instance_id walls = scene.add(room, matte(rho));
    scene.add_point_light({1.2, 0.7, 1.6}, candela);
    const Sensor meters = texels ? scene.add_lightmap({walls}, 30, 20) : scene.add_surface_meters({walls}, 12);
    for (const Way& way : ways) {
      const Result result = render(scene, way, 1, 1u << 13);
      const auto s = result.statistics(meters);
      expect_lx(s.mean_lx, s.mean_standard_error_lx, expected, quiet,
                std::string(way.name) + (texels ? ", texels" : ", triangles"));
      double flux = 0;
      const auto places = scene.places(meters);
      const auto readings = result.readings(meters);
      for (size_t i = 0; i < places.size(); ++i)
        flux += double(places[i].area_m2) * double(readings[i].illuminance_lx);
      EXPECT_NEAR(flux, s.mean_lx * room.area(), 1e-5 * flux) << way.name;
    }
  }
}

TEST(ClosedRoom, ReadsTheSameOnSurfacesForAnyThreads) {
  std::vector<std::vector<ups_meter_reading>> readings[2];
  for (const int threads : {1, 3}) {
    Scene scene(threads);
    const ups_instance_id walls = scene.add(unwrapped_room(), matte(0.6));
    scene.add_point_light({1.2, 0.7, 1.6}, 100);
    const Sensor sets[] = {scene.add_surface_meters({walls}, 12), scene.add_lightmap({walls}, 30, 20),
                           scene.add_discs({{1, 1, 1}}, {{0, 0, 1}}, 0.4)};
    const Result result = scene.render({.method = UPS_METHOD_UPS, .iterations = 4});
    for (const Sensor& s : sets) readings[threads / 2].push_back(result.readings(s));
  }
  for (size_t s = 0; s < 3; ++s) {
    const auto &one = readings[0][s], &three = readings[1][s];
    EXPECT_EQ(std::memcmp(one.data(), three.data(), one.size() * sizeof one[0]), 0) << s;
  }
}

}  // namespace
}  // namespace ups::test
