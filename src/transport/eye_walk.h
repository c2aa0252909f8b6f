// One eye path: from a sensor's point through the scene, every technique at every vertex. Used by the eye pass.
#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "transport/eye_pass.h"
#include "transport/techniques.h"

namespace ups {

// What one eye path found. In double: a million photons may be merged at one of its vertices.
struct EyeTally {
  double rgb[3] = {};
  double direct = 0;  // luminance of the part with one edge
  double bias = 0;    // luminance; see MeterTally
  uint32_t hits = 0;  // of emitters by way of casters, a meter's
  float disc_m2 = 0, caustics = 0, caustics_met = 0, caustic_light = 0;  // see PixelMerges

  void add(const Rgb& v) { rgb[0] += v.r, rgb[1] += v.g, rgb[2] += v.b; }
  Rgb value() const { return {float(rgb[0]), float(rgb[1]), float(rgb[2])}; }
  PixelMerges merges() const { return {float(bias), disc_m2, caustics, caustics_met, caustic_light}; }
};

// A sensor as its eye paths know it.
struct EyeSensor {
  struct Disc {
    double radius = 0;  // 0: no merging
    const PhotonIndex* photons = nullptr;
  };
  bool camera = false, cell = false;
  MeterResponse response;   // a meter's
  mis::Counts counts;
  mis::EyeState own_point;  // a meter's
  Disc first, later;        // of merges at the first vertex that scatters, or at the meter's point; elsewhere
  LightPaths::Path light;  // that it connects to
  const MediaStack* media = nullptr;
  double* excess = nullptr;  // of this pixel or meter, where a pilot measures moments
  float direct_found_from = INFINITY, image_found_from = INFINITY;  // see DirectLight
  TechniqueTally* techniques = nullptr;  // of the camera, where asked for
  uint32_t pixel = 0;
  MeterTally* separated = nullptr;  // of the meter, a column of Plan::separation each, where asked for
  double share = 1;                 // of this eye path in the meter's reading
  bool counts_hits = false;         // a meter: by way of casters they alone bring light
  float own_area_m2 = 0;  // of a path that starts on what a pixel sees: what no other pixel of the iteration sees of it
};

class EyeWalk : Subpath<EyeWalk, TransportMode::radiance> {
 public:
  EyeWalk(const Iteration& in, const Photons& photons, const EyeSensor& sensor, const PathSampler& rng,
          WorkCounts& work)
      : Subpath(in, rng, work), photons_(photons), sensor_(sensor), edges_(kept_edges()), columns_(kept_columns()) {
    counts_ = sensor.counts;
    media_ = *sensor.media;
    if (counts_.connect > 0) prefetch(sensor.light.vertices, std::min(sensor.light.count, 8u));
  }

  // pdf_w: density of the direction.
  EyeTally from_camera(const Vec3& p, const Vec3& direction, float pdf_w);
  // A meter's point: next-event estimation, connections, then a walk in a direction that is drawn by its response.
  // error: of the point, which may lie on a surface.
  EyeTally from_meter(const Vec3& p, float error, const Frame& frame);
  // The same of a planar one on a surface, on the side of frame.n: photons stored there are merged.
  EyeTally from_surface(const SurfacePoint& surface, const Frame& frame);

 private:
  friend Subpath;
  using EyeEndOf = Method::EyeEnd;
  mis::EyeState first_state(float cos_in, double d2, double pass) const {
    return mis::eye_first(counts_, edge_.scatter.pdf, cos_in, d2, pass);
  }
  void gather_at_meter(EyeEnd& eye);
  void gather(const EyeEnd& eye);
  void walk();
  void hit_openings(uint32_t edges);
  void hit_emitter(uint32_t emitter, uint32_t primitive, const Vec3& p, float cos_in, float distance, uint32_t edges,
                   const Rgb& transmittance);
  // The edge by which the walk has come to the flat mirror that it has just left: where it runs into an emitter with an
  // image there, both edges are one.
  struct Bend {
    uint32_t plane = none;
    Edge edge;
    Receiver from;
    float distance = 0;  // to the mirror
    double pass = 1;
  };
  void note_bend();
  bool hit_image(uint32_t emitter, uint32_t primitive, const Vec3& p, float cos_in, float distance, uint32_t edges,
                 const Rgb& transmittance);  // false where there is none
  bool perturb(const EyeEnd& eye, Arrival& out);
  void look_for_light(const EyeEnd& eye, const Arrival& arrival, float direct_found_from, float image_found_from);
  void connect_one(const EyeEnd& eye, const Arrival& arrival);
  bool ask_photons(const EyeEnd& eye, PhotonIndex::Query& query);
  void count_disc(const EyeEnd& eye, double radius);
  void merge(const EyeEnd& eye, PhotonIndex::Query& query);
  uint32_t thin(const EyeEnd& eye, PhotonIndex::Query& query);
  class Holes;
  // Of a disc: how many times larger it is, and its share, each right in the mean.
  struct SolidPart {
    float over = 1, share = 1;
  };
  const SolidPart& solid_part(const EyeEnd& eye, double radius);  // tried once a vertex, where it is asked for
  SolidPart try_solid_part(const EyeEnd& eye, double radius);
  bool meet_beside(const EyeEnd& eye, const Vec3& offset, double radius, Arrival& out);
  // share: of how many photons it stands for.
  void merge_photon(const EyeEnd& eye, const PhotonIndex::Photon& photon, float d2, double radius, float share);
  LightEnd& light_end(uint32_t i);  // the light path's vertex as connections read it
  const EyeSensor::Disc& disc(const EyeEnd& eye) const {
    return eye.edges == 0 || (sensor_.camera && !scattered_) ? sensor_.first : sensor_.later;
  }

  // An edge of path integration that waits for its shadow ray.
  struct WaitingEdge {
    Contribution found;
    MediaStack media;
    Drop drop;
    double share;
    double size;      // lx or cd/m^2 that it brings if it is free
    bool far;         // to a directional emitter
    double part = 0;  // of what all those kept to its emitter would bring
  };
  static std::vector<WaitingEdge>& kept_edges();
  using Column = std::pair<uint32_t, MeterTally>;  // of Plan::separation, and what the path has brought it
  static std::vector<Column>& kept_columns();
  // Adds it up, or where it makes an edge keeps it until the path's end; `share` of it was chosen to stand for the whole.
  void offer(const Contribution& c, Drop drop, double share = 1);
  Vec3 place_of(const Contribution& c) const { return c.media ? c.from : last_met(); }
  void test_edges();  // of those kept
  void part_by_emitter(bool far);
  double size_of_certain_edges(bool far, int rays, double WaitingEdge::*size) const;
  void test_edge(const Contribution& c, Drop drop, double share);
  void add(const Contribution& c, const Rgb& unweighted, double pass, float weight, Drop drop);
  MeterTally& separated(uint32_t emitter);
  void keep_separated(uint32_t emitter, double lx, double direct, double bias);
  void add_separated();  // what was kept, once for the whole path

  const Photons& photons_;
  const EyeSensor& sensor_;
  EyeTally tally_;
  std::vector<WaitingEdge>& edges_;
  std::vector<Column>& columns_;  // few
  uint32_t tests_ = 0;  // of edges_, so far
  bool tells_sources_apart() const { return sensor_.separated && in_.plan.separation.columns.size() > 1; }
  // Those vertices of the light path that were asked for; a path may have many thousand.
  struct LightEnds {
    std::vector<uint32_t> place;  // by vertex; none: not yet made
    std::deque<LightEnd> ends;    // the first `used` are of this path
    uint32_t used = 0;
  };
  LightEnds* light_ends_ = nullptr;
  Bend bend_;
  float own_angle_sr_ = 0, seen_from_m_ = 0;  // a camera: what no other pixel of the iteration sees; along the path
  uint32_t counted_edges_ = none;             // to the vertex whose caustics are counted
  float counted_share_ = 0;                   // of its disc
  bool specular_ = false;   // a camera's path that its method lets see emitters: it was mirrored and refracted alone
  bool scattered_ = false;  // by a continuous lobe
  std::optional<SolidPart> solid_;  // of the vertex that photons are asked for
};

}  // namespace ups
