// See direct_light.h.
#include "transport/direct_light.h"

#include <algorithm>

#include "base/per_thread.h"
#include "transport/techniques.h"

namespace ups {

namespace {

constexpr size_t most_rays = size_t(1) << 22, most_looks = size_t(1) << 26, most_looks_at_images = size_t(1) << 23;
constexpr float unit_roundoff = 0x1p-24f;

// At most, relative: of some dozens of operations, and of both ends' places in distance and response, E ~ W / d^2.
float relative_rounding(const Iteration& in, const Meter& meter, const EyeEnd& eye, const Contribution& c) {
  const bool mirrored = c.mirror != none;  // which doubles what the plane is off by
  const Vec3 way = (mirrored ? c.at_mirror : c.to) - c.from;
  const float d = length(way), whole = mirrored ? d + length(c.to - c.at_mirror) : d,
              response = eye.response.kind == UPS_METER_PLANAR
                             ? dot(way, meter.frame.n) / d
                             : eye.response.value(eye.surface.shading.to_local(way / d)),
              cosine = std::max(response, min_cosine);
  const float place = (mirrored ? 32 : 2) * unit_roundoff * in.scene.radius + meter.error + meter.moved;
  return 64 * unit_roundoff + place / whole * (2 + 2 / cosine);
}

}  // namespace

DirectLight::DirectLight(const Snapshot& scene, const Plan& plan, const TransportSettings& settings) {
  size_t points = 0;
  for (const MeterSet& set : scene.meter_sets) points += set.is_cell() ? 0 : set.meters.size();
  for (uint32_t i = 0; i < plan.exact.size(); ++i)
    if (plan.exact[i]) emitters_.push_back(i);
  if (points == 0 || emitters_.empty() || settings.actual_perturbation || points > most_looks / emitters_.size())
    return;
  for (uint32_t i = 0; settings.has(UPS_TECHNIQUE_MIRROR_SAMPLE) && i < scene.flat_mirrors.images.size(); ++i)
    if (plan.exact[scene.flat_mirrors.images[i].emitter]) images_.push_back(i);
  if (points * images_.size() > most_looks_at_images) images_.clear();
  most_ = std::max<size_t>(1, most_rays / points);
  for (const MeterSet& set : scene.meter_sets) {
    const size_t count = set.is_cell() ? 0 : set.meters.size();
    meters_.emplace_back(count);
    separated_.emplace_back(count * plan.separation.columns.size());
  }
}

size_t DirectLight::bytes() const {
  size_t sum = 0;
  for (const auto& set : meters_) sum += set.size() * sizeof(OfMeter);
  for (const auto& set : separated_) sum += set.size() * sizeof(OfColumn);
  return sum;
}

void DirectLight::find(const Iteration& in, ThreadPool& pool, WorkCounts& work) {
  if (in.plan.meter_pass(in.number) > 0) return;
  constexpr size_t per_block = 16;
  for (size_t s = 0; s < meters_.size(); ++s) {
    const size_t visited = meters_[s].empty() ? 0 : in.plan.visited_meters(in.number, meters_[s].size());
    std::vector<WorkCounts> of_block((visited + per_block - 1) / per_block);
    pool.for_blocks(visited, per_block, [&](size_t b, size_t begin, size_t end) {
      for (size_t i = begin; i < end && !in.stop.is_set(); ++i)
        if (const uint32_t m = in.plan.visited_meter(in.number, i); !meters_[s][m].is_found)
          find(in, s, m, of_block[b]);
    });
    for (const WorkCounts& w : of_block) work.add(w);
  }
}

void DirectLight::find(const Iteration& in, size_t set, uint32_t m, WorkCounts& work) {
  const Meter& meter = in.scene.meter_sets[set].meters[m];
  const EyeEnd eye = meter_end(meter.p, meter.error, meter.frame, in.scene.meter_sets[set].response(m), {},
                               in.scene.media_stacks[in.scene.media_of_meter[set][m]]);
  const Arrival arrival{eye.surface};
  mis::Counts alone;
  alone.light_sample = 1;
  static const PerThread<std::vector<std::pair<float, Contribution>>> kept;
  auto& lights = kept.get();
  lights.clear();
  const auto keep = [&](const Found& c) {
    if (c && is_finite(c->value))
      lights.emplace_back(luminance(c->value), *c);
    else if (c)
      work.drop(Drop::light_sample, {{Stream::meters, uint32_t(set)}, in.number, m * in.plan.meter_samples}, meter.p);
  };
  for (const uint32_t e : emitters_) keep(light_from(in, alone, eye, arrival, {e, 1}, {}));
  if (!in.is_too_long(2))
    for (const uint32_t i : images_) keep(light_from_image(in, alone, eye, arrival, {i, 1}, {}));
  float found_from = 0;
  if (lights.size() > most_) {
    std::nth_element(lights.begin(), lights.begin() + ptrdiff_t(most_ - 1), lights.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    found_from = lights[most_ - 1].first;
  }
  OfMeter& out = meters_[set][m];
  out = {0, 0, found_from, 0, true};
  const size_t columns = in.plan.separation.columns.size();
  for (size_t k = 0; k < columns; ++k) separated_[set][m * columns + k] = {};
  std::sort(lights.begin(), lights.end(),  // so that the sum does not depend on how they were parted
            [](const auto& a, const auto& b) {
              return std::pair(a.second.emitter, a.second.mirror) < std::pair(b.second.emitter, b.second.mirror);
            });
  for (const auto& [size, c] : lights) {
    Passage way;
    if (!(size >= found_from)) continue;
    if (!edge_free(in.scene, c, work, way)) continue;
    const double lx = luminance(c.value * way.transmittance);
    const double mirrored = c.mirror != none ? lx : 0;
    out.lx += lx, out.mirrored += mirrored;
    out.rounding += float(lx) * relative_rounding(in, meter, eye, c);
    if (!columns) continue;
    OfColumn& column = separated_[set][m * columns + in.plan.separation.column_of_emitter[c.emitter]];
    column.lx += lx, column.mirrored += mirrored;
  }
}

void DirectLight::add(const Iteration& in, IterationTally& tally) const {
  const size_t columns = in.plan.separation.columns.size();
  for (size_t s = 0; s < meters_.size(); ++s)
    for (size_t i = 0; i < (meters_[s].empty() ? 0 : tally.meters[s].size()); ++i) {
      const size_t m = in.plan.visited_meter(in.number, i);
      const OfMeter& found = meters_[s][m];
      tally.meters[s][i].add({found.lx, found.lx - found.mirrored, 0, found.lx, found.mirrored, found.rounding, {}});
      for (size_t k = 0; k < columns; ++k) {
        const auto [lx, mirrored] = separated_[s][m * columns + k];
        const float rounding = lx > 0 ? float(lx / found.lx) * found.rounding : 0;
        tally.separated[s][i * columns + k].add({lx, lx - mirrored, 0, lx, mirrored, rounding, {}});
      }
    }
}

}  // namespace ups
