// Structs that cross the boundary with their size, and texts that are asked for twice. A caller built against another
// version may have a shorter or longer struct: what it lacks gets the library's defaults, what is unknown must be 0.
// Included by src/api alone.
#pragma once
#include <algorithm>
#include <cstring>
#include <string>

#include "api/guard.h"

namespace ups::api {

// struct_size and one field; a multiple of the struct's alignment, as each sizeof is, so that no pointer is cut in two;
// no more than any version will need.
template <class Struct>
uint32_t checked_size(const Struct* data, const char* argument) {
  uint32_t size;
  std::memcpy(&size, data, sizeof size);
  if (size < 8 || size > 4096 || size % alignof(Struct) != 0)
    fail_argument(std::string(argument) + "->struct_size is " + std::to_string(size) +
                  "; it must be the struct's sizeof, which is a multiple of " + std::to_string(alignof(Struct)) +
                  " from 8 to 4096");
  return size;
}

// For *_init: at most `size` bytes of the defaults, and 0 for what a later version's struct has beyond them.
template <class Desc>
void write_defaults(Desc* desc, uint32_t size, Desc defaults) {
  if (!desc || size < sizeof size) return;
  defaults.struct_size = size;
  std::memcpy(static_cast<void*>(desc), &defaults, std::min<size_t>(size, sizeof defaults));
  if (size > sizeof defaults) std::memset(reinterpret_cast<char*>(desc) + sizeof defaults, 0, size - sizeof defaults);
}

// Throws where the caller's struct has more fields than this version's, `known` bytes, and one of them is set.
inline void check_unknown_fields(const void* desc, uint32_t size, size_t known, const char* argument) {
  const auto* bytes = static_cast<const unsigned char*>(desc);
  for (size_t i = known; i < size; ++i)
    if (bytes[i] != 0)
      throw Error(UPS_ERROR_UNSUPPORTED,
                  std::string(argument) + "->struct_size is " + std::to_string(size) + "; this version knows " +
                      std::to_string(known) + " bytes, but byte " + std::to_string(i) +
                      " is not 0: a field of a later version is set that would be ignored");
}

// A row-major 3x4 transform that changes nothing.
inline void set_identity(double (&m)[12]) {
  std::fill(std::begin(m), std::end(m), 0.0);
  m[0] = m[5] = m[10] = 1;
}

// The whole desc: what the caller has, defaults for the rest. argument: its name.
template <class Desc>
Desc read_desc(const Desc* desc, void (*init)(Desc*, uint32_t), const char* argument = "desc") {
  require(desc, argument);
  const uint32_t size = checked_size(desc, argument);
  check_unknown_fields(desc, size, sizeof *desc, argument);
  Desc whole;
  init(&whole, uint32_t(sizeof whole));
  std::memcpy(&whole, desc, std::min<size_t>(size, sizeof whole));
  whole.struct_size = uint32_t(sizeof whole);
  return whole;
}

// For *_get_info and the like: out->struct_size bytes, of which 0 are those of later versions' fields; struct_size itself
// stays.
template <class Info>
void write_info(Info* out, Info whole, const char* argument) {
  require(out, argument);
  const uint32_t size = checked_size(out, argument);
  whole.struct_size = size;
  std::memset(static_cast<void*>(out), 0, size);
  std::memcpy(out, &whole, std::min<size_t>(size, sizeof whole));
}

// The two-call convention: *needed always gets the bytes with the final zero. False where text is NULL: only asked.
inline bool copy_text(const std::string& from, char* text, size_t capacity, size_t* needed) {
  if (!text && capacity > 0) fail_argument("text is NULL, but capacity is " + std::to_string(capacity));
  if (!text && !needed) fail_argument("needed is NULL; without text it is all that can be answered");
  const size_t size = from.size() + 1;
  if (needed) *needed = size;
  if (!text) return false;
  if (capacity < size)
    throw Error(UPS_ERROR_BUFFER_TOO_SMALL,
                "capacity is " + std::to_string(capacity) + "; the text needs " + std::to_string(size) + " bytes");
  std::memcpy(text, from.c_str(), size);
  return true;
}

// The same for arrays of plain elements; *needed gets their number. element: the one of an index.
template <class Element, class Get>
void copy_array(size_t count, Element* out, size_t capacity, size_t* needed, const std::string& noun,
                const Get& element) {
  if (!out && capacity > 0) fail_argument(noun + " is NULL, but capacity is " + std::to_string(capacity));
  if (!out && !needed) fail_argument("needed is NULL; without " + noun + " it is all that can be answered");
  if (needed) *needed = count;
  if (!out) return;
  if (capacity < count)
    throw Error(UPS_ERROR_BUFFER_TOO_SMALL,
                "capacity is " + std::to_string(capacity) + "; there are " + std::to_string(count) + " " + noun);
  for (size_t i = 0; i < count; ++i) out[i] = element(i);
}

}  // namespace ups::api
