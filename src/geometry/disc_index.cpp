// Which discs does a segment cross? Asked by light walks for meters, and by both walks for luminous openings.
//
// A tree of boxes, four to a node, finds candidates; whether a disc is crossed is decided in double, so that few discs
// and many give the same answer. Not Embree's: this is built anew whenever the meters' radii change, and all that can
// fail here is an allocation of its own.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/floating_point.h"
#include "base/lanes.h"
#include "geometry/raytracer.h"

namespace ups {
namespace {

using Disc = DiscIndex::Disc;
using Crossing = DiscIndex::Crossing;

constexpr size_t leaf_count = 4;  // discs of a leaf, at most: what is more can be quartered

bool is_ball(const Disc& disc) { return disc.normal.x == 0 && disc.normal.y == 0 && disc.normal.z == 0; }

// A ball is reported from where it is entered, or from the start inside.
bool cross_ball(const Disc& ball, const Vec3d& o, const Vec3d& d, float tmax, float& t_out) {
  const Vec3d to_center = Vec3d(ball.center) - o;
  const double middle = dot(to_center, d), radius = ball.radius;
  const double half2 = radius * radius - length2(to_center - d * middle);
  if (!(half2 >= 0)) return false;
  const double half = std::sqrt(half2);
  if (!(middle + half >= 0 && middle - half <= tmax)) return false;
  t_out = float(std::max(0.0, middle - half));
  return true;
}

bool cross(const Disc& disc, const Vec3d& o, const Vec3d& d, float tmax, float& t_out) {
  const Vec3d n(disc.normal), c(disc.center);
  const double divisor = dot(d, n);
  if (divisor == 0) return is_ball(disc) && cross_ball(disc, o, d, tmax, t_out);
  const double t = dot(c - o, n) / divisor;
  if (!(t >= 0 && t <= tmax)) return false;
  if (length2(o + d * t - c) > double(disc.radius) * disc.radius) return false;
  t_out = float(t);
  return true;
}

struct Bounds {
  float lower[3], upper[3];
  void add(const Bounds& b) {
    for (int a = 0; a < 3; ++a)
      lower[a] = std::min(lower[a], b.lower[a]), upper[a] = std::max(upper[a], b.upper[a]);
  }
};

Bounds bounds_of(const Disc& disc) {
  const float pad = 0x1p-21f * (max_abs(disc.center) + disc.radius);
  const auto half = [&](float n) { return disc.radius * std::sqrt(std::max(0.0f, 1 - n * n)) + pad; };
  const Vec3 h = disc.reach.x < 0 ? Vec3(half(disc.normal.x), half(disc.normal.y), half(disc.normal.z))
                                  : disc.reach + Vec3(pad, pad, pad);
  const Vec3 lower = disc.center - h, upper = disc.center + h;
  return {{lower.x, lower.y, lower.z}, {upper.x, upper.y, upper.z}};
}

// Boxes of four children, side by side to be tested at once. A child with discs is a leaf: they begin at
// `first`; else `first` is a node.
struct Node {
  Float4 lower[3], upper[3];
  uint32_t first[lane_count], discs[lane_count];
};

// A segment as the boxes are tested with: what is rounded makes them larger.
class Segment {
 public:
  Segment(const Vec3& o, const Vec3& d, float tmax) : tmax_(tmax) {
    for (int a = 0; a < 3; ++a) o_[a] = o[a], inverse_[a] = 1 / d[a];
  }
  // A bit a child. Comparisons with what is not a number, from 0 times infinity in the plane of a box's side, leave out
  // that axis.
  uint32_t meets(const Node& node) const {
    Float4 near = all_lanes<Float4>(0), far = all_lanes<Float4>(tmax_);
    for (int a = 0; a < 3; ++a) {
      const bool down = inverse_[a] < 0;
      const Float4 begin = ((down ? node.upper : node.lower)[a] - o_[a]) * (inverse_[a] * (1 - rounding)),
                   end = ((down ? node.lower : node.upper)[a] - o_[a]) * (inverse_[a] * (1 + rounding));
      near = larger(begin, near);
      far = smaller(end, far);
    }
    return bits_of(near <= far);
  }

 private:
  static constexpr float rounding = 4 * std::numeric_limits<float>::epsilon();  // of a difference and two products
  float o_[3], inverse_[3], tmax_;
};

struct Item {
  Bounds bounds;
  uint32_t disc;
  float middle(int axis) const { return bounds.lower[axis] + bounds.upper[axis]; }  // twice
};

class Builder {
 public:
  Builder(std::vector<Item>& items, std::vector<Node>& nodes, const StopSignal& stop)
      : items_(items), nodes_(nodes), stop_(stop) {}

  // Of items [begin, end), more than a leaf's. Returns the node's number. What is built after a stop is of no use.
  uint32_t build(size_t begin, size_t end) {
    const uint32_t number = uint32_t(nodes_.size());
    nodes_.emplace_back();
    if (end - begin > items_between_looks && stop_.is_set()) return number;
    const size_t middle = split(begin, end), cuts[] = {begin, split(begin, middle), middle, split(middle, end), end};
    for (int i = 0; i < lane_count; ++i) {
      const size_t count = cuts[i + 1] - cuts[i];
      Bounds box = items_[cuts[i]].bounds;
      for (size_t k = cuts[i] + 1; k < cuts[i + 1]; ++k) box.add(items_[k].bounds);
      const bool leaf = count <= leaf_count;
      const uint32_t first = leaf ? uint32_t(cuts[i]) : build(cuts[i], cuts[i + 1]);
      Node& node = nodes_[number];
      for (int a = 0; a < 3; ++a) node.lower[a][i] = box.lower[a], node.upper[a][i] = box.upper[a];
      node.first[i] = first, node.discs[i] = leaf ? uint32_t(count) : 0;
    }
    return number;
  }

 private:
  // At the median along the longest side of the middles' box: neither half of two or more is empty.
  size_t split(size_t begin, size_t end) {
    int axis = 0;
    float longest = -1;
    for (int a = 0; a < 3; ++a) {
      float low = HUGE_VALF, high = -HUGE_VALF;
      for (size_t k = begin; k < end; ++k)
        low = std::min(low, items_[k].middle(a)), high = std::max(high, items_[k].middle(a));
      if (high - low > longest) longest = high - low, axis = a;
    }
    const size_t middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + ptrdiff_t(begin), items_.begin() + ptrdiff_t(middle),
                     items_.begin() + ptrdiff_t(end),
                     [axis](const Item& a, const Item& b) { return a.middle(axis) < b.middle(axis); });
    return middle;
  }

  static constexpr size_t items_between_looks = 4096;
  std::vector<Item>& items_;
  std::vector<Node>& nodes_;
  const StopSignal& stop_;
};

}  // namespace

struct DiscIndex::Impl {
  std::vector<Disc> discs;
  std::vector<Node> nodes;      // none for the discs of a leaf
  std::vector<uint32_t> order;  // of the discs, as leaves have them
};

DiscIndex::DiscIndex(std::vector<Disc> discs, const StopSignal& stop) : impl_(std::make_unique<Impl>()) {
  impl_->discs = std::move(discs);
  const size_t count = impl_->discs.size();
  if (count <= leaf_count) return;
  std::vector<Item> items(count);
  for (size_t i = 0; i < count; ++i) items[i] = {bounds_of(impl_->discs[i]), uint32_t(i)};
  Builder(items, impl_->nodes, stop).build(0, count);
  if (stop.is_set()) {
    *impl_ = {};
    return;
  }
  impl_->nodes.shrink_to_fit();
  impl_->order.reserve(count);
  for (const Item& item : items) impl_->order.push_back(item.disc);
}

DiscIndex::~DiscIndex() = default;

size_t DiscIndex::bytes() const {
  return impl_->discs.capacity() * sizeof(Disc) + impl_->nodes.capacity() * sizeof(Node) +
         impl_->order.capacity() * sizeof(uint32_t);
}

bool DiscIndex::empty() const { return impl_->discs.empty(); }

bool DiscIndex::holds(const std::vector<Disc>& discs) const {
  static_assert(sizeof(Disc) == 10 * sizeof(float));  // no padding to compare
  return discs.size() == impl_->discs.size() &&
         std::memcmp(discs.data(), impl_->discs.data(), discs.size() * sizeof(Disc)) == 0;
}

const DiscIndex::Disc& DiscIndex::disc(uint32_t i) const { return impl_->discs[i]; }

void DiscIndex::intersect_all(const Vec3& o, const Vec3& d, float tmax, std::vector<Crossing>& out) const {
  const Vec3d origin(o), direction(d);
  const auto try_disc = [&](uint32_t i) {
    float t;
    if (cross(impl_->discs[i], origin, direction, tmax, t)) out.push_back({i, t});
  };
  if (impl_->nodes.empty()) {
    for (size_t i = 0; i < impl_->discs.size(); ++i) try_disc(uint32_t(i));
    return;
  }
  const size_t begin = out.size();
  const TrapsMasked masked;
  const Segment segment(o, d, tmax);
  uint32_t waiting[lane_count * 16] = {0};  // a level has a quarter of what the one above has, of 2^32 discs at most
  for (int left = 1; left > 0;) {
    const Node& node = impl_->nodes[waiting[--left]];
    for (uint32_t met = segment.meets(node); met; met &= met - 1) {
      const int i = std::countr_zero(met);
      if (node.discs[i] == 0) {
        waiting[left++] = node.first[i];
      } else {
        for (uint32_t k = 0; k < node.discs[i]; ++k) try_disc(impl_->order[node.first[i] + k]);
      }
    }
  }
  std::sort(out.begin() + ptrdiff_t(begin), out.end(),
            [](const Crossing& a, const Crossing& b) { return a.disc < b.disc; });
}

}  // namespace ups
