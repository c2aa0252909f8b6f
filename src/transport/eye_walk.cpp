// See eye_walk.h: the walk, and which techniques are tried where. What they find waits in eye_edges.cpp.
#include "transport/eye_walk.h"

#include <algorithm>

#include "base/per_thread.h"
#include "base/warp.h"
#include "emitter/profile.h"

namespace ups {

EyeTally EyeWalk::from_camera(const Vec3& p, const Vec3& direction, float pdf_w) {
  if (in_.recorder) in_.recorder->start_eye(sensor_, p, {}, 0);
  origin_ = last_.p = p;
  direction_ = direction;
  edge_.scatter.pdf = pdf_w;
  own_angle_sr_ = float(in_.plan.camera_subsets) / pdf_w;
  specular_ = true;
  books().start(luminance(carried_));
  walk();
  test_edges();
  return tally_;
}

EyeTally EyeWalk::from_surface(const SurfacePoint& surface, const Frame& frame) {
  EyeEnd eye = meter_end(surface.p, surface.error, frame, {}, sensor_.own_point, *sensor_.media);
  if (in_.recorder) in_.recorder->start_eye(sensor_, surface.p, frame.n, surface.error);
  origin_ = surface.p;
  if (eye.merge) {
    eye.surface.ng = surface.ng;  // photons tell by it which side they lie on
    eye.surface.instance = surface.instance, eye.surface.material = surface.material;
    eye.surface.primitive = surface.primitive, eye.surface.uv = surface.uv;
    PhotonIndex::Query photons;
    if (ask_photons(eye, photons)) {
      disc(eye).photons->find_rows(photons);
      merge(eye, photons);
    }
    eye.surface.ng = frame.n;
  }
  gather_at_meter(eye);
  test_edges();
  return tally_;
}

EyeTally EyeWalk::from_meter(const Vec3& p, float error, const Frame& frame) {
  if (in_.recorder) in_.recorder->start_eye(sensor_, p, frame.n, error);
  origin_ = p;
  EyeEnd eye = meter_end(p, error, frame, sensor_.response, sensor_.own_point, *sensor_.media);
  if (in_.settings.actual_perturbation && !sensor_.response.across) {  // a point meter's kernel is its disc
    const Vec2 disc = square_to_disc({rng_.get(0, Slot::perturb_x), rng_.get(0, Slot::perturb_y)});
    eye.surface.p += (frame.s * disc.x + frame.t * disc.y) * float(sensor_.first.radius);
  }
  gather_at_meter(eye);
  test_edges();
  add_separated();
  return tally_;
}

void EyeWalk::gather_at_meter(EyeEnd& eye) {
  const Method& method = in_.settings.method;
  if (method.eye_end == EyeEndOf::first_merge) return;  // photons land on the meter itself
  const bool ends = method.eye_end == EyeEndOf::first_surface;
  if (ends && sensor_.cell) return;  // so do light paths
  const Arrival arrival{eye.surface};
  if (ends || in_.has(UPS_TECHNIQUE_LIGHT_SAMPLE))
    look_for_light(eye, arrival, sensor_.direct_found_from, sensor_.image_found_from);
  if (counts_.connect > 0) connect_one(eye, arrival);
  if (ends) return;

  const MeterResponse& response = eye.response;
  const Vec3 local = response.sample(rng_.direction(0));
  if (response.value(local) < min_cosine) return;
  last_ = meter_receiver(eye.surface.p, eye.surface.ng, response);
  direction_ = eye.surface.shading.to_world(local);
  origin_ = eye.surface.ray_origin(eye.surface.ng);
  start_importance_ = response.total();
  carried_ = start_carried_ = Rgb(start_importance_);
  books().start(luminance(carried_));
  edge_.kind = Edge::continuous;
  edge_.state = eye.state;
  const float cosine = response.kind == UPS_METER_PLANAR ? local.z : eye.cosine(eye.surface, direction_);
  edge_.scatter = {response.pdf(local), 1, cosine, eye.merge};
  walk();
}

void EyeWalk::walk() {
  const Method& method = in_.settings.method;
  EyeEnd eye;
  for (uint32_t edges = 1; !in_.is_too_long(edges); ++edges) {
    if (is_stopped(in_.stop, edges)) return;
    trace(edges);
    if (scene_.openings) hit_openings(edges);
    if (!met_.found) {
      if (carry(met_.transmittance_of_earlier(scene_))) books().escaped += luminance(carried_);
      return;
    }
    if (!carry_to_met()) return;
    const SurfacePoint& surface = met_.surface;
    const float cos_in = std::abs(dot(direction_, surface.ng));
    if (cos_in < min_cosine) {
      absorb();
      return;
    }
    if (!scattered_) seen_from_m_ += met_.distance;
    if (const uint32_t emitter = scene_.emitter_of_instance[surface.instance]; emitter != none)
      hit_emitter(emitter, surface.primitive, surface.p, cos_in, met_.distance, edges, Rgb(1.0f));
    if (method.eye_end == EyeEndOf::first_surface) break;

    if (!shade(edges, eye)) {
      if (is_finite(eye.local_wo)) absorb();
      return;
    }
    const bool passes = method.passes_glossy && eye.bsdf->is_glossy(in_.settings.glossy_alpha);
    eye.merge = merge_gate(*eye.bsdf) && !passes;
    if (eye.bsdf->has_continuous()) gather(eye);
    note_bend();
    const bool goes_on = scatter(eye, [&](const BsdfSample& s) {  // where the walk ends, its continuous part was merged
      return s.delta || passes || method.eye_end != EyeEndOf::first_merge || cut();
    });
    if (!goes_on) return;
    const bool delta = edge_.kind == Edge::delta;
    specular_ = specular_ && (delta || passes);
    scattered_ = scattered_ || !delta;
  }
  cut();
}

void EyeWalk::gather(const EyeEnd& eye) {
  Arrival arrival{eye.surface};
  PhotonIndex::Query photons;
  const bool merges = ask_photons(eye, photons);
  const bool arrives = in_.has(UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT) &&
                       (!in_.settings.actual_perturbation || perturb(eye, arrival));
  if (arrives && in_.has(UPS_TECHNIQUE_LIGHT_SAMPLE)) look_for_light(eye, arrival, INFINITY, INFINITY);
  if (merges) disc(eye).photons->find_rows(photons);
  if (arrives && counts_.connect > 0) connect_one(eye, arrival);
  if (merges) merge(eye, photons);
}

// Straight and by way of mirrors. *_found_from: 0 where all light of emitters that are exact, or of their images, is
// found elsewhere, once a render.
void EyeWalk::look_for_light(const EyeEnd& eye, const Arrival& arrival, float direct_found_from,
                             float image_found_from) {
  const bool into_mirrors = in_.looks_into_mirrors() && (image_found_from > 0 || scene_.flat_mirrors.of_extended);
  if (in_.plan.exact_direct && direct_found_from == 0 && !into_mirrors) return;  // a fifth of an office's light samples
  const double choice = rng_.get_fine(eye.edges, Slot::choice);
  const Vec2 position = scene_.emitters.have_extent() ? rng_.position(eye.edges) : Vec2{};
  double u = choice;
  for (const bool far : {false, true}) {
    if (!scene_.emitters.has_direct(far)) continue;
    u = choice;
    if (const Found c = sample_light(in_, counts_, eye, arrival, u, position, direct_found_from, far))
      offer(*c, Drop::light_sample);
  }
  if (!into_mirrors) return;
  for (const bool far : {false, true}) {
    if (!scene_.flat_mirrors.has[far]) continue;
    if (const Found c = sample_mirror(in_, counts_, eye, arrival, u, position, image_found_from, far))
      offer(*c, Drop::light_sample);
  }
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

// Of a walk that has left a vertex by a continuous lobe, where it meets a flat mirror, which has no other lobe.
void EyeWalk::note_bend() {
  bend_.plane = none;
  if (edge_.kind != Edge::continuous || !in_.looks_into_mirrors() || !scene_.flat_mirrors.of_extended) return;
  const uint32_t plane = scene_.flat_mirrors.plane_of(met_.surface.instance, met_.surface.primitive);
  if (plane != none) bend_ = {plane, edge_, last_, met_.distance, met_.pass(met_.distance)};
}

// The image's light comes straight, along the edge that the mirror has bent.
bool EyeWalk::hit_image(uint32_t emitter, uint32_t primitive, const Vec3& p, float cos_in, float distance,
                        uint32_t edges, const Rgb& transmittance) {
  if (bend_.plane == none) return false;
  const uint32_t image = scene_.flat_mirrors.image_of(emitter, bend_.plane);
  if (image == none) return false;
  mis::Scatter scatter = bend_.edge.scatter;
  scatter.pdf *= edge_.scatter.pdf;
  const double whole = double(bend_.distance) + distance, d2 = whole * whole,
               pass = bend_.pass * met_.pass(distance);
  const EyeHit eye{mis::eye_step(bend_.edge.state, counts_, scatter, cos_in, d2, pass), counts_, bend_.from, p,
                   -direction_, scatter.pdf * pass * cos_in / d2, true, edges, carried_ * transmittance, image,
                   edge_.scatter.pdf};
  if (const Found c = hit(in_, eye, emitter, primitive)) offer(*c, Drop::emitter_hit);
  return true;
}

void EyeWalk::hit_emitter(uint32_t emitter, uint32_t primitive, const Vec3& p, float cos_in, float distance,
                          uint32_t edges, const Rgb& transmittance) {
  const Method& method = in_.settings.method;
  if (!in_.has(UPS_TECHNIQUE_EMITTER_HIT) && method.eye_end != EyeEndOf::first_surface) return;
  if (method.hits_after_specular && !specular_) return;
  if (hit_image(emitter, primitive, p, cos_in, distance, edges, transmittance)) return;
  const double pdf_a = edge_.scatter.pdf * met_.pass(distance) * cos_in / (double(distance) * distance);
  const EyeHit eye{arrive([] { return Receiver{}; }, cos_in, distance), counts_, last_, p, -direction_, pdf_a,
                   edge_.kind == Edge::continuous, edges, carried_ * transmittance};
  const Found c = hit(in_, eye, emitter, primitive);
  if (!c) return;
  offer(*c, Drop::emitter_hit);
  if (!sensor_.counts_hits || (edge_.kind != Edge::delta && !edge_.scatter.caster)) return;
  tally_.hits += in_.plan.counts_hits[emitter];
  if (sensor_.separated) ++separated(emitter).caustics;
}

LightEnd& EyeWalk::light_end(uint32_t i) {
  if (!light_ends_) {
    static const PerThread<LightEnds> kept;
    light_ends_ = &kept.get();
    light_ends_->place.assign(sensor_.light.count, none);
    light_ends_->used = 0;
  }
  LightEnds& all = *light_ends_;
  if (all.place[i] == none) {
    all.place[i] = all.used++;
    if (all.ends.size() < all.used) all.ends.emplace_back();
    sensor_.light.vertices[i].fill(scene_, all.ends[all.place[i]]);
  }
  return all.ends[all.place[i]];
}

// All connections of a vertex, by one of them: chosen about in proportion to what each would bring without its shadow
// ray, it stands for their sum if its ray is free (Talbot et al. 2005, resampled importance sampling). Between Lambertian
// surfaces an estimate does; else all is evaluated.
void EyeWalk::connect_one(const EyeEnd& eye, const Arrival& arrival) {
  struct Candidates {
    std::vector<double> sizes;
    std::vector<std::pair<uint32_t, Contribution>> evaluated;  // by their numbers, ascending
  };
  static const PerThread<Candidates> kept;
  auto& [sizes, evaluated] = kept.get();
  sizes.clear(), evaluated.clear();
  const bool estimates = !in_.settings.actual_perturbation && (!eye.bsdf || eye.bsdf->min_alpha_continuous() == 1);
  const LightVertex* lights = sensor_.light.vertices;
  const uint32_t count = sensor_.light.count;
  const auto found = [&](uint32_t i) { return connect(in_, counts_, eye, arrival, light_end(i), lights[i].emitter); };
  if (sensor_.techniques) {  // by their weights, those of next to none would stand for the others
    for (uint32_t i = 0; i < count; ++i)
      if (const Found c = lights[i].lit ? found(i) : Found()) ++work_.connections, offer(*c, Drop::connect);
    return;
  }
  double sum = 0;
  for (uint32_t i = 0; i < count; ++i) {
    double& size = sizes.emplace_back(0);
    if (!lights[i].lit) continue;
    if (estimates && lights[i].lambertian) {
      size = connection_estimate(in_, counts_, eye, lights[i]);
    } else if (const Found c = found(i)) {
      size = luminance(c->value) * c->weight(in_, 1);
      evaluated.emplace_back(i, *c);
    }
    if (!std::isfinite(size)) drop(Drop::connect, eye.surface.p);
    if (!(size > 0 && std::isfinite(size))) size = 0;
    sum += size;
  }
  if (!(sum > 0)) return;
  double target = sum * rng_.get_fine(eye.edges, Slot::connection);
  uint32_t chosen = none;
  for (uint32_t i = 0; i < count; ++i) {
    if (!(sizes[i] > 0)) continue;
    chosen = i;
    if ((target -= sizes[i]) < 0) break;
  }
  ++work_.connections;
  const double share = sum / sizes[chosen];
  const auto at = std::lower_bound(evaluated.begin(), evaluated.end(), chosen,
                                   [](const auto& e, uint32_t number) { return e.first < number; });
  if (at != evaluated.end() && at->first == chosen) return offer(at->second, Drop::connect, share);
  if (const Found c = found(chosen)) offer(*c, Drop::connect, share);
}

}  // namespace ups
