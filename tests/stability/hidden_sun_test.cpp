// Taught by building: a sun that walls and roof keep out is still the brightest thing that a room's surfaces face. What
// its light would be must not crowd out the lamps': in the choice of emitters, in that of images in mirrors, and in which
// edges of a path get a shadow ray.
#include "../support/expect_lx.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

// Closed, with a mirror and a pane in one plane; one lamp.
void furnish(Scene& scene) {
  scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0.5));
  scene.add(quad({0.01, 0.5, 0.5}, {0, 1.2, 0}, {0, 0, 1.6}), mirror(0.9));
  scene.add_point_light({2, 1.5, 2.4}, 40);
}

// Cells, whose light by way of the mirror is sampled, without the sun and with it: by eye paths the same numbers, but for
// light that is found by way of another random number; by all techniques and by `auto` the same mean within 1 %. Of the
// means' noise, 0.15 % at most, the difference's is 0.21 %: a right engine fails with P(|t_30| > 1 / 0.21 - 2.04) = 1.2 %
// where the noise is at its limit; what is off by 1 % passes with 2.5 %. (Three quarters of the
// light paths start from the sun.)
TEST(Taught, AHiddenSunDrownsNoLamps) {
  Scene without, with;
  furnish(without), furnish(with);
  with.add_directional(normalize(P3{-0.7, 0.1, -0.7}), 1e5);
  std::vector<P3> at;
  for (int i = 0; i < 24; ++i) at.push_back({0.5 + 0.6 * (i % 6), 0.4 + 0.7 * (i / 6), 0.02});
  const std::vector<P3> up(at.size(), P3{0, 0, 1}), along(at.size(), P3{1, 0, 0});
  const Sensor plain = without.add_cells(at, up, along, 0.3, 0.3), sunny = with.add_cells(at, up, along, 0.3, 0.3);
  constexpr uint32_t eye = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_MIRROR_SAMPLE;
  struct Way {
    const char* name;
    ups_method method;
    uint32_t techniques;
    double most;  // of the noise with the sun over that without
  };
  for (const Way& way : {Way{"eye paths", UPS_METHOD_UPS, eye, 1.1}, Way{"all techniques", UPS_METHOD_UPS, 0, 1.7},
                         Way{"auto", UPS_METHOD_AUTO, 0, 2.5}}) {
    const RenderOptions options{
        .method = way.method, .iterations = 224, .light_paths = 1u << 11, .techniques = way.techniques};
    const auto x = without.render(options).statistics(plain), y = with.render(options).statistics(sunny);
    const double s = std::hypot(x.mean_standard_error_lx, y.mean_standard_error_lx);
    EXPECT_LE(y.mean_standard_error_lx, 0.0015 * y.mean_lx) << way.name << ": too noisy to judge";
    EXPECT_LE(y.mean_standard_error_lx, way.most * x.mean_standard_error_lx) << way.name;
    EXPECT_GE(0.01 * x.mean_lx - std::abs(x.mean_lx - y.mean_lx), 2.04 * s)
        << way.name << ": " << x.mean_lx << " and " << y.mean_lx << " +- " << s;
    measured("%s: noise %.2f times that without the sun", way.name,
             y.mean_standard_error_lx / x.mean_standard_error_lx);
  }
}

}  // namespace
}  // namespace ups::test
