// A sphere whose normals lean far from its facets.
#pragma once
#include <random>

#include "../support/expect_same.h"

namespace ups::test {

// Directions far from the true normal, at every vertex of a coarse sphere: facets that are smoothed beyond their shape.
inline Shape bumpy_sphere(const P3& center, double radius) {
  Shape s = icosphere(center, radius, 1);
  std::mt19937 engine(3);
  const auto uniform = [&] { return std::generate_canonical<double, 53>(engine) * 2 - 1; };
  for (const P3& v : s.vertices) {
    const P3 n = normalize(v - center), lean{uniform(), uniform(), uniform()};
    s.normals.push_back(normalize(n + (lean - n * dot(lean, n)) * 0.5));
  }
  return s;
}

}  // namespace ups::test
