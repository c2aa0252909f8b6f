// The weights as the engine computes them: two walks along the path with the recurrences of transport/mis.h. Each walk
// is told only what it can know at that vertex; the joining technique sees both states.
#pragma once
#include <vector>

#include "slow_weights.h"
#include "transport/mis.h"

namespace ups::test {

class FastWeights {
 public:
  FastWeights(const Path& path, const mis::Counts& n, const mis::Gates& gates) : p_(path), n_(n), gates_(gates) {
    walk_from_emitter();
    walk_from_sensor();
  }

  double weight(Technique technique, int at) const {
    switch (technique) {
      case Technique::hit:
        return hit();
      case Technique::light_sample:
        return light_sample();
      case Technique::connect:
        return connect(at);
      case Technique::sensor_connect:
        return sensor_connect();
      case Technique::land:
        return mis::weight_land(light_[p_.k], n_, p_.cell_area, p_.pdf_to_emitter[p_.k]);
      case Technique::merge:
        return merge(at);
    }
    return -1;
  }

 private:
  double d2(int edge) const { return p_.distance[edge] * p_.distance[edge]; }
  // Merging is allowed at x_a: known to the light walk, which counts its vertices.
  bool light_gate(int a) const { return p_.merges[a] && (a > 1 || gates_.merge_at_first); }
  // Densities on edge a: of x_a by scattering at x_{a+1}, and of x_{a+1} by scattering at x_a.
  double pb(int a) const { return p_.pdf_to_emitter[a + 1] * p_.cos_near[a] / d2(a); }
  double pf(int a) const {
    if (a == 0 && p_.emitter == EmitterType::directional) return p_.cos_far[0] / p_.disc_area;
    return p_.pdf_to_sensor[a] * p_.cos_far[a] / d2(a);
  }

  void walk_from_emitter() {
    light_.resize(p_.k + 1);
    const double nee_over_emit = p_.nee_a / p_.emission_a;
    light_[1] = p_.emitter == EmitterType::directional
                    ? mis::light_first_directional(n_, nee_over_emit, p_.disc_area, p_.cos_far[0])
                    : mis::light_first(n_, nee_over_emit, p_.pdf_to_sensor[0], d2(0), p_.cos_far[0], p_.hittable(),
                                       p_.cos_near[0], p_.emission_a);
    for (int a = 1; a < p_.k; ++a) {
      const double out = p_.pdf_to_sensor[a], back = p_.pdf_to_emitter[a];
      light_[a + 1] = p_.delta[a]
                          ? mis::light_step_delta(light_[a], back / out * p_.jacobian[a], p_.cos_near[a], p_.cos_far[a])
                          : mis::light_step(light_[a], light_gate(a), out, back, p_.cos_near[a], p_.cos_far[a], d2(a));
    }
  }

  void walk_from_sensor() {
    eye_.resize(p_.k);
    const int k = p_.k;
    eta_sensor_ = p_.sensor == SensorType::point_meter ? n_.eta * p_.sensor_merge_share : 0;
    end_ = p_.camera() ? mis::SensorEnd{} : mis::sensor_end(n_, eta_sensor_, p_.cell_area);
    const double cos_sensor = p_.camera() ? 1 : p_.cos_far[k - 1];
    eye_[k - 1] =
        mis::eye_first(n_, p_.camera(), end_, p_.pdf_to_emitter[k], cos_sensor, p_.cos_near[k - 1], d2(k - 1));
    for (int a = k - 1; a > 0; --a) {
      const double out = p_.pdf_to_emitter[a], back = p_.pdf_to_sensor[a];
      const double cos_out = p_.cos_far[a - 1], cos_in = p_.cos_near[a - 1];
      eye_[a - 1] = p_.delta[a]
                        ? mis::eye_step_delta(eye_[a], back / (out * p_.jacobian[a]), cos_out, cos_in)
                        : mis::eye_step(eye_[a], n_, p_.camera(), p_.merges[a], out, back, cos_out, cos_in, d2(a - 1));
    }
  }

  double hit() const {
    const bool connectable = p_.k > 1 ? !p_.delta[1] : !p_.camera();
    const double pb_0 = pb(0) * (p_.delta[1] ? p_.jacobian[1] : 1);
    return mis::weight_hit(eye_[0], n_, gates_, p_.nee_a, p_.emission_a, p_.pdf_to_sensor[0], pb_0, connectable);
  }
  double light_sample() const {
    const double total = p_.k == 1 ? mis::sensor_total_direct(end_, gates_)
                                   : (light_gate(1) ? mis::eta_at(n_, eye_[1]) : 0) +
                                         mis::eye_total(eye_[1], gates_, p_.camera(), true, p_.pdf_to_sensor[1]);
    return mis::weight_light_sample(n_, p_.hittable() ? pb(0) : 0, p_.nee_a, p_.emission_a, pf(0), total);
  }
  double connect(int s) const {
    return mis::weight_connect(light_[s - 1], eye_[s], n_, light_gate(s - 1), p_.merges[s], pb(s - 1),
                               p_.pdf_to_emitter[s - 1], pf(s - 1), p_.pdf_to_sensor[s]);
  }
  double sensor_connect() const {
    const int a = p_.k - 1;
    const double pb_a = pb(a), pf_a = p_.camera() ? 0 : pf(a);
    return mis::weight_sensor_connect(light_[a], n_, p_.camera(), end_, light_gate(a), pb_a, p_.pdf_to_emitter[a],
                                      pf_a);
  }
  double merge(int m) const {
    if (m == p_.k) return mis::weight_merge_at_sensor(light_[m], n_, eta_sensor_, p_.pdf_to_emitter[m]);
    const double eye = mis::eye_total(eye_[m], gates_, p_.camera(), m == 1, p_.pdf_to_sensor[m]);
    return mis::weight_merge(light_[m], n_, mis::eta_at(n_, eye_[m]), p_.pdf_to_emitter[m], eye);
  }

  const Path& p_;
  const mis::Counts& n_;
  const mis::Gates& gates_;
  std::vector<mis::LightState> light_;  // [a]: at x_a
  std::vector<mis::EyeState> eye_;      // [a]: at x_a
  mis::SensorEnd end_;
  double eta_sensor_ = 0;
};

}  // namespace ups::test
