// The balance-heuristic weights of all techniques, in constant memory a vertex. Pure: no scene, no random numbers.
// tests/oracle proves every function here equal to the slow, obvious definition.
//
// Path x_0 (emitter) ... x_k (sensor), k edges. Technique s connects the first s vertices of a light path with the last
// k+1-s of an eye path; a merge at x_m joins a light path of m edges to an eye path at x_m. Their densities a sample:
//   p(s)    = n_s * prod_{i<s} pf_i * prod_{i>=s} pb_i          (s = 1 uses pn_0 for pf_0)
//   p(m)    = eta * prod_{i<=m} pf_i * prod_{i>=m} pb_i,        eta = N pi r^2
// pf, pb: area densities of the light walk and the eye walk. The extended path space in which both are comparable:
// Hachisuka, Pantaleoni, Jensen 2012, Eq. 7 to 15, the kernel 1/(pi r^2) divided out (also Georgiev et al. 2012).
// Recurrences in the manner of van Antwerpen 2011, split by class of technique.
//
// `pass` of an edge: the probability that a walk along it goes on through all panes that it crosses. It is the same for
// both walks, and part of every density of a direction; so it cancels but for the technique that makes the edge itself.
// Everything is a sum of non-negative terms; Russian roulette is in none of the densities.
#pragma once

namespace ups::mis {

// Densities of techniques that make the same path, relative to one of them, times their counts: summed by class.
struct Classes {
  double eye = 0;      // s = 0 and 1: hits, next-event estimation
  double connect = 0;  // inner edges
  double light = 0;    // t = 1 and 0: splats, landings
  double caustic = 0;  // merges where the light path has met nothing but casters before
  double merge = 0;    // all others

  double sum() const { return eye + connect + light + caustic + merge; }
  Classes& operator+=(const Classes& o) {
    eye += o.eye, connect += o.connect, light += o.light, caustic += o.caustic, merge += o.merge;
    return *this;
  }
  friend Classes operator*(double f, const Classes& c) {
    return {f * c.eye, f * c.connect, f * c.light, f * c.caustic, f * c.merge};
  }
};

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
  double merge_all = 1;  // 0: photons are merged only where their path has met nothing but casters before
};

// Gates that both walks know: no merging of photons straight from an emitter, and no t = 1 for k = 2, where next-event
// estimation covers those paths better. Only for technique sets that contain it, and emitters that it can sample.
struct Gates {
  bool merge_at_first = true;           // g_1
  bool sensor_connect_at_first = true;  // t = 1 with k = 2
};

// A merge's density belongs to one of two classes.
inline void add_merge(Classes& c, double density, bool caustic, const Counts& n) {
  if (caustic)
    c.caustic += density;
  else
    c.merge += n.merge_all * density;
}

// ---- light walk -----------------------------------------------------------------------------------------------------

// At a vertex. Connections and merges without their counts: these may differ by sensor.
struct LightState {
  double inverse_density = 0;  // 1 / pf of this vertex, over path_split for the first: times n_1 pn_0 / pf_0
  double by_connection = 0, by_caustic = 0, by_merge = 0;  // techniques at earlier vertices
  double by_eye = 0;                                       // hits, and next-event estimation at x_1
  bool first = true;                                       // this vertex is x_1
  bool casters = true;  // the vertices before this one, if any, scattered as casters do
};

// x_1 as seen from an emitter. nee_over_emit = pn_0 / pf_0; d2 = squared distance, cos_1 = |cosine| at x_1.
// hittable: an eye path can run into the emitter; then pf_0 = area density of x_0, cos_0 the cosine there.
inline LightState light_first(const Counts& n, double nee_over_emit, double pdf_direction_w, double d2, double cos_1,
                              double pass, bool hittable, double cos_0, double pf_0) {
  const double inv = 1.0 / (pdf_direction_w * cos_1);
  return {.inverse_density = n.light_sample * nee_over_emit * d2 * inv / pass,
          .by_eye = hittable ? n.hit * cos_0 * inv / pf_0 : 0.0};
}

// x_1 lit by a directional emitter whose light starts on a disc of area disc_area.
inline LightState light_first_directional(const Counts& n, double nee_over_emit, double disc_area, double cos_1,
                                          double pass) {
  return {.inverse_density = n.light_sample * nee_over_emit * disc_area / (cos_1 * pass)};
}

// Scattering at a vertex and the edge to the next, as both walks know it.
struct Scatter {
  double pdf = 0, pdf_reverse = 0;  // per solid angle
  double cos_out = 1;               // geometric, at the vertex
  bool merge = false;               // merging is allowed at the vertex: its material's gate and, for x_1, Gates
  bool caster = false;              // the vertex scatters as casters do: by a delta or a glossy lobe
};

// By a continuous lobe at x_a, then the edge to x_{a+1}.
inline LightState light_step(const LightState& s, const Scatter& v, double cos_in, double d2, double pass) {
  const double inv = 1.0 / (v.pdf * cos_in), rho = v.cos_out * inv, own = v.merge ? 1.0 : 0.0;
  return {.inverse_density = d2 * inv / pass,
          .by_connection = rho * ((s.first ? 0.0 : s.inverse_density) + v.pdf_reverse * s.by_connection),
          .by_caustic = rho * ((s.casters ? own : 0.0) + v.pdf_reverse * s.by_caustic),
          .by_merge = rho * ((s.casters ? 0.0 : own) + v.pdf_reverse * s.by_merge),
          .by_eye = rho * ((s.first ? s.inverse_density : 0.0) + v.pdf_reverse * s.by_eye),
          .first = false,
          .casters = s.casters && v.caster};
}

// A delta lobe. chi = pdf_reverse / pdf * BsdfSample::delta_jacobian, discrete probabilities.
inline LightState light_step_delta(const LightState& s, double chi, double cos_out, double cos_in) {
  const double f = cos_out / cos_in * chi;
  return {0.0, f * s.by_connection, f * s.by_caustic, f * s.by_merge, f * s.by_eye, false, s.casters};
}

// All techniques that use a shorter light path than one that ends at this vertex, relative to it.
inline Classes light_total(const LightState& s, const Counts& n, double pdf_reverse) {
  return {.eye = (s.first ? s.inverse_density : 0.0) + pdf_reverse * s.by_eye,
          .connect = n.connect * ((s.first ? 0.0 : s.inverse_density) + pdf_reverse * s.by_connection),
          .caustic = n.eta * pdf_reverse * s.by_caustic,
          .merge = n.merge_all * n.eta * pdf_reverse * s.by_merge};
}

// ---- eye walk -------------------------------------------------------------------------------------------------------

// At a vertex, or at a meter's own point, where pdf_reverse is 1. The newest terms stay apart for a step: the walk
// learns only at its end that its newest vertex is x_1.
struct EyeState {
  double by_connection = 0;   // the technique that connects to this vertex
  Classes before;             // settled
  double newest_merge = 0;    // at the vertex just left
  double newest_splat = 0;    // t = 1 at the vertex just left
  double caustic = 0;         // merges from which on, towards the light, all vertices but this one are casters
  double eta = 0;             // what a merge at this vertex counts
  bool splats = false;        // by_connection is t = 1
};

// A meter's own point z_1 = x_k, before any edge: eta_sensor = N pi r^2 with the radius there, 0 where photons are not
// merged; area of a cell.
inline EyeState at_meter(const Counts& n, double eta_sensor, double area) {
  return {.before = {.light = n.land * area}, .eta = eta_sensor};
}

// z_2 of a camera, whose own point is a pinhole.
inline EyeState eye_first(const Counts& n, double pdf_w, double cos_in, double d2, double pass) {
  return {.by_connection = n.sensor_connect * d2 / (pdf_w * cos_in * pass), .eta = n.eta_first, .splats = true};
}

inline EyeState eye_step(const EyeState& e, const Counts& n, const Scatter& v, double cos_in, double d2, double pass) {
  const double inv = 1.0 / (v.pdf * cos_in), rho = v.cos_out * inv;
  EyeState r;
  r.before = e.before;
  r.before.light += e.newest_splat;
  if (!v.caster) r.before.merge += n.merge_all * (e.caustic + e.newest_merge);
  r.before = rho * v.pdf_reverse * r.before;
  if (!e.splats) r.before.connect += rho * e.by_connection;
  if (v.caster) r.caustic = rho * v.pdf_reverse * (e.caustic + e.newest_merge);
  r.newest_merge = v.merge ? rho * e.eta : 0.0;
  r.newest_splat = e.splats ? rho * e.by_connection : 0.0;
  r.by_connection = n.connect * d2 * inv / pass;
  r.eta = n.eta;
  return r;
}

inline EyeState eye_step_delta(const EyeState& e, double chi, double cos_out, double cos_in) {
  const double f = cos_out / cos_in * chi;
  EyeState r;
  r.before = f * e.before;
  r.before.light += f * e.newest_splat;
  r.caustic = f * (e.caustic + e.newest_merge);
  r.eta = e.eta;
  return r;
}

// All techniques that use a shorter eye path than one that ends at this vertex, relative to it.
// caster: it and all vertices between it and the light are casters. first: it is x_1 (then t = 1 at it makes k = 2).
inline Classes eye_total(const EyeState& e, const Counts& n, const Gates& g, bool caster, bool first,
                         double pdf_reverse) {
  Classes c = e.before;
  add_merge(c, e.caustic + e.newest_merge, caster, n);
  c.light += e.newest_splat;
  c = pdf_reverse * c;
  if (!e.splats)
    c.connect += e.by_connection;
  else if (!first || g.sensor_connect_at_first)
    c.light += e.by_connection;
  return c;
}

// ---- techniques -----------------------------------------------------------------------------------------------------
// Each gives the other techniques that make its path, relative to itself; of those that make an edge, for an edge
// without panes: times the edge's `pass`. *_a: area densities, per solid angle times cosine over squared distance.

inline double weight(const Classes& others) { return 1.0 / (1.0 + others.sum()); }

// Eye path hits the emitter; e belongs to the vertex on the emitter. pn_0, pf_0: area densities of that point by
// next-event estimation (from x_1) and by emission; pdf_direction_w: emission towards x_1; pb_0: area density with
// which the eye walk found it, with the edge's pass. connectable: x_1 can sample x_0, so it scattered by a continuous
// lobe or is a meter's point.
inline Classes others_of_hit(const EyeState& e, const Counts& n, const Gates& g, double pn_0, double pf_0,
                             double pdf_direction_w, double pb_0, bool connectable) {
  Classes c = e.before;
  c.caustic += e.caustic + (g.merge_at_first ? e.newest_merge : 0.0);
  c.light += g.sensor_connect_at_first ? e.newest_splat : 0.0;  // there for k = 2 alone
  c = pf_0 * pdf_direction_w * c;
  c.eye += connectable ? n.light_sample * pn_0 / pb_0 : 0.0;
  return c;
}

// Next-event estimation at x_1, or k = 1 at a meter's own point: those that start from the emitter, over their density
// there; v: of x_1; merge with its g_1.
inline Classes from_emitter_at_light_sample(const EyeState& e, const Counts& n, const Gates& g, const Scatter& v) {
  Classes c = eye_total(e, n, g, v.caster, true, v.pdf_reverse);
  if (v.merge && g.merge_at_first) c.caustic += e.eta;
  return c;
}
// pb_0: density with which x_1 would have found x_0 by scattering (0: the emitter cannot be hit); pf_1: area density of
// x_1 by emission.
inline Classes others_of_light_sample(const Classes& from_emitter, const Counts& n, double pb_0, double pn_0,
                                      double pf_0, double pf_1) {
  const double own = 1.0 / (n.light_sample * pn_0);
  Classes c = pf_0 * pf_1 * own * from_emitter;
  c.eye += n.hit * pb_0 * own;
  return c;
}

// An edge between light vertex x_a and the next, the eye's: l and light of x_a, e and eye of the eye's, which may be a
// meter's own point. pb_light_a, pf_eye_a: of each by the other walk.
inline Classes others_of_connect(const LightState& l, const Scatter& light, const EyeState& e, const Scatter& eye,
                                 const Counts& n, double pb_light_a, double pf_eye_a) {
  Classes at_light = light_total(l, n, light.pdf_reverse);
  if (light.merge) add_merge(at_light, n.eta, l.casters, n);
  const bool caster = l.casters && light.caster;
  Classes at_eye = eye_total(e, n, {}, caster && eye.caster, false, eye.pdf_reverse);
  if (eye.merge) add_merge(at_eye, e.eta, caster, n);
  const double own = 1.0 / n.connect;
  Classes c = own * pb_light_a * at_light;
  c += own * pf_eye_a * at_eye;
  return c;
}

// An edge between light vertex x_{k-1} and a camera's own point.
inline Classes others_of_splat(const LightState& l, const Scatter& light, const Counts& n, double pb_light_a) {
  Classes c = light_total(l, n, light.pdf_reverse);
  if (light.merge) add_merge(c, n.eta_first, l.casters, n);
  return pb_light_a / n.sensor_connect * c;
}

// A merge at x_m; e and eye belong to the eye's vertex there or to a meter's own point. light_reverse: density of the
// light path's last direction backwards.
inline Classes others_of_merge(const LightState& l, double light_reverse, const EyeState& e, const Scatter& eye,
                               const Counts& n, const Gates& g) {
  Classes c = light_total(l, n, light_reverse);
  c += eye_total(e, n, g, l.casters && eye.caster, l.first, eye.pdf_reverse);
  return 1.0 / e.eta * c;
}

// A photon that crosses a cell of the given area (t = 0). Its own density is N pf_0..pf_k.
inline Classes others_of_land(const LightState& l, const Counts& n, double area, double light_reverse) {
  return 1.0 / (n.land * area) * light_total(l, n, light_reverse);
}

}  // namespace ups::mis
