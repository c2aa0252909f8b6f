// What landed on point meters' discs, summed by rings, and which disc a reading takes: chosen after the photons came, so
// that noise and bias together are least, on one half of the batches for the other half and the other way round, so that
// the choice does not bias what is read. Of the other half the choice knows whether light is narrower than a disc, and of
// caustics how bright photons are, wherever in the widest disc.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/zeroed.h"
#include "render/largest_samples.h"
#include "transport/meter_discs.h"
#include "transport/plan.h"
#include "transport/tally.h"

namespace ups {

// Of light about a meter and its neighbours, relative to it: a disc's bias over its illuminance and mean squared radius,
// 1/m2.
struct NeighbourCurvature {
  double mean = 0, variance_of_mean = 0;
  double between = INFINITY;  // variance between meters; infinite: nothing is known
  bool tell() const { return std::isfinite(between); }
  // How much a meter keeps of a bias, lx, that it knows with such a variance; scale: lx m2, illuminance and radius.
  double share_of_own(double scale, double variance) const {
    if (!tell()) return 1;
    const double prior = between * scale * scale;
    return std::isfinite(prior) && prior + variance > 0 ? prior / (prior + variance) : 1;
  }
};

// Of a meter's light: means of discs out to each ring over lx, that of the widest, and their variances.
struct RingProfile {
  double lx = 0, radius2 = 0;  // mean squared radius of the outermost ring, m2
  uint32_t narrowest = 0;
  std::array<float, max_rings> mean{}, variance{};
  // How light leans to one side at the meter, along its frame (across the light: along axes that turn with it): e over
  // lx, of the fit e + f r over the rings of a disc to the means of light times the direction to where it falls. A slope
  // has none; a step at the meter, 1/pi of it.
  std::array<float, max_rings> lean_s{}, lean_t{};
  static constexpr double lean_noise = 4.87;  // of either, its variance over the disc's
  // Of caustics: length of the photons' mean direction from the meter, where chance makes it so long in 14 of 100 cases at
  // most; 2/pi where light ends at the meter. Slopes are in it.
  std::array<float, max_rings> one_sided{};
  // Whether it tells how light goes on from the disc out to one ring to a wider one. What noise such a step has is what
  // the wide disc predicts: a narrow one does not know it, and would seem to be sure where it has too few photons.
  bool has(uint32_t from, uint32_t to) const {
    return narrowest <= from && from < to && to < max_rings && variance[to] > 0;
  }
  double step(uint32_t from, uint32_t to) const { return double(mean[to]) - double(mean[from]); }
  double step_variance(uint32_t from, uint32_t to) const {
    return double(variance[to]) * (std::ldexp(1.0, int(to - from)) - 1);
  }
};

// A disc's bias as a meter and its neighbours show it by such steps, over the same lx.
struct StepBias {
  double mean = 0;
  double own_variance = 0, told_variance = 0;  // of what the meter differs from its neighbours in; of their mean
  double variance() const { return own_variance + told_variance; }
  bool is_beyond(double errors) const { return mean * mean > errors * errors * variance(); }
};

// Of a caustic that may be narrower than the disc it is read from, lx: what narrower discs say more or less than the
// reading, and how far the truth may be from that on either side, 95 %.
struct NarrowLight {
  double shift = 0, chance = 0;
  double size() const { return std::abs(shift) + chance; }
};

class MeterRings {
 public:
  // A row is a column of a meter: all its light, or a source's, columns fastest. direct: some light comes straight from
  // emitters; caustics: all of it comes by way of casters alone, so that a few photons may be all that is known of it.
  MeterRings(size_t meters, size_t columns, uint32_t rings, bool direct, bool caustics = false);
  static double bytes_per_row(uint32_t rings, bool direct) {
    return rings * (sizeof(double) * (batch_count + halves + 2 + (direct ? batch_count : 0)) +
                    sizeof(uint32_t) * halves + sizeof(Largest));
  }
  bool empty() const { return flux_.empty(); }
  void add(size_t row, uint32_t batch, const MeterLanding& landing, uint32_t iteration);

  // Even and odd batches: the outermost ring that is read of each.
  using Choice = std::array<uint32_t, 2>;
  // What is told of neighbours. steps: by the profile of half of the photons and the outermost ring; empty: nothing.
  struct Told {
    NeighbourCurvature curvature;
    std::function<StepBias(const RingProfile&, uint32_t)> steps;
  };
  Choice choose(size_t row, const Rings& rings, uint32_t visits, const Told& told = {}) const;
  RingProfile profile(size_t row, const Rings& rings, uint32_t visits) const;

  // The photons of the chosen discs.
  struct Photons {
    std::array<double, batch_count> value{}, direct{}, bias{};  // lx, sums of each batch; bias as estimated
    double lx = 0;  // mean value
    PathRecord paths;
    uint32_t caustics = 0;  // of the whole disc, those that came by way of casters alone
    uint8_t largest_batch = 0;                // that with paths.largest
    SampleOrigin largest;                     // the same
    double choice_variance = 0;               // lx2, of the reading by which discs were chosen
    double bias_scale = 0;                    // of the discs: light that changes evenly is biased in proportion
    double widest_scale = 0;                  // the same of the widest disc
    double narrower = 0;  // lx; a least error bound: what narrower discs say, and few photons leave open
    NarrowLight caustic;  // that may be added to it
    bool halves_differ = false;  // in their discs
    bool widest = false;  // there are no wider ones
    bool brings_direct = false;  // light straight from emitters, too
    void add(const Photons& caustics);  // which have discs of their own
  };
  // others: how many photons there are besides, with discs of their own.
  Photons read(size_t row, const Rings& rings, const Choice& choice, uint32_t visits, uint32_t others = 0) const;

 private:
  static constexpr size_t halves = 2;
  struct Largest {
    Sample photon;  // lm
    uint8_t batch = 0;
  };
  struct Sums;
  Sums sums_of(size_t row, const Rings& rings, size_t begin, size_t end, uint32_t visits) const;
  struct Dependence {
    std::array<double, max_rings> of_mean, of_bias;
    double clump = 1;  // see Sums
    Dependence() { of_mean.fill(1), of_bias.fill(1); }
  };
  Dependence dependence(size_t row, const Sums& all, const Rings& rings, uint32_t visits) const;
  struct Whole;
  Whole whole(size_t row, const Rings& rings, uint32_t visits) const;
  // bright: whose widest disc tells what a photon may bring, and its variance over that of sums.
  static uint32_t best(const Sums& sums, const Rings& rings, const Dependence& dependence, const Told& told, double lx,
                       uint32_t widest, const Sums& bright, double bright_variance);
  double flux(size_t row, uint32_t batch, uint32_t ring) const {
    return flux_[(row * batch_count + batch) * rings_ + ring];
  }

  uint32_t rings_;
  ZeroedVector<double> flux_, direct_;  // a row by a batch by a ring
  ZeroedVector<double> square_;         // a row by a half by a ring
  ZeroedVector<uint32_t> count_;        // the same
  ZeroedVector<double> lean_;           // flux by its direction from the meter, a row by a ring by s and t
  ZeroedVector<Largest> largest_;       // a row by a ring
  bool caustics_;
  double sure_;  // standard deviations by which narrower discs must differ from what is read, of so many meters
};

}  // namespace ups
