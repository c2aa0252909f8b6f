// See eye_walk.h: the walk, emitter hits, next-event estimation, connections, merges, scattering, and what a meter's
// own point does in their place.
#include "transport/eye_walk.h"

#include "base/per_thread.h"
#include "base/warp.h"
#include "emitter/profile.h"

namespace ups {

EyeTally EyeWalk::from_camera(const Vec3& p, const Vec3& direction, float pdf_w) {
  origin_ = last_.p = p;
  direction_ = direction;
  edge_.pdf = pdf_w;
  specular_ = true;
  walk();
  return tally_;
}

EyeTally EyeWalk::from_surface(const SurfacePoint& surface, const Frame& frame) {
  meter_frame_ = frame;
  meter_p_ = surface.p;
  last_ = {meter_p_, frame.n};
  origin_ = meter_origin_ = surface.ray_origin(frame.n);
  if (sensor_.end.merge > 0) meter_merge(surface);
  return gather_at_meter();
}

EyeTally EyeWalk::from_meter(const Vec3& p, const Vec3& ray_origin, const Frame& frame) {
  meter_p_ = p;
  last_ = {p, frame.n};
  origin_ = meter_origin_ = ray_origin;
  meter_frame_ = frame;
  if (in_.settings.actual_perturbation) perturb_meter();
  return gather_at_meter();
}

EyeTally EyeWalk::gather_at_meter() {
  if (in_.settings.photon_mapping) return tally_;                  // photons land on the meter itself
  if (in_.settings.light_tracing && sensor_.cell) return tally_;  // so do light paths
  if (in_.settings.has(UPS_TECHNIQUE_LIGHT_SAMPLE) || in_.settings.light_tracing) meter_sample_light();
  if (in_.settings.has(UPS_TECHNIQUE_CONNECT))
    connect_one(0, [&](const PreparedLight& l) { return meter_connect(l); });
  if (in_.settings.light_tracing) return tally_;

  const Vec3 local = square_to_cosine_hemisphere(rng_.direction(0));
  if (local.z < min_cosine) return tally_;
  direction_ = meter_frame_.to_world(local);
  throughput_ = start_throughput_ = Rgb(pi);
  edge_.pdf = edge_.cos_out = local.z;
  edge_.pdf *= inv_pi;
  walk();
  return tally_;
}

void EyeWalk::walk() {
  for (uint32_t edges = 1; !longer_than_allowed(edges); ++edges) {
    if (is_stopped(in_.stop, edges)) return;
    meet(scene_, origin_, direction_, media_, work_, met_);
    if (scene_.openings) hit_openings(edges);
    if (!met_.found) return;
    const SurfacePoint& surface = met_.surface;
    const float distance = met_.distance;
    if (!pass_on(met_.transmittance(scene_, distance))) return;
    const float cos_in = std::abs(dot(direction_, surface.ng));
    if (cos_in < min_cosine) return;
    const uint32_t emitter = scene_.emitter_of_instance[surface.instance];
    if (emitter != none) hit_emitter(emitter, surface.primitive, surface.p, cos_in, distance, edges, Rgb(1.0f));
    if (in_.settings.light_tracing) return;  // an emitter seen directly was all that it can add

    Vertex v{surface, met_.bsdf(scene_), -direction_, {}, arrive(cos_in, distance), false, false, edges};
    v.local_wo = surface.shading.to_local(v.wo);
    if (!consistent_side(surface, v.wo, v.local_wo)) return;
    v.passes = v.bsdf.is_glossy(in_.settings.glossy_alpha);
    v.merge = merge_gate(v.bsdf) && !v.passes;
    if (v.bsdf.has_continuous()) {
      Arrival a{surface};
      if (!in_.settings.actual_perturbation || !in_.settings.has(UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT) ||
          perturb(v, a)) {
        if (in_.settings.has(UPS_TECHNIQUE_LIGHT_SAMPLE)) sample_light(v, a);
        if (in_.settings.has(UPS_TECHNIQUE_CONNECT))
          connect_one(edges, [&](const PreparedLight& l) { return connect(v, a, l); });
      }
      if (v.merge) merge(v);
    }
    if (!scatter(v)) return;
  }
}

bool EyeWalk::pass_on(const Rgb& share) {
  throughput_ *= share;
  if (is_finite(throughput_)) return true;
  work_.drop(Drop::eye_walk);
  return false;
}

mis::EyeState EyeWalk::arrive(float cos_in, float distance) const {
  const double d2 = double(distance) * distance;
  switch (edge_.kind) {
    case Edge::sensor:
      return mis::eye_first(sensor_.counts, sensor_.camera, sensor_.end, edge_.pdf, edge_.cos_out, cos_in, d2);
    case Edge::delta: return mis::eye_step_delta(edge_.state, edge_.chi, edge_.cos_out, cos_in);
    case Edge::continuous: break;
  }
  return mis::eye_step(edge_.state, sensor_.counts, sensor_.camera, edge_.merge, edge_.pdf, edge_.pdf_reverse,
                       edge_.cos_out, cos_in, d2);
}

// Luminous openings block nothing: they are found beside the surfaces.
void EyeWalk::hit_openings(uint32_t edges) {
  static const PerThread<std::vector<DiscIndex::Crossing>> kept;
  std::vector<DiscIndex::Crossing>& crossings = kept.get();
  crossings.clear();
  scene_.openings->intersect_all(origin_, direction_, met_.distance, crossings);
  for (const DiscIndex::Crossing& c : crossings) {
    const uint32_t emitter = scene_.emitter_of_opening[c.disc];
    // The index holds what surrounds luminous openings, and of luminous openings alone.
    float t, cos_in;
    if (!static_cast<const ProfileOpeningEmitter&>(scene_.emitters[emitter]).enter(origin_, direction_, t, cos_in))
      continue;
    if (!(t > 0 && t <= met_.distance) || cos_in < min_cosine) continue;
    hit_emitter(emitter, 0, origin_ + direction_ * t, cos_in, t, edges, met_.transmittance(scene_, t));
  }
}

void EyeWalk::hit_emitter(uint32_t index, uint32_t primitive, const Vec3& p, float cos_in, float distance,
                          uint32_t edges, const Rgb& transmittance) {
  if (!in_.settings.has(UPS_TECHNIQUE_EMITTER_HIT) && !in_.settings.light_tracing) return;
  if (in_.settings.hits_after_specular && !specular_) return;
  const Emitter& emitter = scene_.emitters[index];
  EmitterHit hit;
  if (!emitter.eval_hit(last_.p, p, primitive, -direction_, hit)) return;
  double w = 1;
  if (!in_.settings.weightless()) {
    const double pb_0 = edge_.pdf * cos_in / (double(distance) * distance);
    const double pn_0 = double(scene_.emitters.direct_probability(last_, index)) * hit.pdf_nee_a;
    const double pf_0 = double(scene_.emitters.emission_probability(index)) * hit.pdf_position_a;
    const bool connectable = edge_.kind == Edge::continuous || (edge_.kind == Edge::sensor && !sensor_.camera);
    w = mis::weight_hit(arrive(cos_in, distance), sensor_.counts, in_.plan.gates, pn_0, pf_0, hit.pdf_direction_w, pb_0,
                        connectable);
  }
  add({{Family::path_integration, 0, edges}, index}, throughput_ * transmittance * hit.radiance, float(w),
      Drop::emitter_hit);
}

namespace {

// Area densities of x_0 and x_1 by emission, of x_0 by next-event estimation.
struct DirectDensities {
  double pn_0, pf_0, pf_1;
};
DirectDensities direct_densities(const Snapshot& scene, const EmitterSet::Choice& choice, const DirectSample& s,
                                 double cos_1) {
  const Emitter& e = scene.emitters[choice.index];
  const double emit = scene.emitters.emission_probability(choice.index);
  const double d2 = double(s.distance) * s.distance;
  if (e.is_directional()) return {choice.probability, emit, s.pdf_position_a * cos_1};
  if (e.is_delta()) return {choice.probability, emit, s.pdf_direction_w * cos_1 / d2};
  return {double(choice.probability) * s.pdf_nee_a, emit * s.pdf_position_a, s.pdf_direction_w * cos_1 / d2};
}

}  // namespace

// s = 1: next-event estimation at x_1.
void EyeWalk::sample_light(const Vertex& v, const Arrival& a) {
  const uint32_t edges = v.edges + 1;
  if (longer_than_allowed(edges)) return;
  const EmitterSet::Choice choice =
      scene_.emitters.choose_direct(receiver_at(a.surface, v.wo, v.bsdf), rng_.get(v.edges, Slot::choice));
  if (!(choice.probability > 0)) return;
  DirectSample s;
  const Emitter& emitter = scene_.emitters[choice.index];
  if (!emitter.sample_direct(a.surface.p, rng_.position(v.edges), s)) return;
  const Vec3 local = v.surface.shading.to_local(s.wi);
  if (!consistent_side(v.surface, s.wi, local)) return;
  const Scattering f = v.bsdf.evaluate(v.local_wo, local, TransportMode::radiance);
  if (is_black(f.value)) return;
  const double cos_1 = std::abs(dot(s.wi, a.surface.ng)), d2 = double(s.distance) * s.distance;
  const DirectDensities p = direct_densities(scene_, choice, s, cos_1);
  const double pb_0 = emitter.is_delta() ? 0.0 : f.pdf * s.cos_0 / d2;
  const double total = (v.merge && in_.plan.gates.merge_at_first ? mis::eta_at(sensor_.counts, v.state) : 0.0) +
                       mis::eye_total(v.state, in_.plan.gates, sensor_.camera, true, f.pdf_reverse);
  const double w = mis::weight_light_sample(sensor_.counts, pb_0, p.pn_0, p.pf_0, p.pf_1, total);
  const MediaStack& media = met_.beyond(s.wi);
  const float scale = terminator(v.surface, s.wi) * perturbed_cosine(v, a, s.wi) / choice.probability;
  const Rgb value = throughput_ * f.value * s.weight * attenuation_ahead(scene_, media, s.distance) * scale;
  if (is_black(value)) return;
  Rgb passed(1.0f);
  if (is_finite(value) &&
      !segment_free(scene_, media, a.surface.ray_origin(s.wi), lifted(s.p, s.n, s.error), work_, passed))
    return;
  add({{Family::path_integration, 1, edges}, choice.index}, value * passed, float(w), Drop::light_sample);
}

// The light path's vertices as connections read them, made at the first that needs them.
const std::vector<EyeWalk::PreparedLight>& EyeWalk::prepared_light() {
  static const PerThread<std::vector<PreparedLight>> kept;
  std::vector<PreparedLight>& prepared = kept.get();
  if (!light_is_prepared_) {
    prepared.clear();
    for (uint32_t i = sensor_.first_light_vertex; i < sensor_.end_light_vertex; ++i) {
      const LightVertex& l = in_.light.vertices[i];
      const SurfacePoint surface = l.surface();
      const Bsdf bsdf(scene_.materials[l.material], l.uv, l.relative_ior);
      prepared.push_back({&l, surface, bsdf, surface.shading.to_local(l.wo)});
    }
    light_is_prepared_ = true;
  }
  return prepared;
}

// All connections of a vertex, by one of them: each is weighed without its shadow ray, one is chosen in proportion and
// stands for their sum if its ray is free (Talbot et al. 2005, resampled importance sampling). `weigh` gives them.
template <class Weigh>
void EyeWalk::connect_one(uint32_t vertex, const Weigh& weigh) {
  static const PerThread<std::vector<Connection>> kept;
  std::vector<Connection>& all = kept.get();
  all.clear();
  double sum = 0;
  for (const PreparedLight& light : prepared_light()) {
    const Connection c = weigh(light);
    const float size = luminance(c.value);
    if (!is_finite(c.value)) work_.drop(Drop::connect);
    if (!(size > 0) || !is_finite(c.value)) continue;
    sum += size;
    all.push_back(c);
  }
  if (all.empty()) return;
  double target = sum * rng_.get(vertex, Slot::connection);
  size_t chosen = 0;
  while (chosen + 1 < all.size() && (target -= luminance(all[chosen].value)) >= 0) ++chosen;
  const Connection& c = all[chosen];
  ++work_.connections;
  Rgb passed(1.0f);
  const MediaStack& media = vertex == 0 ? media_ : met_.beyond(c.to - c.from);
  if (!segment_free(scene_, media, c.from, c.to, work_, passed)) return;
  const float all_for_one = float(sum / luminance(c.value));
  add({{Family::path_integration, c.s, c.edges}, c.emitter}, c.value * all_for_one * passed,
      c.unweighted * all_for_one * passed, Drop::connect);
}

// 2 <= s < k: an edge to a vertex of the light path.
EyeWalk::Connection EyeWalk::connect(const Vertex& v, const Arrival& a, const PreparedLight& light) const {
  const LightVertex& l = *light.vertex;
  const uint32_t edges = v.edges + 1 + l.depth;
  if (longer_than_allowed(edges)) return {};
  const Vec3 to = l.p - a.surface.p;
  const float d2 = length2(to);
  if (!(d2 > 0)) return {};
  const float distance = std::sqrt(d2);
  const Vec3 d = to / distance;
  const Vec3 eye_local = v.surface.shading.to_local(d);
  if (!consistent_side(v.surface, d, eye_local)) return {};
  const Vec3 light_local = light.surface.shading.to_local(-d);
  if (!consistent_side(light.surface, -d, light_local)) return {};
  const Scattering f_eye = v.bsdf.evaluate(v.local_wo, eye_local, TransportMode::radiance);
  if (is_black(f_eye.value)) return {};
  const Scattering f_light = light.bsdf.evaluate(light.local_wo, light_local, TransportMode::importance);
  if (is_black(f_light.value)) return {};
  const double cos_eye = std::abs(dot(d, a.surface.ng)), cos_light = std::abs(dot(d, l.ng));
  const double w = mis::weight_connect(l.mis, v.state, sensor_.counts, l.merge, v.merge, f_eye.pdf * cos_light / d2,
                                       f_light.pdf_reverse, f_light.pdf * cos_eye / d2, f_eye.pdf_reverse);
  const float scale =
      terminator(v.surface, d) * perturbed_cosine(v, a, d) * light_correction(light.surface, l.wo, -d) / d2;
  const Rgb passes = attenuation_ahead(scene_, met_.beyond(d), distance);
  const Rgb value = throughput_ * f_eye.value * l.flux * f_light.value * passes * scale;
  return {value * float(w), value, a.surface.ray_origin(d), light.surface.ray_origin(-d), l.depth + 1u, edges,
          l.emitter};
}

double EyeWalk::photon_norm(double radius) const {
  return 1.0 / (double(in_.plan.light_paths) * 3.14159265358979323846 * radius * radius);
}

// Against leaks through thin walls and around edges: same orientation, same side, in the tangent plane.
bool EyeWalk::same_surface(const SurfacePoint& s, const LightVertex& l, float radius) {
  const float cos_light = dot(l.wo, s.ng);
  return dot(l.ng, s.ng) >= min_merge_cosine && cos_light * dot(l.wo, l.ng) > 0 && std::abs(cos_light) >= min_cosine &&
         std::abs(dot(s.ng, l.p - s.p)) <= max_merge_height * radius;
}

// Density estimation of illuminance itself, where the meter's point lies on a surface that photons are stored on.
void EyeWalk::meter_merge(const SurfacePoint& surface) {
  const double norm = photon_norm(sensor_.first.radius);
  sensor_.first.photons->query(surface.p, sensor_.first.radius, [&](uint32_t index, float) {
    const LightVertex& l = in_.light.vertices[index];
    const float cos_light = dot(l.wo, meter_frame_.n);
    if (longer_than_allowed(l.depth) || cos_light < min_cosine || !same_surface(surface, l, sensor_.first.radius))
      return;
    const double w = in_.settings.weightless() ? 1.0
                                               : mis::weight_merge_at_sensor(l.mis, sensor_.counts, sensor_.end.merge,
                                                                             cos_light * double(inv_pi));
    ++work_.merges;
    add({{Family::density_estimation, l.depth + 1u, l.depth}, l.emitter}, l.flux * float(norm), float(w), Drop::merge);
  });
}

// Density estimation at an eye vertex: photons on the same side of the same surface within the radius.
void EyeWalk::merge(const Vertex& v) {
  const Disc& disc = v.state.first ? sensor_.first : sensor_.later;
  if (!(disc.radius > 0)) return;
  const float r2 = disc.radius * disc.radius;
  const double norm = photon_norm(disc.radius), eta = mis::eta_at(sensor_.counts, v.state);
  disc.photons->query(v.surface.p, disc.radius, [&](uint32_t index, float d2) {
    const LightVertex& l = in_.light.vertices[index];
    if (longer_than_allowed(v.edges + l.depth) || !same_surface(v.surface, l, disc.radius)) return;
    const float cos_light = dot(l.wo, v.surface.ng);
    const Vec3 local = v.surface.shading.to_local(l.wo);
    if (!consistent_side(v.surface, l.wo, local)) return;
    // eval() carries |cos(wi, n_s)|; a photon's surface density already carries |cos(wi, n_g)|.
    const Scattering f = v.bsdf.evaluate(v.local_wo, local, TransportMode::radiance);
    if (is_black(f.value)) return;
    double w = 1;
    if (!in_.settings.weightless()) {
      const double eye = mis::eye_total(v.state, in_.plan.gates, sensor_.camera, l.depth == 1, f.pdf_reverse);
      w = mis::weight_merge(l.mis, sensor_.counts, eta, f.pdf, eye);
    }
    ++work_.merges;
    const Rgb value =
        throughput_ * f.value * l.flux * (float(norm / std::abs(cos_light)) * terminator(v.surface, l.wo));
    if (!add({{Family::density_estimation, l.depth + 1u, v.edges + l.depth}, l.emitter}, value, float(w), Drop::merge))
      return;
    const float bias = 2 * luminance(value) * float(w) * (2 * d2 < r2 ? -1.0f : 1.0f);
    tally_.bias += bias;
    add_separated(l.emitter, {0.0, 0.0, bias});
  });
}

bool EyeWalk::scatter(const Vertex& v) {
  BsdfSample s;
  if (!v.bsdf.sample(v.local_wo, rng_.get(v.edges, Slot::lobe), rng_.direction(v.edges), TransportMode::radiance, s))
    return false;
  if (in_.settings.photon_mapping && !s.delta && !v.passes) return false;  // its continuous part was merged
  const Vec3 wi = v.surface.shading.to_world(s.wi);
  if (is_finite(s.weight) && !consistent_side(v.surface, wi, s.wi)) return false;
  if (!pass_on(s.delta ? s.weight : s.weight * terminator(v.surface, wi))) return false;
  const bool lossless = s.delta && max_component(s.weight) > 0.9f;
  const float q = survival(throughput_, start_throughput_, v.edges, lossless);
  if (is_black(throughput_) || rng_.get(v.edges, Slot::roulette) >= q) return false;
  throughput_ *= 1 / q;
  specular_ = specular_ && (s.delta || v.passes);
  edge_.kind = s.delta ? Edge::delta : Edge::continuous;
  edge_.state = v.state;
  edge_.merge = v.merge;
  edge_.pdf = s.pdf;
  edge_.pdf_reverse = s.pdf_reverse;
  edge_.cos_out = std::abs(dot(wi, v.surface.ng));
  edge_.chi = double(s.pdf_reverse) / s.pdf * s.delta_jacobian;
  media_ = met_.beyond(wi);
  last_ = receiver_at(v.surface, v.wo, v.bsdf);
  origin_ = v.surface.ray_origin(wi);
  direction_ = wi;
  return true;
}

// k = 1 at the meter's own point.
void EyeWalk::meter_sample_light() {
  const Receiver receiver{meter_p_, meter_frame_.n};
  const EmitterSet::Choice choice = scene_.emitters.choose_direct(receiver, rng_.get(0, Slot::choice));
  if (!(choice.probability > 0)) return;
  DirectSample s;
  const Emitter& emitter = scene_.emitters[choice.index];
  if (!emitter.sample_direct(meter_p_, rng_.position(0), s)) return;
  const double cos_1 = dot(s.wi, meter_frame_.n), d2 = double(s.distance) * s.distance;
  if (cos_1 < min_cosine) return;
  double w = 1;
  if (!in_.settings.light_tracing) {
    const DirectDensities p = direct_densities(scene_, choice, s, cos_1);
    const double pb_0 = emitter.is_delta() ? 0.0 : cos_1 * double(inv_pi) * s.cos_0 / d2;
    w = mis::weight_light_sample(sensor_.counts, pb_0, p.pn_0, p.pf_0, p.pf_1,
                                 mis::sensor_total_direct(sensor_.end, in_.plan.gates));
  }
  const Rgb value = s.weight * attenuation_ahead(scene_, media_, s.distance) * float(cos_1 / choice.probability);
  if (is_black(value)) return;
  Rgb passed(1.0f);
  if (is_finite(value) && !segment_free(scene_, media_, meter_origin_, lifted(s.p, s.n, s.error), work_, passed))
    return;
  add({{Family::path_integration, 1, 1}, choice.index}, value * passed, float(w), Drop::light_sample);
}

// s = k: an edge from the meter's own point to a vertex of the light path.
EyeWalk::Connection EyeWalk::meter_connect(const PreparedLight& light) const {
  const LightVertex& l = *light.vertex;
  const uint32_t edges = 1 + l.depth;
  if (longer_than_allowed(edges)) return {};
  const Vec3 to = l.p - meter_p_;
  const float d2 = length2(to);
  if (!(d2 > 0)) return {};
  const float distance = std::sqrt(d2);
  const Vec3 d = to / distance;
  const double cos_meter = dot(d, meter_frame_.n);
  if (cos_meter < min_cosine) return {};
  const Vec3 light_local = light.surface.shading.to_local(-d);
  if (!consistent_side(light.surface, -d, light_local)) return {};
  const Scattering f = light.bsdf.evaluate(light.local_wo, light_local, TransportMode::importance);
  if (is_black(f.value)) return {};
  const double cos_light = std::abs(dot(d, l.ng));
  double w = 1;
  if (!in_.settings.light_tracing)
    w = mis::weight_sensor_connect(l.mis, sensor_.counts, false, sensor_.end, l.merge,
                                   cos_meter * double(inv_pi) * cos_light / d2, f.pdf_reverse, f.pdf * cos_meter / d2);
  const float scale = float(cos_meter / d2) * light_correction(light.surface, l.wo, -d);
  const Rgb value = l.flux * f.value * attenuation_ahead(scene_, media_, distance) * scale;
  return {value * float(w), value, meter_origin_, light.surface.ray_origin(-d), l.depth + 1u, edges, l.emitter};
}

}  // namespace ups
