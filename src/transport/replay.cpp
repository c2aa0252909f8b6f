// See replay.h.
#include "transport/replay.h"

#include <algorithm>

#include "transport/eye_walk.h"

namespace ups {

void ReplayRecorder::start_light(uint32_t emitter, const EmissionSample& start, const Rgb& carried) {
  walk.light = true;
  walk.emitter = emitter;
  walk.p = start.p, walk.n = start.n;
  walk.pdf_position_a = start.pdf_position_a, walk.pdf_direction_w = start.pdf_direction_w;
  walk.carried = carried;
}

void ReplayRecorder::start_eye(const EyeSensor& sensor, const Vec3& p, const Vec3& n, float) {
  walk.p = p, walk.n = n;
  first_light_vertex_ = sensor.light.first;
}

void ReplayRecorder::meet(const Encounter& met) {
  ReplayedVertex v;
  v.p = met.surface.p, v.ng = met.surface.ng, v.ns = met.surface.shading.n;
  v.instance = met.surface.instance;
  v.distance = met.distance;
  const Vec3 before = walk.vertices.empty() ? walk.p : walk.vertices.back().p;
  v.cos_in = std::abs(dot(normalize(before - v.p), v.ng));
  v.pass = met.pass(met.distance);
  walk.vertices.push_back(v);
}

void ReplayRecorder::scatter(const BsdfSample& lobe, float survival, const Rgb& carried) {
  ReplayedVertex& v = walk.vertices.back();
  v.scattered = true;
  v.delta = lobe.delta, v.transmitted = lobe.transmitted;
  v.pdf = lobe.pdf, v.pdf_reverse = lobe.pdf_reverse;
  v.survival = survival;
  v.weight = lobe.weight, v.carried = carried;
}

ReplayedContribution& ReplayRecorder::add(const Contribution& c, const Brought& brought, uint32_t kind) {
  ReplayedContribution& out = contributions.emplace_back();
  out.kind = kind;
  out.technique = c.technique;
  out.emitter = c.emitter;
  out.brought = brought;
  out.relative = c.relative(brought.pass);
  out.has_edge = c.media;
  out.from = c.from, out.to = c.mirror == none ? c.to : c.at_mirror;
  return out;
}

void ReplayRecorder::join(uint32_t light_vertex, ReplayedContribution& out) const {
  const std::vector<uint32_t>& begin = paths_->begin;
  out.light_path = uint32_t(std::upper_bound(begin.begin(), begin.end(), light_vertex) - begin.begin()) - 1;
  out.light_vertex = out.technique.s - 1;
}

void ReplayRecorder::found(const Contribution& c, const Brought& brought, uint32_t photon) {
  const uint32_t s = c.technique.s;
  if (photon != none) return join(photon, add(c, brought, UPS_TECHNIQUE_MERGE));
  if (s == 0) return void(add(c, brought, UPS_TECHNIQUE_EMITTER_HIT));
  if (s == 1)
    return void(add(c, brought, c.mirror == none ? UPS_TECHNIQUE_LIGHT_SAMPLE : UPS_TECHNIQUE_MIRROR_SAMPLE));
  join(first_light_vertex_, add(c, brought, UPS_TECHNIQUE_CONNECT));
}

void ReplayRecorder::splatted(const Contribution& c, const Brought& brought, size_t camera, uint32_t pixel) {
  if (!paths_ && address_.camera && camera == address_.sensor && pixel == address_.element)
    add(c, brought, UPS_TECHNIQUE_SENSOR_CONNECT);
}

void ReplayRecorder::landed(const Contribution& c, const Brought& brought, const Vec3& p, uint32_t set,
                            uint32_t meter) {
  const MeterSet& meters = in_.scene.meter_sets[set];
  if (paths_ || address_.camera || set != address_.sensor || meters.number(meter) != meters.number(address_.element))
    return;
  ReplayedContribution& out =
      add(c, brought, meters.is_cell() ? UPS_TECHNIQUE_SENSOR_HIT : UPS_TECHNIQUE_MERGE);
  out.from = out.to = p;
}

}  // namespace ups
