// A virtual goniophotometer: flux by direction at infinity, gathered at the nodes of a C-gamma grid. Filled by the
// light pass with what leaves the scene, read by render/accumulator.
//
// Each bit of flux is divided among the four nodes around its direction by the hat functions of bilinear interpolation;
// a node's intensity is its flux over the solid angle integral of its hat. The interpolated table then carries exactly
// the flux that was found. A second, half as wide set of hats tells how much the width blurs (GoniometerTally::narrow).
#pragma once
#include <cstdint>
#include <vector>

#include "base/frame.h"
#include "photometry/photometry.h"

namespace ups {

// By node; a node that stands for others has theirs.
struct GoniometerTally {
  std::vector<double> wide, narrow;  // lm
  double flux = 0, outside = 0;      // lm: all of it, the part beyond the range of gamma
  double largest = 0;                // lm, of one light path
  // Flux times x, y, x y, x^2 - y^2 of its unit direction (x: C0, y: C90), lm: 0 where the light has the symmetry for it.
  double moments[4] = {};
};

class Goniometer {
 public:
  using Symmetry = photometry::Symmetry;

  // frame: s, t, n are local X (C0), Y (C90), Z (away from nadir). Angles ascending, c_deg in [0, 360) from 0,
  // gamma_deg in [0, 180]. Throws Error where the planes are not as symmetric as asked for.
  Goniometer(const Frame& frame, std::vector<double> c_deg, std::vector<double> gamma_deg, Symmetry symmetry);

  Symmetry symmetry() const { return symmetry_; }
  const std::vector<double>& c_deg() const { return c_deg_; }
  const std::vector<double>& gamma_deg() const { return gamma_deg_; }
  size_t node_count() const { return c_deg_.size() * gamma_deg_.size(); }
  // The node that stands for this one: by symmetry, and because all planes meet at the poles.
  uint32_t representative(size_t node) const { return representative_[node]; }
  // Solid angle that a representative's flux is to be divided by, sr.
  double wide_solid_angle(uint32_t node) const { return wide_[node]; }
  double narrow_solid_angle(uint32_t node) const { return narrow_[node]; }

  GoniometerTally empty_tally() const;
  void add(const Vec3& direction, double flux, GoniometerTally& tally) const;

 private:
  void find_representatives();
  void integrate_hats();
  size_t node(size_t c, size_t gamma) const { return c * gamma_deg_.size() + gamma; }

  Frame frame_;
  Symmetry symmetry_;
  std::vector<double> c_deg_, gamma_deg_, c_rad_, gamma_rad_;
  std::vector<uint32_t> representative_;
  std::vector<double> wide_, narrow_;  // by node; 0 where another stands for it
};

}  // namespace ups
