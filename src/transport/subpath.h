// One walk for both ends: from an emitter (importance) or from a sensor (radiance) through the scene, with the state
// that the weights need. LightWalk and EyeWalk are loops over it that call the techniques.
#pragma once
#include <type_traits>

#include "transport/iteration.h"
#include "transport/path_recorder.h"
#include "transport/walk.h"

namespace ups {

// A vertex that a walk has arrived at, with what its techniques share. An eye's own sensor point is one, too.
template <class State>
struct End {
  SurfacePoint surface;
  std::optional<Bsdf> bsdf;  // none: a meter's own point, which responds by its kind
  MeterResponse response;
  Vec3 wo, local_wo;         // towards the vertex before
  State state;
  bool merge = false;   // photons are merged here
  bool caster = false;  // a continuous lobe here is so sharp that it casts caustics as a mirror does
  uint32_t edges = 0;   // from the walk's start
  Rgb carried;          // throughput, lm for a light path
  const MediaStack *front = nullptr, *back = nullptr;

  const MediaStack& beyond(const Vec3& w) const { return dot(w, surface.ng) < 0 ? *back : *front; }
  Scattering evaluate(const Vec3& local, TransportMode mode) const {
    if (bsdf) return bsdf->evaluate(local_wo, local, mode);
    return {Rgb(response.value(local)), response.pdf(local), 1};
  }
  // Of a new edge along w from `at`, which is the vertex or stands for it: its part in densities of area there.
  float cosine(const SurfacePoint& at, const Vec3& w) const { return response.across ? 1.0f : std::abs(dot(w, at.ng)); }
  mis::Scatter scatter(const Scattering& f) const { return {f.pdf, f.pdf_reverse, 1, merge, caster}; }
};
using LightEnd = End<mis::LightState>;
using EyeEnd = End<mis::EyeState>;

template <class Walk, TransportMode mode>
class Subpath {
 protected:
  static constexpr bool from_emitter = mode == TransportMode::importance;
  static constexpr Drop own_walk = from_emitter ? Drop::light_walk : Drop::eye_walk;
  using State = std::conditional_t<from_emitter, mis::LightState, mis::EyeState>;
  using Vertex = End<State>;

  Subpath(const Iteration& in, const PathSampler& rng, WorkCounts& work)
      : in_(in), scene_(in.scene), rng_(rng), work_(work) {}

  void trace(uint32_t edges) {
    PaneNumber u(rng_, edges);
    meet(scene_, origin_, direction_, media_, u, work_, met_);
    if (in_.recorder && met_.found) in_.recorder->meet(met_);
  }

  // p: near the sample.
  void drop(Drop where, const Vec3& p) { work_.drop(where, rng_.address(), p); }
  bool drop(Drop where) {
    drop(where, last_met());
    return false;
  }
  Vec3 last_met() const { return met_.found ? met_.surface.p : origin_; }

  FluxBooks& books() {
    if constexpr (from_emitter) return work_.flux;
    else return work_.importance;
  }
  // False where the path ends as what is left is not finite; the books then lack it.
  bool carry(const Rgb& share) {
    const Rgb after = carried_ * share;
    if (!is_finite(after)) return drop(own_walk);
    books().absorbed += double(luminance(carried_)) - double(luminance(after));
    carried_ = after;
    return true;
  }
  bool carry_to_met() {
    if (!met_.is_clear()) return carry(met_.transmittance(scene_, met_.distance));
    return is_finite(carried_) || drop(own_walk);
  }
  // At a vertex of so many edges: nothing where no light goes on from it.
  void lose_by_leaning(uint32_t edges, double carried) {
    if (in_.is_too_long(edges + 1)) return;
    if constexpr (from_emitter) work_.leaning_lm.lose(carried);
    else work_.leaning_eye.lose(carried / start_importance_);
  }
  bool absorb() {
    carry(Rgb(0.0f));
    return false;
  }
  bool cut() {
    books().cut += luminance(carried_);
    return false;
  }

  // The weights' state at a point that the current edge reaches. at(): how it sees emitters, for a light's first edge.
  template <class At>
  State arrive(const At& at, float cos_in, float distance) const {
    if (!from_emitter && in_.light_samples_alone) return {};  // all weights are 1
    const double d2 = double(distance) * distance, pass = met_.pass(distance);
    if (edge_.kind == Edge::delta) {
      if constexpr (from_emitter) return mis::light_step_delta(edge_.state, edge_.chi, edge_.scatter.cos_out, cos_in);
      else return mis::eye_step_delta(edge_.state, edge_.chi, edge_.scatter.cos_out, cos_in);
    }
    const auto& walk = static_cast<const Walk&>(*this);
    if constexpr (from_emitter)
      return edge_.kind == Edge::first ? walk.first_state(at(), cos_in, d2, pass)
                                       : mis::light_step(edge_.state, edge_.scatter, cos_in, d2, pass);
    else
      return edge_.kind == Edge::first ? walk.first_state(cos_in, d2, pass)
                                       : mis::eye_step(edge_.state, counts_, edge_.scatter, cos_in, d2, pass);
  }

  // What the current edge has met, once its light is there; false where nothing scatters on.
  bool shade(uint32_t edges, Vertex& v) {
    v.surface = met_.surface;
    v.edges = edges;
    v.bsdf.emplace(scene_.materials[v.surface.material], v.surface.uv, met_.relative_ior);
    v.wo = -direction_;
    v.local_wo = v.surface.shading.to_local(v.wo);
    v.carried = carried_;
    v.front = &met_.front, v.back = &met_.back;
    v.state = arrive([&] { return receiver_at(v.surface, v.wo, *v.bsdf); }, std::abs(dot(direction_, v.surface.ng)),
                     met_.distance);
    v.caster = v.bsdf->is_caster();
    if (consistent_side(v.surface, v.wo, v.local_wo)) return true;
    if (!is_finite(v.local_wo)) return drop(own_walk);
    lose_by_leaning(edges, luminance(carried_ * base_colour(scene_.materials[v.surface.material], v.surface.uv)));
    return false;
  }

  // The next edge. keep(sample): whether the walk goes on by such a lobe.
  template <class Keep>
  bool scatter(const Vertex& v, const Keep& keep) {
    BsdfSample s;
    // A pane that was met reflects: those that are gone through are crossed.
    const bool chooses = v.bsdf->chooses_lobe() && !scene_.panes.is_pane(v.surface.instance);
    const float u_lobe = chooses ? rng_.get(v.edges, Slot::lobe) : 0;
    if (!v.bsdf->sample(v.local_wo, u_lobe, rng_.direction(v.edges), mode, s)) return absorb();
    if (!keep(s)) return false;
    const Vec3 wi = v.surface.shading.to_world(s.wi);
    if (is_finite(s.weight) && !consistent_side(v.surface, wi, s.wi)) {
      if (!is_finite(wi)) return drop(own_walk);
      lose_by_leaning(v.edges, luminance(carried_ * s.weight));
      return absorb();
    }
    float correction = 1;
    if constexpr (from_emitter)
      correction = s.delta ? shading_correction(v.surface, v.wo, wi) : light_correction(v.surface, v.wo, wi);
    else if (!s.delta)
      correction = terminator(v.surface, wi);
    const Rgb before = carried_;
    if (!carry(s.weight * correction)) return false;
    if (correction != 1) lose_by_leaning(v.edges, luminance(before * s.weight) * (1 - double(correction)));
    const bool lossless = s.delta && max_component(s.weight) > 0.9f;
    // Of a dark surface that a sensor sees the light comes by dark paths alone: what it leaves is the start.
    if (!from_emitter && v.edges == 1) start_carried_ = carried_;
    const float q = survival(carried_, start_carried_, from_emitter ? light_reserve : eye_reserve, v.edges, lossless);
    if (is_black(carried_) || (q < 1 && !survives(q))) return false;
    if (in_.recorder) in_.recorder->scatter(s, q, carried_);
    edge_.kind = s.delta ? Edge::delta : Edge::continuous;
    edge_.state = v.state;
    edge_.scatter = {s.pdf, s.pdf_reverse, std::abs(dot(wi, v.surface.ng)), v.merge, v.caster};
    edge_.chi = double(s.pdf_reverse) / s.pdf * s.delta_jacobian;
    last_ = receiver_at(v.surface, v.wo, *v.bsdf);
    media_ = met_.beyond(wi);
    origin_ = v.surface.ray_origin(wi);
    direction_ = wi;
    return true;
  }

  bool survives(float q) {
    if (roulette_ < 0) roulette_ = rng_.roulette();
    const bool survives = roulette_ < q;
    roulette_ /= q;
    const Rgb after = survives ? carried_ * (1 / q) : Rgb(0.0f);
    books().play(luminance(carried_), q, luminance(after));
    carried_ = after;
    return survives;
  }

  // The event at the last vertex, not yet an edge: the next cosine and distance make it a state.
  struct Edge {
    enum { first, continuous, delta } kind = first;
    State state;
    mis::Scatter scatter;
    double chi = 0;
  };

  const Iteration& in_;
  const Snapshot& scene_;
  PathSampler rng_;
  WorkCounts& work_;
  mis::Counts counts_;
  Edge edge_;
  Encounter met_;  // where the current edge ends
  Vec3 origin_, direction_;
  Receiver last_;  // the vertex that the current edge leaves; without normal at a camera
  Rgb carried_{1.0f}, start_carried_{1.0f};
  float start_importance_ = 1;  // an eye path's
  double roulette_ = -1;  // what is left of the path's number; none was drawn yet
  MediaStack media_;  // where the current edge starts
};

}  // namespace ups
