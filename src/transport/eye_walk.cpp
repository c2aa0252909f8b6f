// See eye_walk.h: the walk, and which techniques are tried where.
#include "transport/eye_walk.h"

#include <algorithm>

#include "base/per_thread.h"
#include "base/warp.h"
#include "emitter/profile.h"
#include "transport/selection.h"

namespace ups {

EyeTally EyeWalk::from_camera(const Vec3& p, const Vec3& direction, float pdf_w) {
  if (in_.recorder) in_.recorder->start_eye(sensor_, p, {}, 0);
  origin_ = last_.p = p;
  direction_ = direction;
  edge_.scatter.pdf = pdf_w;
  own_angle_sr_ = float(in_.plan.camera_subsets) / pdf_w;
  specular_ = true;
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
    if (!met_.found || !carry_to_met()) return;
    const SurfacePoint& surface = met_.surface;
    const float cos_in = std::abs(dot(direction_, surface.ng));
    if (cos_in < min_cosine) return;
    if (!scattered_) seen_from_m_ += met_.distance;
    if (const uint32_t emitter = scene_.emitter_of_instance[surface.instance]; emitter != none)
      hit_emitter(emitter, surface.primitive, surface.p, cos_in, met_.distance, edges, Rgb(1.0f));
    if (method.eye_end == EyeEndOf::first_surface) return;

    if (!shade(edges, eye)) return;
    const bool passes = method.passes_glossy && eye.bsdf->is_glossy(in_.settings.glossy_alpha);
    eye.merge = merge_gate(*eye.bsdf) && !passes;
    if (eye.bsdf->has_continuous()) gather(eye);
    note_bend();
    const bool goes_on = scatter(eye, [&](const BsdfSample& s) {  // where the walk ends, its continuous part was merged
      return s.delta || passes || method.eye_end != EyeEndOf::first_merge;
    });
    if (!goes_on) return;
    const bool delta = edge_.kind == Edge::delta;
    specular_ = specular_ && (delta || passes);
    scattered_ = scattered_ || !delta;
  }
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

namespace {

// Emptied: of a path that was broken off some may be left.
template <class T>
std::vector<T>& emptied(const PerThread<std::vector<T>>& kept) {
  std::vector<T>& out = kept.get();
  out.clear();
  return out;
}

}  // namespace

std::vector<EyeWalk::WaitingEdge>& EyeWalk::kept_edges() {
  static const PerThread<std::vector<WaitingEdge>> kept;
  return emptied(kept);
}
std::vector<EyeWalk::Column>& EyeWalk::kept_columns() {
  static const PerThread<std::vector<Column>> kept;
  return emptied(kept);
}

constexpr size_t most_waiting = 1024;  // edges, half a megabyte

void EyeWalk::offer(const Contribution& c, Drop drop, double share) {
  // Images of techniques show what has next to no weight, too.
  if (!c.media || sensor_.techniques || (in_.recorder && in_.recorder->wants_all_edges()))
    return test_edge(c, drop, share);
  const double size = luminance(c.value) * share * c.weight(in_, 1);
  if (!std::isfinite(size)) return work_.drop(drop, rng_.address(), place_of(c));
  const bool far = scene_.emitters.has_direct(true) && scene_.emitters[c.emitter].is_directional();
  if (size > 0) edges_.push_back({c, *c.media, drop, share, size, far});
  if (edges_.size() >= most_waiting) test_edges();  // of a path of many hundred vertices
}

namespace {

// Of an eye path. Timed against 1, 2, 4 and all of them at equal error: in the bathroom 0.90 of the time of all, in an
// office and in a box with two balls 0.97. Where an eye path has edges to other emitters, too, those to directional ones
// get so many beside the others' three.
constexpr int shadow_rays = 3, shadow_rays_beside = 2;

}  // namespace

// The size t for which probabilities min(1, size / t) of the edges to emitters of a kind have the sum `rays`.
double EyeWalk::size_of_certain_edges(bool far, int rays, double WaitingEdge::*size) const {
  double t = INFINITY;
  for (;;) {
    double rest = 0;
    int certain = 0;
    for (const WaitingEdge& e : edges_) {
      if (e.far != far) continue;
      if (e.*size >= t) ++certain;
      else rest += e.*size;
    }
    if (certain == rays) return t;
    const double next = rest / (rays - certain);
    if (!(next < t)) return t;
    t = next;
  }
}

void EyeWalk::part_by_emitter(bool far) {
  static const PerThread<std::vector<double>> kept;
  std::vector<double>& sums = kept.get();
  sums.resize(std::max(sums.size(), scene_.emitters.size()));
  for (const WaitingEdge& e : edges_) sums[e.found.emitter] = 0;
  for (const WaitingEdge& e : edges_)
    if (e.far == far) sums[e.found.emitter] += e.size;
  for (WaitingEdge& e : edges_)
    if (e.far == far) e.part = e.size / sums[e.found.emitter];
}

// Which edges get a shadow ray is drawn in proportion to what they would bring, with a fixed number in all: where all
// are free, nothing is lost by it (systematic sampling with probabilities in proportion to size, Madow 1949). Those to
// directional emitters are drawn by themselves: they would bring much, and may all be hidden.
// Where sources are told apart as many are drawn by their part of what the path would bring from their own emitter. A lamp
// that is weak here is chosen seldom, and each time hardly an edge to it would get a ray: its own reading would lack what
// few paths bring, and not know it. Not by their part of their source's: another lamp of its group may be strong and
// hidden. An edge gets its ray by the larger of both probabilities; so up to twice as many rays are cast.
void EyeWalk::test_edges() {
  size_t count[2] = {};
  for (const WaitingEdge& e : edges_) ++count[e.far];
  for (const bool far : {false, true}) {
    const int rays = far && count[0] > 0 ? shadow_rays_beside : shadow_rays;
    const bool all = count[far] <= size_t(rays);
    const bool by_emitter = !all && tells_sources_apart();
    if (by_emitter) part_by_emitter(far);
    const double certain = all ? 0 : size_of_certain_edges(far, rays, &WaitingEdge::size),
                 own = by_emitter ? size_of_certain_edges(far, rays, &WaitingEdge::part) : 1;
    double sum = all ? 0 : rng_.get_fine(tests_, tests_ ? Slot::later_edges : Slot::edges);
    const auto draw = [&](WaitingEdge& e, double probability) {
      const double before = sum;
      if (probability < 1 && std::floor(sum += probability) == std::floor(before)) return;
      e.found.media = &e.media;
      test_edge(e.found, e.drop, e.share / probability);
    };
    const auto by_size = [&](const WaitingEdge& e) { return all ? 1 : std::min(1.0, e.size / certain); };
    const auto by_part = [&](const WaitingEdge& e) { return std::min(1.0, e.part / own); };
    // Those that bring most by themselves, so that no weak one comes between and their number varies by one at most.
    for (WaitingEdge& e : edges_)
      if (e.far == far && !(by_emitter && by_part(e) > by_size(e))) draw(e, by_size(e));
    if (!by_emitter) continue;
    for (WaitingEdge& e : edges_)
      if (e.far == far && by_part(e) > by_size(e)) draw(e, by_part(e));
  }
  ++tests_;
  edges_.clear();
}

void EyeWalk::test_edge(const Contribution& c, Drop drop, double share) {
  Passage way;
  if (c.media && is_finite(c.value) && !edge_free(scene_, c, work_, way)) return;
  const Rgb unweighted = c.value * way.transmittance * float(share);
  const double weight = c.weight(in_, way.pass);
  if (in_.recorder) in_.recorder->found(c, {way.pass, unweighted, weight}, none);
  add(c, unweighted, way.pass, float(weight), drop);
}

void EyeWalk::add(const Contribution& c, const Rgb& unweighted, double pass, float weight, Drop where) {
  const Rgb value = unweighted * weight;
  if (!is_finite(value)) return drop(where, place_of(c));
  const bool is_direct = c.technique.edges == 1;
  const float lx = luminance(value);
  tally_.add(value);
  if (is_direct) tally_.direct += lx;
  if (sensor_.techniques) sensor_.techniques->add(c.technique, sensor_.pixel, value, unweighted);
  if (sensor_.excess) in_.moments->add(lx * sensor_.share, c.relative(pass), sensor_.camera, sensor_.excess);
  keep_separated(c.emitter, lx, is_direct ? lx : 0.0, 0.0);
}

void EyeWalk::keep_separated(uint32_t emitter, double lx, double direct, double bias) {
  if (!sensor_.separated) return;
  const uint32_t column = in_.plan.separation.column_of_emitter[emitter];
  auto at = std::find_if(columns_.begin(), columns_.end(), [&](const Column& c) { return c.first == column; });
  if (at == columns_.end()) at = columns_.insert(at, {column, {}});
  at->second.value += lx, at->second.direct += direct, at->second.bias += bias;
}

void EyeWalk::add_separated() {
  if (!sensor_.separated) return;
  for (const auto& [column, t] : columns_)
    sensor_.separated[column].add(MeterTally::of_path(t.value, t.direct, t.bias), sensor_.share);
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
  if (const Found c = hit(in_, eye, emitter, primitive)) offer(*c, Drop::emitter_hit);
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
