// See close_surfaces.h.
#include "scene/close_surfaces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>

#include "base/rng.h"
#include "scene/panes.h"

namespace ups {

namespace {

constexpr uint32_t fewest = 8, usual = 64, most = 1u << 12, most_of_all = 1u << 17;  // points of an instance

// The share of an instance's area where is_so(point), by points on its triangles. Where there are enough, each triangle
// has some; else each as far as they go, as small ones may be what matters, and the others lie by area, as a large face may
// be of two triangles. Weights are those of the balance heuristic.
template <class IsSo>
float share_of(const Snapshot& scene, uint32_t instance, size_t instances, const IsSo& is_so) {
  const Mesh& mesh = *scene.meshes[scene.instances[instance].mesh];
  const Affine& to_scene = scene.instances[instance].to_scene;
  const uint32_t triangles = mesh.triangle_count();
  if (triangles == 0) return 0;
  const uint32_t wanted = uint32_t(std::clamp<uint64_t>(4 * uint64_t(triangles), usual, most)),
                 points = std::clamp(uint32_t(most_of_all / instances), fewest, wanted),
                 in_turn = 4 * uint64_t(triangles) <= points ? points
                           : triangles <= points             ? std::max(triangles, points / 2)
                                                             : points / 2,
                 by_area = points - in_turn;
  const auto area_of = [&](uint32_t triangle) {
    const auto corner = [&](size_t k) {
      return to_scene.point(Vec3d(mesh.positions[mesh.indices[3 * size_t(triangle) + k]]));
    };
    return 0.5 * length(cross(corner(1) - corner(0), corner(2) - corner(0)));
  };
  double so = 0, all = 0, total = 0;
  const auto look_at = [&](uint32_t point, uint32_t triangle) {
    const double area = area_of(triangle);
    if (!(area > 0)) return;
    const auto u = philox({point, 6, instance, 0}, {0, 0});
    const float a = std::sqrt(to_unit_float(u[0])), b = to_unit_float(u[1]);
    const double weight = by_area == 0 ? area : 1 / (in_turn / (triangles * area) + by_area / total);
    all += weight;
    if (is_so(scene.raytracer->surface_at(instance, triangle, a * (1 - b), a * b))) so += weight;
  };
  for (uint32_t t = 0; t < triangles && by_area > 0; ++t) total += area_of(t);
  for (uint32_t i = 0; i < in_turn; ++i) look_at(i, uint32_t(uint64_t(i) * triangles / in_turn));
  double up_to = 0;
  uint32_t triangle = 0;
  for (uint32_t i = 0; i < by_area && total > 0; ++i) {
    const double at = (i + double(to_unit_float(philox({i, 6, instance, 1}, {0, 0})[0]))) / by_area * total;
    for (double area; triangle + 1 < triangles && up_to + (area = area_of(triangle)) <= at; ++triangle) up_to += area;
    look_at(in_turn + i, triangle);
  }
  return all > 0 ? float(so / all) : 0;
}

// As far as a ray goes on beyond a surface that it has passed, at most: see encounter.cpp, Ray::pass.
float passed(const Snapshot& scene, const SurfacePoint& s) { return 2 * s.error + 16 * 0x1p-24f * scene.radius; }

const Material& material_of(const Snapshot& scene, uint32_t instance) {
  return scene.materials[scene.instances[instance].material];
}

// Against n.
template <class Random>
Vec3 aslant(const Vec3& n, const Random& u) {
  constexpr float most_slant = 0.5f;
  const auto slant = [&](size_t k) { return most_slant * (2 * to_unit_float(u[k]) - 1); };
  return Frame(n).to_world(normalize(Vec3(slant(0), slant(1), -1)));
}

std::vector<uint32_t> solids_of_glass(const Snapshot& scene) {
  std::vector<uint32_t> glass;
  for (uint32_t i = 0; i < scene.instances.size(); ++i)
    if (scene.media.of_instance[i] != none) glass.push_back(i);
  return glass;
}

}  // namespace

std::vector<PaneOnSurface> find_panes_on_surfaces(const Snapshot& scene, ThreadPool& pool, Monitor& monitor) {
  std::vector<PaneOnSurface> found;
  for (uint32_t i = 0; i < scene.instances.size(); ++i)
    if (scene.panes.is_pane(i)) found.push_back({i});
  std::vector<char> close(found.size());
  parallel_for(pool, found.size(), [&](size_t i) {
    monitor.check();
    PaneOnSurface& pane = found[i];
    std::vector<Hit> hits;
    pane.covered = share_of(scene, pane.instance, found.size(), [&](const SurfacePoint& s) {
      const float length = passed(scene, s);
      hits.clear();
      scene.raytracer->intersect_all(s.p - s.ng * length, s.ng, 2 * length, hits);
      for (const Hit& hit : hits) {
        if (hit.instance == pane.instance) continue;
        close[i] = true;
        if (scene.panes.is_crossed(hit.instance) || traits_of(material_of(scene, hit.instance)).transmits) continue;
        pane.opaque = hit.instance;
        return true;
      }
      return false;
    });
  });
  size_t kept = 0;
  for (size_t i = 0; i < found.size(); ++i)
    if (close[i]) found[kept++] = found[i];
  found.resize(kept);
  return found;
}

std::vector<SheetOnSurface> find_sheets_on_surfaces(const Snapshot& scene, ThreadPool& pool, const Monitor* monitor) {
  std::vector<SheetOnSurface> found;
  for (uint32_t i = 0; i < scene.instances.size(); ++i)
    if (traits_of(material_of(scene, i)).transmits && scene.media.of_instance[i] == none && !scene.panes.is_crossed(i))
      found.push_back({i, none, 0, 0});
  // Rays from either side, aslant, each in its own way: of two surfaces in one plane rounding decides which one is met.
  constexpr uint32_t rays = 8;
  parallel_for(pool, found.size(), [&](size_t i) {
    if (monitor) monitor->check();
    SheetOnSurface& sheet = found[i];
    uint32_t point = 0;
    sheet.covered = share_of(scene, sheet.instance, found.size(), [&](const SurfacePoint& s) {
      ++point;
      const float reach = 2 * s.error;
      for (uint32_t ray = 0; ray < rays; ++ray) {
        const Vec3 d = aslant(ray % 2 ? -s.ng : s.ng, philox({point, ray, sheet.instance, 2}, {0, 0}));
        Hit hit;
        if (!scene.raytracer->intersect(s.p - d * reach, d, 2 * reach, hit) || !stops_light(scene, hit.instance)) continue;
        sheet.opaque = hit.instance, sheet.resolved_m = std::max(sheet.resolved_m, reach);
        return true;
      }
      return false;
    });
  });
  std::erase_if(found, [](const SheetOnSurface& s) { return s.opaque == none; });
  return found;
}

bool stops_light(const Snapshot& scene, uint32_t instance) {
  return scene.media.of_instance[instance] == none && !scene.panes.is_crossed(instance) &&
         scene.emitter_of_instance[instance] == none && !traits_of(material_of(scene, instance)).transmits;
}

std::vector<uint32_t> find_touched_glass(const Snapshot& scene, ThreadPool& pool, Monitor& monitor) {
  std::vector<uint32_t> found = solids_of_glass(scene);
  std::vector<char> touched(found.size());
  parallel_for(pool, found.size(), [&](size_t i) {
    monitor.check();
    std::vector<Hit> hits;
    touched[i] = share_of(scene, found[i], found.size(), [&](const SurfacePoint& s) {
      hits.clear();
      scene.raytracer->intersect_all(s.p - s.ng * (2 * s.error), s.ng, 4 * s.error, hits);
      return std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) { return stops_light(scene, hit.instance); });
    }) > 0;
  });
  size_t kept = 0;
  for (size_t i = 0; i < found.size(); ++i)
    if (touched[i]) found[kept++] = found[i];
  found.resize(kept);
  return found;
}

namespace {

// Without holes.
bool is_opaque(const Snapshot& scene, uint32_t instance) {
  return stops_light(scene, instance) &&
         scene.texturing[scene.instances[instance].material].alpha_mode == SurfaceTexturing::opaque;
}

// Opaque ones.
bool looks_alike(const Material& a, const Material& b) {
  const auto numbers = [](const Material& m) {
    return std::array{m.reflectance.r, m.reflectance.g, m.reflectance.b, m.roughness,   m.ior,         m.metallic,
                      m.ior_rgb.r,     m.ior_rgb.g,     m.ior_rgb.b,     m.ior_k_rgb.r, m.ior_k_rgb.g, m.ior_k_rgb.b};
  };
  return a.model == b.model && numbers(a) == numbers(b) && a.reflectance_texture == b.reflectance_texture &&
         a.roughness_texture == b.roughness_texture && a.metallic_texture == b.metallic_texture;
}

// Rays are aslant, each in its own way: of several that come straight down all would meet the same one of two planes.
// As near as rounding decides: a quarter of what rays are lifted by. none: there is no such surface, or one that faces the
// other way covers both, as a floor covers the lower faces of what stands on it.
uint32_t met_in_plane(const Snapshot& scene, uint32_t instance, const SurfacePoint& s) {
  constexpr float parallel = 0.9999f;
  constexpr uint32_t rays = 4, rays_once_met = 32;  // as only one of three is met, as rounding has it
  const auto bits = [](float v) { return std::bit_cast<uint32_t>(v); };
  const auto is_other = [&](uint32_t other) {
    return !looks_alike(material_of(scene, other), material_of(scene, instance)) ||
           scene.texturing[scene.instances[other].material] != scene.texturing[scene.instances[instance].material];
  };
  const float gap = 0.25f * s.error;
  uint32_t met = none;
  for (uint32_t ray = 0; ray < (met == none ? rays : rays_once_met); ++ray) {
    const Vec3 d = aslant(s.ng, philox({bits(s.p.x), bits(s.p.y), bits(s.p.z), ray}, {0, 0}));
    Hit hit;
    if (!scene.raytracer->intersect(s.p - d * gap, d, 2 * gap, hit) || hit.instance == instance ||
        !is_opaque(scene, hit.instance))
      continue;
    const float facing = dot(scene.raytracer->surface_at(hit).ng, s.ng);
    if (facing < -parallel) return none;
    if (facing > parallel && is_other(hit.instance)) met = hit.instance;
  }
  return met;
}

// Nobody sees what the smaller of both encloses, as the lower face of a box that is wound inwards and stands on a floor.
bool is_enclosed(const Snapshot& scene, const SurfacePoint& s, uint32_t a, uint32_t b) {
  const auto size = [&](uint32_t i) {
    const Raytracer::Instance& instance = scene.instances[i];
    const Box& box = scene.mesh_boxes[instance.mesh];
    return double(length(box.upper - box.lower)) * std::cbrt(std::abs(instance.to_scene.determinant()));
  };
  Hit hit;
  return scene.raytracer->intersect(s.ray_origin(s.ng), s.ng, INFINITY, hit) &&
         hit.instance == (size(a) < size(b) ? a : b);
}

}  // namespace

std::vector<Overlaid> find_overlaid(const Snapshot& scene, ThreadPool& pool, const Monitor* monitor) {
  const size_t count = scene.instances.size();
  std::vector<Overlaid> found(count);
  parallel_for(pool, count, [&](size_t i) {
    if (monitor) monitor->check();
    Overlaid& here = found[i];
    here.instance = uint32_t(i);
    if (!is_opaque(scene, here.instance)) return;
    share_of(scene, here.instance, count, [&](const SurfacePoint& s) {
      if (here.beneath != none) return false;
      const uint32_t other = met_in_plane(scene, here.instance, s);
      if (other == none || is_enclosed(scene, s, here.instance, other)) return false;
      here.beneath = other, here.resolved_m = s.error;
      return true;
    });
  });
  const auto is_told = [&](const Overlaid& o) {  // a pair once
    return o.beneath != none && (found[o.beneath].beneath != o.instance || o.instance > o.beneath);
  };
  std::vector<Overlaid> out;
  std::copy_if(found.begin(), found.end(), std::back_inserter(out), is_told);
  return out;
}

std::vector<uint32_t> find_thin_glass(const Snapshot& scene, ThreadPool& pool) {
  const std::vector<uint32_t> glass = solids_of_glass(scene);
  std::vector<float> thin(glass.size());
  parallel_for(pool, glass.size(), [&](size_t i) {
    const bool inside_out = scene.media.is_inside_out(glass[i]);
    thin[i] = share_of(scene, glass[i], glass.size(), [&](const SurfacePoint& s) {
      // From where a refracted ray starts back to the face that it came through; behind the glass it is the other one.
      const Vec3 outwards = inside_out ? -s.ng : s.ng;
      Hit hit;
      if (!scene.raytracer->intersect(s.p - outwards * (2 * s.error), outwards, 3 * s.error, hit)) return false;
      const Vec3 ng = scene.raytracer->surface_at(hit).ng;
      return hit.instance == glass[i] && (dot(outwards, ng) < 0) != inside_out;
    });
  });
  std::vector<uint32_t> out;
  for (size_t i = 0; i < glass.size(); ++i)
    if (thin[i] > 0.5f) out.push_back(glass[i]);
  return out;
}

}  // namespace ups
