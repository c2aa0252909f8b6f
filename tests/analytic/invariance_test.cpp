// What must not change a result: the number of threads (not a bit), the unit of length, the place of the scene.
#include <cstring>

#include "../support/expect_lx.h"

namespace ups::test {
namespace {

// Where light comes from. mixed: an area emitter, and candelas that grow with the square of the lengths.
enum class Lights { mixed, area, candela };

// A little of everything, lengths times `scale`, moved by `offset`.
struct Room {
  Scene scene;
  Sensor points, cells, camera;

  Room(int threads, double scale, const P3& offset, bool with_camera, Lights lights = Lights::mixed) : scene(threads) {
    const auto at = [&](double x, double y, double z) { return P3{x * scale, y * scale, z * scale} + offset; };
    const auto add = [&](const Shape& shape, const ups_material_desc& m) { scene.add(shape.scaled(scale), m, offset); };
    ups_material_desc tinted = glass(1.5);
    for (int i = 0; i < 3; ++i) tinted.absorption_per_m_rgb[i] = float((0.25 + 0.5 * i) / scale);
    add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), matte(0.6));
    add(box({2.5, 1.5, 0.25}, {3.5, 2.5, 1}), rough(UPS_MATERIAL_PLASTIC, 0.5, 0.3));
    add(icosphere({1, 1, 0.75}, 0.5, 2), tinted);
    if (lights != Lights::candela) add(quad({1.5, 1, 2.25}, {0, 1, 0}, {1, 0, 0}), emitter(500));
    const double intensity = lights == Lights::mixed ? 50 * scale * scale : 50;
    if (lights != Lights::area) scene.add_point_light(at(3, 1, 2), intensity);
    if (lights == Lights::candela) scene.add_spot(at(2, 2, 2.25), {0, -1, -1}, 2 * intensity, 0.25, 0.5);
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
                         ::testing::Values(UPS_METHOD_AUTO, UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL,
                                           UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_PPM,
                                           UPS_METHOD_SPPM, UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING),
                         [](const auto& i) {
                           return std::string(i.param == UPS_METHOD_AUTO ? "auto" : method_name(i.param));
                         });

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST_P(Invariance, ThreadsDoNotChangeABit) {
  Room one(1, 1, {}, true), two(2, 1, {}, true);
  const RenderOptions options{.method = GetParam(), .iterations = 6, .seed = 42, .flux_paths = 65536};
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

void expect_near(double value, double expected, const std::string& what) {
  EXPECT_NEAR(value, expected, 1e-6 * std::abs(expected)) << what;
}
// -1: not known.
double scaled(double factor, float error) { return error == -1 ? -1 : factor * double(error); }

// Every decision of `result` is that of `expected`, and every photometric quantity is `factor` times as large.
void expect_scaled(const Room& room, const Result& result, const Room& original, const Result& expected, double factor,
                   const std::string& what) {
  const ups_result_info a = result.info(), b = expected.info();
  EXPECT_EQ(a.rays, b.rays) << what;
  EXPECT_EQ(a.merges, b.merges) << what;
  EXPECT_EQ(a.connections, b.connections) << what;
  EXPECT_EQ(a.light_paths, b.light_paths) << what;
  EXPECT_EQ(a.eye_paths, b.eye_paths) << what;
  EXPECT_EQ(a.dropped_samples, b.dropped_samples) << what;
  for (const auto& [sensor, reference] :
       {std::pair(room.points, original.points), std::pair(room.cells, original.cells)}) {
    const auto x = result.readings(sensor), y = expected.readings(reference);
    for (size_t i = 0; i < x.size(); ++i) {
      const std::string meter = what + ", meter " + std::to_string(i);
      expect_near(x[i].illuminance_lx, factor * y[i].illuminance_lx, meter);
      expect_near(x[i].direct_lx, factor * y[i].direct_lx, meter + ", direct");
      expect_near(x[i].standard_error_lx, scaled(factor, y[i].standard_error_lx), meter + ", standard error");
      expect_near(x[i].bias_lx, factor * y[i].bias_lx, meter + ", bias");
      expect_near(x[i].error_bound_lx, scaled(factor, y[i].error_bound_lx), meter + ", bound");
    }
  }
  const Image x = result.image(room.camera), y = expected.image(original.camera);
  for (size_t i = 0; i < x.luminance.size(); ++i) {
    expect_near(x.luminance[i], factor * y.luminance[i], what + ", pixel " + std::to_string(i / 3));
    expect_near(x.standard_error[i], scaled(factor, y.standard_error[i]),
                what + ", error of pixel " + std::to_string(i / 3));
  }
}

// Powers of two are exact, so that every decision is the same and floats are rounded alike. Area emitters give the same
// lx, candela sources when their intensity grows with the square of the lengths, or else lx over that square. Where
// this was written all of it was the same to the last bit.
TEST_P(Invariance, UnitsOfLengthDoNotMatter) {
  const RenderOptions options{.method = GetParam(), .iterations = 6};
  for (const Lights lights : {Lights::mixed, Lights::area, Lights::candela}) {
    Room original(0, 1, {}, true, lights);
    const Result expected = original.scene.render(options);
    EXPECT_EQ(expected.info().merges > 0,
              (expected.info().techniques & (UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT)) != 0);
    for (const int power : {-10, 17}) {
      Room room(0, std::ldexp(1, power), {}, true, lights);
      const Result result = room.scene.render(options);
      expect_scaled(room, result, original, expected, lights == Lights::candela ? std::ldexp(1, -2 * power) : 1,
                    "lights " + std::to_string(int(lights)) + ", 2^" + std::to_string(power));
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
