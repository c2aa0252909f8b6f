// See profile_plot.h.
#include "report/profile_plot.h"

#include <cmath>

namespace ups::report {

std::vector<PlaneReport> drawn_planes(const ProfileReport& report) {
  std::vector<PlaneReport> planes;
  for (const int plane : {0, 1}) planes.push_back({90.0 * plane, report.beam[plane], report.field[plane]});
  if (report.peak_plane) planes.push_back(*report.peak_plane);
  return planes;
}

Prefix prefix_of(double largest) {
  if (largest >= 1e6) return {1e6, "M"};
  if (largest >= 1e5) return {1e3, "k"};
  if (largest >= 0.1 || largest <= 0) return {1, ""};
  return largest >= 1e-4 ? Prefix{1e-3, "m"} : Prefix{1e-6, "\u00b5"};
}

double round_step(double smallest) {
  if (!(smallest > 0)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(smallest)));
  const double factor = smallest / power * (1 - 1e-12);
  return power * (factor <= 1 ? 1 : factor <= 2 ? 2 : factor <= 5 ? 5 : 10);
}

bool is_per_kilolumen(const ProfileReport& report) { return report.info.light_output_ratio >= 0; }

}  // namespace ups::report
