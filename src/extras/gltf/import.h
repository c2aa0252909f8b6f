// The state of one import, shared by its parts: materials and textures, meshes, nodes, lights, meters, goniometers.
// import.cpp owns the order of work; each part is a file of its own.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/boundary.h"
#include "gltf/document.h"
#include "gltf/transform.h"
#include "ups/ups.h"
#include "ups/ups_gltf.h"

namespace ups::gltf {

struct Sensor {
  ups_gltf_sensor_info info;
  std::string name;
  std::vector<double> positions_m;  // meters: world, 3 values each
  std::vector<float> normals;
};

inline constexpr uint32_t number_bits = 0xffffff;  // of an id: its number, as messages of the core have it

struct UniqueNames {
  std::set<std::string> taken;
  std::map<std::string, int> next;  // of a base, the number that it is worth trying: all below are taken
};

struct ProfileDeleter {
  void operator()(ups_profile* profile) const { ups_profile_destroy(profile); }
};
using ProfilePtr = std::unique_ptr<ups_profile, ProfileDeleter>;

struct FixtureDeleter {
  void operator()(ups_fixture* fixture) const;
};
using FixturePtr = std::unique_ptr<ups_fixture, FixtureDeleter>;

struct Material {
  ups_material_id id;
  int uv_set;  // the TEXCOORD_n that its textures use
  bool textured, emits;
};

inline void store(const Rgb& from, float (&to)[3]) {
  for (size_t i = 0; i < 3; ++i) to[i] = float(from[i]);
}

struct SourceName {
  ups_source_kind kind;
  uint32_t id;
  std::string name;
  std::string file;  // photometric, of a luminaire; as the scene file names it
};

// By part and number: where in the file.
using Places = std::map<std::pair<ups_gltf_part, uint32_t>, std::string>;

struct PlacedMesh {  // a primitive
  ups_mesh_id id;
  bool emits;
  uint32_t triangles;
  bool has_uvs;
};

// "colour_temperature_k" of an emitter or a luminaire, where there is one.
void read_colour_temperature(const JsonReader& reader, float (&rgb)[3]);
// Rec.709.
inline double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

// A photometric file and how to read it.
struct ProfileFile {
  std::string key;   // files of one key are the same
  std::string name;  // for messages
  Bytes bytes;
  std::string folder;   // where its TILT file may be; empty: nowhere
  float tilt_deg = -1;  // >= 0: with the TILT factor at this tilt
  uint32_t lamp_set = 0;
};

class Importer {
 public:
  Importer(ups_context* context, ups_scene* scene, const ups_gltf_import_desc& desc)
      : context_(context), scene_(scene), desc_(desc) {}
  void run(const std::string& path);

  std::vector<Sensor> sensors;
  std::vector<SourceName> sources;
  Places places;
  std::vector<std::string> warnings;

 private:
  // By the core's number, as its messages have it.
  void note_place(ups_gltf_part part, uint32_t id, const std::string& where);
  // Throws what the core said, with the place in the file, unless status is OK.
  void check(ups_status status, const std::string& where) const;
  // The same of a fixture's part: the core counts parts from 1, the file from 0, so the core's number is left out.
  void check_part(ups_status status, const std::string& where) const;
  void warn(const std::string& text);  // each text once
  void warn_about_the_rest();          // animations, skins and what else the scene does not take over
  void warn_about_extensions(const JsonReader& reader, std::initializer_list<std::string_view> known);

  // texture.cpp
  enum class Decode { color, color_with_alpha, normal, green, blue };
  ups_texture_id texture(const JsonReader& material, const JsonReader& info, Decode decode);
  // material.cpp, material_extras.cpp
  void add_materials();
  Material add_material(const JsonReader& material);
  void read_core_material(const JsonReader& material, ups_material_desc& desc);
  void reflect_all(const JsonReader& material, ups_material_desc& desc);
  void read_transmission(const JsonReader& material, ups_material_desc& desc);
  void read_emission(const JsonReader& material, ups_material_desc& desc);
  void read_alpha(const JsonReader& material, ups_material_desc& desc);
  void read_extras_material(const JsonReader& extras, ups_material_desc& desc);
  void read_pane(const JsonReader& extras, ups_material_desc& desc);
  int uv_set_of(const JsonReader& material);
  const Material& default_material();
  // mesh.cpp
  const std::vector<PlacedMesh>& mesh(int index);
  std::optional<PlacedMesh> add_primitive(const tinygltf::Primitive& primitive, const std::string& where);
  // node.cpp
  void read_scene();
  void warn_of_nodes_in_no_scene();
  void read_node(int index, const Affine& parent);
  void add_instances(int index, const Affine& to_world, const std::string& where);
  void add_camera(const JsonReader& node, int index, const Affine& frame);
  // light.cpp
  void add_punctual_light(const JsonReader& node, const Affine& frame);
  void add_ies_light(const JsonReader& node, const Affine& frame);
  void add_luminaire(const JsonReader& luminaire, const Affine& frame);
  // profile.cpp
  const ups_profile* profile(const ProfileFile& file, const std::string& where);
  // goniometer.cpp
  void add_goniometer(const JsonReader& words, const std::string& node_name, const Affine& frame);
  // observer.cpp
  void add_observer(const JsonReader& words, const std::string& node_name, const Affine& frame);
  // fixture.cpp
  void add_fixture(const JsonReader& fixture, const Affine& frame);
  const ups_fixture* fixture_of(const JsonReader& fixture);
  void add_emitter(ups_fixture* fixture, const JsonReader& part);
  void add_reflector(ups_fixture* fixture, const JsonReader& part);
  void add_lens(ups_fixture* fixture, const JsonReader& part);
  void add_collimator(ups_fixture* fixture, const JsonReader& part);
  template <class Desc>
  void read_finish(const JsonReader& part, Desc& desc, ups_material_desc& custom);
  // meters.cpp
  void add_meters(const JsonReader& meters, const std::string& node_name, const Affine& frame);
  void add_surface_meters(const JsonReader& meters, const std::string& node_name);
  void keep_meters(Sensor&& sensor, const JsonReader& meters, const std::string& node_name);
  std::string unique_name(const std::string& name, bool illuminance, const std::string& where);
  // names.cpp: no file bears an observer's name, so it stays as it is.
  std::string unique_observer_name(const std::string& name, const std::string& where);
  // names.cpp: of what emits on the present node; word: "luminaire", "instance" or "fixture".
  void name_source(ups_source_kind kind, uint32_t id, const char* word, const std::string& file = {});

  ups_context* context_;
  ups_scene* scene_;
  ups_gltf_import_desc desc_;
  Document document_;
  std::vector<Material> materials_;
  std::optional<Material> default_material_;
  std::vector<std::optional<std::vector<PlacedMesh>>> meshes_;
  std::vector<std::pair<std::string, ProfilePtr>> profiles_;
  std::vector<std::pair<const Json*, FixturePtr>> fixtures_;  // by their "parts"
  std::vector<std::pair<std::string, ups_texture_id>> textures_;
  UniqueNames names_, source_names_;
  std::set<std::string> warned_;
  std::map<std::string, uint32_t> nameless_;  // sources on nodes without a name, by their word
  std::vector<char> visited_;  // nodes
  uint32_t group_ = 0;         // of what the present node emits
  std::string node_name_, node_where_;  // of the present node
  struct {
    std::vector<float> angle_deg, transmittance, reflectance;
  } pane_;                     // of the present material, until the scene has copied it
  // Its mesh, by primitive.
  std::vector<ups_instance_id> node_instances_;
  std::vector<PlacedMesh> node_meshes_;
};

}  // namespace ups::gltf
