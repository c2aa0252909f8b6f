// See techniques.h.
#include "transport/techniques.h"

namespace ups {

namespace {

// Flux arrives at the drawn point by its own cosine, and is scattered at the vertex: as a photon is that lies there.
float arrival_factor(const EyeEnd& eye, const Arrival& a, const Vec3& wi) {
  if (!(a.ratio > 0)) return 1;
  if (!consistent_side(a.surface, wi, a.surface.shading.to_local(wi))) return 0;
  const float here = dot(wi, a.surface.ng), there = dot(wi, eye.surface.ng);
  return here * there > 0 ? a.ratio * here / there : 0;
}

// A response of a meter has no terminator, and its back sees nothing.
bool scatters(const EyeEnd& eye, const Vec3& wi, Vec3& local) {
  local = eye.surface.shading.to_local(wi);
  return eye.bsdf ? consistent_side(eye.surface, wi, local) : eye.response.value(local) >= min_cosine;
}
float terminator(const EyeEnd& eye, const Vec3& wi) { return eye.bsdf ? terminator(eye.surface, wi) : 1.0f; }

// Area densities of x_0 and x_1 by emission, of x_0 by next-event estimation.
struct DirectDensities {
  double pn_0, pf_0, pf_1;
};
DirectDensities direct_densities(const Snapshot& scene, const EmissionGuide& guide, const EmitterSet::Choice& choice,
                                 const DirectSample& s, double cos_1) {
  const double emit = guide.probability(scene.emitters, choice.index);
  const double d2 = double(s.distance) * s.distance;
  if (scene.emitters.is_directional(choice.index)) return {choice.probability, emit, s.pdf_position_a * cos_1};
  if (scene.emitters.is_delta(choice.index)) return {choice.probability, emit, s.pdf_direction_w * cos_1 / d2};
  return {double(choice.probability) * s.pdf_nee_a, emit * s.pdf_position_a, s.pdf_direction_w * cos_1 / d2};
}

}  // namespace

Found hit(const Iteration& in, const EyeHit& eye, uint32_t index, uint32_t primitive) {
  const EmitterSet& emitters = in.scene.emitters;
  const FlatMirrors& mirrors = in.scene.flat_mirrors;
  const bool mirrored = eye.image != none;
  const Vec3 reference = mirrored ? mirrors.planes[mirrors.images[eye.image].plane].mirrored(eye.from.p) : eye.from.p;
  EmitterHit h;
  if (!emitters[index].eval_hit(reference, eye.p, primitive, eye.wo, h)) return {};
  Contribution c{{Family::path_integration, 0, eye.edges}, index, eye.carried * h.radiance};
  if (in.weighted()) {
    const float chosen = mirrored ? image_probability(in.scene, eye.from, eye.image)
                                  : emitters.direct_probability(eye.from, index);
    const double pn_0 = double(chosen) * h.pdf_nee_a;
    const double pf_0 = double(in.plan.guide.probability(emitters, index)) * h.pdf_position_a;
    const double emitted =
        eye.goes_on * h.pdf_direction_w * in.plan.guide.factor(emitters, index, eye.p, primitive, eye.wo);
    c.others = mis::others_of_hit(eye.state, eye.counts, in.gates_of(index), pn_0, pf_0, emitted, eye.pdf_a,
                                  eye.connectable);
  }
  return c;
}

EyeEnd meter_end(const Vec3& p, float error, const Frame& frame, const MeterResponse& response,
                 const mis::EyeState& state, const MediaStack& media) {
  EyeEnd eye;
  eye.surface.p = p;
  eye.surface.error = error;
  eye.surface.ng = frame.n;
  eye.surface.shading = response.frame(frame);
  eye.response = response;
  eye.state = state;
  eye.merge = state.eta > 0;
  eye.carried = Rgb(1.0f);
  eye.front = eye.back = &media;
  return eye;
}

namespace {

// Of a sample of the emitter. leaves: its light's direction there; edges: to the eye's vertex; goes_on: probability that
// a walk from there is reflected to the emitter.
Found light_of(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
               const EmitterSet::Choice& choice, DirectSample s, const Vec3& leaves, uint32_t edges, double goes_on) {
  Vec3 local;
  if (!scatters(eye, s.wi, local)) return {};
  const Scattering f = eye.evaluate(local, TransportMode::radiance);
  if (is_black(f.value)) return {};
  const MediaStack& media = eye.beyond(s.wi);
  const float scale = terminator(eye, s.wi) * arrival_factor(eye, arrival, s.wi);
  Contribution c{{Family::path_integration, 1, eye.edges + edges}, choice.index,
                 eye.carried * f.value * s.weight * attenuation_ahead(in.scene, media, s.distance) * scale};
  if (is_black(c.value)) return {};
  if (in.weighted()) {
    const mis::Classes from_emitter =
        mis::from_emitter_at_light_sample(eye.state, n, in.gates_of(choice.index), eye.scatter(f));
    if (from_emitter.sum() > 0) in.plan.guide.apply(in.scene.emitters, choice.index, leaves, s);
    const double cos_1 = eye.cosine(arrival.surface, s.wi), d2 = double(s.distance) * s.distance;
    const DirectDensities d = direct_densities(in.scene, in.plan.guide, choice, s, cos_1);
    const double pb_0 = in.scene.emitters.is_delta(choice.index) ? 0.0 : f.pdf * goes_on * s.cos_0 / d2;
    c.others = mis::others_of_light_sample(from_emitter, n, pb_0, d.pn_0, d.pf_0, d.pf_1);
  }
  c.from = arrival.surface.ray_origin(s.wi);
  c.to = lifted(s.p, s.n, s.error);
  c.media = &media;
  return c;
}

Receiver receiver_of(const EyeEnd& eye, const Arrival& arrival) {
  return eye.bsdf ? receiver_at(arrival.surface, eye.wo, *eye.bsdf)
                  : meter_receiver(arrival.surface.p, eye.surface.ng, eye.response);
}

// found_from: INFINITY where nothing is found elsewhere. What is no number counts as found, and was counted, there.
bool is_found_elsewhere(const Iteration& in, const Contribution& c, float found_from) {
  return found_from < INFINITY && in.plan.exact[c.emitter] && !std::isless(luminance(c.value), found_from);
}

}  // namespace

Found light_from(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
                 const EmitterSet::Choice& choice, const Vec2& u_position) {
  DirectSample s;
  if (!in.scene.emitters[choice.index].sample_direct(arrival.surface.p, u_position, s)) return {};
  return light_of(in, n, eye, arrival, choice, s, -s.wi, 1, 1);
}

// As straight light to the vertex's own image behind the mirror, along a path of the same length: its weights are those
// of an emitter whose light paths begin with being mirrored.
Found light_from_image(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
                       const EmitterChoice& choice, const Vec2& u_position) {
  const FlatMirrors::Image& image = in.scene.flat_mirrors.images[choice.index];
  const FlatMirrors::Plane& plane = in.scene.flat_mirrors.planes[image.plane];
  const Emitter& emitter = in.scene.emitters[image.emitter];
  DirectSample s;
  Vec3 at;
  if (!emitter.sample_direct(plane.mirrored(arrival.surface.p), u_position, s) ||
      !plane.shows(image.far ? image.center : s.p, image.far, arrival.surface.p, at))
    return {};
  const Vec3 leaves = -s.wi;
  s.wi = plane.mirrored_direction(s.wi);
  const MirrorLobe lobe = mirror_lobe(in.scene.materials[plane.material], std::abs(dot(s.wi, plane.n)));
  s.weight *= lobe.reflectance;
  (image.far ? s.pdf_position_a : s.pdf_direction_w) *= lobe.probability;
  Found c =
      light_of(in, n, eye, arrival, {image.emitter, choice.probability, 0}, s, leaves, 2, double(lobe.probability));
  if (!c) return {};
  c->mirror = image.plane;
  c->at_mirror = at;
  if (image.far) c->to = at + image.center * s.distance;
  return c;
}

Found sample_mirror(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
                    double u_choice, const Vec2& u_position, float found_from, bool far) {
  if (in.is_too_long(eye.edges + 2) || !(u_choice < in.scene.flat_mirrors.frequency)) return {};
  const EmitterChoice choice = choose_image(in.scene, receiver_of(eye, arrival), u_choice, far);
  if (!(choice.probability > 0)) return {};
  Found c = light_from_image(in, n, eye, arrival, choice, u_position);
  if (!c || is_found_elsewhere(in, *c, found_from)) return {};
  c->value *= 1 / choice.probability;
  return c;
}

namespace {

// Where paths leave the mirror that they meet at p: off its surface. Something else may lie close before it, as a pane.
// `place` is exact to `error`. False where the mirror is not there.
bool leave_mirror(const Snapshot& scene, uint32_t mirror, const Vec3& place, const Vec3& up, float error,
                  WorkCounts& work, Vec3& out) {
  constexpr int most = 8;  // surfaces
  Vec3 o = place + up * (4 * error);
  Hit hit;
  for (int i = 0; i < most && ++work.rays; ++i) {
    const float left = dot(o - place, up) + 4 * error;
    if (!(left > 0) || !scene.raytracer->intersect(o, -up, left, hit)) return false;
    const SurfacePoint s = scene.raytracer->surface_at(hit);
    if (scene.flat_mirrors.plane_of(hit.instance, hit.primitive) == mirror) {
      out = s.ray_origin(up);
      return true;
    }
    o = s.ray_origin(-up);
  }
  return false;
}

}  // namespace

bool edge_free(const Snapshot& scene, const Contribution& c, WorkCounts& work, Passage& passage) {
  if (c.mirror == none) return segment_free(scene, *c.media, c.from, c.to, work, passage);
  const FlatMirrors::Plane& plane = scene.flat_mirrors.planes[c.mirror];
  const Vec3 up = plane.height(c.to) > 0 ? plane.n : -plane.n;
  const float error = plane.error + 0x1p-22f * (max_abs(c.from) + length(c.at_mirror - c.from));
  Vec3 above;
  return leave_mirror(scene, c.mirror, c.at_mirror, up, error, work, above) &&
         segment_free(scene, *c.media, c.from, above, work, passage) &&
         segment_free(scene, *c.media, above, c.to, work, passage);
}

Found sample_light(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
                   double& u_choice, const Vec2& u_position, float found_from, bool far) {
  if (in.is_too_long(eye.edges + 1)) return {};
  const EmitterSet::Choice choice = in.scene.emitters.choose_direct(receiver_of(eye, arrival), u_choice, far);
  if (!(choice.probability > 0)) return {};
  u_choice = choice.u;
  Found c = light_from(in, n, eye, arrival, choice, u_position);
  if (!c || is_found_elsewhere(in, *c, found_from)) return {};
  c->value *= 1 / choice.probability;
  return c;
}

Found connect(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
              const LightEnd& light, uint32_t emitter) {
  const uint32_t edges = eye.edges + 1 + light.edges;
  if (in.is_too_long(edges)) return {};
  const Vec3 to = light.surface.p - arrival.surface.p;
  const float d2 = length2(to);
  if (!(d2 > 0)) return {};
  const float distance = std::sqrt(d2);
  const Vec3 d = to / distance;
  Vec3 eye_local;
  if (!scatters(eye, d, eye_local)) return {};
  const Vec3 light_local = light.surface.shading.to_local(-d);
  if (!consistent_side(light.surface, -d, light_local)) return {};
  const Scattering f_eye = eye.evaluate(eye_local, TransportMode::radiance);
  if (is_black(f_eye.value)) return {};
  const Scattering f_light = light.evaluate(light_local, TransportMode::importance);
  if (is_black(f_light.value)) return {};
  const MediaStack& media = eye.beyond(d);
  const float scale = terminator(eye, d) * arrival_factor(eye, arrival, d) *
                      light_correction(light.surface, light.wo, -d) / d2;
  Contribution c{{Family::path_integration, light.edges + 1, edges}, emitter,
                 eye.carried * f_eye.value * light.carried * f_light.value *
                     attenuation_ahead(in.scene, media, distance) * scale};
  c.own = &mis::Classes::connect;
  if (in.weighted()) {
    const double cos_eye = eye.cosine(arrival.surface, d), cos_light = std::abs(dot(d, light.surface.ng));
    c.others = mis::others_of_connect(light.state, light.scatter(f_light), eye.state, eye.scatter(f_eye), n,
                                      f_eye.pdf * cos_light / d2, f_light.pdf * cos_eye / d2);
  }
  c.from = arrival.surface.ray_origin(d);
  c.to = light.surface.ray_origin(-d);
  c.media = &media;
  return c;
}

// The geometry and, of the weight, the techniques that make the same edge in another way: connections next to it and
// merges at its ends (mis::others_of_connect).
float connection_estimate(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const LightVertex& light) {
  if (in.is_too_long(eye.edges + 1 + light.depth)) return 0;
  const Vec3 to = light.p - eye.surface.p;
  const float d2 = length2(to), cos_light = -dot(to, light.ng);
  if (!(d2 > 0)) return 0;
  float cos_eye = dot(to, eye.surface.ng);
  if (!eye.bsdf && eye.response.kind != UPS_METER_PLANAR) {
    const float d = std::sqrt(d2);
    cos_eye = d * eye.response.value(eye.surface.shading.to_local(to / d));
  }
  const bool eye_faces = eye.bsdf ? eye.bsdf->transmits_continuously() || cos_eye * dot(eye.wo, eye.surface.ng) > 0
                                  : cos_eye > 0;
  if (!eye_faces || !(light.both_sides || cos_light * dot(light.wo, light.ng) > 0)) return 0;
  const float g = std::abs(cos_eye * cos_light) / (d2 * d2);
  constexpr float dark = 0.05f;  // of a coat or what shines through
  const float size = luminance(light.flux) * std::max(dark, max_component(light.textured.reflectance)) * g;
  if (!in.weighted()) return size;
  const double photons = light.merge ? (light.casters ? 1.0 : n.merge_all) * n.eta : 0.0;
  return size / float(1 + g * double(inv_pi) * (double(light.inverse_density) + eye.state.by_connection + photons));
}

std::optional<Splatted> splat(const Iteration& in, size_t index, const LightEnd& light, uint32_t emitter) {
  const Camera& camera = in.scene.cameras[index];
  const uint32_t edges = light.edges + 1;
  if (light.state.first && !in.gates_of(emitter).sensor_connect_at_first) return {};
  if (in.is_too_long(edges)) return {};
  const Vec3 to = camera.position() - light.surface.p;
  const float d2 = length2(to);
  if (!(d2 > 0)) return {};
  const float distance = std::sqrt(d2);
  const Vec3 d = to / distance;
  const auto pixel = camera.pixel_of(-d);
  if (!pixel) return {};
  in.prefetch_camera_counts(index, *pixel);
  const Vec3 local = light.surface.shading.to_local(d);
  if (!consistent_side(light.surface, d, local)) return {};
  const Scattering f = light.evaluate(local, TransportMode::importance);
  const Rgb value = f.value * light_correction(light.surface, light.wo, d);
  if (is_black(value)) return {};
  const mis::Counts n = in.camera_counts(index, *pixel);
  if (!(n.sensor_connect > 0)) return {};
  const float pdf_w = camera.pdf_w(-d);
  const MediaStack& media = light.beyond(d);
  Contribution c{{Family::path_integration, edges, edges}, emitter,
                 light.carried * value * attenuation_ahead(in.scene, media, distance) *
                     float(pdf_w / (double(d2) * in.plan.light_paths))};
  if (is_black(c.value)) return {};
  c.own = &mis::Classes::light;
  if (in.weighted())
    c.others = mis::others_of_splat(light.state, light.scatter(f), n,
                                    double(pdf_w) * std::abs(dot(d, light.surface.ng)) / d2);
  c.from = light.surface.ray_origin(d);
  c.to = camera.position();
  c.media = &media;
  return Splatted{c, *pixel};
}

namespace {

// Against leaks through thin walls and around edges: same orientation, same side, in the tangent plane.
bool same_surface(const Snapshot& scene, const SurfacePoint& s, const LightVertex& l, const Vec3& p, float cos_light,
                  double radius) {
  if (!merges_with(scene, s, l.material, l.blended)) return false;
  return dot(l.ng, s.ng) >= min_merge_cosine && cos_light * dot(l.wo, l.ng) > 0 && std::abs(cos_light) >= min_cosine &&
         std::abs(dot(s.ng, p - s.p)) <= max_merge_height * radius;
}

}  // namespace

Found merge(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const LightVertex& l, const Vec3& p,
            double radius) {
  const float cos_light = dot(l.wo, eye.surface.ng);
  if (!l.casters && !(n.merge_all > 0)) return {};
  if (in.is_too_long(eye.edges + l.depth) || !same_surface(in.scene, eye.surface, l, p, cos_light, radius)) return {};
  Vec3 local;
  if (!scatters(eye, l.wo, local)) return {};
  // evaluate() carries |cos(wi, n_s)|; a photon's surface density already carries |cos(wi, n_g)|.
  const Scattering f = eye.evaluate(local, TransportMode::radiance);
  if (is_black(f.value)) return {};
  // Both paths had to meet what is blended, where light that goes on from there has met it once.
  const double norm = in.photon_norm(radius * radius) / (l.blended ? double(l.coverage) : 1.0);
  Contribution c{{Family::density_estimation, l.depth + 1u, eye.edges + l.depth}, l.emitter,
                 eye.carried * f.value * l.flux * (float(norm / std::abs(cos_light)) * terminator(eye, l.wo))};
  c.own = l.casters ? &mis::Classes::caustic : &mis::Classes::merge;
  if (in.weighted())
    c.others = mis::others_of_merge(l.state(), f.pdf, eye.state, eye.scatter(f), n, in.gates_of(l.emitter));
  return c;
}

// Above the surface by as much as photons may lie off its plane: the chord of a bent one passes below it.
bool nothing_between(const Snapshot& scene, const SurfacePoint& s, const Vec3& side, const Vec3& p, float error,
                     double radius, WorkCounts& work) {
  const float height = std::max(max_merge_height * float(radius), 2 * (s.error + error));
  const Vec3 lift = s.ng * (dot(side, s.ng) > 0 ? height : -height), to = p - s.p;
  const float distance = length(to);
  if (!(distance > 0)) return true;
  ++work.rays;
  return !scene.raytracer->occluded(s.p + lift, to / distance, distance);
}

Contribution land(const Iteration& in, const mis::Counts& n, const mis::LightState& state, double eta, double area,
                  float reverse, double flux, uint32_t edges, uint32_t emitter) {
  const bool merges = eta > 0;
  Contribution c{{merges ? Family::density_estimation : Family::path_integration, edges + 1, edges}, emitter,
                 Rgb(float(flux / (in.plan.light_paths * area)))};
  c.own = !merges ? &mis::Classes::light : state.casters ? &mis::Classes::caustic : &mis::Classes::merge;
  if (in.weighted())
    c.others = merges ? mis::others_of_merge(state, reverse, mis::at_meter(n, eta, 0), {0, 1}, n, in.gates_of(emitter))
                      : mis::others_of_land(state, n, area, reverse);
  return c;
}

}  // namespace ups
