// Has tinygltf read the document's JSON. It knows some media types of data URIs alone, wants buffers to be of just
// their byteLength and indices to have a buffer view, so it is given a text that leaves it no choice: each buffer is a
// file whose bytes are here, indices without a buffer view are kept from it.
#include <algorithm>
#include <limits>
#include <map>

#include "common/boundary.h"
#include "gltf/document.h"

namespace ups::gltf {

namespace {

using extras::Error;

// What tinygltf's file callbacks know: it looks into the current folder as well, which must not find anything.
struct BufferFiles {
  std::map<std::string, Bytes> contents;  // by the path that tinygltf will ask for, once each
};

constexpr const char* base = "ups-buffer-files";  // a name for tinygltf's look-ups, no folder

// Set by name, and all of them: later versions of tinygltf also ask for the size, and refuse a set with a gap.
template <class Callbacks>
Callbacks callbacks_of(BufferFiles& files) {
  Callbacks calls{};
  calls.FileExists = [](const std::string& path, void* user) {
    return static_cast<BufferFiles*>(user)->contents.count(path) != 0;
  };
  calls.ExpandFilePath = [](const std::string& path, void*) { return path; };
  calls.ReadWholeFile = [](Bytes* out, std::string*, const std::string& path, void* user) {
    BufferFiles& known = *static_cast<BufferFiles*>(user);
    const auto found = known.contents.find(path);
    if (found == known.contents.end()) return false;
    *out = std::move(found->second);
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

Json* member(Json& object, std::string_view key) {
  for (JsonMember& m : object.members) {
    if (m.name == key) return &m.value;
  }
  return nullptr;
}

std::vector<Json>& items(Json& object, std::string_view key) {
  static std::vector<Json> none;  // stays empty: items are changed, never added
  Json* array = member(object, key);
  return array ? array->items : none;
}

// What a buffer holds, cut to its byteLength.
Bytes buffer_bytes(const JsonReader& buffer, size_t index, const Document& document, const ByteRange& binary) {
  const int64_t length = buffer.integer("byteLength", -1, 1, std::numeric_limits<int64_t>::max());
  if (length < 0) buffer.fail("byteLength", "is missing");
  const std::string uri = buffer.text("uri", "");
  if (uri.empty() && (!binary.data || index != 0))
    buffer.fail("uri", "is missing; only the first buffer of a .glb with a binary chunk may leave it out");
  Bytes bytes = uri.empty() ? Bytes(binary.data, binary.data + std::min(binary.size, size_t(length)))
                            : read_uri(document, uri, buffer.where());
  if (bytes.size() < uint64_t(length)) {
    const std::string source = uri.empty()        ? "the binary chunk"
                               : is_data_uri(uri) ? "its data URI"
                                                  : "its file '" + percent_decoded(uri) + "'";
    throw Error(UPS_ERROR_PARSE, buffer.where() + ": " + source + " has " + std::to_string(bytes.size()) +
                                     " bytes, byteLength says " + std::to_string(length));
  }
  bytes.resize(size_t(length));
  return bytes;
}

// Images are read when a material asks for them, so files of images are not among these.
BufferFiles take_buffers(Document& document, const ByteRange& binary) {
  BufferFiles files;
  (void)JsonReader(document.json, "the file").array("buffers");  // throws where it is none
  std::vector<Json>& buffers = items(document.json, "buffers");
  for (size_t i = 0; i < buffers.size(); ++i) {
    const Json* name = buffers[i].find("name");
    const JsonReader buffer(buffers[i], place("buffer", i, name ? name->text : ""));
    const std::string file = "buffer-" + std::to_string(i);
    files.contents[std::string(base) + "/" + file] = buffer_bytes(buffer, i, document, binary);
    if (!member(buffers[i], "uri")) buffers[i].members.push_back({"uri", {}});
    Json text;
    text.kind = Json::Kind::text;
    text.text = file;
    *member(buffers[i], "uri") = text;
  }
  return files;
}

// Indices whose accessor has no buffer view: all 0, but for sparse ones (glTF 2.0, section 3.6.2.3).
struct BareIndices {
  size_t mesh, primitive;
  int accessor;
};
std::vector<BareIndices> take_bare_indices(Json& json) {
  std::vector<BareIndices> bare;
  const std::vector<Json>& accessors = items(json, "accessors");
  std::vector<Json>& meshes = items(json, "meshes");
  for (size_t m = 0; m < meshes.size(); ++m) {
    std::vector<Json>& primitives = items(meshes[m], "primitives");
    for (size_t p = 0; p < primitives.size(); ++p) {
      const Json* indices = primitives[p].find("indices");
      if (!indices || accessors[size_t(indices->number)].find("bufferView")) continue;
      bare.push_back({m, p, int(indices->number)});
      std::erase_if(primitives[p].members, [](const JsonMember& member) { return member.name == "indices"; });
    }
  }
  return bare;
}

}  // namespace

void load_model(Document& document, const ByteRange& binary, std::vector<std::string>& warnings) {
  BufferFiles files = take_buffers(document, binary);
  const std::vector<BareIndices> bare = take_bare_indices(document.json);
  const std::string text = json_text(document.json);
  if (text.size() > std::numeric_limits<unsigned int>::max()) throw Error(UPS_ERROR_UNSUPPORTED, "larger than 4 GiB");
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(keep_encoded, nullptr);
  loader.SetFsCallbacks(callbacks_of<tinygltf::FsCallbacks>(files));
  std::string error, warning;  // warnings: images in files only
  const bool good = loader.LoadASCIIFromString(&document.model, &error, &warning, text.data(),
                                               static_cast<unsigned int>(text.size()), base);
  std::replace(error.begin(), error.end(), '\n', ' ');
  if (error.size() > 300) error = error.substr(0, whole_characters(error.data(), 300)) + "...";  // of a whole data URI
  if (!good) throw Error(UPS_ERROR_PARSE, error.empty() ? "not a valid glTF file" : error);
  if (!error.empty()) warnings.push_back(error);  // tinygltf went on
  for (const BareIndices& b : bare) document.model.meshes.at(b.mesh).primitives.at(b.primitive).indices = b.accessor;
}

}  // namespace ups::gltf
