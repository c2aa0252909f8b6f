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

class ParseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
class UnsupportedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Symmetry { none, axial, c0_c180, c90_c270, quadrants };
enum class OpeningShape { point, rectangle, disc, box, cylinder, sphere };

struct Opening {
  OpeningShape shape = OpeningShape::point;
  float size_m[3] = {0, 0, 0};  // along local x (C0-C180), y (C90-C270), z
  int axis = 2;                 // of a cylinder: 0 x, 1 y, 2 z
};

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

struct Keyword {
  std::string name, value;
};

// Factors on all intensities by the tilt of a luminaire with HID lamps. Read, never applied.
struct Tilt {
  int lamp_geometry = 0;  // 1 vertical, 2 horizontal and stays so, 3 horizontal and tilts along; 0: no table
  std::vector<double> angle_deg, factor;
};

// A photometric file as read.
struct Photometry {
  Distribution distribution;
  Opening opening;
  Symmetry symmetry = Symmetry::none;
  double rated_flux_lm = -1;  // lamps x lumens; < 0: absolute
  double input_power_w = -1;
  std::string format;             // "IES LM-63-2002"
  std::vector<Keyword> keywords;  // in the file's order; free label lines under the name LABEL
  Tilt tilt;
  std::vector<std::string> warnings;  // each with its line
};

// bytes: an IES LM-63 file of any edition, type C. Throws ParseError ("line 12: ...") or UnsupportedError (type A, B).
Photometry read_ies(const void* bytes, size_t size);
// Recognises the format; EULUMDAT is refused with UnsupportedError in this version.
Photometry read(const void* bytes, size_t size);

}  // namespace photometry
