// See goniometer.h: nodes that symmetry makes alike, integrals of the hats, and flux divided among the nodes.
#include "sensor/goniometer.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace ups {

namespace {

// Integral of sin(gamma) times a function that falls linearly from 1 at gamma to 0 at gamma + h (h < 0: towards the
// nadir). = |cos g - (sin(g + h) - sin g) / h|, written so that small h keep their digits.
double hat_side(double gamma, double h) {
  const double y = 0.5 * h, middle = gamma + y;
  // cos g = cos(m - y); (sin(g + h) - sin g) / h = cos(m) sin(y) / y
  const double sinc_deficit =
      std::abs(y) > 0.05 ? 1 - std::sin(y) / y : y * y * (1.0 / 6 - y * y * (1.0 / 120 - y * y / 5040));
  const double cos_deficit = 2 * std::pow(std::sin(0.5 * y), 2);
  return std::abs(std::sin(middle) * std::sin(y) + std::cos(middle) * (sinc_deficit - cos_deficit));
}

// The last element at or below x; x is not below the first.
size_t cell_of(const std::vector<double>& v, double x) {
  return size_t(std::upper_bound(v.begin() + 1, v.end(), x) - v.begin()) - 1;
}

}  // namespace

Goniometer::Goniometer(const Frame& frame, std::vector<double> c_deg, std::vector<double> gamma_deg, Symmetry symmetry)
    : frame_(frame),
      symmetry_(c_deg.size() == 1 ? Symmetry::axial : symmetry),
      c_deg_(std::move(c_deg)),
      gamma_deg_(std::move(gamma_deg)) {
  for (double c : c_deg_) c_rad_.push_back(c / 180 * pi_d);
  for (double g : gamma_deg_) gamma_rad_.push_back(g / 180 * pi_d);
  find_representatives();
  integrate_hats();
}

void Goniometer::find_representatives() {
  if (symmetry_ == Symmetry::axial && c_deg_.size() > 1)
    fail_argument("symmetry is UPS_SYMMETRY_AXIAL, but c_count is " + std::to_string(c_deg_.size()) + "; it must be 1");
  constexpr double same = 1e-4;  // degrees; angles may come as floats
  const auto plane_at = [&](double c) {
    c = std::fmod(c + 720, 360);
    const size_t planes = c_deg_.size(),
                 next = size_t(std::lower_bound(c_deg_.begin(), c_deg_.end(), c) - c_deg_.begin());
    for (const size_t i : {(next + planes - 1) % planes, next % planes})
      if (const double d = std::abs(c_deg_[i] - c); d < same || d > 360 - same) return i;
    fail_argument("symmetry: the planes must be as symmetric as the fixture, but there is none at C " +
                  std::to_string(c));
  };
  std::vector<uint32_t> plane(c_deg_.size());
  for (size_t i = 0; i < plane.size(); ++i) {
    size_t first = i;
    const bool about_0 = symmetry_ == Symmetry::c0_c180 || symmetry_ == Symmetry::quadrants;
    const bool about_90 = symmetry_ == Symmetry::c90_c270 || symmetry_ == Symmetry::quadrants;
    if (about_0) first = std::min(first, plane_at(-c_deg_[i]));
    if (about_90) first = std::min(first, plane_at(180 - c_deg_[i]));
    if (about_0 && about_90) first = std::min(first, plane_at(180 + c_deg_[i]));
    plane[i] = uint32_t(first);
  }
  for (size_t c = 0; c < c_deg_.size(); ++c)
    for (size_t g = 0; g < gamma_deg_.size(); ++g) {
      const bool pole = gamma_deg_[g] == 0 || gamma_deg_[g] == 180;
      representative_.push_back(uint32_t(node(pole ? 0 : plane[c], g)));
    }
}

void Goniometer::integrate_hats() {
  wide_.assign(node_count(), 0);
  narrow_ = wide_;
  const size_t planes = c_deg_.size(), rows = gamma_deg_.size();
  for (size_t c = 0; c < planes; ++c) {
    const double before = c_rad_[c] - (c ? c_rad_[c - 1] : c_rad_[planes - 1] - 2 * pi_d);
    const double after = (c + 1 < planes ? c_rad_[c + 1] : c_rad_[0] + 2 * pi_d) - c_rad_[c];
    const double across = planes > 1 ? 0.5 * (before + after) : 2 * pi_d,
                 narrow_across = planes > 1 ? 0.5 * across : across;
    for (size_t g = 0; g < rows; ++g) {
      double along = 0, narrow_along = 0;
      for (int side : {-1, 1}) {
        const size_t next = g + size_t(side);
        if (next >= rows) continue;  // below 0 too
        const double h = gamma_rad_[next] - gamma_rad_[g];
        along += hat_side(gamma_rad_[g], h);
        narrow_along += hat_side(gamma_rad_[g], 0.5 * h);
      }
      const uint32_t r = representative_[node(c, g)];
      wide_[r] += across * along;
      narrow_[r] += narrow_across * narrow_along;
    }
  }
}

GoniometerTally Goniometer::empty_tally() const {
  return {std::vector<double>(node_count()), std::vector<double>(node_count()), 0, 0, 0, {}};
}

void Goniometer::add(const Vec3& direction, double flux, GoniometerTally& tally) const {
  const Vec3d local(frame_.to_local(direction));
  const double gamma = std::atan2(std::hypot(local.x, local.y), -local.z);
  tally.flux += flux;
  tally.largest = std::max(tally.largest, flux);
  const double moments[4] = {local.x, local.y, local.x * local.y, local.x * local.x - local.y * local.y};
  for (int k = 0; k < 4; ++k) tally.moments[k] += flux * moments[k];
  if (gamma < gamma_rad_.front() || gamma > gamma_rad_.back()) {
    tally.outside += flux;
    return;
  }
  const size_t rows = gamma_deg_.size(), planes = c_deg_.size();
  const size_t g = std::min(cell_of(gamma_rad_, gamma), rows - 2);
  const double t = (gamma - gamma_rad_[g]) / (gamma_rad_[g + 1] - gamma_rad_[g]);
  size_t c = 0;
  double s = 0;
  if (planes > 1) {
    double azimuth = std::atan2(local.y, local.x);
    if (azimuth < 0) azimuth += 2 * pi_d;
    c = cell_of(c_rad_, azimuth);
    s = (azimuth - c_rad_[c]) / ((c + 1 < planes ? c_rad_[c + 1] : 2 * pi_d) - c_rad_[c]);
  }
  for (int i = 0; i < (planes > 1 ? 2 : 1); ++i)
    for (int j = 0; j < 2; ++j) {
      const double across = planes > 1 ? (i ? s : 1 - s) : 1, along = j ? t : 1 - t;
      const uint32_t r = representative_[node((c + size_t(i)) % planes, g + size_t(j))];
      tally.wide[r] += flux * across * along;
      const double narrow_across = planes > 1 ? std::max(0.0, 2 * across - 1) : 1;
      tally.narrow[r] += flux * narrow_across * std::max(0.0, 2 * along - 1);
    }
}

}  // namespace ups
