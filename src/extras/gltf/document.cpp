// Loads a .gltf or .glb file: container, JSON, buffers. tinygltf trusts much of what it reads, so what it does not
// check is checked here first, with messages that say where; see also accessor.cpp.
#include "gltf/document.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>

#include "common/boundary.h"

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

// glTF 2.0, section 4.4: a 12-byte header, then chunks of length, type, data; the first one is JSON.
std::pair<size_t, size_t> json_chunk(const Bytes& file) {
  constexpr size_t header = 12, chunk_header = 8;
  if (file.size() < header + chunk_header) fail_parse("truncated .glb: no room for its header");
  const uint32_t version = little_endian(&file[4]), length = little_endian(&file[8]);
  if (version != 2) throw Error(UPS_ERROR_UNSUPPORTED, ".glb version " + std::to_string(version) + ", only 2 is read");
  if (length > file.size()) {
    fail_parse("truncated .glb: its header says " + std::to_string(length) + " bytes, the file has " +
               std::to_string(file.size()));
  }
  const size_t json_length = little_endian(&file[12]);
  if (little_endian(&file[16]) != 0x4E4F534A) fail_parse("bad .glb: its first chunk is not JSON");
  if (json_length > length - header - chunk_header) {
    fail_parse("truncated .glb: its JSON chunk says " + std::to_string(json_length) + " bytes, the file ends before");
  }
  const size_t next = header + chunk_header + json_length;
  if (next + chunk_header <= length && little_endian(&file[next]) > length - next - chunk_header) {
    fail_parse("truncated .glb: its binary chunk says " + std::to_string(little_endian(&file[next])) +
               " bytes, the file has " + std::to_string(length - next - chunk_header) + " left");
  }
  return {header + chunk_header, json_length};
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

void check_primitives(const JsonReader& root) {
  for_each(root, "meshes", "mesh", [&](const JsonReader& mesh, size_t) {
    const std::vector<Json>& primitives = mesh.array("primitives");
    for (size_t i = 0; i < primitives.size(); ++i) {
      const JsonReader primitive(primitives[i], mesh.where() + ", primitive " + std::to_string(i));
      check_index(primitive, "indices", root, "accessors");
      check_index(primitive, "material", root, "materials");
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
    accessor.integer("count", 1, 1, max_integer);
  });
  for_each(root, "nodes", "node", [&](const JsonReader& node, size_t) {
    check_index(node, "mesh", root, "meshes");
    check_index(node, "camera", root, "cameras");
    for (const Json& child : node.array("children")) {
      if (child.kind != Json::Kind::number) node.fail("children", "must be an array of whole numbers");
    }
  });
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
}

bool is_data_uri(const std::string& uri) { return uri.rfind("data:", 0) == 0; }

// What tinygltf's file callbacks know: it looks into the current folder as well, which must not find anything.
struct BufferFiles {
  std::map<std::string, Bytes> contents;  // by the path that tinygltf will ask for
};

// Set by name, and all of them: later versions of tinygltf also ask for the size, and refuse a set with a gap.
template <class Callbacks>
Callbacks callbacks_of(BufferFiles& files) {
  Callbacks calls{};
  calls.FileExists = [](const std::string& path, void* user) {
    return static_cast<BufferFiles*>(user)->contents.count(path) != 0;
  };
  calls.ExpandFilePath = [](const std::string& path, void*) { return path; };
  calls.ReadWholeFile = [](Bytes* out, std::string*, const std::string& path, void* user) {
    const BufferFiles& known = *static_cast<BufferFiles*>(user);
    const auto found = known.contents.find(path);
    if (found == known.contents.end()) return false;
    *out = found->second;
    return true;
  };
  calls.WriteWholeFile = [](std::string*, const std::string&, const Bytes&, void*) { return false; };
  if constexpr (requires { calls.GetFileSizeInBytes; }) {
    calls.GetFileSizeInBytes = [](size_t* size, std::string*, const std::string& path, void* user) {
      const BufferFiles& known = *static_cast<BufferFiles*>(user);
      const auto found = known.contents.find(path);
      if (found == known.contents.end()) return false;
      *size = found->second.size();
      return true;
    };
  }
  calls.user_data = &files;
  return calls;
}

// Keeps the encoded bytes of an image; those in a buffer view stay there (tinygltf has not checked the view's range).
bool keep_encoded(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
                  int size, void*) {
  if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
  return true;
}

// tinygltf knows some media types only, and wants the exact size.
void check_data_uri(const JsonReader& buffer, const std::string& uri, int64_t length) {
  if (!tinygltf::IsDataURI(uri)) buffer.fail("uri", "must start with data:application/octet-stream;base64,");
  const size_t begin = uri.find(',') + 1;
  const size_t size = uri.find_last_not_of('=') + 1;
  const size_t bytes = size > begin ? (size - begin) * 3 / 4 : 0;
  if (bytes != uint64_t(length)) {
    buffer.fail("uri", "holds " + std::to_string(bytes) + " bytes, byteLength says " + std::to_string(length));
  }
}

// Buffers in files are read here, cut to their byteLength (tinygltf wants the file to have just that size). Images are
// read when a material asks for them, so files of images are not offered to tinygltf.
BufferFiles read_buffer_files(const JsonReader& root, const Document& document, const std::string& base, bool binary) {
  BufferFiles files;
  for_each(root, "buffers", "buffer", [&](const JsonReader& buffer, size_t index) {
    const int64_t length = buffer.integer("byteLength", -1, 1, max_integer);
    if (length < 0) buffer.fail("byteLength", "is missing");
    const std::string uri = buffer.text("uri", "");
    if (is_data_uri(uri)) {
      check_data_uri(buffer, uri, length);
      return;
    }
    if (uri.empty()) {
      if (!binary || index != 0) buffer.fail("uri", "is missing; only the first buffer of a .glb may leave it out");
      return;
    }
    Bytes bytes = read_uri(document, uri, buffer.where());
    if (bytes.size() < uint64_t(length)) {
      fail_parse(buffer.where() + ": its file '" + percent_decoded(uri) + "' has " + std::to_string(bytes.size()) +
                 " bytes, byteLength says " + std::to_string(length));
    }
    bytes.resize(size_t(length));
    std::string asked = uri;  // tinygltf decodes '+' as a blank
    std::replace(asked.begin(), asked.end(), '+', ' ');
    files.contents[base + "/" + percent_decoded(asked)] = std::move(bytes);
  });
  return files;
}

void load_model(Document& document, const Bytes& file, bool binary, std::vector<std::string>& warnings) {
  const std::string base = "ups-buffer-files";  // a name for tinygltf's look-ups, no folder
  BufferFiles files = read_buffer_files(JsonReader(document.json, "the file"), document, base, binary);
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(keep_encoded, nullptr);
  loader.SetFsCallbacks(callbacks_of<tinygltf::FsCallbacks>(files));
  std::string error, warning;  // warnings: images in files only
  const auto size = static_cast<unsigned int>(file.size());
  const bool good = binary ? loader.LoadBinaryFromMemory(&document.model, &error, &warning, file.data(), size, base)
                           : loader.LoadASCIIFromString(&document.model, &error, &warning,
                                                        reinterpret_cast<const char*>(file.data()), size, base);
  std::replace(error.begin(), error.end(), '\n', ' ');
  if (error.size() > 300) error = error.substr(0, 300) + "...";  // it may quote a whole data URI
  if (!good) fail_parse(error.empty() ? "not a valid glTF file" : error);
  if (!error.empty()) warnings.push_back(error);  // tinygltf went on
}

}  // namespace

std::string percent_decoded(const std::string& uri) {
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
  };
  std::string result;
  for (size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
      result += char(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
      i += 2;
    } else {
      result += uri[i];
    }
  }
  return result;
}

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

Bytes read_file(const std::filesystem::path& path, const std::string& where) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw Error(UPS_ERROR_IO, where + ": '" + path.string() + "' is a folder, not a file");
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(UPS_ERROR_IO, where + ": cannot open the file '" + path.string() + "'");
  Bytes bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) throw Error(UPS_ERROR_IO, where + ": cannot read the file '" + path.string() + "'");
  return bytes;
}

Bytes read_uri(const Document& document, const std::string& uri, const std::string& where) {
  if (!is_data_uri(uri)) return read_file(document.folder / utf8_path(percent_decoded(uri)), where);
  const size_t comma = uri.find(',');
  const std::string marker = ";base64";
  if (comma == std::string::npos || comma < marker.size() ||
      uri.compare(comma - marker.size(), marker.size(), marker) != 0) {
    fail_parse(where + ": a data URI must be base64");
  }
  Bytes bytes;
  std::string media_type;  // tinygltf decodes some types only; which one it is does not matter here
  const std::string plain = "data:application/octet-stream;base64," + uri.substr(comma + 1);
  if (!tinygltf::DecodeDataURI(&bytes, media_type, plain, 0, false)) fail_parse(where + ": its data URI is not base64");
  return bytes;
}

Document load_document(const std::string& path, std::vector<std::string>& warnings) {
  const std::filesystem::path file_path = utf8_path(path);
  const Bytes file = read_file(file_path, "glTF");
  if (file.size() > std::numeric_limits<uint32_t>::max()) throw Error(UPS_ERROR_UNSUPPORTED, "larger than 4 GiB");
  const bool binary = is_binary(file);
  const auto [offset, length] = binary ? json_chunk(file) : std::make_pair(size_t(0), file.size());
  const char* text = reinterpret_cast<const char*>(file.data()) + offset;

  Document document;
  document.folder = file_path.parent_path();
  document.json = parse_json(text, text + length);
  const JsonReader root(document.json, "the file");
  check_version(root);
  check_extensions(root, warnings);
  check_primitives(root);
  check_arrays(root);
  load_model(document, file, binary, warnings);
  return document;
}

}  // namespace ups::gltf
