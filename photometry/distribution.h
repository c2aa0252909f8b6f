// One luminous intensity distribution: a table of directions with irregular steps. Evaluation, flux and exact sampling
// of the interpolated intensity. The standard library only; usable without the engine. Made by the readers and by
// programs; sampled by the emitters that have a profile.
//
// Frame: gamma 0 is the nadir (local -Z), C0 is local +X, C90 is +Y:
//   direction = (sin g cos C, sin g sin C, -cos g).
// Tables of types B and A (IES LM-63) have another polar axis. Their forward direction (0, 0) is the nadir, up is C0,
// right is C270; seen along forward with up at the top:
//   type B: forward cos H cos V, right sin H,       up cos H sin V   (polar axis: right)
//   type A: forward cos V cos H, right cos V sin H, up sin V         (polar axis: up)
#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "photometry/density_table.h"

namespace photometry {

// How a table counts directions.
enum class PhotometricType { c, b, a };

class Distribution {
 public:
  static constexpr size_t max_values = 4'000'000;

  // c_deg: ascending in [0, 360), starting at 0 unless single; planes wrap around. gamma_deg: ascending in [0, 180].
  // at least 2 of them. intensity_cd: gamma fastest, finite, >= 0; at most max_values. Throws std::invalid_argument
  // that names the field and element.
  Distribution(std::vector<double> c_deg, std::vector<double> gamma_deg, std::vector<double> intensity_cd);
  // A table of any type in its own angles: planes through the polar axis (type A: H, type B: V), at least 2, ascending
  // in [-180, 180], and rows (A: V, B: H), at least 2, ascending in [-90, 90]; row fastest. The planes do not wrap
  // around. Type c is the constructor above.
  Distribution(PhotometricType type, std::vector<double> plane_deg, std::vector<double> row_deg,
               std::vector<double> intensity_cd);

  // Bilinear in the table's angles, cd; 0 outside the table. The direction has any length > 0, in the frame above.
  double eval(double x, double y, double z) const;
  // Flux by the band rule on the table as it is: planes averaged with trapezoid weights, bands of equal polar angle
  // 2 pi (cos a - cos b) (I_a + I_b) / 2.
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
  // The same in single precision, of a unit direction: many times as fast.
  float fast_pdf_w(float x, float y, float z) const;
  // The inverse of sample(): u1, u2 in [0, 1] of a direction of any length > 0. False where the intensity is 0.
  bool invert(double x, double y, double z, double& u1, double& u2) const;

  // The table in its own angles: of type C planes C and rows gamma, of type A planes H and rows V, of type B planes V
  // and rows H.
  PhotometricType type() const { return type_; }
  const std::vector<double>& c_deg() const { return c_deg_; }
  const std::vector<double>& gamma_deg() const { return gamma_deg_; }
  double at(size_t c, size_t gamma) const { return table_[c * gamma_deg_.size() + gamma]; }

  // The same intensities at the nodes of a C-gamma grid, as the first constructor takes it. Interpolated between the
  // grid's nodes it is not the same distribution where the grids differ.
  Distribution resampled(std::vector<double> grid_c_deg, std::vector<double> grid_gamma_deg) const;
  // Where the value at(plane, row) of a table of any type lies, in C-gamma terms.
  void node_direction(size_t plane, size_t row, double& c_deg, double& gamma_deg) const;

 private:
  PhotometricType type_ = PhotometricType::c;
  std::vector<double> c_deg_, gamma_deg_, table_;
  double band_flux_lm_ = 0, interpolated_flux_lm_ = 0;
  double peak_cd_ = 0, peak_c_deg_ = 0, peak_gamma_deg_ = 0;

  // A cell of the table and the place in it, 0 to 1 along C (s) and gamma (t).
  struct Place {
    size_t c, gamma;
    double s, t;
  };
  void check_table() const;
  size_t cells() const { return type_ == PhotometricType::c ? c_deg_.size() : c_deg_.size() - 1; }  // along C
  void find_peak();
  bool locate(double x, double y, double z, Place& place) const;
  double plane_value(size_t c, size_t gamma, double t) const;  // of plane c (or, past the last, of the first)
  double c_width(size_t c) const;                              // rad, to the next plane
  double turns(double x, double y, double z) const;  // from the first plane, of a whole turn
  void build_sampling_tables();
  void build_density_table();

  std::vector<double> c_rad_, gamma_rad_;  // azimuth and polar angle about the table's own polar axis
  // At gamma row j: integral of the intensity over C from plane 0 to plane i, at [j * (cells + 1) + i].
  std::vector<double> c_cumulative_;
  std::vector<double> band_cumulative_;  // flux below each gamma row, lm
  DensityTable density_;                 // empty where there is no flux
};

}  // namespace photometry
