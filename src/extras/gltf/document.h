// A loaded glTF file: tinygltf's model for what it reads well (buffers, accessors, meshes, nodes, images), the JSON
// text as values for materials, extensions and extras, and readers of accessors and files that check every range.
#pragma once
#include <tiny_gltf.h>

#include <cstdint>
#include <string>
#include <vector>

#include "gltf/json.h"
#include "gltf/uri.h"

namespace ups::gltf {

using Bytes = std::vector<unsigned char>;

struct ByteRange {
  const unsigned char* data;
  size_t size, stride;  // stride 0: tight
};

struct Document {
  std::string folder;          // that relative names in the file start from
  bool allow_outside = false;  // of files that it names: they may lie outside that folder
  Json json;
  tinygltf::Model model;  // images hold their encoded bytes (PNG, JPEG), not pixels

  // The JSON object of an element, such as element("nodes", 3); throws where it is no object.
  JsonReader element(const char* array, size_t index, const std::string& where) const;
};

// Reads and checks the file. Throws extras::Error: IO, PARSE, UNSUPPORTED (unknown required extensions, glTF 1).
// Extensions that are used, not required and not known become warnings.
Document load_document(const std::string& path, bool allow_outside, std::vector<std::string>& warnings);

bool is_known_extension(const std::string& name);

// Fills document.model from document.json, whose buffers then bear names instead of their data. binary: the chunk of a
// .glb that is its first buffer; data is null where there is none.
void load_model(Document& document, const ByteRange& binary, std::vector<std::string>& warnings);

// A file beside the scene, or what a data URI holds. where: who asks, for messages.
Bytes read_uri(const Document& document, const std::string& uri, const std::string& where);
// A file that the scene names. Throws (IO) also where it lies outside the scene's folder, unless that is allowed.
Bytes read_beside(const Document& document, const std::string& path, const std::string& where);

// Bytes of a buffer view; throws where its range is not inside its buffer.
ByteRange buffer_view(const Document& document, int index, const std::string& where);

// Accessors as plain arrays: sparse ones filled in, normalized integers as fractions. components: 2, 3 or 4.
std::vector<float> read_floats(const Document& document, int accessor, int components, const std::string& where);
std::vector<uint32_t> read_indices(const Document& document, int accessor, const std::string& where);

}  // namespace ups::gltf
