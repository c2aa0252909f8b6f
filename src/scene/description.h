// What a program has added to a scene so far: checked, copied, and open to change until the next commit. Filled by the
// API, read by scene/prepare.
#pragma once
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "bsdf/pane_table.h"
#include "geometry/box.h"
#include "geometry/raytracer.h"
#include "photometry/photometry.h"
#include "scene/ids.h"
#include "ups/ups_glare.h"
#include "ups/ups_scene.h"
#include "ups/ups_sensor.h"

namespace ups {

// Of ups_material_desc_init, and of what a fixture's finish leaves open.
ups_material_desc default_material();
inline constexpr double max_ior = 1e6;  // whose fourth powers are numbers; no material has a hundred

struct MaterialDescription : ups_material_desc {  // pane_*: NULL, as `pane` holds them
  std::shared_ptr<const PaneTable> pane;
};

struct TextureDescription {
  std::shared_ptr<const Texture> texture;
  float min, max;  // over all texels and channels
};

struct InstanceDescription {
  uint32_t mesh;  // number
  Affine to_world;
  uint32_t group;
  bool of_fixture;  // what it emits is a luminaire's
  bool emits = false;  // a fixture's emitter, however it is dimmed
};

struct LightDescription {
  ups_light_kind kind;
  Affine to_world;
  Rgb intensity;
  float inner_cone_rad, outer_cone_rad;
};

struct LuminaireDescription {
  std::shared_ptr<const photometry::Photometry> profile;
  bool use_opening;
  Affine to_world;
  Rgb color;  // luminance 1
  float flux_lm, intensity_scale;
};

struct SourceDescription {  // lights and luminaires share their ids
  std::variant<LightDescription, LuminaireDescription> kind;
  float dimming;
  uint32_t group;
};

struct CameraDescription {
  Affine to_world;
  uint32_t width, height;
  float vertical_fov_rad;
  bool illuminance;
  ups_projection projection;
  uint32_t layers;
};

struct MetersDescription {
  ups_meter_kind kind;
  std::shared_ptr<const std::vector<Vec3d>> positions;
  Box bounds;  // of the positions
  std::vector<Vec3> normals, tangents;  // of any length > 0; tangents: empty or one a meter
  float cell_width, cell_height, footprint;
};

struct SurfaceMetersDescription {
  std::vector<ups_instance_id> instances;
  bool back;
  uint32_t width, height;  // texels of a lightmap; 0: a meter a triangle
};

struct GoniometerDescription {
  Affine to_world;
  ups_profile_symmetry symmetry;
  std::vector<double> c_deg, gamma_deg;
  std::vector<float> given_c_deg, given_gamma_deg;  // empty: equal steps
  photometry::Opening opening;
};

struct ObserverDescription {
  Affine to_world;
  ups_position_index position_index;
  float ceiling_area;
};

class Description {
 public:
  // Without a tag: a scene of its own that hands out no ids.
  explicit Description(std::shared_ptr<const SceneTag> tag = nullptr) : tag_(std::move(tag)) {}
  const std::shared_ptr<const SceneTag>& tag() const { return tag_; }
  // Another after each change, and in each scene. Copies of a description have the same things.
  uint64_t revision() const { return revision_; }

  // Each takes a whole desc (the API fills in what an older caller's lacks) and throws Error (INVALID_ARGUMENT) that
  // names the field and element; nothing has changed then.
  ups_texture_id add_texture(const ups_texture_desc& desc);
  ups_material_id add_material(const ups_material_desc& desc);
  ups_mesh_id add_mesh(const ups_mesh_desc& desc, std::shared_ptr<const Revolution> revolution = nullptr);
  ups_instance_id add_instance(const ups_instance_desc& desc, bool of_fixture = false, bool emits = false);
  ups_luminaire_id add_light(const ups_light_desc& desc);
  ups_luminaire_id add_luminaire(const ups_luminaire_desc& desc, std::shared_ptr<const photometry::Photometry> profile);
  ups_sensor_id add_camera(const ups_camera_desc& desc);
  ups_sensor_id add_meters(const ups_meter_desc& desc);
  ups_sensor_id add_surface_meters(const ups_surface_meters_desc& desc);
  ups_sensor_id add_lightmap(const ups_lightmap_desc& desc);
  ups_sensor_id add_goniometer(const ups_goniometer_desc& desc);
  ups_sensor_id add_observer(const ups_observer_desc& desc);

  void set_texture(ups_texture_id id, const ups_texture_desc& desc);
  void set_material(ups_material_id id, const ups_material_desc& desc);
  void set_mesh(ups_mesh_id id, const ups_mesh_desc& desc);
  void set_mesh_vertices(ups_mesh_id id, const float* positions_m, const float* normals, uint32_t vertex_count);
  // of_fixture: whether the caller is the fixture that it must be a part of, or must not.
  void set_instance(ups_instance_id id, const ups_instance_desc& desc, bool of_fixture = false);
  void set_transform(ups_instance_id id, const double (&to_world)[12]);  // of none that is a fixture's
  void set_light(ups_luminaire_id id, const ups_light_desc& desc);
  // profile null: as it is.
  void set_luminaire(ups_luminaire_id id, const ups_luminaire_desc& desc,
                     std::shared_ptr<const photometry::Photometry> profile);
  void set_luminaire_transform(ups_luminaire_id id, const double (&to_world)[12]);
  void set_dimming(ups_luminaire_id id, float dimming);
  void set_maintenance_factor(double factor);
  double maintenance_factor() const { return maintenance_factor_; }  // of luminaires and fixtures
  void set_camera(ups_sensor_id id, const ups_camera_desc& desc);
  void set_meters(ups_sensor_id id, const ups_meter_desc& desc);
  void set_surface_meters(ups_sensor_id id, const ups_surface_meters_desc& desc);
  void set_lightmap(ups_sensor_id id, const ups_lightmap_desc& desc);
  void set_goniometer(ups_sensor_id id, const ups_goniometer_desc& desc);
  void set_observer(ups_sensor_id id, const ups_observer_desc& desc);

  // What was added, as it stands; arrays point to what is here.
  ups_texture_desc texture(ups_texture_id id) const;
  ups_material_desc material(ups_material_id id) const;
  ups_mesh_desc mesh(ups_mesh_id id) const;
  ups_instance_desc instance(ups_instance_id id) const;
  ups_light_desc light(ups_luminaire_id id) const;
  ups_luminaire_desc luminaire(ups_luminaire_id id) const;
  const std::shared_ptr<const photometry::Photometry>& profile(ups_luminaire_id id) const;
  float dimming(ups_luminaire_id id) const { return sources_.get(id.v, "luminaire").dimming; }
  ups_camera_desc camera(ups_sensor_id id) const;
  ups_meter_desc meters(ups_sensor_id id) const;
  ups_surface_meters_desc surface_meters(ups_sensor_id id) const;
  ups_lightmap_desc lightmap(ups_sensor_id id) const;
  ups_goniometer_desc goniometer(ups_sensor_id id) const;
  ups_observer_desc observer(ups_sensor_id id) const;

  void remove_texture(ups_texture_id id);    // throws where a material has it
  void remove_material(ups_material_id id);  // where a mesh has it
  void remove_mesh(ups_mesh_id id);          // where an instance has it
  // What was set, as it was before: takes no memory, as removing what nothing has takes none.
  void put_back(ups_instance_id id, std::shared_ptr<const InstanceDescription> before) noexcept {
    instances_.put_back(number_of(id.v), std::move(before));
  }
  void put_back(ups_material_id id, std::shared_ptr<const MaterialDescription> before) noexcept {
    materials_.put_back(number_of(id.v), std::move(before));
  }
  // Numbers of a mesh that has it, of an instance that has it; 0: none, or it is not there.
  uint32_t user_of(ups_material_id id) const;
  uint32_t user_of(ups_mesh_id id) const;
  void remove_instance(ups_instance_id id) { instances_.remove(id.v, "instance"), ++revision_; }
  void remove_luminaire(ups_luminaire_id id) { sources_.remove(id.v, "luminaire"), ++revision_; }
  void remove_sensor(ups_sensor_id id) { sensors_.remove(id.v, "sensor"), ++revision_; }

  const IdTable<TextureDescription>& textures() const { return textures_; }
  const IdTable<MaterialDescription>& materials() const { return materials_; }
  const IdTable<Mesh>& meshes() const { return meshes_; }
  const IdTable<InstanceDescription>& instances() const { return instances_; }
  const IdTable<SourceDescription>& sources() const { return sources_; }
  using Sensor =
      std::variant<CameraDescription, MetersDescription, SurfaceMetersDescription, GoniometerDescription,
                   ObserverDescription>;
  const IdTable<Sensor>& sensors() const { return sensors_; }

 private:
  // What a desc describes, checked.
  TextureDescription read(const ups_texture_desc& desc) const;
  MaterialDescription read(const ups_material_desc& desc) const;
  Mesh read(const ups_mesh_desc& desc) const;
  InstanceDescription read(const ups_instance_desc& desc, bool of_fixture) const;
  const InstanceDescription& instance_of(ups_instance_id id, bool of_fixture) const;
  SourceDescription read(const ups_light_desc& desc) const;
  SourceDescription read(const ups_luminaire_desc& desc, std::shared_ptr<const photometry::Photometry> profile) const;
  Sensor read(const ups_camera_desc& desc) const;
  Sensor read(const ups_meter_desc& desc) const;
  Sensor read(const ups_surface_meters_desc& desc) const;
  Sensor read(const ups_lightmap_desc& desc) const;
  Sensor read(const ups_goniometer_desc& desc) const;
  Sensor read(const ups_observer_desc& desc) const;
  void check_material_textures(const ups_material_desc& desc) const;
  // Of surfaces that are measured; adds up their triangles.
  std::vector<ups_instance_id> read_instances(const ups_instance_id* ids, uint32_t count, uint64_t& triangles) const;

  template <class Table, class Item>
  auto add(Table& table, Item item) {
    const uint32_t id = table.add(std::move(item));
    ++revision_;
    return id;
  }
  template <class Table, class Item>
  void set(Table& table, uint32_t id, Item item, const char* noun) {
    table.set(id, std::move(item), noun);
    ++revision_;
  }
  // Throws where the source is of the other kind.
  template <class Kind>
  const Kind& source_of(ups_luminaire_id id) const;
  // Where the sensor is of another kind; is_lightmap: of surface meters.
  template <class Kind>
  const Kind& sensor_of(ups_sensor_id id) const;
  const SurfaceMetersDescription& surface_of(ups_sensor_id id, bool is_lightmap) const;

  std::shared_ptr<const SceneTag> tag_;
  uint32_t tag_bits_ = tag_ ? tag_->bits() : 0;
  uint64_t revision_ = tag_ ? tag_->first_revision() : 0;
  double maintenance_factor_ = 1;
  IdTable<TextureDescription> textures_{tag_bits_};
  IdTable<MaterialDescription> materials_{tag_bits_};
  IdTable<Mesh> meshes_{tag_bits_};
  IdTable<InstanceDescription> instances_{tag_bits_};
  IdTable<SourceDescription> sources_{tag_bits_};
  IdTable<Sensor> sensors_{tag_bits_};
};

}  // namespace ups
