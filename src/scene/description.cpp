// See description.h: surfaces, that is textures, materials, meshes and instances; for what emits see
// description_sources.cpp, for sensors description_sensors.cpp.
#include "scene/description.h"

#include <cmath>

#include "scene/read.h"

namespace ups {
namespace {

std::vector<float> read_texels(const ups_texture_desc& d) {
  const size_t row = size_t(d.width) * d.channel_count;
  check::require(d.row_stride_bytes == 0 || (d.row_stride_bytes >= 4 * row && d.row_stride_bytes % 4 == 0),
                 "row_stride_bytes is " + std::to_string(d.row_stride_bytes) +
                     "; it must be 0 (tight) or a multiple of 4 of at least " + std::to_string(4 * row));
  const size_t stride = d.row_stride_bytes ? d.row_stride_bytes / 4 : row;
  std::vector<float> texels(row * d.height);
  for (size_t y = 0; y < d.height; ++y)
    for (size_t i = 0; i < row; ++i) {
      const float value = d.texels[y * stride + i];
      if (!std::isfinite(value))
        fail_argument("texels: row " + std::to_string(y) + ", column " + std::to_string(i / d.channel_count) +
                      ", channel " + std::to_string(i % d.channel_count) + " is " + check::text(double(value)) +
                      "; it must be finite");
      texels[y * row + i] = value;
    }
  return texels;
}

void check_emission_and_alpha(const ups_material_desc& d) {
  check::enumeration(d.alpha_mode, UPS_ALPHA_BLEND, "alpha_mode", "UPS_ALPHA_*");
  check::range(double(d.alpha), 0, 1, "alpha");
  check::at_least(double(d.alpha_cutoff), 0, "alpha_cutoff");
  check::colour(d.luminance_cd_m2, 0, INFINITY, "luminance_cd_m2");
  check::flag(d.emits_both_sides, "emits_both_sides");
  check::finite(double(d.normal_scale), "normal_scale");
}

void check_transmittance(const ups_material_desc& d) {
  const float* t = d.transmittance_rgb;
  if (std::isless(t[0], 0.0f) && std::isless(t[1], 0.0f) && std::isless(t[2], 0.0f)) return;  // the model's default
  check::colour(d.transmittance_rgb, 0, 1, "transmittance_rgb");
  if (d.model != UPS_MATERIAL_DIFFUSER) return;
  for (size_t i = 0; i < 3; ++i) {
    const double sum = double(d.reflectance_rgb[i]) + double(t[i]);
    check::require(sum <= 1 + 1e-6, "reflectance_rgb[" + std::to_string(i) + "] + transmittance_rgb[" +
                                        std::to_string(i) + "] is " + check::text(sum) +
                                        "; a diffuser's must be at most 1 together");
  }
}

// Null where the desc has no table.
std::shared_ptr<const PaneTable> read_pane(const ups_material_desc& d) {
  if (d.pane_angle_count == 0) return nullptr;
  check::require(d.model == UPS_MATERIAL_GLAZING, "pane_angle_count is " + std::to_string(d.pane_angle_count) +
                                                      "; a table by angle is of UPS_MATERIAL_GLAZING alone");
  check::require(d.transmittance_rgb[0] < 0, "transmittance_rgb and pane_transmittance are set; one of them says what "
                                             "the pane lets through");
  check_count(d.pane_angle_count, 2, 9001, "pane_angle_count");
  check::pointer(d.pane_angle_deg, "pane_angle_deg");
  check::pointer(d.pane_transmittance, "pane_transmittance");
  const size_t n = d.pane_angle_count;
  std::vector<float> angle(d.pane_angle_deg, d.pane_angle_deg + n), reflectance,
      transmittance(d.pane_transmittance, d.pane_transmittance + n);
  if (d.pane_reflectance) reflectance.assign(d.pane_reflectance, d.pane_reflectance + n);
  for (size_t i = 0; i < n; ++i) {
    const double a = double(angle[i]), t = double(transmittance[i]), r = reflectance.empty() ? 0 : double(reflectance[i]);
    check::require(i == 0 ? a == 0 : a > double(angle[i - 1]) && (i + 1 < n ? a < 90 : a == 90),
                   check::element("pane_angle_deg", i) + " is " + check::text(a) +
                       "; the angles must ascend from 0 to 90");
    check::range(t, 0, 1, check::element("pane_transmittance", i));
    check::range(r, 0, 1, check::element("pane_reflectance", i));
    check::require(t + r <= 1 + 1e-6, "pane_transmittance + pane_reflectance at " + check::text(a) + " degrees is " +
                                          check::text(t + r) + "; together they must be at most 1");
  }
  return std::make_shared<const PaneTable>(std::move(angle), std::move(transmittance), std::move(reflectance));
}

void check_indices_of_refraction(const ups_material_desc& d) {
  const bool dielectric =
      d.model == UPS_MATERIAL_PLASTIC || d.model == UPS_MATERIAL_GLASS || d.model == UPS_MATERIAL_GLAZING;
  if (dielectric)
    check::range(double(d.ior), 1, max_ior, "ior");
  else
    check::finite(double(d.ior), "ior");
  check::colour(d.ior_k_rgb, 0, max_ior, "ior_k_rgb");
  check::colour(d.ior_rgb, 0, max_ior, "ior_rgb");
  const bool complex = d.ior_k_rgb[0] > 0 || d.ior_k_rgb[1] > 0 || d.ior_k_rgb[2] > 0;
  for (size_t i = 0; complex && d.model == UPS_MATERIAL_METAL && i < 3; ++i)
    check::require(d.ior_rgb[i] > 0,
                   check::element("ior_rgb", i) + " is 0; it must be above 0 where ior_k_rgb is used");
}

}  // namespace

ups_material_desc default_material() {
  ups_material_desc d{};
  d.model = UPS_MATERIAL_MATTE;
  std::fill(std::begin(d.reflectance_rgb), std::end(d.reflectance_rgb), 0.5f);
  std::fill(std::begin(d.transmittance_rgb), std::end(d.transmittance_rgb), -1.0f);
  d.ior = 1.5f;
  std::fill(std::begin(d.ior_rgb), std::end(d.ior_rgb), 1.0f);
  d.alpha_mode = UPS_ALPHA_OPAQUE;
  d.alpha = 1;
  d.alpha_cutoff = 0.5f;
  d.normal_scale = 1;
  return d;
}

TextureDescription Description::read(const ups_texture_desc& d) const {
  check_count(d.width, 1, 1u << 20, "width");
  check_count(d.height, 1, 1u << 20, "height");
  check::require(d.channel_count == 1 || d.channel_count == 3 || d.channel_count == 4,
                 "channel_count is " + std::to_string(d.channel_count) + "; it must be 1, 3 or 4");
  check::pointer(d.texels, "texels");
  std::vector<float> texels = read_texels(d);
  const auto [low, high] = std::minmax_element(texels.begin(), texels.end());
  TextureDescription texture{nullptr, *low, *high};
  texture.texture = std::make_shared<const Texture>(d.width, d.height, d.channel_count, std::move(texels));
  return texture;
}

ups_texture_id Description::add_texture(const ups_texture_desc& d) { return {add(textures_, read(d))}; }

// What the materials that have it want of it.
void Description::set_texture(ups_texture_id id, const ups_texture_desc& d) {
  textures_.get(id.v, "texture");
  const auto old = textures_.shared(number_of(id.v));
  const auto before = revision_;
  set(textures_, id.v, read(d), "texture");
  try {
    materials_.each([&](uint32_t number, const MaterialDescription& material) {
      try {
        check_material_textures(material);
      } catch (const Error& e) {
        throw Error(e.status(), "material " + std::to_string(number) + ": " + e.what());
      }
    });
  } catch (...) {
    textures_.put_back(number_of(id.v), old);
    revision_ = before;
    throw;
  }
}

void Description::remove_texture(ups_texture_id id) {
  textures_.get(id.v, "texture");
  materials_.each([&](uint32_t number, const MaterialDescription& m) {
    for (const ups_texture_id used : {m.reflectance_texture, m.roughness_texture, m.metallic_texture, m.normal_texture,
                                      m.alpha_texture})
      if (used.v == id.v)
        fail_argument("texture id " + std::to_string(number_of(id.v)) + " is used by material " +
                      std::to_string(number) + "; set or remove that first");
  });
  textures_.remove(id.v, "texture"), ++revision_;
}

void Description::check_material_textures(const ups_material_desc& d) const {
  const auto find = [&](ups_texture_id id, const char* field) -> const TextureDescription* {
    if (id.v == 0) return nullptr;
    return &textures_.get(id.v, (std::string(field) + ": texture").c_str());
  };
  const auto share = [&](ups_texture_id id, const char* field) {  // of light: more than 1 would create energy
    const TextureDescription* t = find(id, field);
    check::require(!t || (t->min >= 0 && t->max <= 1 + 1e-6f),
                   std::string(field) + ": texture id " + std::to_string(number_of(id.v)) + " has texels from " +
                       (t ? check::text(double(t->min)) + " to " + check::text(double(t->max)) : "") +
                       "; they must lie in [0, 1]");
  };
  share(d.reflectance_texture, "reflectance_texture");
  share(d.roughness_texture, "roughness_texture");
  share(d.metallic_texture, "metallic_texture");
  find(d.alpha_texture, "alpha_texture");
  const TextureDescription* normal = find(d.normal_texture, "normal_texture");
  check::require(!normal || normal->texture->channels() >= 3, "normal_texture: texture id " +
                                                       std::to_string(number_of(d.normal_texture.v)) +
                                                       " has 1 channel; it must have 3 or 4");
}

MaterialDescription Description::read(const ups_material_desc& d) const {
  check::enumeration(d.model, UPS_MATERIAL_DIFFUSER, "model", "UPS_MATERIAL_*");
  check::colour(d.reflectance_rgb, 0, 1, "reflectance_rgb");
  check_transmittance(d);
  check::range(double(d.roughness), 0, 1, "roughness");
  check_indices_of_refraction(d);
  check::colour(d.absorption_per_m_rgb, 0, INFINITY, "absorption_per_m_rgb");
  check::range(double(d.metallic), 0, 1, "metallic");
  check_emission_and_alpha(d);
  check_reserved(d.reserved);
  check_material_textures(d);
  MaterialDescription material{d, read_pane(d)};
  material.pane_angle_deg = material.pane_transmittance = material.pane_reflectance = nullptr;
  return material;
}

ups_material_id Description::add_material(const ups_material_desc& d) { return {add(materials_, read(d))}; }

void Description::set_material(ups_material_id id, const ups_material_desc& d) {
  materials_.get(id.v, "material");
  set(materials_, id.v, read(d), "material");
}

void Description::remove_material(ups_material_id id) {
  materials_.get(id.v, "material");
  const uint32_t user = user_of(id);
  if (user != 0)
    fail_argument("material id " + std::to_string(number_of(id.v)) + " is used by mesh " + std::to_string(user) +
                  "; set or remove that first");
  materials_.remove(id.v, "material"), ++revision_;
}

Mesh Description::read(const ups_mesh_desc& d) const {
  check_count(d.vertex_count, 1, 0xfffffffe, "vertex_count");
  check_count(d.triangle_count, 1, 0xfffffffe, "triangle_count");
  check::require(d.material.v != 0, "material is 0; a mesh needs one");
  materials_.get(d.material.v, "material: material");
  check::pointer(d.positions_m, "positions_m");
  check::pointer(d.indices, "indices");
  const check::Floats positions{d.positions_m, d.vertex_count, 3, d.position_stride_bytes};
  const check::Floats normals{d.normals, d.normals ? d.vertex_count : 0, 3, d.normal_stride_bytes};
  const check::Floats uvs{d.uvs, d.uvs ? d.vertex_count : 0, 2, d.uv_stride_bytes};
  const check::Floats tangents{d.tangents, d.tangents ? d.vertex_count : 0, 4, d.tangent_stride_bytes};
  check::all_finite(positions, "positions_m", "position_stride_bytes");
  check::all_finite(normals, "normals", "normal_stride_bytes");
  check::all_finite(uvs, "uvs", "uv_stride_bytes");
  check::all_finite(tangents, "tangents", "tangent_stride_bytes");
  const size_t index_count = 3 * size_t(d.triangle_count);
  for (size_t i = 0; i < index_count; ++i)
    if (d.indices[i] >= d.vertex_count)
      fail_argument("indices: element " + std::to_string(i) + " is " + std::to_string(d.indices[i]) +
                    "; it must be below vertex_count, " + std::to_string(d.vertex_count));
  Mesh mesh;
  mesh.material_number = number_of(d.material.v);
  mesh.positions = read_vectors(positions);
  mesh.normals = read_vectors(normals);
  for (size_t i = 0; i < uvs.count; ++i) mesh.uvs.push_back({uvs.at(i)[0], uvs.at(i)[1]});
  for (size_t i = 0; i < tangents.count; ++i)
    mesh.tangents.insert(mesh.tangents.end(), tangents.at(i), tangents.at(i) + 4);
  mesh.indices.assign(d.indices, d.indices + index_count);
  return mesh;
}

ups_mesh_id Description::add_mesh(const ups_mesh_desc& d, std::shared_ptr<const Revolution> revolution) {
  Mesh mesh = read(d);
  mesh.revolution = std::move(revolution);
  return {add(meshes_, std::move(mesh))};
}

void Description::set_mesh(ups_mesh_id id, const ups_mesh_desc& d) {
  check::require(!meshes_.get(id.v, "mesh").revolution,
                 "mesh id " + std::to_string(number_of(id.v)) + " is a fixture's curved part, which has no triangles");
  set(meshes_, id.v, read(d), "mesh");
}

void Description::set_mesh_vertices(ups_mesh_id id, const float* positions_m, const float* normals,
                                    uint32_t vertex_count) {
  const Mesh& old = meshes_.get(id.v, "mesh");
  check::require(vertex_count == old.positions.size(),
                 "vertex_count is " + std::to_string(vertex_count) + "; the mesh has " +
                     std::to_string(old.positions.size()) + " vertices (ups_scene_set_mesh sets another number)");
  check::pointer(positions_m, "positions_m");
  ups_mesh_desc d = mesh(id);
  d.positions_m = positions_m, d.position_stride_bytes = 0;
  if (normals) d.normals = normals, d.normal_stride_bytes = 0;
  set_mesh(id, d);
}

void Description::remove_mesh(ups_mesh_id id) {
  meshes_.get(id.v, "mesh");
  const uint32_t user = user_of(id);
  if (user != 0)
    fail_argument("mesh id " + std::to_string(number_of(id.v)) + " is used by instance " + std::to_string(user) +
                  "; set or remove that first");
  meshes_.remove(id.v, "mesh"), ++revision_;
}

uint32_t Description::user_of(ups_material_id id) const {
  uint32_t user = 0;
  meshes_.each([&](uint32_t number, const Mesh& mesh) {
    if (user == 0 && mesh.material_number == number_of(id.v)) user = number;
  });
  return user;
}

uint32_t Description::user_of(ups_mesh_id id) const {
  uint32_t user = 0;
  instances_.each([&](uint32_t number, const InstanceDescription& instance) {
    if (user == 0 && instance.mesh == number_of(id.v)) user = number;
  });
  return user;
}

InstanceDescription Description::read(const ups_instance_desc& d, bool of_fixture) const {
  check::require(d.mesh.v != 0, "mesh is 0; an instance needs one");
  meshes_.get(d.mesh.v, "mesh: mesh");
  check::transform(d.to_world, "to_world");
  check_reserved(d.reserved);
  return {number_of(d.mesh.v), to_affine(d.to_world), d.group, of_fixture};
}

ups_instance_id Description::add_instance(const ups_instance_desc& d, bool of_fixture, bool emits) {
  InstanceDescription instance = read(d, of_fixture);
  instance.emits = emits;
  return {add(instances_, std::move(instance))};
}

// A fixture alone sets and moves its parts.
const InstanceDescription& Description::instance_of(ups_instance_id id, bool of_fixture) const {
  const InstanceDescription& instance = instances_.get(id.v, "instance");
  check::require(instance.of_fixture == of_fixture, "instance id " + std::to_string(number_of(id.v)) +
                                                        " is a part of a fixture; set the fixture");
  return instance;
}

void Description::set_instance(ups_instance_id id, const ups_instance_desc& d, bool of_fixture) {
  const bool emits = instance_of(id, of_fixture).emits;
  InstanceDescription instance = read(d, of_fixture);
  instance.emits = emits;
  set(instances_, id.v, std::move(instance), "instance");
}

void Description::set_transform(ups_instance_id id, const double (&to_world)[12]) {
  InstanceDescription instance = instance_of(id, false);
  check::transform(to_world, "to_world");
  instance.to_world = to_affine(to_world);
  set(instances_, id.v, instance, "instance");
}

// ---- as they stand ----

ups_texture_desc Description::texture(ups_texture_id id) const {
  const Texture& texture = *textures_.get(id.v, "texture").texture;
  ups_texture_desc d{};
  d.width = texture.width(), d.height = texture.height(), d.channel_count = texture.channels();
  return d;
}

ups_material_desc Description::material(ups_material_id id) const {
  const MaterialDescription& material = materials_.get(id.v, "material");
  ups_material_desc d = material;
  if (!material.pane) return d;
  d.pane_angle_deg = material.pane->angle_deg().data();
  d.pane_transmittance = material.pane->transmittance().data();
  if (material.pane->has_reflectance()) d.pane_reflectance = material.pane->reflectance().data();
  return d;
}

ups_mesh_desc Description::mesh(ups_mesh_id id) const {
  const Mesh& mesh = meshes_.get(id.v, "mesh");
  static_assert(sizeof(Vec3) == 3 * sizeof(float) && sizeof(Vec2) == 2 * sizeof(float));  // arrays of floats
  ups_mesh_desc d{};
  d.vertex_count = uint32_t(mesh.positions.size()), d.triangle_count = uint32_t(mesh.triangle_count());
  d.material = {materials_.id_of(mesh.material_number)};
  d.positions_m = &mesh.positions.data()->x;
  d.normals = mesh.normals.empty() ? nullptr : &mesh.normals.data()->x;
  d.uvs = mesh.uvs.empty() ? nullptr : &mesh.uvs.data()->x;
  d.tangents = mesh.tangents.empty() ? nullptr : mesh.tangents.data();
  d.indices = mesh.indices.data();
  return d;
}

ups_instance_desc Description::instance(ups_instance_id id) const {
  const InstanceDescription& instance = instances_.get(id.v, "instance");
  ups_instance_desc d{};
  d.mesh = {meshes_.id_of(instance.mesh)};
  copy_transform(instance.to_world, d.to_world);
  d.group = instance.group;
  return d;
}

}  // namespace ups
