// See fixture_parts.h: finishes, then a function for each kind of part.
#include "api/fixture_parts.h"

#include <algorithm>
#include <cmath>

#include "api/desc.h"
#include "scene/check.h"

namespace ups::api {
namespace {

constexpr double default_chord = 1e-3, default_normal = 0.1 * optics::pi / 180;  // of the largest radius; rad
constexpr double default_round_normal = 10 * optics::pi / 180;  // not the triangles' normals are traced there
// Of discs and cylinders that shine: these stay polygons, inside of what surrounds them, whose radius counts in a beam.
constexpr double default_emitter_chord = 1e-4;
constexpr uint32_t max_facets = 100'000;

// ---- finishes ----

// In place of a finish's own numbers; < 0: none.
struct Numbers {
  float reflectance = -1, transmittance = -1, roughness = -1, absorption_per_m = -1, ior = -1;
};

void fill(float (&rgb)[3], float value) { std::fill(std::begin(rgb), std::end(rgb), value); }

struct Finish {
  const char* name;
  ups_material_model model;
  Numbers own;  // < 0: has no such number
};
constexpr Finish finishes[] = {
    {"SPECULAR_ALUMINIUM", UPS_MATERIAL_MIRROR, {0.86f}},
    {"ENHANCED_ALUMINIUM", UPS_MATERIAL_MIRROR, {0.95f}},
    {"SEMI_SPECULAR_ALUMINIUM", UPS_MATERIAL_METAL, {0.86f, -1, 0.35f}},
    {"MATTE_WHITE", UPS_MATERIAL_MATTE, {0.90f}},
    {"BLACK", UPS_MATERIAL_MATTE, {}},
    {"OPAL", UPS_MATERIAL_DIFFUSER, {0.35f, 0.60f}},
    {"PMMA", UPS_MATERIAL_GLASS, {-1, -1, -1, 0.2f, 1.49f}},
    {"POLYCARBONATE", UPS_MATERIAL_GLASS, {-1, -1, -1, 4.6f, 1.585f}},
    {"GLASS", UPS_MATERIAL_GLASS, {-1, -1, -1, 2.2f, 1.52f}},
    {"FROSTED_PMMA", UPS_MATERIAL_GLASS, {-1, -1, 0.5f, 0.2f, 1.49f}},
};
static_assert(std::size(finishes) == UPS_FINISH_CUSTOM);

// The given number, or the finish's own.
float number(const Finish& finish, float own, float given, const char* field) {
  if (!(given < 0) && own < 0)
    fail_argument(std::string(field) + " is " + check::text(double(given)) + ", but UPS_FINISH_" + finish.name +
                  " has no such number; leave it below 0");
  return given < 0 ? own : given;
}

ups_material_desc custom(const ups_material_desc* given, const Numbers& numbers) {
  check::pointer(given, "material");
  const std::pair<float, const char*> unused[] = {{numbers.reflectance, "finish_reflectance"},
                                                  {numbers.transmittance, "finish_transmittance"},
                                                  {numbers.roughness, "finish_roughness"},
                                                  {numbers.absorption_per_m, "finish_absorption_per_m"},
                                                  {numbers.ior, "finish_ior"}};
  for (const auto& [value, field] : unused)
    check::require(value < 0, std::string(field) + " is " + check::text(double(value)) +
                                  "; with UPS_FINISH_CUSTOM it must be below 0, as *material says it");
  const ups_material_desc d = read_desc(given, &ups_material_desc_init);
  for (const ups_texture_id& id :
       {d.reflectance_texture, d.roughness_texture, d.metallic_texture, d.normal_texture, d.alpha_texture})
    check::require(id.v == 0, "material: a texture is set; a fixture belongs to no scene, so its parts have none");
  for (const float l : d.luminance_cd_m2)
    check::require(l == 0, "material: luminance_cd_m2 is not 0; light comes from ups_fixture_add_emitter");
  return d;
}

ups_material_desc material_of(ups_finish finish, const Numbers& given, const ups_material_desc* material) {
  check::enumeration(finish, UPS_FINISH_CUSTOM, "finish", "UPS_FINISH_*");
  if (finish != UPS_FINISH_CUSTOM)
    check::require(!material, "material is set; with UPS_FINISH_" + std::string(finishes[finish].name) +
                                  " it must be NULL, or finish UPS_FINISH_CUSTOM");
  ups_material_desc d;
  if (finish == UPS_FINISH_CUSTOM) {
    d = custom(material, given);
  } else {
    const Finish& f = finishes[finish];
    ups_material_desc_init(&d, sizeof d);
    d.model = f.model;
    fill(d.reflectance_rgb, std::max(0.0f, number(f, f.own.reflectance, given.reflectance, "finish_reflectance")));
    fill(d.transmittance_rgb, number(f, f.own.transmittance, given.transmittance, "finish_transmittance"));
    d.roughness = std::max(0.0f, number(f, f.own.roughness, given.roughness, "finish_roughness"));
    fill(d.absorption_per_m_rgb,
         std::max(0.0f, number(f, f.own.absorption_per_m, given.absorption_per_m, "finish_absorption_per_m")));
    const float ior = number(f, f.own.ior, given.ior, "finish_ior");
    if (ior >= 0) d.ior = ior;
  }
  Description().add_material(d);  // for its checks
  return d;
}

void require_solid(const ups_material_desc& material) {
  check::require(
      material.model == UPS_MATERIAL_GLASS,
      "finish is a sheet's; a solid needs UPS_FINISH_PMMA, _POLYCARBONATE, _GLASS, _FROSTED_PMMA, or _CUSTOM "
      "with UPS_MATERIAL_GLASS");
}

// ---- what all parts have ----

void facets(uint32_t count, uint32_t low, const char* field) {
  check::require(count == 0 || (count >= low && count <= max_facets),
                 std::string(field) + " is " + std::to_string(count) + "; it must be 0 or " + std::to_string(low) +
                     " to " + std::to_string(max_facets));
}

optics::Mesh triangles(const optics::Profile& profile, double chord, double normal, double size) {
  const double usual = profile.facets_around > 0 ? default_normal : default_round_normal;
  return optics::tessellate(profile, {chord == 0 ? default_chord * size : chord, normal == 0 ? usual : normal});
}

// What the bands of a round mesh are to the ray tracer; null where it has none.
std::shared_ptr<const Revolution> revolution(const optics::Mesh& mesh) {
  if (mesh.bands.empty()) return nullptr;
  auto out = std::make_shared<Revolution>();
  out->columns = mesh.columns;
  double size = 0;
  size_t triangle = 0;
  for (const optics::Band& b : mesh.bands) {
    for (const double v : {b.from.r, b.from.z, b.to.r, b.to.z}) size = std::max(size, std::abs(v));
    out->bands.push_back({b.from.r, b.from.z, b.to.r, b.to.z, b.square_r, b.square_z, b.linear, b.bulge,
                          uint32_t(triangle)});
    triangle += mesh.columns * (b.from.r == 0 || b.to.r == 0 ? 1 : 2);
  }
  out->margin = 1e-10 * size;
  return out;
}

// Of a part that is traced as the shape that it is.
void set_shape(FixturePart& part, const optics::Profile& profile, double chord, double normal, double size) {
  part.mesh = triangles(profile, chord, normal, size);
  part.revolution = revolution(part.mesh);
}

std::vector<optics::Point> points(const double* rz, uint32_t count, const char* field, const char* count_field) {
  check::require(count >= 2 && count <= 100'000,
                 std::string(count_field) + " is " + std::to_string(count) + "; it must be 2 to 100000");
  check::pointer(rz, field);
  std::vector<optics::Point> out;
  for (uint32_t i = 0; i < count; ++i) out.push_back({rz[2 * i], rz[2 * i + 1]});
  return out;
}

// A field that the chosen kind of part does not read; what is set in vain is a mistake.
void unused(double value, const char* field, const char* kind) {
  check::require(value == 0,
                 std::string(field) + " is " + check::text(value) + "; " + kind + " has none, it must be 0");
}

}  // namespace

Affine rigid(const double (&m)[12], const std::string& field) {
  check::transform(m, field);
  Affine a;
  std::copy(std::begin(m), std::end(m), a.m);
  double worst = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) worst = std::max(worst, std::abs(dot(a.column(i), a.column(j)) - (i == j ? 1 : 0)));
  check::require(worst <= 1e-5 && a.determinant() > 0,
                 field + " scales, shears or mirrors (columns' products differ from 0 and 1 by " + check::text(worst) +
                     ", determinant " + check::text(a.determinant()) + "); it must be a rotation and a translation");
  return a;
}

// ---- emitters ----

namespace {

// As large as the sphere: so is what is seen of it, in the mean over directions (Cauchy: a quarter of the surface).
optics::Mesh sphere_mesh(double radius, double chord) {
  optics::Mesh mesh = triangles(optics::sphere(radius), chord, optics::pi, radius);
  const double scale = std::sqrt(4 * optics::pi * radius * radius / optics::area(mesh));
  if (std::isfinite(scale))
    for (float& v : mesh.positions) v = float(double(v) * scale);
  return mesh;
}

// Normals are not used: the emission is that of the flat triangles.
optics::Mesh emitter_mesh(const ups_fixture_emitter_desc& d) {
  const auto mesh = [&](const optics::Profile& profile) {
    const double chord = d.chord_tolerance_m == 0 ? default_emitter_chord * d.radius_m : d.chord_tolerance_m;
    return triangles(profile, chord, optics::pi, optics::largest_radius(profile));
  };
  switch (d.shape) {
    case UPS_EMITTER_RECTANGLE:
      unused(d.radius_m, "radius_m", "a rectangle");
      return optics::rectangle(d.width_m, d.length_m);
    case UPS_EMITTER_CYLINDER:
      unused(d.width_m, "width_m", "a cylinder");
      return mesh(optics::cylinder(d.radius_m, d.length_m));
    default:
      unused(d.width_m, "width_m", "a disc or a sphere");
      unused(d.length_m, "length_m", "a disc or a sphere");
      return d.shape == UPS_EMITTER_DISC ? mesh(optics::disc(d.radius_m))
                                         : sphere_mesh(d.radius_m, d.chord_tolerance_m);
  }
}

}  // namespace

FixturePart make_part(const ups_fixture_emitter_desc& d) {
  check::enumeration(d.shape, UPS_EMITTER_CYLINDER, "shape", "UPS_EMITTER_*");
  check::range(double(d.reflectance), 0, 1, "reflectance");
  check::at_least(double(d.flux_lm), 0, "flux_lm");
  check::colour(d.color_rgb, 0, INFINITY, "color_rgb");
  check::require(d.reserved == 0, "reserved is " + check::text(double(d.reserved)) + "; it must be 0");
  const Rgb rgb{d.color_rgb[0], d.color_rgb[1], d.color_rgb[2]};
  const float y = luminance(rgb);
  check::require(y > 0 && std::isfinite(y),
                 "color_rgb is black; it must have a luminance above 0 (flux_lm sets how much light)");
  FixturePart part;
  part.to_fixture = rigid(d.to_fixture, "to_fixture");
  part.mesh = emitter_mesh(d);
  part.area_m2 = optics::area(part.mesh);
  part.mesh.normals.clear();
  part.flux_lm = double(d.flux_lm);
  part.color = rgb / y;
  part.material = material_of(UPS_FINISH_MATTE_WHITE, {d.reflectance}, nullptr);
  check::require(part.area_m2 > 0, "the emitter is too small: its triangles have no area in single precision");
  return part;
}

// ---- reflectors ----

namespace {

optics::Profile reflector_profile(const ups_reflector_desc& d) {
  if (d.profile != UPS_REFLECTOR_PARABOLOID) unused(d.focal_length_m, "focal_length_m", "this profile");
  if (d.profile != UPS_REFLECTOR_ELLIPSOID) {
    unused(d.semi_axis_m, "semi_axis_m", "this profile");
    unused(d.half_distance_m, "half_distance_m", "this profile");
  }
  switch (d.profile) {
    case UPS_REFLECTOR_PARABOLOID:
      unused(d.depth_m, "depth_m", "a paraboloid");
      return optics::paraboloid(d.focal_length_m, d.inner_radius_m, d.aperture_radius_m);
    case UPS_REFLECTOR_ELLIPSOID:
      return optics::ellipsoid(d.semi_axis_m, d.half_distance_m, d.inner_radius_m, d.aperture_radius_m, d.depth_m);
    case UPS_REFLECTOR_CONE:
      return optics::cone(d.inner_radius_m, d.aperture_radius_m, d.depth_m);
    case UPS_REFLECTOR_CYLINDER:
      unused(d.inner_radius_m, "inner_radius_m", "a cylinder");
      return optics::cone(d.aperture_radius_m, d.aperture_radius_m, d.depth_m);
    default:
      unused(d.inner_radius_m, "inner_radius_m", "a polyline");
      unused(d.aperture_radius_m, "aperture_radius_m", "a polyline");
      unused(d.depth_m, "depth_m", "a polyline");
      check::require(d.facets_along == 0, "facets_along is " + std::to_string(d.facets_along) +
                                              "; with a polyline it must be 0 (smooth 0 makes its pieces flat)");
      return optics::polyline(points(d.profile_rz_m, d.profile_point_count, "profile_rz_m", "profile_point_count"),
                              d.smooth == 1);
  }
}

}  // namespace

FixturePart make_part(const ups_reflector_desc& d) {
  check::enumeration(d.profile, UPS_REFLECTOR_POLYLINE, "profile", "UPS_REFLECTOR_*");
  check::flag(d.smooth, "smooth");
  facets(d.facets_around, 3, "facets_around");
  facets(d.facets_along, 1, "facets_along");
  FixturePart part;
  part.to_fixture = rigid(d.to_fixture, "to_fixture");
  part.material = material_of(d.finish, {d.finish_reflectance, d.finish_transmittance, d.finish_roughness}, d.material);
  check::require(part.material.model != UPS_MATERIAL_GLASS,
                 "finish is a solid's; a reflector is an open sheet and needs a sheet's");
  optics::Profile profile = reflector_profile(d);
  profile.facets_around = d.facets_around;
  if (d.facets_along > 0) profile.sections.front().facets_along = d.facets_along;
  set_shape(part, profile, d.chord_tolerance_m, d.normal_tolerance_rad, optics::largest_radius(profile));
  return part;
}

// ---- solids ----

FixturePart make_part(const ups_lens_desc& d) {
  facets(d.facets_around, 3, "facets_around");
  FixturePart part;
  part.to_fixture = rigid(d.to_fixture, "to_fixture");
  part.material =
      material_of(d.finish, {-1, -1, d.finish_roughness, d.finish_absorption_per_m, d.finish_ior}, d.material);
  require_solid(part.material);
  optics::Face entry{d.entry_radius_m, d.entry_conic, {}}, exit{d.exit_radius_m, d.exit_conic, {}};
  std::copy(std::begin(d.entry_coefficients), std::end(d.entry_coefficients), entry.coefficients.begin());
  std::copy(std::begin(d.exit_coefficients), std::end(d.exit_coefficients), exit.coefficients.begin());
  optics::Profile profile = optics::lens(entry, exit, d.radius_m, d.thickness_m);
  profile.facets_around = d.facets_around;
  set_shape(part, profile, d.chord_tolerance_m, d.normal_tolerance_rad, d.radius_m);
  return part;
}

FixturePart make_part(const ups_collimator_desc& d) {
  check::enumeration(d.wall, UPS_COLLIMATOR_POLYLINE, "wall", "UPS_COLLIMATOR_*");
  check::flag(d.smooth, "smooth");
  facets(d.facets_around, 3, "facets_around");
  facets(d.exit_facets_along, 1, "exit_facets_along");
  if (d.wall != UPS_COLLIMATOR_PARALLEL) unused(d.wall_thickness_m, "wall_thickness_m", "this wall");
  if (d.wall != UPS_COLLIMATOR_PARABOLOID) unused(d.wall_focal_length_m, "wall_focal_length_m", "this wall");
  FixturePart part;
  part.to_fixture = rigid(d.to_fixture, "to_fixture");
  part.material =
      material_of(d.finish, {-1, -1, d.finish_roughness, d.finish_absorption_per_m, d.finish_ior}, d.material);
  require_solid(part.material);
  optics::Collimator c;
  c.cavity_radius_m = d.cavity_radius_m, c.cavity_depth_m = d.cavity_depth_m;
  c.wall_thickness_m = d.wall_thickness_m, c.ior = double(part.material.ior);
  c.lens = {d.lens_radius_m, d.lens_conic, {}};
  c.wall = optics::Collimator::Wall(d.wall);  // both enumerations count alike
  c.focal_length_m = d.wall_focal_length_m, c.height_m = d.height_m, c.smooth = d.smooth == 1;
  if (d.wall == UPS_COLLIMATOR_POLYLINE)
    c.wall_points = points(d.wall_rz_m, d.wall_point_count, "wall_rz_m", "wall_point_count");
  c.exit = {d.exit_radius_m, d.exit_conic, {}};
  c.exit_facets_along = d.exit_facets_along, c.facets_around = d.facets_around;
  const optics::Profile profile = optics::collimator(c);
  set_shape(part, profile, d.chord_tolerance_m, d.normal_tolerance_rad, optics::largest_radius(profile));
  return part;
}
static_assert(int(optics::Collimator::Wall::polyline) == UPS_COLLIMATOR_POLYLINE);

FixturePart make_part(const ups_fixture_part_desc& d) {
  check::require(d.reserved == 0, "reserved is " + check::text(double(d.reserved)) + "; it must be 0");
  FixturePart part;
  part.to_fixture = rigid(d.to_fixture, "to_fixture");
  part.material = material_of(
      d.finish,
      {d.finish_reflectance, d.finish_transmittance, d.finish_roughness, d.finish_absorption_per_m, d.finish_ior},
      d.material);
  check::pointer(d.mesh, "mesh");
  ups_mesh_desc mesh = read_desc(d.mesh, &ups_mesh_desc_init);
  check::require(mesh.material.v == 0, "mesh: material is " + std::to_string(mesh.material.v) +
                                           "; it must be 0, as the part's finish is its material");
  Description scratch;  // checks and copies
  mesh.material = scratch.add_material(part.material);
  mesh.uvs = mesh.tangents = nullptr;
  const ups_mesh_id id = scratch.add_mesh(mesh);
  const Mesh& copy = *scratch.meshes().get(id.v, "mesh");
  for (const Vec3& p : copy.positions) part.mesh.positions.insert(part.mesh.positions.end(), {p.x, p.y, p.z});
  for (const Vec3& n : copy.normals) part.mesh.normals.insert(part.mesh.normals.end(), {n.x, n.y, n.z});
  part.mesh.indices = copy.indices;
  if (part.material.model == UPS_MATERIAL_GLASS)
    check::require(optics::topology(part.mesh).closed,
                   "mesh is not closed; a solid finish needs a surface in which each edge is shared by two triangles, "
                   "turned outwards");
  return part;
}

}  // namespace ups::api
