// See encounter.h.
#include "transport/encounter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/per_thread.h"
#include "scene/close_surfaces.h"

namespace ups {

Rgb Encounter::transmittance_of_stretches(const Snapshot& scene, float t) const {
  Rgb product(1.0f);
  float from = 0;
  for (const Stretch& s : earlier) {
    if (s.end >= t) return product * attenuation(scene, s.media, t - from);
    product *= attenuation(scene, s.media, s.end - from);
    from = s.end;
  }
  return product * attenuation(scene, media, t - from);
}

Encounter::Crossed Encounter::crossed_before(float t) const {
  Crossed last{0, Rgb(1.0f), 1};
  for (const Crossed& c : panes)
    if (c.end < t) last = c;
  return last;
}

namespace {

// A boundary's own solid or open medium, and whether the ray comes out of it.
struct Face {
  uint32_t medium;
  bool leaves;
};

// The surface knows best what lies before it: `walk` is what the walk believes. What was left without having been
// entered was around the walk all along.
void before(const Snapshot& scene, const Face& f, MediaStack& walk) {
  if (scene.media.by_rank[f.medium].is_open()) {
    if (f.leaves)
      walk.set_open(f.medium);
    else if (walk.open() == f.medium)
      walk.set_open(none);
  } else if (f.leaves) {
    walk.add(f.medium);
  } else {
    walk.remove(f.medium);
  }
}

// On a face's inside or outside. Outside an open surface is outside of all of them.
void set_side(const Snapshot& scene, uint32_t medium, bool inside, MediaStack& walk) {
  if (scene.media.by_rank[medium].is_open())
    walk.set_open(inside ? medium : none);
  else if (inside)
    walk.add(medium);
  else
    walk.remove(medium);
}

float index_of(const Snapshot& scene, const MediaStack& media) {
  return media.top() == none ? 1.0f : scene.materials[scene.media.by_rank[media.top()].material].ior;
}

Face face_of(const Snapshot& scene, const SurfacePoint& s, const Vec3& d) {
  return {scene.media.of_instance[s.instance], scene.media.leaves(s.instance, d, s.ng)};
}

// All surfaces that lie within rounding of one, and the direction across it that a ray along d goes on: hits' t is
// `reach` at the surface itself.
struct Across {
  Vec3 direction;
  float reach;
  const std::vector<Hit>& hits;  // until the thread's next
};
Across look_across(const Snapshot& scene, const SurfacePoint& s, const Vec3& d) {
  static const PerThread<std::vector<Hit>> kept;
  std::vector<Hit>& hits = kept.get();
  hits.clear();
  const Vec3 across = dot(d, s.ng) < 0 ? -s.ng : s.ng;
  const float reach = 2 * s.error;  // as ray_origin() leaves the surface
  scene.raytracer->intersect_all(s.p - across * reach, across, 2 * reach, hits);
  return {across, reach, hits};
}

// The other faces that lie within rounding of the one at e.surface. The strongest solid's stands for all, whichever a
// walk met, so that both walks of a path scatter at the same.
void gather_faces(const Snapshot& scene, const Vec3& d, Encounter& e, std::vector<Face>& faces) {
  const auto& [across, reach, hits] = look_across(scene, e.surface, d);
  const SurfacePoint met = e.surface;
  uint32_t strongest = faces[0].medium;
  for (const Hit& hit : hits) {
    if (hit.instance == met.instance || scene.media.of_instance[hit.instance] == none) continue;
    const SurfacePoint other = scene.raytracer->surface_at(hit);
    faces.push_back(face_of(scene, other, across));
    if (faces.back().medium >= strongest) continue;
    strongest = faces.back().medium;
    e.surface = other;
    e.surface.p = met.p, e.surface.error = met.error;
  }
}

// What the glass at e.surface touches, and no light goes through, is met instead, whichever of the two rounding lets a
// ray meet first: they are in optical contact, and a ray that goes on beyond the face would start behind it. Not what the
// ray comes from.
bool meets_touched(const Snapshot& scene, const Vec3& d, Encounter& e) {
  if (!scene.panes.is_touched_glass(e.surface.instance)) return false;
  const Across across = look_across(scene, e.surface, d);
  for (const Hit& hit : across.hits) {
    if (!stops_light(scene, hit.instance)) continue;
    const SurfacePoint touched = scene.raytracer->surface_at(hit);
    if (hit.t < across.reach - touched.error) continue;
    e.surface = touched;
    return true;
  }
  return false;
}

// The media about e.surface, for a ray along d that ran in e.media until there; without other faces this is all where
// media do not nest.
void find_sides(const Snapshot& scene, const Vec3& d, Encounter& e) {
  const Face own = face_of(scene, e.surface, d);
  if (own.medium == none) {
    e.front = e.back = e.media;
    return;
  }
  before(scene, own, e.media);
  e.front = e.back = e.media;
  const bool in_front = scene.media.is_inside_out(e.surface.instance);
  set_side(scene, own.medium, in_front, e.front);
  set_side(scene, own.medium, !in_front, e.back);
  const float ior = scene.materials[e.surface.material].ior;
  e.relative_ior = in_front ? 1 / ior : ior;
}

void find_nested_sides(const Snapshot& scene, const Vec3& d, Encounter& e) {
  const Face own = face_of(scene, e.surface, d);
  if (own.medium == none) {
    e.front = e.back = e.media;
    return;
  }
  static const PerThread<std::vector<Face>> kept;
  std::vector<Face>& faces = kept.get();
  faces.assign(1, own);
  if (scene.media.by_rank[own.medium].meets_others) gather_faces(scene, d, e, faces);
  for (const Face& f : faces) before(scene, f, e.media);
  MediaStack near = e.media, far = e.media;
  for (const Face& f : faces) {
    set_side(scene, f.medium, f.leaves, near);
    set_side(scene, f.medium, !f.leaves, far);
  }
  const bool from_front = dot(d, e.surface.ng) < 0;
  e.front = from_front ? near : far;
  e.back = from_front ? far : near;
  e.relative_ior = index_of(scene, e.back) / index_of(scene, e.front);
}

bool is_without_effect(const Snapshot& scene, const Encounter& e) {
  return scene.media.of_instance[e.surface.instance] != none && e.relative_ior == 1 &&
         scene.emitter_of_instance[e.surface.instance] == none;
}

PaneCrossing crossing(const Snapshot& scene, const SurfacePoint& s, const Vec3& d) {
  PaneCrossing c{Rgb(1.0f), Rgb(0.0f), 1};
  if (scene.panes.is_pane(s.instance)) c = cross_pane(scene.materials[s.material], std::abs(dot(d, s.shading.n)));
  if (!scene.panes.is_blended(s.instance)) return c;
  const float met = coverage(scene, s);
  return {c.reflectance * met, Rgb(1 - met) + c.transmittance * met, c.reflected * met};
}

// One number serves all panes of an edge: what is left of it after each is uniform again.
bool goes_through(const Snapshot& scene, const Vec3& d, PaneNumber& number, bool panes_show_nothing, Encounter& e) {
  const PaneCrossing pane = crossing(scene, e.surface, d);
  if (panes_show_nothing && scene.panes.is_pane(e.surface.instance) && !is_black(pane.transmittance)) return true;
  float& u = number.value();
  if (u < pane.reflected || is_black(pane.transmittance)) return false;
  u = std::min((u - pane.reflected) / (1 - pane.reflected), 0x1.fffffep-1f);
  const Encounter::Crossed before = e.panes.empty() ? Encounter::Crossed{0, Rgb(1.0f), 1} : e.panes.back();
  const float pass = 1 - pane.reflected;
  e.panes.push_back({e.distance, before.share * pane.transmittance * (1 / pass), before.pass * pass});
  return true;
}

// A ray that goes on beyond surfaces along its own line: one that is lifted off each of them drifts, and would meet what
// lies at its end.
struct Ray {
  const Snapshot& scene;
  Vec3 o, d;
  float from = 0, last = -1, reach = 0;  // of what was passed last, to be met once
  uint32_t instance = none;
  // Other surfaces that a blended one lies on, as a rug on a floor, or a pane, as on a wall: where the ray goes on lies
  // beyond them.
  std::array<Hit, 4> beneath{};  // t from o
  size_t beneath_count = 0, beneath_met = 0;

  // The next hit before `end`, its distance from o.
  bool next(float end, WorkCounts& work, Hit& hit, float& distance) {
    if (beneath_met < beneath_count) {
      hit = beneath[beneath_met++];
      distance = hit.t;
      return distance < end;
    }
    for (;;) {
      ++work.rays;
      if (!(end > from) || !scene.raytracer->intersect(o + d * from, d, end - from, hit)) return false;
      distance = from + hit.t;
      if (hit.instance != instance || distance - last > reach) return true;
      from = distance + reach;
    }
  }
  void pass(const SurfacePoint& s, float distance) {
    const float lift = 2 * s.error + 4 * 0x1p-24f * (max_abs(o) + distance), cosine = std::abs(dot(d, s.ng));
    const float beyond = distance + lift / std::max(cosine, 0.05f);
    if (beneath_met < beneath_count) return;  // what is left lies before where the ray goes on
    if (!scene.panes.blended.empty() || scene.panes.is_on_surface(s.instance))
      find_beneath(s, distance, 2 * distance - beyond, beyond);
    last = distance;
    instance = s.instance;
    reach = 2 * lift / std::max(cosine, 1e-3f);
    from = std::max(from, beyond);
  }

 private:
  // A blended film on a pane, too, whichever of the two was met first.
  void find_beneath(const SurfacePoint& s, float distance, float begin, float end) {
    static const PerThread<std::vector<Hit>> kept;
    std::vector<Hit>& hits = kept.get();
    hits.clear();
    begin = std::max(begin, from);
    beneath_count = beneath_met = 0;
    if (!(end > begin)) return;
    scene.raytracer->intersect_all(o + d * begin, d, end - begin, hits);
    uint32_t before = s.instance;
    for (Hit& hit : hits) {
      if (hit.instance == s.instance || hit.instance == before) continue;
      before = hit.instance;
      const bool full = beneath_count == beneath.size();
      if (full && scene.panes.is_crossed(hit.instance)) continue;
      hit.t = std::max(begin + hit.t, std::nextafter(distance, INFINITY));  // behind it, whatever rounding says
      beneath[full ? beneath_count - 1 : beneath_count++] = hit;
      if (full) break;
    }
  }
};

}  // namespace

void meet(const Snapshot& scene, const Vec3& o, const Vec3& d, const MediaStack& start, PaneNumber& u,
          WorkCounts& work, Encounter& out, bool panes_show_nothing) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  out.media = start;
  out.earlier.clear();
  out.panes.clear();
  out.relative_ior = 1;
  for (Ray ray{scene, o, d};; ray.pass(out.surface, out.distance)) {
    Hit hit;
    out.distance = infinity;
    out.found = ray.next(infinity, work, hit, out.distance);
    if (!out.found) return;
    out.surface = scene.raytracer->surface_at(hit);
    const bool crossed = scene.panes.is_crossed(hit.instance);
    if (crossed && goes_through(scene, d, u, panes_show_nothing, out)) continue;
    meets_touched(scene, d, out);
    if (!scene.media.nest) return find_sides(scene, d, out);
    find_nested_sides(scene, d, out);
    if (crossed || !is_without_effect(scene, out)) return;
    out.earlier.push_back({out.distance, out.media});
    out.media = out.beyond(d);
  }
}

namespace {

// Up to `length` from a along d.
bool is_free_through(const Snapshot& scene, const MediaStack& media, const Vec3& a, const Vec3& d, float length,
                     WorkCounts& work, Passage& passage) {
  static const PerThread<Encounter> kept;
  Encounter& e = kept.get();
  e.media = media;
  e.relative_ior = 1;
  const bool nest = scene.media.nest;
  float before = 0, distance = 0;
  Hit hit;
  for (Ray ray{scene, a, d}; ray.next(length, work, hit, distance); ray.pass(e.surface, distance)) {
    const bool pane = scene.panes.is_crossed(hit.instance);
    if (!pane && !(nest && scene.media.of_instance[hit.instance] != none)) return false;
    e.surface = scene.raytracer->surface_at(hit);
    if (!pane && meets_touched(scene, d, e)) return false;
    if (nest) find_nested_sides(scene, d, e);  // which changes nothing at a pane
    if (!pane && !is_without_effect(scene, e)) return false;
    if (nest) passage.transmittance *= attenuation(scene, e.media, distance - before);
    before = distance;
    if (pane) {
      const PaneCrossing way = crossing(scene, e.surface, d);
      if (is_black(way.transmittance)) return false;
      passage.transmittance *= way.transmittance;
      passage.pass *= 1 - double(way.reflected);
    } else {
      e.media = e.beyond(d);
    }
  }
  if (nest) passage.transmittance *= attenuation(scene, e.media, std::max(0.0f, length - before));
  return true;
}

}  // namespace

bool segment_free(const Snapshot& scene, const MediaStack& media, const Vec3& a, const Vec3& b, WorkCounts& work,
                  Passage& passage) {
  const Vec3 d = b - a;
  const float l = length(d);
  if (!(l > 0)) return true;
  // The rounding of origin, direction and length moves the end along, however exact the end's own coordinates are: a
  // small surface in the middle of the scene must not hide its own points from what is far away.
  const float rounding = 16 * 0x1p-24f * (max_abs(a) + l);
  if (scene.media.nest || scene.panes.may_lie_between(a, b))
    return is_free_through(scene, media, a, d / l, l - rounding, work, passage);
  ++work.rays;
  return !(l > rounding) || !scene.raytracer->occluded(a, d / l, l - rounding);
}

}  // namespace ups
