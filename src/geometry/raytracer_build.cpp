// See raytracer_impl.h: which instances are baked, which of them share an index, and what of an earlier build stays.
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "base/monitor.h"
#include "geometry/grouping.h"
#include "geometry/raytracer_impl.h"
#include "platform/memory.h"

namespace ups {
namespace {

// Embree takes rays into an instance's frame in float. Where that would lose many digits the instance is baked: a
// transform that stretches one way more than another by max_stretch, or a translation beyond max_reach times the
// scene's extent; of a mesh that might as well be baked, less. Where the scale's cube or its inverse leaves a float's range
// rays would meet nothing: beyond max_scale either way.
constexpr double max_stretch = 4, max_reach = 4, max_reach_alone = 2, max_scale = 1e6;
// Baked triangles of one index without groups: as many as are built in some 45 ms by one thread. Where there are more, a
// mesh of so many may have an index of its own, so that the others need no groups.
constexpr size_t flat_triangles = 3 << 15, least_own_triangles = 1 << 12;

// Points of the surface, among them those that lie farthest along the axes that `to` leads to.
template <class Visit>
void each_extreme(const Mesh& mesh, const Affine& to, const Visit& visit) {
  if (!mesh.revolution) return mesh.each_used([&](const Vec3& p) { visit(Vec3d(p)); });
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d row(to.m[4 * axis], to.m[4 * axis + 1], to.m[4 * axis + 2]);
    visit(farthest(*mesh.revolution, row)), visit(farthest(*mesh.revolution, -row));
  }
}

// Largest over smallest stretch, at most: product of the Frobenius norms of the matrix and its inverse.
double stretch(const Affine& m) {
  double forward = 0, cofactor = 0;
  for (int c = 0; c < 3; ++c) {
    forward += length2(m.column(c));
    cofactor += length2(cross(m.column((c + 1) % 3), m.column((c + 2) % 3)));
  }
  const double det = std::abs(m.determinant());
  return det > 0 ? std::sqrt(forward * cofactor) / (3 * det) : std::numeric_limits<double>::infinity();
}

// The largest and the least stretch of any length, by Gershgorin's circles about the eigenvalues of M^T M: exact where a
// scale comes first and a rotation after it.
std::pair<double, double> stretches(const Affine& m) {
  double most = 0, least = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 3; ++c) {
    const double own = length2(m.column(c));
    double others = 0;
    for (int k = 0; k < 3; ++k) others += k == c ? 0 : std::abs(dot(m.column(c), m.column(k)));
    most = std::max(most, own + others), least = std::min(least, own - others);
  }
  return {std::sqrt(most), std::sqrt(std::max(least, 0.0))};
}

// Which instances Embree is given as triangles of the scene; the others keep the mesh's frame, so that who moves them
// builds nothing but the index above all. In a scene too large for one index the largest meshes of one instance do: as
// few as leave the others an index without groups, or if that cannot be those that would fill a group alone.
std::vector<bool> choose_baked(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                               const std::vector<Raytracer::Instance>& instances, const std::vector<Box>& boxes) {
  std::vector<size_t> uses(boxes.size());
  double extent = 0;
  for (const auto& i : instances) {
    ++uses[i.mesh];
    const Box box = boxes[i.mesh].transformed(i.to_scene);
    extent = std::max({extent, max_abs(box.lower), max_abs(box.upper)});
  }
  const auto is_exact = [&](const Raytracer::Instance& i, double reach) {
    const double scale = std::cbrt(std::abs(i.to_scene.determinant()));
    return stretch(i.to_scene) <= max_stretch && max_abs(i.to_scene.column(3)) <= reach * extent &&
           scale >= 1 / max_scale && scale <= max_scale;
  };
  const auto count = [&](size_t k) { return meshes[instances[k].mesh]->triangle_count(); };
  std::vector<bool> baked;
  size_t triangles = 0;
  for (size_t k = 0; k < instances.size(); ++k) {
    baked.push_back(uses[instances[k].mesh] == 1 || !is_exact(instances[k], max_reach));
    if (baked[k]) triangles += count(k);
  }
  if (triangles <= flat_triangles) return baked;
  std::vector<size_t> large;
  for (size_t k = 0; k < instances.size(); ++k)
    if (uses[instances[k].mesh] == 1 && count(k) >= least_own_triangles && !meshes[instances[k].mesh]->revolution &&
        is_exact(instances[k], max_reach_alone))
      large.push_back(k);
  std::stable_sort(large.begin(), large.end(), [&](size_t a, size_t b) { return count(a) > count(b); });
  size_t own = 0, left = triangles;
  while (own < large.size() && left > flat_triangles) left -= count(large[own++]);
  if (left > flat_triangles)
    while (own > 0 && count(large[own - 1]) <= group_triangles) --own;
  for (size_t i = 0; i < own; ++i) baked[large[i]] = false;
  return baked;
}

}  // namespace

Box bounding_box(const Mesh& mesh) {
  Box box;
  each_extreme(mesh, Affine{}, [&](const Vec3d& p) { box.grow(p); });
  return box;
}

size_t Mesh::bytes() const {
  return sizeof *this + positions.capacity() * sizeof(Vec3) + normals.capacity() * sizeof(Vec3) +
         uvs.capacity() * sizeof(Vec2) + tangents.capacity() * sizeof(float) + indices.capacity() * sizeof(uint32_t) +
         (revolution ? revolution->bands.capacity() * sizeof(RevolutionBand) : 0);
}

// Makes an Impl, with what an earlier one has.
class RaytracerBuild {
 public:
  using Impl = Raytracer::Impl;
  using Instance = Raytracer::Instance;
  using Traced = std::shared_ptr<const TracedMesh>;

  RaytracerBuild(Impl& out, const Impl* earlier, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                 const std::vector<Instance>& instances, ThreadPool& pool, Monitor* monitor)
      : out_(out), earlier_(earlier), meshes_(meshes), instances_(instances), pool_(pool), monitor_(monitor) {}

  void run() {
    const std::vector<Box> boxes = mesh_boxes();
    const std::vector<bool> baked = choose_baked(meshes_, instances_, boxes);
    const Grouping grouping = choose_groups(baked, boxes);
    before_ = out_.device->bytes();
    limit_memory();
    out_.top = std::make_unique<embree::Scene>(*out_.device, out_.finds_all);
    for (size_t i = 0; i < instances_.size(); ++i) {
      place(i, baked[i]);
      if (!baked[i]) attach_part(part_of({traced_of(i)}), uint32_t(i), out_.placed[i].to_scene);
      grow_bounds(out_.placed[i], boxes[instances_[i].mesh]);
      report();
    }
    for (const uint32_t i : grouping.ungrouped) attach(*out_.top, *traced_of(i), i);
    limit_memory();
    for (const auto& members : grouping.groups) {
      std::vector<Traced> meshes;
      for (const uint32_t i : members) meshes.push_back(traced_of(i));
      attach_part(part_of(meshes), uint32_t(instances_.size() + out_.members.size()), Affine{});
      out_.members.push_back(members);
      report();
    }
    limit_memory();
    out_.top->commit(pool_, monitor_, share(done_), 1);
  }

 private:
  const Mesh& mesh_of(size_t instance) const { return *meshes_[instances_[instance].mesh]; }
  const Traced& traced_of(size_t instance) const { return out_.traced[out_.placed[instance].traced]; }

  // Of the baked instances; counts all triangles and chooses the device.
  Grouping choose_groups(const std::vector<bool>& baked, const std::vector<Box>& boxes) {
    Grouping grouping;
    size_t baked_triangles = 0, instanced_triangles = 0;
    std::vector<bool> counted(meshes_.size());
    for (size_t i = 0; i < instances_.size(); ++i) {
      const size_t count = mesh_of(i).triangle_count();
      out_.triangles += count;
      if (baked[i])
        baked_triangles += count, grouping.ungrouped.push_back(uint32_t(i));
      else if (!counted[instances_[i].mesh])
        instanced_triangles += count, counted[instances_[i].mesh] = true;
    }
    // A small scene's index is built whole; Embree, where its memory runs out, has least to leave behind in a device of
    // its own.
    shares_parts_ = earlier_ && !earlier_->device->is_spoiled() &&
                    baked_triangles + instanced_triangles > flat_triangles;
    out_.device = shares_parts_ ? earlier_->device : std::make_shared<embree::Device>();
    if (baked_triangles <= flat_triangles) return grouping;
    std::vector<Thing> things;
    for (const uint32_t i : grouping.ungrouped)
      things.push_back({boxes[instances_[i].mesh].transformed(instances_[i].to_scene), mesh_of(i).triangle_count(),
                        instances_[i].number});
    Grouping grouped = group_by_place(things);
    const auto name = [&](std::vector<uint32_t>& members) {
      for (uint32_t& member : members) member = grouping.ungrouped[member];
    };
    name(grouped.ungrouped);
    for (auto& members : grouped.groups) name(members);
    return grouped;
  }

  // Only of meshes that an instance shows.
  std::vector<Box> mesh_boxes() {
    std::vector<Box> boxes(meshes_.size());
    for (const Instance& i : instances_) {
      Box& box = boxes[i.mesh];
      if (!box.empty()) continue;
      const Mesh* mesh = meshes_[i.mesh].get();
      const auto known = earlier_ ? earlier_->boxes.find(mesh) : std::map<const Mesh*, Box>::const_iterator();
      box = earlier_ && known != earlier_->boxes.end() ? known->second : bounding_box(*mesh);
      out_.boxes[mesh] = box;
    }
    return boxes;
  }

  void place(size_t i, bool baked) {
    const Affine& to_scene = instances_[i].to_scene;
    const double side = to_scene.determinant() < 0 ? -1 : 1;
    const auto [most, least] = baked ? std::pair(1.0, 1.0) : stretches(to_scene);
    Impl::Placed placed{0, instances_[i].material, baked, to_scene, side, NormalMatrix(to_scene), most, least, 0, 1};
    if (!baked) {
      // Embree takes rays to the object's frame in float: it loses digits of the translation, and more where stretched.
      placed.error_scale = float(2 * std::max(1.0, stretch(to_scene)));
      placed.error_offset = placed.error_scale * float(max_abs(to_scene.column(3)));
    }
    const uint32_t material = instances_[i].material;
    const bool has_holes = material < out_.texturing.size() && out_.texturing[material].may_have_holes();
    const Impl::Key key{meshes_[instances_[i].mesh].get(), has_holes, baked, to_scene};
    Traced& traced = out_.made_of[key];
    if (!traced) {
      if (earlier_)
        if (const auto known = earlier_->made_of.find(key); known != earlier_->made_of.end()) traced = known->second;
      if (!traced)
        traced = make_traced_mesh(meshes_[instances_[i].mesh], has_holes, baked ? &to_scene : nullptr, pool_);
      out_.traced.push_back(traced);
      index_[traced.get()] = uint32_t(out_.traced.size() - 1);
      if (has_holes) out_.holes[traced.get()] = out_.texturing[material];
    }
    placed.traced = index_[traced.get()];
    out_.placed.push_back(placed);
  }

  void attach(embree::Scene& scene, const TracedMesh& mesh, uint32_t id) {
    if (RTCGeometry geometry = make_geometry(*out_.device, mesh)) scene.attach(geometry, id);
  }

  // What has these meshes, in this order.
  std::shared_ptr<const Impl::Part> part_of(const std::vector<Traced>& meshes) {
    std::shared_ptr<const Impl::Part>& part = out_.part_of[meshes];
    if (part) return part;
    if (shares_parts_ && earlier_->finds_all == out_.finds_all)
      if (const auto known = earlier_->part_of.find(meshes); known != earlier_->part_of.end()) part = known->second;
    if (!part) {
      auto made = std::make_shared<Impl::Part>(out_.device, out_.finds_all);
      made->meshes = meshes;
      for (size_t k = 0; k < meshes.size(); ++k) attach(made->scene, *meshes[k], uint32_t(k));
      size_t triangles = 0;
      for (const Traced& mesh : meshes) triangles += mesh->source->triangle_count();
      if (triangles > group_triangles) limit_memory();
      made->scene.commit(pool_, monitor_, share(done_), share(done_ + triangles));
      part = std::move(made);
    }
    out_.parts.push_back(part);
    for (const Traced& mesh : meshes) done_ += mesh->source->triangle_count();
    return part;
  }

  void attach_part(const std::shared_ptr<const Impl::Part>& part, uint32_t id, const Affine& to_scene) {
    float columns[12];
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r) columns[3 * c + r] = float(to_scene.m[4 * r + c]);
    RTCGeometry handle = rtcNewGeometry(*out_.device, RTC_GEOMETRY_TYPE_INSTANCE);
    out_.device->check();
    rtcSetGeometryInstancedScene(handle, part->scene);
    rtcSetGeometryTransform(handle, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    out_.top->attach(handle, id);
  }

  void grow_bounds(const Impl::Placed& instance, const Box& mesh_box) {
    if (out_.bounds.holds(mesh_box.transformed(instance.to_scene))) return;
    each_extreme(*out_.traced[instance.traced]->source, instance.to_scene,
                 [&](const Vec3d& p) { out_.bounds.grow(Vec3d(Vec3(instance.to_scene.point(p)))); });
  }

  // Of what Embree takes, which is most of what a build does, besides meshes' copies: as these are made the system has
  // less, and is asked again.
  void limit_memory() const {
    if (!monitor_) return out_.device->allow(UINT64_MAX, "");
    const platform::AvailableMemory system = platform::available_memory();
    const uint64_t now = out_.device->bytes(), taken = now - std::min<uint64_t>(before_, now),
                   limit = monitor_->memory_limit(), left = limit - std::min(limit, taken);
    const auto text = [](const std::string& whose, uint64_t bytes) {
      return whose + " (" + MemoryBudget::in_bytes(double(bytes)) + ")";
    };
    if (limit > 0 && left < system.bytes)
      out_.device->allow(left, text("memory_limit_bytes", limit));
    else
      out_.device->allow(system.bytes, text(system.limit, system.bytes));
  }
  float share(size_t triangles) const {
    return std::min(1.0f, float(triangles) / float(std::max<size_t>(1, out_.triangles)));
  }
  void report() const {
    if (!monitor_) return;
    monitor_->check();
    monitor_->report(share(done_));
  }

  Impl& out_;
  const Impl* earlier_;
  const std::vector<std::shared_ptr<const Mesh>>& meshes_;
  const std::vector<Instance>& instances_;
  ThreadPool& pool_;
  Monitor* monitor_;
  bool shares_parts_ = false;  // with `earlier_`
  size_t done_ = 0;            // triangles of parts
  size_t before_ = 0;          // bytes of the device, of earlier builds
  std::map<const TracedMesh*, uint32_t> index_;
};

Raytracer::Raytracer(const std::vector<std::shared_ptr<const Mesh>>& meshes, const std::vector<Instance>& instances,
                     const std::vector<SurfaceTexturing>& texturing, ThreadPool& pool, bool finds_all,
                     const Raytracer* earlier, Monitor* monitor)
    : impl_(std::make_unique<Impl>()) {
  impl_->finds_all = finds_all;
  impl_->texturing = texturing;
  RaytracerBuild(*impl_, earlier ? earlier->impl_.get() : nullptr, meshes, instances, pool, monitor).run();
}

size_t Raytracer::shared_parts(const Raytracer& earlier) const {
  size_t count = 0;
  for (const auto& mesh : impl_->traced)
    count += std::find(earlier.impl_->traced.begin(), earlier.impl_->traced.end(), mesh) != earlier.impl_->traced.end();
  return count;
}

}  // namespace ups
