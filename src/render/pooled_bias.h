// What meters beside each other tell of the bias of merging: most of what one of them says alone is noise.
#pragma once
#include <vector>

#include "render/meter_rings.h"
#include "render/spread.h"

namespace ups {

// Of a meter, estimated by itself. lx: of the light that may be merged; bias_scale: of its disc (Rings), 0: without one;
// widest_scale: of the whole disc that it could have taken, which walls cut, 0: as others.
struct OwnBias {
  Spread bias;
  double lx, bias_scale, widest_scale = 0;
  double scale() const { return bias_scale > 0 ? lx * bias_scale : lx; }
  // meters: of its set. By chance alone one meter in 100 has 3 standard errors by 16 batches: of more, more are asked for.
  bool is_beyond_doubt(size_t meters) const {
    return std::abs(bias.mean) > deviations_by_batches(deviations_among(meters, 2.61)) * bias.standard_error;
  }
};

inline OwnBias own_bias(const MeterRings::Photons& p, uint32_t visits) {
  return {spread(p.bias.data(), visits), p.lx, p.bias_scale, p.widest_scale};
}

// By how light goes on from narrow discs to wide ones, and leans to one side, at a set's meters. An edge beside a meter
// shows in that, and too little in the curvature of the disc that it lies in; but a narrow disc has so few photons that
// one meter alone does not show it.
class NeighbourProfiles {
 public:
  explicit NeighbourProfiles(std::vector<RingProfile> meters);
  bool tell(size_t m) const;
  // To choose the disc out to a ring by half of the photons, which have the profile `half`; 0 where too few tell.
  StepBias bias_to_choose_by(size_t m, const RingProfile& half, uint32_t ring) const {
    return bias(m, half, ring, to_choose);
  }
  // lx; how far the discs of both halves may be off by an edge beside the meter.
  double edge(size_t m, const MeterRings::Choice& discs) const;
  // A bias that the meter alone tells, as no neighbour took such discs: where that is in doubt, what profiles say of them.
  Spread instead_of(const Spread& own, size_t m, const MeterRings::Choice& discs) const;
  // A bias estimated otherwise, and what profiles say of these discs; edge: theirs, at least its standard error.
  Spread added_to(const Spread& bias, size_t m, const MeterRings::Choice& discs, double edge) const;

 private:
  // sure: standard deviations of chance that meters must differ by.
  static constexpr double to_choose = 2, to_state = 1;
  template <class Of>
  StepBias together(size_t m, const RingProfile& own, double sure, const StepBias& alone, const Of& estimate) const;
  StepBias bias_from(size_t m, const RingProfile& own, uint32_t from, uint32_t ring, double sure) const;
  StepBias bias(size_t m, const RingProfile& own, uint32_t ring, double sure) const;
  static double caustic_lean(const RingProfile& p, uint32_t ring);
  double bias_by_edge(size_t m, uint32_t ring) const;
  std::array<StepBias, 2> stated(size_t m, const MeterRings::Choice& discs) const;
  std::vector<RingProfile> meters_;
  double certain_;  // standard deviations of what counts, of so many meters
};

// Of a set's meters, in its order, in which neighbours follow each other.
std::vector<NeighbourCurvature> neighbour_curvatures(const std::vector<OwnBias>& meters);

// What is to be expected of the bias of one of so many meters when the neighbours' curvature is known; its own where it is
// not, or where its own is beyond doubt.
Spread pooled_bias(const OwnBias& own, const NeighbourCurvature& neighbours, size_t meters);

}  // namespace ups
