// See light_tree.h.
#include "emitter/light_tree.h"

namespace ups {
namespace {

constexpr float by_flux = 0.05f;  // the share that no estimate takes part in
constexpr size_t max_cut = 64;    // nodes that are weighed for a receiver
constexpr float large2 = 0.16f;   // a node is opened whose radius is more than 0.4 of its distance
static_assert(max_cut >= LightTree::max_listed);

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
  float estimate = 0, flux = 0;
  float sum() const { return estimate + flux; }
};

struct LightTree::Cut {
  uint32_t size = 0;
  uint32_t node[max_cut];
  Shares shares[max_cut];
};

// Altogether behind the receiver's plane.
bool LightTree::is_behind(const View& view, const Node& node) {
  if (view.all_around || view.both_sides) return false;
  return !(dot(view.n, node.center - view.p) > -dot(view.size_n, node.half));
}

// False where the node cannot shine.
bool LightTree::weigh(const View& view, const Node& node, Shares& out) const {
  if (is_behind(view, node)) return false;
  const Vec3 to = node.center - view.p;
  const float d2 = std::max(length2(to), 1e-30f);
  const float inverse = 1 / std::sqrt(d2);
  float cosine = 1;
  if (!view.all_around) {
    // On the average of a box that reaches this far to both sides of its centre, where part of it is behind the plane.
    const float reach = dot(view.size_n, node.half), along = dot(view.n, to);
    float height = view.both_sides ? std::abs(along) : along;
    if (height < reach) {
      const float above = height + reach;
      height = view.both_sides ? (height * height + reach * reach) / (2 * reach) : above * above / (4 * reach);
    }
    cosine = std::min(1.0f, height * inverse);
  }
  const float falloff = inverse * inverse;
  const float intensity =
      node.intensity * lobes_[node.lobe].towards(-to, inverse) + node.spread * std::min(1.0f, node.radius2 * falloff);
  out.estimate = intensity * cosine * std::min(falloff, node.largest_falloff);
  out.flux = node.flux;
  return true;
}

void LightTree::cut(const View& view, Cut& out) const {
  float estimates = 0, fluxes = 0;
  const auto add = [&](uint32_t k) {
    if (!weigh(view, nodes_[k], out.shares[out.size])) return;
    out.node[out.size] = k;
    estimates += out.shares[out.size].estimate;
    fluxes += out.shares[out.size].flux;
    ++out.size;
  };
  if (listed_) {
    for (uint32_t k = 0; k < nodes_.size(); ++k) add(k);
  } else {
    uint32_t queue[2 * max_cut] = {0}, first = 0, last = 1;
    while (first < last) {
      const uint32_t k = queue[first++];
      const Node& node = nodes_[k];
      if (is_behind(view, node)) continue;
      const bool room = out.size + (last - first) + 2 <= max_cut && last + 2 <= 2 * max_cut;
      if (room && !is_leaf(k) && node.radius2 > large2 * length2(node.center - view.p))
        queue[last++] = k + 1, queue[last++] = right_of(k);
      else
        add(k);
    }
  }
  const bool any = estimates > 1e-30f;
  const float of_estimates = any ? (1 - by_flux) / estimates : 0;
  const float of_fluxes = fluxes > 0 ? (any ? by_flux : 1) / fluxes : 0;
  for (uint32_t i = 0; i < out.size; ++i) {
    out.shares[i].estimate *= of_estimates;
    out.shares[i].flux *= of_fluxes;
  }
}

// A node's shares among its children. Where neither is weighed to have any, they go by flux.
void LightTree::halve(const View& view, uint32_t node, const Shares& shares, Shares& left, Shares& right) const {
  const uint32_t l = node + 1, r = right_of(node);
  Shares a, b;
  if (!weigh(view, nodes_[l], a) & !weigh(view, nodes_[r], b)) a.flux = nodes_[l].flux, b.flux = nodes_[r].flux;
  const float fluxes = a.flux + b.flux, estimates = a.estimate + b.estimate;
  const float flux = a.flux / fluxes, estimate = estimates > 0 ? a.estimate / estimates : flux;
  left = {shares.estimate * estimate, shares.flux * flux};
  right = {shares.estimate * (1 - estimate), shares.flux * (1 - flux)};
}

EmitterChoice LightTree::choose(const Receiver& receiver, float u) const {
  const View view(receiver);
  Cut c;
  cut(view, c);
  double below = 0, start = 0;
  uint32_t at = none;
  for (uint32_t i = 0; i < c.size; ++i) {
    const double share = c.shares[i].sum();
    if (!(share > 0)) continue;
    at = i;
    start = below;
    below += share;
    if (u < below) break;  // rounding may leave u above the last one, which is then taken
  }
  if (at == none) return {};
  uint32_t k = c.node[at];
  Shares shares = c.shares[at];
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
  return {emitter_of_node_[k], shares.sum(), std::min(float(rest), 0x1.fffffep-1f)};
}

float LightTree::probability(const Receiver& receiver, size_t emitter) const {
  const uint32_t leaf = emitter < leaf_of_emitter_.size() ? leaf_of_emitter_[emitter] : none;
  if (leaf == none) return 0;
  const View view(receiver);
  Cut c;
  cut(view, c);
  for (uint32_t i = 0; i < c.size; ++i) {
    uint32_t k = c.node[i];
    if (leaf < k || leaf >= nodes_[k].end) continue;
    Shares shares = c.shares[i];
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
