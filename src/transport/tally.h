// What one iteration found: sums for every sensor, and counts.
// The accumulator in render/ turns iterations into readings.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <vector>

#include "base/memory_budget.h"
#include "base/vec.h"
#include "sensor/goniometer.h"
#include "transport/flux_books.h"
#include "transport/sampler.h"
#include "transport/technique.h"

namespace ups {

// Where a sample was left out because it was not finite: by a technique; or with all the rest of its path, whose
// throughput no longer was.
enum class Drop {
  emitter_hit, light_sample, connect, sensor_connect, merge, sensor_hit,
  emission, light_walk, eye_walk,
  count
};
inline constexpr const char* drop_names[] = {"emitter_hit", "light_sample", "connect",    "sensor_connect", "merge",
                                             "sensor_hit",  "emission",     "light_walk", "eye_walk"};
static_assert(std::size(drop_names) == size_t(Drop::count));

struct DroppedSample {
  Drop where;
  PathAddress path;
  Vec3 p;  // near it; may not be finite either
};

// Of what is scattered, what shading normals lose that lean from their faces, less what they add; and its squares.
struct LeaningLoss {
  double sum = 0, squares = 0;

  void lose(double amount) { sum += amount, squares += amount * amount; }
  void add(const LeaningLoss& o) { sum += o.sum, squares += o.squares; }
};

struct WorkCounts {
  uint64_t rays = 0, light_paths = 0, eye_paths = 0, light_vertices = 0, merges = 0, connections = 0;
  // Vertices of eye paths about which were too many photons to look at all of them, and the most that were about one.
  uint64_t crowds = 0, largest_crowd = 0;
  uint64_t caster_rays = 0;  // of light paths that have met nothing but casters
  float brightest_lm = 0;    // of all light paths, as they started
  float brightest_caustic_lm = 0;  // of those that a caster sent on, from no other surface
  std::array<uint64_t, size_t(Drop::count)> dropped{};
  std::vector<DroppedSample> first_dropped;  // one of each Drop: the first, in an order that threads do not change
  FluxBooks flux, importance;  // of light paths, of eye paths
  LeaningLoss leaning_lm;   // of light paths
  // Of eye paths, as shares of the importance that they start with; within glass of index n as 1 / n^2 of it.
  LeaningLoss leaning_eye;

  void drop(Drop where, const PathAddress& path, const Vec3& p) {
    if (dropped[size_t(where)]++ == 0) first_dropped.push_back({where, path, p});
  }
  // o: of later samples.
  void add(const WorkCounts& o) {
    rays += o.rays;
    light_paths += o.light_paths;
    eye_paths += o.eye_paths;
    light_vertices += o.light_vertices;
    merges += o.merges;
    connections += o.connections;
    crowds += o.crowds;
    largest_crowd = std::max(largest_crowd, o.largest_crowd);
    caster_rays += o.caster_rays;
    brightest_lm = std::max(brightest_lm, o.brightest_lm);
    brightest_caustic_lm = std::max(brightest_caustic_lm, o.brightest_caustic_lm);
    for (const DroppedSample& d : o.first_dropped)
      if (dropped[size_t(d.where)] == 0) first_dropped.push_back(d);
    for (size_t i = 0; i < dropped.size(); ++i) dropped[i] += o.dropped[i];
    flux.add(o.flux);
    importance.add(o.importance);
    leaning_lm.add(o.leaning_lm);
    leaning_eye.add(o.leaning_eye);
  }
};

enum LightPart { whole_light, direct_light, indirect_light, light_part_count };

// Of as many as it can hold: whether they are few is what is asked.
inline void count_up(uint32_t& count, uint32_t more) { count += std::min(more, UINT32_MAX - count); }

// Paths that brought light to one meter by chance: how many, and the most that one of them brought to one iteration.
struct PathRecord {
  float largest = 0;  // lx
  uint32_t count = 0;

  void add(const PathRecord& o, double scale = 1) {
    largest = std::max(largest, float(o.largest * scale));
    count_up(count, o.count);
  }
};

// Which path of its iteration brought a sample: of a light path its number, of a meter's eye paths their running number,
// of a pixel's 0.
struct PathNumber {
  static constexpr uint32_t light_bit = 1u << 31;
  uint32_t bits = 0;

  static PathNumber light(uint32_t path) { return {path | light_bit}; }
  bool is_light() const { return bits & light_bit; }
  uint32_t number() const { return bits & ~light_bit; }
};

// Estimates of this iteration for one meter, lx; of a point meter without what landed on its disc.
struct MeterTally {
  double value = 0;
  double direct = 0;  // part of value that came straight from an emitter
  double bias = 0;    // 2 (M_r - M_{r/sqrt 2}) of eye paths' merges: its mean is their bias to O(r^4)
  double exact = 0;    // part of value that is no matter of chance
  double exact_mirrored = 0;  // part of that which is not direct
  float rounding = 0;  // of exact, at most
  uint32_t caustics = 0;  // light paths that landed by way of casters alone; see Plan::hits_alone_at: eye paths that hit
  std::array<PathRecord, light_part_count> paths;
  PathNumber largest;  // that of paths[whole_light]

  static MeterTally of_path(double value, double direct, double bias, PathNumber path = {}) {
    constexpr double rounding = 1e-5;  // direct light of a path that brought nothing else
    MeterTally t{value, direct, bias};
    t.largest = path;
    const double parts[] = {value, direct, value - direct};
    for (size_t k = 0; k < light_part_count; ++k)
      if (parts[k] > rounding * value) t.paths[k] = {float(parts[k]), 1};
    return t;
  }
  void add(const MeterTally& o, double scale = 1) {
    value += o.value * scale;
    direct += o.direct * scale;
    bias += o.bias * scale;
    exact += o.exact * scale;
    exact_mirrored += o.exact_mirrored * scale;
    rounding += float(o.rounding * scale);
    count_up(caustics, o.caustics);
    if (float(o.paths[whole_light].largest * scale) > paths[whole_light].largest) largest = o.largest;
    for (size_t k = 0; k < light_part_count; ++k) paths[k].add(o.paths[k], scale);
  }
};

// A photon on a point meter's disc.
struct MeterLanding {
  uint32_t visited;  // running number of the meter
  uint32_t column;   // of Plan::separation, where there is one
  uint8_t ring;      // of MeterDiscs
  bool direct;       // straight from an emitter
  uint8_t octant;    // of MeterDiscs, about the meter
  uint32_t path;     // that brought it
  double lm;         // weighted, already divided by N
  bool caustic = false;  // by way of casters alone
};

// What a light path brought to a pixel, already divided by N.
struct Splat {
  uint32_t pixel, path;
  Rgb value;
};

// What merging says of a pixel besides its light.
struct PixelMerges {
  float bias = 0;  // see MeterTally: luminance, lx
  // About the first vertex that scatters: of the disc where photons were looked for what is no other pixel's, 0 where
  // there is no such vertex; and as much of the number of those that came by way of casters alone.
  float disc_m2 = 0, caustics = 0;
  float caustics_met = 0, caustic_light = 0;  // of the whole disc: how many brought light, and how much: luminance, lx
};

// On the first diffuse surface that a pixel sees.
struct PixelIlluminance {
  float lx = 0;
  PixelMerges merges;
};

// The surface that a camera's eye path meets first, whatever it is made of: panes and mirrors too.
struct FirstHit {
  Rgb albedo;       // base_colour()
  Vec3 normal;      // of shading, towards the camera
  float depth = -1; // m from the camera; -1: nothing is met
};

// Small however large the sensors are: holds visited pixels and meters alone, by their running number
// (Plan::for_visited_pixels, Plan::visited_meter).
struct IterationTally {
  std::vector<std::vector<Rgb>> pixels;         // a camera: eye paths
  std::vector<std::vector<PixelMerges>> pixel_merges;  // a camera; empty without merging
  std::vector<std::vector<PixelIlluminance>> illuminance;  // a camera; empty where not asked for
  std::vector<std::vector<FirstHit>> first_hits;  // a camera; empty where its layers are not asked for
  std::vector<std::vector<uint32_t>> first_ids;   // a camera: instances at pixels' centres, 0: none; of a first visit
  std::vector<std::vector<Splat>> splats;       // a camera
  std::vector<TechniqueTally> techniques;       // a camera, of all its pixels; empty where not asked for
  std::vector<std::vector<MeterTally>> meters;
  std::vector<std::vector<MeterLanding>> landings;  // a set, in an order that threads do not change
  // A set: a meter by a column of Plan::separation, column fastest; empty without.
  std::vector<std::vector<MeterTally>> separated;
  std::vector<GoniometerTally> goniometers;
  WorkCounts work, light_work;  // all of it, and the light pass's
  // Of a pilot (Moments): by visited pixel and meter, and by tile, set of techniques fastest.
  struct Start {  // of a light path that came to something as a caustic, or (flux 0) to nothing
    uint32_t emitter;
    Vec2 square;
    float flux;
  };
  std::vector<Start> starts;  // where a guide is trained
  std::vector<std::vector<double>> excess_of_pixels, excess_of_meters, excess_of_splats;
  MemoryShare share;  // of splats and landings

  size_t bytes() const;
};

inline size_t IterationTally::bytes() const {
  size_t sum = sizeof *this;
  const auto count = [&](const auto& all) {
    for (const auto& one : all) sum += one.size() * sizeof one[0];
  };
  count(pixels), count(pixel_merges), count(illuminance), count(splats), count(meters), count(landings);
  count(first_hits), count(first_ids);
  count(separated);
  for (const TechniqueTally& t : techniques)
    sum += (t.weighted.size() + t.unweighted.size() + 2 * t.pixels) * sizeof(Rgb);
  for (const GoniometerTally& g : goniometers) sum += (g.wide.size() + g.narrow.size()) * sizeof(double);
  return sum;
}

}  // namespace ups
