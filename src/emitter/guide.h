// Where light paths start, learnt from what earlier ones were worth at the sensors: the choice of emitter, and for each
// well-known emitter a histogram over the square that its emission is sampled from. Both are densities like any other:
// sampling, next-event estimation and hits multiply by the same number, so every estimate keeps its mean.
//
// The guided square is u_direction, of directional lights u_position: what Emitter::emission_square finds again.
#pragma once
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "emitter/emitter_set.h"

namespace ups {

class GuideTraining;

// One per render, frozen while it is used. The emitters are always those that it was made for.
class EmissionGuide {
 public:
  EmissionGuide() = default;  // as without: EmitterSet::choose_emission, no histograms
  // dark: of each emitter, whether no light path may start from it, as all of its light is found otherwise; empty:
  // none.
  EmissionGuide(const EmitterSet& emitters, GuideTraining training, std::span<const uint8_t> dark = {});

  EmitterSet::Choice choose(const EmitterSet& emitters, double u) const;
  float probability(const EmitterSet& emitters, size_t i) const;

  // Emitter::sample_emission through the histogram. `square`: the guided square's point that it came to.
  bool sample(const EmitterSet& emitters, size_t i, const Vec2& u_position, const Vec2& u_direction,
              EmissionSample& out, Vec2& square) const;
  // Over the guided square, whose mean is 1.
  float density(size_t i, const Vec2& square) const;
  float least_density(size_t i) const;  // it is nowhere below
  // What an emitter's own pdf_direction_w (of directional lights pdf_position_a) is to be multiplied by: light that
  // leaves p in that direction. `primitive`: as for Emitter::eval_hit.
  float factor(const EmitterSet& emitters, size_t i, const Vec3& p, uint32_t primitive, const Vec3& direction) const;
  // factor() to a DirectSample. direction: as the light of it leaves the emitter.
  void apply(const EmitterSet& emitters, size_t i, const Vec3& direction, DirectSample& sample) const;

  size_t histogram_count() const;
  uint32_t resolution(size_t i) const { return i < histograms_.size() ? histograms_[i].n : 0; }  // a side; 0: none
  size_t bytes() const;

 private:
  // n x n cells: cumulative probabilities (upper ends) of rows, then of each row's cells, from `first` in cumulative_.
  struct Histogram {
    uint32_t first = 0, n = 0;
  };
  double fill(Histogram& h, const GuideTraining& training, size_t emitter, size_t begin, size_t end);
  float warp(const Histogram& h, Vec2& u) const;

  DiscreteDistribution choice_;  // empty: as without
  std::vector<Histogram> histograms_;
  std::vector<float> cumulative_;
};

// What light paths have been worth, by where they started. Sums depend on the order of add() alone.
class GuideTraining {
 public:
  // A light path that `drawn_with` started from `square` of the emitter. value: what it was worth, as an estimator has
  // it (divided by the densities that it was drawn with): the flux that it started with if any of it came to use, or
  // what it contributed relative to the means; the first is steadier, as a few contributions outweigh all others.
  void add(const EmitterSet& emitters, const EmissionGuide& drawn_with, uint32_t emitter, const Vec2& square,
           double value);
  static constexpr uint32_t finest = 6;  // 64 x 64
  // Cells of an emitter's finest square, counted row by row, that have a share of its paths whatever these have been
  // worth so far: of something too small for them to find.
  struct Aim {
    uint32_t cell;
    float weight;
  };
  // aims: by emitter. densest: of what they add, over a uniform density.
  void aim(std::vector<std::vector<Aim>> aims, double densest = INFINITY) {
    aims_ = std::move(aims), densest_ = densest;
  }
  static uint32_t finest_cell(const Vec2& square);
  bool empty() const { return cells_.empty() && aims_.empty(); }
  size_t bytes() const { return cells_.capacity() * sizeof(Cell); }

 private:
  friend class EmissionGuide;
  static constexpr size_t most_cells = size_t(1) << 18;
  // Cells in z-order within an emitter, so that four neighbours in turn are one of the next coarser grid.
  struct Cell {
    uint64_t key;
    uint32_t paths;
    double moment[2];  // second, over the square, of two halves of the paths: sums of value^2 * density of drawing
  };
  uint64_t key_of(uint32_t emitter, const Vec2& square) const;
  uint32_t emitter_of(size_t cell) const { return uint32_t(cells_[cell].key >> (2 * level_)); }
  uint32_t resolution(size_t begin, size_t end) const;
  void compact();
  bool has_aims(size_t emitter) const { return emitter < aims_.size() && !aims_[emitter].empty(); }

  std::vector<std::vector<Aim>> aims_;
  double densest_ = INFINITY;
  uint32_t level_ = finest;
  size_t compact_at_ = 1 << 16;
  uint64_t added_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace ups
