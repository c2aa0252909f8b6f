// Actual vertex perturbation: where path integration arrives in the extended path space (Hachisuka, Pantaleoni, Jensen
// 2012, section 3). Part of EyeWalk, used only where UPS_PERTURBATION_ACTUAL was asked for.
#include "base/warp.h"
#include "transport/eye_walk.h"

namespace ups {

// y_{s+1} is drawn from the merging kernel on the surface around z_t, and
// takes the place of z_t for what arrives. Drawn on the tangent disc and moved along the normal onto a surface where a
// photon would be stored and merged; false where there is none: the kernel reaches beyond the surface. Of two such
// surfaces that close to each other it takes the upper one, where merging counts both.
bool EyeWalk::perturb(const Vertex& v, Arrival& out) {
  const float radius = (v.state.first ? sensor_.first : sensor_.later).radius;
  if (!(radius > 0)) return true;  // no merging here either
  const Vec2 disc = square_to_disc({rng_.get(v.edges, Slot::perturb_x), rng_.get(v.edges, Slot::perturb_y)});
  const Frame frame(v.surface.ng);
  float reach = 2 * max_merge_height * radius;
  Vec3 start = v.surface.p + (frame.s * disc.x + frame.t * disc.y) * radius + v.surface.ng * (0.5f * reach);
  for (Hit hit; reach > 0 && scene_.raytracer->intersect(start, -v.surface.ng, reach, hit);) {
    ++work_.rays;
    out.surface = scene_.raytracer->surface_at(hit);
    const float cosine = dot(out.surface.ng, v.surface.ng);
    const Bsdf bsdf(scene_.materials[out.surface.material], out.surface.uv);
    if (merge_gate(bsdf) && cosine >= min_merge_cosine && length2(out.surface.p - v.surface.p) <= radius * radius) {
      out.perturbed = true;
      out.ratio = 1 / cosine;
      return true;
    }
    start = out.surface.ray_origin(-v.surface.ng);
    reach -= hit.t + 2 * out.surface.error;
  }
  return false;
}

// Flux arrives at the drawn point by its own cosine, and is scattered at the vertex: as a photon is that lies there.
float EyeWalk::perturbed_cosine(const Vertex& v, const Arrival& a, const Vec3& wi) {
  if (!a.perturbed) return 1;
  if (!consistent_side(a.surface, wi, a.surface.shading.to_local(wi))) return 0;
  const float here = dot(wi, a.surface.ng), there = dot(wi, v.surface.ng);
  return here * there > 0 ? a.ratio * here / there : 0;
}

// A point meter's kernel is its disc.
void EyeWalk::perturb_meter() {
  const Vec2 disc = square_to_disc({rng_.get(0, Slot::perturb_x), rng_.get(0, Slot::perturb_y)});
  const Vec3 shift = (meter_frame_.s * disc.x + meter_frame_.t * disc.y) * sensor_.first.radius;
  meter_p_ += shift;
  meter_origin_ += shift;
}

}  // namespace ups
