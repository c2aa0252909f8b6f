// The techniques of Unified Path Sampling side by side, in the paper's order: unidirectional ones, inner connections,
// and density estimation. Each finds what it is worth and which others make the same path; the caller tests the edge
// that it makes, weighs and adds it up.
#pragma once
#include <optional>

#include "transport/light_vertex.h"
#include "transport/subpath.h"
#include "transport/technique.h"

namespace ups {

// Where path integration arrives at an eye's vertex: there, or beside it (UPS_PERTURBATION_ACTUAL).
struct Arrival {
  SurfacePoint surface;
  float ratio = 0;  // kernel over the density that the point was drawn with; 0: at the vertex itself
};

EyeEnd meter_end(const Vec3& p, float error, const Frame& frame, const MeterResponse& response,
                 const mis::EyeState& state, const MediaStack& media);
// As the choice of emitters sees it: a cosine counts where the response is one.
inline Receiver meter_receiver(const Vec3& p, const Vec3& n, const MeterResponse& response) {
  return {p, response.kind == UPS_METER_PLANAR ? n : Vec3()};
}

struct Contribution {
  Technique technique;
  uint32_t emitter = 0;
  Rgb value;            // without its weight; of a new edge without what its panes and nested media let pass
  mis::Classes others;  // for a new edge without panes
  Vec3 from, to;        // ends of a new edge
  const MediaStack* media = nullptr;  // around `from`; null: no new edge
  uint32_t mirror = none;             // a plane of FlatMirrors by way of which the edge goes, at:
  Vec3 at_mirror;
  double mis::Classes::*own = &mis::Classes::eye;  // its class

  mis::Classes relative(double pass) const {  // all techniques of the path, this one included
    mis::Classes all = pass * others;
    all.*own += 1;
    return all;
  }
  double weight(const Iteration& in, double pass) const {
    return in.weighted() ? mis::weight(pass == 1 ? others : pass * others) : 1.0;
  }
};
using Found = std::optional<Contribution>;

// How an eye walk came upon an emitter.
struct EyeHit {
  const mis::EyeState& state;  // of a vertex there
  const mis::Counts& counts;
  Receiver from;     // the vertex before
  Vec3 p, wo;        // the point, back along the walk
  double pdf_a;      // of p by the walk
  bool connectable;  // the vertex before could have sampled it
  uint32_t edges;
  Rgb carried;
  uint32_t image = none;  // of the emitter, that `from` has seen: the path is that of light straight from it
  double goes_on = 1;     // then: probability that the mirror's light goes this way
};
Found hit(const Iteration& in, const EyeHit& eye, uint32_t emitter, uint32_t primitive);                  // s = 0
// Light of one emitter, chosen with a probability; of it at the eye.
Found light_from(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,  // s = 1
                 const EmitterSet::Choice& choice, const Vec2& u_position);
// found_from: what an emitter of Plan::exact brings from there on is found elsewhere. u_choice: uniform again afterwards.
Found sample_light(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
                   double& u_choice, const Vec2& u_position, float found_from, bool far);
// The same by way of a flat mirror: choice: among the scene's images.
Found light_from_image(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
                       const EmitterChoice& choice, const Vec2& u_position);
Found sample_mirror(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,
                    double u_choice, const Vec2& u_position, float found_from, bool far);
// Is the new edge free, but for panes?
bool edge_free(const Snapshot& scene, const Contribution& c, WorkCounts& work, Passage& passage);
Found connect(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const Arrival& arrival,  // 2 <= s <= k
              const LightEnd& light, uint32_t emitter);
// About what that brings, unoccluded, where both ends are Lambertian: for a choice among light vertices.
// Zero only where it brings nothing.
float connection_estimate(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const LightVertex& light);
struct Splatted {
  Contribution contribution;
  uint32_t pixel;
};
std::optional<Splatted> splat(const Iteration& in, size_t camera, const LightEnd& light, uint32_t emitter);  // t = 1
// p: the light vertex's place.
Found merge(const Iteration& in, const mis::Counts& n, const EyeEnd& eye, const LightVertex& light, const Vec3& p,
            double radius);
// No wall stands between a vertex and a point of its surface within the merge radius, such as a thin one on a floor that
// goes on beyond it; looked for on the side of `side`.
bool nothing_between(const Snapshot& scene, const SurfacePoint& s, const Vec3& side, const Vec3& p, float error,
                     double radius, WorkCounts& work);
// t = 0 of a cell (eta 0), or a merge at a point meter's own disc: a light path of `edges` edges crosses it. reverse:
// density of its last direction backwards; flux: as the meter responds to it.
Contribution land(const Iteration& in, const mis::Counts& n, const mis::LightState& state, double eta, double area,
                  float reverse, double flux, uint32_t edges, uint32_t emitter);

}  // namespace ups
