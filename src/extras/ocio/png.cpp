// Pictures as PNG files through stb_image_write, which compiles here alone.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "common/atomic_file.h"
#include "ocio/picture.h"
#include "platform/thread_slot.h"

namespace {

// stb_image_write goes on with memory that it did not get: here that throws, and what it holds by then is freed with the
// scope. One at a time in a thread.
class StbMemory {
 public:
  StbMemory() {
    if (!slot.set(this)) throw std::bad_alloc();
  }
  ~StbMemory() {
    while (Block* first = blocks_.next) unlink(first), std::free(first);
    slot.set(nullptr);
  }
  StbMemory(const StbMemory&) = delete;
  StbMemory& operator=(const StbMemory&) = delete;

  static void* resize(void* old, size_t size) {
    StbMemory& all = *static_cast<StbMemory*>(slot.get());
    Block* block = old ? static_cast<Block*>(old) - 1 : nullptr;
    if (block) unlink(block);
    void* grown = std::realloc(block, sizeof(Block) + size);
    if (Block* kept = grown ? static_cast<Block*>(grown) : block) all.link(kept);
    if (!grown) throw std::bad_alloc();
    return static_cast<Block*>(grown) + 1;
  }
  static void release(void* memory) {
    if (!memory) return;
    Block* block = static_cast<Block*>(memory) - 1;
    unlink(block);
    std::free(block);
  }

 private:
  struct alignas(std::max_align_t) Block {
    Block *next = nullptr, *before = nullptr;
  };
  void link(Block* block) {
    *block = {blocks_.next, &blocks_};
    if (block->next) block->next->before = block;
    blocks_.next = block;
  }
  static void unlink(Block* block) {
    block->before->next = block->next;
    if (block->next) block->next->before = block->before;
  }

  static const ups::platform::ThreadSlot slot;
  Block blocks_;
};
const ups::platform::ThreadSlot StbMemory::slot([](void*) {});

}  // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wshadow"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_MALLOC(size) StbMemory::resize(nullptr, size)
#define STBIW_REALLOC(memory, size) StbMemory::resize(memory, size)
#define STBIW_FREE(memory) StbMemory::release(memory)
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
  const StbMemory memory;
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
