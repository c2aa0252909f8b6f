// Light vertices by place, for merging: a hashed grid of cells twice the largest radius, filled by counting sort.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/prefetch.h"
#include "base/stop.h"
#include "transport/light_vertex.h"

namespace ups {

class PhotonIndex {
 public:
  PhotonIndex() = default;
  // Holds the vertices whose `merge` gate is open. max_radius > 0 bounds every later query. Empty where `stop` is set on
  // the way.
  PhotonIndex(const LightPaths& paths, float max_radius, const StopSignal& stop = {}) : per_cell_(1 / (2 * max_radius)) {
    if (!fill(paths, stop) || !mark_neighbourhoods(max_radius, stop)) photons_.clear();
  }

  bool empty() const { return photons_.empty(); }
  // While it is built, at most.
  static size_t bytes(size_t photons) {
    const size_t buckets = std::bit_ceil(std::max<size_t>(photons, 16));
    return photons * (sizeof(uint32_t) + sizeof(Photon)) + 2 * buckets * sizeof(uint32_t);
  }

  // A query in three steps. Each asks for what the next one reads, so that memory answers while the caller does
  // something else.
  struct Query {
    Vec3 p;
    float radius = 0;
    // 8, but for rounding; after find_rows() the first photon of each and one past its last.
    uint32_t bucket[27], end[27];
    int count = 0;
    uint64_t candidates = 0;  // photons in them
    // What visit() looks at of these: each stride-th, from number `first` on.
    uint32_t stride = 1, first = 0;
  };
  void ask(const Vec3& p, float radius, Query& q) const {
    q.p = p, q.radius = radius, q.count = 0, q.candidates = 0, q.stride = 1, q.first = 0;
    if (!may_find(p)) return;
    const Cell lo = cell_of(p - Vec3(radius, radius, radius)), hi = cell_of(p + Vec3(radius, radius, radius));
    for (int64_t z = lo.z; z <= hi.z; ++z)
      for (int64_t y = lo.y; y <= hi.y; ++y) {
        const uint32_t row = row_of(y, z);
        for (int64_t x = lo.x; x <= hi.x; ++x) {
          const uint32_t b = bucket_of(row, x);
          // Two of the cells may share a bucket: its photons must not count twice.
          if (std::find(q.bucket, q.bucket + q.count, b) != q.bucket + q.count) continue;
          prefetch(begin_.data() + b);
          q.bucket[q.count++] = b;
        }
      }
  }
  void find_rows(Query& q) const {
    for (int k = 0; k < q.count; ++k) {
      q.end[k] = begin_[q.bucket[k] + 1];
      q.bucket[k] = begin_[q.bucket[k]];
      q.candidates += q.end[k] - q.bucket[k];
      prefetch(photons_.data() + q.bucket[k]);
    }
  }
  struct Photon {
    Vec3 p;
    uint32_t place;  // of LightPaths
  };
  // visit(photon, squared distance) for every one within the radius, each once.
  template <class Visit>
  void visit(const Query& q, const Visit& visit) const {
    const float r2 = q.radius * q.radius;
    uint64_t skip = q.first;
    for (int k = 0; k < q.count; ++k) {
      uint64_t i = q.bucket[k] + skip;
      for (; i < q.end[k]; i += q.stride) {
        const float d2 = length2(photons_[i].p - q.p);
        if (d2 < r2) visit(photons_[i], d2);
      }
      skip = i - q.end[k];
    }
  }
  template <class Visit>
  void query(const Vec3& p, float radius, const Visit& to) const {
    Query q;
    ask(p, radius, q);
    find_rows(q);
    visit(q, to);
  }

 private:
  struct Cell {
    int64_t x, y, z;
  };
  bool fill(const LightPaths& paths, const StopSignal& stop) {
    const size_t count = paths.merged, buckets = std::bit_ceil(std::max<size_t>(count, 16));
    mask_ = uint32_t(buckets - 1);
    begin_.assign(buckets + 1, 0);
    std::vector<uint32_t> bucket;
    bucket.reserve(count);
    for (const auto& block : paths.photons) {
      if (stop.is_set()) return false;
      for (const StoredPhoton& f : block) {
        const Cell c = cell_of(f.p);
        bucket.push_back(bucket_of(row_of(c.y, c.z), c.x));
        ++begin_[bucket.back() + 1];
      }
    }
    for (size_t b = 0; b < buckets; ++b) begin_[b + 1] += begin_[b];
    std::vector<uint32_t> next(begin_.begin(), begin_.end() - 1);
    photons_.resize(count);
    size_t at = 0;
    for (size_t b = 0; b < paths.photons.size(); ++b) {
      if (stop.is_set()) return false;
      for (const StoredPhoton& f : paths.photons[b]) photons_[next[bucket[at++]]++] = {f.p, paths.place(b, f.vertex)};
    }
    return true;
  }
  // Caustics are mostly elsewhere: a coarse grid of bits about all photons says so at once.
  static constexpr int side = 32;
  int coarse(float x, float low) const { return std::clamp(int((x - low) * to_coarse_), 0, side - 1); }
  bool mark_neighbourhoods(float radius, const StopSignal& stop) {
    if (photons_.empty()) return true;
    Vec3 high = low_ = photons_[0].p;
    for (const Photon& f : photons_) {
      low_ = {std::min(low_.x, f.p.x), std::min(low_.y, f.p.y), std::min(low_.z, f.p.z)};
      high = {std::max(high.x, f.p.x), std::max(high.y, f.p.y), std::max(high.z, f.p.z)};
    }
    radius = 1.001f * radius + 0x1p-21f * std::max(max_abs(low_), max_abs(high));  // rounding
    low_ = low_ - Vec3(radius, radius, radius);
    extent_ = max_abs(high - low_) + radius;
    to_coarse_ = 1 / std::max(extent_ * 1.001f / side, 2 * radius);  // so a photon marks few cells, crowded or not
    near_.assign(side * side, 0);
    return stop.for_each(photons_.size(), [&](size_t i) {
      const Photon& f = photons_[i];
      for (int z = coarse(f.p.z - radius, low_.z); z <= coarse(f.p.z + radius, low_.z); ++z)
        for (int y = coarse(f.p.y - radius, low_.y); y <= coarse(f.p.y + radius, low_.y); ++y)
          for (int x = coarse(f.p.x - radius, low_.x); x <= coarse(f.p.x + radius, low_.x); ++x)
            near_[z * side + y] |= 1u << x;
    });
  }
  bool may_find(const Vec3& p) const {
    if (photons_.empty()) return false;
    const Vec3 d = p - low_;
    if (!(d.x >= 0 && d.y >= 0 && d.z >= 0 && d.x <= extent_ && d.y <= extent_ && d.z <= extent_)) return false;
    return near_[coarse(p.z, low_.z) * side + coarse(p.y, low_.y)] >> coarse(p.x, low_.x) & 1;
  }

  // A query's box spans at most two cells an axis, or rounding makes it three: a cell is two radii wide.
  Cell cell_of(const Vec3& p) const {
    const auto floored = [](float x) {
      const auto towards_zero = int64_t(x);
      return towards_zero - (x < float(towards_zero));
    };
    return {floored(p.x * per_cell_), floored(p.y * per_cell_), floored(p.z * per_cell_)};
  }
  // Cells that follow one another along x are neighbours in memory, too.
  static uint32_t row_of(int64_t y, int64_t z) {
    uint64_t h = uint64_t(y) * 0xc2b2ae3d27d4eb4full ^ uint64_t(z) * 0x165667b19e3779f9ull;
    h ^= h >> 32;
    h *= 0xd6e8feb86659fd93ull;
    return uint32_t(h >> 32);
  }
  uint32_t bucket_of(uint32_t row, int64_t x) const { return (row + uint32_t(x)) & mask_; }

  float per_cell_ = 1;
  uint32_t mask_ = 0;
  std::vector<uint32_t> begin_;
  std::vector<Photon> photons_;
  Vec3 low_;
  float extent_ = 0, to_coarse_ = 0;
  std::vector<uint32_t> near_;  // rows of bits along x
};

}  // namespace ups
