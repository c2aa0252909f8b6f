// What must not change a result: the number of threads (not a bit), the unit of length, the place of the scene.
#include <cstring>

#include "../support/expect_lx.h"

namespace ups::test {
namespace {

// A little of everything, lengths times `scale`, moved by `offset`.
struct Room {
  Scene scene;
  Sensor points, cells, camera;

  Room(int threads, double scale, const P3& offset, bool with_camera) : scene(threads) {
    const auto at = [&](double x, double y, double z) { return P3{x * scale, y * scale, z * scale} + offset; };
    const auto add = [&](const Shape& shape, const ups_material_desc& m) { scene.add(shape.scaled(scale), m, offset); };
    add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), matte(0.6));
    add(box({2.5, 1.5, 0.25}, {3.5, 2.5, 1}), rough(UPS_MATERIAL_PLASTIC, 0.5, 0.3));
    add(icosphere({1, 1, 0.75}, 0.5, 2), glass(1.5));
    add(quad({1.5, 1, 2.25}, {0, 1, 0}, {1, 0, 0}), emitter(500));
    scene.add_point_light(at(3, 1, 2), 50 * scale * scale);
    std::vector<P3> positions;
    for (int i = 0; i < 9; ++i) positions.push_back(at(0.5 + i % 3 * 1.25, 0.5 + i / 3 * 0.75, i % 2 ? 0.0 : 1.5));
    points = scene.add_meters(positions, {0, 0, 1});
    cells = scene.add_cells({at(2, 0.5, 0), at(0.5, 2, 0)}, {{0, 0, 1}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 0}}, 0.5 * scale,
                            0.5 * scale);
    if (with_camera) camera = scene.add_camera(at(0.25, 0.25, 1.75), {1, 0.75, -0.25}, 24, 16, 1.2);
  }
};

class Invariance : public ::testing::TestWithParam<ups_method> {};
INSTANTIATE_TEST_SUITE_P(Methods, Invariance,
                         ::testing::Values(UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING,
                                           UPS_METHOD_LIGHT_TRACING, UPS_METHOD_PPM, UPS_METHOD_SPPM,
                                           UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING),
                         [](const auto& i) { return std::string(method_name(i.param)); });

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST_P(Invariance, ThreadsDoNotChangeABit) {
  Room one(1, 1, {}, true), two(2, 1, {}, true);
  const RenderOptions options{.method = GetParam(), .iterations = 6, .seed = 42};
  const Result a = one.scene.render(options), b = two.scene.render(options);
  EXPECT_EQ(a.info().threads, 1);
  EXPECT_EQ(b.info().threads, 2);
  EXPECT_TRUE(same_bits(a.readings(one.points), b.readings(two.points)));
  EXPECT_TRUE(same_bits(a.readings(one.cells), b.readings(two.cells)));
  EXPECT_TRUE(same_bits(a.image(one.camera).luminance, b.image(two.camera).luminance));
  EXPECT_TRUE(same_bits(a.image(one.camera).standard_error, b.image(two.camera).standard_error));
  EXPECT_EQ(a.info().rays, b.info().rays);
  EXPECT_EQ(a.info().absorbed_flux_lm, b.info().absorbed_flux_lm);
  EXPECT_GT(a.statistics(one.cells).mean_lx, 0);

  const Result repeated = one.scene.render(options),
               other = one.scene.render({.method = GetParam(), .iterations = 6, .seed = 43});
  EXPECT_TRUE(same_bits(a.readings(one.cells), repeated.readings(one.cells))) << "the same seed once more";
  EXPECT_FALSE(same_bits(a.readings(one.cells), other.readings(one.cells))) << "another seed";
}

// Powers of two are exact, so that every decision is the same: area emitters give the same lx, candela sources do when
// their intensity grows with the square of the lengths.
TEST_P(Invariance, UnitsOfLengthDoNotMatter) {
  const RenderOptions options{.method = GetParam(), .iterations = 6};
  Room reference(0, 1, {}, false);
  const Result expected = reference.scene.render(options);
  for (int power : {-10, 17}) {
    Room room(0, std::ldexp(1, power), {}, false);
    const Result result = room.scene.render(options);
    for (const auto& [sensor, original] :
         {std::pair(room.points, reference.points), std::pair(room.cells, reference.cells)}) {
      const auto a = result.readings(sensor), b = expected.readings(original);
      for (size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(a[i].illuminance_lx, b[i].illuminance_lx, 1e-5 * b[i].illuminance_lx)
            << "2^" << power << ", meter " << i;
    }
  }
}

// A building far from zero: 2^17 m east, 2^16 m north. Rounding moves surfaces by the error of the scene's own extent,
// which may turn single decisions, hence 0.1 % and not the last bit.
TEST_P(Invariance, PlaceDoesNotMatter) {
  const RenderOptions options{.method = GetParam(), .iterations = 6};
  Room here(0, 1, {}, false), far(0, 1, {131072, 65536, 16}, false);
  const Result a = here.scene.render(options), b = far.scene.render(options);
  EXPECT_NEAR(a.statistics(here.points).mean_lx, b.statistics(far.points).mean_lx,
              1e-3 * a.statistics(here.points).mean_lx);
  EXPECT_NEAR(a.statistics(here.cells).mean_lx, b.statistics(far.cells).mean_lx,
              1e-3 * a.statistics(here.cells).mean_lx);
}

}  // namespace
}  // namespace ups::test
