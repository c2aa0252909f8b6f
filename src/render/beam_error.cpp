// See beam_error.h. An angle is no mean of batches: its noise is found by leaving out one batch after the other
// (Quenouille 1956, Tukey 1958), its blur by the angle of intensities without their estimated bias.
#include "render/beam_error.h"

#include "photometry/metrics.h"

namespace ups {

namespace {

template <class Intensity>
double angle_of(const Goniometer& goniometer, double c_deg, double fraction, const Intensity& intensity) {
  std::vector<double> all;
  for (uint32_t node = 0; node < goniometer.node_count(); ++node) all.push_back(std::max(0.0, double(intensity(node))));
  photometry::Photometry data{photometry::Distribution(goniometer.c_deg(), goniometer.gamma_deg(), std::move(all))};
  data.symmetry = goniometer.symmetry();
  return photometry::beam_of(data, c_deg, fraction).angle_deg;
}

}  // namespace

ups_goniometer_beam beam_with_error(const Goniometer& goniometer, const GoniometerReading& r, double c_deg,
                                    double fraction) {
  const auto angle = [&](const auto& intensity) { return angle_of(goniometer, c_deg, fraction, intensity); };
  ups_goniometer_beam out{};
  out.struct_size = sizeof out;
  const double whole = angle([&](uint32_t node) { return r.nodes[node].intensity_cd; });
  out.angle_deg = float(whole);
  out.standard_error_deg = out.low_deg = out.high_deg = -1;
  const uint32_t used = uint32_t(r.without_batch.size());
  if (whole < 0 || used < min_batches) return out;
  const double unblurred =
      angle([&](uint32_t node) { return r.nodes[node].intensity_cd - r.nodes[node].bias_cd; });
  std::vector<double> left;
  double mean = 0, square = 0;
  for (uint32_t b = 0; b < used; ++b) {
    left.push_back(angle([&](uint32_t node) { return r.without_batch[b][goniometer.representative(node)]; }));
    if (left.back() < 0) return out;
    mean += left.back() / used;
  }
  for (const double a : left) square += (a - mean) * (a - mean);
  if (unblurred < 0) return out;
  const double error = std::sqrt(square * (used - 1) / used);
  out.standard_error_deg = float(error);
  out.bias_deg = float(whole - unblurred);
  const double bound = std::abs(whole - unblurred) + t_quantile(used) * error;
  out.low_deg = float(std::max(0.0, whole - bound));
  out.high_deg = float(std::min(360.0, whole + bound));
  return out;
}

}  // namespace ups
