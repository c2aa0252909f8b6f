// See eye_walk.h: density estimation around an eye path's vertex, and perturbation, which stands for it in tests.
#include "transport/eye_walk.h"
#include "transport/techniques.h"

namespace ups {

// For photons on the same side of the same surface within the radius: density estimation. False where there is none.
bool EyeWalk::ask_photons(const EyeEnd& eye, PhotonIndex::Query& query) {
  const EyeSensor::Disc& disc = this->disc(eye);
  if (!eye.merge || !(disc.radius > 0)) return false;
  disc.photons->ask(eye.surface.p, float(disc.radius), query);
  const bool counts = &disc == &sensor_.first && counted_edges_ == none;
  solid_.reset();
  if (counts) count_disc(eye, disc.radius);
  return query.count > 0;
}

// Discs of neighbours overlap, and find the same photons. Of a path that has two such vertices the first one counts.
void EyeWalk::count_disc(const EyeEnd& eye, double radius) {
  const SolidPart part = in_.plan.seeks_caustics ? solid_part(eye, radius) : SolidPart{};  // else nobody reads it
  const float area = pi * float(radius * radius), cosine = std::abs(dot(eye.wo, eye.surface.ng)),
              own = eye.edges == 0 ? sensor_.own_area_m2 : own_angle_sr_ * seen_from_m_ * seen_from_m_ / cosine;
  counted_edges_ = eye.edges;
  tally_.disc_m2 = std::min(area * part.share, own);
  counted_share_ = std::min(1.0f, own * part.over / area);
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

// Where alpha cuts holes into the disc about a vertex, as its triangle's mapping goes on.
class EyeWalk::Holes {
 public:
  static constexpr uint32_t most_tries = 1 << 12;
  static Vec3 offset(const SurfacePoint& s, const Vec2& square, double radius) {
    const Frame frame(s.ng);
    const Vec2 disc = square_to_disc(square);
    return (frame.s * disc.x + frame.t * disc.y) * float(radius);
  }
  Holes(const Snapshot& scene, const SurfacePoint& s, double radius) : uv_(s.uv) {
    const SurfaceTexturing& t = scene.texturing[s.material];
    if (!t.alpha || !t.may_have_holes()) return;
    constexpr double most_repeats = 1e4;  // beyond it floats tell no places of the texture apart
    chart_ = scene.raytracer->chart_at(s);
    if (std::max(max_abs(chart_.u), max_abs(chart_.v)) * radius < most_repeats) texturing_ = &t;
  }
  explicit operator bool() const { return texturing_; }
  bool has(const Vec3& offset) const {
    return texturing_ && texturing_->is_hole_at({uv_.x + dot(chart_.u, offset), uv_.y + dot(chart_.v, offset)});
  }

 private:
  const Vec2 uv_;
  const SurfaceTexturing* texturing_ = nullptr;  // null: no holes
  Raytracer::Chart chart_;
};

// The part of a disc where photons can be: places of it at random until so many are solid are in the mean as many times
// more as it is smaller (negative binomial distribution; of its share Haldane 1945, Biometrika 33, 222). What the mapping
// takes for a hole may be filled: by another part of the mesh, a frame, the floor below.
const EyeWalk::SolidPart& EyeWalk::solid_part(const EyeEnd& eye, double radius) {
  if (!solid_) solid_ = try_solid_part(eye, radius);
  return *solid_;
}

EyeWalk::SolidPart EyeWalk::try_solid_part(const EyeEnd& eye, double radius) {
  constexpr uint32_t wanted = 8;  // which adds at most a third of what is merged here as noise
  const Holes holes(scene_, eye.surface, radius);
  if (!holes) return {};
  uint32_t tries = 0, solid = 0;
  for (Arrival beside; solid < wanted && tries < Holes::most_tries; ++tries) {
    const Vec3 offset = Holes::offset(eye.surface, rng_.more(eye.edges, tries), radius);
    solid += !holes.has(offset) || meet_beside(eye, offset, radius, beside);
  }
  if (solid == 0) return {};
  return {float(tries) / float(solid), solid < wanted ? float(solid) / float(tries) : (wanted - 1) / float(tries - 1)};
}

// Vertices lie anywhere in memory: some are asked for before the first of them is read.
void EyeWalk::merge(const EyeEnd& eye, PhotonIndex::Query& query) {
  const EyeSensor::Disc& disc = this->disc(eye);
  const float share = float(thin(eye, query));
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
  c->value *= share * solid_part(eye, radius).over;
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

// Moves from beside a vertex along its normal onto a surface where a photon would be stored and merged; false where there
// is none. Of two such surfaces that close to each other it takes the upper one, by ng, where merging counts both.
bool EyeWalk::meet_beside(const EyeEnd& eye, const Vec3& offset, double radius, Arrival& out) {
  const SurfacePoint& own = eye.surface;
  const Vec3& side = eye.edges == 0 ? own.shading.n : eye.wo;
  float reach = 2 * max_merge_height * float(radius);
  Vec3 start = own.p + offset + own.ng * (0.5f * reach);
  for (Hit hit; reach > 0;) {
    ++work_.rays;
    if (!scene_.raytracer->intersect(start, -own.ng, reach, hit)) return false;
    out.surface = scene_.raytracer->surface_at(hit);
    const float cosine = dot(out.surface.ng, own.ng);
    const Bsdf bsdf(scene_.materials[out.surface.material], out.surface.uv);
    const bool blends = coverage(scene_, out.surface) < 1;
    if (merge_gate(bsdf) && merges_with(scene_, own, out.surface.material, blends) && cosine >= min_merge_cosine &&
        length2(out.surface.p - own.p) <= float(radius) * float(radius)) {
      out.ratio = 1 / cosine;
      return nothing_between(scene_, own, side, out.surface.p, out.surface.error, radius, work_);
    }
    start = out.surface.ray_origin(-own.ng);
    reach -= hit.t + 2 * out.surface.error;
  }
  return false;
}

// y_{s+1} of the extended path space (Hachisuka, Pantaleoni, Jensen 2012, section 3) is drawn from the merging kernel on
// the surface around z_t, and takes the place of z_t for what arrives. Drawn on the tangent disc, again where a hole is;
// false where there is no surface: the kernel reaches beyond it.
bool EyeWalk::perturb(const EyeEnd& eye, Arrival& out) {
  const double radius = disc(eye).radius;
  if (!(radius > 0)) return true;  // no merging here either
  const Holes holes(scene_, eye.surface, radius);
  Vec2 square(rng_.get(eye.edges, Slot::perturb_x), rng_.get(eye.edges, Slot::perturb_y));
  for (uint32_t k = 0; k < Holes::most_tries; square = rng_.more(eye.edges, k++)) {
    const Vec3 offset = Holes::offset(eye.surface, square, radius);
    if (meet_beside(eye, offset, radius, out)) return true;
    if (!holes.has(offset)) return false;
  }
  return false;
}

}  // namespace ups
