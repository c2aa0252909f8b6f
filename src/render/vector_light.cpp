// See vector_light.h.
#include "render/vector_light.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ups {

namespace {

constexpr Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

}  // namespace

// To first order, as of any linear function of the six. What one side alone does not know, the others cannot tell.
MeterLight VectorLight::along(const Vec3d& direction) const {
  MeterLight out{{}, {}, UINT32_MAX, {}, {true, true, true}, sides_[0]->merges_direct, {}};
  for (const MeterLight* side : sides_) out.visits = std::min(out.visits, side->visits);
  if (out.visits == 0) return out;
  out.photons.widest = true;
  float most = 0;
  double bias_variance = 0, most_unsure = 0;
  for (uint32_t i = 0; i < vector_sides; ++i) {
    const MeterLight& side = *sides_[i];
    const double share = dot(direction, Vec3d(axis_of_side(i))), size = std::abs(share);
    if (size == 0) continue;
    for (uint32_t b = 0; b < std::min(out.visits, batch_count); ++b) {  // sides may have been visited once more or less
      const double scale = share * visits_of_batch(out.visits, b) / visits_of_batch(side.visits, b);
      out.sums.value[b] += scale * side.sums.value[b];
      out.sums.direct[b] += scale * side.sums.direct[b];
      out.sums.bias[b] += scale * side.sums.bias[b];
    }
    const double visits = double(out.visits) / side.visits;
    out.sums.exact += share * visits * side.sums.exact;
    out.sums.exact_mirrored += share * visits * side.sums.exact_mirrored;
    out.sums.rounding += size * visits * side.sums.rounding;
    const float largest = side.sums.paths[whole_light].largest;
    if (size * double(largest) > out.largest_counts * double(most)) {
      most = largest, out.largest_counts = size;
      out.sums.largest_batch = side.sums.largest_batch, out.sums.largest = side.sums.largest;
      if (!out.sums.largest.path.is_light()) out.sums.largest.path.bits += i * eye_paths_;
    }
    for (const LightPart part : {whole_light, direct_light, indirect_light}) {
      out.sums.paths[part].add(side.sums.paths[part]);
      out.sums.batches[part] |= side.sums.batches[part];
      out.largest[part] = std::max(out.largest[part], size * side.largest[part]);
      out.exact[part] = out.exact[part] && side.exact[part];
      const auto [error, bound] = side.error_of(part);
      out.unfound[part] += size * (error < 0 ? std::max(bound, 0.0f) : float(side.unfound[part]));
      if (part == whole_light && error >= 0) {
        out.photons.caustic.shift += share * side.photons.caustic.shift;
        out.photons.caustic.chance += size * side.photons.caustic.chance;
      }
    }
    const double unsure = size * (side.unfound[whole_light] + side.photons.caustic.size());
    if (unsure > most_unsure) most_unsure = unsure, out.sums.caustics = side.sums.caustics;
    out.bias.mean += share * side.bias.mean;
    out.bias_apart = std::hypot(out.bias_apart, share * side.bias_apart);
    out.edge = std::hypot(out.edge, share * side.edge);
    bias_variance += std::pow(share * std::max(0.0, side.bias.standard_error), 2);
    out.photons.narrower += size * side.photons.narrower;
    out.photons.choice_variance += share * share * side.photons.choice_variance;
    out.photons.bias_scale = std::max(out.photons.bias_scale, side.photons.bias_scale);
    out.photons.halves_differ |= side.photons.halves_differ;
    if (side.photons.bias_scale > 0) out.photons.widest &= side.photons.widest;
  }
  out.sums.paths[whole_light].largest = most;
  out.bias.standard_error = std::sqrt(bias_variance);
  return out;
}

Vec3d VectorLight::vector(LightPart part) const {
  Vec3d v(0, 0, 0);
  for (uint32_t i = 0; i < vector_sides; ++i) v += Vec3d(axis_of_side(i)) * sides_[i]->mean_of(part);
  return v;
}

// Noise n across a vector makes it longer, by n^2 / 2 over its length in the mean, of one that noise alone makes by all
// of it.
MeterLight VectorLight::length(LightPart part) const {
  for (const MeterLight* side : sides_)
    if (side->visits == 0) return along(axes[2]);
  const Vec3d v = vector(part);
  const double length = ups::length(v);
  MeterLight out = along(length > 0 ? v / length : axes[2]);
  double noise2 = 0;
  for (const Vec3d& axis : axes) noise2 += std::pow(std::max(0.0f, along(axis).error_of(part).first), 2);
  const double across2 = noise2 - std::pow(std::max(0.0f, out.error_of(part).first), 2);
  const double longer = across2 > 0 && length > 0 ? std::min(length, across2 / (2 * length)) : 0;
  out.bias.mean += longer;
  if (!out.may_be_merged(part)) out.unfound[part] += longer;  // the bias of its merging is not this part's
  for (uint32_t b = 0; b < std::min(out.visits, batch_count); ++b)
    out.sums.bias[b] += longer * visits_of_batch(out.visits, b);
  return out;
}

ups_meter_reading VectorLight::reading(const MeterLight& length) const {
  ups_meter_reading r = length.reading();
  if (r.illuminance_lx < 0) return r;
  r.direct_lx = float(ups::length(vector(direct_light)));
  r.indirect_lx = float(ups::length(vector(indirect_light)));
  return r;
}

ups_meter_part_reading VectorLight::part(ups_light_part part) const { return length(light_part(part)).part(part); }

std::array<ups_vector_part_reading, 3> VectorLight::components() const {
  std::array<ups_vector_part_reading, 3> parts{};
  for (int k = 0; k < 3; ++k) {
    const MeterLight light = along(axes[k]);
    for (const ups_light_part part : {UPS_LIGHT_PART_DIRECT, UPS_LIGHT_PART_INDIRECT, UPS_LIGHT_PART_ALL}) {
      const LightPart of = light_part(part);
      ups_vector_part_reading& r = parts[size_t(part)];
      r.standard_error_lx[k] = r.error_bound_lx[k] = -1;
      if (light.visits == 0) continue;
      r.vector_lx[k] = float(light.mean_of(of));
      r.bias_lx[k] = float(light.bias_of(of));
      std::tie(r.standard_error_lx[k], r.error_bound_lx[k]) = light.error_of(of);
    }
  }
  return parts;
}

}  // namespace ups
