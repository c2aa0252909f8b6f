// See light_tree.h.
#include "emitter/light_tree.h"

#include <bit>

namespace ups {
namespace {

constexpr float by_flux = 0.05f;  // the share that no estimate takes part in: half by flux, half by number
constexpr size_t max_cut = 64;    // nodes that are chosen from
constexpr float large2 = 0.16f;   // a node is opened whose radius is more than 0.4 of its distance
static_assert(max_cut >= LightTree::max_listed && LightTree::max_listed % lane_count == 0);

// Which of `count` shares holds u, that is the sum of those before it and more; `none` where all are 0. All are added
// up, as that takes less time than a wrong guess where to end.
struct Pick {
  static constexpr uint32_t none = 0xffffffffu;
  uint32_t at = none;
  double start = 0, sum = 0;
};
template <class Share>
inline Pick pick(uint32_t count, double u, const Share& share_of) {
  Pick out;
  for (uint32_t i = 0; i < count; ++i) {
    const double share = share_of(i);
    const bool taken = share > 0 && !(u < out.sum);  // rounding may leave u above the last one, which is then taken
    out.at = taken ? i : out.at;
    out.start = taken ? out.sum : out.start;
    out.sum += share > 0 ? share : 0;
  }
  return out;
}

}  // namespace

// The receiver, with what is the same for all nodes.
struct LightTree::View {
  explicit View(const Receiver& r)
      : p(r.p),
        n(r.n),
        size_n(std::abs(n.x), std::abs(n.y), std::abs(n.z)),
        all_around(max_abs(n) == 0),
        both_sides(r.both_sides) {}
  Vec3 p, n, size_n;
  bool all_around, both_sides;
};

// What of all light falls to a node: by estimate, and by flux.
struct LightTree::Shares {
  float estimate, flux;
  float sum() const { return estimate + flux; }
};

// Lanes by number: lane_count times that of the four, and which of them.
struct LightTree::Cut {
  uint32_t size = 0;
  uint32_t lane[max_cut];
  float estimate[max_cut], flux[max_cut];
  Shares shares(uint32_t i) const { return {estimate[i], flux[i]}; }
  // 1, but for the rounding of each, which would be the last one's loss or gain. Four sums, as adding up takes time.
  double whole() const {
    double sums[4] = {};
    for (uint32_t i = 0; i < size; ++i) sums[i % 4] += shares(i).sum();
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }
  // counts: a bit of each lane that is taken. There is room for those that are not: only four that are all taken fill
  // it.
  void add(uint32_t four, uint32_t counts, const Float4& estimates, const Float4& fluxes) {
    for (uint32_t i = 0; i < lane_count; ++i) {  // without a branch: each in turn where the next one is to go
      estimate[size] = estimates[i], flux[size] = fluxes[i];
      lane[size] = four * lane_count + i;
      size += counts >> i & 1;
    }
  }
};

// The shares of four below a node.
struct LightTree::Parts {
  Float4 estimate, flux;
  Shares shares(uint32_t i) const { return {estimate[i], flux[i]}; }
};

// Where a box lies, its centre in the direction `to`. Real: float, or several at once.
template <class Real>
struct LightTree::Placed {
  Vec3T<Real> to;
  Real distance2, along, reach;  // of the centre and of the box along the receiver's normal
};

template <class Real>
inline LightTree::Placed<Real> LightTree::place(const View& view, const Vec3T<Real>& center, const Vec3T<Real>& half) {
  const Vec3T<Real> to = center - all_lanes<Real>(view.p);
  return {to, length2(to), dot(all_lanes<Real>(view.n), to), dot(all_lanes<Real>(view.size_n), half)};
}

// Not altogether behind the receiver's plane: true, or a mask.
template <class Real>
inline auto LightTree::is_before(const View& view, const Placed<Real>& box) {
  const Real any = all_lanes<Real>(view.all_around || view.both_sides ? -INFINITY : 0.0f);
  return box.along + box.reach > any;
}

// How a box looks from the receiver.
template <class Real>
struct LightTree::Seen {
  Real inverse, cosine, falloff;  // 1 / distance
};

template <class Real>
inline LightTree::Seen<Real> LightTree::see(const View& view, const Placed<Real>& box) {
  using std::abs, std::sqrt, ups::abs, ups::sqrt;
  const Real least = all_lanes<Real>(1e-30f), one = all_lanes<Real>(1);
  Seen<Real> out;
  out.inverse = 1 / sqrt(larger(least, box.distance2));
  out.falloff = out.inverse * out.inverse;
  const Real reach = box.reach, height = view.both_sides ? abs(box.along) : box.along;
  Real seen = height;
  if (const auto is_cut = abs(height) < reach; bits_of(is_cut)) {  // on the average of a box partly behind the plane
    const Real above = height + reach, span = is_cut ? larger(reach, least) : one;
    const Real part = view.both_sides ? (height * height + reach * reach) / (2 * span) : above * above / (4 * span);
    seen = is_cut ? part : height;
  }
  const Real cosine = seen * out.inverse;
  out.cosine = view.all_around ? one : smaller(cosine, one);
  return out;
}

// Of: a node, or several.
template <class Real, class Of>
inline Real LightTree::estimate(const Of& node, const Seen<Real>& seen, const Real& lobe) {
  const Real large = smaller(node.radius2 * seen.falloff, all_lanes<Real>(1));
  const Real intensity = node.intensity * lobe + node.spread * large;
  return intensity * seen.cosine * smaller(Real(node.largest_falloff), seen.falloff);
}

LightTree::Lanes LightTree::lanes_of(const uint32_t* nodes, uint32_t count) const {
  Lanes lanes{};
  lanes.all_fine = true;
  for (uint32_t lane = 0; lane < lane_count; ++lane) {
    const uint32_t k = nodes[std::min(lane, count - 1)];
    const Node& node = nodes_[k];
    const Lobe& lobe = lobes_[node.lobe];
    const auto put = [lane](const Vec3& v, Vec3T<Float4>& to) { to.x[lane] = v.x, to.y[lane] = v.y, to.z[lane] = v.z; };
    put(node.center, lanes.center), put(node.half, lanes.half);
    put(-lobe.frame.s, lanes.minus_s), put(-lobe.frame.t, lanes.minus_t), put(-lobe.frame.n, lanes.minus_n);
    lanes.intensity[lane] = node.intensity, lanes.spread[lane] = node.spread, lanes.flux[lane] = node.flux;
    lanes.radius2[lane] = node.radius2, lanes.largest_falloff[lane] = node.largest_falloff;
    lanes.lobe[lane] = &lobe;
    lanes.all_fine = lanes.all_fine && lobe.shape == Lobe::Shape::fine;
    lanes.node[lane] = k, lanes.below[lane] = none;
    lanes.used[lane] = lane < count ? -1 : 0;
  }
  return lanes;
}

// Makes the four below an inner node, and theirs: of the two below it those that look largest are replaced by what lies
// below them. Their number.
uint32_t LightTree::widen(uint32_t k) {
  uint32_t nodes[lane_count] = {k + 1, right_of(k)}, count = 2;
  while (count < lane_count) {
    uint32_t widest = none;
    float radius2 = 0;
    for (uint32_t i = 0; i < count; ++i)
      if (!is_leaf(nodes[i]) && nodes_[nodes[i]].radius2 > radius2) widest = i, radius2 = nodes_[nodes[i]].radius2;
    if (widest == none) break;
    const uint32_t opened = nodes[widest];
    nodes[widest] = opened + 1, nodes[count++] = right_of(opened);
  }
  const uint32_t number = uint32_t(lanes_.size());
  lanes_.push_back(lanes_of(nodes, count));
  for (uint32_t i = 0; i < count; ++i) {
    if (is_leaf(nodes[i])) continue;
    const uint32_t below = widen(nodes[i]);
    lanes_[number].below[i] = below, lanes_[number].opens[i] = -1;
  }
  return number;
}

Float4 LightTree::lobes(const Lanes& lanes, const Vec3T<Float4>& to, const Float4& inverse) {
  Float4 out;
  for (int i = 0; i < lane_count; ++i)
    out[i] = lanes.lobe[i]->towards({-to.x[i], -to.y[i], -to.z[i]}, inverse[i]);
  return out;
}

inline Float4 LightTree::fine_lobes(const Lanes& lanes, const Vec3T<Float4>& to) {
  const Int4 texel = Lobe::Fine::texel(
      Vec3T<Float4>(dot(to, lanes.minus_s), dot(to, lanes.minus_t), dot(to, lanes.minus_n)));
  const auto towards = [&](int i) { return lanes.lobe[i]->table[texel[i]]; };
  return Float4{towards(0), towards(1), towards(2), towards(3)};
}

Float4 LightTree::estimates(const View& view, const Lanes& lanes, const Placed<Float4>& placed) {
  const Seen<Float4> seen = see(view, placed);
  return estimate(lanes, seen, lanes.all_fine ? fine_lobes(lanes, placed.to) : lobes(lanes, placed.to, seen.inverse));
}

void LightTree::cut_list(const View& view, Cut& out) const {
  for (uint32_t four = 0; four < lanes_.size(); ++four) {
    const Lanes& lanes = lanes_[four];
    const Placed<Float4> placed = place(view, lanes.center, lanes.half);
    if (const uint32_t counts = bits_of(lanes.used & is_before(view, placed)))
      out.add(four, counts, estimates(view, lanes, placed), lanes.flux);
  }
}

void LightTree::cut_tree(const View& view, Cut& out) const {
  constexpr size_t most_opened = (max_cut - lane_count) / (lane_count - 1);
  uint32_t queue[1 + most_opened], first = 0, last = 1;
  size_t most = lane_count;  // nodes that are left in the end
  queue[0] = 0;
  while (first < last) {
    const uint32_t four = queue[first++];
    const Lanes& lanes = lanes_[four];
    const Placed<Float4> placed = place(view, lanes.center, lanes.half);
    const Int4 used = lanes.used & is_before(view, placed);
    uint32_t counts = bits_of(used);
    most -= lane_count - size_t(std::popcount(counts));
    uint32_t opens = bits_of(used & lanes.opens & (lanes.radius2 > large2 * placed.distance2));
    for (; opens && most + lane_count - 1 <= max_cut && last <= most_opened; opens &= opens - 1) {
      const int i = std::countr_zero(opens);
      queue[last++] = lanes.below[i], most += lane_count - 1;
      counts &= ~(1u << i);
    }
    if (counts) out.add(four, counts, estimates(view, lanes, placed), lanes.flux);
  }
}

void LightTree::cut(const View& view, Cut& out) const {
  if (listed_) cut_list(view, out);
  else cut_tree(view, out);
  if (listed_ && out.size == 1) {  // certain, however little it is
    out.estimate[0] = 1, out.flux[0] = 0;
    return;
  }
  float estimates = 0, fluxes = 0;
  for (uint32_t i = 0; i < out.size; ++i) estimates += out.estimate[i], fluxes += out.flux[i];
  const bool any = estimates > 1e-30f;
  const float of_estimates = any ? (1 - by_flux) / estimates : 0;
  const float of_fluxes = fluxes > 0 ? (any ? by_flux : 1) / fluxes : 0;
  for (uint32_t i = 0; i < out.size; ++i) out.estimate[i] *= of_estimates, out.flux[i] *= of_fluxes;
}

// A node's shares among the four below it. Where none is weighed to have any, they go by flux.
LightTree::Parts LightTree::part(const View& view, uint32_t four, const Shares& shares) const {
  const Lanes& lanes = lanes_[four];
  const Placed<Float4> placed = place(view, lanes.center, lanes.half);
  const Int4 before = lanes.used & is_before(view, placed), counts = bits_of(before) ? before : lanes.used;
  const Float4 zero{}, flux = counts ? lanes.flux : zero;
  const Float4 weighed = bits_of(before) ? estimates(view, lanes, placed) : zero, estimate = before ? weighed : zero;
  const float fluxes = flux[0] + flux[1] + flux[2] + flux[3];
  const float sum = estimate[0] + estimate[1] + estimate[2] + estimate[3];
  return {(sum > 0 ? estimate / sum : flux / fluxes) * shares.estimate, flux / fluxes * shares.flux};
}

EmitterChoice LightTree::choose(const Receiver& receiver, double u) const {
  const View view(receiver);
  constexpr double below_1 = 1 - 0x1p-53;
  if (single_) {
    if (!is_before(view, place(view, nodes_[0].center, nodes_[0].half))) return {};
    return {emitter_of_node_[0], 1, std::min(u, below_1)};
  }
  Cut c;
  cut(view, c);
  const double all = c.whole();
  const Pick of_cut = pick(c.size, u * all, [&](uint32_t i) { return c.shares(i).sum(); });
  if (of_cut.at == none) return {};
  uint32_t lane = c.lane[of_cut.at];
  Shares shares = c.shares(of_cut.at);
  double rest = std::clamp((u * all - of_cut.start) / shares.sum(), 0.0, 1.0);
  for (;;) {
    const Lanes& lanes = lanes_[lane / lane_count];
    const uint32_t below = lanes.below[lane % lane_count], node = lanes.node[lane % lane_count];
    if (below == none) return {emitter_of_node_[node], shares.sum(), std::min(rest, below_1)};
    const Parts parts = part(view, below, shares);
    const auto share = [&](uint32_t i) { return parts.shares(i).sum(); };
    const double whole = double(share(0)) + share(1) + share(2) + share(3);
    const Pick of_parts = pick(lane_count, rest * whole, share);
    if (of_parts.at == none) return {};
    lane = below * lane_count + of_parts.at;
    shares = parts.shares(of_parts.at);
    rest = std::clamp((rest * whole - of_parts.start) / shares.sum(), 0.0, 1.0);
  }
}

float LightTree::brings(const Receiver& receiver, size_t emitter) const {
  const uint32_t leaf = emitter < leaf_of_emitter_.size() ? leaf_of_emitter_[emitter] : none;
  if (leaf == none) return 0;
  const View view(receiver);
  const Node& node = nodes_[leaf];
  const Placed<float> placed = place(view, node.center, node.half);
  if (!is_before(view, placed)) return 0;
  const Seen<float> seen = see(view, placed);
  return estimate(node, seen, lobes_[node.lobe].towards(-placed.to, seen.inverse)) * float(flux_lm_);
}

bool LightTree::holds(uint32_t lane, uint32_t leaf) const {
  const uint32_t k = lanes_[lane / lane_count].node[lane % lane_count];
  return leaf >= k && leaf < nodes_[k].end;
}

float LightTree::probability(const Receiver& receiver, size_t emitter) const {
  const uint32_t leaf = emitter < leaf_of_emitter_.size() ? leaf_of_emitter_[emitter] : none;
  if (leaf == none) return 0;
  const View view(receiver);
  if (single_) return is_before(view, place(view, nodes_[0].center, nodes_[0].half)) ? 1.0f : 0.0f;
  Cut c;
  cut(view, c);
  for (uint32_t i = 0; i < c.size; ++i) {
    uint32_t lane = c.lane[i];
    if (!holds(lane, leaf)) continue;
    Shares shares = c.shares(i);
    for (uint32_t below; (below = lanes_[lane / lane_count].below[lane % lane_count]) != none;) {
      const Parts parts = part(view, below, shares);
      uint32_t k = 0;
      while (!holds(below * lane_count + k, leaf)) ++k;
      lane = below * lane_count + k;
      shares = parts.shares(k);
    }
    return shares.sum();
  }
  return 0;
}

}  // namespace ups
