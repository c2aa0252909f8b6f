// Hazard 2: infinities and 0/0, from scenes that the API lets in: values at the ends of what it takes, shapes without
// area, normals without length. Result (support/result.h) fails where a value is not finite or a sample was dropped.
#include <random>

#include "../support/scene_builder.h"
#include "../support/figures.h"

#include <gtest/gtest.h>

namespace ups::test {
namespace {

class Extremes {
 public:
  explicit Extremes(uint32_t seed) : rng_(seed) {}
  bool chance(double p) { return uniform() < p; }
  double uniform() { return std::generate_canonical<double, 53>(rng_); }
  double any_of(std::initializer_list<double> values) {
    return values.begin()[size_t(uniform() * double(values.size()))];
  }

  ups_material_desc material() {
    const auto models = {UPS_MATERIAL_MATTE,   UPS_MATERIAL_MIRROR,  UPS_MATERIAL_METAL,   UPS_MATERIAL_PLASTIC,
                         UPS_MATERIAL_GLASS, UPS_MATERIAL_GLAZING, UPS_MATERIAL_DIFFUSER};
    ups_material_desc m = test::material(models.begin()[size_t(uniform() * double(models.size()))], 0.5);
    for (float& r : m.reflectance_rgb) r = float(any_of({0, 1e-38, 1e-6, 0.5, 1 - 6e-8, 1}));
    m.roughness = float(any_of({0, 1e-3, 5.5e-3, 0.01, 0.3, 1}));
    m.ior = float(any_of({1, 1.0000002, 1.00003, 1.001, 1.5, 2.5}));
    for (float& a : m.absorption_per_m_rgb) a = float(any_of({0, 0, 1e-30, 1, 1e6, 1e30}));
    if (chance(0.2)) m.metallic = float(any_of({0, 1e-7, 0.5, 1}));
    if (chance(0.2))
      for (float& l : m.luminance_cd_m2) l = float(any_of({0, 1e-30, 1, 1e9}));
    return m;
  }
  // A shape in the room, at a size from 1e-6 to 1 m; slivers, doubled vertices, normals that are zero or point back.
  Shape shape() {
    const double size = any_of({1e-6, 1e-3, 0.1, 1}), thin = any_of({0, 1e-7, 1e-3, 1, 1});
    const P3 at{3 * uniform(), 3 * uniform(), 2 * uniform()};
    Shape s = chance(0.4) ? box(at, at + P3{size, size, size * std::max(thin, 1e-6)})
              : chance(0.5) ? icosphere(at, size, 1)
                            : quad(at, {size, 0, 0}, {0, size * thin, size * any_of({0, 1e-6, 1})});
    if (chance(0.3))
      for (const P3& v : s.vertices)
        s.normals.push_back(chance(0.2) ? P3{} : normalize(P3{0.1, 0.2, v.z - at.z + 0.01}));
    return s;
  }
  P3 place() { return {4 * uniform(), 4 * uniform(), 2.8 * uniform()}; }

 private:
  std::mt19937_64 rng_;
};

void fill(Scene& scene, Extremes& e) {
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), e.material());
  for (int i = 0; i < 5; ++i) scene.add(e.shape(), e.material());
  scene.add_point_light(e.place(), e.any_of({1e-30, 1, 1e12}));
  if (e.chance(0.5))
    scene.add_spot(e.place(), {e.uniform(), 1e-7, -1}, e.any_of({1e-6, 1e9}), 0.0, e.any_of({1e-3, 0.5}));
  if (e.chance(0.3)) scene.add_directional({1e-7, 0, -1}, e.any_of({1e-20, 1e5}));
  scene.add_meters({e.place(), e.place(), {2, 2, 0}}, {1e-3, 0, 1});
  scene.add_cells({{1, 1, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, e.any_of({1e-5, 0.5}), 0.5);
  scene.add_camera(e.place(), {1, 0.5, -0.2}, 8, 8, e.any_of({1e-3, 1, 2.5}), true);
}

// What is refused is said to be; of what is not, no value is other than finite and no sample is dropped: below 1e-7 of
// them, at 95 %, where none of 3e7 rays' is, as in the full form.
TEST(Hazard02, ScenesOfExtremesGiveFiniteReadings) {
  constexpr ups_method methods[] = {UPS_METHOD_AUTO, UPS_METHOD_UPS, UPS_METHOD_PPM, UPS_METHOD_LIGHT_TRACING,
                                    UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING};
  const uint32_t cases = fast_or_full(40u, 150u);
  size_t rendered = 0;
  uint64_t rays = 0;
  for (uint32_t i = 0; i < cases; ++i) {
    Extremes e(i);
    Scene scene;
    try {
      fill(scene, e);
      const Result r = scene.render({.method = methods[i % std::size(methods)], .iterations = 4, .light_paths = 512});
      rays += r.info().rays, ++rendered;
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find("ups_"), 0u) << "case " << i << ": " << what;  // a status, not a value
      EXPECT_EQ(what.find(ups_status_name(UPS_ERROR_INTERNAL)), std::string::npos) << "case " << i << ": " << what;
    }
  }
  measured("%zu of %u scenes rendered, %.3g rays", rendered, cases, double(rays));
  EXPECT_GT(rendered, cases / 2);
  EXPECT_TRUE(!full() || rays > 30'000'000) << rays;
}

}  // namespace
}  // namespace ups::test
