// One eye path: from a sensor's point through the scene, every technique at every vertex. Used by the eye pass.
#pragma once
#include "transport/eye_pass.h"
#include "transport/sampler.h"
#include "transport/walk.h"

namespace ups {

// What one eye path found.
struct EyeTally {
  Rgb value;
  float direct = 0;  // luminance of the part with one edge
  float bias = 0;    // luminance; see MeterTally
};

class EyeWalk {
 public:
  struct Disc {
    float radius = 0;  // 0: no merging
    const PhotonIndex* photons = nullptr;
  };
  struct Sensor {
    bool camera = false, cell = false;
    mis::Counts counts;
    mis::SensorEnd end;
    Disc first, later;  // of merges at the first vertex that scatters, or at the meter's point; elsewhere
    uint32_t first_light_vertex = 0, end_light_vertex = 0;  // of the light path that it connects to
    MediaStack media;
    TechniqueTally* techniques = nullptr;  // of the camera, where asked for
    uint32_t pixel = 0;
    MeterTally* separated = nullptr;  // of the meter, a column of Plan::separation each, where asked for
    double share = 1;                 // of this eye path in the meter's reading
  };
  EyeWalk(const EyePassInput& in, const Sensor& sensor, const PathSampler& rng, WorkCounts& work)
      : in_(in), scene_(in.scene), sensor_(sensor), rng_(rng), work_(work), media_(sensor.media) {}

  // pdf_w: density of the direction; throughput: what a unit of radiance along it is worth.
  EyeTally from_camera(const Vec3& p, const Vec3& direction, float pdf_w);
  // A planar meter's point: next-event estimation, connections, then a cosine-weighted walk. ray_origin: p, off the
  // surface that it may lie on.
  EyeTally from_meter(const Vec3& p, const Vec3& ray_origin, const Frame& frame);
  // The same on a surface, on the side of frame.n: photons stored there are merged.
  EyeTally from_surface(const SurfacePoint& surface, const Frame& frame);

 private:
  struct Edge {
    enum { sensor, continuous, delta } kind = sensor;
    mis::EyeState state;
    bool merge = false;
    double pdf = 0, pdf_reverse = 0, cos_out = 1, chi = 0;
  };
  // A vertex on a surface, with what its techniques share.
  struct Vertex {
    SurfacePoint surface;
    Bsdf bsdf;
    Vec3 wo, local_wo;
    mis::EyeState state;
    bool merge;
    bool passes;     // SPPM: sampled further instead of merged at
    uint32_t edges;  // from the sensor
  };

  void walk();
  bool pass_on(const Rgb& share);  // false where the path ends as its throughput is no longer finite
  mis::EyeState arrive(float cos_in, float distance) const;
  void hit_openings(uint32_t edges);
  void hit_emitter(uint32_t emitter, uint32_t primitive, const Vec3& p, float cos_in, float distance, uint32_t edges,
                   const Rgb& transmittance);
  // Where path integration arrives at a vertex: there, or beside it (UPS_PERTURBATION_ACTUAL).
  struct Arrival {
    SurfacePoint surface;
    bool perturbed = false;
    float ratio = 1;  // kernel over the density that the point was drawn with
  };
  bool perturb(const Vertex& v, Arrival& out);
  static float perturbed_cosine(const Vertex& v, const Arrival& a, const Vec3& wi);
  void perturb_meter();
  EyeTally gather_at_meter();
  void sample_light(const Vertex& v, const Arrival& a);
  // What a technique found: by way of which vertices, from which emitter.
  struct Found {
    Technique technique;
    uint32_t emitter;
  };
  struct Connection {  // before its shadow ray
    Rgb value, unweighted;
    Vec3 from, to;
    uint32_t s = 0, edges = 0, emitter = 0;
  };
  struct PreparedLight {
    const LightVertex* vertex;
    SurfacePoint surface;
    Bsdf bsdf;
    Vec3 local_wo;
  };
  const std::vector<PreparedLight>& prepared_light();
  Connection connect(const Vertex& v, const Arrival& a, const PreparedLight& light) const;
  template <class Weigh>
  void connect_one(uint32_t vertex, const Weigh& weigh);
  void merge(const Vertex& v);
  bool scatter(const Vertex& v);
  void meter_sample_light();
  Connection meter_connect(const PreparedLight& light) const;
  void meter_merge(const SurfacePoint& surface);
  static bool same_surface(const SurfacePoint& s, const LightVertex& l, float radius);
  double photon_norm(double radius) const;  // 1 / (N pi r^2)

  bool longer_than_allowed(uint32_t edges) const {
    return in_.settings.max_path_length && edges > in_.settings.max_path_length;
  }
  bool add(const Found& found, const Rgb& unweighted, float weight, Drop drop) {
    return add(found, unweighted * weight, unweighted, drop);
  }
  bool add(const Found& found, const Rgb& value, const Rgb& unweighted, Drop drop) {
    if (!is_finite(value)) {
      work_.drop(drop);
      return false;
    }
    const bool is_direct = found.technique.edges == 1;
    tally_.value += value;
    if (is_direct) tally_.direct += luminance(value);
    if (sensor_.techniques) sensor_.techniques->add(found.technique, sensor_.pixel, value, unweighted);
    add_separated(found.emitter, {luminance(value), is_direct ? luminance(value) : 0.0, 0.0});
    return true;
  }
  void add_separated(uint32_t emitter, const MeterTally& part) {
    if (sensor_.separated) sensor_.separated[in_.plan.separation.column_of_emitter[emitter]].add(part, sensor_.share);
  }

  const EyePassInput& in_;
  const Snapshot& scene_;
  const Sensor& sensor_;
  PathSampler rng_;
  WorkCounts& work_;
  EyeTally tally_;

  Vec3 origin_, direction_;
  Receiver last_;  // the vertex that the current edge leaves; without normal at a camera
  Vec3 meter_p_, meter_origin_;  // where path integration arrives at a meter, and its rays' origin
  Frame meter_frame_;
  Rgb throughput_{1.0f}, start_throughput_{1.0f};
  Edge edge_;
  bool light_is_prepared_ = false;
  bool specular_ = false;  // a camera's path that scattered by delta lobes alone so far, in SPPM by glossy surfaces too
  MediaStack media_;  // at the last vertex
  Encounter met_;     // where the current edge ends; at its vertex: the media on both sides
};

}  // namespace ups
