// See description.h. Surfaces first (textures, materials, meshes, instances), then what emits, then sensors.
#include "scene/description.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/check.h"
#include "sensor/goniometer.h"

namespace ups {
namespace {

constexpr uint32_t max_meters = 16'777'216;  // of a set

Affine to_affine(const double (&m)[12]) {
  Affine a;
  std::copy(std::begin(m), std::end(m), a.m);
  return a;
}

void check_count(uint32_t value, uint32_t low, uint32_t high, const char* field) {
  if (value < low || value > high)
    fail_argument(std::string(field) + " is " + std::to_string(value) + "; it must be " + std::to_string(low) + " to " +
                  std::to_string(high));
}

std::vector<Vec3> read_vectors(const check::Floats& floats) {
  std::vector<Vec3> out;
  out.reserve(floats.count);
  for (size_t i = 0; i < floats.count; ++i) out.emplace_back(floats.at(i)[0], floats.at(i)[1], floats.at(i)[2]);
  return out;
}

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
  if (t[0] < 0 && t[1] < 0 && t[2] < 0) return;  // the model's default
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
    check::at_least(double(d.ior), 1, "ior");
  else
    check::finite(double(d.ior), "ior");
  check::colour(d.ior_k_rgb, 0, INFINITY, "ior_k_rgb");
  check::colour(d.ior_rgb, 0, INFINITY, "ior_rgb");
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

// ---- surfaces ----

ups_texture_id Description::add_texture(const ups_texture_desc& d) {
  check_count(d.width, 1, 1u << 20, "width");
  check_count(d.height, 1, 1u << 20, "height");
  check::require(d.channel_count == 1 || d.channel_count == 3 || d.channel_count == 4,
                 "channel_count is " + std::to_string(d.channel_count) + "; it must be 1, 3 or 4");
  check::pointer(d.texels, "texels");
  std::vector<float> texels = read_texels(d);
  const auto [low, high] = std::minmax_element(texels.begin(), texels.end());
  TextureDescription texture{nullptr, d.channel_count, *low, *high};
  texture.texture = std::make_shared<const Texture>(d.width, d.height, d.channel_count, std::move(texels));
  return {textures_.add(std::move(texture))};
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
  check::require(!normal || normal->channels >= 3, "normal_texture: texture id " +
                                                       std::to_string(number_of(d.normal_texture.v)) +
                                                       " has 1 channel; it must have 3 or 4");
}

MaterialDescription Description::checked(const ups_material_desc& d) const {
  check::enumeration(d.model, UPS_MATERIAL_DIFFUSER, "model", "UPS_MATERIAL_*");
  check::colour(d.reflectance_rgb, 0, 1, "reflectance_rgb");
  check_transmittance(d);
  check::range(double(d.roughness), 0, 1, "roughness");
  check_indices_of_refraction(d);
  check::colour(d.absorption_per_m_rgb, 0, INFINITY, "absorption_per_m_rgb");
  check::range(double(d.metallic), 0, 1, "metallic");
  check_emission_and_alpha(d);
  check::require(d.reserved == 0, "reserved is " + std::to_string(d.reserved) + "; it must be 0");
  check_material_textures(d);
  MaterialDescription material{d, read_pane(d)};
  material.pane_angle_deg = material.pane_transmittance = material.pane_reflectance = nullptr;
  return material;
}

ups_material_id Description::add_material(const ups_material_desc& d) { return {materials_.add(checked(d))}; }

void Description::set_material(ups_material_id id, const ups_material_desc& d) {
  MaterialDescription& old = materials_.get(id.v, "material");
  old = checked(d);
}

ups_mesh_id Description::add_mesh(const ups_mesh_desc& d, std::shared_ptr<const Revolution> revolution) {
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
  auto mesh = std::make_shared<Mesh>();
  mesh->material = number_of(d.material.v) - 1;
  mesh->positions = read_vectors(positions);
  mesh->normals = read_vectors(normals);
  for (size_t i = 0; i < uvs.count; ++i) mesh->uvs.push_back({uvs.at(i)[0], uvs.at(i)[1]});
  for (size_t i = 0; i < tangents.count; ++i)
    mesh->tangents.insert(mesh->tangents.end(), tangents.at(i), tangents.at(i) + 4);
  mesh->indices.assign(d.indices, d.indices + index_count);
  mesh->revolution = std::move(revolution);
  return {meshes_.add(std::move(mesh))};
}

ups_instance_id Description::add_instance(const ups_instance_desc& d, bool of_fixture) {
  check::require(d.mesh.v != 0, "mesh is 0; an instance needs one");
  meshes_.get(d.mesh.v, "mesh: mesh");
  check::transform(d.to_world, "to_world");
  check::require(d.reserved == 0, "reserved is " + std::to_string(d.reserved) + "; it must be 0");
  return {instances_.add({number_of(d.mesh.v), to_affine(d.to_world), d.group, of_fixture})};
}

void Description::set_transform(ups_instance_id id, const double (&to_world)[12]) {
  InstanceDescription& instance = instances_.get(id.v, "instance");
  check::transform(to_world, "to_world");
  instance.to_world = to_affine(to_world);
}

// ---- what emits ----

void Description::set_maintenance_factor(double factor) {
  check::require(factor > 0 && factor <= 1,
                 "maintenance_factor is " + check::text(factor) + "; it must be above 0 and at most 1");
  maintenance_factor_ = factor;
}

ups_luminaire_id Description::add_light(const ups_light_desc& d) {
  check::enumeration(d.kind, UPS_LIGHT_DIRECTIONAL, "kind", "UPS_LIGHT_*");
  check::transform(d.to_world, "to_world");
  check::colour(d.intensity_rgb, 0, INFINITY, "intensity_rgb");
  if (d.kind == UPS_LIGHT_SPOT) {
    check::range(double(d.outer_cone_rad), 0, double(float(0.5 * 3.14159265358979)), "outer_cone_rad");
    check::require(d.inner_cone_rad >= 0 && d.inner_cone_rad < d.outer_cone_rad,
                   "inner_cone_rad is " + check::text(double(d.inner_cone_rad)) +
                       "; it must be at least 0 and less than outer_cone_rad, " +
                       check::text(double(d.outer_cone_rad)));
  }
  const LightDescription light{d.kind, to_affine(d.to_world), to_rgb(d.intensity_rgb), d.inner_cone_rad,
                               d.outer_cone_rad};
  return {sources_.add({light, 1.0f, d.group})};
}

ups_luminaire_id Description::add_luminaire(const ups_luminaire_desc& d,
                                            std::shared_ptr<const photometry::Photometry> profile) {
  check::flag(d.use_opening, "use_opening");
  check::pointer(profile.get(), "profile");
  check::transform(d.to_world, "to_world");
  check::colour(d.color_rgb, 0, INFINITY, "color_rgb");
  const float y = luminance(to_rgb(d.color_rgb));
  check::require(y > 0 && std::isfinite(y),
                 "color_rgb is black; it must have a luminance above 0 (flux sets how much light)");
  check::finite(double(d.flux_lm), "flux_lm");
  check::at_least(double(d.dimming), 0, "dimming");
  check::at_least(double(d.intensity_scale), 0, "intensity_scale");
  check::require(
      d.flux_lm <= 0 || profile->distribution.band_flux_lm() > 0,
      "flux_lm is " + check::text(double(d.flux_lm)) + ", but the profile emits nothing that could be scaled to it");
  LuminaireDescription luminaire{std::move(profile),      d.use_opening == 1, to_affine(d.to_world),
                                 to_rgb(d.color_rgb) / y, d.flux_lm,          d.intensity_scale};
  check::require(d.reserved == 0, "reserved is " + std::to_string(d.reserved) + "; it must be 0");
  return {sources_.add({std::move(luminaire), d.dimming, d.group})};
}

void Description::set_dimming(ups_luminaire_id id, float dimming) {
  SourceDescription& source = sources_.get(id.v, "luminaire");
  check::at_least(double(dimming), 0, "dimming");
  source.dimming = dimming;
}

// ---- sensors ----

ups_sensor_id Description::add_camera(const ups_camera_desc& d) {
  check::enumeration(d.projection, UPS_PANORAMA, "projection",
                     "UPS_PERSPECTIVE, UPS_EQUIDISTANT, UPS_EQUISOLID, UPS_PANORAMA");
  check_count(d.width, 1, 16384, "width");
  check_count(d.height, 1, 16384, "height");
  check::transform(d.to_world, "to_world");
  check::require(
      d.projection != UPS_PERSPECTIVE || (d.vertical_fov_rad > 0 && double(d.vertical_fov_rad) < 3.14159265358979),
      "vertical_fov_rad is " + check::text(double(d.vertical_fov_rad)) + "; it must be above 0 and below pi");
  check::flag(d.illuminance, "illuminance");
  constexpr uint32_t all = UPS_LAYER_ALBEDO | UPS_LAYER_NORMAL | UPS_LAYER_DEPTH | UPS_LAYER_ID;
  check::require((d.layers & ~all) == 0,
                 "layers is " + std::to_string(d.layers) + "; it must be UPS_LAYER_* joined by |, at most " +
                     std::to_string(all));
  check::require(d.reserved == 0, "reserved is " + std::to_string(d.reserved) + "; it must be 0");
  return {sensors_.add(CameraDescription{to_affine(d.to_world), d.width, d.height, d.vertical_fov_rad,
                                         d.illuminance == 1, d.projection, d.layers})};
}

ups_sensor_id Description::add_meters(const ups_meter_desc& d) {
  check::enumeration(d.kind, UPS_METER_VECTOR, "kind", "UPS_METER_*");
  check_count(d.count, 1, max_meters, "count");
  check::require(d.reserved == 0, "reserved is " + std::to_string(d.reserved) + "; it must be 0");
  check::pointer(d.positions_m, "positions_m");
  check::pointer(d.normals, "normals");
  const float width = d.cell_size_m[0], height = d.cell_size_m[1];
  const bool cells = width > 0 && height > 0 && std::isfinite(width) && std::isfinite(height);
  check::require(cells || (width == 0 && height == 0), "cell_size_m is " + check::text(double(width)) + ", " +
                                                           check::text(double(height)) +
                                                           "; it must be 0, 0 (points) or both above 0");
  if (cells) check::pointer(d.tangents, "tangents");
  check::at_least(double(d.footprint_m), 0, "footprint_m");
  check::require(!(cells && d.footprint_m > 0),
                 "footprint_m is " + check::text(double(d.footprint_m)) +
                     " beside cell_size_m; a mean is over a disc or a rectangle: leave one of them 0");
  check::require(d.reserved_2 == 0, "reserved_2 is " + std::to_string(d.reserved_2) + "; it must be 0");
  for (size_t i = 0; i < d.count; ++i)
    for (size_t k = 0; k < 3; ++k)
      if (!std::isfinite(d.positions_m[3 * i + k]))
        fail_argument("positions_m: element " + std::to_string(i) + ", component " + std::to_string(k) + " is " +
                      check::text(d.positions_m[3 * i + k]) + "; it must be finite");
  const check::Floats normals{d.normals, d.count, 3, 0}, tangents{d.tangents, d.tangents ? d.count : 0, 3, 0};
  check::all_finite(normals, "normals", "");
  check::all_finite(tangents, "tangents", "");
  MetersDescription meters{d.kind, nullptr, read_vectors(normals), read_vectors(tangents), width, height,
                           d.footprint_m};
  std::vector<Vec3d> positions;
  for (size_t i = 0; i < d.count; ++i) {
    const double* p = d.positions_m + 3 * i;
    positions.emplace_back(p[0], p[1], p[2]);
    const Vec3d n(meters.normals[i]);
    if (!(length(n) > 0))
      fail_argument("normals: element " + std::to_string(i) + " has length 0; it must point somewhere");
    if (d.kind == UPS_METER_SEMICYLINDRICAL && !(std::hypot(n.x, n.y) > 1e-6 * length(n)))
      fail_argument("normals: element " + std::to_string(i) +
                    " is vertical; a semicylindrical meter faces the horizontal part of its normal");
    if (meters.tangents.empty()) continue;
    const Vec3d t(meters.tangents[i]);
    if (!(length(cross(n, t)) > 1e-6 * length(n) * length(t)))
      fail_argument("tangents: element " + std::to_string(i) +
                    " is parallel to its normal, or 0; it must point along a side");
  }
  meters.positions = std::make_shared<const std::vector<Vec3d>>(std::move(positions));
  return {sensors_.add(std::move(meters))};
}

std::vector<uint32_t> Description::check_instances(const ups_instance_id* ids, uint32_t count,
                                                   uint64_t& triangles) const {
  check_count(count, 1, max_id_number, "instance_count");
  check::pointer(ids, "instances");
  std::vector<uint32_t> numbers;
  std::set<uint32_t> seen;
  for (uint32_t i = 0; i < count; ++i) {
    const std::string field = check::element("instances", i);
    check::require(ids[i].v != 0, field + " is 0; it must be an instance of the scene");
    const InstanceDescription& instance = instances_.get(ids[i].v, (field + ": instance").c_str());
    const Mesh& mesh = *meshes_.at(instance.mesh);
    numbers.push_back(number_of(ids[i].v));
    check::require(seen.insert(numbers.back()).second,
                   field + ": instance " + std::to_string(numbers.back()) + " is listed twice");
    check::require(!mesh.revolution, field + ": instance " + std::to_string(numbers.back()) +
                                         " is a curved part of a fixture, which has no triangles; meters on surfaces "
                                         "want an instance of a mesh");
    triangles += mesh.triangle_count();
  }
  return numbers;
}

ups_sensor_id Description::add_surface_meters(const ups_surface_meters_desc& d) {
  uint64_t triangles = 0;
  SurfaceMetersDescription meters{check_instances(d.instances, d.instance_count, triangles), d.back == 1, 0, 0};
  check::require(triangles <= max_meters, "instances have " + std::to_string(triangles) +
                                              " triangles together; a set measures at most " +
                                              std::to_string(max_meters));
  check::flag(d.back, "back");
  check::require(d.reserved == 0, "reserved is " + std::to_string(d.reserved) + "; it must be 0");
  return {sensors_.add(std::move(meters))};
}

ups_sensor_id Description::add_lightmap(const ups_lightmap_desc& d) {
  uint64_t triangles = 0;
  SurfaceMetersDescription map{check_instances(d.instances, d.instance_count, triangles), d.back == 1, d.width,
                               d.height};
  check_count(d.width, 1, 16384, "width");
  check_count(d.height, 1, 16384, "height");
  check::require(uint64_t(d.width) * d.height <= max_meters,
                 "width * height is " + std::to_string(uint64_t(d.width) * d.height) + "; it must be at most " +
                     std::to_string(max_meters));
  for (const uint32_t number : map.instances)
    check::require(!meshes_.at(instances_.at(number).mesh)->uvs.empty(),
                   "instances: the mesh of instance " + std::to_string(number) +
                       " has no uvs; a lightmap needs them to place its texels (ups_mesh_desc.uvs)");
  check::flag(d.back, "back");
  check::require(d.reserved == 0, "reserved is " + std::to_string(d.reserved) + "; it must be 0");
  return {sensors_.add(std::move(map))};
}

namespace {

// The angles as given, or equal steps; checked by element.
std::vector<double> angles_of(const float* given, uint32_t count, double step, double limit, bool limit_allowed,
                              const std::string& field) {
  std::vector<double> angles;
  for (uint32_t i = 0; i < count; ++i) {
    const double a = given ? double(given[i]) : i * step;
    check::require(a >= 0 && (a < limit || (limit_allowed && a == limit)),
                   check::element(field, i) + " is " + check::text(a) + "; it must be in [0, " + check::text(limit) +
                       (limit_allowed ? "]" : ")"));
    check::require(i == 0 || a > angles.back(),
                   check::element(field, i) + " is " + check::text(a) + "; it must be greater than the one before");
    angles.push_back(a);
  }
  return angles;
}

}  // namespace

ups_sensor_id Description::add_goniometer(const ups_goniometer_desc& d) {
  constexpr uint64_t most = photometry::Distribution::max_values;
  check::enumeration(d.symmetry, UPS_SYMMETRY_QUADRANTS, "symmetry", "UPS_SYMMETRY_*");
  check::enumeration(d.opening_shape, UPS_OPENING_SPHERE, "opening_shape", "UPS_OPENING_*");
  check_count(d.c_count, 1, most, "c_count");
  check_count(d.gamma_count, 2, most, "gamma_count");
  check::require(uint64_t(d.c_count) * d.gamma_count <= most,
                 "c_count * gamma_count is " + std::to_string(uint64_t(d.c_count) * d.gamma_count) +
                     "; it must be at most " + std::to_string(most));
  check::transform(d.to_world, "to_world");
  GoniometerDescription g{to_affine(d.to_world), d.symmetry, {}, {}, {}};
  g.c_deg = angles_of(d.c_deg, d.c_count, 360.0 / d.c_count, 360, false, "c_deg");
  g.gamma_deg = angles_of(d.gamma_deg, d.gamma_count, 180.0 / (d.gamma_count - 1), 180, true, "gamma_deg");
  check::require(g.c_deg[0] == 0, "c_deg[0] is " + check::text(g.c_deg[0]) + "; the first plane must be 0");
  if (!d.gamma_deg) g.gamma_deg.back() = 180;
  g.opening.shape = photometry::OpeningShape(d.opening_shape);
  for (int k = 0; k < 3; ++k) {
    check::range(double(d.opening_m[k]), 0, 1e6, check::element("opening_m", size_t(k)));
    g.opening.size_m[k] = d.opening_m[k];
  }
  Goniometer(Frame(Vec3(0, 0, 1)), g.c_deg, g.gamma_deg, Goniometer::Symmetry(d.symmetry));  // throws what is wrong
  return {sensors_.add(std::move(g))};
}

ups_sensor_id Description::add_observer(const ups_observer_desc& d) {
  check::enumeration(d.metric, UPS_GLARE_METRIC_UGR, "metric", "UPS_GLARE_METRIC_*");
  check::enumeration(d.position_index, UPS_POSITION_INDEX_GUTH, "position_index", "UPS_POSITION_INDEX_*");
  check::finite(d.ceiling_area_m2, "ceiling_area_m2");
  check::require(d.ceiling_area_m2 >= 0, "ceiling_area_m2 is " + check::text(d.ceiling_area_m2) +
                                             "; it must be above 0, or 0 for the scene's extent");
  check::transform(d.to_world, "to_world");
  return {sensors_.add(ObserverDescription{to_affine(d.to_world), d.position_index, d.ceiling_area_m2})};
}

}  // namespace ups
