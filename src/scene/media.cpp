// See media.h: which meshes enclose a volume, the order of media, what a point lies in. Overlaps are in overlaps.cpp.
#include "scene/media.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/per_thread.h"
#include "geometry/box.h"
#include "scene/snapshot.h"

namespace ups {
namespace {

// Integrals over a closed surface: of n 0, of x_i n_j the volume for i = j, else 0. What is missing of them comes from
// holes and open ends; this share of the area (times the extent) may be cracks.
constexpr double closed_within = 1e-4;

// A volume below this share of area times extent is none: two sheets back to back enclose what rounding makes.
constexpr double rounding_of_volume = 1e-7;

struct Enclosed {
  double volume = INFINITY;  // infinite: nothing
  bool inside_out = false;   // as a whole; shells of hollows within it are wound the other way
};

Enclosed enclosed_by(const Mesh& mesh) {
  if (mesh.indices.empty()) return {};
  const Vec3d o(mesh.positions[*std::min_element(mesh.indices.begin(), mesh.indices.end())]);  // a vertex of its own
  Vec3d sum, moment[3];  // of n; of n times x, y, z
  double area = 0, extent = 0;
  for (size_t t = 0; t < mesh.indices.size(); t += 3) {
    Vec3d p[3];
    for (size_t k = 0; k < 3; ++k) p[k] = Vec3d(mesh.positions[mesh.indices[t + k]]) - o;
    const Vec3d normal = cross(p[1] - p[0], p[2] - p[0]) * 0.5, middle = (p[0] + p[1] + p[2]) * (1 / 3.0);
    sum = sum + normal;
    moment[0] = moment[0] + normal * middle.x, moment[1] = moment[1] + normal * middle.y;
    moment[2] = moment[2] + normal * middle.z;
    area += length(normal);
    extent = std::max(extent, max_abs(middle));
  }
  const double volume = (moment[0].x + moment[1].y + moment[2].z) / 3;
  moment[0].x -= volume, moment[1].y -= volume, moment[2].z -= volume;
  const double excess = std::max({max_abs(moment[0]), max_abs(moment[1]), max_abs(moment[2])});
  const bool closed = length(sum) <= closed_within * area && excess <= closed_within * area * extent;
  if (!closed) return {};
  if (volume > 0) return {volume, false};
  return volume < -rounding_of_volume * area * extent ? Enclosed{-volume, true} : Enclosed{};
}

struct Extent {
  Box box;
  uint32_t medium;
};

// Boxes that meet, within rounding: by a sweep along x.
void mark_meetings(std::vector<Extent> extents, Media& media) {
  std::sort(extents.begin(), extents.end(),
            [](const Extent& a, const Extent& b) { return a.box.lower.x < b.box.lower.x; });
  for (size_t i = 0; i < extents.size(); ++i)
    for (size_t j = i + 1; j < extents.size() && extents[j].box.lower.x <= extents[i].box.upper.x; ++j) {
      const Box &a = extents[i].box, &b = extents[j].box;
      if (a.lower.y > b.upper.y || b.lower.y > a.upper.y || a.lower.z > b.upper.z || b.lower.z > a.upper.z) continue;
      media.by_rank[extents[i].medium].meets_others = media.by_rank[extents[j].medium].meets_others = true;
      media.nest = true;
    }
}

Box padded(Box box) {
  constexpr double rounding = 0x1p-18;
  const double pad = rounding * std::max(max_abs(box.lower), max_abs(box.upper));
  box.lower = box.lower - Vec3d(pad, pad, pad), box.upper = box.upper + Vec3d(pad, pad, pad);
  return box;
}

// The media of all glass instances, and of each instance its own; solids only where some are wanted.
Media list(const std::vector<Medium>& of_glass, size_t instance_count, bool solids) {
  Media media;
  media.of_instance.assign(instance_count, none);
  std::vector<Medium> all = of_glass;
  for (Medium& m : all)
    if (!solids) m.volume = INFINITY;
  const auto key = [](const Medium& m) {
    return std::make_tuple(-int64_t(m.priority), m.volume, m.is_open() ? m.material : m.instance);
  };
  std::sort(all.begin(), all.end(), [&](const Medium& a, const Medium& b) { return key(a) < key(b); });
  for (const Medium& m : all) {
    const bool known = m.is_open() && !media.by_rank.empty() && key(media.by_rank.back()) == key(m);
    if (!known) media.by_rank.push_back(m);
    media.of_instance[m.instance] = uint32_t(media.by_rank.size() - 1);
  }
  return media;
}

}  // namespace

Media rank_media(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                 const std::vector<Raytracer::Instance>& instances, const std::vector<Material>& materials,
                 const std::vector<SurfaceTexturing>& texturing) {
  std::vector<std::optional<Enclosed>> enclosed(meshes.size());  // by each mesh, once it was asked for
  std::vector<bool> inside_out(instances.size());
  std::vector<Medium> glass;
  bool index_of_air = false;
  size_t solids = 0;
  for (uint32_t i = 0; i < instances.size(); ++i) {
    const Mesh& mesh = *meshes[instances[i].mesh];
    const Material& material = materials[instances[i].material];
    if (material.model != MaterialModel::glass) continue;
    std::optional<Enclosed>& by_mesh = enclosed[instances[i].mesh];
    const bool holes = texturing[instances[i].material].alpha_mode != SurfaceTexturing::opaque;
    if (!by_mesh) by_mesh = holes ? Enclosed{} : enclosed_by(mesh);
    const double scale = std::abs(instances[i].to_scene.determinant());
    glass.push_back({instances[i].material, material.priority, by_mesh->volume * scale, i});
    inside_out[i] = by_mesh->inside_out;
    solids += !glass.back().is_open();
    index_of_air |= material.ior == 1;
  }
  Media media = list(glass, instances.size(), true);
  media.nest = index_of_air || (solids > 0 && solids < glass.size());
  std::vector<Box> boxes(meshes.size());
  std::vector<Extent> extents;
  for (const Medium& m : glass) {
    if (m.is_open()) continue;
    const Raytracer::Instance& instance = instances[m.instance];
    Box& box = boxes[instance.mesh];
    if (box.empty()) box = bounding_box(*meshes[instance.mesh]);
    extents.push_back({padded(box.transformed(instance.to_scene)), media.of_instance[m.instance]});
  }
  mark_meetings(std::move(extents), media);
  if (!media.nest) media = list(glass, instances.size(), false);
  if (std::find(inside_out.begin(), inside_out.end(), true) != inside_out.end())
    media.inside_out = std::move(inside_out);
  return media;
}

namespace {

MediaStack open_medium_at(const Snapshot& scene, Vec3 p, const Vec3& d) {
  MediaStack stack;
  Hit hit;
  for (int crossings = 0; crossings < 10'000; ++crossings) {
    if (!scene.raytracer->intersect(p, d, INFINITY, hit)) break;
    const SurfacePoint s = scene.raytracer->surface_at(hit);
    const uint32_t m = scene.media.of_instance[s.instance];
    if (m != none) {
      if (scene.media.leaves(s.instance, d, s.ng)) stack.set_open(m);
      break;
    }
    p = s.ray_origin(d);
  }
  return stack;
}

}  // namespace

MediaStack media_at(const Snapshot& scene, const Vec3& p) {
  const Vec3 d = normalize(Vec3(0.0123f, 0.0071f, 1.0f));  // along no wall
  if (!scene.media.nest) return open_medium_at(scene, p, d);
  static const PerThread<std::vector<Hit>> kept;
  std::vector<Hit>& hits = kept.get();
  hits.clear();
  scene.raytracer->intersect_all(p, d, INFINITY, hits);
  MediaStack stack;
  std::vector<uint32_t> seen;
  bool open_seen = false;
  for (const Hit& hit : hits) {
    const uint32_t m = scene.media.of_instance[hit.instance];
    if (m == none) continue;
    const bool open = scene.media.by_rank[m].is_open();
    if (open ? open_seen : std::find(seen.begin(), seen.end(), m) != seen.end()) continue;
    open ? void(open_seen = true) : seen.push_back(m);
    if (!scene.media.leaves(hit.instance, d, scene.raytracer->surface_at(hit).ng)) continue;
    open ? stack.set_open(m) : stack.add(m);
  }
  return stack;
}

}  // namespace ups
