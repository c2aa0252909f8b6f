// See eye_walk.h: density estimation around an eye path's vertex, and perturbation, which stands for it in tests.
#include "transport/eye_walk.h"
#include "transport/techniques.h"

namespace ups {

// For photons on the same side of the same surface within the radius: density estimation. False where there is none.
bool EyeWalk::ask_photons(const EyeEnd& eye, PhotonIndex::Query& query) {
  const EyeSensor::Disc& disc = this->disc(eye);
  if (!eye.merge || !(disc.radius > 0)) return false;
  if (&disc == &sensor_.first) count_disc(eye, pi * float(disc.radius * disc.radius));
  disc.photons->ask(eye.surface.p, float(disc.radius), query);
  return query.count > 0;
}

// Discs of neighbours overlap, and find the same photons. Of a path that has two such vertices the first one counts.
void EyeWalk::count_disc(const EyeEnd& eye, float area) {
  if (counted_edges_ != none) return;
  const float cosine = std::abs(dot(eye.wo, eye.surface.ng)),
              own = eye.edges == 0 ? sensor_.own_area_m2 : own_angle_sr_ * seen_from_m_ * seen_from_m_ / cosine;
  counted_edges_ = eye.edges;
  tally_.disc_m2 = std::min(area, own);
  counted_share_ = tally_.disc_m2 / area;
}

// Of a crowd of photons each k-th counts, k times: what is merged stays the same in the mean, and a light path that
// lands where all others do takes no more time. Returns k, which is odd: light paths are stratified by powers of two.
// Of what a disc's cells hold it has a fifth, so 3,000 photons of most.
uint32_t EyeWalk::thin(const EyeEnd& eye, PhotonIndex::Query& query) {
  constexpr uint64_t most = 1 << 14;
  if (query.candidates <= most) return 1;
  query.stride = uint32_t((query.candidates + most - 1) / most) | 1u;
  query.first = std::min(uint32_t(rng_.get(eye.edges, Slot::crowd) * float(query.stride)), query.stride - 1);
  ++work_.crowds;
  work_.largest_crowd = std::max(work_.largest_crowd, query.candidates);
  if (eye.edges == counted_edges_) tally_.disc_m2 /= float(query.stride);  // so much of it was looked at
  return query.stride;
}

// The disc of a surface that alpha cuts holes into: what is solid of it, as the vertex's triangle is mapped.
class EyeWalk::SolidPart {
 public:
  SolidPart(const Snapshot& scene, const SurfacePoint& s, double radius)
      : frame_(s.ng), uv_(s.uv), radius_(float(radius)), holes_(&scene.texturing[s.material]) {
    if (!holes_->alpha || !holes_->may_have_holes())
      holes_ = nullptr;
    else
      chart_ = scene.raytracer->chart_at(s);
  }
  static constexpr uint32_t most_tries = 1 << 12;
  bool is_all() const { return !holes_; }
  Vec3 offset(const Vec2& square) const {
    const Vec2 disc = square_to_disc(square);
    return (frame_.s * disc.x + frame_.t * disc.y) * radius_;
  }
  bool has(const Vec3& offset) const {
    return !holes_ || !holes_->is_hole_at({uv_.x + dot(chart_.u, offset), uv_.y + dot(chart_.v, offset)});
  }

 private:
  const Frame frame_;
  const Vec2 uv_;
  const float radius_;
  const SurfaceTexturing* holes_;  // null: it has none
  Raytracer::Chart chart_;
};

// How much larger the disc is than what is solid of it, where alone photons are: places of it at random until so many of
// them are solid are in the mean that many times more (negative binomial distribution).
float EyeWalk::over_solid_part(const EyeEnd& eye, double radius) {
  constexpr uint32_t wanted = 16;  // which adds at most a quarter of what is merged here as noise
  const SolidPart part(scene_, eye.surface, radius);
  if (part.is_all()) return 1;
  uint32_t tries = 0;
  for (uint32_t solid = 0; solid < wanted && tries < SolidPart::most_tries; ++tries)
    solid += part.has(part.offset(rng_.more(eye.edges, tries)));
  return float(tries) / wanted;
}

// Vertices lie anywhere in memory: some are asked for before the first of them is read.
void EyeWalk::merge(const EyeEnd& eye, PhotonIndex::Query& query) {
  const EyeSensor::Disc& disc = this->disc(eye);
  const float share = float(thin(eye, query)) * over_solid_part(eye, disc.radius);
  struct Near {
    const PhotonIndex::Photon* photon;
    float d2;
  } waiting[32];
  size_t count = 0;
  const auto merge_waiting = [&] {
    for (size_t i = 0; i < count; ++i) merge_photon(eye, *waiting[i].photon, waiting[i].d2, disc.radius, share);
    count = 0;
  };
  disc.photons->visit(query, [&](const PhotonIndex::Photon& photon, float d2) {
    prefetch(&photons_.paths.at(photon.place).ng);  // the line that is read
    waiting[count++] = {&photon, d2};
    if (count == std::size(waiting)) merge_waiting();
  });
  merge_waiting();
}

void EyeWalk::merge_photon(const EyeEnd& eye, const PhotonIndex::Photon& photon, float d2, double radius, float share) {
  const LightVertex& light = photons_.paths.at(photon.place);
  Found c = ups::merge(in_, counts_, eye, light, photon.p, radius);
  if (!c || !nothing_between(scene_, eye.surface, light.wo, photon.p, light.most_error(), radius, work_)) return;
  ++work_.merges;
  c->value *= share;
  const float weight = float(c->weight(in_, 1));
  if (in_.recorder) in_.recorder->found(*c, {1, c->value, weight}, photons_.paths.running_number(photon.place));
  add(*c, c->value, 1, weight, Drop::merge);
  const float r2 = float(radius * radius);
  const float bias = 2 * luminance(c->value) * weight * (2 * d2 < r2 ? -1.0f : 1.0f);
  if (!std::isfinite(bias)) return;
  tally_.bias += bias;
  if (light.casters && !light.first && eye.edges == counted_edges_) {
    tally_.caustics += counted_share_;
    ++tally_.caustics_met;
    tally_.caustic_light += luminance(c->value) * weight;
  }
  keep_separated(c->emitter, 0.0, 0.0, bias);
}

// y_{s+1} of the extended path space (Hachisuka, Pantaleoni, Jensen 2012, section 3) is drawn from the merging kernel on
// the surface around z_t, and takes the place of z_t for what arrives. Drawn on the tangent disc and moved along the
// normal onto a surface where a photon would be stored and merged; false where there is none: the kernel reaches beyond
// the surface. Of two such surfaces that close to each other it takes the upper one, where merging counts both.
bool EyeWalk::perturb(const EyeEnd& eye, Arrival& out) {
  const float radius = float(disc(eye).radius);
  if (!(radius > 0)) return true;  // no merging here either
  const SurfacePoint& own = eye.surface;
  const SolidPart part(scene_, own, radius);
  Vec3 offset = part.offset({rng_.get(eye.edges, Slot::perturb_x), rng_.get(eye.edges, Slot::perturb_y)});
  for (uint32_t k = 0; k < SolidPart::most_tries && !part.has(offset); ++k) offset = part.offset(rng_.more(eye.edges, k));
  float reach = 2 * max_merge_height * radius;
  Vec3 start = own.p + offset + own.ng * (0.5f * reach);
  for (Hit hit; reach > 0 && scene_.raytracer->intersect(start, -own.ng, reach, hit);) {
    ++work_.rays;
    out.surface = scene_.raytracer->surface_at(hit);
    const float cosine = dot(out.surface.ng, own.ng);
    const Bsdf bsdf(scene_.materials[out.surface.material], out.surface.uv);
    if (merge_gate(bsdf) && cosine >= min_merge_cosine && length2(out.surface.p - own.p) <= radius * radius) {
      out.ratio = 1 / cosine;
      return nothing_between(scene_, own, eye.wo, out.surface.p, out.surface.error, double(radius), work_);
    }
    start = out.surface.ray_origin(-own.ng);
    reach -= hit.t + 2 * out.surface.error;
  }
  return false;
}

}  // namespace ups
