// The weights as the engine computes them: two walks along the path with the recurrences of transport/weights.h. Each walk
// is told only what it can know at that vertex; the joining technique sees both states.
#pragma once
#include <vector>

#include "slow_weights.h"
#include "transport/light_vertex.h"
#include "transport/weights.h"

namespace ups::test {

// What connections and merges know of a light path's vertex: its state, or that as it is stored until then.
enum class LightStates { exact, stored };

class FastWeights {
 public:
  FastWeights(const Path& path, const mis::Counts& n, const mis::Gates& gates, LightStates states = LightStates::exact)
      : p_(path), n_(n), gates_(gates), states_(states) {
    walk_from_emitter();
    walk_from_sensor();
  }

  double weight(Technique technique, int at) const { return mis::weight(others(technique, at)); }

 private:
  double d2(int edge) const { return p_.distance[edge] * p_.distance[edge]; }
  // Densities on edge a: of x_a by scattering at x_{a+1}, and of x_{a+1} by scattering at x_a.
  double pb(int a) const { return p_.pdf_to_emitter[a + 1] * p_.cos_near[a] / d2(a); }
  double pf(int a) const {
    if (a == 0 && p_.emitter == EmitterType::directional) return p_.cos_far[0] / p_.disc_area;
    return p_.pdf_to_sensor[a] * p_.cos_far[a] / d2(a);
  }

  mis::Classes others(Technique technique, int at) const {
    switch (technique) {
      case Technique::hit: return hit();
      case Technique::light_sample: return light_sample();
      case Technique::connect: return connect(at);
      case Technique::sensor_connect: return sensor_connect();
      case Technique::land: return mis::others_of_land(light_[p_.k], n_, p_.cell_area, p_.pdf_to_emitter[p_.k]);
      case Technique::merge: return merge(at);
    }
    return {};
  }
  // What the light walk knows of scattering at x_a; its gate is for x_1, too.
  mis::Scatter from_light(int a) const {
    const bool merge = p_.merges[a] && (a > 1 || gates_.merge_at_first);
    return {p_.pdf_to_sensor[a], p_.pdf_to_emitter[a], p_.cos_near[a], merge, p_.caster[a]};
  }
  // What the eye walk knows; a meter's own point merges where it has a radius.
  mis::Scatter from_eye(int a) const {
    if (a == p_.k) return {p_.pdf_to_emitter[a], 1, p_.cos_far[a - 1], eta_sensor_ > 0, false};
    return {p_.pdf_to_emitter[a], p_.pdf_to_sensor[a], p_.cos_far[a - 1], p_.merges[a], p_.caster[a]};
  }

  void walk_from_emitter() {
    light_.resize(p_.k + 1);
    const double nee_over_emit = p_.nee_a / p_.emission_a;
    light_[1] = p_.emitter == EmitterType::directional
                    ? mis::light_first_directional(n_, nee_over_emit, p_.disc_area, p_.cos_far[0], p_.pass[0])
                    : mis::light_first(n_, nee_over_emit, p_.pdf_to_sensor[0], d2(0), p_.cos_far[0], p_.pass[0],
                                       p_.hittable(), p_.cos_near[0], p_.emission_a);
    for (int a = 1; a < p_.k; ++a) {
      const double chi = p_.pdf_to_emitter[a] / p_.pdf_to_sensor[a] * p_.jacobian[a];
      light_[a + 1] = p_.delta[a] ? mis::light_step_delta(light_[a], chi, p_.cos_near[a], p_.cos_far[a])
                                  : mis::light_step(light_[a], from_light(a), p_.cos_far[a], d2(a), p_.pass[a]);
    }
  }

  void walk_from_sensor() {
    const int k = p_.k;
    eye_.resize(k + 1);
    eta_sensor_ = p_.sensor == SensorType::point_meter ? n_.eta * p_.sensor_merge_share : 0;
    eye_[k] = mis::at_meter(n_, eta_sensor_, p_.cell_area);
    for (int a = k; a > 0; --a) {
      const double chi = p_.pdf_to_sensor[a] / (p_.pdf_to_emitter[a] * p_.jacobian[a]);
      const double cos_out = p_.cos_far[a - 1], cos_in = p_.cos_near[a - 1], pass = p_.pass[a - 1];
      if (a == k && p_.camera())
        eye_[a - 1] = mis::eye_first(n_, p_.pdf_to_emitter[k], cos_in, d2(a - 1), pass);
      else
        eye_[a - 1] = p_.delta[a] ? mis::eye_step_delta(eye_[a], chi, cos_out, cos_in)
                                  : mis::eye_step(eye_[a], n_, from_eye(a), cos_in, d2(a - 1), pass);
    }
  }

  mis::Classes hit() const {
    const bool connectable = p_.k > 1 ? !p_.delta[1] : !p_.camera();
    const double pb_0 = pb(0) * (p_.delta[1] ? p_.jacobian[1] : 1) * p_.pass[0];
    return mis::others_of_hit(eye_[0], n_, gates_, p_.nee_a, p_.emission_a, p_.pdf_to_sensor[0], pb_0, connectable);
  }
  mis::Classes light_sample() const {
    const mis::Classes from_emitter = mis::from_emitter_at_light_sample(eye_[1], n_, gates_, from_eye(1));
    return p_.pass[0] * mis::others_of_light_sample(from_emitter, n_, p_.hittable() ? pb(0) : 0, p_.nee_a,
                                                    p_.emission_a, pf(0));
  }
  mis::LightState joined(int a) const {
    if (states_ == LightStates::exact) return light_[a];
    LightVertex v;
    v.set_state(light_[a]);
    return v.state();
  }
  mis::Classes connect(int s) const {
    return p_.pass[s - 1] * mis::others_of_connect(joined(s - 1), from_light(s - 1), eye_[s], from_eye(s), n_,
                                                   pb(s - 1), pf(s - 1));
  }
  mis::Classes sensor_connect() const {
    if (!p_.camera()) return connect(p_.k);
    return p_.pass[p_.k - 1] * mis::others_of_splat(light_[p_.k - 1], from_light(p_.k - 1), n_, pb(p_.k - 1));
  }
  mis::Classes merge(int m) const {
    return mis::others_of_merge(joined(m), p_.pdf_to_emitter[m], eye_[m], from_eye(m), n_, gates_);
  }

  const Path& p_;
  const mis::Counts& n_;
  const mis::Gates& gates_;
  const LightStates states_;
  std::vector<mis::LightState> light_;  // [a]: at x_a
  std::vector<mis::EyeState> eye_;      // [a]: at x_a
  double eta_sensor_ = 0;
};

}  // namespace ups::test
