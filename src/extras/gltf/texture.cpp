// Images of the file become linear textures of the scene: PNG and JPEG, sRGB decoded where glTF says so, single
// channels taken out of metallic-roughness images. Each image and use is decoded once.
#include <cmath>
#include <cstring>

#include "gltf/import.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wshadow"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace ups::gltf {

namespace {

constexpr int gl_repeat = 10497;

// IEC 61966-2-1.
float srgb_to_linear(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }

struct Pixels {  // 4 channels, 0 to 1 as stored
  uint32_t width = 0, height = 0;
  std::vector<float> values;
};

Pixels decode_image(const unsigned char* bytes, size_t size, const std::string& where) {
  if (size > size_t(std::numeric_limits<int>::max())) throw extras::Error(UPS_ERROR_PARSE, where + ": too large");
  const auto* data = bytes;
  const int count = int(size);
  int width = 0, height = 0, channels = 0;
  Pixels result;
  const auto take = [&](auto* decoded, float largest) {
    if (!decoded) {
      if (std::strcmp(stbi_failure_reason(), "outofmem") == 0) throw std::bad_alloc();
      throw extras::Error(UPS_ERROR_PARSE, where + ": not a readable PNG or JPEG image: " + stbi_failure_reason());
    }
    const std::unique_ptr<void, void (*)(void*)> owner(decoded, stbi_image_free);
    result.width = uint32_t(width);
    result.height = uint32_t(height);
    result.values.resize(size_t(width) * size_t(height) * 4);
    for (size_t i = 0; i < result.values.size(); ++i) result.values[i] = decoded[i] / largest;
  };
  if (stbi_is_16_bit_from_memory(data, count)) {
    take(stbi_load_16_from_memory(data, count, &width, &height, &channels, 4), 65535.f);
  } else {
    take(stbi_load_from_memory(data, count, &width, &height, &channels, 4), 255.f);
  }
  return result;
}

Pixels read_image(const Document& document, size_t index, const std::string& user) {
  const tinygltf::Image& image = document.model.images[index];
  const std::string where = user + ", " + place("image", index, image.name);
  if (image.bufferView >= 0) {
    const ByteRange range = buffer_view(document, image.bufferView, where);
    return decode_image(range.data, range.size, where);
  }
  if (!image.image.empty()) return decode_image(image.image.data(), image.image.size(), where);
  const Bytes bytes = read_uri(document, image.uri, where);
  return decode_image(bytes.data(), bytes.size(), where);
}

}  // namespace

ups_texture_id Importer::texture(const JsonReader& material, const JsonReader& info, Decode decode) {
  const auto& textures = document_.model.textures;
  const int64_t index = info.integer("index", -1, 0, std::numeric_limits<int32_t>::max());
  if (index < 0 || size_t(index) >= textures.size()) {
    info.fail("index", "is missing or out of range: the file has " + std::to_string(textures.size()) + " textures");
  }
  const tinygltf::Texture& texture = textures[size_t(index)];
  const std::string where = material.where() + ", " + place("texture", size_t(index), texture.name);
  if (texture.source < 0) {
    std::string names;
    for (const auto& extension : texture.extensions) names += (names.empty() ? "" : ", ") + extension.first;
    warn(where + ": skipped, it has no image (\"source\") that is PNG or JPEG" +
         (names.empty() ? "" : ", only one of " + names) + "; what it multiplies is taken alone");
    return {};
  }
  if (size_t(texture.source) >= document_.model.images.size()) {
    throw extras::Error(UPS_ERROR_PARSE, where + ": \"source\" is out of range: the file has " +
                                             std::to_string(document_.model.images.size()) + " images");
  }
  warn_about_extensions(info, {});
  if (texture.sampler >= 0 && size_t(texture.sampler) < document_.model.samplers.size()) {
    const tinygltf::Sampler& sampler = document_.model.samplers[size_t(texture.sampler)];
    if (sampler.wrapS != gl_repeat || sampler.wrapT != gl_repeat) {
      warn(where + ": its sampler's clamping or mirroring is skipped, the texture repeats");
    }
  }

  const std::string key = std::to_string(texture.source) + "/" + std::to_string(int(decode));
  for (const auto& [known, id] : textures_) {
    if (known == key) return id;
  }
  const Pixels pixels = read_image(document_, size_t(texture.source), where);
  const uint32_t channels = decode == Decode::color_with_alpha                  ? 4
                            : decode == Decode::green || decode == Decode::blue ? 1
                                                                                : 3;
  const uint32_t first = decode == Decode::green ? 1 : decode == Decode::blue ? 2 : 0;
  const bool srgb = decode == Decode::color || decode == Decode::color_with_alpha;
  std::vector<float> texels(pixels.values.size() / 4 * channels);
  for (size_t i = 0; i < texels.size(); ++i) {
    const uint32_t channel = first + uint32_t(i % channels);
    const float value = pixels.values[i / channels * 4 + channel];
    texels[i] = srgb && channel < 3 ? srgb_to_linear(value) : value;
  }
  ups_texture_desc desc;
  ups_texture_desc_init(&desc, sizeof desc);
  desc.width = pixels.width;
  desc.height = pixels.height;
  desc.channel_count = channels;
  desc.texels = texels.data();
  ups_texture_id id{};
  check(ups_scene_add_texture(scene_, &desc, &id), where);
  textures_.emplace_back(key, id);
  return id;
}

}  // namespace ups::gltf
