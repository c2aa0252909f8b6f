// The balance-heuristic weights of all techniques, in constant memory a vertex. Pure: no scene, no random numbers.
// tests/oracle proves every function here equal to the slow, obvious definition.
//
// Path x_0 (emitter) ... x_k (sensor), k edges. Technique s connects the first s vertices of a light path with the last
// k+1-s of an eye path; a merge at x_m joins a light path of m edges to an eye path at x_m. Their densities a sample:
//   p(s)    = n_s * prod_{i<s} pf_i * prod_{i>=s} pb_i          (s = 1 uses pn_0 for pf_0)
//   p(m)    = eta * prod_{i<=m} pf_i * prod_{i>=m} pb_i,        eta = N pi r^2
// pf, pb: area densities of the light walk and the eye walk. The extended path space in which both are comparable:
// Hachisuka, Pantaleoni, Jensen 2012, Eq. 7 to 15, the kernel 1/(pi r^2) divided out (also Georgiev et al. 2012).
// Recurrences in the manner of van Antwerpen 2011, split by technique class so that a light vertex holds no counts:
//   dV          1/pf of this vertex (first vertex: times pn_0/pf_0)
//   Bc, Bm, Bp  sums over earlier techniques: connections, merges, {hit, next-event estimation}
// Everything is a sum of non-negative terms; Russian roulette is in none of the densities.
#pragma once

namespace ups::mis {

// How many samples each technique takes for one eye path. Zero switches a technique off.
struct Counts {
  double hit = 0;             // n_0: 0 or 1
  double light_sample = 0;    // n_1: 0 or 1
  double connect = 0;         // c: connections a split, also those from a meter's own point
  double sensor_connect = 0;  // N/Ke for a camera (t = 1); unused for meters
  double land = 0;            // N/Ke for a cell (t = 0), else 0
  // N pi r^2. Radii may differ by vertex if both walks know them: here the first vertex that scatters a camera's path
  // by a continuous lobe has its own (a pixel's), all others share one. A light vertex that is joined to an eye path is
  // beyond that first vertex, or is it.
  double eta_first = 0;
  double eta = 0;
};

// Gates that both walks know: no merging of photons straight from an emitter, and no t = 1 for k = 2, where next-event
// estimation covers those paths better. Only for technique sets that contain it,
// and scenes whose emitters it can sample.
struct Gates {
  bool merge_at_first = true;           // g_1
  bool sensor_connect_at_first = true;  // t = 1 with k = 2
};

// ---- light walk -----------------------------------------------------------------------------------------------------

struct LightState {
  double dV = 0, Bc = 0, Bm = 0, Bp = 0;
  bool first = true;  // this vertex is x_1
};

// x_1 as seen from an emitter. nee_over_emit = pn_0 / pf_0; d2 = squared distance, cos_1 = |cosine| at x_1.
// hittable: an eye path can run into the emitter; then pf_0 = area density of x_0, cos_0 the cosine there.
inline LightState light_first(const Counts& n, double nee_over_emit, double pdf_direction_w, double d2, double cos_1,
                              bool hittable, double cos_0, double pf_0) {
  LightState s;
  const double inv = 1.0 / (pdf_direction_w * cos_1);
  s.dV = n.light_sample * nee_over_emit * d2 * inv;
  s.Bp = hittable ? n.hit * cos_0 * inv / pf_0 : 0.0;
  return s;
}

// x_1 lit by a directional emitter whose light starts on a disc of area disc_area.
inline LightState light_first_directional(const Counts& n, double nee_over_emit, double disc_area, double cos_1) {
  LightState s;
  s.dV = n.light_sample * nee_over_emit * disc_area / cos_1;
  return s;
}

// Scattering by a continuous lobe at x_a, then the edge to x_{a+1}. merge: merging is allowed at x_a (its material's
// gate and, for x_1, Gates::merge_at_first). pdf, pdf_reverse per solid angle; cosines geometric.
inline LightState light_step(const LightState& s, bool merge, double pdf, double pdf_reverse, double cos_out,
                             double cos_in, double d2) {
  LightState r;
  const double inv = 1.0 / (pdf * cos_in), rho = cos_out * inv;
  r.Bm = rho * ((merge ? 1.0 : 0.0) + pdf_reverse * s.Bm);
  r.Bc = rho * ((s.first ? 0.0 : s.dV) + pdf_reverse * s.Bc);
  r.Bp = rho * ((s.first ? s.dV : 0.0) + pdf_reverse * s.Bp);
  r.dV = d2 * inv;
  r.first = false;
  return r;
}

// A delta lobe. chi = pdf_reverse / pdf * BsdfSample::delta_jacobian, discrete probabilities.
inline LightState light_step_delta(const LightState& s, double chi, double cos_out, double cos_in) {
  const double f = cos_out / cos_in * chi;
  return {0.0, f * s.Bc, f * s.Bm, f * s.Bp, false};
}

// Sum of all techniques that use a shorter light path than one that ends at this vertex, relative to it.
inline double light_total(const LightState& s, const Counts& n, double pdf_reverse) {
  return (s.first ? 1.0 : n.connect) * s.dV + pdf_reverse * (n.connect * s.Bc + n.eta * s.Bm + s.Bp);
}

// ---- eye walk -------------------------------------------------------------------------------------------------------

// The newest terms stay apart for a step: the walk learns only at its end that its newest vertex is x_1.
struct EyeState {
  double dE = 0;  // the technique that connects to this vertex
  double X = 0;   // settled
  double M = 0;   // merge at the vertex just left
  double Q = 0;   // t = 1 at the vertex just left
  bool second = true;  // this vertex is z_2, the first that the eye walk found
  bool first = false;  // no continuous lobe yet: merges here count eta_first
};

// What a merge at this vertex counts.
inline double eta_at(const Counts& n, const EyeState& e) { return e.first ? n.eta_first : n.eta; }

// At the sensor's own point z_1 = x_k, before any edge: techniques that end there, for U1 of the weights below.
// eta_sensor: N pi r^2 with the radius there; 0 where photons are not merged.
struct SensorEnd {
  double merge = 0;  // eta_sensor
  double land = 0;   // (N/Ke) / pb_k for cells, else 0
};
inline SensorEnd sensor_end(const Counts& n, double eta_sensor, double area) { return {eta_sensor, n.land * area}; }

// z_2 from the sensor. cos_out: at z_1 (1 for a pinhole, where U1 is 0). camera: dE counts t = 1 splats, else c.
inline EyeState eye_first(const Counts& n, bool camera, const SensorEnd& u, double pdf_w, double cos_out, double cos_in,
                          double d2) {
  EyeState e;
  const double inv = 1.0 / (pdf_w * cos_in);
  e.dE = (camera ? n.sensor_connect : n.connect) * d2 * inv;
  e.X = cos_out * inv * u.land;
  e.M = cos_out * inv * u.merge;
  e.first = camera;  // a meter's own point counts as the first
  return e;
}

inline EyeState eye_step(const EyeState& e, const Counts& n, bool camera, bool merge, double pdf, double pdf_reverse,
                         double cos_out, double cos_in, double d2) {
  EyeState r;
  const double inv = 1.0 / (pdf * cos_in), rho = cos_out * inv;
  const bool t1 = camera && e.second;
  r.X = rho * ((t1 ? 0.0 : e.dE) + pdf_reverse * (e.X + e.M + e.Q));
  r.M = merge ? rho * eta_at(n, e) : 0.0;
  r.Q = t1 ? rho * e.dE : 0.0;
  r.dE = n.connect * d2 * inv;
  r.second = false;
  return r;
}

inline EyeState eye_step_delta(const EyeState& e, double chi, double cos_out, double cos_in) {
  return {0.0, cos_out / cos_in * chi * (e.X + e.M + e.Q), 0.0, 0.0, false, e.first};
}

// Sum of all techniques that use a shorter eye path than one that ends at this vertex, relative to it.
// is_first: this vertex is x_1, so that t = 1 at it would make a path of k = 2.
inline double eye_total(const EyeState& e, const Gates& g, bool camera, bool is_first, double pdf_reverse) {
  const bool gated = is_first && camera && e.second && !g.sensor_connect_at_first;
  return (gated ? 0.0 : e.dE) + pdf_reverse * (e.X + e.M + e.Q);
}

// ---- weights --------------------------------------------------------------------------------------------------------
// *_w_to_a factors: cosine over squared distance on the joining edge.

// Eye path hits the emitter; e belongs to the vertex on the emitter. pn_0, pf_0: area densities of that point by
// next-event estimation (from x_1) and by emission; pdf_direction_w: emission towards x_1; pb_0: area density with
// which the eye walk found it. connectable: x_1 can sample x_0,
// so it scattered by a continuous lobe or is a meter's point.
inline double weight_hit(const EyeState& e, const Counts& n, const Gates& g, double pn_0, double pf_0,
                         double pdf_direction_w, double pb_0, bool connectable) {
  const double M = g.merge_at_first ? e.M : 0.0;
  const double Q = g.sensor_connect_at_first ? e.Q : 0.0;  // Q is there for k = 2 alone
  const double nee = connectable ? n.light_sample * pn_0 / pb_0 : 0.0;
  return 1.0 / (1.0 + nee + pf_0 * pdf_direction_w * (e.X + M + Q));
}

// Next-event estimation at x_1. pb_0: density with which x_1 would have found x_0 by scattering (0: the emitter cannot
// be hit); pf_1: area density of x_1 by emission; total: merge at x_1 plus eye_total,
// or U1 for a meter's own point (k = 1).
inline double weight_light_sample(const Counts& n, double pb_0, double pn_0, double pf_0, double pf_1, double total) {
  return 1.0 / (1.0 + (n.hit * pb_0 + pf_0 * pf_1 * total) / (n.light_sample * pn_0));
}

// U1 for k = 1 as seen by next-event estimation and hits: the merge there is one at x_1.
inline double sensor_total_direct(const SensorEnd& u, const Gates& g) {
  return (g.merge_at_first ? u.merge : 0.0) + u.land;
}

// An edge between light vertex x_a (merge gate g_light) and eye vertex x_{a+1}
// (gate g_eye), both not the sensor's point.
inline double weight_connect(const LightState& l, const EyeState& e, const Counts& n, bool g_light, bool g_eye,
                             double pb_light_a, double pdf_reverse_light, double pf_eye_a, double pdf_reverse_eye) {
  const double light = pb_light_a * ((g_light ? n.eta : 0.0) + light_total(l, n, pdf_reverse_light));
  const double eye = pf_eye_a * ((g_eye ? eta_at(n, e) : 0.0) + e.dE + pdf_reverse_eye * (e.X + e.M + e.Q));
  return 1.0 / (1.0 + (light + eye) / n.connect);
}

// An edge between light vertex x_{k-1} and the sensor's own point: a camera's splat (count N/Ke,
// u empty) or a meter (c).
inline double weight_sensor_connect(const LightState& l, const Counts& n, bool camera, const SensorEnd& u, bool g_light,
                                    double pb_light_a, double pdf_reverse_light, double pf_sensor_a) {
  const double count = camera ? n.sensor_connect : n.connect, eta = camera ? n.eta_first : n.eta;
  const double light = pb_light_a * ((g_light ? eta : 0.0) + light_total(l, n, pdf_reverse_light));
  return 1.0 / (1.0 + (light + pf_sensor_a * (u.merge + u.land)) / count);
}

// A merge at an eye vertex x_m; eta is eta_at() and `eye` eye_total() there.
inline double weight_merge(const LightState& l, const Counts& n, double eta, double pdf_reverse_light, double eye) {
  return eta / (eta + light_total(l, n, pdf_reverse_light) + eye);
}

// A merge at a meter's own point, whose radius may be another than that of its eye path's vertices: eta_sensor.
inline double weight_merge_at_sensor(const LightState& l, const Counts& n, double eta_sensor,
                                     double pdf_reverse_light) {
  return eta_sensor / (eta_sensor + light_total(l, n, pdf_reverse_light));
}

// A photon that crosses a cell of the given area (t = 0). Its own density is N pf_0..pf_k.
inline double weight_land(const LightState& l, const Counts& n, double area, double pdf_reverse_light) {
  return 1.0 / (1.0 + light_total(l, n, pdf_reverse_light) / (n.land * area));
}

}  // namespace ups::mis
