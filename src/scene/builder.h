// The making of a snapshot from a description, for prepare.cpp (surfaces, sensors, media),
// prepare_sources.cpp (what emits) and prepare_warnings.cpp.
#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "emitter/emitter.h"
#include "emitter/rays.h"
#include "scene/description.h"
#include "scene/snapshot.h"

namespace ups {

// Axes of a placed thing whose scale does not matter: z first, then x.
struct Axes {
  Vec3d x, y, z;
  explicit Axes(const Affine& m) : z(normalize(m.column(2))) {
    x = normalize(m.column(0) - z * dot(m.column(0), z));
    y = cross(z, x);
  }
  Frame frame() const { return {Vec3(x), Vec3(y), Vec3(z)}; }
};

// Errors of what is built inside say whose they are.
template <class Build>
void in_context(const std::string& name, const Build& build) {
  try {
    build();
  } catch (const Error& e) {
    throw Error(e.status(), name + ": " + e.what());
  }
}

class Builder {
 public:
  Builder(const Description& description, ThreadPool& threads)
      : in_(description), threads_(threads), out_(std::make_shared<Snapshot>()) {}

  std::shared_ptr<const Snapshot> build();

 private:
  void place();
  void add_materials();
  void add_geometry();
  void add_emissive_instances();
  void bound(Source& source, const std::vector<Vec3>& corners) const;
  void add_sources();
  void add_light(const std::string& name, const LightDescription& light, float dimming);
  void add_luminaire(const std::string& name, const LuminaireDescription& luminaire, float dimming);
  float opening_error(const Vec3& p, const Frame& frame, const photometry::Opening& opening) const;
  std::shared_ptr<const RaySet> rays_of(const LuminaireDescription& luminaire);
  void add_rays(const std::string& name, const LuminaireDescription& luminaire, const Rgb& scale);
  // size: of Snapshot::emitter_sizes.
  bool add_emitter(const std::string& name, std::unique_ptr<Emitter> emitter, const Vec3& probe, float size = 0);
  void add_sensors();
  MeterSet make_meters(const MetersDescription& meters) const;
  void find_media();
  void add_warnings();
  void warn_of_overlaps();
  void warn_of_triangles();
  void warn_of_swallowed_light();
  void warn_of_unit();
  void warn_of_maintenance();

  Affine to_scene(Affine m) const {
    m.m[3] -= out_->origin.x, m.m[7] -= out_->origin.y, m.m[11] -= out_->origin.z;
    return m;
  }
  Vec3 to_scene(const Vec3d& p) const { return Vec3(p - out_->origin); }
  void warn(std::string text) { out_->warnings.push_back(std::move(text)); }
  // Told once for all of a kind that share the text.
  void warn_of(const char* noun, uint32_t id, const std::string& text) { shared_warnings_[{noun, text}].push_back(id); }
  void warn_of(const Source& source, const std::string& text) {
    warn_of(source.kind == UPS_SOURCE_INSTANCE ? "instance" : "luminaire", source.id, text);
  }

  const Description& in_;
  ThreadPool& threads_;
  std::shared_ptr<Snapshot> out_;
  std::vector<Raytracer::Instance> instances_;
  std::vector<std::unique_ptr<Emitter>> emitters_;
  std::vector<Vec3> emitter_probes_;  // a point of each, off any surface
  std::vector<DiscIndex::Disc> openings_;
  uint32_t unmaintained_ = 0;  // lamps that are no luminaires
  std::map<const photometry::Photometry*, std::shared_ptr<const RaySet>> ray_sets_;  // one a profile
  std::map<std::pair<std::string, std::string>, std::vector<uint32_t>> shared_warnings_;  // ids by noun and text
};

}  // namespace ups
