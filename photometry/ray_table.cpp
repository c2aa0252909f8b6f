// See ray_table.h.
#include "photometry/ray_table.h"

#include <cmath>

#include "photometry/far_field.h"
#include "photometry/luminosity.h"
#include "photometry/text_reader.h"

namespace photometry {
namespace {

constexpr double largest_position_m = 1e6, largest_total_lm = 1e20;

// Rays whose flux or direction is odd, counted with the place of the first.
struct Oddities {
  size_t count = 0, first_byte = 0;
  void add(size_t byte) {
    if (count++ == 0) first_byte = byte;
  }
  void warn(Photometry& out, const char* one, const char* several) const {
    if (count > 0) out.warnings.push_back(at_byte(first_byte, counted(count, one, several)));
  }
};

class RayReader {
 public:
  RayReader(const FileBytes& file, const RayTable& table) : file_(file), table_(table) {}
  void read(Photometry& out);

 private:
  float value(size_t at, size_t column) const { return file_.f32(at + 4 * column, "a ray"); }
  void read_place(size_t index, size_t at, Ray& ray);
  double efficacy(size_t index, size_t at) const;
  double scale(Photometry& out) const;

  const FileBytes& file_;
  const RayTable& table_;
  Oddities no_flux_, not_unit_;
  double sum_units_ = 0, sum_lm_ = 0;
};

void RayReader::read_place(size_t index, size_t at, Ray& ray) {
  double length2 = 0;
  for (size_t k = 0; k < 3; ++k) {
    const double p = value(at, k) * table_.metres, d = value(at, 3 + k);
    if (std::isnan(p) || std::abs(p) > largest_position_m)
      fail_at_byte(at + 4 * k, "ray " + std::to_string(index + 1) + " starts at a coordinate of " + shown(p) +
                                   " m; it must be within a million metres");
    ray.p_m[k] = float(p);
    length2 += d * d;
  }
  const double length = std::sqrt(length2);
  if (std::isnan(length) || length < 1e-6 || length > 1e6)
    fail_at_byte(at + 12, "ray " + std::to_string(index + 1) + " has no direction: the length of its direction is " +
                              shown(length) + "; it must be 1");
  if (std::abs(length - 1) > 1e-3) not_unit_.add(at + 12);
  for (size_t k = 0; k < 3; ++k) ray.direction[k] = float(value(at, 3 + k) / length);
}

// Lumens in a unit of the flux column.
double RayReader::efficacy(size_t index, size_t at) const {
  if (table_.wavelength) return luminous_efficacy(double(value(at, table_.wavelength)) * table_.nanometres);
  if (!table_.spectrum) return table_.lumens_per_unit;
  const float spectrum = value(at, table_.spectrum);
  const size_t spectra = table_.efficacy.size();
  if (std::isnan(spectrum) || spectrum < 1 || spectrum >= float(spectra + 1))
    fail_at_byte(at + 4 * table_.spectrum, "ray " + std::to_string(index + 1) + " has the spectrum " + shown(spectrum) +
                                               "; the file has " + std::to_string(spectra) + ", counted from 1");
  return table_.efficacy[size_t(spectrum) - 1];
}

// What the rays' lumens are multiplied with, so that they add up to what the header states.
double RayReader::scale(Photometry& out) const {
  const auto given = [](double total) { return std::isfinite(total) && total > 0; };
  const auto warn = [&](double stated, const char* unit) {  // NaN and 0: not stated
    if (std::isinf(stated) || std::isless(stated, 0.0))
      out.warnings.push_back("the header's flux is " + shown(stated) + " " + unit +
                             "; it must be greater than 0, and the rays are not scaled to it");
  };
  warn(table_.total_lm, "lm");
  warn(table_.total_units, table_.unit);
  const bool in_lm = given(table_.total_lm);
  if (!in_lm && !given(table_.total_units)) return 1;
  const double total = in_lm ? table_.total_lm : table_.total_units, sum = in_lm ? sum_lm_ : sum_units_;
  const std::string unit = std::string(" ") + (in_lm ? "lm" : table_.unit);
  if (std::abs(sum - total) > 1e-3 * total)
    out.warnings.push_back("the rays' fluxes add up to " + shown(sum) + unit + "; they are scaled to the header's " +
                           shown(total) + unit);
  return total / sum;
}

void RayReader::read(Photometry& out) {
  const size_t bytes = 4 * table_.columns;
  std::vector<double> flux;
  flux.reserve(table_.count);
  out.rays.reserve(table_.count);
  for (size_t i = 0; i < table_.count; ++i) {
    const size_t at = table_.begin + i * bytes;
    Ray ray;
    read_place(i, at, ray);
    const double units = value(at, table_.flux);
    if (!std::isfinite(units) || units <= 0) {
      no_flux_.add(at + 4 * table_.flux);
      continue;
    }
    sum_units_ += units;
    const double lumens = units * efficacy(i, at);
    if (!std::isgreater(lumens, 0.0)) continue;  // infrared, ultraviolet
    sum_lm_ += lumens;
    flux.push_back(lumens);
    out.rays.push_back(ray);
  }
  no_flux_.warn(out, "ray has a flux that is 0, negative or not finite; it is left out",
                "rays have a flux that is 0, negative or not finite; they are left out");
  not_unit_.warn(out, "direction is not of length 1; it is normalised",
                 "directions are not of length 1; they are normalised");
  const double factor = out.rays.empty() ? 1 : scale(out);
  if (!(sum_lm_ * factor <= largest_total_lm))
    fail_at_byte(table_.begin, "the rays' fluxes add up to " + shown(sum_lm_ * factor) + " lm, which is too much");
  for (size_t i = 0; i < flux.size(); ++i) out.rays[i].flux_lm = float(flux[i] * factor);
  if (out.rays.empty()) out.warnings.push_back(at_byte(table_.begin, "no ray has any luminous flux"));
}

template <class Character>
void append_printable(std::string& out, Character c) {
  append_utf8(out, c < 0x20 ? ' ' : c);
}

}  // namespace

std::string FileBytes::latin1(size_t at, size_t size, const char* field) const {
  require(at, size, field);
  std::string out;
  for (size_t i = 0; i < size && data_[at + i]; ++i) append_printable(out, uint32_t(data_[at + i]));
  return std::string(trimmed(out));
}

std::string FileBytes::utf32(size_t at, size_t size, const char* field) const {
  require(at, size, field);
  std::string out;
  for (size_t i = 0; i + 4 <= size; i += 4) {
    const uint32_t c = u32(at + i, field);
    if (c == 0) break;
    append_printable(out, c);
  }
  return std::string(trimmed(out));
}

Photometry dark_photometry() { return Photometry{Distribution({0}, {0, 180}, {0, 0})}; }

void read_rays(const FileBytes& file, const RayTable& table, Photometry& out) {
  const size_t there = file.size() > table.begin ? (file.size() - table.begin) / (4 * table.columns) : 0;
  if (there < table.count)
    fail_at_byte(file.size(), "the file ends before ray " + std::to_string(there + 1) + " of " +
                                  std::to_string(table.count) + "; they have " + std::to_string(4 * table.columns) +
                                  " bytes each and start at byte " + std::to_string(table.begin));
  RayReader(file, table).read(out);
  if (out.rays.empty()) return;
  try {
    FarField field = far_field(out.rays);
    out.distribution = std::move(field.distribution);
    if (out.distribution.c_deg().size() == 1) out.symmetry = Symmetry::axial;
    const std::string rays = out.rays.size() == 1 ? "one ray" : std::to_string(out.rays.size()) + " rays";
    out.warnings.push_back("the table of intensities is a sample of " + rays + ", with a noise of about " +
                           shown(std::ceil(1000 * field.noise) / 10) + " % a node");
  } catch (const std::invalid_argument& e) {
    fail_at_byte(table.begin, std::string("the rays' far field: ") + e.what());
  }
}

}  // namespace photometry
