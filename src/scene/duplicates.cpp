// See duplicates.h. Triangles are compared by a 64-bit key of their corners, as floats of the scene; a chance agreement
// of two keys among n triangles has probability n^2 / 2^65.
#include "scene/duplicates.h"

#include <algorithm>
#include <bit>

#include "base/floating_point.h"
#include "base/rng.h"

namespace ups {
namespace {

constexpr size_t max_triangles = 20'000'000;  // a table of 320 MB; larger scenes go unchecked

uint64_t corner_key(const Vec3& p) {
  const auto bits = [](float v) { return uint64_t(std::bit_cast<uint32_t>(v + 0.0f)); };  // -0 as 0
  return hash_combine(bits(p.x) << 32 | bits(p.y), bits(p.z));
}

}  // namespace

Duplicates find_duplicates(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                           const std::vector<Raytracer::Instance>& instances, const Media& media) {
  size_t total = 0;
  for (const auto& i : instances) total += meshes[i.mesh]->triangle_count();
  if (total > max_triangles) return {};
  struct Entry {
    uint64_t key;
    Duplicates::Triangle triangle;
  };
  std::vector<Entry> entries;
  entries.reserve(total);
  std::vector<uint64_t> corners;
  for (size_t i = 0; i < instances.size(); ++i) {
    const Mesh& mesh = *meshes[instances[i].mesh];
    corners.clear();
    {
      const TrapsMasked masked;  // vertices that no triangle has may lie anywhere
      for (const Vec3& p : mesh.positions) corners.push_back(corner_key(Vec3(instances[i].to_scene.point(Vec3d(p)))));
    }
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
      const uint32_t* v = &mesh.indices[3 * size_t(t)];
      if (corners[v[0]] == corners[v[1]] || corners[v[1]] == corners[v[2]] || corners[v[2]] == corners[v[0]])
        continue;  // no area: nothing hits it
      entries.push_back({corners[v[0]] + corners[v[1]] + corners[v[2]], {uint32_t(i), t}});
    }
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
  const auto is_solid = [&](uint32_t instance) {
    const uint32_t medium = media.of_instance[instance];
    return medium != none && !media.by_rank[medium].is_open();
  };
  const auto shared = [&](uint32_t a, uint32_t b) { return a != b && is_solid(a) && is_solid(b); };
  Duplicates found;
  for (size_t i = 1; i < entries.size(); ++i)
    if (entries[i].key == entries[i - 1].key &&
        !shared(entries[i].triangle.instance, entries[i - 1].triangle.instance) && found.count++ == 0)
      found.first = entries[i - 1].triangle, found.second = entries[i].triangle;
  return found;
}

}  // namespace ups
