// One light path: from an emitter through the scene, with what it leaves at every vertex and crossing. Used by the light
// pass.
#pragma once
#include <cmath>
#include <limits>

#include "transport/light_pass.h"
#include "transport/plan.h"
#include "transport/techniques.h"

namespace ups {

// Blocks are summed in their order, so the number of threads never shows.
struct LightPass::Block {
  std::vector<LightVertex> vertices;
  std::vector<StoredPhoton> photons;
  std::vector<uint32_t> counts;  // vertices a path
  struct CameraSplat {
    Splat splat;
    Rgb unweighted;
    uint32_t camera, edges;
    mis::Classes relative;
  };
  std::vector<CameraSplat> splats;
  struct Landing {
    uint32_t disc, emitter;
    MeterTally value;
    uint32_t ring;  // of a point's disc; none: a cell
    uint8_t octant;
    double lm;
    mis::Classes relative;
  };
  std::vector<Landing> landings;
  struct Escape {
    Vec3 direction;
    float flux;
  };
  std::vector<Escape> escapes;  // where there are goniometers
  std::vector<IterationTally::Start> starts;
  WorkCounts work;
  std::vector<DiscIndex::Crossing> crossings;
  MemoryShare share;  // of all but these

  // For other paths; what has grown stays.
  void clear() {
    vertices.clear(), photons.clear(), counts.clear();
    splats.clear(), landings.clear(), escapes.clear(), starts.clear();
    work = {};
  }
};

class LightWalk : Subpath<LightWalk, TransportMode::importance> {
 public:
  LightWalk(const Iteration& in, const SensorIndex& sensors, LightPass::Block& block, uint32_t path)
      : Subpath(in,
                {in.settings.seed, in.light_stream, in.light_visit.batch,
                 uint64_t(in.light_visit.number) * in.plan.light_paths + path, in.number, path},
                block.work),
        sensors_(sensors), block_(block), path_(path) {
    counts_ = in.light_counts();
    ends_with_casters_ = in.plan.traces_caustics_alone();
  }

  void run() {
    if (!emit()) return;
    walk();
    if (in_.trains_guide)
      block_.share.push_back(block_.starts, {emitter_index_, square_, useful_ ? luminance(start_carried_) : 0.0f});
  }

 private:
  friend Subpath;
  void walk() {
    LightEnd light;
    for (uint32_t a = 1; !in_.is_too_long(a); ++a) {
      if (is_stopped(in_.stop, a)) return;
      trace(a);
      if (casters_) ++work_.caster_rays;
      if (!sensors_.empty()) cross_sensors(a);
      if (!met_.found) {
        if (!carry(met_.transmittance_of_earlier(scene_))) return;
        books().escaped += luminance(carried_);
        if (!scene_.goniometers.empty()) block_.share.push_back(block_.escapes, {direction_, luminance(carried_)});
        return;
      }
      if (!carry_to_met()) return;
      if (std::abs(dot(direction_, met_.surface.ng)) < min_cosine) {
        absorb();
        return;
      }
      const bool lit = shade(a, light), continuous = lit && light.bsdf->has_continuous();
      if (!lit && !is_finite(light.local_wo)) return;  // dropped
      light.merge = merge_gate(*light.bsdf) && (!light.state.first || in_.gates_of(emitter_index_).merge_at_first);
      if (in_.stores_vertices && (light.merge || continuous)) store(light, lit);
      // Light from behind a bump: nothing goes on, but next to it, where photons are merged, the normal may be another.
      if (!lit) {
        absorb();
        return;
      }
      if (continuous && in_.has(UPS_TECHNIQUE_SENSOR_CONNECT))
        for (uint32_t c = 0; c < scene_.cameras.size(); ++c) splat(c, light);
      if (!scatter(light, [&](const BsdfSample& s) { return is_finite(s.weight) || drop(Drop::light_walk); })) return;
      casters_ = casters_ && (edge_.kind == Edge::delta || light.caster);
      if (a == 1 && edge_.kind == Edge::delta) begin_at_image();
      if (casters_ && !is_first_edge())
        work_.brightest_caustic_lm = std::max(work_.brightest_caustic_lm, luminance(carried_));
      else if (!casters_ && ends_with_casters_)
        return;
    }
    cut();
  }

  bool emit() {
    ++work_.light_paths;
    const EmissionGuide& guide = in_.plan.guide;
    // The second number goes on where the first one's 24 bits end: weak lamps among strong ones have less than one.
    const double u = double(rng_.get(0, Slot::choice)) + 0x1p-24 * double(rng_.get(0, Slot::more_choice));
    const EmitterSet::Choice choice = guide.choose(scene_.emitters, u);
    if (!(choice.probability > 0)) return false;
    emitter_index_ = choice.index;
    emit_probability_ = choice.probability;
    emitter_ = &scene_.emitters[choice.index];
    const Vec2 position = emitter_->position_of_batch(rng_.position(0), in_.light_visit.batch, batch_count);
    if (!guide.sample(scene_.emitters, emitter_index_, position, rng_.direction(0), start_, square_)) return false;
    origin_ = emission_origin(start_.p, start_.n, start_.direction, start_.error);
    carried_ = start_carried_ = start_.flux / choice.probability;
    if (!is_finite(carried_) || !is_finite(origin_) || !is_finite(start_.direction)) return drop(Drop::emission);
    if (is_black(carried_)) return false;
    books().start(luminance(carried_));
    work_.brightest_lm = std::max(work_.brightest_lm, luminance(carried_));
    direction_ = start_.direction;
    const uint32_t media = scene_.media_of_emitter[choice.index];
    media_ = media == none ? media_at(scene_, origin_) : scene_.media_stacks[media];
    if (in_.recorder) in_.recorder->start_light(choice.index, start_, carried_);
    return true;
  }

  bool is_first_edge() const { return edge_.kind == Edge::first; }

  // Light that a flat mirror reflects straight from the emitter is that of its image: its path begins there.
  void begin_at_image() {
    if (!in_.looks_into_mirrors()) return;
    const uint32_t plane = scene_.flat_mirrors.plane_of(met_.surface.instance, met_.surface.primitive);
    if (plane == none || (image_ = scene_.flat_mirrors.image_of(emitter_index_, plane)) == none) return;
    to_mirror_ = met_.distance, pass_to_mirror_ = met_.pass(met_.distance), mirrored_ = edge_.scatter.pdf;
    edge_.kind = Edge::first;
  }
  // Along the edge of the image's light, which the mirror bends: an eye walk goes on there with the same probability.
  mis::LightState first_state_of_image(const Receiver& at, float cos_in, double d2, double pass) const {
    const FlatMirrors& mirrors = scene_.flat_mirrors;
    const double distance = to_mirror_ + std::sqrt(d2);
    return first_state(image_probability(scene_, at, image_),
                       mirrors.planes[mirrors.images[image_].plane].mirrored(at.p), mirrored_, cos_in,
                       distance * distance, pass * pass_to_mirror_);
  }

  // x_1 needs to know how next-event estimation would have found x_0.
  mis::LightState first_state(const Receiver& at, float cos_in, double d2, double pass) const {
    if (image_ != none) return first_state_of_image(at, cos_in, d2, pass);
    const float chosen = counts_.light_sample > 0 ? scene_.emitters.direct_probability(at, emitter_index_) : 0;
    return first_state(chosen, at.p, 1, cos_in, d2, pass);
  }

  // reference: x_1 as the emitter sees it, straight ahead. goes_on: see mirrored_.
  mis::LightState first_state(float chosen, const Vec3& reference, double goes_on, float cos_in, double d2,
                              double pass) const {
    const double choose = double(chosen) / emit_probability_;
    if (scene_.emitters.is_directional(emitter_index_))
      return mis::light_first_directional(counts_, choose, 1.0 / (start_.pdf_position_a * goes_on), cos_in, pass);
    const double pdf_direction_w = start_.pdf_direction_w * goes_on;
    if (scene_.emitters.is_delta(emitter_index_))
      return mis::light_first(counts_, choose, pdf_direction_w, d2, cos_in, pass, false, 1.0, 1.0);
    EmitterHit hit;
    const uint32_t primitive = start_.primitive == EmissionSample::invalid ? 0 : start_.primitive;
    const bool seen = emitter_->eval_hit(reference, start_.p, primitive, start_.direction, hit);
    const double pf_0 = double(emit_probability_) * start_.pdf_position_a;
    const double ratio = seen ? choose * hit.pdf_nee_a / start_.pdf_position_a : 0.0;
    return mis::light_first(counts_, ratio, pdf_direction_w, d2, cos_in, pass, true, start_.cos_0 * goes_on, pf_0);
  }

  void cross_sensors(uint32_t a) {
    if (is_first_edge() && !in_.gates_of(emitter_index_).merge_at_first && !in_.has(UPS_TECHNIQUE_SENSOR_HIT)) return;
    block_.crossings.clear();
    sensors_.crossings(origin_, direction_, met_.distance, block_.crossings);
    for (const DiscIndex::Crossing& c : block_.crossings) land(a, c);
  }

  // How a meter sees the current edge's light.
  struct Seen {
    float cos_in;   // to what catches it; below min_cosine: nothing is seen
    float reverse;  // density of an eye walk's direction
    float factor;   // response over cos_in
  };
  Seen see(const MeterResponse& response, const Frame& own) const {
    const float cosine = -dot(direction_, own.n);
    if (response.kind == UPS_METER_PLANAR) return {cosine, cosine * inv_pi, 1};
    const Vec3 local = response.frame(own).to_local(-direction_);
    const float value = response.value(local), cos_in = response.across ? 1.0f : std::abs(cosine);
    return {value < min_cosine ? 0.0f : cos_in, response.pdf(local), value / cos_in};
  }

  // A point meter merges the photon, a cell counts it.
  void land(uint32_t a, const DiscIndex::Crossing& crossing) {
    const SensorIndex::Entry& e = sensors_.entry(crossing.disc);
    const MeterSet& set = scene_.meter_sets[e.set];
    const Meter& meter = set.piece(e.meter, e.piece);
    const bool cell = set.is_cell();
    if (!cell && !casters_ && !(e.counts.merge_all > 0)) return;
    if (!cell && is_first_edge() && !in_.gates_of(emitter_index_).merge_at_first) return;
    const Vec3 center = lifted(meter.p, meter.frame.n, meter.error);
    const MeterResponse response = set.response(e.meter);
    const Seen seen = see(response, meter.frame);
    // A disc across the light is met where the path passes the meter by.
    const float t = response.across ? dot(center - origin_, direction_) : crossing.t;
    if (seen.cos_in < min_cosine || !(t > 0) || (response.across && t > met_.distance)) return;
    const Vec3 p = origin_ + direction_ * t;
    const Vec3 offset = p - center;
    // Across the light octants alone are asked for: axes of equal length that turn as the direction does. (About that
    // one axis they turn once: light from all around it has no side.)
    const Vec3 t_axis = response.across ? cross(Vec3(0.3713f, -0.5291f, 0.7639f), direction_) : meter.frame.t,
               s_axis = response.across ? cross(t_axis, direction_) : meter.frame.s;
    const float x = dot(offset, s_axis), y = dot(offset, t_axis);
    if (cell && !set.covers(e.meter, e.piece, x, y)) return;
    float share = 1;
    uint32_t ring = none;
    if (response.across)
      ring = in_.plan.meter_discs[e.set].ring_across(e.meter, meter.frame.n, direction_, offset, share);
    else if (!cell)
      ring = in_.plan.meter_discs[e.set].ring_at(e.meter, x, y);
    if (!cell && ring == none) return;
    const double flux = luminance(carried_ * met_.transmittance(scene_, t)) * seen.factor / share;
    const mis::LightState state =
        in_.weighted() ? arrive([&] { return meter_receiver(p, meter.frame.n, response); }, seen.cos_in, t)
                        : mis::LightState{};
    const Contribution c = ups::land(in_, e.counts, state, e.eta, e.area, seen.reverse, flux, a, emitter_index_);
    const double weight = c.weight(in_, 1), value = luminance(c.value) * weight;
    if (in_.recorder) in_.recorder->landed(c, {1, c.value, weight}, p, e.set, e.meter);
    if (!std::isfinite(value)) return drop(cell ? Drop::sensor_hit : Drop::merge, p);
    const bool caustic = casters_ && !is_first_edge();
    useful_ |= caustic;
    MeterTally brought = MeterTally::of_path(value, a == 1 ? value : 0.0, 0.0, PathNumber::light(path_));
    brought.caustics = caustic;
    block_.share.push_back(block_.landings, {crossing.disc, emitter_index_, brought, ring, MeterDiscs::octant_of(x, y),
                                             value * e.area, c.relative(1)});
  }

  void store(const LightEnd& light, bool lit) {
    LightVertex v;
    v.p = light.surface.p;
    v.ng = light.surface.ng;
    v.ns = light.surface.shading.n;
    v.wo = light.wo;
    v.textured = light.bsdf->textured();
    v.flux = carried_;
    v.set_error(light.surface.error);
    v.material = light.surface.material;
    v.emitter = emitter_index_;
    v.relative_ior = met_.relative_ior;
    v.depth = uint16_t(std::min<uint32_t>(light.edges, 0xffff));
    v.merge = light.merge;
    v.lit = lit;
    v.lambertian = light.bsdf->min_alpha_continuous() == 1;
    v.both_sides = light.bsdf->transmits_continuously();
    v.set_coverage(coverage(scene_, light.surface));
    v.set_state(light.state);
    if (light.merge) block_.share.push_back(block_.photons, {v.p, uint32_t(block_.vertices.size())});
    block_.share.push_back(block_.vertices, v);
    ++block_.counts.back();
    useful_ |= casters_ && !light.state.first;
    ++work_.light_vertices;
    if (in_.recorder) in_.recorder->store();
  }

  void splat(uint32_t camera, const LightEnd& light) {
    const std::optional<Splatted> found = ups::splat(in_, camera, light, emitter_index_);
    if (!found) return;
    const Contribution& c = found->contribution;
    Passage way;
    if (is_finite(c.value) && !segment_free(scene_, *c.media, c.from, c.to, work_, way)) return;
    const double weight = c.weight(in_, way.pass);
    const Rgb unweighted = c.value * way.transmittance, value = unweighted * float(weight);
    if (in_.recorder) in_.recorder->splatted(c, {way.pass, unweighted, weight}, camera, found->pixel);
    if (!is_finite(value)) return drop(Drop::sensor_connect, light.surface.p);
    block_.share.push_back(block_.splats, {{found->pixel, path_, value}, unweighted, camera, c.technique.edges,
                                           c.relative(way.pass)});
  }

  const SensorIndex& sensors_;
  LightPass::Block& block_;
  const uint32_t path_;
  const Emitter* emitter_ = nullptr;
  bool casters_ = true, ends_with_casters_ = false, useful_ = false;
  Vec2 square_;  // where on the emitter's square the path started
  uint32_t emitter_index_ = 0;
  float emit_probability_ = 1;
  uint32_t image_ = none;  // of the emitter, where its light was mirrored first; with how:
  double to_mirror_ = 0, pass_to_mirror_ = 1, mirrored_ = 1;
  EmissionSample start_;
};

}  // namespace ups
