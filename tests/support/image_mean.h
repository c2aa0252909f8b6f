// The mean of an image over seeds.
#pragma once
#include <cmath>
#include <numeric>
#include <vector>

#include "mean.h"
#include "scene_builder.h"

namespace ups::test {

// Over all pixels and channels of a camera's luminance, seeds 1 to 8 whatever `options` says: 7 degrees of freedom.
inline Mean image_mean(Scene& scene, const Sensor& camera, RenderOptions options) {
  std::vector<double> means;
  const uint64_t seeds = low_effort() ? 2 : 8;
  for (options.seed = 1; options.seed <= seeds; ++options.seed) {
    const std::vector<float> pixels = scene.render(options).image(camera).luminance;
    means.push_back(std::accumulate(pixels.begin(), pixels.end(), 0.0) / double(pixels.size()));
  }
  const Mean mean = mean_of(means);
  if (traces_renders()) std::printf("[ IMAGE    ] mean to %.2g %%\n", 100 * mean.standard_error / mean.value);
  return mean;
}

}  // namespace ups::test
