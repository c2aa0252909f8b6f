// See goniometer_sums.h. A node's bias is the difference of its two sets of hats (sensor/goniometer.h).
#include "render/goniometer_sums.h"

namespace ups {

GoniometerSums::GoniometerSums(const Goniometer& goniometer, double emitted_lm, uint32_t light_paths)
    : goniometer_(goniometer), emitted_lm_(emitted_lm), largest_(light_paths ? emitted_lm / light_paths : 0),
      wide_(goniometer.node_count() * batch_count), narrow_(wide_.size()) {}

void GoniometerSums::add(uint32_t batch, const GoniometerTally& tally) {
  for (size_t i = 0; i < tally.wide.size(); ++i) {
    wide_[i * batch_count + batch] += tally.wide[i];
    narrow_[i * batch_count + batch] += tally.narrow[i];
  }
  flux_[batch] += tally.flux;
  for (int k = 0; k < 4; ++k) moments_[k][batch] += tally.moments[k];
  outside_ += tally.outside;
  largest_ = std::max(largest_, tally.largest);
}

// Where the intensity has a kink the blur of a hat grows with its width, so that half the width changes half of it;
// elsewhere with the square, so that the blur is said half as large again. The difference is taken batch by batch: its
// spread is its own noise.
ups_intensity_reading GoniometerSums::read_node(uint32_t node, uint32_t iterations) const {
  double wide[batch_count], blur[batch_count];
  const double per_sr = 1 / goniometer_.wide_solid_angle(node),
               narrow_per_sr = 1 / goniometer_.narrow_solid_angle(node);
  for (uint32_t b = 0; b < batch_count; ++b) {
    wide[b] = wide_[size_t(node) * batch_count + b] * per_sr;
    blur[b] = 2 * (wide[b] - narrow_[size_t(node) * batch_count + b] * narrow_per_sr);
  }
  const Spread i = spread(wide, iterations), b = spread(blur, iterations);
  ups_intensity_reading out;
  out.intensity_cd = float(i.mean);
  out.standard_error_cd = float(i.standard_error);
  out.bias_cd = float(b.mean);
  out.error_bound_cd = error_bound(i, b, iterations);
  const ChanceLight light = chance(node, iterations);
  if (i.standard_error < 0 || !(emitted_lm_ > 0) || light.is_enough(iterations)) return out;
  out.standard_error_cd = -1;
  out.error_bound_cd = largest_ > 0 ? float(std::abs(b.mean) + light.bound(largest_, iterations) * per_sr) : -1;
  return out;
}

bool GoniometerSums::relative_errors(uint32_t iterations, std::vector<double>& out) const {
  std::vector<ups_intensity_reading> own;
  double peak = 0;
  for (uint32_t node = 0; node < goniometer_.node_count(); ++node) {
    if (goniometer_.representative(node) != node) continue;
    own.push_back(read_node(node, iterations));
    if (own.back().error_bound_cd < 0) return false;
    peak = std::max(peak, double(own.back().intensity_cd));
  }
  if (!(emitted_lm_ > 0)) peak = 1;
  if (!(peak > 0)) peak = emitted_lm_ / (4 * pi_d);
  for (const ups_intensity_reading& r : own)
    out.push_back(r.error_bound_cd / std::max(double(r.intensity_cd), share_of_mean * peak));
  return true;
}

double GoniometerSums::mean_noise(uint32_t iterations) const {
  double noise = 0, flux = 0, of_dark = 0;
  for (uint32_t node = 0; node < goniometer_.node_count(); ++node) {
    if (goniometer_.representative(node) != node) continue;
    const Spread s = spread(&wide_[size_t(node) * batch_count], iterations);  // flux, lm
    if (s.standard_error < 0) return -1;
    if (const ChanceLight light = chance(node, iterations); light.batches == 0)
      of_dark = light.bound(largest_, iterations);
    noise += t_quantile(iterations) * s.standard_error;
    flux += s.mean;
  }
  if (!(emitted_lm_ > 0)) return 0;
  if (!(largest_ > 0)) return -1;
  return (noise + of_dark) / (flux > 0 ? flux : emitted_lm_);
}

// Six standard errors and half a percent of the flux: neither noise nor the facets of a round thing.
std::string GoniometerSums::asymmetry(uint32_t iterations) const {
  using photometry::Symmetry;
  const Symmetry told = goniometer_.symmetry();
  const bool axial = told == Symmetry::axial, both = axial || told == Symmetry::quadrants;
  const bool zero[4] = {both || told == Symmetry::c90_c270, both || told == Symmetry::c0_c180, told != Symmetry::none,
                        axial};
  static const char* const words[4] = {"more light goes to one side of the plane C90-C270",
                                       "more light goes to one side of the plane C0-C180",
                                       "more light goes to one diagonal than to the other",
                                       "the planes C0-C180 and C90-C270 differ"};
  const double flux = spread(flux_, iterations).mean;
  for (int k = 0; k < 4; ++k) {
    const Spread m = spread(moments_[k], iterations);
    if (zero[k] && m.standard_error >= 0 && std::abs(m.mean) > 6 * m.standard_error + 0.005 * flux) return words[k];
  }
  return {};
}

GoniometerReading GoniometerSums::read(uint32_t iterations) const {
  GoniometerReading r;
  for (uint32_t node = 0; node < goniometer_.node_count(); ++node) {
    const uint32_t own = goniometer_.representative(node);
    r.nodes.push_back(own < node ? r.nodes[own] : read_node(own, iterations));
  }
  const uint32_t used = iterations < min_batches ? 0 : std::min(iterations, batch_count);
  for (uint32_t b = 0; b < used; ++b) {
    std::vector<float>& without = r.without_batch.emplace_back(goniometer_.node_count());
    for (uint32_t node = 0; node < goniometer_.node_count(); ++node) {
      if (goniometer_.representative(node) != node) continue;
      const double* sums = &wide_[size_t(node) * batch_count];
      const double left = spread(sums, iterations).mean * iterations - sums[b];
      without[node] =
          float(left / ((iterations - visits_of_batch(iterations, b)) * goniometer_.wide_solid_angle(node)));
    }
  }
  const Spread flux = spread(flux_, iterations);
  ups_goniometer_info& info = r.info;
  info.struct_size = sizeof info;
  info.c_count = uint32_t(goniometer_.c_deg().size());
  info.gamma_count = uint32_t(goniometer_.gamma_deg().size());
  info.flux_lm = flux.mean;
  info.flux_standard_error_lm = flux.standard_error;
  info.outside_flux_lm = iterations ? outside_ / iterations : 0;
  if (emitted_lm_ > 0 && !chance_light(flux_, iterations).is_enough(iterations)) info.flux_standard_error_lm = -1;
  info.emitted_flux_lm = emitted_lm_;
  info.light_output_ratio = emitted_lm_ > 0 ? flux.mean / emitted_lm_ : 0;
  info.light_output_ratio_standard_error =
      emitted_lm_ > 0 && info.flux_standard_error_lm >= 0 ? info.flux_standard_error_lm / emitted_lm_ : -1;
  std::vector<double> errors, lit;
  info.worst_relative_error_bound = info.median_relative_error_bound = -1;
  const bool lit_somewhere =
      std::any_of(r.nodes.begin(), r.nodes.end(), [](const auto& n) { return n.intensity_cd > 0; });
  if ((lit_somewhere || !(emitted_lm_ > 0)) && relative_errors(iterations, errors)) {
    info.worst_relative_error_bound = *std::max_element(errors.begin(), errors.end());
    size_t i = 0;
    for (uint32_t node = 0; node < goniometer_.node_count(); ++node)
      if (goniometer_.representative(node) == node) {
        if (r.nodes[node].intensity_cd > 0) lit.push_back(errors[i]);  // half of most lamps' nodes are dark
        ++i;
      }
    info.median_relative_error_bound = lit.empty() ? 0 : quantile(lit, 0.5);
  }
  return r;
}

}  // namespace ups
