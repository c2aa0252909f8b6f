// Axis-aligned boxes in double: bounds of meshes and scenes.
#pragma once
#include "base/vec.h"

namespace ups {

struct Box {
  Vec3d lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};

  bool empty() const { return !(lower.x <= upper.x); }
  void grow(const Vec3d& p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
  Vec3d corner(int i) const {
    return {i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z};
  }
  bool holds(const Box& b) const {
    return b.lower.x >= lower.x && b.lower.y >= lower.y && b.lower.z >= lower.z && b.upper.x <= upper.x &&
           b.upper.y <= upper.y && b.upper.z <= upper.z;
  }
  // Around the transformed box, which may be larger than what is in it.
  Box transformed(const Affine& m) const {
    Box out;
    for (int i = 0; i < 8; ++i) out.grow(m.point(corner(i)));
    return out;
  }
};

}  // namespace ups
