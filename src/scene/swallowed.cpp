// See swallowed.h. A few light paths of each emitter, of which nothing but the way counts: most emitters prove innocent
// after some twenty rays.
#include "scene/swallowed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rng.h"
#include "geometry/box.h"
#include "scene/probe.h"

namespace ups {

namespace {

constexpr uint32_t max_edges = 16;

// Lengths are measured across the surface that an edge meets, from where the edge starts to the surface's plane: in the
// gap between two planes all light goes as far as the gap is wide, however slanting.
class Suspect {
 public:
  Suspect(const Snapshot& scene, uint32_t emitter)
      : scene_(scene), emitter_(scene.emitters[emitter]), narrow_(std::min(0.5f, scene.radius / 8)) {
    // The slot around a source that a surface covers lets a share of 4 gap / size past its body.
    const float size = scene.emitter_sizes[emitter];
    front_gap_ = std::min(std::max(0.001f, size / 50), scene.radius / 250);
    back_gap_ = 3 * front_gap_;  // seldom is a source meant to be so close behind what faces away
  }

  SwallowedLight judge(uint32_t paths) {
    for (uint32_t i = 0; i < paths && (may_be_in_gap(paths) || may_be_shut_in(paths)); ++i) follow(i, paths);
    SwallowedLight out;
    if (4 * paths_ < paths) return out;
    if (may_be_in_gap(paths_))
      out.kind = SwallowedLight::in_gap;
    else if (may_be_shut_in(paths_) && out_ <= out_share * edges_ && !measured_within())
      out.kind = SwallowedLight::shut_in;
    out.instance = instance_;
    out.from_behind = 2 * fronts_ < paths_;
    out.gap_m = gap_;
    out.extent_m = Vec3(space_.upper - space_.lower);
    return out;
  }

 private:
  // Of 50 paths one may go astray.
  bool may_be_in_gap(uint32_t paths) const { return 50 * beyond_gap_ <= paths; }
  // In a space that is closed on all sides, no edge is wide. Within a wall, or between a ceiling and the slab above it,
  // those along it are, but seldom two in a row, as in a room; and what light meets first shows its back. Early on
  // chance is allowed for.
  static constexpr double out_share = 0.015;
  bool may_be_shut_in(uint32_t paths) const {
    return !any_wide_ || (50 * fronts_ <= paths && out_ <= max_edges + out_share * edges_);
  }

  void follow(uint32_t i, uint32_t paths) {
    const FirstLight light = first_light(scene_, emitter_, i);
    if (!(light.flux > 0)) return;
    ++paths_;
    SurfacePoint s = light.surface;
    Vec3 o = light.origin, d = light.direction;
    space_.grow(Vec3d(o));
    bool found = light.hit, was_wide = false;
    for (uint32_t edge = 0;; ++edge) {
      if (!found) {  // once out it stays out
        out_ += max_edges - edge;
        edges_ += max_edges - edge;
        any_wide_ = true;
        if (edge == 0) ++beyond_gap_, ++fronts_;
        return;
      }
      const float across = std::abs(dot(s.p - o, s.ng));
      ++edges_;
      const bool wide = across > narrow_;
      any_wide_ |= wide;
      if (wide && was_wide) ++out_;
      was_wide = wide;
      space_.grow(Vec3d(s.p));
      BsdfSample next;
      const bool goes_on = bounce(i, edge, s, d, next);
      if (edge == 0) meet_first(s, d, across + light.lift, goes_on && (next.delta || next.transmitted));
      if (!goes_on || edge + 1 == max_edges || !may_be_shut_in(paths)) return;
      d = s.shading.to_world(next.wi);
      o = s.ray_origin(d);
      Hit hit;
      found = intersect_blended(scene_, o, d, hit);
      if (found) s = scene_.raytracer->surface_at(hit);
    }
  }

  bool bounce(uint32_t path, uint32_t edge, const SurfacePoint& s, const Vec3& d, BsdfSample& next) const {
    const auto u = philox({path, 3 + edge, 0, 0}, {0, 0});
    const Bsdf bsdf(scene_.materials[s.material], s.uv);
    return bsdf.sample(s.shading.to_local(-d), to_unit_float(u[0]), {to_unit_float(u[1]), to_unit_float(u[2])},
                       TransportMode::importance, next);
  }

  void meet_first(const SurfacePoint& s, const Vec3& d, float across, bool passes) {
    const bool behind = dot(d, s.ng) > 0;
    if (!behind) ++fronts_;
    if (passes || across > (behind ? back_gap_ : front_gap_))
      ++beyond_gap_;
    else
      gap_ = std::max(gap_, across);
    if (instance_ == none) instance_ = s.instance;
  }

  // Whoever measures within the space means the light to be there.
  bool measured_within() const {
    const Vec3d margin = (space_.upper - space_.lower) * 0.01;
    const auto within = [&](const Vec3& p) {
      const Vec3d a = Vec3d(p) - space_.lower - margin, b = space_.upper - margin - Vec3d(p);
      return std::min({a.x, a.y, a.z, b.x, b.y, b.z}) > 0;
    };
    for (const Camera& camera : scene_.cameras)
      if (within(camera.position())) return true;
    for (const MeterSet& set : scene_.meter_sets)
      for (const Meter& meter : set.meters)
        if (within(meter.p)) return true;
    return false;
  }

  const Snapshot& scene_;
  const Emitter& emitter_;
  float narrow_, front_gap_, back_gap_;
  uint32_t paths_ = 0, edges_ = 0, out_ = 0, fronts_ = 0, beyond_gap_ = 0;
  bool any_wide_ = false;
  uint32_t instance_ = none;
  float gap_ = 0;
  Box space_;
};

}  // namespace

std::vector<SwallowedLight> find_swallowed_light(const Snapshot& scene, ThreadPool& pool) {
  const size_t count = scene.emitters.size();
  std::vector<SwallowedLight> found(count);
  if (count == 0) return found;
  const auto paths = uint32_t(std::clamp<size_t>((size_t(1) << 17) / count, 32, 128));
  parallel_for(pool, count, [&](size_t i) {
    if (!scene.emitters[i].is_directional()) found[i] = Suspect(scene, uint32_t(i)).judge(paths);
  });
  return found;
}

}  // namespace ups
