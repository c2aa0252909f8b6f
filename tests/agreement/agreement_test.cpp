// Do methods that share little code agree? Where no closed form exists, path tracing, bidirectional path tracing, UPS,
// light tracing and the three kinds of photon mapping must measure the same light. Two scenes: area emitters with
// glossy, plastic and glass objects, where path tracing is complete; a point light among diffuse surfaces, where every
// method is.
//
// Readings are compared in pairs: |a - b| <= 4 combined standard errors + the reported biases. Errors come from 16
// batches each; for the difference of two readings P(|t_30| > 4) = 4e-4. 16 to 96 comparisons: a right engine fails
// with probability below 4 %. These find what is wrong at a single meter, of some per cent; what is wrong with the
// light as a whole is found by the means over the meters, to 1 % in 95 of 100 cases and more (expect_same.h, with its
// false alarms). Image means are over 8 seeds: P(|t_14| > 4) = 1.3e-3, 3 to 6 pairs: below 1 %; the error of a
// difference is at most 0.35 %, so that 2 % are found in 95 of 100 cases or more. Seeds are fixed: a test that passes
// once passes always.
#include "../support/expect_same.h"

namespace ups::test {
namespace {

using Readings = std::vector<ups_meter_reading>;

void expect_each_agrees(const std::vector<std::pair<ups_method, Readings>>& all, double largest_relative_error) {
  for (size_t i = 0; i < all.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      for (size_t m = 0; m < all[i].second.size(); ++m) {
        const auto &a = all[i].second[m], &b = all[j].second[m];
        const std::string what = std::string(method_name(all[i].first)) + " and " + method_name(all[j].first) +
                                 ", meter " + std::to_string(m);
        ASSERT_GE(a.standard_error_lx, 0) << what;
        ASSERT_GE(b.standard_error_lx, 0) << what;
        const double s = std::hypot(a.standard_error_lx, b.standard_error_lx),
                     difference = a.illuminance_lx - b.illuminance_lx;
        EXPECT_LE(s, largest_relative_error * b.illuminance_lx) << what << ": too noisy to judge";
        EXPECT_LE(std::abs(difference), sigmas * s + std::abs(a.bias_lx) + std::abs(b.bias_lx))
            << what << ": " << a.illuminance_lx << " and " << b.illuminance_lx << " lx, " << difference / s
            << " standard errors";
      }
}

// Each meter, and their mean.
void expect_agreement(Scene& scene, const Sensor& meters, const std::vector<Trial>& trials,
                      double largest_relative_error) {
  std::vector<std::pair<ups_method, Readings>> each;
  std::vector<Estimate> means;
  for (const Trial& t : trials) {
    const Result r = render_quietly(scene, t.options, {meters});
    each.emplace_back(t.options.method, r.readings(meters));
    means.push_back(estimate(t.name, r, meters));
  }
  expect_each_agrees(each, largest_relative_error);
  expect_same(means, 0, "mean");
}

// Images do not report the bias of merging; with a small radius there is nothing to report.
constexpr double image_merge_radius = 0.02;

void expect_same_image_mean(Scene& scene, const Sensor& camera, const std::vector<ups_method>& methods,
                            uint32_t iterations, uint32_t light_paths = 0) {
  constexpr double largest_relative_error = 0.0035;
  std::vector<Mean> means;
  for (ups_method m : methods)
    means.push_back(image_mean(scene, camera,
                               {.method = m,
                                .iterations = m == UPS_METHOD_PATH_TRACING ? 2 * iterations : iterations,
                                .merge_radius_m = image_merge_radius,
                                .light_paths = m == UPS_METHOD_PATH_TRACING ? 0 : light_paths}));
  for (size_t i = 0; i < means.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      const double s = std::hypot(means[i].standard_error, means[j].standard_error);
      const std::string what = std::string(method_name(methods[i])) + " and " + method_name(methods[j]);
      EXPECT_LE(s, largest_relative_error * means[j].value) << what << ": too noisy to judge";
      EXPECT_LE(std::abs(means[i].value - means[j].value), sigmas * s)
          << what << ": " << means[i].value << " and " << means[j].value << " cd/m^2";
    }
}

std::vector<P3> grid(double z) {
  std::vector<P3> out;
  for (int i = 0; i < 16; ++i) out.push_back({0.5 + i % 4, 0.4 + 0.7333 * (i / 4), z});
  return out;
}

void add_room(Scene& scene) {
  Shape walls = box({0, 0, 0}, {4, 3, 2.5}).flipped();
  walls.triangles.erase(walls.triangles.begin(), walls.triangles.begin() + 2);  // without its floor
  scene.add(walls, matte(0.6));
}

class AreaLitRoom : public ::testing::Test {
 protected:
  void SetUp() override {
    add_room(scene);
    scene.add(quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}), rough(UPS_MATERIAL_PLASTIC, 0.4, 0.3));
    scene.add(box({2.6, 1.8, 0}, {3.4, 2.6, 0.7}), rough(UPS_MATERIAL_METAL, 0.8, 0.4));
    scene.add(icosphere({1.2, 1.3, 0.45}, 0.4, 2), glass(1.5));
    scene.add(quad({1.4, 0.9, 2.4}, {0, 1.2, 0}, {1.2, 0, 0}), emitter(1000, 0.5));
  }
  Scene scene;
};

TEST_F(AreaLitRoom, MetersAgree) {
  const Sensor meters = scene.add_meters(grid(0.9), {0, 0, 1});
  expect_agreement(scene, meters,
                   {trial(UPS_METHOD_UPS, 48), trial(UPS_METHOD_BIDIRECTIONAL, 48),
                    trial(UPS_METHOD_PATH_TRACING, 128),
                    trial(UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING, 144, 1u << 15, 0.15)}, 0.015);  // next to no bias
}

TEST_F(AreaLitRoom, ImagesAgree) {
  const Sensor camera = scene.add_camera({0.3, 0.2, 1.6}, {1, 0.8, -0.5}, 32, 24, 1.1);
  expect_same_image_mean(scene, camera, {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING}, 28);
}

TEST_F(AreaLitRoom, ImagesByPhotonMappingAgree) {
  const Sensor camera = scene.add_camera({0.3, 0.2, 1.6}, {1, 0.8, -0.5}, 32, 24, 1.1);
  expect_same_image_mean(
      scene, camera,
      {UPS_METHOD_PATH_TRACING, UPS_METHOD_PPM, UPS_METHOD_SPPM, UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING}, 44, 1u << 15);
}

// A hundred small panels that eye paths can hit, facing all ways, and a screen that lets light through: both walks must
// know the same probability of choosing each of them.
class RoomOfManyPanels : public ::testing::Test {
 protected:
  void SetUp() override {
    add_room(scene);
    scene.add(quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}), matte(0.3));
    ups_material_desc screen = material(UPS_MATERIAL_DIFFUSER, 0.3);
    for (float& t : screen.transmittance_rgb) t = 0.5f;
    scene.add(quad({1.5, 0.3, 1.2}, {0, 2.4, 0}, {0.3, 0, 0.9}), screen);
    scene.add(quad({2.2, 0.5, 1.3}, {1, 0, 0}, {0, 1, 0.2}), rough(UPS_MATERIAL_METAL, 0.8, 0.4));
    for (int i = 0; i < 100; ++i) {
      const P3 p{0.2 + 0.4 * (i % 10), 0.15 + 0.3 * (i / 10), 2.2 + 0.02 * (i % 7)};
      const double turn = 0.9 * i;
      scene.add(quad(p, {0.1 * std::cos(turn), 0.1 * std::sin(turn), 0}, {0, 0.05 * (i % 3), -0.1}),
                emitter(200 + 30 * (i % 9), 0.5));
    }
  }
  Scene scene;
};

TEST_F(RoomOfManyPanels, MetersAgree) {
  const Sensor meters = scene.add_meters(grid(0.9), {0, 0, 1});
  expect_agreement(scene, meters,
                   {trial(UPS_METHOD_UPS, 32), trial(UPS_METHOD_BIDIRECTIONAL, 32), trial(UPS_METHOD_PATH_TRACING, 64)},
                   0.01);
}

TEST_F(RoomOfManyPanels, ImagesAgree) {
  const Sensor camera = scene.add_camera({0.3, 0.2, 1.6}, {1, 0.8, -0.5}, 32, 24, 1.1);
  expect_same_image_mean(scene, camera, {UPS_METHOD_UPS, UPS_METHOD_PATH_TRACING}, 24);
}

class PointLitDiffuseRoom : public ::testing::Test {
 protected:
  void SetUp() override {
    add_room(scene);
    scene.add(quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}), matte(0.3));
    scene.add(box({2.75, 1.8, 0.01}, {3.25, 2.6, 0.7}), matte(0.8));
    scene.add(quad({1, 1, 1.6}, {1, 0, 0}, {0, 1, 0}), matte(0.5));  // a shade below the light
    scene.add_point_light({1.5, 1.5, 2}, 100);
  }
  Scene scene;
};

TEST_F(PointLitDiffuseRoom, CellsAgree) {
  const Sensor cells =
      scene.add_cells(grid(0), std::vector<P3>(16, {0, 0, 1}), std::vector<P3>(16, {1, 0, 0}), 0.7, 0.7);
  std::vector<Trial> trials;
  for (const ups_method m : cell_methods)
    trials.push_back(trial(m, m == UPS_METHOD_LIGHT_TRACING ? 128 : m == UPS_METHOD_PATH_TRACING ? 128 : 48, 1u << 14));
  expect_agreement(scene, cells, trials, 0.015);
}

TEST_F(PointLitDiffuseRoom, ImagesAgree) {
  const Sensor camera = scene.add_camera({0.3, 0.2, 1.6}, {1, 0.8, -0.5}, 32, 24, 1.1);
  expect_same_image_mean(
      scene, camera, {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING}, 20);
}

}  // namespace
}  // namespace ups::test
