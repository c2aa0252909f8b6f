// Where the flux of light paths goes, and the importance of eye paths: summed over them as they are traced, at the cost
// of some additions an edge.
//
// Of a path that starts with S, S = absorbed + escaped + cut + roulette + what is lost, to rounding: what comes to a
// vertex and does not leave it is absorbed. So the books do not tell whether a material gives back too much. They tell
// whether emission starts paths with the flux that it states (a sensor's response does by construction), whether any are
// lost, and whether roulette is fair.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

namespace ups {

struct FluxBooks {  // lm, or of an eye path what its sensor weighs it by; not yet divided by the number of paths
  double started = 0, started_squares = 0;
  double absorbed = 0, escaped = 0;
  double cut = 0;  // left at the greatest length of paths that was asked for, or where the method ends them
  // Taken by roulette from paths that it ended, less what it gave to others: each game is fair, of a variance known
  // before it is played. Numbers of a batch's paths are stratified, by which all together vary less.
  double roulette = 0, roulette_variance = 0, largest_game = 0;

  // What came to an end, and of how many paths, by batch: they owe each other nothing, where paths and games within one are
  // stratified.
  struct OfBatch {
    double ended = 0;
    uint64_t paths = 0;
  };
  std::array<OfBatch, 16> batches{};

  // Once for all paths of an iteration, before they are added to others.
  void settle(uint32_t batch, uint64_t paths) { batches[batch] = {absorbed + escaped, paths}; }
  void start(double lm) {
    started += lm;
    started_squares += lm * lm;
  }
  // A path that goes on with probability q; after: 0 where it ends.
  void play(double before, double q, double after) {
    const double odds = (1 - q) / q;
    roulette += before - after;
    roulette_variance += before * before * odds;
    largest_game = std::max(largest_game, before * std::max(1.0, odds));
  }
  void add(const FluxBooks& o) {
    started += o.started;
    started_squares += o.started_squares;
    absorbed += o.absorbed;
    escaped += o.escaped;
    cut += o.cut;
    roulette += o.roulette;
    roulette_variance += o.roulette_variance;
    largest_game = std::max(largest_game, o.largest_game);
    for (size_t b = 0; b < batches.size(); ++b) {
      batches[b].ended += o.batches[b].ended;
      batches[b].paths += o.batches[b].paths;
    }
  }
};

}  // namespace ups
