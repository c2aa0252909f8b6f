// UPS for C++17: what there is to light, what lights it, what measures; edits, commits, renders. See ups.hpp.
#ifndef UPS_HPP_SCENE_HPP
#define UPS_HPP_SCENE_HPP

#include "fixture.hpp"
#include "job.hpp"
#include "replay.hpp"

namespace ups {
inline namespace v0_1 {

// Many threads read, or one changes it. Edits take effect at the next commit; ids stay. Arrays of what get_ returns are
// the scene's: they are there until that thing is set or removed, or the scene ends.
class Scene : public Handle<ups_scene> {
 public:
  using Handle::Handle;
  explicit Scene(const Context &context) : Handle(detail::value<ups_scene *>(ups_scene_create, context.get())) {}

  // ---- textures, materials
  ups_texture_id add_texture(const TextureDesc &desc) {
    return detail::value<ups_texture_id>(ups_scene_add_texture, get(), &desc);
  }
  void set_texture(ups_texture_id id, const TextureDesc &desc) { check(ups_scene_set_texture(get(), id, &desc)); }
  // Without texels: read_texture has them.
  TextureDesc get_texture(ups_texture_id id) const { return desc<TextureDesc>(ups_scene_get_texture, id); }
  std::vector<float> read_texture(ups_texture_id id) const {
    return detail::list<float>(ups_scene_read_texture, get(), id);
  }
  void remove_texture(ups_texture_id id) { check(ups_scene_remove_texture(get(), id)); }

  ups_material_id add_material(const MaterialDesc &desc) {
    return detail::value<ups_material_id>(ups_scene_add_material, get(), &desc);
  }
  void set_material(ups_material_id id, const MaterialDesc &desc) {
    check(ups_scene_set_material(get(), id, &desc));
  }
  MaterialDesc get_material(ups_material_id id) const { return desc<MaterialDesc>(ups_scene_get_material, id); }
  void remove_material(ups_material_id id) { check(ups_scene_remove_material(get(), id)); }

  // ---- meshes, instances
  ups_mesh_id add_mesh(const MeshDesc &desc) {
    return detail::value<ups_mesh_id>(ups_scene_add_mesh, get(), &desc);
  }
  void set_mesh(ups_mesh_id id, const MeshDesc &desc) { check(ups_scene_set_mesh(get(), id, &desc)); }
  // 3 values a vertex; without normals these stay as they are.
  void set_mesh_vertices(ups_mesh_id id, Span<const float> positions_m, Span<const float> normals = {}) {
    const float *const n = detail::optional_array(normals, positions_m.size(), "normals");
    check(ups_scene_set_mesh_vertices(get(), id, positions_m.data(), n,
                                      detail::count(positions_m.size(), 3, "positions_m")));
  }
  MeshDesc get_mesh(ups_mesh_id id) const { return desc<MeshDesc>(ups_scene_get_mesh, id); }
  void remove_mesh(ups_mesh_id id) { check(ups_scene_remove_mesh(get(), id)); }

  ups_instance_id add_instance(const InstanceDesc &desc) {
    return detail::value<ups_instance_id>(ups_scene_add_instance, get(), &desc);
  }
  void set_instance(ups_instance_id id, const InstanceDesc &desc) {
    check(ups_scene_set_instance(get(), id, &desc));
  }
  void set_transform(ups_instance_id id, const Transform &to_world) {
    check(ups_scene_set_transform(get(), id, to_world.data()));
  }
  InstanceDesc get_instance(ups_instance_id id) const { return desc<InstanceDesc>(ups_scene_get_instance, id); }
  void remove_instance(ups_instance_id id) { check(ups_scene_remove_instance(get(), id)); }

  // ---- luminaires, lights
  ups_luminaire_id add_luminaire(const LuminaireDesc &desc) {
    return detail::value<ups_luminaire_id>(ups_scene_add_luminaire, get(), &desc);
  }
  void set_luminaire(ups_luminaire_id id, const LuminaireDesc &desc) {
    check(ups_scene_set_luminaire(get(), id, &desc));
  }
  // Without its profile, which set_luminaire then leaves as it is.
  LuminaireDesc get_luminaire(ups_luminaire_id id) const { return desc<LuminaireDesc>(ups_scene_get_luminaire, id); }
  Profile get_luminaire_profile(ups_luminaire_id id) const {
    return Profile(detail::value<ups_profile *>(ups_scene_get_luminaire_profile, get(), id));
  }
  ups_luminaire_id add_light(const LightDesc &desc) {
    return detail::value<ups_luminaire_id>(ups_scene_add_light, get(), &desc);
  }
  void set_light(ups_luminaire_id id, const LightDesc &desc) { check(ups_scene_set_light(get(), id, &desc)); }
  LightDesc get_light(ups_luminaire_id id) const { return desc<LightDesc>(ups_scene_get_light, id); }
  // Of either kind:
  void set_luminaire_transform(ups_luminaire_id id, const Transform &to_world) {
    check(ups_scene_set_luminaire_transform(get(), id, to_world.data()));
  }
  void set_dimming(ups_luminaire_id id, float dimming) { check(ups_scene_set_dimming(get(), id, dimming)); }
  float get_dimming(ups_luminaire_id id) const { return detail::value<float>(ups_scene_get_dimming, get(), id); }
  void remove_luminaire(ups_luminaire_id id) { check(ups_scene_remove_luminaire(get(), id)); }
  void set_maintenance_factor(double factor) { check(ups_scene_set_maintenance_factor(get(), factor)); }
  double get_maintenance_factor() const { return detail::value<double>(ups_scene_get_maintenance_factor, get()); }

  // ---- fixtures
  ups_fixture_id add_fixture(const Fixture &fixture, const FixtureInstanceDesc &desc) {
    return detail::value<ups_fixture_id>(ups_scene_add_fixture, get(), fixture.get(), &desc);
  }
  void set_fixture(ups_fixture_id id, const FixtureInstanceDesc &desc) {
    check(ups_scene_set_fixture(get(), id, &desc));
  }
  FixtureInstanceDesc get_fixture(ups_fixture_id id) const {
    return desc<FixtureInstanceDesc>(ups_scene_get_fixture, id);
  }
  ups_instance_id get_fixture_instance(ups_fixture_id id, ups_fixture_part_id part) const {
    return detail::value<ups_instance_id>(ups_scene_get_fixture_instance, get(), id, part);
  }
  void set_fixture_transform(ups_fixture_id id, const Transform &to_world) {
    check(ups_scene_set_fixture_transform(get(), id, to_world.data()));
  }
  void set_fixture_dimming(ups_fixture_id id, float dimming) {
    check(ups_scene_set_fixture_dimming(get(), id, dimming));
  }
  void remove_fixture(ups_fixture_id id) { check(ups_scene_remove_fixture(get(), id)); }

  // ---- sensors
  ups_sensor_id add_camera(const CameraDesc &desc) { return sensor(ups_scene_add_camera, &desc); }
  ups_sensor_id add_meters(const MeterDesc &desc) { return sensor(ups_scene_add_meters, &desc); }
  ups_sensor_id add_surface_meters(const SurfaceMetersDesc &desc) {
    return sensor(ups_scene_add_surface_meters, &desc);
  }
  ups_sensor_id add_lightmap(const LightmapDesc &desc) { return sensor(ups_scene_add_lightmap, &desc); }
  ups_sensor_id add_goniometer(const GoniometerDesc &desc) { return sensor(ups_scene_add_goniometer, &desc); }
  ups_sensor_id add_observer(const ObserverDesc &desc) { return sensor(ups_scene_add_observer, &desc); }
  void set_camera(ups_sensor_id id, const CameraDesc &desc) { check(ups_scene_set_camera(get(), id, &desc)); }
  void set_meters(ups_sensor_id id, const MeterDesc &desc) { check(ups_scene_set_meters(get(), id, &desc)); }
  void set_surface_meters(ups_sensor_id id, const SurfaceMetersDesc &desc) {
    check(ups_scene_set_surface_meters(get(), id, &desc));
  }
  void set_lightmap(ups_sensor_id id, const LightmapDesc &desc) {
    check(ups_scene_set_lightmap(get(), id, &desc));
  }
  void set_goniometer(ups_sensor_id id, const GoniometerDesc &desc) {
    check(ups_scene_set_goniometer(get(), id, &desc));
  }
  void set_observer(ups_sensor_id id, const ObserverDesc &desc) {
    check(ups_scene_set_observer(get(), id, &desc));
  }
  CameraDesc get_camera(ups_sensor_id id) const { return desc<CameraDesc>(ups_scene_get_camera, id); }
  MeterDesc get_meters(ups_sensor_id id) const { return desc<MeterDesc>(ups_scene_get_meters, id); }
  SurfaceMetersDesc get_surface_meters(ups_sensor_id id) const {
    return desc<SurfaceMetersDesc>(ups_scene_get_surface_meters, id);
  }
  LightmapDesc get_lightmap(ups_sensor_id id) const { return desc<LightmapDesc>(ups_scene_get_lightmap, id); }
  GoniometerDesc get_goniometer(ups_sensor_id id) const {
    return desc<GoniometerDesc>(ups_scene_get_goniometer, id);
  }
  ObserverDesc get_observer(ups_sensor_id id) const { return desc<ObserverDesc>(ups_scene_get_observer, id); }
  void remove_sensor(ups_sensor_id id) { check(ups_scene_remove_sensor(get(), id)); }

  // ---- commits
  void commit() { check(ups_scene_commit(get())); }
  // The same as a job: poll, wait, cancel. Edits go on meanwhile, for the next commit.
  Job start_commit() { return Job(detail::value<ups_job *>(ups_scene_start_commit, get())); }
  Job start_commit(const CommitDesc &desc) {
    return Job(detail::value<ups_job *>(ups_scene_start_commit_with, get(), &desc));
  }
  bool is_dirty() const { return detail::value<std::int32_t>(ups_scene_is_dirty, get()) != 0; }

  // ---- of the committed scene
  ups_scene_info get_info() const { return detail::sized<ups_scene_info>(ups_scene_get_info, get()); }
  std::string get_text(ups_scene_text topic) const { return detail::text(ups_scene_get_text, get(), topic); }
  std::vector<ups_scene_source> sources() const {
    for (;;) {  // a commit that comes between may number them anew
      const std::uint64_t revision = get_info().revision;
      try {
        auto out = detail::all<ups_scene_source>(ups_scene_get_source_count, ups_scene_get_source, get());
        if (get_info().revision == revision) return out;
      } catch (const Error &) {
        if (get_info().revision == revision) throw;
      }
    }
  }
  // index: in sources().
  Profile get_source_profile(std::uint32_t index) const {
    return Profile(detail::value<ups_profile *>(ups_scene_get_source_profile, get(), index));
  }
  std::vector<ups_meter_place> read_meter_places(ups_sensor_id meters) const {
    return detail::list<ups_meter_place>(ups_scene_read_meter_places, get(), meters);
  }
  std::vector<ups_segment> read_section(const Vec3 &point_m, const Vec3 &normal) const {
    return detail::list<ups_segment>(ups_scene_read_section, get(), point_m.data(), normal.data());
  }
  std::vector<ups_segment> read_outlines(const Vec3 &point_m, const Vec3 &normal,
                                         double depth_m = std::numeric_limits<double>::infinity()) const {
    return detail::list<ups_segment>(ups_scene_read_outlines, get(), point_m.data(), normal.data(), depth_m);
  }

  // ---- renders: a limit, a target or a number of iterations must be set
  Result render(const RenderDesc &desc) const {
    return Result(detail::value<ups_result *>(ups_render, get(), &desc));
  }
  // The same as a job, which can be watched and cancelled; ups_job_start.
  Job start(const RenderDesc &desc) const { return Job(detail::value<ups_job *>(ups_job_start, get(), &desc)); }
  ups_memory_estimate estimate_memory(const RenderDesc &desc) const {
    return detail::sized<ups_memory_estimate>(ups_scene_estimate_memory, get(), &desc);
  }
  // One of Result::read_largest_samples, traced again; desc: that of the render that it is of.
  Path replay(const RenderDesc &desc, const ups_sample &sample) const {
    return Path(detail::value<ups_path *>(ups_replay, get(), &desc, &sample));
  }

 private:
  template <typename Function, typename Desc>
  ups_sensor_id sensor(Function add, const Desc *desc) {
    return detail::value<ups_sensor_id>(add, get(), desc);
  }
  template <typename Desc, typename Function, typename Id>
  Desc desc(Function get_desc, Id id) const {
    Desc out;
    check(get_desc(get(), id, &out));
    return out;
  }
};

}  // namespace v0_1
}  // namespace ups

#endif
