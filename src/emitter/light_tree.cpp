// See light_tree.h.
#include "emitter/light_tree.h"

namespace ups {
namespace {

constexpr float by_flux = 0.05f;  // the share that no estimate takes part in: half by flux, half by number
constexpr size_t max_cut = 64;    // nodes that are weighed for a receiver
constexpr float large2 = 0.16f;   // a node is opened whose radius is more than 0.4 of its distance
static_assert(max_cut >= LightTree::max_listed && LightTree::max_listed % lane_count == 0);

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

struct LightTree::Cut {
  uint32_t size = 0;
  uint32_t node[max_cut];
  float estimate[max_cut], flux[max_cut];
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

// Altogether behind the receiver's plane.
inline bool LightTree::is_behind(const View& view, const Placed<float>& node) {
  return !(view.all_around || view.both_sides) && !(node.along > -node.reach);
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

inline LightTree::Shares LightTree::weigh(const View& view, const Node& node, const Placed<float>& placed) const {
  const Seen<float> seen = see(view, placed);
  return {estimate(node, seen, lobes_[node.lobe].towards(-placed.to, seen.inverse)), node.flux};
}

// False where the node cannot shine.
bool LightTree::weigh(const View& view, const Node& node, Shares& out) const {
  const Placed<float> placed = place(view, node.center, node.half);
  if (is_behind(view, placed)) return false;
  out = weigh(view, node, placed);
  return true;
}

void LightTree::fill_lanes() {
  lanes_.assign((nodes_.size() + lane_count - 1) / lane_count, Lanes{});
  for (size_t k = 0; k < lanes_.size() * lane_count; ++k) {
    Lanes& lanes = lanes_[k / lane_count];
    const size_t lane = k % lane_count;
    const Node& node = nodes_[std::min(k, nodes_.size() - 1)];
    const Lobe& lobe = lobes_[node.lobe];
    const auto put = [lane](const Vec3& v, Vec3T<Float4>& to) { to.x[lane] = v.x, to.y[lane] = v.y, to.z[lane] = v.z; };
    put(node.center, lanes.center), put(node.half, lanes.half);
    put(-lobe.frame.s, lanes.minus_s), put(-lobe.frame.t, lanes.minus_t), put(-lobe.frame.n, lanes.minus_n);
    lanes.intensity[lane] = node.intensity, lanes.spread[lane] = node.spread, lanes.flux[lane] = node.flux;
    lanes.radius2[lane] = node.radius2, lanes.largest_falloff[lane] = node.largest_falloff;
    lanes.lobe[lane] = &lobe;
    lanes.all_fine = (lane == 0 || lanes.all_fine) && lobe.shape == Lobe::Shape::fine;
    lanes.used[lane] = k < nodes_.size() ? -1 : 0;
  }
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

void LightTree::weigh_list(const View& view, Cut& out) const {
  const bool one_side = !(view.all_around || view.both_sides);
  for (size_t group = 0; group < lanes_.size(); ++group) {
    const Lanes& lanes = lanes_[group];
    const Placed<Float4> placed = place(view, lanes.center, lanes.half);
    const uint32_t counts = bits_of(one_side ? lanes.used & (placed.along > -placed.reach) : lanes.used);
    if (!counts) continue;
    const Seen<Float4> seen = see(view, placed);
    const Float4 lobe = lanes.all_fine ? fine_lobes(lanes, placed.to) : lobes(lanes, placed.to, seen.inverse);
    const Float4 estimates = estimate(lanes, seen, lobe);
    for (uint32_t i = 0; i < lane_count; ++i) {  // without a branch: each in turn where the next one is to go
      out.estimate[out.size] = estimates[i], out.flux[out.size] = lanes.flux[i];
      out.node[out.size] = uint32_t(group) * lane_count + i;
      out.size += counts >> i & 1;
    }
  }
}

void LightTree::cut(const View& view, Cut& out) const {
  if (listed_) {
    weigh_list(view, out);
  } else {
    uint32_t queue[2 * max_cut], first = 0, last = 1;
    queue[0] = 0;
    while (first < last) {
      const uint32_t k = queue[first++];
      const Node& node = nodes_[k];
      const Placed<float> placed = place(view, node.center, node.half);
      if (is_behind(view, placed)) continue;
      const bool room = out.size + (last - first) + 2 <= max_cut && last + 2 <= 2 * max_cut;
      if (room && !is_leaf(k) && node.radius2 > large2 * placed.distance2) {
        queue[last++] = k + 1, queue[last++] = right_of(k);
        continue;
      }
      const Shares shares = weigh(view, node, placed);
      out.estimate[out.size] = shares.estimate, out.flux[out.size] = shares.flux;
      out.node[out.size++] = k;
    }
  }
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

// A node's shares among its children. Where neither is weighed to have any, they go by flux.
void LightTree::halve(const View& view, uint32_t node, const Shares& shares, Shares& left, Shares& right) const {
  const uint32_t l = node + 1, r = right_of(node);
  Shares a{}, b{};
  if (!weigh(view, nodes_[l], a) & !weigh(view, nodes_[r], b)) a.flux = nodes_[l].flux, b.flux = nodes_[r].flux;
  const float fluxes = a.flux + b.flux, estimates = a.estimate + b.estimate;
  const float flux = a.flux / fluxes, estimate = estimates > 0 ? a.estimate / estimates : flux;
  left = {shares.estimate * estimate, shares.flux * flux};
  right = {shares.estimate * (1 - estimate), shares.flux * (1 - flux)};
}

EmitterChoice LightTree::choose(const Receiver& receiver, float u) const {
  const View view(receiver);
  constexpr float below_1 = 0x1.fffffep-1f;
  if (single_) {
    if (is_behind(view, place(view, nodes_[0].center, nodes_[0].half))) return {};
    return {emitter_of_node_[0], 1, std::min(u, below_1)};
  }
  Cut c;
  cut(view, c);
  // Where the sum of shares passes u. All are added up, as that takes less time than a wrong guess where to end.
  double below = 0, start = 0;
  uint32_t at = none;
  for (uint32_t i = 0; i < c.size; ++i) {
    const double share = c.shares(i).sum();
    const bool taken = share > 0 && !(u < below);  // rounding may leave u above the last one, which is then taken
    at = taken ? i : at;
    start = taken ? below : start;
    below += share > 0 ? share : 0;
  }
  if (at == none) return {};
  uint32_t k = c.node[at];
  Shares shares = c.shares(at);
  double rest = std::clamp((u - start) / shares.sum(), 0.0, 1.0);
  while (!is_leaf(k)) {
    Shares left, right;
    halve(view, k, shares, left, right);
    const double whole = double(left.sum()) + right.sum(), share = left.sum() / whole;
    const bool to_left = right.sum() == 0 || (left.sum() > 0 && rest < share);
    k = to_left ? k + 1 : right_of(k);
    shares = to_left ? left : right;
    rest = std::clamp(to_left ? rest / share : (rest - share) / (1 - share), 0.0, 1.0);
  }
  return {emitter_of_node_[k], shares.sum(), std::min(float(rest), below_1)};
}

float LightTree::brings(const Receiver& receiver, size_t emitter) const {
  const uint32_t leaf = emitter < leaf_of_emitter_.size() ? leaf_of_emitter_[emitter] : none;
  Shares shares;
  return leaf != none && weigh(View(receiver), nodes_[leaf], shares) ? shares.estimate * float(flux_lm_) : 0;
}

float LightTree::probability(const Receiver& receiver, size_t emitter) const {
  const uint32_t leaf = emitter < leaf_of_emitter_.size() ? leaf_of_emitter_[emitter] : none;
  if (leaf == none) return 0;
  const View view(receiver);
  if (single_) return is_behind(view, place(view, nodes_[0].center, nodes_[0].half)) ? 0.0f : 1.0f;
  Cut c;
  cut(view, c);
  for (uint32_t i = 0; i < c.size; ++i) {
    uint32_t k = c.node[i];
    if (leaf < k || leaf >= nodes_[k].end) continue;
    Shares shares = c.shares(i);
    while (!is_leaf(k)) {
      Shares left, right;
      halve(view, k, shares, left, right);
      const bool to_left = leaf < right_of(k);
      k = to_left ? k + 1 : right_of(k);
      shares = to_left ? left : right;
    }
    return shares.sum();
  }
  return 0;
}

}  // namespace ups
