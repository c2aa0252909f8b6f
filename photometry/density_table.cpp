// See density_table.h. Every operation is one of IEEE 754, so that all machines have the same bits.
#include "photometry/density_table.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846;

// atan2(y, x) without a branch: in (-pi/8, pi/8) by the polynomial of Moshier's Cephes library (atanf.c), from there by
// octants. 0 for (0, 0).
float angle_of(float y, float x) {
  static constexpr float sign[8] = {1, 1, -1, -1, -1, -1, 1, 1};
  static constexpr float offset[8] = {0,         float(pi / 4),     float(pi / 2), float(pi / 4),
                                      float(pi), float(3 * pi / 4), float(pi / 2), float(3 * pi / 4)};
  const float a = std::abs(y), b = std::abs(x), small = std::min(a, b), large = std::max(a, b);
  const bool turned = small > 0.414213562f * large;  // by pi/4
  const float turn = float(turned), q = (small - turn * large) / std::max(large + turn * small, FLT_MIN), q2 = q * q;
  const float power =
      (8.05374449538e-2f * q2 - 1.38776856032e-1f) * (q2 * q2) + (1.99777106478e-1f * q2 - 3.33329491539e-1f);
  const int octant = 4 * int(std::signbit(x)) + 2 * int(a > b) + int(turned);
  return std::copysign(offset[octant] + sign[octant] * (power * (q2 * q) + q), y);
}

}  // namespace

DensityTable::Nodes::Nodes(const std::vector<double>& rad) {
  const size_t n = rad.size();
  for (const double angle : rad) nodes_.push_back({float(angle), 0});
  float narrowest = nodes_[n - 1].angle - nodes_[0].angle;
  for (size_t i = 0; i + 1 < n; ++i) {
    const float width = nodes_[i + 1].angle - nodes_[i].angle;
    if (!(width > FLT_MIN)) continue;  // in single precision; find() passes over it, and of less the inverse is none
    nodes_[i].inverse_width = 1 / width;
    narrowest = std::min(narrowest, width);
  }
  const float range = nodes_[n - 1].angle - nodes_[0].angle;
  // Of equal nodes each is in a step of its own, just above its start.
  if (range > FLT_MIN) steps_per_rad_ = 1.000001f * std::min(1 / narrowest, 2 * float(n) / range);
  before_.assign(step(nodes_[n - 1].angle) + 2, 0);
  for (size_t i = 1; i + 1 < n; ++i) before_[step(nodes_[i].angle) + 1] = uint32_t(i);
  for (size_t k = 1; k < before_.size(); ++k) before_[k] = std::max(before_[k], before_[k - 1]);
}

uint32_t DensityTable::Nodes::find(float angle, float& place) const {
  const uint32_t k = step(angle);
  uint32_t low = before_[k], high = before_[k + 1];
  while (low < high) {  // hardly ever more than once
    const uint32_t middle = (low + high + 1) / 2;
    if (nodes_[middle].angle <= angle) low = middle;
    else high = middle - 1;
  }
  place = std::min((angle - nodes_[low].angle) * nodes_[low].inverse_width, 1.0f);
  return low;
}

DensityTable::DensityTable(const std::vector<double>& plane_rad, const std::vector<double>& row_rad,
                           std::vector<float> density)
    : planes_(plane_rad), rows_(row_rad), density_(std::move(density)) {}

float DensityTable::at(float x, float y, float z) const {
  const float polar = angle_of(std::sqrt(x * x + y * y), -z);
  if (!rows_.contain(polar)) return 0;
  float t, s;
  const float* row = &density_[rows_.find(polar, t)];
  if (planes_.size() == 1) return row[0] * (1 - t) + row[1] * t;
  float azimuth = angle_of(y, x);
  azimuth += float(azimuth < planes_.first()) * float(2 * pi);
  if (!planes_.contain(azimuth)) return 0;
  row += planes_.find(azimuth, s) * rows_.size();
  const float* next = row + rows_.size();
  return (row[0] * (1 - t) + row[1] * t) * (1 - s) + (next[0] * (1 - t) + next[1] * t) * s;
}

}  // namespace photometry
