// Hazards 6 and 7: absolute epsilons, which show in other units of length, and coordinates far from the origin.
#include "../support/mixed_room.h"

namespace ups::test {
namespace {

void expect_near(double value, double expected, const std::string& what) {
  compared(value, expected, 0, what);
  EXPECT_NEAR(value, expected, 1e-6 * std::abs(expected)) << what;
}
// -1: not known.
double scaled(double factor, float error) { return error == -1 ? -1 : factor * double(error); }

// Every decision of `result` is that of `expected`, and every photometric quantity is `factor` times as large.
void expect_scaled(const MixedRoom& room, const Result& result, const MixedRoom& original, const Result& expected,
                   double factor, const std::string& what) {
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

class Hazard06 : public ::testing::TestWithParam<ups_method> {};
INSTANTIATE_TEST_SUITE_P(Methods, Hazard06, ::testing::ValuesIn(every_method), name_of_method);

// Powers of two are exact, so that every decision is the same and floats are rounded alike. Area emitters give the same
// lx, candela sources when their intensity grows with the square of the lengths, or else lx over that square. Where
// this was written all of it was the same to the last bit.
TEST_P(Hazard06, UnitsOfLengthDoNotMatter) {
  const RenderOptions options{.method = GetParam(), .iterations = 6};
  for (const Lights lights : {Lights::mixed, Lights::area, Lights::candela}) {
    MixedRoom original(0, 1, {}, true, lights);
    const Result expected = original.scene.render(options);
    EXPECT_EQ(expected.info().merges > 0,
              (expected.info().techniques & (UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT)) != 0);
    for (const int power : {-10, 17}) {
      MixedRoom room(0, std::ldexp(1, power), {}, true, lights);
      const Result result = room.scene.render(options);
      expect_scaled(room, result, original, expected, lights == Lights::candela ? std::ldexp(1, -2 * power) : 1,
                    "lights " + std::to_string(int(lights)) + ", 2^" + std::to_string(power));
    }
  }
}

class Hazard07 : public ::testing::TestWithParam<ups_method> {};
INSTANTIATE_TEST_SUITE_P(Methods, Hazard07, ::testing::ValuesIn(every_method), name_of_method);

// A building far from zero: some 131 km east, 66 km north, by no multiple of anything that coordinates are rounded to.
// Rounding moves surfaces by the error of the scene's own extent, which may turn single decisions, hence 0.1 % and not
// the last bit; light straight from its sources is as exact at each meter. In the full form so is all light at each
// meter: of more paths a single decision is less.
TEST_P(Hazard07, PlaceDoesNotMatter) {
  const RenderOptions options{.method = GetParam(), .iterations = fast_or_full(6u, 96u)};
  MixedRoom here(0, 1, {}, false), far(0, 1, {131072.37, 65536.71, 16.13}, false);
  const Result a = here.scene.render(options), b = far.scene.render(options);
  const auto x = a.readings(here.points), y = b.readings(far.points);
  for (size_t i = 0; i < x.size(); ++i)
    if (x[i].direct_lx > 0)
      expect_ratio(y[i].direct_lx, x[i].direct_lx, 1e-3, "direct light, meter " + std::to_string(i));
    else
      EXPECT_EQ(y[i].direct_lx, 0) << "meter " << i;
  for (size_t i = 0; i < x.size() && full(); ++i)
    if (x[i].illuminance_lx > 0)
      expect_ratio(y[i].illuminance_lx, x[i].illuminance_lx, 1e-3, "all light, meter " + std::to_string(i));
  expect_ratio(b.statistics(far.points).mean_lx, a.statistics(here.points).mean_lx, 1e-3, "mean over points");
  expect_ratio(b.statistics(far.cells).mean_lx, a.statistics(here.cells).mean_lx, 1e-3, "mean over cells");
}

}  // namespace
}  // namespace ups::test
