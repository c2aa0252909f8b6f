// Hazard 16: vertices that lie close together where surfaces meet, their shading normals leaning towards each other.
// Where densities take one cosine and the geometry term another, connections between them spike.
#include <algorithm>

#include "bumpy_sphere.h"

namespace ups::test {
namespace {

// A point light in a white coarse sphere, seen from inside: concave edges everywhere. No pixel is a thousand times as
// bright as the median of all, by any method that joins vertices, and the mean is the same by all: within 0.5 % at
// standard errors of at most 0.15 % over 8 seeds, see expect_same.h (there t has 15 degrees of freedom, here 7: a false
// alarm at the limit of noise is P(|t_14| > 3) = 1 % a pair): an error of 1 % is found in 95 of 100 cases at the least.
TEST(Hazard16, EdgesOfABumpySphereDoNotSpike) {
  Scene scene;
  Shape inside = bumpy_sphere({0, 0, 0}, 1).flipped();
  for (P3& n : inside.normals) n = n * -1;
  scene.add(inside, matte(0.8));
  scene.add_point_light({0.15, -0.2, 0.1}, 100);
  const Sensor camera = scene.add_camera({-0.45, 0.1, 0}, {1, 0, 0.1}, 64, 48, 1.6);
  std::vector<Estimate> means;
  for (const Trial& t : {trial(UPS_METHOD_PATH_TRACING, 16), trial(UPS_METHOD_BIDIRECTIONAL, 16, 1u << 12),
                         trial(UPS_METHOD_UPS, 16, 1u << 12, 0.02)}) {
    means.push_back(estimate(t.name, image_mean(scene, camera, t.options)));
    std::vector<float> pixels = scene.render(t.options).image(camera).luminance;
    std::sort(pixels.begin(), pixels.end());
    const double ratio = double(pixels.back()) / pixels[pixels.size() / 2];
    EXPECT_LT(ratio, 1000) << t.name;
    EXPECT_GT(pixels[pixels.size() / 2], 0) << t.name;
    measured("%s: largest over median %.3g", t.name.c_str(), ratio);
  }
  expect_same(means, 0, "image");
}

}  // namespace
}  // namespace ups::test
