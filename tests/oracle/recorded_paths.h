// Real paths of the engine, both ends of them, and their local quantities computed anew from geometry, materials and
// emitters: what the oracle (slow_weights.h) needs to tell what the engine's weight should have been.
#pragma once
#include <optional>
#include <vector>

#include "replay_room.h"
#include "slow_weights.h"
#include "transport/eye_walk.h"
#include "transport/light_pass.h"
#include "transport/path_recorder.h"

namespace ups::test {

// A vertex of a walk; one without a surface is a meter's point, a camera's or an emitter's.
struct Node {
  Vec3d p, ng;
  Frame shading;
  std::optional<Bsdf> bsdf;
  float relative_ior = 1;
  uint32_t instance = none;
  float error = 0;     // of p
  bool delta = false;  // the walk went on by a delta lobe
  MeterResponse response;  // of a meter's point

  bool is_planar() const { return response.kind == UPS_METER_PLANAR; }
  Vec3 local(const Vec3d& w) const { return shading.to_local(Vec3(w)); }
};

struct Walked {
  Node start;
  uint32_t emitter = none;
  std::vector<Node> nodes;
};

// A path that a technique found. x_m of a merge is there twice: the photon, and what it was merged to.
struct Replayed {
  SensorType sensor = SensorType::camera;
  bool of_pixel = false;  // the camera's, or the meter on what a pixel sees
  uint32_t pixel = 0, set = 0;
  Technique technique = Technique::hit;
  int at = 0;  // as Term
  uint32_t emitter = 0;
  bool lifted = true;                  // x_0 may lie off its surface, as rays start
  std::vector<Node> by_light, by_eye;  // x_0 ... from the one, ... x_k from the other
  mis::Classes found;                  // by the engine, this technique included
};

// Local quantities of a path, by definition. mirrors: light that a flat mirror reflects straight from an emitter counts as
// that of an emitter behind it: the path is one edge shorter.
class LocalQuantities {
 public:
  LocalQuantities(const Room& room, const EmissionGuide& guide, const Replayed& r, bool mirrors)
      : room_(room), guide_(guide), r_(r) {
    const int s = int(r.by_light.size()), t = int(r.by_eye.size());
    const bool merge = r.technique == Technique::merge;
    path_.k = s + t - (merge ? 2 : 1);
    for (int i = 0; i < s; ++i) near_.push_back(&r.by_light[i]), far_.push_back(&r.by_light[i]);
    if (merge) near_.pop_back();
    for (int i = 0; i < t; ++i) {
      near_.push_back(&r.by_eye[i]);
      if (!(merge && i == 0)) far_.push_back(&r.by_eye[i]);
    }
    if (mirrors) unfold();
    path_.sensor = r.sensor;
    path_.cell_area = r.sensor == SensorType::cell ? room.scene->meter_sets[r.set].area(0) : 1;
    resize();
    emission();
    for (int i = 0; i < path_.k; ++i) edge(i);
    for (int i = 1; i < path_.k; ++i) scattering(i);
    sensor();
    if (mirror_) path_.pdf_to_emitter[1] *= mirrored_share();
  }
  const Path& path() const { return path_; }
  const Vec3d& x_0() const { return x_0_; }
  bool panes_crossed() const {
    return std::any_of(path_.pass.begin(), path_.pass.end(), [](double p) { return p < 1; });
  }
  bool resolved() const { return resolved_; }  // every delta lobe was found again
  bool of_image() const { return mirror_ != nullptr; }

 private:
  // As vertices that edge i leaves towards the sensor, and that edge i - 1 reaches.
  const Node& near(int i) const { return *near_[i]; }
  const Node& far(int i) const { return *far_[i]; }
  const Snapshot& scene() const { return *room_.scene; }

  // x_1 is left out where it is such a mirror.
  void unfold() {
    const FlatMirrors& all = scene().flat_mirrors;
    if (path_.k < 2 || !far(1).bsdf || !near(1).delta) return;
    const std::vector<uint32_t>& planes = all.planes_of_instance[far(1).instance];
    if (planes.empty() || (image_ = all.image_of(r_.emitter, planes[0])) == none) return;
    mirror_ = &all.planes[planes[0]];
    at_mirror_ = far(1).p;
    near_.erase(near_.begin() + 1), far_.erase(far_.begin() + 1);
    --path_.k;
  }

  void resize() {
    const size_t k = size_t(path_.k);
    direction_.resize(k), path_.distance.resize(k), path_.cos_near.resize(k), path_.cos_far.resize(k);
    path_.pass.resize(k, 1);
    path_.delta.resize(k + 1), path_.merges.resize(k + 1), path_.caster.resize(k + 1);
    path_.pdf_to_sensor.resize(k + 1, 1), path_.pdf_to_emitter.resize(k + 1, 1), path_.jacobian.resize(k + 1, 1);
  }

  void emission() {
    const Emitter& e = scene().emitters[r_.emitter];
    const Node& x_1 = far(1);
    const Vec3 place(x_1.p), reference = mirror_ ? mirror_->mirrored(place) : place;
    path_.emission_a = guide_.probability(scene().emitters, r_.emitter);
    const auto choose = [&](const Vec3d& away) {  // away: from the emitter
      const bool meter = !x_1.bsdf;
      const Vec3d n = meter || dot(away, x_1.ng) < 0 ? x_1.ng : -x_1.ng;
      const Receiver at{place, x_1.is_planar() ? Vec3(n) : Vec3(), !meter && x_1.bsdf->transmits_continuously()};
      return double(mirror_ ? image_probability(scene(), at, image_)
                            : scene().emitters.direct_probability(at, r_.emitter));
    };
    DirectSample s;
    if (e.is_delta()) e.sample_direct(reference, {0.5f, 0.5f}, s);
    const Vec3d& towards = mirror_ ? at_mirror_ : x_1.p;
    const auto arriving = [&](const Vec3d& d) { return mirror_ ? normalize(x_1.p - at_mirror_) : d; };
    if (e.is_directional()) {
      path_.emitter = EmitterType::directional;
      x_0_ = towards + Vec3d(s.wi) * (4.0 * scene().radius);
      const double guided = guide_.factor(scene().emitters, r_.emitter, reference, 0, -s.wi);
      path_.disc_area = 1 / (s.pdf_position_a * guided);
      path_.nee_a = choose(arriving(-Vec3d(s.wi)));
    } else if (e.is_delta()) {
      path_.emitter = EmitterType::point;
      x_0_ = Vec3d(e.center());
      const Vec3d d = normalize(towards - x_0_);
      path_.pdf_to_sensor[0] =
          double(s.pdf_direction_w) * guide_.factor(scene().emitters, r_.emitter, Vec3(x_0_), 0, Vec3(d));
      path_.nee_a = choose(arriving(d));
    } else {
      path_.emitter = EmitterType::area;
      x_0_ = near(0).p;
      const uint32_t primitive = find_surface();
      const Vec3d d = normalize(towards - x_0_);
      EmitterHit hit;
      resolved_ = e.eval_hit(reference, Vec3(x_0_), primitive, Vec3(d), hit);
      path_.emission_a *= hit.pdf_position_a;
      path_.pdf_to_sensor[0] =
          double(hit.pdf_direction_w) * guide_.factor(scene().emitters, r_.emitter, Vec3(x_0_), primitive, Vec3(d));
      path_.nee_a = choose(arriving(d)) * hit.pdf_nee_a;
    }
    if (mirror_) path_.pdf_to_sensor[0] *= mirrored_share(), path_.disc_area /= mirrored_share();
  }

  // Of a luminous opening, a box along the axes: the face that x_0 lies on, either side of it.
  Vec3d face_of_opening() const {
    const Emitter& e = scene().emitters[r_.emitter];
    const Vec3d from_center = x_0_ - Vec3d(e.center());
    Vec3d face;
    double least = INFINITY;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
      const double beside = std::abs(std::abs(dot(from_center, Vec3d(axis))) - double(e.reach(axis)));
      if (beside < least) least = beside, face = Vec3d(axis);
    }
    return face;
  }

  // The triangle that x_0 lies on, which puts it exactly there, and its normal; openings are no surface.
  uint32_t find_surface() {
    n_0_ = face_of_opening();
    const auto& emitters = scene().emitter_of_instance;
    const size_t instance = size_t(std::find(emitters.begin(), emitters.end(), r_.emitter) - emitters.begin());
    if (instance == emitters.size()) return 0;
    const Mesh& mesh = *scene().meshes[instance];  // each has its own, and stands where it is
    uint32_t nearest = 0;
    double least = INFINITY, height = 0;
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
      Vec3d p[3];
      for (int c = 0; c < 3; ++c) p[c] = Vec3d(mesh.positions[mesh.indices[3 * t + uint32_t(c)]]) - scene().origin;
      const Vec3d n = normalize(cross(p[1] - p[0], p[2] - p[0]));
      const double above = dot(x_0_ - p[0], n);
      double beside = std::abs(above);
      for (int c = 0; c < 3; ++c) {
        const Vec3d side = normalize(p[(c + 1) % 3] - p[c]);
        beside = std::max(beside, dot(x_0_ - p[c], cross(side, n)));
      }
      if (beside >= least) continue;
      least = beside, height = above, nearest = t, n_0_ = n;
    }
    if (r_.lifted) x_0_ = x_0_ - n_0_ * height;
    return nearest;
  }

  double mirrored_share() const {
    const Vec3d n(mirror_->n), d = normalize(far(1).p - at_mirror_);
    return double(mirror_lobe(scene().materials[mirror_->material], float(std::abs(dot(d, n)))).probability);
  }

  void edge(int i) {
    const bool folded = i == 0 && mirror_;
    if (folded) cross_panes(0, x_0_, at_mirror_);
    const Vec3d from = folded ? at_mirror_ : i == 0 ? x_0_ : near(i).p, to = far(i + 1).p, w = to - from;
    const double distance = length(w);
    const Vec3d d = direction_[i] = w / distance;
    path_.distance[i] = distance + (folded ? length(at_mirror_ - x_0_) : 0);
    const Vec3d leaves = folded ? normalize(at_mirror_ - x_0_) : d;
    path_.cos_near[i] =
        i == 0 && path_.emitter != EmitterType::area ? 1 : std::abs(dot(leaves, i == 0 ? n_0_ : near(i).ng));
    path_.cos_far[i] = far(i + 1).response.across ? 1 : std::abs(dot(d, far(i + 1).ng));
    cross_panes(i, from, to);
  }
  void cross_panes(int i, const Vec3d& from, const Vec3d& to) {
    const double distance = length(to - from);
    const Vec3d d = (to - from) / distance;
    for (const Pane& pane : room_.panes) {
      const Vec3d n = normalize(cross(pane.u, pane.v));
      const double cosine = dot(d, n), t = dot(pane.corner - from, n) / cosine;
      if (!(t * std::abs(cosine) > 1e-5 && (distance - t) * std::abs(cosine) > 1e-5)) continue;
      const Vec3d at = from + d * t - pane.corner;
      const double u = dot(at, cross(pane.v, n)) / dot(pane.u, cross(pane.v, n)),
                   v = dot(at, cross(pane.u, n)) / dot(pane.v, cross(pane.u, n));
      if (u < 0 || u > 1 || v < 0 || v > 1) continue;
      path_.pass[i] *= 1 - double(cross_pane(scene().materials[pane.material], float(std::abs(cosine))).reflected);
    }
  }

  void scattering(int i) {
    const Node& x = near(i);
    const Vec3 to_emitter = x.local(-direction_[i - 1]), to_sensor = x.local(direction_[i]);
    path_.delta[i] = x.delta;
    path_.merges[i] = x.bsdf->has_continuous() || !x.bsdf->has_delta();
    path_.caster[i] = x.delta || x.bsdf->is_caster();
    if (x.delta) {
      path_.pdf_to_sensor[i] = delta_probability(x, to_emitter, to_sensor);
      path_.pdf_to_emitter[i] = delta_probability(x, to_sensor, to_emitter);
      const double n_e = to_emitter.z > 0 ? 1 : x.relative_ior, n_s = to_sensor.z > 0 ? 1 : x.relative_ior;
      path_.jacobian[i] = (n_e * n_e * std::abs(to_emitter.z)) / (n_s * n_s * std::abs(to_sensor.z));
    } else {
      path_.pdf_to_sensor[i] = x.bsdf->pdf(to_emitter, to_sensor);
      path_.pdf_to_emitter[i] = x.bsdf->pdf(to_sensor, to_emitter);
    }
  }
  // Of the lobe from wo that leads to wi.
  double delta_probability(const Node& x, const Vec3& wo, const Vec3& wi) {
    for (const float u : {0.0f, 0x1.fffffep-1f, 0.01f, 0.5f, 0.99f}) {
      BsdfSample s;
      if (x.bsdf->sample(wo, u, {0.5f, 0.5f}, TransportMode::radiance, s) && s.delta && length(s.wi - wi) < 0.05f)
        return s.pdf;
    }
    resolved_ = false;
    return 1;
  }

  void sensor() {
    const int k = path_.k;
    const Vec3d d = direction_[k - 1];
    path_.pdf_to_emitter[k] = path_.camera() ? double(scene().cameras[0].pdf_w(Vec3(-d))) : response_pdf(far(k), -d);
  }
  // In proportion to how a meter's kind responds.
  static double response_pdf(const Node& meter, const Vec3d& w) {
    const double sine = std::hypot(w.x, w.y), facing = std::hypot(meter.ng.x, meter.ng.y),
                 cosine = dot(w, meter.ng);
    switch (meter.response.kind) {
      case UPS_METER_CYLINDRICAL: return sine / (pi_d * pi_d);
      case UPS_METER_SEMICYLINDRICAL:
        return (sine + (w.x * meter.ng.x + w.y * meter.ng.y) / facing) / (pi_d * pi_d);
      case UPS_METER_HEMISPHERICAL: return std::max(0.0, (1 + cosine) / (3 * pi_d));
      case UPS_METER_SPHERICAL: return 1 / (4 * pi_d);
      case UPS_METER_VECTOR: return dot(w, Vec3d(axis_of_side(meter.response.side))) / pi_d;
      default: return std::abs(cosine) / pi_d;
    }
  }

  const Room& room_;
  const EmissionGuide& guide_;
  const Replayed& r_;
  Path path_;
  std::vector<const Node*> near_, far_;
  std::vector<Vec3d> direction_;
  Vec3d x_0_, n_0_;
  const FlatMirrors::Plane* mirror_ = nullptr;  // that was unfolded
  uint32_t image_ = none;
  Vec3d at_mirror_;
  bool resolved_ = true;
};

// Puts what walks met and techniques found together to whole paths.
class Recorder : public PathRecorder {
 public:
  explicit Recorder(const Room& room) : room_(room) {}
  std::vector<Replayed> paths;
  bool of_pixels = true;  // the eye pass that runs: of images, or of meters
  uint32_t meter_set = 0;  // of these

  void start_light(uint32_t emitter, const EmissionSample& start, const Rgb&) override {
    light_.push_back({{.p = Vec3d(start.p), .error = error_of(emitter)}, emitter, {}});
    current_ = &light_.back();
  }
  void start_eye(const EyeSensor& sensor, const Vec3& p, const Vec3& n, float error) override {
    eye_ = {{.p = Vec3d(p), .ng = Vec3d(n), .error = error, .response = sensor.response}, none, {}};
    current_ = &eye_;
    sensor_ = sensor.camera ? SensorType::camera : sensor.cell ? SensorType::cell : SensorType::point_meter;
    pixel_ = sensor.pixel;
    first_light_vertex_ = sensor.light.first;
  }
  void meet(const Encounter& met) override {
    const SurfacePoint& s = met.surface;
    current_->nodes.push_back(
        {Vec3d(s.p), Vec3d(s.ng), s.shading, met.bsdf(*room_.scene), met.relative_ior, s.instance, s.error, false});
  }
  void scatter(const BsdfSample& lobe, float, const Rgb&) override { current_->nodes.back().delta = lobe.delta; }
  void store() override { stored_.push_back({light_.size() - 1, current_->nodes.size()}); }

  void found(const Contribution& c, const Brought& brought, uint32_t photon) override {
    const uint32_t k = c.technique.edges, s = c.technique.s;
    Replayed r = begin(c, brought.pass);
    if (photon != none) {
      r.technique = Technique::merge, r.at = int(s) - 1;
      add_light(light_[stored_[photon].first], s - 1, r);
      add_eye(k - s + 1, r);
    } else if (s == 0) {
      if (eye_.nodes.size() < k) return;  // an opening before the sky
      r.technique = Technique::hit;
      add_hit(c.emitter, k, r);
    } else if (s == 1) {
      r.technique = Technique::light_sample, r.at = 1;
      r.by_light.push_back({.p = Vec3d(c.to), .error = error_of(c.emitter)});
      if (c.mirror != none) r.by_light.push_back(mirror_of(c));
      add_eye(k - uint32_t(r.by_light.size()), r);
    } else {
      r.technique = s == k ? Technique::sensor_connect : Technique::connect, r.at = int(s);
      add_light(light_[stored_[first_light_vertex_].first], s - 1, r);
      r.by_light.back().delta = false;  // however that walk went on
      add_eye(k - s, r);
    }
    paths.push_back(std::move(r));
  }
  void splatted(const Contribution& c, const Brought& brought, size_t, uint32_t pixel) override {
    Replayed r = begin(c, brought.pass);
    r.sensor = SensorType::camera, r.of_pixel = true, r.pixel = pixel;
    r.technique = Technique::sensor_connect, r.at = int(c.technique.s);
    add_light(light_.back(), c.technique.edges - 1, r);
    r.by_eye.push_back({.p = Vec3d(room_.scene->cameras[0].position())});
    paths.push_back(std::move(r));
  }
  void landed(const Contribution& c, const Brought&, const Vec3& p, uint32_t set, uint32_t meter) override {
    Replayed r = begin(c, 1);
    const bool cell = room_.scene->meter_sets[set].is_cell();
    r.sensor = cell ? SensorType::cell : SensorType::point_meter;
    r.of_pixel = false, r.set = set;
    r.technique = cell ? Technique::land : Technique::merge;
    r.at = int(c.technique.edges) + (cell ? 1 : 0);
    add_light(light_.back(), c.technique.edges - 1, r);
    const MeterSet& meters = room_.scene->meter_sets[set];
    const Node at{.p = Vec3d(p), .ng = Vec3d(meters.piece(meter, 0).frame.n), .response = meters.response(meter)};
    r.by_light.push_back(at);
    if (!cell) r.by_eye.push_back(at);
    paths.push_back(std::move(r));
  }

 private:
  Replayed begin(const Contribution& c, double pass) const {
    Replayed r;
    r.sensor = sensor_, r.of_pixel = of_pixels, r.pixel = pixel_, r.emitter = c.emitter, r.found = c.relative(pass);
    r.set = meter_set;
    return r;
  }
  Node mirror_of(const Contribution& c) const {
    const auto& planes = room_.scene->flat_mirrors.planes_of_instance;
    const FlatMirrors::Plane& plane = room_.scene->flat_mirrors.planes[c.mirror];
    const auto is_there = [&](const std::vector<uint32_t>& of) { return !of.empty() && of[0] == c.mirror; };
    Node node{.p = Vec3d(c.at_mirror), .ng = Vec3d(plane.n), .shading = Frame(plane.n), .delta = true};
    node.bsdf.emplace(room_.scene->materials[plane.material], Vec2());
    node.instance = uint32_t(std::find_if(planes.begin(), planes.end(), is_there) - planes.begin());
    node.error = plane.error;
    return node;
  }
  float error_of(uint32_t emitter) const {
    EmissionSample s;
    room_.scene->emitters[emitter].sample_emission({0.5f, 0.5f}, {0.3f, 0.4f}, s);
    return s.error;
  }
  static void add_light(const Walked& light, size_t nodes, Replayed& r) {
    r.by_light.push_back(light.start);
    r.by_light.insert(r.by_light.end(), light.nodes.begin(), light.nodes.begin() + ptrdiff_t(nodes));
  }
  // The sensor's point and what the walk met first, from x_{k - nodes} on.
  void add_eye(size_t nodes, Replayed& r) const {
    for (size_t i = nodes; i-- > 0;) r.by_eye.push_back(eye_.nodes[i]);
    r.by_eye.push_back(eye_.start);
  }
  // Where a line from outside enters a luminous opening, a box along the axes: in d.
  static double entry_of(const Emitter& box, const Vec3d& from, const Vec3d& d) {
    double entry = 0;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
      const double along = dot(d, Vec3d(axis)), far = dot(Vec3d(box.center()) - from, Vec3d(axis)),
                   half = double(box.reach(axis));
      if (along != 0) entry = std::max(entry, std::min((far - half) / along, (far + half) / along));
    }
    return entry;
  }
  // What was hit may be an opening on the way to the vertex that was met.
  void add_hit(uint32_t emitter, size_t k, Replayed& r) const {
    const Node& met = eye_.nodes[k - 1];
    Node x_0{.p = met.p, .error = met.error};
    const Snapshot& scene = *room_.scene;
    if (scene.emitter_of_instance[met.instance] != emitter) {
      const Vec3d from = k > 1 ? eye_.nodes[k - 2].p : eye_.start.p, d = met.p - from;
      x_0.p = from + d * entry_of(scene.emitters[emitter], from, d);
    }
    r.by_eye.push_back(x_0);
    add_eye(k - 1, r);
  }

  const Room& room_;
  std::vector<Walked> light_;
  std::vector<std::pair<size_t, size_t>> stored_;  // light path and depth
  Walked eye_;
  Walked* current_ = nullptr;
  SensorType sensor_ = SensorType::camera;
  uint32_t pixel_ = 0, first_light_vertex_ = 0;
};

}  // namespace ups::test
