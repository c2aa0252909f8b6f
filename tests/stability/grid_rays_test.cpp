// Hazard 10: rays along the grid that things stand on meet two of them at once, on edges that they share, or one twice.
// Meters' discs, against integer arithmetic. Panes: shared_edges_test.cpp.
#include <gtest/gtest.h>

#include "../support/figures.h"
#include "geometry/raytracer.h"

namespace ups {
namespace {

// Discs of radius 1 about the points of an integer grid, in layers at z = 0, 1, 2, with their normals along `axis`.
std::vector<DiscIndex::Disc> grid(int side, int axis) {
  std::vector<DiscIndex::Disc> discs;
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        Vec3 n;
        (axis == 0 ? n.x : axis == 1 ? n.y : n.z) = (x + y + z) % 2 ? 1.0f : -1.0f;
        discs.push_back({Vec3(float(x), float(y), float(z)), n, 1});
      }
  return discs;
}

// Along the discs' normals from every quarter of the grid: through centres, rims, points where rims touch, and corners
// of boxes. Of each disc double arithmetic is exact here.
TEST(Hazard10, RaysAlongTheGridCountEachDiscOnce) {
  constexpr int side = 12, quarters = 4 * side;
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {1.0f, -1.0f}) {
      const std::vector<DiscIndex::Disc> discs = grid(side, axis);
      const DiscIndex index(discs);
      size_t crossings = 0, on_rims = 0;
      std::vector<DiscIndex::Crossing> found;
      for (int i = -4; i < quarters; ++i)
        for (int j = -4; j < quarters; ++j) {
          const float u = 0.25f * float(i), v = 0.25f * float(j), start = sign > 0 ? -8.0f : 64.0f;
          const Vec3 o = axis == 0 ? Vec3(start, u, v) : axis == 1 ? Vec3(u, start, v) : Vec3(u, v, start);
          const Vec3 d = axis == 0 ? Vec3(sign, 0, 0) : axis == 1 ? Vec3(0, sign, 0) : Vec3(0, 0, sign);
          found.clear();
          index.intersect_all(o, d, 128, found);
          std::vector<uint32_t> expected;
          for (uint32_t k = 0; k < discs.size(); ++k) {
            Vec3 to = discs[k].center - o;
            (axis == 0 ? to.x : axis == 1 ? to.y : to.z) = 0;
            const float beside2 = dot(to, to);
            if (beside2 <= 1) expected.push_back(k);
            on_rims += beside2 == 1;
          }
          ASSERT_EQ(found.size(), expected.size()) << "axis " << axis << ", " << u << ", " << v;
          for (size_t k = 0; k < found.size(); ++k) ASSERT_EQ(found[k].disc, expected[k]);
          crossings += found.size();
        }
      test::measured("axis %d, sign %g: %zu crossings, each once; %zu on rims", axis, double(sign), crossings, on_rims);
      EXPECT_GT(crossings, 21000u);
      EXPECT_GT(on_rims, 1600u);
    }
}

}  // namespace
}  // namespace ups
