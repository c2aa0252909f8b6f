// Reads accessors into plain arrays. Every range is checked against the bytes that are there (glTF 2.0, sections 3.6.2
// and 5.1): a file decides neither what memory is read nor how much is asked for.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "common/boundary.h"
#include "gltf/document.h"

namespace ups::gltf {

namespace {

// A sparse accessor without a buffer view has no bytes that bound its count.
constexpr size_t max_count_without_bytes = size_t(1) << 26;

struct Accessor {  // checked: bytes holds data->count elements; null where the accessor has no buffer view (zeros)
  const tinygltf::Accessor* data = nullptr;
  std::string where;
  size_t components = 0, component_bytes = 0, stride = 0;
  const unsigned char* bytes = nullptr;
  size_t element_bytes() const { return components * component_bytes; }
};

[[noreturn]] void fail(const std::string& where, const std::string& problem) {
  throw extras::Error(UPS_ERROR_PARSE, where + ": " + problem);
}

size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

template <class T>
T load(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

// glTF 2.0, section 3.6.2.2: how normalized integers become fractions.
float as_float(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return load<float>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load<uint8_t>(bytes) / (normalized ? 255.f : 1.f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<uint16_t>(bytes) / (normalized ? 65535.f : 1.f);
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const float value = load<int8_t>(bytes);
      return normalized ? std::max(value / 127.f, -1.f) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const float value = load<int16_t>(bytes);
      return normalized ? std::max(value / 32767.f, -1.f) : value;
    }
    default:
      return float(load<uint32_t>(bytes));
  }
}

uint32_t as_index(const unsigned char* bytes, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return load<uint8_t>(bytes);
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<uint16_t>(bytes);
  return load<uint32_t>(bytes);
}

bool is_index_type(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

// Checks that count elements of the given size and stride, starting at offset, lie inside the view.
void check_range(const ByteRange& view, size_t offset, size_t count, size_t stride, size_t element_bytes,
                 const std::string& where) {
  if (stride < element_bytes) {
    fail(where, "byteStride " + std::to_string(stride) + " is less than an element's " + std::to_string(element_bytes));
  }
  const bool inside = offset <= view.size && element_bytes <= view.size - offset &&
                      (count - 1) <= (view.size - offset - element_bytes) / stride;
  if (!inside) {
    fail(where, "its " + std::to_string(count) + " elements of " + std::to_string(element_bytes) +
                    " bytes from offset " + std::to_string(offset) + " reach past the buffer view's " +
                    std::to_string(view.size) + " bytes");
  }
}

// Everything is checked before the caller asks for memory, so that the bytes that are there bound it.
Accessor open_accessor(const Document& document, int index, size_t components, const std::string& user) {
  const auto& accessors = document.model.accessors;
  if (index < 0 || size_t(index) >= accessors.size()) {
    fail(user,
         "accessor " + std::to_string(index) + " is out of range: the file has " + std::to_string(accessors.size()));
  }
  const tinygltf::Accessor& data = accessors[index];
  Accessor accessor;
  accessor.data = &data;
  accessor.where = user + ", " + place("accessor", index, data.name);
  accessor.components = components;
  accessor.component_bytes = component_size(data.componentType);
  if (accessor.component_bytes == 0) {
    fail(accessor.where, "componentType " + std::to_string(data.componentType) + " is not one of glTF's");
  }
  if (data.count == 0 || data.count > std::numeric_limits<uint32_t>::max()) {
    fail(accessor.where, "count must be from 1 to 4294967295");
  }
  if (data.bufferView >= 0) {
    const ByteRange view = buffer_view(document, data.bufferView, accessor.where);
    accessor.stride = view.stride ? view.stride : accessor.element_bytes();
    check_range(view, data.byteOffset, data.count, accessor.stride, accessor.element_bytes(), accessor.where);
    accessor.bytes = view.data + data.byteOffset;
  } else if (data.count > max_count_without_bytes) {
    fail(accessor.where, "count " + std::to_string(data.count) + " without a bufferView is too large");
  }
  return accessor;
}

// Calls store(element, bytes) for every element: those of the view, then the sparse ones that replace some.
template <class Store>
void for_each_element(const Document& document, const Accessor& accessor, Store&& store) {
  const tinygltf::Accessor& data = *accessor.data;
  if (accessor.bytes) {
    for (size_t i = 0; i < data.count; ++i) store(i, accessor.bytes + i * accessor.stride);
  }
  if (!data.sparse.isSparse) return;
  const auto& sparse = data.sparse;
  const std::string where = accessor.where + ", sparse";
  const size_t index_bytes = component_size(sparse.indices.componentType);
  if (sparse.count < 1 || size_t(sparse.count) > data.count)
    fail(where, "count must be from 1 to the accessor's count");
  if (!is_index_type(sparse.indices.componentType)) fail(where, "indices must be unsigned integers");
  if (sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) fail(where, "byteOffset is negative");
  const ByteRange indices = buffer_view(document, sparse.indices.bufferView, where + " indices");
  const ByteRange values = buffer_view(document, sparse.values.bufferView, where + " values");
  check_range(indices, sparse.indices.byteOffset, sparse.count, index_bytes, index_bytes, where + " indices");
  check_range(values, sparse.values.byteOffset, sparse.count, accessor.element_bytes(), accessor.element_bytes(),
              where + " values");
  for (size_t i = 0; i < size_t(sparse.count); ++i) {
    const uint32_t element =
        as_index(indices.data + sparse.indices.byteOffset + i * index_bytes, sparse.indices.componentType);
    if (element >= data.count) fail(where, "index " + std::to_string(element) + " is out of range");
    store(element, values.data + sparse.values.byteOffset + i * accessor.element_bytes());
  }
}

}  // namespace

ByteRange buffer_view(const Document& document, int index, const std::string& user) {
  const auto& views = document.model.bufferViews;
  if (index < 0 || size_t(index) >= views.size()) {
    fail(user,
         "buffer view " + std::to_string(index) + " is out of range: the file has " + std::to_string(views.size()));
  }
  const tinygltf::BufferView& view = views[index];
  const std::string where = user + ", " + place("buffer view", index, view.name);
  const auto& buffers = document.model.buffers;
  if (view.buffer < 0 || size_t(view.buffer) >= buffers.size()) {
    fail(where,
         "buffer " + std::to_string(view.buffer) + " is out of range: the file has " + std::to_string(buffers.size()));
  }
  const auto& data = buffers[view.buffer].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
    fail(where, "its " + std::to_string(view.byteLength) + " bytes from offset " + std::to_string(view.byteOffset) +
                    " reach past buffer " + std::to_string(view.buffer) + ", which has " + std::to_string(data.size()));
  }
  return {data.data() + view.byteOffset, view.byteLength, view.byteStride};
}

std::vector<float> read_floats(const Document& document, int index, int components, const std::string& user) {
  const Accessor accessor = open_accessor(document, index, size_t(components), user);
  if (accessor.data->type != components) {  // TINYGLTF_TYPE_VECn is n
    fail(accessor.where, "must be of type VEC" + std::to_string(components));
  }
  std::vector<float> result(accessor.data->count * accessor.components, 0.f);
  for_each_element(document, accessor, [&](size_t element, const unsigned char* bytes) {
    for (size_t c = 0; c < accessor.components; ++c) {
      const float value =
          as_float(bytes + c * accessor.component_bytes, accessor.data->componentType, accessor.data->normalized);
      if (!std::isfinite(value)) {
        fail(accessor.where, "element " + std::to_string(element) + " holds a value that is not a finite number");
      }
      result[element * accessor.components + c] = value;
    }
  });
  return result;
}

std::vector<uint32_t> read_indices(const Document& document, int index, const std::string& user) {
  const Accessor accessor = open_accessor(document, index, 1, user);
  if (accessor.data->type != TINYGLTF_TYPE_SCALAR || !is_index_type(accessor.data->componentType)) {
    fail(accessor.where, "indices must be SCALAR unsigned integers");
  }
  std::vector<uint32_t> result(accessor.data->count, 0);
  for_each_element(document, accessor, [&](size_t element, const unsigned char* bytes) {
    result[element] = as_index(bytes, accessor.data->componentType);
  });
  return result;
}

}  // namespace ups::gltf
