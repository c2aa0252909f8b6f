// Chooses an emitter for a receiver in proportion to about what it would bring, unoccluded: intensity towards the
// receiver times the cosine there over the squared distance. Few emitters are weighed one by one. Many are the leaves
// of a tree: from its root down, nodes that look large from the receiver are opened, up to a number of them; one of the
// nodes that remain is chosen, then a child at a time down to an emitter (in the manner of Conty Estevez and Kulla
// 2018, Importance Sampling of Many Lights with Adaptive Tree Splitting). Nodes are weighed four at once: those of a
// list, or four that lie below one of the tree.
//
// A small share goes by flux, and as much by number, among the emitters that are not behind the receiver's plane, so
// that what is misjudged is never forgotten: what is strong, and what is weak where the strong ones are hidden.
// Probabilities are a function of the receiver alone and can be asked for afterwards.
#pragma once
#include <deque>
#include <vector>

#include "base/lanes.h"
#include "emitter/lobe.h"
#include "emitter/outline.h"
#include "emitter/receiver.h"

namespace ups {

struct EmitterChoice {
  uint32_t index = 0;
  float probability = 0;  // 0: none can be chosen
  double u = 0;           // uniform again in [0, 1): stratification is kept
};

class LightTree {
 public:
  struct Entry {
    Outline outline;
    double flux;           // by which the small share goes
    float exposed = 1;     // multiplies what it would bring
    uint32_t emitter = 0;  // what a choice names
  };
  static constexpr size_t max_listed = 64;  // emitters that are weighed one by one

  LightTree() = default;
  LightTree(LightTree&&) = default;  // no copies: lobes point into the tables
  LightTree& operator=(LightTree&&) = default;
  // Those without flux are left out. emitter_count: numbers of emitters are below it. weighs_one: where there is one
  // emitter, too, which brings the same to the bit.
  LightTree(const std::vector<Entry>& entries, size_t emitter_count, bool weighs_one = false);

  EmitterChoice choose(const Receiver& receiver, double u) const;
  float probability(const Receiver& receiver, size_t emitter) const;
  // What one of them is estimated to bring, unoccluded, lx.
  float brings(const Receiver& receiver, size_t emitter) const;
  bool is_tree() const { return !listed_; }
  size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + lobes_.capacity() * sizeof(Lobe) + fine_.size() * sizeof(FineTable) +
           coarse_.size() * sizeof(CoarseTable) + lanes_.capacity() * sizeof(Lanes) +
           (emitter_of_node_.capacity() + leaf_of_emitter_.capacity()) * sizeof(uint32_t);
  }

 private:
  struct Node {
    Vec3 center, half;      // of its box
    float intensity;        // that goes with the lobe, relative to the flux of all emitters
    float spread;           // more of it in all directions where an emitter is seen under a large angle
    float flux;             // relative, too, and half of it by number
    float radius2;          // of the sphere about the box
    float largest_falloff;  // 1 / radius2
    uint32_t lobe;
    uint32_t end;  // one past the last node below this one, which all follow it: the left child first
  };
  // What is weighed four at once, with the frames of their lobes turned to look at the receiver. The last lanes may
  // repeat a node.
  struct Lanes {
    Vec3T<Float4> center, half, minus_s, minus_t, minus_n;
    Float4 intensity, spread, flux, radius2, largest_falloff;
    Int4 used, opens;  // -1 or 0; opens: has lanes of its own below it
    const Lobe* lobe[lane_count];
    uint32_t node[lane_count], below[lane_count];  // below: lanes, none of an emitter
    bool all_fine;  // their shapes
  };
  struct View;
  template <class Real> struct Placed;
  template <class Real> struct Seen;
  struct Shares;
  struct Cut;
  struct Parts;
  static constexpr uint32_t none = 0xffffffffu;

  bool is_leaf(uint32_t k) const { return nodes_[k].end == k + 1; }
  uint32_t right_of(uint32_t k) const { return nodes_[k + 1].end; }
  template <class Real>
  static Placed<Real> place(const View& view, const Vec3T<Real>& center, const Vec3T<Real>& half);
  template <class Real>
  static auto is_before(const View& view, const Placed<Real>& box);
  template <class Real>
  static Seen<Real> see(const View& view, const Placed<Real>& box);
  template <class Real, class Of>
  static Real estimate(const Of& node, const Seen<Real>& seen, const Real& lobe);
  static Float4 lobes(const Lanes& lanes, const Vec3T<Float4>& to, const Float4& inverse);
  static Float4 fine_lobes(const Lanes& lanes, const Vec3T<Float4>& to);
  static Float4 estimates(const View& view, const Lanes& lanes, const Placed<Float4>& placed);
  Lanes lanes_of(const uint32_t* nodes, uint32_t count) const;
  uint32_t widen(uint32_t node);
  void cut_list(const View& view, Cut& out) const;
  void cut_tree(const View& view, Cut& out) const;
  void cut(const View& view, Cut& out) const;
  Parts part(const View& view, uint32_t lanes, const Shares& shares) const;
  bool holds(uint32_t lane, uint32_t leaf) const;

  class Lobes;
  Node leaf_of(const Entry& entry, uint32_t lobe, double total_flux, float least) const;
  // order: of the leaves, sorted in place.
  void build(const std::vector<Node>& leaves, std::vector<uint32_t>& order, size_t begin, size_t end);
  void join(uint32_t node);

  std::vector<Node> nodes_;  // a tree in pre-order, or a list of leaves
  std::vector<uint32_t> emitter_of_node_;
  std::vector<uint32_t> leaf_of_emitter_;  // none: is never chosen
  std::vector<Lobe> lobes_;
  std::deque<FineTable> fine_;  // that lobes point to
  std::deque<CoarseTable> coarse_;
  double flux_lm_ = 0;  // of all
  bool listed_ = true;
  bool single_ = false;  // one emitter, which needs no weighing: 12 % of an office with one luminaire
  std::vector<Lanes> lanes_;  // of a list, or of a tree: the root's first
};

}  // namespace ups
