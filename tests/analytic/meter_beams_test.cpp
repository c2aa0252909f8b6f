// Single beams of 100 lx across at 30, 60 and 90 degrees from the vertical, on meters of every kind: what they read is
// known in closed form. By light samples, where it is exact, and by merging, connections and hits apart, each with a
// beam that it can carry: of parallel light, of a small bright patch, of an emitter with extent.
#include "../support/expect_lx.h"
#include "../support/meter_response.h"

namespace ups::test {
namespace {

struct Case {
  ups_meter_kind kind;
  P3 normal;
  double lx[3];  // at 30, 60 and 90 degrees, of a beam from the azimuth of +x
};
constexpr double deg[] = {30, 60, 90};
constexpr Case cases[] = {{UPS_METER_PLANAR, {0, 0, 1}, {86.60254, 50, 0}},
                          {UPS_METER_CYLINDRICAL, {0, 0, 1}, {15.915494, 27.566445, 31.830989}},
                          {UPS_METER_CYLINDRICAL, {1, 2, -3}, {15.915494, 27.566445, 31.830989}},
                          {UPS_METER_SEMICYLINDRICAL, {3, 0, 1}, {31.830989, 55.132890, 63.661977}},
                          {UPS_METER_SEMICYLINDRICAL, {-1, 0, 0.2}, {0, 0, 0}},
                          {UPS_METER_SEMICYLINDRICAL, {0, -1, 0}, {15.915494, 27.566445, 31.830989}},
                          {UPS_METER_HEMISPHERICAL, {0, 0, 1}, {46.650635, 37.5, 25}},
                          {UPS_METER_HEMISPHERICAL, {-1, 0, -1}, {0, 0, 0}},
                          {UPS_METER_SPHERICAL, {0.1, 0.2, -1}, {25, 25, 25}},
                          {UPS_METER_VECTOR, {0, 0.5, 1}, {100, 100, 100}}};

P3 to_light(int angle) {
  const double eps = deg[angle] * pi_d / 180;
  return {std::sin(eps), 0, std::cos(eps)};
}
std::string name_of(const Case& c, int angle) {
  return "kind " + std::to_string(c.kind) + " at " + std::to_string(deg[angle]) + " degrees";
}

// Points are exact: one shadow ray. So are cells by eye paths: the field is uniform. Rounding is 1e-5.
TEST(MeterBeams, ByLightSamples) {
  for (int angle = 0; angle < 3; ++angle) {
    const P3 w = to_light(angle);
    Scene scene;
    scene.add(quad({-5, -5, -3}, {10, 0, 0}, {0, 10, 0}), matte(0));
    scene.add_directional(w * -1, 100);
    std::vector<std::array<Sensor, 2>> sets;
    for (const Case& c : cases) {
      scene.set_meter_kind(c.kind);
      const P3 across = normalize(cross(c.normal, {0.3, 1, 0.2}));
      sets.push_back({scene.add_meters({{0.2, 0.1, 0}}, c.normal),
                      scene.add_cells({{0.2, 0.1, 0}}, {c.normal}, {across}, 0.1, 0.2)});
    }
    const Result result = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 16});
    for (size_t i = 0; i < sets.size(); ++i) {
      const std::string what = name_of(cases[i], angle);
      for (const Sensor& meters : sets[i]) {
        const ups_meter_reading r = result.readings(meters)[0];
        EXPECT_NEAR(r.illuminance_lx, cases[i].lx[angle], 1e-3) << what;
        EXPECT_NEAR(r.direct_lx, cases[i].lx[angle], 1e-3) << what;
        EXPECT_NEAR(r.indirect_lx, 0, 1e-3) << what;
      }
      if (cases[i].kind != UPS_METER_VECTOR) {
        EXPECT_THROW(result.vectors(sets[i][0]), std::exception) << what;
        continue;
      }
      const ups_vector_reading v = result.vectors(sets[i][0])[0];
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(v.vector_lx[k], 100 * component(w, k), 1e-3) << what;
        EXPECT_EQ(v.standard_error_lx[k], 0) << what;
        EXPECT_LE(v.error_bound_lx[k], 0.01) << what;
      }
    }
  }
}

// By a technique with noise: 64 meters of each kind, their mean judged as expect_lx.h says, with its false alarms and
// what it finds: 1 % of what the kind reads. A reading below a tenth of the beam is judged as one of a tenth, so that
// 0.1 % of the beam is found where there is no light; a vector's components as its length.
class Beam {
 public:
  Scene scene;
  explicit Beam(int angle) : w(to_light(angle)), angle_(angle) {}
  const P3 w;

  void add_meters(double apart) {
    std::vector<P3> places;
    for (int i = 0; i < 64; ++i) places.push_back({apart * (i % 8 - 3.5), apart * (i / 8 - 3.5), 0});
    for (const Case& c : cases) {
      scene.set_meter_kind(c.kind);
      sets_.push_back(scene.add_meters(places, c.normal));
    }
  }
  // beam_lx: across it. expected: of a case, where the beam is so wide that it is not what the closed form says.
  template <class Expected>
  void expect(RenderOptions options, double beam_lx, const Expected& expected) {
    const double lx = beam_lx / 100;
    std::vector<P3> right;
    std::vector<double> sizes;
    for (const Case& c : cases) right.push_back(expected(c)), sizes.push_back(std::max(length(right.back()), 10.0));
    const auto noise_of = [&](const Result& r, size_t i) { return r.statistics(sets_[i]).mean_standard_error_lx / lx; };
    const Result result = render_until_quiet(scene, options, 8192, [&](const Result& r) {
      double most = 0;
      for (size_t i = 0; i < sets_.size(); ++i) most = std::max(most, noise_of(r, i) / (quiet * sizes[i]));
      return most;
    });
    for (size_t i = 0; i < sets_.size(); ++i) {
      const Case& c = cases[i];
      const std::string what = name_of(c, angle_) + ", " + std::to_string(options.iterations) + " iterations";
      const double noise = noise_of(result, i), allowed = std::max(relative_tolerance * sizes[i], sigmas * noise);
      // Where there is no light, none or few paths find any, and the error is not known.
      if (length(right[i]) >= 10) {
        EXPECT_GE(noise, 0) << what << ": no standard error";
      }
      EXPECT_LE(noise, quiet * sizes[i]) << what << ": too noisy to judge";
      if (c.kind != UPS_METER_VECTOR) {
        EXPECT_NEAR(result.statistics(sets_[i]).mean_lx / lx, right[i].x, allowed) << what << " +- " << noise;
        continue;
      }
      P3 sum;
      for (const ups_vector_reading& v : result.vectors(sets_[i]))
        sum = sum + P3{v.vector_lx[0], v.vector_lx[1], v.vector_lx[2]} * (1 / (64 * lx));
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(component(sum, k), component(right[i], k), allowed) << what << ", " << k;
    }
  }
  // As the closed form says.
  void expect(const RenderOptions& options, double beam_lx = 100) {
    expect(options, beam_lx,
           [this](const Case& c) { return c.kind == UPS_METER_VECTOR ? w * 100 : P3{c.lx[angle_], 0, 0}; });
  }

 private:
  int angle_;
  std::vector<Sensor> sets_;
};

class MeterBeams : public ::testing::TestWithParam<int> {};

// Photons of parallel light, where they cross the meters' discs.
TEST_P(MeterBeams, ByMerging) {
  Beam beam(GetParam());
  beam.scene.add(quad({-0.8, -0.8, -0.3}, {1.6, 0, 0}, {0, 1.6, 0}), matte(0));  // small: so is the sun's disc
  beam.scene.add_directional(beam.w * -1, 100);
  beam.add_meters(0.2);
  beam.expect({.method = UPS_METHOD_UPS,
               .iterations = 16,
               .merge_radius_m = 0.1,
               .light_paths = 1u << 17,
               .techniques = UPS_TECHNIQUE_MERGE});
}

// A square that faces the meters, whose middle is `far` away along the beam, as points x points of equal area.
struct Square {
  Shape shape;
  P3 w;
  double area;
  std::vector<P3> places;

  Square(const P3& to_light, double far, double side, int points) : w(to_light), area(side * side) {
    const P3 s{0, side, 0}, t = cross(w, s), corner = w * far + s * -0.5 + t * -0.5;
    shape = quad(corner, s, t);
    if (dot(shape.area_normal(0), w) > 0) shape = shape.flipped();
    for (int i = 0; i < points * points; ++i)
      places.push_back(corner + s * ((i % points + 0.5) / points) + t * ((i / points + 0.5) / points));
  }
  // Across the beam, of so many cd/m2; lx.
  double across(double luminance) const {
    double sum = 0;
    for (const P3& p : places) sum += std::pow(dot(p, w) / dot(p, p), 2);
    return luminance * area / double(places.size()) * sum;
  }
  // Of a case, where the beam has 100 lx across: the closed form of each point.
  P3 expected(const Case& c) const {
    const double luminance = 100 / across(1);
    P3 sum;
    for (const P3& p : places) {
      const P3 to = normalize(p);
      const double lx = luminance * area / double(places.size()) * dot(to, w) / dot(p, p);
      sum = sum + (c.kind == UPS_METER_VECTOR ? to * lx : P3{lx * response(c.kind, c.normal, to), 0, 0});
    }
    return sum;
  }
};

// A matte patch of 0.1 m, 2 m away, lit by a spot that stands aside and sheds no light on the meters. Its extent makes
// little of the closed forms, but where the horizon of a meter cuts it in halves.
TEST_P(MeterBeams, ByConnections) {
  constexpr double far = 2, rho = 0.8, cd = 1000;
  const int angle = GetParam();
  Beam beam(angle);
  const Square patch(beam.w, far, 0.1, 64);
  const P3 middle = beam.w * far, spot = middle + P3{0, 0.5, 0} + beam.w * -0.5;
  beam.scene.add(patch.shape, matte(rho));
  beam.scene.add_spot(spot, middle - spot, cd, 0.095, 0.1);  // the patch is seen within 0.091
  beam.add_meters(0);
  double lx = 0;  // on the patch
  for (const P3& p : patch.places)
    lx += cd * -dot(spot - p, beam.w) / std::pow(length(spot - p), 3) / double(patch.places.size());
  for (const Case& c : cases) {
    const bool is_cut = angle == 2 && (c.kind == UPS_METER_PLANAR || c.kind == UPS_METER_HEMISPHERICAL);
    if (c.kind != UPS_METER_VECTOR && !is_cut) {
      EXPECT_NEAR(patch.expected(c).x, c.lx[angle], 0.05) << name_of(c, angle);
    }
  }
  beam.expect({.method = UPS_METHOD_LIGHT_TRACING,
               .iterations = angle == 2 ? 448u : 288u,  // a horizon that halves the patch makes more noise
               .light_paths = 1u << 14,
               .techniques = UPS_TECHNIQUE_CONNECT},
              patch.across(rho * lx / pi_d), [&](const Case& c) { return patch.expected(c); });
}

// An emitter can be hit only if it has an extent: of 4 m, 2 m away, a sixth of all directions.
TEST_P(MeterBeams, ByEmitterHits) {
  Beam beam(GetParam());
  const Square square(beam.w, 2, 4, 256);
  beam.scene.add(square.shape, emitter(100));
  beam.add_meters(0);
  beam.expect({.method = UPS_METHOD_UPS, .iterations = 128, .techniques = UPS_TECHNIQUE_EMITTER_HIT},
              square.across(100), [&](const Case& c) { return square.expected(c); });
}

INSTANTIATE_TEST_SUITE_P(At, MeterBeams, ::testing::Values(0, 1, 2),
                         [](const auto& i) { return std::to_string(int(deg[i.param])) + "Degrees"; });

}  // namespace
}  // namespace ups::test
