// The making of a snapshot from a description, for prepare.cpp (sensors, media), prepare_place.cpp, prepare_surfaces.cpp,
// prepare_contacts.cpp (emitters that touch glass), prepare_meters.cpp, prepare_sources.cpp (what emits) and
// prepare_warnings.cpp.
#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/monitor.h"
#include "base/parallel.h"
#include "emitter/area.h"
#include "emitter/emitter.h"
#include "emitter/profile.h"
#include "emitter/rays.h"
#include "scene/description.h"
#include "scene/snapshot.h"

namespace ups {

// Axes of a placed thing whose scale does not matter: z first, then x; of a mirrored one they are left-handed.
struct Axes {
  Vec3d x, y, z;
  explicit Axes(const Affine& m) : z(normalize(m.column(2))) {
    x = normalize(m.column(0) - z * dot(m.column(0), z));
    y = cross(z, x) * (m.determinant() < 0 ? -1.0 : 1.0);
  }
  Frame frame() const { return {Vec3(x), Vec3(y), Vec3(z)}; }
};

std::vector<EmitterTriangle> emitting_triangles(const Mesh& mesh, const Affine& to_scene);  // in prepare_sources.cpp

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
  Builder(const Description& description, ThreadPool& threads, const Snapshot* earlier, Monitor& monitor)
      : in_(description), threads_(threads), earlier_(earlier), monitor_(monitor),
        out_(std::make_shared<Snapshot>()) {}

  std::shared_ptr<const Snapshot> build();

 private:
  void list_surfaces();
  class Places;
  void place();
  void find_places(Places& places);
  void check_extent(Places& places);
  Places places_that_matter(const Places& places) const;
  void leave_out_far_surfaces(const Places& near, Places& places);
  bool sees_infinity() const;
  Box mesh_box(size_t mesh) const;
  void add_materials();
  Material make_material(const MaterialDescription& description);
  SurfaceTexturing make_texturing(uint32_t number, const MaterialDescription& description);
  const Texture* texture(ups_texture_id id);
  bool scatters_as_before(uint32_t material) const;
  void warn_of_transmittance(uint32_t number, const Material& material);
  void limit_ior(uint32_t number, Material& material);
  void add_geometry();
  void warn_of_inside_out();
  bool is_same_instance(size_t i) const;
  bool has_same_origin() const { return max_abs(earlier_->origin - out_->origin) == 0; }
  // Emitters that touch glass, and what is near enough to be touched.
  using SourceKey = std::pair<ups_source_kind, uint32_t>;
  double rounding_of_places() const;
  double contact_error() const;
  double contact_reach() const;
  ContactPart::Role emission(const Raytracer::Instance& instance) const;
  TouchableParts touchable_parts() const;
  std::map<SourceKey, Contact> possible_contacts(const TouchableParts& touchable) const;
  Box emission_box(const LuminaireDescription& luminaire) const;
  std::vector<EmittingPoint> points_of(const Contact& contact) const;
  TouchableParts find_contacts();
  void search_contacts(TouchableParts& touchable);
  void set_back_emitters();
  void trace_surfaces(const TouchableParts& touchable);
  const Contact* contact_of_source();
  Vec3 place_of(const LuminaireDescription& luminaire);
  void warn_of_contacts();
  void add_emissive_instances();
  void add_panes();
  void find_panes_and_what_they_lie_on();
  void bound(Source& source, const Mesh& mesh, const Affine& to_scene) const;  // in the scene's frame
  void add_sources();
  void add_light(const std::string& name, const LightDescription& light, const SourceDescription& source);
  void add_luminaire(const std::string& name, const LuminaireDescription& luminaire, const SourceDescription& source);
  float opening_error(const Vec3& p, const Frame& frame, const photometry::Opening& opening) const;
  Vec3 opening_place(const Vec3& p, const Frame& frame, const photometry::Opening& opening, float error,
                     const ProfileOpeningEmitter& emitter) const;
  std::shared_ptr<const RaySet> rays_of(const LuminaireDescription& luminaire);
  void add_rays(const std::string& name, const LuminaireDescription& luminaire, const SourceDescription& source,
                const Rgb& scale);
  using UnitEmitter = std::function<std::unique_ptr<Emitter>()>;
  // size: of Snapshot::emitter_sizes. unit: the same emitter of another flux, which no dimming changes.
  bool add_emitter(const std::string& name, std::shared_ptr<const Emitter> emitter, UnitEmitter unit, const Vec3& front,
                   const EmitterProbe& probe, float size = 0);
  // What is known of the source that was begun last; null: it was not there, or stood elsewhere.
  const EmitterProbe* known_probe(const SourceDescription& source) const;
  EmitterProbe probe_of(const SourceDescription& source, const std::function<EmitterProbe()>& find);
  using PlacedEmitter = std::function<std::unique_ptr<Emitter>(const Vec3& shift, const Rgb& scale)>;
  EmitterProbe place_probe(const SourceDescription& source, const Vec3& p, const PlacedEmitter& make_at);
  void find_exposed();
  void find_concentration();
  void add_sensors();
  void add_meter_set(uint32_t id, const std::function<MeterSet()>& make);
  MeterSet make_meters(const MetersDescription& meters) const;
  void note_glass_edges(uint32_t id, const MeterSet& meters);
  MeterSet make_surface_meters(uint32_t id, const SurfaceMetersDescription& meters);
  void find_media();
  bool sensors_are_same() const { return in_.sensors() == earlier_->described->sensors(); }
  void add_warnings();
  void share_searches();
  void warn_of_missing_uvs();
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
  const Snapshot* earlier_;  // may be null
  Monitor& monitor_;
  std::shared_ptr<Snapshot> out_;
  // As in the earlier build: the ray tracer; that, and how surfaces scatter; that, and where errors end.
  bool same_geometry_ = false, same_surfaces_ = false, same_places_ = false;
  bool same_emitters_ = false;  // they stand where they stood
  bool contacts_differ_ = false;  // from the earlier build's: emitters want to be set back, or no longer
  std::map<std::pair<ups_source_kind, uint32_t>, size_t> earlier_emitter_;  // index, by source
  std::vector<std::shared_ptr<const Emitter>> emitters_;
  std::vector<UnitEmitter> unit_emitters_;
  std::vector<Vec3> emitter_fronts_;  // a point of each, off any surface
  std::vector<DiscIndex::Disc> openings_;
  std::vector<std::pair<SourceKey, const Contact*>> touching_;  // of what emits
  std::set<uint32_t> far_surfaces_;  // ids of instances that are left out
  uint32_t unmaintained_ = 0;  // lamps that are no luminaires
  std::map<const photometry::Photometry*, std::shared_ptr<const RaySet>> ray_sets_;  // one a profile
  std::map<std::pair<std::string, std::string>, std::vector<uint32_t>> shared_warnings_;  // ids by noun and text
};

}  // namespace ups
