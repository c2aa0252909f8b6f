// Which solid dielectrics does a point lie in, and which of them counts? Where solids overlap it is the one of higher
// priority, at equal priority that of smaller volume (Schmidt, Budge 2002, who take the one entered last): a property
// of the solids, so that both walks of a path agree. Made at commit; read by the walks (transport/encounter.h).
//
// A solid is an instance whose mesh encloses a volume; one that is inside out as a whole is taken as if it were turned.
// The other surfaces of glass are open, such as a water surface without a body: of them the last that was entered
// counts, told by its material, and who leaves one is outside of all.
#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "base/vec.h"
#include "bsdf/material.h"
#include "geometry/raytracer.h"

namespace ups {

inline constexpr uint32_t none = 0xffffffffu;

struct Snapshot;

// A solid, or all open surfaces of one material.
struct Medium {
  uint32_t material;
  int32_t priority;
  double volume;              // m^3; infinite: open
  uint32_t instance;          // of a solid
  bool meets_others = false;  // its box meets that of another solid: their faces may coincide
  bool is_open() const { return volume == INFINITY; }
};

struct Media {
  std::vector<Medium> by_rank;        // the strongest first
  std::vector<uint32_t> of_instance;  // index into by_rank; none: not of glass
  // Solids may overlap, or have the index of air. Else every surface of glass is treated as an open one, which comes to
  // the same and costs less: its index counts against 1, whatever lies around it.
  bool nest = false;
  // By instance: closed, but its front is inwards, so that the glass lies before its faces. Empty: none is.
  std::vector<bool> inside_out;

  bool is_inside_out(uint32_t instance) const { return !inside_out.empty() && inside_out[instance]; }
  // Does a ray along d come out of the glass where it meets a face of this instance?
  bool leaves(uint32_t instance, const Vec3& d, const Vec3& ng) const {
    return (dot(d, ng) > 0) != is_inside_out(instance);
  }
};

// The media that a point lies in. Fixed size: of more than `capacity` solids about one point the weakest are forgotten.
class MediaStack {
 public:
  static constexpr int capacity = 7;
  MediaStack() { std::fill_n(solids_, capacity, none); }

  // The one that counts; none: air.
  uint32_t top() const { return std::min(solids_[0], open_); }
  uint32_t open() const { return open_; }
  void set_open(uint32_t medium) { open_ = medium; }
  void add(uint32_t solid) {
    for (uint32_t& s : solids_) {
      if (s == solid) return;
      if (solid < s) std::swap(s, solid);
    }
  }
  void remove(uint32_t solid) {
    const auto at = std::find(solids_, solids_ + capacity, solid);
    if (at == solids_ + capacity || solid == none) return;
    std::copy(at + 1, solids_ + capacity, at);
    solids_[capacity - 1] = none;
  }
  bool operator==(const MediaStack&) const = default;

 private:
  uint32_t open_ = none;
  uint32_t solids_[capacity];  // ascending, so the strongest first; none: no more
};

Media rank_media(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                 const std::vector<Raytracer::Instance>& instances, const std::vector<Material>& materials,
                 const std::vector<SurfaceTexturing>& texturing);

// Around a point off any surface: a solid's first surface in some direction tells by its side, and so does the first
// open one.
MediaStack media_at(const Snapshot& scene, const Vec3& p);

// Two solids of equal priority and different index of which neither lies in the other, though some of both is shared.
struct PartialOverlap {
  uint32_t instance_a, instance_b;
};
std::vector<PartialOverlap> find_partial_overlaps(const Snapshot& scene,
                                                  const std::vector<Raytracer::Instance>& instances, ThreadPool& pool);

}  // namespace ups
