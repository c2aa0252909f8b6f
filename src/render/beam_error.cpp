// See beam_error.h. An angle is no mean of batches: its noise is found by leaving out one batch after the other
// (Quenouille 1956, Tukey 1958), its blur by the angle of intensities without their estimated bias.
#include "render/beam_error.h"

#include "photometry/metrics.h"

namespace ups {

namespace {

template <class Intensity>
photometry::Beam beam_of(const Goniometer& goniometer, double c_deg, double fraction, const Intensity& intensity) {
  std::vector<double> all;
  for (uint32_t node = 0; node < goniometer.node_count(); ++node) all.push_back(std::max(0.0, double(intensity(node))));
  photometry::Photometry data{photometry::Distribution(goniometer.c_deg(), goniometer.gamma_deg(), std::move(all))};
  data.symmetry = goniometer.symmetry();
  return photometry::beam_of(data, c_deg, fraction);
}

// Between a peak and the edge that the interpolation puts before the next node the light may end anywhere.
double unresolved_deg(const Goniometer& goniometer, const photometry::Beam& beam) {
  constexpr double rounding = 0.01;
  const auto has_node = [&](double from, double to) {
    for (const double gamma : goniometer.gamma_deg())
      for (const double angle : {gamma, -gamma, 360 - gamma, gamma - 360})
        if (angle > from + rounding && angle < to - rounding) return true;
    return false;
  };
  return (has_node(beam.from_deg, beam.peak_deg) ? 0 : beam.peak_deg - beam.from_deg) +
         (has_node(beam.peak_deg, beam.to_deg) ? 0 : beam.to_deg - beam.peak_deg);
}

}  // namespace

ups_goniometer_beam beam_with_error(const Goniometer& goniometer, const GoniometerReading& r, double c_deg,
                                    double fraction) {
  const auto beam = [&](const auto& intensity) { return beam_of(goniometer, c_deg, fraction, intensity); };
  const auto angle = [&](const auto& intensity) { return beam(intensity).angle_deg; };
  ups_goniometer_beam out{};
  out.struct_size = sizeof out;
  const photometry::Beam of_nodes = beam([&](uint32_t node) { return r.nodes[node].intensity_cd; });
  const double whole = of_nodes.angle_deg;
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
  out.low_deg = float(std::max(0.0, whole - bound - unresolved_deg(goniometer, of_nodes)));
  out.high_deg = float(std::min(360.0, whole + bound));
  return out;
}

}  // namespace ups
