// `extras.ups.fixture` of a node: a luminaire of emitters, reflectors, lenses and collimators, built through the core's
// fixtures. Words are those of ups_fixture.h; lengths in metres, angles in degrees. Nodes of the same parts share one.
#include <cmath>
#include <limits>

#include "gltf/import.h"

namespace ups::gltf {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double degree = 0.017453292519943295;
constexpr int64_t max_count = 1000000;  // the core has limits of its own

bool same(const Json& a, const Json& b) {
  if (a.kind != b.kind || a.boolean != b.boolean || a.number != b.number || a.text != b.text ||
      a.items.size() != b.items.size() || a.members.size() != b.members.size()) {
    return false;
  }
  for (size_t i = 0; i < a.items.size(); ++i) {
    if (!same(a.items[i], b.items[i])) return false;
  }
  for (size_t i = 0; i < a.members.size(); ++i) {
    if (a.members[i].name != b.members[i].name || !same(a.members[i].value, b.members[i].value)) return false;
  }
  return true;
}

// Place of a word in a list; the field itself is left alone where the word is missing.
void read_choice(const JsonReader& part, const char* key, std::initializer_list<const char*> words, int32_t& value) {
  if (!part.has(key)) return;
  const std::string word = part.text(key, "");
  std::string all;
  int32_t i = 0;
  for (const char* candidate : words) {
    if (word == candidate) {
      value = i;
      return;
    }
    all += (all.empty() ? "" : ", ") + std::string(candidate);
    ++i;
  }
  part.fail(key, "must be one of " + all);
}

// Lengths and other numbers that the core checks.
void read_numbers(const JsonReader& part, std::initializer_list<std::pair<const char*, double*>> fields) {
  for (const auto& [key, value] : fields) *value = part.number(key, *value, -unlimited, unlimited);
}
void read_count(const JsonReader& part, const char* key, uint32_t& value) {
  value = uint32_t(part.integer(key, value, 0, max_count));
}

template <class Desc>
void read_tolerances(const JsonReader& part, Desc& desc) {
  read_numbers(part, {{"chord_tolerance_m", &desc.chord_tolerance_m}});
  desc.normal_tolerance_rad = part.number("normal_tolerance_deg", 0, 0, 180) * degree;
}

// "position_m" and "rotation" (a quaternion, as a node's), of every part.
template <class Desc>
void read_place(const JsonReader& part, Desc& desc) {
  tinygltf::Node place;
  place.translation = part.numbers("position_m", 3, -unlimited, unlimited).value_or(std::vector<double>{});
  place.rotation = part.numbers("rotation", 4, -unlimited, unlimited).value_or(std::vector<double>{});
  const Affine frame = local_transform(place, part.where()).full;
  std::copy(std::begin(frame.m), std::end(frame.m), desc.to_fixture);
}

std::vector<double> read_points(const JsonReader& part, const char* key) {
  std::vector<double> rz;
  for (const Json& item : part.array(key)) {
    const bool good = item.is_array() && item.items.size() == 2 && item.items[0].kind == Json::Kind::number &&
                      item.items[1].kind == Json::Kind::number;
    if (!good) part.fail(key, "must be an array of [r, z]; its element " + std::to_string(rz.size() / 2) + " is not");
    rz.insert(rz.end(), {item.items[0].number, item.items[1].number});
  }
  return rz;
}

void read_finish_number(const JsonReader& part, const char* key, float& value) {
  if (part.has(key)) value = float(part.number(key, 0, 0, unlimited));
}

}  // namespace

void FixtureDeleter::operator()(ups_fixture* fixture) const { ups_fixture_destroy(fixture); }

// A word, or an object in the words of a material's extras.ups. `custom` must outlive the desc.
template <class Desc>
void Importer::read_finish(const JsonReader& part, Desc& desc, ups_material_desc& custom) {
  const Json* finish = part.json().find("finish");
  if (finish && finish->is_object()) {
    ups_material_desc_init(&custom, sizeof custom);
    read_extras_material(*part.object("finish"), custom);
    desc.finish = UPS_FINISH_CUSTOM;
    desc.material = &custom;
  } else {
    read_choice(part, "finish",
                {"specular_aluminium", "enhanced_aluminium", "semi_specular_aluminium", "matte_white", "black", "opal",
                 "pmma", "polycarbonate", "glass", "frosted_pmma"},
                desc.finish);
  }
  read_finish_number(part, "roughness", desc.finish_roughness);
  if constexpr (requires { desc.finish_reflectance; }) {
    read_finish_number(part, "reflectance", desc.finish_reflectance);
    read_finish_number(part, "transmittance", desc.finish_transmittance);
  } else {
    read_finish_number(part, "absorption_per_m", desc.finish_absorption_per_m);
    read_finish_number(part, "ior", desc.finish_ior);
  }
}

void Importer::add_emitter(ups_fixture* fixture, const JsonReader& part) {
  part.allow_only({"shape", "radius_m", "width_m", "length_m", "flux_lm", "colour_temperature_k", "reflectance",
                   "position_m", "rotation", "chord_tolerance_m"});
  ups_fixture_emitter_desc desc;
  ups_fixture_emitter_desc_init(&desc, sizeof desc);
  read_choice(part, "shape", {"disc", "rectangle", "sphere", "cylinder"}, desc.shape);
  read_place(part, desc);
  read_numbers(part, {{"radius_m", &desc.radius_m},
                      {"width_m", &desc.width_m},
                      {"length_m", &desc.length_m},
                      {"chord_tolerance_m", &desc.chord_tolerance_m}});
  if (!part.has("flux_lm")) part.fail("flux_lm", "is missing: what leaves the emitter");
  desc.flux_lm = float(part.number("flux_lm", 0, 0, largest_float));
  desc.reflectance = float(part.number("reflectance", 0, 0, 1));
  read_colour_temperature(part, desc.color_rgb);
  check_part(ups_fixture_add_emitter(fixture, &desc, nullptr), part.where());
}

void Importer::add_reflector(ups_fixture* fixture, const JsonReader& part) {
  part.allow_only({"profile", "focal_length_m", "semi_axis_m", "half_distance_m", "inner_radius_m", "aperture_radius_m",
                   "depth_m", "points_m", "smooth", "finish", "reflectance", "transmittance", "roughness", "position_m",
                   "rotation", "facets_around", "facets_along", "chord_tolerance_m", "normal_tolerance_deg"});
  ups_reflector_desc desc;
  ups_material_desc custom;
  ups_reflector_desc_init(&desc, sizeof desc);
  read_choice(part, "profile", {"paraboloid", "ellipsoid", "cone", "cylinder", "polyline"}, desc.profile);
  read_place(part, desc);
  read_numbers(part, {{"focal_length_m", &desc.focal_length_m},
                      {"semi_axis_m", &desc.semi_axis_m},
                      {"half_distance_m", &desc.half_distance_m},
                      {"inner_radius_m", &desc.inner_radius_m},
                      {"aperture_radius_m", &desc.aperture_radius_m},
                      {"depth_m", &desc.depth_m}});
  const std::vector<double> points = read_points(part, "points_m");
  if (!points.empty() && desc.profile != UPS_REFLECTOR_POLYLINE) part.fail("points_m", "needs the profile polyline");
  desc.profile_rz_m = points.data();
  desc.profile_point_count = uint32_t(points.size() / 2);
  desc.smooth = part.boolean("smooth", desc.smooth != 0);
  read_count(part, "facets_around", desc.facets_around);
  read_count(part, "facets_along", desc.facets_along);
  read_tolerances(part, desc);
  read_finish(part, desc, custom);
  check_part(ups_fixture_add_reflector(fixture, &desc, nullptr), part.where());
}

void Importer::add_lens(ups_fixture* fixture, const JsonReader& part) {
  part.allow_only({"radius_m", "thickness_m", "entry_radius_m", "entry_conic", "entry_coefficients", "exit_radius_m",
                   "exit_conic", "exit_coefficients", "finish", "roughness", "absorption_per_m", "ior", "position_m",
                   "rotation", "facets_around", "chord_tolerance_m", "normal_tolerance_deg"});
  ups_lens_desc desc;
  ups_material_desc custom;
  ups_lens_desc_init(&desc, sizeof desc);
  read_place(part, desc);
  read_numbers(part, {{"radius_m", &desc.radius_m},
                      {"thickness_m", &desc.thickness_m},
                      {"entry_radius_m", &desc.entry_radius_m},
                      {"entry_conic", &desc.entry_conic},
                      {"exit_radius_m", &desc.exit_radius_m},
                      {"exit_conic", &desc.exit_conic}});
  for (const auto& [key, values] :
       {std::pair{"entry_coefficients", desc.entry_coefficients}, {"exit_coefficients", desc.exit_coefficients}}) {
    if (const auto given = part.numbers(key, 4, -unlimited, unlimited)) std::copy(given->begin(), given->end(), values);
  }
  read_count(part, "facets_around", desc.facets_around);
  read_tolerances(part, desc);
  read_finish(part, desc, custom);
  check_part(ups_fixture_add_lens(fixture, &desc, nullptr), part.where());
}

void Importer::add_collimator(ups_fixture* fixture, const JsonReader& part) {
  part.allow_only({"cavity_radius_m",
                   "cavity_depth_m",
                   "lens_radius_m",
                   "lens_conic",
                   "flat_lens",
                   "wall",
                   "wall_thickness_m",
                   "wall_focal_length_m",
                   "wall_points_m",
                   "smooth",
                   "height_m",
                   "exit_radius_m",
                   "exit_conic",
                   "exit_facets_along",
                   "finish",
                   "roughness",
                   "absorption_per_m",
                   "ior",
                   "position_m",
                   "rotation",
                   "facets_around",
                   "chord_tolerance_m",
                   "normal_tolerance_deg"});
  ups_collimator_desc desc;
  ups_material_desc custom;
  ups_collimator_desc_init(&desc, sizeof desc);
  read_choice(part, "wall", {"parallel", "paraboloid", "polyline"}, desc.wall);
  read_place(part, desc);
  read_numbers(part, {{"cavity_radius_m", &desc.cavity_radius_m},
                      {"cavity_depth_m", &desc.cavity_depth_m},
                      {"lens_radius_m", &desc.lens_radius_m},
                      {"lens_conic", &desc.lens_conic},
                      {"wall_thickness_m", &desc.wall_thickness_m},
                      {"wall_focal_length_m", &desc.wall_focal_length_m},
                      {"height_m", &desc.height_m},
                      {"exit_radius_m", &desc.exit_radius_m},
                      {"exit_conic", &desc.exit_conic}});
  if (part.boolean("flat_lens", false)) {
    if (part.has("lens_radius_m")) part.fail("flat_lens", "and \"lens_radius_m\" exclude each other");
    desc.lens_radius_m = unlimited;
  }
  const std::vector<double> points = read_points(part, "wall_points_m");
  if (!points.empty() && desc.wall != UPS_COLLIMATOR_POLYLINE) part.fail("wall_points_m", "needs the wall polyline");
  desc.wall_rz_m = points.data();
  desc.wall_point_count = uint32_t(points.size() / 2);
  desc.smooth = part.boolean("smooth", desc.smooth != 0);
  read_count(part, "facets_around", desc.facets_around);
  read_count(part, "exit_facets_along", desc.exit_facets_along);
  read_tolerances(part, desc);
  read_finish(part, desc, custom);
  check_part(ups_fixture_add_collimator(fixture, &desc, nullptr), part.where());
}

const ups_fixture* Importer::fixture_of(const JsonReader& reader) {
  const Json* parts = reader.json().find("parts");
  if (!parts) reader.fail("parts", "is missing: an array of emitter, reflector, lens and collimator objects");
  for (const auto& [known, fixture] : fixtures_) {
    if (same(*known, *parts)) return fixture.get();
  }
  ups_fixture* created = nullptr;
  check(ups_fixture_create(context_, &created), reader.where());
  FixturePtr fixture(created);
  const std::vector<Json>& items = reader.array("parts");
  for (size_t i = 0; i < items.size(); ++i) {
    const JsonReader part(items[i], reader.where() + ".parts[" + std::to_string(i) + "]");
    part.allow_only({"emitter", "reflector", "lens", "collimator"});
    if (part.json().members.size() != 1) {
      throw extras::Error(UPS_ERROR_PARSE,
                          part.where() + " must have one member: emitter, reflector, lens or collimator");
    }
    if (const auto emitter = part.object("emitter")) add_emitter(created, *emitter);
    if (const auto reflector = part.object("reflector")) add_reflector(created, *reflector);
    if (const auto lens = part.object("lens")) add_lens(created, *lens);
    if (const auto collimator = part.object("collimator")) add_collimator(created, *collimator);
  }
  fixtures_.emplace_back(parts, std::move(fixture));
  return created;
}

void Importer::add_fixture(const JsonReader& reader, const Affine& frame) {
  reader.allow_only({"parts", "flux_lm", "dimming"});
  ups_fixture_instance_desc desc;
  ups_fixture_instance_desc_init(&desc, sizeof desc);
  desc.group = group_;
  desc.dimming = float(reader.number("dimming", 1, 0, largest_float));
  if (reader.has("flux_lm")) desc.flux_lm = float(reader.number("flux_lm", 0, 0, largest_float));
  std::copy(std::begin(frame.m), std::end(frame.m), desc.to_world);
  ups_fixture_id id{};
  check(ups_scene_add_fixture(scene_, fixture_of(reader), &desc, &id), reader.where());
  note_place(UPS_GLTF_PART_FIXTURE, id.v, node_where_);
  const std::vector<Json>& parts = reader.array("parts");
  for (uint32_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].find("emitter")) continue;
    ups_instance_id instance{};
    check(ups_scene_get_fixture_instance(scene_, id, {i + 1}, &instance), reader.where());
    name_source(UPS_SOURCE_INSTANCE, instance.v, "fixture");
    note_place(UPS_GLTF_PART_INSTANCE, instance.v, node_where_ + ", part " + std::to_string(i));
  }
}

}  // namespace ups::gltf
