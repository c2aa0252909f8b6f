// Triangle primitives of glTF meshes become meshes of the scene, once each, when the first node uses them. Strips and
// fans are unrolled; points and lines have no area and are skipped.
#include <utility>

#include "gltf/import.h"

namespace ups::gltf {

namespace {

[[noreturn]] void fail(const std::string& where, const std::string& problem) {
  throw extras::Error(UPS_ERROR_PARSE, where + ": " + problem);
}

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

// glTF 2.0, section 3.7.2.1: how strips and fans list their triangles.
std::vector<uint32_t> unroll(const std::vector<uint32_t>& from, int mode) {
  std::vector<uint32_t> to;
  for (size_t i = 0; i + 2 < from.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      to.insert(to.end(), {from[i + 1], from[i + 2], from[0]});
    } else {
      to.insert(to.end(), {from[i], from[i + 1 + i % 2], from[i + 2 - i % 2]});
    }
  }
  return to;
}

std::vector<uint32_t> triangle_indices(const Document& document, const tinygltf::Primitive& primitive,
                                       size_t vertex_count, const std::string& where) {
  std::vector<uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = read_indices(document, primitive.indices, where + ", indices");
  } else {
    indices.resize(vertex_count);
    for (size_t i = 0; i < vertex_count; ++i) indices[i] = uint32_t(i);
  }
  for (size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= vertex_count) {
      fail(where, "index " + std::to_string(indices[i]) + " at place " + std::to_string(i) + " of accessor " +
                      std::to_string(primitive.indices) + " is out of range: there are " +
                      std::to_string(vertex_count) + " vertices");
    }
  }
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES) return unroll(indices, primitive.mode);
  if (indices.size() % 3 != 0) fail(where, std::to_string(indices.size()) + " indices do not make whole triangles");
  return indices;
}

// Primitives may share a buffer of which each uses a part.
struct Vertices {
  size_t count;                // of each attribute
  std::vector<uint32_t> used;  // by the triangles, ascending; empty: all
};

// Where not all are used `indices` become places among those that are.
Vertices keep_used(std::vector<uint32_t>& indices, size_t count) {
  std::vector<uint32_t> place_of(count), used;
  for (const uint32_t i : indices) place_of[i] = 1;
  for (size_t i = 0; i < count; ++i) {
    if (place_of[i] == 0) continue;
    place_of[i] = uint32_t(used.size());
    used.push_back(uint32_t(i));
  }
  if (used.size() == count) return {count, {}};
  for (uint32_t& i : indices) i = place_of[i];
  return {count, std::move(used)};
}

// Leaves of an attribute what the used vertices have.
void gather(std::vector<float>& values, const Vertices& vertices, size_t components) {
  if (vertices.used.empty()) return;
  auto to = values.begin();
  for (const uint32_t i : vertices.used) {
    for (size_t c = 0; c < components; ++c) *to++ = values[i * components + c];
  }
  values.erase(to, values.end());
}

// An optional attribute; empty where the primitive does not have it.
std::vector<float> optional_floats(const Document& document, const tinygltf::Primitive& primitive,
                                   const std::string& name, int components, const Vertices& vertices,
                                   const std::string& where) {
  const int accessor = attribute(primitive, name);
  if (accessor < 0) return {};
  std::vector<float> values = read_floats(document, accessor, components, where + ", " + name);
  if (values.size() != vertices.count * size_t(components)) {
    fail(where, name + " has " + std::to_string(values.size() / size_t(components)) + " elements, POSITION has " +
                    std::to_string(vertices.count));
  }
  gather(values, vertices, size_t(components));
  return values;
}

// Whether any triangle has an area. Coordinates are floats: in doubles no product vanishes that should not.
bool has_area(const std::vector<float>& positions, const std::vector<uint32_t>& indices) {
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    double edges[2][3];
    for (size_t e = 0; e < 2; ++e) {
      for (size_t c = 0; c < 3; ++c) {
        edges[e][c] = double(positions[3 * size_t(indices[i + 1 + e]) + c]) - positions[3 * size_t(indices[i]) + c];
      }
    }
    for (size_t a = 0, b = 1; a < 3; ++a, b = (b + 1) % 3) {
      if (edges[0][a] * edges[1][b] != edges[0][b] * edges[1][a]) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<PlacedMesh> Importer::add_primitive(const tinygltf::Primitive& primitive, const std::string& where) {
  if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    fail(where, "mode " + std::to_string(primitive.mode) + " is not one of glTF's 0 to 6");
  }
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    warn(where + ": points and lines are skipped");
    return std::nullopt;
  }
  if (attribute(primitive, "POSITION") < 0) {
    warn(where + ": skipped, it has no POSITION");
    return std::nullopt;
  }
  if (!primitive.targets.empty()) warn(where + ": morph targets are skipped");
  if (attribute(primitive, "COLOR_0") >= 0) warn(where + ": vertex colours (COLOR_0) are skipped");

  std::vector<float> positions = read_floats(document_, attribute(primitive, "POSITION"), 3, where + ", POSITION");
  std::vector<uint32_t> indices = triangle_indices(document_, primitive, positions.size() / 3, where);
  if (indices.empty()) {
    warn(where + ": skipped, it has no triangle");
    return std::nullopt;
  }
  if (!has_area(positions, indices)) {
    warn(where + ": skipped, none of its " + std::to_string(indices.size() / 3) + " triangles has an area");
    return std::nullopt;
  }
  const Material& material = primitive.material >= 0 ? materials_.at(size_t(primitive.material)) : default_material();
  const std::string uv_name = "TEXCOORD_" + std::to_string(material.uv_set);
  const Vertices vertices = keep_used(indices, positions.size() / 3);
  gather(positions, vertices, 3);
  const auto normals = optional_floats(document_, primitive, "NORMAL", 3, vertices, where);
  const auto uvs = optional_floats(document_, primitive, uv_name, 2, vertices, where);
  if (uvs.empty() && material.textured) warn(where + ": it has no " + uv_name + " for its material's textures");
  const auto tangents = optional_floats(document_, primitive, "TANGENT", 4, vertices, where);

  ups_mesh_desc desc;
  ups_mesh_desc_init(&desc, sizeof desc);
  desc.material = material.id;
  desc.vertex_count = uint32_t(positions.size() / 3);
  desc.triangle_count = uint32_t(indices.size() / 3);
  desc.positions_m = positions.data();
  desc.normals = normals.empty() ? nullptr : normals.data();
  desc.uvs = uvs.empty() ? nullptr : uvs.data();
  desc.tangents = tangents.empty() ? nullptr : tangents.data();
  desc.indices = indices.data();
  ups_mesh_id id{};
  check(ups_scene_add_mesh(scene_, &desc, &id), where);
  note_place(UPS_GLTF_PART_MESH, id.v, where);
  return PlacedMesh{id, material.emits, desc.triangle_count, !uvs.empty()};
}

const std::vector<PlacedMesh>& Importer::mesh(int index) {
  auto& ids = meshes_.at(size_t(index));
  if (ids) return *ids;
  ids.emplace();
  const tinygltf::Mesh& source = document_.model.meshes[size_t(index)];
  const std::string mesh_where = place("mesh", size_t(index), source.name);
  if (source.primitives.empty()) warn(mesh_where + ": skipped, it has no primitives");
  for (size_t i = 0; i < source.primitives.size(); ++i) {
    const std::string where = mesh_where + ", primitive " + std::to_string(i);
    if (const auto id = add_primitive(source.primitives[i], where)) ids->push_back(*id);
  }
  return *ids;
}

}  // namespace ups::gltf
