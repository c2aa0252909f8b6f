// Walks the node hierarchy: each node's meshes, camera, lights and what its `extras.ups` says, turned to +Z up.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "gltf/import.h"

namespace ups::gltf {

namespace {

constexpr int64_t default_width = 512, max_width = 16384;
constexpr double largest_element = 1e99;  // of a matrix: its third power is a number
constexpr double flat = 1e-14;  // relative: as the core, which refuses such matrices

bool is_unit(const std::vector<double>& scale) {
  for (double s : scale) {
    if (s != 1) return false;
  }
  return true;
}

[[noreturn]] void fail(const std::string& where, const std::string& problem) {
  throw extras::Error(UPS_ERROR_PARSE, where + ": " + problem);
}

}  // namespace

void Importer::read_scene() {
  const tinygltf::Model& model = document_.model;
  std::vector<int> roots;
  if (!model.scenes.empty()) {
    const int chosen = model.defaultScene >= 0 ? model.defaultScene : 0;
    if (size_t(chosen) >= model.scenes.size()) fail("scene " + std::to_string(chosen), "is not in the file");
    const std::string where = place("scene", size_t(chosen), model.scenes[size_t(chosen)].name);
    const JsonReader scene = document_.element("scenes", size_t(chosen), where);
    if (const auto extras = scene.ups_extras()) {
      extras->allow_only({"maintenance_factor", "sky"});
      if (extras->has("sky")) {
        throw extras::Error(UPS_ERROR_UNSUPPORTED, where +
                                                       ": extras.ups.sky is not built yet; light the scene with "
                                                       "luminaires or emitting surfaces");
      }
      check(ups_scene_set_maintenance_factor(scene_, extras->number("maintenance_factor", 1, 0, 1)),
            where + ": extras.ups");
    }
    if (model.scenes.size() > 1) warn("only " + where + " is read, the other scenes of the file are skipped");
    roots = model.scenes[size_t(chosen)].nodes;
  } else {
    std::vector<char> is_child(model.nodes.size(), 0);
    for (const auto& node : model.nodes) {
      for (int child : node.children) {
        if (child >= 0 && size_t(child) < is_child.size()) is_child[size_t(child)] = 1;
      }
    }
    for (size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(int(i));
    }
  }

  // A stack instead of recursion: a file may nest nodes as deep as it likes. Depth first, in the file's order.
  visited_.assign(model.nodes.size(), 0);
  std::vector<std::pair<int, Affine>> stack;
  const auto push = [&](const std::vector<int>& children, const Affine& parent) {
    for (auto child = children.rbegin(); child != children.rend(); ++child) stack.emplace_back(*child, parent);
  };
  push(roots, turn_to_z_up());
  while (!stack.empty()) {
    const auto [index, parent] = stack.back();
    stack.pop_back();
    if (index < 0 || size_t(index) >= model.nodes.size()) {
      fail("node " + std::to_string(index), "is out of range: the file has " + std::to_string(model.nodes.size()));
    }
    const tinygltf::Node& node = model.nodes[size_t(index)];
    const std::string where = place("node", size_t(index), node.name);
    if (visited_[size_t(index)]++) fail(where, "has two parents or is its own ancestor; nodes must form a tree");
    read_node(index, parent);
    push(node.children, parent * local_transform(node, where).full);
  }
  if (model.scenes.size() == 1) warn_of_nodes_in_no_scene();
}

// With what is below them.
void Importer::warn_of_nodes_in_no_scene() {
  const std::vector<tinygltf::Node>& nodes = document_.model.nodes;
  std::vector<char> is_child(nodes.size(), 0);
  for (const tinygltf::Node& node : nodes)
    for (const int child : node.children) is_child[size_t(child)] = 1;
  for (size_t i = 0; i < nodes.size(); ++i)
    if (!visited_[i] && !is_child[i]) warn(place("node", i, nodes[i].name) + " is in no scene and is skipped");
}

void Importer::read_node(int index, const Affine& parent) {
  const tinygltf::Node& source = document_.model.nodes[size_t(index)];
  const std::string where = place("node", size_t(index), source.name);
  const JsonReader node = document_.element("nodes", size_t(index), where);
  const NodeTransform local = local_transform(source, where);
  const auto extras = node.ups_extras();
  group_ = extras ? uint32_t(extras->integer("group", 0, 0, std::numeric_limits<uint32_t>::max())) : 0;
  node_name_ = source.name, node_where_ = where;
  node_instances_.clear(), node_meshes_.clear();
  if (source.mesh >= 0) add_instances(source.mesh, parent * local.full, where);
  if (source.skin >= 0) warn(where + ": its skin is skipped");
  warn_about_extensions(node, {"KHR_lights_punctual", "EXT_lights_ies"});

  if (extras) {
    extras->allow_only(
        {"meters", "goniometer", "observer", "luminaire", "fixture", "group", "width", "height", "illuminance_camera",
         "projection", "layers"});
    for (const char* key : {"width", "height", "illuminance_camera", "projection", "layers"}) {
      if (extras->has(key) && source.camera < 0) extras->fail(key, "needs a camera on the same node");
    }
  }
  auto meters = extras ? extras->object("meters") : std::nullopt;
  if (meters && (meters->has("surface") || meters->has("lightmap"))) {  // they follow the mesh, its scale included
    add_surface_meters(*meters, source.name);
    meters.reset();
  }
  const auto goniometer = extras ? extras->object("goniometer") : std::nullopt;
  const auto observer = extras ? extras->object("observer") : std::nullopt;
  const auto luminaire = extras ? extras->object("luminaire") : std::nullopt;
  const auto fixture = extras ? extras->object("fixture") : std::nullopt;
  const bool has_punctual = node.extension("KHR_lights_punctual").has_value();
  const bool has_ies = node.extension("EXT_lights_ies").has_value();
  if (source.camera < 0 && !meters && !goniometer && !observer && !luminaire && !fixture && !has_punctual && !has_ies)
    return;

  bool scaled = false;
  const Affine whole = parent * local.unscaled, frame = without_scale(whole, scaled, where),
               of_light = with_mirror_of(whole, frame);
  if (scaled || !is_unit(source.scale))
    warn(where + ": its scale is ignored for meters, goniometers, observers, luminaires, fixtures, lights and cameras");
  if (source.camera >= 0) add_camera(node, source.camera, frame);
  if (has_punctual) add_punctual_light(node, of_light);
  if (has_ies) add_ies_light(node, of_light);
  if (luminaire) add_luminaire(*luminaire, of_light);
  const bool mirrors = determinant(whole) < 0;
  if (mirrors && fixture)
    warn(where + ": a node above it mirrors, which a fixture cannot be: it stands as if turned about its axis");
  const char* const eye = source.camera >= 0 ? "a camera" : observer ? "an observer" : nullptr;
  if (mirrors && eye)
    warn(where + ": a node above it mirrors, which " + eye +
         " cannot be: it looks the way that the mirror gives it, and what it sees is not mirrored");
  if (fixture) add_fixture(*fixture, frame);
  if (meters) add_meters(*meters, source.name, of_light);
  if (goniometer) add_goniometer(*goniometer, source.name, of_light);
  if (observer) add_observer(*observer, source.name, frame);
}

void Importer::add_instances(int index, const Affine& to_world, const std::string& where) {
  const auto is_large = [](double element) { return !(std::abs(element) <= largest_element); };
  if (std::any_of(std::begin(to_world.m), std::end(to_world.m), is_large))
    fail(where, "its matrix has an element beyond 1e+99");
  // Relative to the axes' lengths: a scale of 0 hides the node, a small one does not.
  const double volume = length(to_world.column(0)) * length(to_world.column(1)) * length(to_world.column(2));
  if (!(std::abs(determinant(to_world)) > flat * volume)) {
    warn(where + ": its mesh is skipped, as its matrix has a scale of 0");
    return;
  }
  const std::vector<PlacedMesh>& primitives = mesh(index);
  for (const PlacedMesh& placed : primitives) {
    ups_instance_desc desc;
    ups_instance_desc_init(&desc, sizeof desc);
    desc.mesh = placed.id;
    desc.group = group_;
    std::copy(std::begin(to_world.m), std::end(to_world.m), desc.to_world);
    ups_instance_id instance{};
    check(ups_scene_add_instance(scene_, &desc, &instance), where);
    note_place(UPS_GLTF_PART_INSTANCE, instance.v,
               primitives.size() == 1 ? where : where + ", primitive " + std::to_string(&placed - primitives.data()));
    if (placed.emits) name_source(UPS_SOURCE_INSTANCE, instance.v, "instance");
    node_instances_.push_back(instance);
    node_meshes_.push_back(placed);
  }
}

namespace {

ups_projection projection_of(const JsonReader& words) {
  constexpr const char* names[] = {"perspective", "equidistant", "equisolid", "panorama"};  // UPS_PERSPECTIVE, ...
  const std::string given = words.text("projection", names[0]);
  for (size_t i = 0; i < std::size(names); ++i)
    if (given == names[i]) return ups_projection(i);
  words.fail("projection", "must be perspective, equidistant, equisolid or panorama");
}

uint32_t layers_of(const JsonReader& words) {
  constexpr const char* names[] = {"albedo", "normal", "depth", "id"};  // of UPS_LAYER_*, bit by bit
  uint32_t layers = 0;
  for (const Json& item : words.array("layers")) {
    const auto at = std::find(std::begin(names), std::end(names), item.text);
    if (item.kind != Json::Kind::text || at == std::end(names))
      words.fail("layers", "must be an array of the words albedo, normal, depth, id");
    layers |= 1u << (at - std::begin(names));
  }
  return layers;
}

// Width over height of an image of which one side is given at most.
double aspect_of(ups_projection projection, double of_perspective) {
  if (projection == UPS_PANORAMA) return 2;
  return projection == UPS_PERSPECTIVE && of_perspective > 0 ? of_perspective : 1;
}

}  // namespace

void Importer::add_camera(const JsonReader& node, int index, const Affine& frame) {
  const tinygltf::Camera& camera = document_.model.cameras.at(size_t(index));
  const std::string where = node.where() + ", " + place("camera", size_t(index), camera.name);
  if (camera.type != "perspective") {
    warn(where + ": skipped, only perspective cameras are read");
    return;
  }
  const auto extras = node.ups_extras();
  const JsonReader size = extras ? *extras : JsonReader(empty_object(), where);
  const ups_projection projection = projection_of(size);
  const double aspect = aspect_of(projection, camera.perspective.aspectRatio);
  const auto pixels = [](double count) {
    return int64_t(std::lround(std::min(std::max(count, 1.0), double(max_width))));
  };
  int64_t width = size.integer("width", 0, 1, max_width), height = size.integer("height", 0, 1, max_width);
  if (width == 0) width = height > 0 ? pixels(double(height) * aspect) : default_width;
  if (height == 0) height = pixels(double(width) / aspect);

  ups_camera_desc desc;
  ups_camera_desc_init(&desc, sizeof desc);
  desc.width = desc_.camera_width ? desc_.camera_width : uint32_t(width);
  desc.height = desc_.camera_height ? desc_.camera_height : uint32_t(height);
  std::copy(std::begin(frame.m), std::end(frame.m), desc.to_world);
  desc.vertical_fov_rad = float(camera.perspective.yfov);
  desc.illuminance = size.boolean("illuminance_camera", false);
  desc.projection = projection;
  desc.layers = layers_of(size) | desc_.camera_layers;
  Sensor sensor{};
  check(ups_scene_add_camera(scene_, &desc, &sensor.info.sensor), where);
  sensor.info.struct_size = sizeof sensor.info;
  sensor.info.kind = UPS_GLTF_CAMERA;
  sensor.info.width = desc.width;
  sensor.info.height = desc.height;
  sensor.info.illuminance = desc.illuminance;
  sensor.info.projection = desc.projection;
  sensor.info.layers = layers_of(size);
  const std::string node_name = node.text("name", "");
  sensor.name = unique_name(node_name.empty() ? "camera" : node_name, desc.illuminance != 0, where);
  sensors.push_back(std::move(sensor));
}

}  // namespace ups::gltf
