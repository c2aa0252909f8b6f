// What a program has added to a scene so far: checked, copied, and open to change until the next commit. Filled by the
// API, read by scene/prepare.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.h"
#include "geometry/raytracer.h"
#include "photometry/photometry.h"
#include "ups/ups_scene.h"
#include "ups/ups_sensor.h"

namespace ups {

// Things by id. Ids start at 1; one that was removed never comes back.
template <class T>
class IdTable {
 public:
  uint32_t add(T item) {
    if (items_.size() >= 0xfffffffe) throw Error(UPS_ERROR_OUT_OF_MEMORY, "a scene holds at most 2^32 - 2 of a kind");
    items_.emplace_back(std::move(item));
    return uint32_t(items_.size());
  }
  void remove(uint32_t id, const char* noun) {
    get(id, noun);
    items_[id - 1].reset();
  }
  const T& get(uint32_t id, const char* noun) const {
    if (id == 0 || id > items_.size())
      fail_argument(std::string(noun) + " id " + std::to_string(id) + " is not of this scene; it has ids 1 to " +
                    std::to_string(items_.size()));
    if (!items_[id - 1]) fail_argument(std::string(noun) + " id " + std::to_string(id) + " was removed");
    return *items_[id - 1];
  }
  T& get(uint32_t id, const char* noun) { return const_cast<T&>(std::as_const(*this).get(id, noun)); }
  // visit(id, item) in the order of ids.
  template <class Visit>
  void each(const Visit& visit) const {
    for (size_t i = 0; i < items_.size(); ++i)
      if (items_[i]) visit(uint32_t(i + 1), *items_[i]);
  }
  size_t size() const { return items_.size(); }  // the largest id

 private:
  std::vector<std::optional<T>> items_;
};

struct TextureDescription {
  std::shared_ptr<const Texture> texture;
  uint32_t channels;
  float min, max;  // over all texels and channels
};

struct InstanceDescription {
  uint32_t mesh;  // id
  Affine to_world;
  uint32_t group;
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
};

struct MetersDescription {
  std::vector<Vec3d> positions;
  std::vector<Vec3> normals, tangents;  // of any length > 0; tangents: empty or one a meter
  float cell_width, cell_height;
};

struct GoniometerDescription {
  Affine to_world;
  ups_profile_symmetry symmetry;
  std::vector<double> c_deg, gamma_deg;
  photometry::Opening opening;
};

class Description {
 public:
  // Each takes a whole desc (the API fills in what an older caller's lacks) and throws Error (INVALID_ARGUMENT) that
  // names the field and element.
  ups_texture_id add_texture(const ups_texture_desc& desc);
  ups_material_id add_material(const ups_material_desc& desc);
  ups_mesh_id add_mesh(const ups_mesh_desc& desc, std::shared_ptr<const Revolution> revolution = nullptr);
  ups_instance_id add_instance(const ups_instance_desc& desc);
  ups_luminaire_id add_light(const ups_light_desc& desc);
  ups_luminaire_id add_luminaire(const ups_luminaire_desc& desc, std::shared_ptr<const photometry::Photometry> profile);
  ups_sensor_id add_camera(const ups_camera_desc& desc);
  ups_sensor_id add_meters(const ups_meter_desc& desc);
  ups_sensor_id add_goniometer(const ups_goniometer_desc& desc);

  void set_material(ups_material_id id, const ups_material_desc& desc);
  void set_transform(ups_instance_id id, const double (&to_world)[12]);
  void set_dimming(ups_luminaire_id id, float dimming);
  void remove_instance(ups_instance_id id) { instances_.remove(id.v, "instance"); }
  void remove_luminaire(ups_luminaire_id id) { sources_.remove(id.v, "luminaire"); }
  void remove_sensor(ups_sensor_id id) { sensors_.remove(id.v, "sensor"); }

  const IdTable<TextureDescription>& textures() const { return textures_; }
  const IdTable<ups_material_desc>& materials() const { return materials_; }
  const IdTable<std::shared_ptr<const Mesh>>& meshes() const { return meshes_; }  // Mesh::material is the id - 1
  const IdTable<InstanceDescription>& instances() const { return instances_; }
  const IdTable<SourceDescription>& sources() const { return sources_; }
  using Sensor = std::variant<CameraDescription, MetersDescription, GoniometerDescription>;
  const IdTable<Sensor>& sensors() const { return sensors_; }

 private:
  void check_material(const ups_material_desc& desc) const;
  void check_material_textures(const ups_material_desc& desc) const;

  IdTable<TextureDescription> textures_;
  IdTable<ups_material_desc> materials_;
  IdTable<std::shared_ptr<const Mesh>> meshes_;
  IdTable<InstanceDescription> instances_;
  IdTable<SourceDescription> sources_;
  IdTable<Sensor> sensors_;
};

}  // namespace ups
