// The extended path space itself: with actual perturbation, path integration draws a vertex from the merging kernel
// around the eye path's vertex and so estimates what density estimation estimates, for any radius, not only as it
// shrinks (Hachisuka, Pantaleoni, Jensen 2012, Eq. 16 and 17; Eq. 18 leaves the vertex out). Radii are large here, so
// that the virtual perturbation of every render measures something else by many standard errors; as the radius shrinks
// the two come together as its square.
//
// Tolerances are those of expect_lx.h, with its false alarms and what they find: an error of 1 %. Means of images are
// over 8 seeds: P(|t_14| > 4) = 0.13 % a comparison where noise decides. 10 comparisons.
#include "../support/expect_lx.h"
#include "../support/image_mean.h"

namespace ups::test {
namespace {

constexpr double height = 1, intensity = 1000;

// Illuminance of a plane at distance rho from the foot of a point source.
double illuminance(double rho) { return intensity * height / std::pow(height * height + rho * rho, 1.5); }

// Mean over a disc at `x` by the midpoint rule in equal areas.
double disc_mean(double x, double radius) {
  constexpr int rings = 64, sectors = 64;
  double sum = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double r = radius * std::sqrt((i + 0.5) / rings), phi = 2 * pi_d * (j + 0.5) / sectors;
      sum += illuminance(std::hypot(x + r * std::cos(phi), r * std::sin(phi)));
    }
  return sum / (rings * sectors);
}

struct Plane {
  Scene scene;
  Sensor meter;
  Plane() {
    scene.add(quad({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}), matte(0));
    // A cone that is wider than every disc, so that its photons are not wasted.
    scene.add_spot({0, 0, height}, {0, 0, -1}, intensity, 1.0, 1.1);
    meter = scene.add_meters({{0.3, 0, 0}}, {0, 0, 1});
  }
  ups_meter_reading read(RenderOptions options) { return scene.render(options).readings(meter)[0]; }
};

TEST(ActualPerturbation, OfNextEventEstimationAtAMeterMeasuresWhatMergingMeasures) {
  constexpr double radius = 0.4;
  constexpr uint32_t iterations = 64;
  Plane plane;
  const double expected = disc_mean(0.3, radius), at_point = illuminance(0.3);
  ASSERT_GT(std::abs(expected / at_point - 1), 0.02);
  RenderOptions options{.method = UPS_METHOD_PATH_TRACING, .iterations = iterations, .merge_radius_m = radius};
  expect_lx(plane.read(options), at_point, quiet, "virtual");
  options.perturbation = UPS_PERTURBATION_ACTUAL;
  expect_lx(plane.read(options), expected, quiet, "actual");
  options.method = UPS_METHOD_PPM;
  options.light_paths = 1u << 13;
  expect_lx(plane.read(options), expected, quiet, "merging");
}

// The difference to virtual perturbation is the bias of merging, r^2 / 8 times the Laplacian of illuminance: 4.3 % of
// the light at the largest radius, 0.07 % at the smallest. Its standard error is at most 2 % of it; 4 are allowed
// besides the next term of the series, P(|t_15| > 4) = 0.12 % each: of the light 0.9 % is found at the largest radius,
// 0.01 % at the smallest. Each is 4 times the next one, to an eighth of that, which is 4 of the ratio's errors: 3.3 and
// 4.7 are found.
TEST(ActualPerturbation, ComesToVirtualAsTheSquareOfTheRadius) {
  constexpr double largest_error = 0.02;  // of a difference
  Plane plane;
  const double x = 0.3, s = height * height + x * x;
  const double laplacian = intensity * height * (15 * x * x / std::pow(s, 3.5) - 6 / std::pow(s, 2.5));
  const double virtual_lx = illuminance(x);
  double last = 0;
  for (double radius : {0.28, 0.14, 0.07, 0.035}) {
    const double predicted = radius * radius / 8 * laplacian;
    RenderOptions options{.method = UPS_METHOD_PATH_TRACING, .iterations = 64, .merge_radius_m = radius,
                          .perturbation = UPS_PERTURBATION_ACTUAL};
    const auto excess = [&](const Result& rendered) {
      return double(rendered.readings(plane.meter)[0].standard_error_lx) / (largest_error * std::abs(predicted));
    };
    const Result result = render_until_quiet(plane.scene, options, 8192, excess);
    const ups_meter_reading r = result.readings(plane.meter)[0];
    EXPECT_GE(excess(result), 0) << radius << ": no standard error";
    EXPECT_LE(excess(result), 1) << radius << ": too noisy to judge, " << options.iterations << " iterations";
    const double difference = r.illuminance_lx - virtual_lx;
    // The next term of the series is of order r^2 relative to this one.
    EXPECT_NEAR(difference, predicted, 1.2 * radius * radius * std::abs(predicted) + sigmas * r.standard_error_lx)
        << radius;
    if (last != 0) {
      EXPECT_NEAR(last / difference, 4, 0.5) << radius;
    }
    last = difference;
  }
  EXPECT_LT(std::abs(last), 0.001 * virtual_lx);
}

// `options` once with actual perturbation against PPM at the same radius, which hardly shrinks, so that each may have
// the iterations that it needs; once virtual, which must differ.
void expect_same_as_merging(Scene& scene, const Sensor& camera, RenderOptions options, double least_difference) {
  options.radius_alpha = 0.999;
  RenderOptions merging = options;
  merging.method = UPS_METHOD_PPM;
  merging.iterations = 8;
  merging.techniques = 0;
  merging.light_paths = 1u << 13;
  const Mean b = image_mean(scene, camera, merging), c = image_mean(scene, camera, options);
  options.perturbation = UPS_PERTURBATION_ACTUAL;
  const Mean a = image_mean(scene, camera, options);
  const double s = std::hypot(a.standard_error, b.standard_error);
  EXPECT_LE(s, quiet * b.value) << "too noisy to judge";
  EXPECT_LE(std::abs(a.value - b.value), std::max(relative_tolerance * b.value, sigmas * s))
      << a.value << " " << b.value;
  EXPECT_GE(std::abs(c.value - b.value), least_difference * b.value) << "virtual: " << c.value << " " << b.value;
}

// Over a sphere: the kernel is cut by the merging rules, and the drawn point's normal is another than the vertex's.
TEST(ActualPerturbation, OfNextEventEstimationOnACurvedSurfaceMeasuresWhatMergingMeasures) {
  Scene scene;
  scene.add(icosphere({0, 0, 0}, 1, 5), matte(0.5));
  scene.add_spot({0, 0, 1.5}, {0, 0, -1}, intensity, 1.2, 1.3);
  const Sensor camera = scene.add_camera({0, 0, 1.4}, {0.3, 0, -1}, 4, 4, 0.2);
  expect_same_as_merging(scene, camera, {.method = UPS_METHOD_PATH_TRACING, .iterations = 2048, .merge_radius_m = 0.4,
                                         .max_path_length = 2}, 0.05);
}

// Over ridges: half of what the kernel covers is inclined by 40 degrees to the vertex's face, so that the density of a
// drawn point on its own face is 0.77 of that on the tangent disc.
TEST(ActualPerturbation, OfNextEventEstimationOnRidgesMeasuresWhatMergingMeasures) {
  constexpr int ridges = 48;
  const double width = 0.05, rise = width / 2 * std::tan(20 * pi_d / 180);
  Scene scene;
  Shape floor;
  for (int i = -ridges / 2; i < ridges / 2; ++i) {
    const double x = i * width;
    floor.append(quad({x, -1.2, 0}, {width / 2, 0, rise}, {0, 2.4, 0}));
    floor.append(quad({x + width / 2, -1.2, rise}, {width / 2, 0, -rise}, {0, 2.4, 0}));
  }
  scene.add(floor, matte(0.5));
  scene.add_spot({0, 0, 1.5}, {0, 0, -1}, intensity, 0.5, 0.6);
  const Sensor camera = scene.add_camera({0, 0, 1.4}, {0, 0.01, -1}, 16, 16, 0.3);
  expect_same_as_merging(scene, camera, {.method = UPS_METHOD_PATH_TRACING, .iterations = 2048, .merge_radius_m = 0.15,
                                         .max_path_length = 2}, 0.05);
}

// s = 2, t = 2: a lit spot on a wall, the floor beneath it seen by the camera.
TEST(ActualPerturbation, OfConnectionsMeasuresWhatMergingMeasures) {
  Scene scene;
  scene.add(quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), matte(0.5));
  scene.add(quad({-0.2, 0.2, 0.3}, {0.4, 0, 0}, {0, 0, 0.3}), matte(0.8));
  scene.add_spot({0, -0.5, 0.45}, {0, 1, 0}, intensity, 0.12, 0.14);
  const Sensor camera = scene.add_camera({0, -0.1, 1}, {0, 0.1, -1}, 4, 4, 0.1);
  expect_same_as_merging(scene, camera,
                         {.method = UPS_METHOD_UPS,
                          .iterations = 768,
                          .merge_radius_m = 0.15,
                          .light_paths = 1u << 8,  // each eye path takes one of them
                          .techniques = UPS_TECHNIQUE_CONNECT,
                          .max_path_length = 3},
                         0.05);
}

// A pane just above the floor: no photon is stored on it, and a vertex that is drawn there would see past it.
TEST(ActualPerturbation, DrawsNoVertexOnAPaneAboveTheSurface) {
  Scene scene;
  scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(0.5));
  scene.add(quad({-1, -1, 0.005}, {2, 0, 0}, {0, 2, 0}), mirror(0.9));
  scene.add_spot({0, 0, 1}, {0, 0, -1}, intensity, 0.3, 0.4);
  const Sensor camera = scene.add_camera({0, 0, 0.004}, {0, 0.1, -1}, 4, 4, 0.5);
  for (ups_perturbation perturbation : {UPS_PERTURBATION_VIRTUAL, UPS_PERTURBATION_ACTUAL})
    for (float v : scene.render({.method = UPS_METHOD_PATH_TRACING,
                                 .iterations = 16,
                                 .merge_radius_m = 0.1,
                                 .perturbation = perturbation})
                       .image(camera)
                       .luminance)
      EXPECT_EQ(v, 0);
}

}  // namespace
}  // namespace ups::test
