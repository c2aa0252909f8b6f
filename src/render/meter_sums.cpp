// See meter_sums.h.
#include "render/meter_sums.h"

#include <bit>
#include <tuple>

#include "render/tails.h"
#include "render/zero_bound.h"

namespace ups {

void MeterSums::add(uint32_t batch, const MeterTally& t, uint32_t iteration) {
  value[batch] += t.value;
  direct[batch] += t.direct;
  bias[batch] += t.bias;
  exact += t.exact;
  exact_mirrored += t.exact_mirrored;
  rounding += t.rounding;
  count_up(caustics, t.caustics);
  if (t.paths[whole_light].largest > paths[whole_light].largest)
    largest_batch = uint8_t(batch), largest = {iteration, t.largest};
  for (size_t k = 0; k < light_part_count; ++k) {
    paths[k].add(t.paths[k]);
    if (t.paths[k].count > 0) batches[k] |= uint16_t(1u << batch);
  }
}

void MeterSums::add(const MeterRings::Photons& photons) {
  if (photons.paths.largest > paths[whole_light].largest)
    largest_batch = photons.largest_batch, largest = photons.largest;
  count_up(caustics, photons.caustics);
  for (uint32_t b = 0; b < batch_count; ++b) {
    value[b] += photons.value[b];
    direct[b] += photons.direct[b];
    bias[b] += photons.bias[b];
    const double parts[] = {photons.value[b], photons.direct[b], photons.value[b] - photons.direct[b]};
    for (size_t k = 0; k < light_part_count; ++k)
      if (parts[k] > 1e-9 * photons.value[b]) batches[k] |= uint16_t(1u << b);
  }
  for (const LightPart part : {whole_light, direct_light, indirect_light})
    if (part != direct_light || photons.brings_direct) paths[part].add(photons.paths);
}

std::pair<float, float> MeterLight::error_of(LightPart part, MeterError* apart) const {
  const bool direct = part == direct_light;
  const double exact_of[] = {sums.exact, sums.exact - sums.exact_mirrored, sums.exact_mirrored},
               of_exact = exact_of[part] / visits, rounding = exact_of[part] != 0 ? sums.rounding / visits : 0;
  if (exact[part]) return {0.0f, float(rounding)};
  double values[batch_count];
  ChanceLight light{sums.paths[part].count, uint32_t(std::popcount(sums.batches[part])), 0};
  for (uint32_t b = 0; b < batch_count; ++b) {
    values[b] = direct ? sums.direct[b] : part == indirect_light ? sums.value[b] - sums.direct[b] : sums.value[b];
    light.largest_batch = std::max(light.largest_batch, values[b] - of_exact * visits_of_batch(visits, b));
  }
  // Light straight from emitters that no photon brings is not biased, nor has it any part in the choice of discs.
  const bool merged = may_be_merged(part), halves_differ = merged && photons.halves_differ;
  const Spread blur = merged ? bias : Spread{0, 0};
  const double narrower = merged ? photons.narrower : 0, shift = direct ? 0 : std::abs(photons.caustic.shift),
               chance = direct ? 0 : photons.caustic.chance;
  Spread e = halves_differ ? spread_of_halves(values, visits) : spread(values, visits);
  if (e.standard_error < 0) return {-1.0f, -1.0f};
  if (merged) e.standard_error = std::hypot(e.standard_error, std::sqrt(photons.choice_variance));
  const double offset = std::abs(blur.mean);
  const double added = rounding + unfound[part];
  if (!light.is_enough(visits)) {
    const double bound = std::max(offset + light.bound(largest[part], visits), narrower) + shift + chance + added;
    if (apart) *apart = {.bias = float(offset), .unfound = float(bound - offset), .paths = float(light.paths)};
    return {-1.0f, float(bound)};
  }
  // A disc is chosen that has less bias than noise: where it may be noise, its standard error counts once, unless it is
  // so large beside the reading's own, whose photons are stratified, that it could not tell. Nor is bias known better
  // than its model: a fit of even curvature sees three fifths of a slope's, so 95 % are taken to be within two thirds.
  const bool noise = offset <= 2 * blur.standard_error,
             once = noise && photons.bias_scale > 0 && blur.standard_error < 3 * e.standard_error;
  const uint32_t means = halves_differ ? 2 : 1;
  const double t = noise ? t_quantile(visits, means, offset, e.standard_error) : t_quantile(visits, means),
               model = 0.31 * std::max(offset, merged ? bias_apart : 0.0),
               bound = offset + std::hypot(t * e.standard_error, (once ? 1 : t) * blur.standard_error, t * model);
  // What is chance of narrow caustics is independent of all that.
  const double known = std::max(bound, narrower), whole = offset + shift + std::hypot(known - offset, chance);
  if (apart) {
    const bool disc = merged && photons.bias_scale > 0;
    // Bias is estimated with four times the variance that merging has, batch by batch. All but rays and what bias makes
    // falls as merging does, and of an edge beside the meter what more photons tell of it.
    const double all = known - offset, own = merged ? spread(sums.bias, visits).standard_error : 0,
                 of_rays = std::max(0.0, std::pow(e.standard_error, 2) - photons.choice_variance - own * own / 4),
                 share = all > 0 ? t * t / (all * all) : 0, of_bias = share * model * model,
                 of_edge = (once ? share / (t * t) : share) * std::pow(std::min(merged ? edge : 0, blur.standard_error), 2);
    *apart = {.noise = float(all),
              .bias = float(offset),
              .merged = float(merged && all > 0 ? std::max(0.0, 1 - share * of_rays - of_edge - of_bias) : 0),
              .deviations = blur.standard_error > 0 ? float(offset / blur.standard_error) : 1e9f,
              .unfound = float(added + whole - known),
              .paths = float(sums.caustics),
              .of_bias = float(of_bias),
              .widest = disc && photons.widest,
              .narrower = disc && !photons.widest,
              .visits = visits};
  }
  return {float(e.standard_error), float(whole + added)};
}

ups_meter_reading MeterLight::reading() const {
  if (visits == 0) return {-1, -1, -1, -1, -1, -1};
  const double value = spread(sums.value, visits).mean;
  ups_meter_reading out;
  out.illuminance_lx = float(value);
  out.direct_lx = float(spread(sums.direct, visits).mean);
  out.indirect_lx = float(std::max(0.0, value - double(out.direct_lx)));
  out.bias_lx = float(bias.mean);
  std::tie(out.standard_error_lx, out.error_bound_lx) = error_of(whole_light);
  return out;
}

LightPart light_part(ups_light_part part) {
  return part == UPS_LIGHT_PART_DIRECT ? direct_light : part == UPS_LIGHT_PART_INDIRECT ? indirect_light : whole_light;
}

double MeterLight::mean_of(LightPart part) const {
  const double direct = spread(sums.direct, visits).mean;
  return part == direct_light ? direct : spread(sums.value, visits).mean - (part == whole_light ? 0 : direct);
}

double MeterLight::merged_lx() const {
  if (visits == 0) return 0;
  const double without_merging = merges_direct ? sums.exact : sums.exact_mirrored;
  return std::max(0.0, mean_of(merges_direct ? whole_light : indirect_light) - without_merging / visits);
}

ups_meter_part_reading MeterLight::part(ups_light_part part) const {
  if (visits == 0) return {-1, -1, -1, -1};
  const LightPart of = light_part(part);
  ups_meter_part_reading out;
  out.illuminance_lx = float(std::max(0.0, mean_of(of)));
  out.bias_lx = float(bias_of(of));
  std::tie(out.standard_error_lx, out.error_bound_lx) = error_of(of);
  return out;
}

uint32_t MeterLight::flags(const ups_meter_reading& r) const {
  if (r.error_bound_lx < 0) return UPS_READING_UNKNOWN;
  if (r.standard_error_lx < 0) return UPS_READING_FEW_PATHS;
  const PathRecord& paths = sums.paths[whole_light];
  if (paths.count == 0) return UPS_READING_EXACT;
  const double by_chance = spread(sums.value, visits).mean - sums.exact / visits,
               batch = sums.value[sums.largest_batch] -
                       sums.exact / visits * visits_of_batch(visits, sums.largest_batch);
  uint32_t flags = 0;
  if (single_path_dominates(largest_counts * double(paths.largest), paths.count, by_chance, batch, r.standard_error_lx,
                            visits))
    flags |= UPS_READING_SINGLE_PATH;
  if (batch_kurtosis(sums.value, visits) > largest_kurtosis) flags |= UPS_READING_HEAVY_TAIL;
  return flags;
}

}  // namespace ups
