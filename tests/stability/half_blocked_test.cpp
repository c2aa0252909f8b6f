// Hazard 29: what stands before a camera and blocks half of its view. Cameras are pinholes, with no lens whose points
// would have to be counted; still light that comes to them and rays that leave them must lose the same.
#include <algorithm>

#include "../support/expect_same.h"
#include "../support/full.h"

namespace ups::test {
namespace {

// A black sheet a millimetre before the pinhole, its edge on the axis, between two columns of pixels. That half is
// black, exactly, the other as it is without the sheet, by paths from the camera and by paths from the light. Image
// means over eight seeds, as expect_same.h says, at errors of at most 0.15 %: 1 % is found in 95 cases of 100 at that
// limit, a false alarm has P(|t_14| > 3) = 1 % there. Without the sheet both halves are alike: the mean over the seeds
// of their ratio is 1 to 0.5 % or 4 standard errors of at most 0.25 %, P(|t_7| > 4) = 0.5 %; 1.5 % is found in 97 cases
// of 100.
TEST(Hazard29, AViewThatIsHalfBlockedIsTheSameFromBothEnds) {
  constexpr uint32_t width = 32, height = 24;
  std::vector<Estimate> halves;
  for (const bool blocked : {true, false})
    for (Trial t : {trial(UPS_METHOD_PATH_TRACING, 48), trial(UPS_METHOD_LIGHT_TRACING, 64, 1u << 15)}) {
      Scene scene;
      scene.add(quad({2, -3, -3}, {0, 0, 6}, {0, 6, 0}), matte(0.7));
      scene.add(quad({-0.5, -1, 1.5}, {0, 2, 0}, {1, 0, -0.5}), emitter(1000));
      if (blocked) scene.add(quad({1e-3, 0, -1}, {0, 1, 0}, {0, 0, 2}), matte(0));
      const Sensor camera = scene.add_camera({0, 0, 0}, {1, 0, 0}, width, height, 1);
      std::vector<double> open, ratios;
      const uint64_t seeds = low_effort() ? 2 : 8;
      for (t.options.seed = 1; t.options.seed <= seeds; ++t.options.seed) {
        const std::vector<float> pixels = scene.render(t.options).image(camera).luminance;
        double left = 0, right = 0;
        for (size_t i = 0; i < pixels.size(); ++i) (i / 3 % width < width / 2 ? left : right) += pixels[i];
        ratios.push_back(left / right);
        open.push_back(right / (pixels.size() / 2));
      }
      const Mean ratio = mean_of(ratios);
      if (blocked) {
        EXPECT_EQ(ratio.value, 0) << t.name;
      } else {
        expect_lx(ratio.value, ratio.standard_error, 1, 0.0025, t.name + ", left half over right");
      }
      halves.push_back(estimate(t.name + (blocked ? ", half blocked" : ", open"), mean_of(open)));
    }
  expect_same(halves, 0, "the open half");
}

}  // namespace
}  // namespace ups::test
