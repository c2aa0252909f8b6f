// One luminous intensity distribution: a C-gamma table with irregular steps. Evaluation, flux and exact sampling of the
// interpolated intensity. The standard library only; usable without the engine. Made by ies.cpp and by programs;
// sampled by the emitters that have a profile.
//
// Frame: gamma 0 is the nadir (local -Z), C0 is local +X, C90 is +Y:
//   direction = (sin g cos C, sin g sin C, -cos g).
#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace photometry {

class Distribution {
 public:
  static constexpr size_t max_values = 4'000'000;

  // c_deg: ascending in [0, 360), starting at 0 unless single; planes wrap around. gamma_deg: ascending in [0, 180].
  // at least 2 of them. intensity_cd: gamma fastest, finite, >= 0; at most max_values. Throws std::invalid_argument
  // that names the field and element.
  Distribution(std::vector<double> c_deg, std::vector<double> gamma_deg, std::vector<double> intensity_cd);

  // Bilinear in (C, gamma), cd; 0 outside the table's gamma range. The direction has any length > 0.
  double eval(double x, double y, double z) const;
  // Flux by the band rule: planes averaged with trapezoid weights, bands 2 pi (cos a - cos b) (I_a + I_b) / 2.
  double band_flux_lm() const { return band_flux_lm_; }
  // Integral of the interpolated intensity over the sphere, exact.
  double interpolated_flux_lm() const { return interpolated_flux_lm_; }
  double peak_cd() const { return peak_cd_; }
  double peak_c_deg() const { return peak_c_deg_; }
  double peak_gamma_deg() const { return peak_gamma_deg_; }

  struct Sample {
    double x, y, z;  // unit
    double intensity_cd;
    double pdf_w;  // = intensity / interpolated flux
  };
  // A direction with density exactly in proportion to the interpolated intensity; u1, u2 in [0, 1).
  // Continuous in u within a table cell. Undefined where the flux is 0 (pdf_w = 0).
  Sample sample(double u1, double u2) const;
  double pdf_w(double x, double y, double z) const;

  const std::vector<double>& c_deg() const { return c_deg_; }
  const std::vector<double>& gamma_deg() const { return gamma_deg_; }
  double at(size_t c, size_t gamma) const { return table_[c * gamma_deg_.size() + gamma]; }

 private:
  std::vector<double> c_deg_, gamma_deg_, table_;
  double band_flux_lm_ = 0, interpolated_flux_lm_ = 0;
  double peak_cd_ = 0, peak_c_deg_ = 0, peak_gamma_deg_ = 0;

  // A cell of the table and the place in it, 0 to 1 along C (s) and gamma (t).
  struct Place {
    size_t c, gamma;
    double s, t;
  };
  bool locate(double x, double y, double z, Place& place) const;
  double plane_value(size_t c, size_t gamma, double t) const;  // of plane c (or, past the last, of the first)
  double c_width(size_t c) const;                              // rad, to the next plane
  void build_sampling_tables();

  std::vector<double> c_rad_, gamma_rad_;
  // At gamma row j: integral of the intensity over C from plane 0 to plane i, at [j * (planes + 1) + i].
  std::vector<double> c_cumulative_;
  std::vector<double> band_cumulative_;  // flux below each gamma row, lm
};

}  // namespace photometry
