// Scenes whose memory is measured.
#pragma once
#include <vector>

#include "support/scene_builder.h"

namespace ups::test {

inline std::vector<P3> grid(int columns, int rows, double x, double y, double step, double z) {
  std::vector<P3> places;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) places.push_back({x + i * step, y + j * step, z});
  return places;
}

inline void add_box(Scene& scene) {
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
  scene.add_point_light({2, 2, 2.5}, 100);
}

inline void add_luminaires(Scene& scene, const std::vector<P3>& places) {
  const auto profile = table_profile(scene.context(), 0.3f);
  for (const P3& p : places) scene.add_luminaire(profile.get(), p, {0, 0, -1}, true);
}

// 10 m x 8 m x 3 m, four desks with screens of metal, so many luminaires, ten to a row.
inline void add_office(Scene& scene, int luminaires) {
  scene.add(box({0, 0, 0}, {10, 8, 3}).flipped(), matte(0.7));
  for (int i = 0; i < 4; ++i) {
    scene.add(box({1 + 2.0 * i, 2, 0.7}, {2 + 2.0 * i, 4, 0.74}), matte(0.5));
    scene.add(box({1.2 + 2.0 * i, 2, 1.0}, {1.8 + 2.0 * i, 2.05, 1.4}), rough(UPS_MATERIAL_METAL, 0.6, 0.3));
  }
  std::vector<P3> places;
  for (int i = 0; i < luminaires; ++i) places.push_back({0.5 + 0.9 * (i % 10), 0.5 + 0.7 * (i / 10), 2.9});
  add_luminaires(scene, places);
}

}  // namespace ups::test
