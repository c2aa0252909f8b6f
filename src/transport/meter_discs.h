// Point meters as discs on which photons are merged, fixed for the whole render: rings out to a largest radius, of which
// a reading takes as many as serve it best once the photons came (render/meter_rings.h), and the part of them that the
// meter sees in its own plane. The weights know the whole disc alone: they may be any partition of unity.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/snapshot.h"

namespace ups {

inline constexpr uint32_t max_rings = 24;  // each to a radius sqrt(2) times that of the one before: 4096 : 1 in all

// Of one meter, from the innermost ring on.
struct Rings {
  uint32_t count = 0;
  uint32_t narrowest = 0;  // the outermost of the narrowest disc that coordinates resolve
  double area[max_rings] = {};     // m2, what is seen
  double radius2[max_rings] = {};  // m2, mean over the ring
  // What the bias is proportional to where light changes evenly: r^2, of half discs r, as means over the ring.
  double bias_scale[max_rings] = {};
};

class MeterDiscs {
 public:
  MeterDiscs() = default;  // of cells
  // Everything is seen out to the radius. rays: an even number for look_around().
  MeterDiscs(size_t meters, uint32_t rings, float radius, uint32_t rays = 0);
  // Of meters whose discs stand across the light, so that they fill a ball; rays: for look_all_around().
  static MeterDiscs across(size_t meters, uint32_t rings, float radius, uint32_t rays);
  // Many rows of sums (a meter, or a column of one, each) take fewer rings.
  static uint32_t rings_for(size_t rows) { return rows <= 100000 ? max_rings : rows <= 1000000 ? max_rings / 2 : 8; }

  // A light path must not reach a meter through a wall: rays in its plane find how far it sees. A direction counts as
  // far as the opposite one does, as half a disc is biased by the light's slope. Of different meters at the same time.
  void look_around(const Snapshot& scene, const Meter& meter, uint32_t m, float largest);
  // The same of a ball: it ends before the first surface that it would meet, but for one right beneath the meter, which
  // hides half of it from all light alike.
  void look_all_around(const Snapshot& scene, const Meter& meter, uint32_t m, float largest);

  bool empty() const { return radius_.empty(); }
  size_t bytes() const {
    return radius_.size() * (sizeof(float) + sizeof(double)) + limits_.size() + height_.size() * sizeof(float);
  }
  uint32_t ring_count() const { return rings_; }
  float radius(uint32_t m) const { return radius_[m]; }
  double area(uint32_t m) const { return area_[m]; }
  Rings rings(uint32_t m, float min_radius) const;
  // Of how many meters, at most, discs may find the photons of one, itself among them; of many meters by some. sides: of
  // each meter, which are at one place, all meters' first sides before the second ones.
  uint32_t most_that_meet(const std::vector<Meter>& meters, uint32_t sides = 1) const;
  // The eighth of a turn in which a point lies, by signs and by the larger of x and y.
  static uint8_t octant_of(float x, float y) {
    return uint8_t((std::abs(y) > std::abs(x)) | (x < 0) << 1 | (y < 0) << 2);
  }
  // Of a point of the plane at x, y from the meter, along its frame's s and t.
  uint32_t ring_at(uint32_t m, float x, float y) const {
    const uint32_t ring = ring_of(x * x + y * y, radius_[m] * radius_[m]);
    return ring < rings_ && (limits_.empty() || ring < limit(m, x, y)) ? ring : none;
  }

  // Of the point at `offset` from the meter, on the disc across the direction; normal: the meter's. share: of that
  // ring's circle there, what the surface beneath the meter leaves.
  uint32_t ring_across(uint32_t m, const Vec3& normal, const Vec3& direction, const Vec3& offset, float& share) const {
    const float d2 = length2(offset), height = height_[m];
    const uint32_t ring = ring_of(d2, radius_[m] * radius_[m]);
    if (ring >= rings_ || dot(offset, normal) < -height) return none;
    const float lowest = std::sqrt(d2) * length(cross(normal, direction));  // of the circle, below the meter
    if (lowest > height) share = 0.5f + inv_pi * std::asin(height / lowest);
    return ring;
  }

 private:
  uint32_t ring_of(float d2, float radius2) const {
    return uint32_t(std::max(int(rings_) + std::ilogb(std::max(d2 / radius2, 0x1p-100f)), 0));
  }
  uint32_t limit(uint32_t m, float x, float y) const {
    const float turn = std::atan2(y, x) / pi;  // opposite directions are alike
    const uint32_t sector = uint32_t((turn < 0 ? turn + 1 : turn) * float(sectors_));
    return limits_[size_t(m) * sectors_ + std::min(sector, sectors_ - 1)];
  }

  uint32_t rings_ = 0, sectors_ = 0;  // sectors of half a turn
  std::vector<float> radius_;
  std::vector<double> area_;  // what is seen
  std::vector<uint8_t> limits_;  // rings seen, a meter by a sector, sector fastest; empty: all
  uint32_t rays_ = 0;            // of a ball
  std::vector<float> height_;    // of a ball's meter over the surface beneath it; infinite: there is none near
};

// Median distance of a meter of the set to its nearest neighbour; infinite where there is none, 0 for cells, where
// photons are counted, not merged.
float meter_spacing(const MeterSet& set);

}  // namespace ups
