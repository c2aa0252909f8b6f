// Do solids overlap in part? Points of each one's surface are looked up in the other. What is closer to the other's
// surface than a thousandth of its size is neither inside nor outside, so that faces may touch; a few points of many
// do not count, so that rims may.
#include <cmath>

#include "base/parallel.h"
#include "base/rng.h"
#include "geometry/box.h"
#include "scene/media.h"
#include "scene/snapshot.h"

namespace ups {
namespace {

constexpr double boundary_share = 1e-3;  // of the smaller solid's size
constexpr uint32_t most_points = 128, least_points = 32;
constexpr size_t most_in_all = 1 << 17;
constexpr double least_share = 0.04;     // of the points: fewer are a rim

struct SurfacePoints {
  Box box;
  std::vector<Vec3> p, n;
};

class Overlaps {
 public:
  Overlaps(const Snapshot& scene, const std::vector<Raytracer::Instance>& instances)
      : scene_(scene), instances_(instances), points_(scene.media.by_rank.size()) {}

  struct Pair {
    uint32_t a, b;  // media
  };
  std::vector<Pair> candidates() {
    const std::vector<Medium>& media = scene_.media.by_rank;
    std::vector<uint32_t> solids;
    for (uint32_t m = 0; m < media.size(); ++m)
      if (media[m].meets_others) {
        points_[m].box = bounding_box(mesh_of(m)).transformed(to_scene(m));
        solids.push_back(m);
      }
    std::sort(solids.begin(), solids.end(),
              [&](uint32_t a, uint32_t b) { return points_[a].box.lower.x < points_[b].box.lower.x; });
    std::vector<Pair> pairs;
    for (size_t i = 0; i < solids.size(); ++i)
      for (size_t j = i + 1; j < solids.size(); ++j) {
        const uint32_t a = solids[i], b = solids[j];
        if (points_[b].box.lower.x > points_[a].box.upper.x) break;
        if (media[a].priority != media[b].priority || index(a) == index(b) || !meet(a, b)) continue;
        pairs.push_back({a, b});
      }
    return pairs;
  }

  void sample_surfaces(const std::vector<Pair>& pairs) {
    const auto count = uint32_t(std::clamp<size_t>(most_in_all / (pairs.size() + 1), least_points, most_points));
    for (const Pair& pair : pairs)
      for (const uint32_t m : {pair.a, pair.b})
        if (points_[m].p.empty()) sample_surface(m, count);
  }

  bool overlap_in_part(const Pair& pair) const {
    const float reach = float(boundary_share * std::min(size(pair.a), size(pair.b)));
    return lies_in_part(pair.a, pair.b, reach) || lies_in_part(pair.b, pair.a, reach);
  }

 private:
  const Raytracer::Instance& instance(uint32_t m) const { return instances_[scene_.media.by_rank[m].instance]; }
  const Affine& to_scene(uint32_t m) const { return instance(m).to_scene; }
  const Mesh& mesh_of(uint32_t m) const { return *scene_.meshes[instance(m).mesh]; }
  float index(uint32_t m) const { return scene_.materials[scene_.media.by_rank[m].material].ior; }
  double size(uint32_t m) const { return length(points_[m].box.upper - points_[m].box.lower); }
  bool meet(uint32_t i, uint32_t j) const {
    const Box &a = points_[i].box, &b = points_[j].box;
    return a.lower.y < b.upper.y && b.lower.y < a.upper.y && a.lower.z < b.upper.z && b.lower.z < a.upper.z;
  }

  // Spread evenly over the area, the same each time.
  void sample_surface(uint32_t m, uint32_t count) {
    const Mesh& mesh = mesh_of(m);
    std::vector<double> sums(1, 0.0);
    const auto corner = [&](size_t t, size_t k) {
      return to_scene(m).point(Vec3d(mesh.positions[mesh.indices[3 * t + k]]));
    };
    for (size_t t = 0; t < mesh.triangle_count(); ++t)
      sums.push_back(sums.back() + length(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0))));
    for (uint32_t i = 0; i < count; ++i) {
      const auto u = philox({i, 0, 0, 0}, {0, 0});
      const double target = sums.back() * (i + double(to_unit_float(u[0]))) / count;
      const size_t above = size_t(std::upper_bound(sums.begin(), sums.end(), target) - sums.begin());
      const size_t t = std::min(above, mesh.triangle_count()) - 1;
      double v = double(to_unit_float(u[1])), w = double(to_unit_float(u[2]));
      if (v + w > 1) v = 1 - v, w = 1 - w;
      const SurfacePoint s =
          scene_.raytracer->surface_at(scene_.media.by_rank[m].instance, uint32_t(t), float(v), float(w));
      points_[m].p.push_back(s.p);
      points_[m].n.push_back(s.ng);
    }
  }

  bool is_inside(uint32_t solid, const Vec3& p, const Vec3& d, std::vector<Hit>& hits) const {
    const Box& box = points_[solid].box;
    if (!(p.x > box.lower.x && p.y > box.lower.y && p.z > box.lower.z && p.x < box.upper.x && p.y < box.upper.y &&
          p.z < box.upper.z))
      return false;
    hits.clear();
    scene_.raytracer->intersect_all(p, d, float(2 * size(solid)), hits);
    for (const Hit& hit : hits)
      if (scene_.media.of_instance[hit.instance] == solid)
        return scene_.media.leaves(hit.instance, d, scene_.raytracer->surface_at(hit).ng);
    return false;
  }

  // Some of m's surface is inside the other, and some outside.
  bool lies_in_part(uint32_t m, uint32_t other, float reach) const {
    std::vector<Hit> hits;
    size_t inside = 0, outside = 0;
    const Vec3 d = normalize(Vec3(0.0123f, 0.0071f, 1.0f));
    for (size_t i = 0; i < points_[m].p.size(); ++i) {
      const bool above = is_inside(other, points_[m].p[i] + points_[m].n[i] * reach, d, hits);
      const bool below = is_inside(other, points_[m].p[i] - points_[m].n[i] * reach, d, hits);
      inside += above && below, outside += !above && !below;
    }
    const double needed = least_share * double(points_[m].p.size());
    return double(inside) >= needed && double(outside) >= needed;
  }

  const Snapshot& scene_;
  const std::vector<Raytracer::Instance>& instances_;
  std::vector<SurfacePoints> points_;  // by medium
};

}  // namespace

std::vector<PartialOverlap> find_partial_overlaps(const Snapshot& scene,
                                                  const std::vector<Raytracer::Instance>& instances,
                                                  ThreadPool& pool) {
  Overlaps overlaps(scene, instances);
  const std::vector<Overlaps::Pair> pairs = overlaps.candidates();
  overlaps.sample_surfaces(pairs);
  std::vector<char> found(pairs.size());
  parallel_for(pool, pairs.size(), [&](size_t i) { found[i] = overlaps.overlap_in_part(pairs[i]); });
  std::vector<PartialOverlap> out;
  for (size_t i = 0; i < pairs.size(); ++i)
    if (found[i]) {
      const std::vector<Medium>& media = scene.media.by_rank;
      const auto [a, b] = std::minmax(media[pairs[i].a].instance, media[pairs[i].b].instance);
      out.push_back({a, b});
    }
  std::sort(out.begin(), out.end(), [](const PartialOverlap& a, const PartialOverlap& b) {
    return std::make_pair(a.instance_a, a.instance_b) < std::make_pair(b.instance_a, b.instance_b);
  });
  return out;
}

}  // namespace ups
