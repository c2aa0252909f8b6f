// Loads a .gltf or .glb file: container, JSON, the files it names. tinygltf (model.cpp) trusts much of what it reads,
// so what it does not check is checked here first, with messages that say where; see also accessor.cpp.
#include "gltf/document.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "common/boundary.h"
#include "platform/files.h"
#include "platform/paths.h"

namespace ups::gltf {

namespace {

using extras::Error;

[[noreturn]] void fail_parse(const std::string& message) { throw Error(UPS_ERROR_PARSE, message); }

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr int64_t max_integer = std::numeric_limits<int64_t>::max();

uint32_t little_endian(const unsigned char* bytes) {
  return uint32_t(bytes[0]) | uint32_t(bytes[1]) << 8 | uint32_t(bytes[2]) << 16 | uint32_t(bytes[3]) << 24;
}

bool is_binary(const Bytes& file) { return file.size() >= 4 && std::memcmp(file.data(), "glTF", 4) == 0; }

// glTF 2.0, section 4.4: a 12-byte header, then chunks of length, type, data; the first one is JSON, the second, if
// any, the first buffer.
struct Chunks {
  ByteRange json, binary;  // binary.data: null where there is none
};
Chunks chunks_of(const Bytes& file) {
  constexpr uint32_t json_type = 0x4E4F534A, binary_type = 0x004E4942;
  constexpr size_t header = 12, chunk_header = 8;
  if (file.size() < header + chunk_header) fail_parse("truncated .glb: no room for its header");
  const uint32_t version = little_endian(&file[4]), length = little_endian(&file[8]);
  if (version != 2) throw Error(UPS_ERROR_UNSUPPORTED, ".glb version " + std::to_string(version) + ", only 2 is read");
  if (length < header + chunk_header) {
    fail_parse("bad .glb: its header says " + std::to_string(length) + " bytes, less than its own and its first chunk's "
               "headers have");
  }
  if (length > file.size()) {
    fail_parse("truncated .glb: its header says " + std::to_string(length) + " bytes, the file has " +
               std::to_string(file.size()));
  }
  const size_t json_length = little_endian(&file[12]);
  if (little_endian(&file[16]) != json_type) fail_parse("bad .glb: its first chunk is not JSON");
  if (json_length > length - header - chunk_header) {
    fail_parse("truncated .glb: its JSON chunk says " + std::to_string(json_length) + " bytes, the file ends before");
  }
  Chunks chunks{{&file[header] + chunk_header, json_length, 0}, {nullptr, 0, 0}};
  const size_t next = header + chunk_header + json_length;
  if (next + chunk_header > length) return chunks;
  const size_t size = little_endian(&file[next]), left = length - next - chunk_header;
  if (size > left) {
    fail_parse("truncated .glb: its binary chunk says " + std::to_string(size) + " bytes, the file has " +
               std::to_string(left) + " left");
  }
  if (little_endian(&file[next + 4]) == binary_type) chunks.binary = {&file[next] + chunk_header, size, 0};
  return chunks;
}

std::string name_of(const Json& object) {
  const Json* name = object.find("name");
  return name && name->kind == Json::Kind::text ? name->text : std::string();
}

// Calls body(reader, index) for each element of a top-level array.
template <class Body>
void for_each(const JsonReader& root, const char* array, const char* kind, Body&& body) {
  const std::vector<Json>& items = root.array(array);
  for (size_t i = 0; i < items.size(); ++i) body(JsonReader(items[i], place(kind, i, name_of(items[i]))), i);
}

void check_index(const JsonReader& reader, const char* key, const JsonReader& root, const char* array) {
  const size_t count = root.array(array).size();
  const int64_t index = reader.integer(key, -1, 0, std::numeric_limits<int32_t>::max());
  if (index >= 0 && size_t(index) >= count) {
    reader.fail(key,
                "is " + std::to_string(index) + ", out of range: the file has " + std::to_string(count) + " " + array);
  }
}

void require(const JsonReader& reader, const char* key) {
  if (!reader.has(key)) reader.fail(key, "is missing");
}

void check_sparse(const JsonReader& sparse, const JsonReader& root) {
  require(sparse, "count");
  sparse.integer("count", 1, 1, max_integer);
  for (const char* key : {"indices", "values"}) {
    require(sparse, key);
    const JsonReader part = *sparse.object(key);
    require(part, "bufferView");
    check_index(part, "bufferView", root, "bufferViews");
    part.integer("byteOffset", 0, 0, max_integer);
  }
}

// tinygltf reads a list of nodes up to what is no number.
void check_nodes(const JsonReader& of, const char* key, const JsonReader& root) {
  const size_t count = root.array("nodes").size();
  for (const Json& node : of.array(key)) {
    if (node.kind != Json::Kind::number || node.number != std::floor(node.number))
      of.fail(key, "must be an array of whole numbers");
    if (!(node.number >= 0 && node.number < double(count)))
      of.fail(key, "has node " + json_text(node) + ", out of range: the file has " + std::to_string(count) + " nodes");
  }
}

// It reads a matrix alone.
void check_transform(const JsonReader& node) {
  for (const auto& [key, count] : {std::pair("translation", 3), {"rotation", 4}, {"scale", 3}, {"matrix", 16}})
    node.numbers(key, size_t(count), -unlimited, unlimited);
  for (const char* key : {"translation", "rotation", "scale"})
    if (node.has("matrix") && node.has(key)) node.fail(key, "stands beside a matrix; a node has one or the other");
}

void check_primitives(const JsonReader& root) {
  for_each(root, "meshes", "mesh", [&](const JsonReader& mesh, size_t) {
    const std::vector<Json>& primitives = mesh.array("primitives");
    for (size_t i = 0; i < primitives.size(); ++i) {
      const JsonReader primitive(primitives[i], mesh.where() + ", primitive " + std::to_string(i));
      check_index(primitive, "indices", root, "accessors");
      check_index(primitive, "material", root, "materials");
      primitive.integer("mode", 4, 0, 6);
      const auto attributes = primitive.object("attributes");
      if (!attributes) primitive.fail("attributes", "is missing");
      for (const auto& [name, value] : primitives[i].find("attributes")->members) {
        (void)value;
        check_index(*attributes, name.c_str(), root, "accessors");
      }
    }
  });
}

// tinygltf takes a default for a number of the wrong kind or sign; here it is an error.
void check_arrays(const JsonReader& root) {
  for_each(root, "bufferViews", "buffer view", [&](const JsonReader& view, size_t) {
    check_index(view, "buffer", root, "buffers");
    view.integer("byteOffset", 0, 0, max_integer);
    view.integer("byteLength", 0, 1, max_integer);
    view.integer("byteStride", 4, 4, 252);
  });
  for_each(root, "accessors", "accessor", [&](const JsonReader& accessor, size_t) {
    check_index(accessor, "bufferView", root, "bufferViews");
    accessor.integer("byteOffset", 0, 0, max_integer);
    require(accessor, "componentType");
    require(accessor, "count");
    accessor.boolean("normalized", false);
    accessor.integer("count", 1, 1, max_integer);
    if (const auto sparse = accessor.object("sparse")) check_sparse(*sparse, root);
  });
  for_each(root, "nodes", "node", [&](const JsonReader& node, size_t) {
    check_index(node, "mesh", root, "meshes");
    check_index(node, "camera", root, "cameras");
    check_nodes(node, "children", root);
    check_transform(node);
  });
  root.integer("scene", 0, 0, std::numeric_limits<int32_t>::max());
  for_each(root, "scenes", "scene", [&](const JsonReader& scene, size_t) { check_nodes(scene, "nodes", root); });
  for_each(root, "materials", "material",
           [&](const JsonReader& material, size_t) { material.numbers("emissiveFactor", 3, 0, unlimited); });
  for_each(root, "images", "image",
           [&](const JsonReader& image, size_t) { check_index(image, "bufferView", root, "bufferViews"); });
  for_each(root, "cameras", "camera", [&](const JsonReader& camera, size_t) {
    if (const auto perspective = camera.object("perspective")) {
      perspective->number("yfov", 1, 0, 3.14159265358979);
      perspective->number("aspectRatio", 1, 0, unlimited);
    }
  });
}

void check_extensions(const JsonReader& root, std::vector<std::string>& warnings) {
  const auto required = root.array("extensionsRequired");
  for (const Json& name : required) {
    if (!is_known_extension(name.text)) {
      throw Error(UPS_ERROR_UNSUPPORTED,
                  "the file requires the extension '" + name.text + "', which is not known here");
    }
  }
  for (const Json& name : root.array("extensionsUsed")) {
    if (!is_known_extension(name.text)) warnings.push_back("the extension '" + name.text + "' is skipped");
  }
}

void check_version(const JsonReader& root) {
  const auto asset = root.object("asset");
  if (!asset) root.fail("asset", "is missing: this is no glTF 2.0 file");
  const std::string version = asset->text("version", "");
  if (version.rfind("2.", 0) != 0) {
    throw Error(UPS_ERROR_UNSUPPORTED, "asset.version is \"" + version + "\"; only glTF 2.0 is read");
  }
  const std::string least = asset->text("minVersion", "2.0");
  if (least != "2.0") {
    throw Error(UPS_ERROR_UNSUPPORTED, "asset.minVersion is \"" + least + "\"; only glTF 2.0 is read");
  }
}

}  // namespace

bool is_known_extension(const std::string& name) {
  static const char* const known[] = {
      "KHR_materials_ior", "KHR_materials_transmission", "KHR_materials_volume",           "KHR_lights_punctual",
      "EXT_lights_ies",    "KHR_mesh_quantization",      "KHR_materials_emissive_strength"};
  return std::any_of(std::begin(known), std::end(known), [&](const char* k) { return name == k; });
}

JsonReader Document::element(const char* array, size_t index, const std::string& where) const {
  const Json* items = json.find(array);
  if (!items || index >= items->items.size()) fail_parse(where + " is not in the file");
  return JsonReader(items->items[index], where);
}

namespace {

Bytes read_file(const std::string& path, const std::string& where) {
  auto in = platform::open_to_read(path);
  if (!in) throw Error(UPS_ERROR_IO, where + ": cannot open the file '" + path + "': " + platform::why_not_open(path));
  Bytes bytes;
  constexpr size_t block = size_t(1) << 16;
  for (size_t size = 0; in; bytes.resize(size)) {  // what fails sets a bit, where iterators throw
    bytes.resize(size + block);
    in.read(reinterpret_cast<char*>(bytes.data()) + size, block);
    size += size_t(in.gcount());
  }
  if (in.bad()) throw Error(UPS_ERROR_IO, where + ": cannot read the file '" + path + "'");
  return bytes;
}

}  // namespace

Bytes read_beside(const Document& document, const std::string& path, const std::string& where) {
  if (!document.allow_outside && !platform::lies_within(path, document.folder)) {
    throw Error(UPS_ERROR_IO, where + ": the file '" + path +
                                  "' lies outside the scene's folder; move it there, or allow files outside "
                                  "(--allow-outside; ups_gltf_import_desc.allow_outside)");
  }
  return read_file(path, where);
}

// RFC 2397: data:[type][;base64],data. The type does not matter here, though tinygltf decodes some alone.
Bytes read_uri(const Document& document, const std::string& uri, const std::string& where) {
  if (!is_data_uri(uri)) return read_beside(document, platform::joined(document.folder, percent_decoded(uri)), where);
  const size_t comma = uri.find(',');
  if (comma == std::string::npos) fail_parse(where + ": a data URI must have a comma before its data");
  const std::string data = percent_decoded(uri.substr(comma + 1)), marker = ";base64";
  if (comma < marker.size() || uri.compare(comma - marker.size(), marker.size(), marker) != 0)
    return {data.begin(), data.end()};
  Bytes bytes;
  std::string media_type;
  if (!tinygltf::DecodeDataURI(&bytes, media_type, "data:application/octet-stream;base64," + data, 0, false))
    fail_parse(where + ": its data URI is not base64");
  return bytes;
}

Document load_document(const std::string& path, bool allow_outside, std::vector<std::string>& warnings) {
  const Bytes file = read_file(path, "glTF");
  if (file.size() > std::numeric_limits<uint32_t>::max()) throw Error(UPS_ERROR_UNSUPPORTED, "larger than 4 GiB");
  const Chunks chunks =
      is_binary(file) ? chunks_of(file) : Chunks{{file.data(), file.size(), 0}, {nullptr, 0, 0}};
  const char* text = reinterpret_cast<const char*>(chunks.json.data);

  extras::ask_for_memory(extras::ample_bytes + 8 * chunks.json.size);
  Document document;
  document.folder = platform::folder_of(path);
  document.allow_outside = allow_outside;
  document.json = parse_json(text, text + chunks.json.size);
  const JsonReader root(document.json, "the file");
  check_version(root);
  check_extensions(root, warnings);
  check_primitives(root);
  check_arrays(root);
  load_model(document, chunks.binary, warnings);
  return document;
}

}  // namespace ups::gltf
