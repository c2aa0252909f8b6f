// A thread's last error, kept where exhausted memory cannot hurt: not thread_local, whose first use in a thread may
// need memory and ends the process where there is none. Needs the standard library and platform/ alone: included by the
// boundaries of the core and of the extras, each of which has one.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "platform/thread_slot.h"

namespace ups {

// The size without a UTF-8 character that was cut in two.
inline size_t whole_characters(const char* bytes, size_t size) {
  size_t start = size;
  while (start > 0 && (bytes[start - 1] & 0xc0) == 0x80) --start;
  if (start == 0) return size;
  const unsigned char lead = static_cast<unsigned char>(bytes[start - 1]);
  const size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 1;
  return start - 1 + length > size ? start - 1 : size;
}

class LastError {
 public:
  // Keeps "prefix: message", or the message alone where the prefix is empty. Without memory for a longer text than any
  // before the end is cut off.
  void set(const char* prefix, const char* message) noexcept {
    const size_t name = std::strlen(prefix), body = std::strlen(message);
    Text* text = grown(name + 2 + body + 1);
    if (!text) return;
    size_t size = 0;
    const auto append = [&](const char* from, size_t count) {
      count = std::min(count, text->capacity - 1 - size);
      std::memcpy(text->bytes() + size, from, count);
      size += count;
    };
    if (name) append(prefix, name), append(": ", 2);
    append(message, body);
    if (name + (name ? 2 : 0) + body > size) size = whole_characters(text->bytes(), size);
    text->bytes()[size] = '\0';
  }

  // Never null; empty before the first error. Valid until the thread's next error.
  const char* get() const noexcept {
    const void* kept = slot_.get();
    if (kept == &no_memory) return no_memory;
    return kept ? static_cast<const Text*>(kept)->bytes() : "";
  }

 private:
  struct Text {
    size_t capacity;
    char* bytes() { return reinterpret_cast<char*>(this + 1); }
    const char* bytes() const { return reinterpret_cast<const char*>(this + 1); }
  };
  static constexpr char no_memory[] = "out of memory, even for a message";

  // This thread's text, with room for `size` bytes if there is memory; null if it never got any.
  Text* grown(size_t size) noexcept {
    void* kept = slot_.get();
    Text* old = kept == &no_memory ? nullptr : static_cast<Text*>(kept);
    if (old && old->capacity >= size) return old;
    const size_t capacity = std::max<size_t>(size, 512);
    Text* text = static_cast<Text*>(std::malloc(sizeof(Text) + capacity));
    if (!text) {
      if (!old) slot_.set(&no_memory);
      return old;
    }
    text->capacity = capacity;
    if (!slot_.set(text)) {
      std::free(text);
      return old;
    }
    std::free(old);
    return text;
  }
  static void release(void* kept) {
    if (kept != &no_memory) std::free(kept);
  }

  platform::ThreadSlot slot_{&release};
};

}  // namespace ups
