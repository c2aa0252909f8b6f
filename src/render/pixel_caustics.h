// What an image may not show yet: light by way of casters; with the bias of its pixels, which is kept where photons are
// merged, too.
#pragma once
#include <vector>

#include "render/caustic_search.h"
#include "render/pixel_bias.h"
#include "render/tiles.h"
#include "transport/tally.h"

namespace ups {

// By tiles and those beside them, as far as what one path may bring is told: a smaller caustic is not looked for, as
// nothing that is seen elsewhere says where it may be.
class PixelCaustics {
 public:
  static constexpr double bytes_per_pixel = 40.0 / (Units::side * Units::side);
  PixelCaustics(uint32_t width, uint32_t height) : tiles_(width, height), of_tile_(tiles_.count()) {}

  void add(uint32_t pixel, const PixelMerges& merges) {
    of_tile_[tiles_.of(pixel)].add({{double(merges.disc_m2), double(merges.caustics)},
                                    double(merges.caustics_met), double(merges.caustic_light), 1, merges.disc_m2 > 0});
  }
  struct Unfound {
    double lx = 0;       // in the mean over the tile, parts of which may see nothing that light falls on
    double photons = 0;  // that were found
    double light = 0, of_visit = 0;  // luminance, lx, they bring a pixel that sees something; how many its disc meets
    // Standard error of that light in a pixel, where so few photons are due that its batches do not know it. Of less than
    // one that light is missing, or its batches know it.
    double noise(uint32_t visits) const {
      const double due = of_visit * visits;
      return due > 0 && due < CausticSearch::enough ? light / std::sqrt(std::max(due, 1.0)) : 0;
    }
  };
  // By tile. Of a light path that starts with so many lm.
  std::vector<Unfound> unfound(double brightest_lm, uint32_t light_paths) const {
    std::vector<Unfound> out;
    for (size_t t = 0; t < of_tile_.size(); ++t) {
      Tile all;
      tiles_.each_around(t, [&](size_t tile) { all.add(of_tile_[tile]); });
      const double lx = all.search.unfound_lx(brightest_lm, light_paths);
      const Tile& own = of_tile_[t];
      const double of_seen = all.seen > 0 ? 1.0 / all.seen : 0, sees = own.visits > 0 ? double(own.seen) / own.visits : 1;
      out.push_back({lx * sees, all.search.paths, sees > 0 ? all.light * of_seen : 0, all.met * of_seen});
    }
    return out;
  }

 private:
  struct Tile {
    CausticSearch search;
    double met = 0, light = 0;  // sums of PixelMerges'
    uint32_t visits = 0, seen = 0;  // of its pixels, together; with a disc
    void add(const Tile& o) {
      search.add(o.search), met += o.met, light += o.light;
      count_up(visits, o.visits), count_up(seen, o.seen);
    }
  };
  const Tiles tiles_;
  std::vector<Tile> of_tile_;
};

// What merging says of an image's pixels, luminance or illuminance.
struct PixelMergeSums {
  static double bytes_per_pixel(double batches) {
    return PixelBias::bytes_per_pixel(batches) + PixelCaustics::bytes_per_pixel;
  }
  PixelBias bias;
  PixelCaustics caustics;
  PixelMergeSums(uint32_t width, uint32_t height) : bias(width, height), caustics(width, height) {}
  void add(uint32_t pixel, const PixelMerges& merges) {
    bias.add(pixel, merges.bias);
    caustics.add(pixel, merges);
  }
  // What is told by all pixels at once: see PixelBias::of_squares and PixelCaustics::unfound.
  struct Errors {
    std::vector<PixelBias::OfSquare> squares;
    std::vector<PixelCaustics::Unfound> unfound;
  };
};

}  // namespace ups
