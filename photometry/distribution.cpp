// The table of distribution.h: validation, interpolation, the two fluxes, and sampling by exact inversion. All of it
// works in the frame of the table's own polar axis, where every type is azimuth and polar angle; directions are turned
// on the way in and out.
//
// With planes C_i and rows g_j the intensity is bilinear, so its integral over C is linear in gamma between rows. The
// marginal density of gamma is therefore (a + b gamma) sin(gamma) in a band, whose integral is in closed form, and the
// density of C given gamma is piecewise linear. Both are inverted exactly, so the map from the unit square is
// continuous.
#include "photometry/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "photometry/text_reader.h"

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846;

// Radians: a direction computed from a table's last angle may come out so far beyond it, and belongs to it.
constexpr double rounding_rad = 1e-12;

double to_radians(double degrees) { return degrees / 180 * pi; }  // exact at 90 and 180

// sin(y) - y cos(y), by its series where the difference would cancel.
double sine_moment(double y) {
  if (y > 0.1) return std::sin(y) - y * std::cos(y);
  const double y2 = y * y;
  return y * y2 * (1.0 / 3 - y2 * (1.0 / 30 - y2 * (1.0 / 840 - y2 / 45360)));
}

// One band of gamma, from g0 over h radians, in which a function runs linearly from a to b.
struct Band {
  double g0, h, a, b;

  // Integral of the function times sin(gamma) from t = 0 to t. Written about the middle of the range: with half width y
  // it is 2 (mean sin(middle) sin(y) + slope cos(middle) (sin(y) - y cos(y))), which stays exact for needles; of the
  // narrowest the slope alone would be beyond a double.
  double integral(double t) const {
    const double y = 0.5 * h * t, middle = g0 + y, mean = a + 0.5 * (b - a) * t;
    return 2 * (mean * std::sin(middle) * std::sin(y) + (b - a) * std::cos(middle) * (sine_moment(y) / h));
  }
  double density(double t) const { return (a + (b - a) * t) * std::max(0.0, std::sin(g0 + h * t)) * h; }
  double invert(double q) const;
};

// Where the integral of a line from v0 to v1 over [0, 1] reaches the fraction q of its whole; v0 + v1 > 0, q > 0.
double invert_linear(double v0, double v1, double q) {
  return std::min(1.0, q * (v0 + v1) / (v0 + std::sqrt(v0 * v0 * (1 - q) + v1 * v1 * q)));
}

// Where the integral reaches the fraction q of its whole: Newton's method, kept inside a shrinking bracket.
double Band::invert(double q) const {
  const double target = q * integral(1), v0 = density(0), v1 = density(1);
  double low = 0, high = 1, t = v0 + v1 > 0 ? invert_linear(v0, v1, q) : q;
  for (int i = 0; i < 100; ++i) {
    const double excess = integral(t) - target, slope = density(t);
    if (slope > 0 && std::abs(excess) <= 1e-14 * t * slope) break;  // t as an end of the bracket would lead away again
    (excess > 0 ? high : low) = t;
    double next = slope > 0 ? t - excess / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    t = next;
  }
  return t;
}

// The last cell i of `count` that starts at or below the target and is not empty; `cumulative(i)` is where it starts.
template <class Cumulative>
size_t find_cell(size_t count, double target, const Cumulative& cumulative) {
  size_t low = 0, high = count;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    (cumulative(middle) <= target ? low : high) = middle;
  }
  while (low > 0 && !(cumulative(low + 1) > cumulative(low))) --low;
  return low;
}

// Strictly inside a cell, so that an edge of zero intensity is never hit.
double fraction(double part, double whole) { return std::clamp(part / whole, 0x1p-60, 1 - 0x1p-53); }

std::string element(const char* field, size_t i) { return std::string(field) + "[" + std::to_string(i) + "]"; }

void check_angles(const std::vector<double>& angle, const char* field, double first, double last, const char* range) {
  const bool last_allowed = range[std::char_traits<char>::length(range) - 1] == ']';
  for (size_t i = 0; i < angle.size(); ++i) {
    if (std::isnan(angle[i]) || angle[i] < first || angle[i] > last || (angle[i] == last && !last_allowed))
      throw std::invalid_argument(element(field, i) + " = " + shortest(angle[i]) + " is outside " + range);
    if (i > 0 && !(angle[i] > angle[i - 1]))
      throw std::invalid_argument(element(field, i) + " = " + shortest(angle[i]) +
                                  " does not ascend: it must be greater than the one before");
  }
}

template <class Real>
struct DirectionT {
  Real x, y, z;
};
using Direction = DirectionT<double>;

// Into the frame in which a table of this type is azimuth and polar angle (the polar angle counts from -z): signed axes
// of the luminaire's frame. 0 - z rather than -z, so that the horizon is not at an azimuth of 180 degrees.
template <class Real>
DirectionT<Real> to_native(PhotometricType type, const DirectionT<Real>& d) {
  if (type == PhotometricType::b) return {0 - d.z, d.x, 0 - d.y};  // forward, up, right
  if (type == PhotometricType::a) return {0 - d.z, 0 - d.y, d.x};  // forward, right, up
  return d;
}
Direction from_native(PhotometricType type, const Direction& d) {
  if (type == PhotometricType::b) return {d.y, 0 - d.z, 0 - d.x};
  if (type == PhotometricType::a) return {d.z, 0 - d.y, 0 - d.x};
  return d;
}

Direction direction_of(double azimuth_rad, double polar_rad) {
  const double sine = std::sin(polar_rad);
  return {sine * std::cos(azimuth_rad), sine * std::sin(azimuth_rad), -std::cos(polar_rad)};
}

// Of an angle in degrees; exact at multiples of 90.
double cosine_deg(double angle) {
  const double a = std::fmod(std::abs(angle), 360), b = a > 180 ? 360 - a : a;
  return b > 90 ? -std::sin(to_radians(b - 90)) : b > 45 ? std::sin(to_radians(90 - b)) : std::cos(to_radians(b));
}

}  // namespace

Distribution::Distribution(std::vector<double> c_deg, std::vector<double> gamma_deg, std::vector<double> intensity_cd)
    : Distribution(PhotometricType::c, std::move(c_deg), std::move(gamma_deg), std::move(intensity_cd)) {}

Distribution::Distribution(PhotometricType type, std::vector<double> plane_deg, std::vector<double> row_deg,
                           std::vector<double> intensity_cd)
    : type_(type), c_deg_(std::move(plane_deg)), gamma_deg_(std::move(row_deg)), table_(std::move(intensity_cd)) {
  check_table();
  for (double c : c_deg_) c_rad_.push_back(to_radians(c));
  for (double g : gamma_deg_) gamma_rad_.push_back(to_radians(type_ == PhotometricType::c ? g : g + 90));
  find_peak();
  if (peak_cd_ > 1e300) throw std::invalid_argument("intensity_cd has values too large to add up");
  build_sampling_tables();
  if (interpolated_flux_lm_ > 0) build_density_table();
}

void Distribution::check_table() const {
  const bool wraps = type_ == PhotometricType::c;
  const char* planes = wraps ? "c_deg" : "plane_deg";
  const char* rows = wraps ? "gamma_deg" : "row_deg";
  if (c_deg_.size() < (wraps ? 1 : 2))
    throw std::invalid_argument(wraps ? "c_deg is empty: at least one plane is needed"
                                      : "plane_deg has fewer than 2 planes");
  if (gamma_deg_.size() < 2) throw std::invalid_argument(std::string(rows) + " has fewer than 2 angles");
  if (c_deg_.size() > max_values / gamma_deg_.size())
    throw std::invalid_argument("intensity_cd would have more than " + std::to_string(max_values) + " values");
  if (wraps)
    check_angles(c_deg_, planes, 0, 360, "[0, 360)"), check_angles(gamma_deg_, rows, 0, 180, "[0, 180]");
  else
    check_angles(c_deg_, planes, -180, 180, "[-180, 180]"), check_angles(gamma_deg_, rows, -90, 90, "[-90, 90]");
  if (wraps && c_deg_.size() > 1 && c_deg_[0] != 0) throw std::invalid_argument("c_deg[0] is not 0");
  if (table_.size() != c_deg_.size() * gamma_deg_.size())
    throw std::invalid_argument("intensity_cd has " + std::to_string(table_.size()) + " values where " + planes +
                                " and " + rows + " ask for " + std::to_string(c_deg_.size() * gamma_deg_.size()));
  for (size_t i = 0; i < table_.size(); ++i)
    if (!std::isfinite(table_[i]) || table_[i] < 0)
      throw std::invalid_argument(element("intensity_cd", i) + " is negative or not finite");
}

void Distribution::find_peak() {
  const size_t peak = size_t(std::max_element(table_.begin(), table_.end()) - table_.begin());
  const size_t plane = peak / gamma_deg_.size(), row = peak % gamma_deg_.size();
  peak_cd_ = table_[peak];
  node_direction(plane, row, peak_c_deg_, peak_gamma_deg_);
}

void Distribution::node_direction(size_t plane, size_t row, double& c_deg, double& gamma_deg) const {
  c_deg = c_deg_[plane];
  gamma_deg = gamma_deg_[row];
  if (type_ == PhotometricType::c) return;
  Direction d = from_native(type_, direction_of(c_rad_[plane], gamma_rad_[row]));
  for (double* component : {&d.x, &d.y, &d.z})
    if (std::abs(*component) < 1e-15) *component = 0;  // what rounding leaves of an axis
  const double c = std::atan2(d.y, d.x) / pi * 180;
  c_deg = c < 0 ? c + 360 : c;
  gamma_deg = std::atan2(std::hypot(d.x, d.y), -d.z) / pi * 180;
}

Distribution Distribution::resampled(std::vector<double> grid_c_deg, std::vector<double> grid_gamma_deg) const {
  std::vector<double> table;
  if (grid_gamma_deg.size() > 0 && grid_c_deg.size() > max_values / grid_gamma_deg.size())
    throw std::invalid_argument("the grid would have more than " + std::to_string(max_values) + " values");
  for (double c : grid_c_deg)
    for (double g : grid_gamma_deg) {
      const double sine = cosine_deg(90 - g);
      table.push_back(eval(sine * cosine_deg(c), sine * cosine_deg(90 - c), -cosine_deg(g)));
    }
  return Distribution(std::move(grid_c_deg), std::move(grid_gamma_deg), std::move(table));
}

void Distribution::build_sampling_tables() {
  const size_t n = cells(), rows = gamma_deg_.size();

  c_cumulative_.resize(rows * (n + 1));
  for (size_t j = 0; j < rows; ++j)
    for (size_t i = 0; i < n; ++i)
      c_cumulative_[j * (n + 1) + i + 1] =
          c_cumulative_[j * (n + 1) + i] + c_width(i) * 0.5 * (at(i, j) + at((i + 1) % c_deg_.size(), j));

  band_cumulative_.assign(1, 0.0);
  for (size_t j = 0; j + 1 < rows; ++j) {
    const double a = c_cumulative_[j * (n + 1) + n], b = c_cumulative_[(j + 1) * (n + 1) + n];
    const double h = gamma_rad_[j + 1] - gamma_rad_[j];
    band_cumulative_.push_back(band_cumulative_.back() + Band{gamma_rad_[j], h, a, b}.integral(1));
    band_flux_lm_ += 0.5 * (a + b) * 2 * std::sin(gamma_rad_[j] + 0.5 * h) * std::sin(0.5 * h);  // cos a - cos b
  }
  interpolated_flux_lm_ = band_cumulative_.back();
}

void Distribution::build_density_table() {
  constexpr double most = std::numeric_limits<float>::max();  // of a beam whose density no float holds
  std::vector<float> density;
  for (const double intensity : table_)
    density.push_back(intensity < most * interpolated_flux_lm_ ? float(intensity / interpolated_flux_lm_)
                                                               : float(intensity > 0 ? most : 0));
  std::vector<double> planes = c_rad_;
  if (type_ == PhotometricType::c) {
    const auto rows = std::ptrdiff_t(gamma_deg_.size());
    const bool alike = std::equal(table_.begin() + rows, table_.end(), table_.begin());  // each plane the one before
    if (alike) planes.resize(1);
    else planes.push_back(2 * pi);
    const std::vector<float> first(density.begin(), density.begin() + rows);
    density.resize(alike ? 0 : density.size());
    density.insert(density.end(), first.begin(), first.end());
  }
  density_ = DensityTable(planes, gamma_rad_, std::move(density));
}

double Distribution::c_width(size_t c) const {
  return (c + 1 < c_rad_.size() ? c_rad_[c + 1] : 2 * pi + c_rad_[0]) - c_rad_[c];
}

double Distribution::plane_value(size_t c, size_t gamma, double t) const {
  const size_t plane = c < c_deg_.size() ? c : 0;
  return at(plane, gamma) * (1 - t) + at(plane, gamma + 1) * t;
}

bool Distribution::locate(double x, double y, double z, Place& place) const {
  const Direction d = to_native(type_, Direction{x, y, z});
  const double gamma = std::atan2(std::hypot(d.x, d.y), -d.z);
  const auto is_between = [](double angle, const std::vector<double>& of) {
    return angle >= of.front() - rounding_rad && angle <= of.back() + rounding_rad;
  };
  if (!is_between(gamma, gamma_rad_)) return false;
  const auto row = std::upper_bound(gamma_rad_.begin() + 1, gamma_rad_.end() - 1, gamma);
  place.gamma = size_t(row - gamma_rad_.begin()) - 1;
  place.t = std::clamp((gamma - row[-1]) / (row[0] - row[-1]), 0.0, 1.0);
  place.c = 0;
  place.s = 0;
  if (c_rad_.size() == 1) return true;
  double c = std::atan2(d.y, d.x);
  const bool wraps = type_ == PhotometricType::c;
  if (wraps && c < 0) c += 2 * pi;
  if (!wraps && !is_between(c, c_rad_)) return false;
  place.c = size_t(std::upper_bound(c_rad_.begin() + 1, c_rad_.end() - (wraps ? 0 : 1), c) - c_rad_.begin()) - 1;
  place.s = std::clamp((c - c_rad_[place.c]) / c_width(place.c), 0.0, 1.0);
  return true;
}

double Distribution::eval(double x, double y, double z) const {
  Place p;
  if ((x == 0 && y == 0 && z == 0) || !locate(x, y, z, p)) return 0;
  return plane_value(p.c, p.gamma, p.t) * (1 - p.s) + plane_value(p.c + 1, p.gamma, p.t) * p.s;
}

double Distribution::pdf_w(double x, double y, double z) const {
  return interpolated_flux_lm_ > 0 ? eval(x, y, z) / interpolated_flux_lm_ : 0;
}

float Distribution::fast_pdf_w(float x, float y, float z) const {
  if (!(interpolated_flux_lm_ > 0)) return 0;
  const DirectionT<float> d = to_native(type_, DirectionT<float>{x, y, z});
  return density_.at(d.x, d.y, d.z);
}

Distribution::Sample Distribution::sample(double u1, double u2) const {
  if (!(interpolated_flux_lm_ > 0)) return {0, 0, -1, 0, 0};
  const size_t n = cells();

  const double flux_below = u1 * interpolated_flux_lm_;
  const size_t j = find_cell(gamma_rad_.size() - 1, flux_below, [&](size_t k) { return band_cumulative_[k]; });
  const double* row = &c_cumulative_[j * (n + 1)];
  const double* next_row = row + n + 1;
  const Band band{gamma_rad_[j], gamma_rad_[j + 1] - gamma_rad_[j], row[n], next_row[n]};
  const double t =
      band.invert(fraction(flux_below - band_cumulative_[j], band_cumulative_[j + 1] - band_cumulative_[j]));

  const auto cumulative = [&](size_t k) { return row[k] * (1 - t) + next_row[k] * t; };
  const double c_target = u2 * cumulative(n);
  const size_t i = find_cell(n, c_target, cumulative);
  const double v0 = plane_value(i, j, t), v1 = plane_value(i + 1, j, t);
  const double s = invert_linear(v0, v1, fraction(c_target - cumulative(i), cumulative(i + 1) - cumulative(i)));

  const Direction d = from_native(type_, direction_of(c_rad_[i] + s * c_width(i), band.g0 + t * band.h));
  const double intensity = v0 * (1 - s) + v1 * s;
  return {d.x, d.y, d.z, intensity, intensity / interpolated_flux_lm_};
}

double Distribution::turns(double x, double y, double z) const {
  const Direction d = to_native(type_, Direction{x, y, z});
  const double t = (std::atan2(d.y, d.x) - c_rad_[0]) / (2 * pi);
  return t - std::floor(t);
}

bool Distribution::invert(double x, double y, double z, double& u1, double& u2) const {
  Place p;
  if ((x == 0 && y == 0 && z == 0) || !locate(x, y, z, p)) return false;
  if (c_rad_.size() == 1) p.s = turns(x, y, z);  // all around alike: locate() does not look where
  const double v0 = plane_value(p.c, p.gamma, p.t), v1 = plane_value(p.c + 1, p.gamma, p.t);
  if (!(v0 * (1 - p.s) + v1 * p.s > 0)) return false;
  const size_t n = cells();
  const double *row = &c_cumulative_[p.gamma * (n + 1)], *next_row = row + n + 1;
  const Band band{gamma_rad_[p.gamma], gamma_rad_[p.gamma + 1] - gamma_rad_[p.gamma], row[n], next_row[n]};
  const auto cumulative = [&](size_t k) { return row[k] * (1 - p.t) + next_row[k] * p.t; };
  const double part = c_width(p.c) * p.s * (v0 + 0.5 * p.s * (v1 - v0));
  u1 = std::clamp((band_cumulative_[p.gamma] + band.integral(p.t)) / interpolated_flux_lm_, 0.0, 1.0);
  u2 = std::clamp((cumulative(p.c) + part) / cumulative(n), 0.0, 1.0);
  return true;
}

}  // namespace photometry
