// What a pane lets through and reflects by angle of incidence, as measured: instead of what Fresnel's equations give.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

namespace ups {

class PaneTable {
 public:
  // angle_deg: ascending from 0 to 90; reflectance: empty: as Fresnel's.
  PaneTable(std::vector<float> angle_deg, std::vector<float> transmittance, std::vector<float> reflectance)
      : angle_deg_(std::move(angle_deg)), angle_(angle_deg_), transmittance_(std::move(transmittance)), reflectance_(std::move(reflectance)) {
    for (float& a : angle_) a *= 3.14159265f / 180;
  }
  // As they were given.
  const std::vector<float>& angle_deg() const { return angle_deg_; }
  const std::vector<float>& transmittance() const { return transmittance_; }
  const std::vector<float>& reflectance() const { return reflectance_; }
  bool has_reflectance() const { return !reflectance_.empty(); }
  bool transmits() const { return any(transmittance_); }
  bool reflects() const { return any(reflectance_); }
  // Between the angles of the table straight. reflectance: 0 where the table has none.
  void at(float cosine, float& reflectance, float& transmittance) const {
    const float angle = std::acos(std::min(cosine, 1.0f));
    const auto above = std::upper_bound(angle_.begin() + 1, angle_.end() - 1, angle);
    const auto i = size_t(above - angle_.begin());
    const float u = std::clamp((angle - angle_[i - 1]) / (angle_[i] - angle_[i - 1]), 0.0f, 1.0f);
    transmittance = transmittance_[i - 1] + u * (transmittance_[i] - transmittance_[i - 1]);
    reflectance = has_reflectance() ? reflectance_[i - 1] + u * (reflectance_[i] - reflectance_[i - 1]) : 0;
  }

 private:
  static bool any(const std::vector<float>& values) {
    return std::any_of(values.begin(), values.end(), [](float v) { return v > 0; });
  }
  std::vector<float> angle_deg_, angle_, transmittance_, reflectance_;  // angle_: rad
};

}  // namespace ups
