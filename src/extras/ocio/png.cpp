// Pictures as PNG files through stb_image_write, which compiles here alone.
#include <algorithm>

#include "common/atomic_file.h"
#include "ocio/picture.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wshadow"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace ups::ocio {

Picture::Picture(uint32_t w, uint32_t h, const Color& background) : width(w), height(h) {
  rgb.resize(size_t(w) * h * 3);
  for (size_t i = 0; i < rgb.size(); ++i) rgb[i] = background[i % 3];
}

void Picture::fill(uint32_t x, uint32_t y, uint32_t w, uint32_t h, const Color& color) {
  for (uint32_t row = y; row < std::min(y + h, height); ++row) {
    for (uint32_t column = x; column < std::min(x + w, width); ++column) {
      for (size_t c = 0; c < 3; ++c) rgb[(size_t(row) * width + column) * 3 + c] = color[c];
    }
  }
}

namespace {

// PNG, annex D; the polynomial's bits from the lowest one on.
uint32_t crc(const unsigned char* bytes, size_t count) {
  uint32_t c = ~0u;
  for (size_t i = 0; i < count; ++i) {
    c ^= bytes[i];
    for (int k = 0; k < 8; ++k) c = (c & 1 ? 0xEDB88320u : 0) ^ (c >> 1);
  }
  return ~c;
}

void append_big_endian(std::vector<unsigned char>& to, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(uint8_t(value >> shift));
}

std::vector<unsigned char> text_chunk(const std::string& keyword, const std::string& text) {
  const std::string content = "tEXt" + keyword + '\0' + text;
  std::vector<unsigned char> chunk;
  append_big_endian(chunk, uint32_t(content.size() - 4));
  chunk.insert(chunk.end(), content.begin(), content.end());
  append_big_endian(chunk, crc(chunk.data() + 4, content.size()));
  return chunk;
}

}  // namespace

void write_png(const std::string& path, const Picture& picture, const PngTexts& texts) {
  std::vector<unsigned char> bytes;
  const auto append = [](void* context, void* data, int size) {
    auto& to = *static_cast<std::vector<unsigned char>*>(context);
    const auto* from = static_cast<unsigned char*>(data);
    to.insert(to.end(), from, from + size);
  };
  if (!stbi_write_png_to_func(append, &bytes, int(picture.width), int(picture.height), 3, picture.rgb.data(), 0)) {
    throw extras::Error(UPS_ERROR_INTERNAL, "cannot compress the picture '" + path + "'");
  }
  constexpr ptrdiff_t header = 33;  // signature and IHDR
  for (size_t i = texts.size(); i-- > 0;) {
    const std::vector<unsigned char> chunk = text_chunk(texts[i].first, texts[i].second);
    bytes.insert(bytes.begin() + header, chunk.begin(), chunk.end());
  }
  extras::write_file(path, bytes.data(), bytes.size());
}

}  // namespace ups::ocio
