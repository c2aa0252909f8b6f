// The streams of random numbers of a render, and those of one path by fixed addresses (vertex, slot): scrambled Sobol
// points for the first vertices, Philox for the rest. A switched-off effect never shifts the numbers of another.
#pragma once
#include "base/rng.h"
#include "transport/sobol.h"

namespace ups {

// What a vertex draws. A light path's vertex 0 is the emitter, an eye path's the sensor. Philox gives four at a time,
// so those that are drawn together stand together.
enum class Slot {
  choice, position_x, position_y,  // next-event estimation; a light path's vertex 0: its emitter
  connection,                      // which of a vertex's connections gets its shadow ray
  direction_x, direction_y, lobe, edges,  // vertex 0: which of an eye path's edges that waited get their shadow rays
  cell_x, cell_y,  // a point in a meter's cell
  perturb_x, perturb_y,  // where path integration arrives beside the vertex
  count,
  more_choice = connection,  // of a light path's vertex 0
  crowd = perturb_x,     // which of the photons about the vertex are merged where they are very many
  pane = cell_x,         // of a later vertex: which panes the edge to it goes through
  later_edges = cell_y,  // of number k > 0: which of a long path's edges that waited for test k get their shadow rays
  roulette = edges       // of vertex 1: the last bits of the path's number
};

// All that draws numbers of its own. Two streams share none, whatever their seeds: the seed alone is Philox's key, by a
// one-to-one mix, and the stream is a word of its counter.
class Stream {
 public:
  enum Kind : uint32_t {
    light,        // light paths
    pilot,        // those that merge radii are fitted to, and techniques chosen by
    flux,         // those that only book flux
    camera,       // eye paths, by camera
    illuminance,  // those from what a camera's pixels see, by camera
    meters,       // eye paths, by set of meters
    pairing,      // which light path an eye path meets
    kinds
  };
  Stream(Kind kind, uint32_t index = 0) : word_(index * kinds + kind) {}
  Kind kind() const { return Kind(word_ % kinds); }
  uint32_t index() const { return word_ / kinds; }
  static uint64_t key_of(uint64_t seed) { return hash_combine(seed, 0); }
  std::array<uint32_t, 4> numbers(uint64_t seed, uint32_t a, uint32_t b, uint32_t c) const {
    return numbers_of_key(key_of(seed), a, b, c);
  }
  std::array<uint32_t, 4> numbers_of_key(uint64_t key, uint32_t a, uint32_t b, uint32_t c) const {
    return philox({a, b, c, word_}, {uint32_t(key), uint32_t(key >> 32)});
  }
  uint64_t scramble(uint64_t seed, uint64_t key) const {
    return hash_combine(hash_combine(key_of(seed), word_), key);
  }

 private:
  uint32_t word_;
};

// Names a path within a render.
struct PathAddress {
  Stream stream;
  uint32_t iteration, path;  // path: running number of a light path, pixel, or meter times the samples of each
};

class PathSampler {
 public:
  // key: which member of the stream (batch and pixel or meter), so that each has its own scrambling. index: the running
  // number of the sample within the batch.
  // iteration, path: address of the independent numbers beyond the stratified ones. A sequence has 2^32 points, then
  // another begins.
  PathSampler(uint64_t seed, Stream stream, uint64_t key, uint64_t index, uint32_t iteration, uint32_t path)
      : key_(Stream::key_of(seed)),
        stream_(stream),
        scramble_(stream.scramble(seed, index >> 32 ? hash_combine(key, index >> 32) : key)),
        index_(uint32_t(index)),
        iteration_(iteration),
        path_(path) {}

  PathAddress address() const { return {stream_, iteration_, path_}; }
  float get(uint32_t vertex, Slot slot) { return to_unit_float(bits(vertex, slot)); }
  // All 32 bits, where what is seldom chosen weighs much.
  double get_fine(uint32_t vertex, Slot slot) { return 0x1p-32 * bits(vertex, slot); }
  // Decides how long the path gets, all by itself: what is left of it after each game is uniform again. So the lengths
  // of paths are stratified as one dimension; in white rooms they are most of the noise.
  double roulette() { return 0x1p-32 * (stratified(roulette_dimension) + double(get(1, Slot::roulette))); }
  // Beyond those of the slots, for what takes as many as chance has it: k < 2^12.
  Vec2 more(uint32_t vertex, uint32_t k) const {
    const auto numbers = stream_.numbers_of_key(key_, iteration_, path_, ~(vertex << 12 | k));
    return {to_unit_float(numbers[0]), to_unit_float(numbers[1])};
  }
  Vec2 position(uint32_t vertex) { return {get(vertex, Slot::position_x), get(vertex, Slot::position_y)}; }
  Vec2 direction(uint32_t vertex) { return {get(vertex, Slot::direction_x), get(vertex, Slot::direction_y)}; }

 private:
  static constexpr int roulette_dimension = 20;
  uint32_t bits(uint32_t vertex, Slot slot) {
    const int dimension = sobol_dimension(vertex, slot);
    if (dimension >= 0) return stratified(dimension);
    const uint32_t address = vertex * 3 + uint32_t(slot) / 4;
    if (address != cached_address_) {
      cached_ = stream_.numbers_of_key(key_, iteration_, path_, address);
      cached_address_ = address;
    }
    return cached_[uint32_t(slot) % 4];
  }
  uint32_t stratified(int dimension) const {
    return sobol_owen(index_, dimension, uint32_t(mix64(scramble_ + uint64_t(dimension))));
  }
  // The best dimensions go where most of the variance is: the first two directions, then emitters, lobes, later ones.
  static int sobol_dimension(uint32_t vertex, Slot slot) {
    static constexpr int table[3][int(Slot::count)] = {{4, 5, 6, -1, 0, 1, -1, -1, 18, 19, -1, -1},
                                                      {9, 10, 11, -1, 2, 3, 8, -1, 7, -1, -1, -1},
                                                      {15, 16, 17, -1, 12, 13, 14, -1, -1, -1, -1, -1}};
    return vertex < 3 ? table[vertex][int(slot)] : -1;
  }

  uint64_t key_;  // Philox's
  Stream stream_;
  uint64_t scramble_;
  uint32_t index_, iteration_, path_;
  uint32_t cached_address_ = 0xffffffffu;
  std::array<uint32_t, 4> cached_{};
};

}  // namespace ups
