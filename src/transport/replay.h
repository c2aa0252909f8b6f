// One path of a render traced again, with everything that happened to it: for people who want to know where a sample
// came from. Filled by Integrator::replay, told by render/replay.
#pragma once
#include <vector>

#include "transport/light_vertex.h"
#include "transport/path_recorder.h"
#include "transport/tally.h"
#include "transport/techniques.h"

namespace ups {

// Of a sample, within a render of a scene.
struct SampleAddress {
  bool camera = false;
  uint32_t sensor = 0;   // of the snapshot's cameras or sets of meters
  uint32_t element = 0;  // pixel or meter
  uint32_t iteration = 0;
  PathNumber path;
};

struct ReplayedVertex {
  Vec3 p, ng, ns;
  uint32_t instance = 0;
  float distance = 0, cos_in = 0;  // from the vertex before; to the geometric normal
  double pass = 1;                 // probability of having gone through the panes before it
  bool scattered = false;          // the walk went on, by:
  bool delta = false, transmitted = false;
  float pdf = 0, pdf_reverse = 0;  // per solid angle; of a delta lobe its probability
  float survival = 1;              // roulette's
  Rgb weight, carried;             // f cos / pdf; the throughput after it, roulette included
};

struct ReplayedWalk {
  bool light = false;
  uint32_t path = 0;  // running number of a light path
  Vec3 p, n;          // of its start; a point emitter's and a camera's normal is zero
  uint32_t emitter = 0;
  float pdf_position_a = 0, pdf_direction_w = 0;  // of a light path
  Rgb carried{1.0f};
  std::vector<ReplayedVertex> vertices;
};

struct ReplayedContribution {
  uint32_t kind = 0;  // UPS_TECHNIQUE_*
  Technique technique;
  uint32_t emitter = 0;
  Brought brought;
  mis::Classes relative;  // densities of all techniques over this one's
  bool has_edge = false;  // a new one, from `from` to `to`; of a mirror sample as far as the mirror
  Vec3 from, to;
  uint32_t light_path = none, light_vertex = 0;  // that it was joined to or merged with; edges from the emitter
  double value() const { return luminance(brought.unweighted) * brought.weight; }
};

struct Replayed {
  SampleAddress address;
  double value = -1;   // of the sample, lx or cd/m2, as the estimate gets it; -1: the render traced no such path
  double scale = 1;    // of contributions in it
  ReplayedWalk walk;
  std::vector<ReplayedContribution> contributions;  // the largest first
  size_t told = 0;                                  // of them, by told_share, least_told and most_told
  double untold_share = 0;                          // that the others bring
  std::vector<ReplayedWalk> light_paths;            // that these were joined to, each once
};

// So much of a sample is told in full, with the light paths that brought it, and so many contributions at least and at
// most, as all of these paths are kept.
inline constexpr double told_share = 0.99;
inline constexpr size_t least_told = 12, most_told = 1024;

// Writes down one walk.
class ReplayRecorder : public PathRecorder {
 public:
  // paths: what eye paths were joined to; null: the walk is a light path that brings light to the address.
  ReplayRecorder(const Iteration& in, const LightPaths* paths, const SampleAddress& address)
      : in_(in), paths_(paths), address_(address) {}
  ReplayedWalk walk;
  std::vector<ReplayedContribution> contributions;

  bool wants_all_edges() const override { return false; }
  void start_light(uint32_t emitter, const EmissionSample& start, const Rgb& carried) override;
  void start_eye(const EyeSensor& sensor, const Vec3& p, const Vec3& n, float error) override;
  void meet(const Encounter& met) override;
  void scatter(const BsdfSample& lobe, float survival, const Rgb& carried) override;
  void store() override {}
  void found(const Contribution& c, const Brought& brought, uint32_t photon) override;
  void splatted(const Contribution& c, const Brought& brought, size_t camera, uint32_t pixel) override;
  void landed(const Contribution& c, const Brought& brought, const Vec3& p, uint32_t set, uint32_t meter) override;

 private:
  ReplayedContribution& add(const Contribution& c, const Brought& brought, uint32_t kind);
  void join(uint32_t light_vertex, ReplayedContribution& out) const;  // to a stored one, by its number

  const Iteration& in_;
  const LightPaths* paths_;
  const SampleAddress address_;
  uint32_t first_light_vertex_ = 0;
};

}  // namespace ups
