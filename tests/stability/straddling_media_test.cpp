// What is in several media at once: emitters of one mesh that lie in water and in air, cells that a water's surface
// crosses. Each place has its own medium, by light paths and by eye paths.
#include "../support/expect_same.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

constexpr double absorption = 0.5;
ups_material_desc absorbing(double ior) {
  ups_material_desc m = glass(ior);
  std::fill(std::begin(m.absorption_per_m_rgb), std::end(m.absorption_per_m_rgb), float(absorption));
  return m;
}
Shape lamp_at(const P3& p) { return quad(p - P3{0.1, 0.1, 0}, {0, 0.2, 0}, {0.2, 0, 0}); }  // shines down

// Two lamps of one mesh, one of them in a block that absorbs and does not bend light, and cells under both (before: light
// paths of the other had the block's absorption over 3 m, exp(-1.5), or none of it within). By expect_pair: 0.5 % or three
// standard errors of the difference, which is at most 0.2 %: 1 % is found in 97 of 100 cases.
TEST(Taught, LampsOfOneMeshInWaterAndInAir) {
  for (const bool water_first : {true, false}) {
    Scene scene;
    scene.add(box({-4, -1, -0.1}, {-2, 1, 2.5}), absorbing(1));
    scene.add(quad({-6, -4, 0}, {12, 0, 0}, {0, 8, 0}), matte(0));
    Shape lamps = lamp_at(water_first ? P3{-3, 0, 2} : P3{3, 0, 3});
    lamps.append(lamp_at(water_first ? P3{3, 0, 3} : P3{-3, 0, 2}));
    scene.add(lamps, emitter(1000));
    const Sensor cells = scene.add_cells({{3, 0, 0.01}, {-3, 0, 0.01}}, {{0, 0, 1}, {0, 0, 1}},
                                         {{1, 0, 0}, {1, 0, 0}}, 1, 1);
    const auto read = [&](ups_method method, uint32_t light_paths) {
      return scene.render({.method = method, .iterations = 80, .light_paths = light_paths}).readings(cells);
    };
    const auto pt = read(UPS_METHOD_PATH_TRACING, 0), lt = read(UPS_METHOD_LIGHT_TRACING, 1u << 16),
               ups = read(UPS_METHOD_UPS, 1u << 12);
    for (size_t i = 0; i < 2; ++i)
      for (const auto& other : {lt, ups}) {
        const Estimate a{"PT", pt[i].illuminance_lx, pt[i].standard_error_lx},
            b{"other", other[i].illuminance_lx, other[i].standard_error_lx};
        EXPECT_LE(std::hypot(a.standard_error, b.standard_error), 0.002 * a.mean) << i;
        expect_pair(a, b, (i ? "under water" : "in air") + std::string(water_first ? ", water first" : ""));
      }
  }
}

// A wall's cell that a surface of what absorbs and does not bend light crosses, its middle in air: a lamp in it. The mean
// of I cos exp(-a s) / d^2 over the cell, s as far as the way goes in it. At a standard error of 0.17 % an error of 1 % is
// found in 96 of 100 cases (expect_lx.h, with its false alarms).
TEST(Taught, CellsThatAWatersSurfaceCrosses) {
  constexpr double candela = 100, away = 2, height = 2, level = 2;
  const P3 lamp{0, 0, 1};
  for (const double end : {3.0, away}) {  // beyond the wall, and at it
    Scene scene;
    scene.add(box({-1.3, -3, -1}, {end, 3, level}), absorbing(1));
    scene.add_point_light(lamp, candela);
    const P3 middle{away, 0, level + 0.1};
    const Sensor cell = scene.add_cells({middle}, {{-1, 0, 0}}, {{0, 1, 0}}, 1, height);
    double expected = 0;
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const P3 p = middle + P3{0, (i + 0.5) / steps - 0.5, height * ((j + 0.5) / steps - 0.5)}, way = p - lamp;
        const double d = length(way), within = p.z <= level ? d : d * (level - lamp.z) / way.z;
        expected += candela * way.x / (d * d * d) * std::exp(-absorption * within) / (steps * steps);
      }
    for (const ups_method method : {UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_UPS}) {
      const auto r = scene.render({.method = method, .iterations = 144, .light_paths = 1u << 13}).readings(cell)[0];
      expect_lx(r, expected, quiet, method_name(method));
    }
  }
}

}  // namespace
}  // namespace ups::test
