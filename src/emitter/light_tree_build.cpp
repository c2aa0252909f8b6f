// How the light tree of light_tree.h is built: leaves from outlines, groups that are bright, small and far apart.
#include <array>
#include <cstddef>
#include <map>
#include <numeric>

#include "emitter/light_tree.h"

namespace ups {
namespace {

Vec3 low(const Vec3& a, const Vec3& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 high(const Vec3& a, const Vec3& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

struct Extent {
  Vec3 lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};
  double flux = 0;
  void grow(const Extent& e) { lower = low(lower, e.lower), upper = high(upper, e.upper), flux += e.flux; }
  // Flux times squared diagonal.
  double cost() const { return flux > 0 ? flux * length2(Vec3d(upper) - Vec3d(lower)) : 0; }
};

// Their cosines, each widened: a texel's middle stands for all of it.
CoarseTable facet_table(const std::vector<Vec3>& areas) {
  CoarseTable table{};
  for (int i = 0; i < Lobe::Coarse::size; ++i) {
    const Vec3 w = Lobe::Coarse::direction(i, 0.5f, 0.5f);
    for (const Vec3& a : areas) table[size_t(i)] += std::max(0.0f, dot(a, w) + 0.2f * length(a)) / 1.2f;
  }
  return table;
}

}  // namespace

// The lobes of all leaves, each once.
class LightTree::Lobes {
 public:
  explicit Lobes(LightTree& tree) : tree_(tree) {}

  uint32_t add(const Outline& o) {
    Lobe lobe;
    lobe.frame = o.frame;
    switch (o.shape) {
      case Outline::Shape::uniform: break;
      case Outline::Shape::cosine: lobe.shape = Lobe::Shape::cosine; break;
      case Outline::Shape::two_cosines: lobe.shape = Lobe::Shape::two_cosines; break;
      case Outline::Shape::cone: lobe = cone_lobe(o.frame, o.inner_versine, o.outer_versine); break;
      case Outline::Shape::profile:
        lobe.shape = Lobe::Shape::fine;
        lobe.table = table_of(*o.distribution);
        break;
      case Outline::Shape::facets:
        lobe.shape = Lobe::Shape::coarse;
        lobe.table = tree_.coarse_.emplace_back(facet_table(o.areas)).data();
        break;
    }
    return add(lobe);
  }

 private:
  uint32_t add(const Lobe& l) {
    const Frame& f = l.frame;
    const Key key{l.table,
                  {float(l.shape), l.outer_cosine, l.inverse_width, f.s.x, f.s.y, f.s.z, f.t.x, f.t.y, f.t.z, f.n.x,
                   f.n.y, f.n.z}};
    const auto [at, is_new] = number_.try_emplace(key, uint32_t(tree_.lobes_.size()));
    if (is_new) tree_.lobes_.push_back(l);
    return at->second;
  }
  const float* table_of(const photometry::Distribution& d) {
    const float*& table = table_[&d];
    if (!table) table = tree_.fine_.emplace_back(fine_table(d)).data();
    return table;
  }

  using Key = std::pair<const float*, std::array<float, 12>>;
  LightTree& tree_;
  std::map<Key, uint32_t> number_;
  std::map<const photometry::Distribution*, const float*> table_;
};

LightTree::LightTree(const std::vector<Entry>& entries, size_t emitter_count, bool weighs_one)
    : leaf_of_emitter_(emitter_count, none) {
  double total = 0;
  Extent all;
  for (const Entry& e : entries) {
    if (!(e.flux > 0)) continue;
    total += e.flux;
    all.grow({e.outline.center - e.outline.half, e.outline.center + e.outline.half, e.flux});
  }
  if (!(total > 0)) return;
  flux_lm_ = total;
  // Emitters at one place are told apart by intensity: nothing divides by zero.
  const float extent = length(all.upper - all.lower), least = extent > 0 ? std::max(1e-9f * extent, 1e-15f) : 1;
  std::vector<Node> leaves;
  std::vector<uint32_t> emitters;
  Lobes lobes(*this);
  for (const Entry& e : entries) {
    if (!(e.flux > 0)) continue;
    leaves.push_back(leaf_of(e, lobes.add(e.outline), total, least));
    emitters.push_back(e.emitter);
  }
  for (Node& leaf : leaves) leaf.flux = 0.5f * (leaf.flux + 1 / float(leaves.size()));
  listed_ = leaves.size() <= max_listed;
  single_ = leaves.size() == 1 && !weighs_one;
  nodes_.reserve(2 * leaves.size());
  std::vector<uint32_t> order(leaves.size());
  std::iota(order.begin(), order.end(), 0u);
  if (listed_)
    for (size_t i = 0; i < leaves.size(); ++i) build(leaves, order, i, i + 1);
  else
    build(leaves, order, 0, leaves.size());
  for (uint32_t& leaf : emitter_of_node_) leaf = leaf == none ? none : emitters[leaf];
  for (uint32_t k = 0; k < nodes_.size(); ++k)
    if (is_leaf(k)) leaf_of_emitter_[emitter_of_node_[k]] = k;
  if (!listed_) {
    widen(0);
    return;
  }
  for (uint32_t k = 0; k < nodes_.size(); k += lane_count) {
    uint32_t four[lane_count], count = 0;
    while (count < lane_count && k + count < nodes_.size()) four[count] = k + count, ++count;
    lanes_.push_back(lanes_of(four, count));
  }
}

LightTree::Node LightTree::leaf_of(const Entry& e, uint32_t lobe, double total_flux, float least) const {
  const Outline& o = e.outline;
  Node n;
  n.center = o.center;
  n.half = o.half;
  n.intensity = float(double(o.intensity) * e.exposed / total_flux);
  // What has extent and a distribution shines near by as its brightest direction does.
  n.spread = max_abs(o.half) > 0 && lobes_[lobe].table ? n.intensity * lobes_[lobe].largest() : 0;
  n.flux = std::max(float(e.flux / total_flux), 1e-30f);
  n.radius2 = std::max(length2(o.half), least * least);
  n.largest_falloff = 1 / n.radius2;
  n.lobe = lobe;
  return n;
}

namespace {

// Where to part what lies in [begin, end): by the bins of the emitters' centres along each axis, so that the sum over
// both parts of flux times squared diagonal is least (as the surface area heuristic weighs boxes).
template <class Node>
struct Parting {
  int axis = -1;
  float at = 0;
  static Extent extent_of(const Node& n) { return {n.center - n.half, n.center + n.half, n.flux}; }

  static Parting find(const std::vector<Node>& leaves, const std::vector<uint32_t>& order, size_t begin, size_t end) {
    constexpr int most_bins = 16;
    const int bins = std::min<int>(most_bins, int(end - begin));
    Vec3 lower{INFINITY, INFINITY, INFINITY}, upper = -lower;
    for (size_t i = begin; i < end; ++i) {
      lower = low(lower, leaves[order[i]].center), upper = high(upper, leaves[order[i]].center);
    }
    Parting best;
    double least = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
      const float from = lower[axis], width = (upper[axis] - from) / float(bins);
      if (!(width > 0)) continue;
      Extent bin[most_bins], left[most_bins], right;
      for (size_t i = begin; i < end; ++i) {
        const Node& n = leaves[order[i]];
        bin[std::clamp(int((n.center[axis] - from) / width), 0, bins - 1)].grow(extent_of(n));
      }
      for (int b = 0; b + 1 < bins; ++b) {
        if (b > 0) left[b] = left[b - 1];
        left[b].grow(bin[b]);
      }
      for (int b = bins - 1; b > 0; --b) {
        right.grow(bin[b]);
        const double cost = left[b - 1].cost() + right.cost();
        if (left[b - 1].flux > 0 && right.flux > 0 && cost < least) {
          least = cost;
          best = {axis, from + width * float(b)};
        }
      }
    }
    return best;
  }
};

}  // namespace

void LightTree::build(const std::vector<Node>& leaves, std::vector<uint32_t>& order, size_t begin, size_t end) {
  const uint32_t k = uint32_t(nodes_.size());
  if (end - begin == 1) {
    nodes_.push_back(leaves[order[begin]]);
    nodes_[k].end = k + 1;
    emitter_of_node_.push_back(order[begin]);
    return;
  }
  const auto parting = Parting<Node>::find(leaves, order, begin, end);
  const auto from = order.begin() + std::ptrdiff_t(begin), to = order.begin() + std::ptrdiff_t(end);
  auto middle = from;
  if (parting.axis >= 0)
    middle = std::partition(from, to, [&](uint32_t i) { return leaves[i].center[parting.axis] < parting.at; });
  if (middle == from || middle == to) middle = from + std::ptrdiff_t((end - begin) / 2);  // all at one place
  const size_t between = size_t(middle - order.begin());
  nodes_.emplace_back();
  emitter_of_node_.push_back(none);
  build(leaves, order, begin, between);
  build(leaves, order, between, end);
  nodes_[k].end = uint32_t(nodes_.size());
  join(k);
}

// A node from its children.
void LightTree::join(uint32_t k) {
  const Node &a = nodes_[k + 1], &b = nodes_[right_of(k)];
  Node& n = nodes_[k];
  const Vec3 lower = low(a.center - a.half, b.center - b.half), upper = high(a.center + a.half, b.center + b.half);
  n.center = (lower + upper) * 0.5f;
  const float rounding = 0x1p-20f * std::max(max_abs(lower), max_abs(upper));
  n.half = (upper - lower) * 0.5f + Vec3(rounding, rounding, rounding);
  n.radius2 = std::max(length2(n.half), std::max(a.radius2, b.radius2));
  n.largest_falloff = 1 / n.radius2;
  n.flux = a.flux + b.flux;
  n.lobe = a.lobe;
  n.intensity = a.intensity + b.intensity;
  n.spread = 0;  // the node is opened where that would matter
  if (a.lobe == b.lobe) return;
  CoarseTable& table = coarse_.emplace_back();
  add_to(table, lobes_[a.lobe], a.intensity);
  add_to(table, lobes_[b.lobe], b.intensity);
  n.intensity = 1;
  n.lobe = uint32_t(lobes_.size());
  lobes_.push_back({Lobe::Shape::coarse, 0, 0, table.data()});
}

}  // namespace ups
