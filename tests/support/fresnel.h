// Fresnel's reflectance of unpolarised light (Born & Wolf, Principles of Optics, 1.5.2), for closed forms of tests.
#pragma once
#include <cmath>

namespace ups::test {

// cosine > 0: from air onto a medium of this index; < 0: from within it.
inline double fresnel(double cosine, double ior) {
  const double eta = cosine > 0 ? ior : 1 / ior, c = std::abs(cosine), sine2 = (1 - c * c) / (eta * eta);
  if (sine2 >= 1) return 1;
  const double t = std::sqrt(1 - sine2), s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
  return (s * s + p * p) / 2;
}

}  // namespace ups::test
