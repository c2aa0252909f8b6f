// How a small library of the extras meets its C callers: exceptions become a status and a thread's message, descs and
// texts are copied by size. Each library keeps one thread-local message of its own. Called by the extras alone.
#pragma once
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "base/floating_point.h"
#include "base/last_error.h"
#include "base/owner.h"
#include "ups/ups_base.h"

namespace ups::extras {

class Error : public std::runtime_error {
 public:
  Error(ups_status status, const std::string& message) : std::runtime_error(message), status_(status) {}
  ups_status status() const { return status_; }

 private:
  ups_status status_;
};

inline void require(bool condition, const char* message) {
  if (!condition) throw Error(UPS_ERROR_INVALID_ARGUMENT, message);
}

// Of this library's own making, and not destroyed.
template <HandleType T>
void require_handle(const T* handle, const char* argument) {
  if (!handle) throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string(argument) + " is NULL");
  if (!handle->owner.is_ours())
    throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string(argument) + " is no handle of its kind that this library made, "
                                                                    "or it was destroyed already");
}

// Libraries that answer exhausted memory by an exception of their own tell of it in words.
inline bool tells_of_memory(const std::exception& e) {
  return std::strstr(e.what(), "bad_alloc") || std::strstr(e.what(), "allocate memory") ||
         std::strstr(e.what(), std::strerror(ENOMEM));
}

// Other libraries end the process where memory runs out within them (OpenColorIO, Cairo, the JSON reader): before they
// are called more than they take is asked for.
inline void ask_for_memory(size_t bytes) {
  void* volatile block = std::malloc(bytes);
  if (!block) throw std::bad_alloc();
  std::free(block);
}
inline constexpr size_t ample_bytes = size_t(32) << 20;

// Runs body in the floating-point environment that results are computed in; what it throws becomes the status, the text
// goes to last_error.
template <class Body>
ups_status guarded(LastError& last_error, Body&& body) noexcept {
  const DefaultFloatingPoint environment;
  try {
    body();
    return UPS_OK;
  } catch (const Error& e) {
    last_error.set("", e.what());
    return e.status();
  } catch (const std::exception& e) {
    if (dynamic_cast<const std::bad_alloc*>(&e) || dynamic_cast<const std::length_error*>(&e) || tells_of_memory(e)) {
      last_error.set("", "out of memory");
      return UPS_ERROR_OUT_OF_MEMORY;
    }
    last_error.set("internal error", e.what());
    return UPS_ERROR_INTERNAL;
  } catch (...) {
    last_error.set("", "internal error of an unknown kind");
    return UPS_ERROR_INTERNAL;
  }
}

// For *_init: at most struct_size bytes of the defaults, and 0 for what a later version's struct has beyond them.
template <class Desc>
void write_defaults(Desc* desc, uint32_t struct_size, Desc defaults) {
  if (!desc || struct_size < sizeof(uint32_t)) return;
  defaults.struct_size = struct_size;
  std::memcpy(static_cast<void*>(desc), &defaults, std::min<size_t>(struct_size, sizeof(Desc)));
  if (struct_size > sizeof(Desc))
    std::memset(reinterpret_cast<char*>(desc) + sizeof(Desc), 0, struct_size - sizeof(Desc));
}

// As of the core: struct_size and one field; a multiple of the struct's alignment; no more than any version will need.
template <class Struct>
void check_size(uint32_t size, const char* advice) {
  if (size < 8 || size > 4096 || size % alignof(Struct) != 0)
    throw Error(UPS_ERROR_INVALID_ARGUMENT, "struct_size is " + std::to_string(size) +
                                                "; it must be the struct's sizeof, a multiple of " +
                                                std::to_string(alignof(Struct)) + " from 8 to 4096: " + advice);
}

// The caller's desc over this version's defaults. Where it is longer, the fields that this version does not know must
// be 0: they would be ignored.
template <class Desc>
Desc read_desc(const Desc* given, Desc defaults) {
  if (!given) return defaults;
  const uint32_t size = given->struct_size;
  check_size<Desc>(size, "fill the desc by its init function first");
  for (size_t i = sizeof(Desc); i < size; ++i)
    if (reinterpret_cast<const char*>(given)[i] != 0)
      throw Error(UPS_ERROR_UNSUPPORTED, "struct_size is " + std::to_string(size) + "; this version knows " +
                                             std::to_string(sizeof(Desc)) + " bytes, but byte " + std::to_string(i) +
                                             " is not 0: a field of a later version is set that would be ignored");
  std::memcpy(static_cast<void*>(&defaults), given, std::min<size_t>(size, sizeof(Desc)));
  return defaults;
}

// Copies at most struct_size bytes, which the caller set, and leaves struct_size alone.
template <class Info>
void write_info(const Info& from, Info* to) {
  require(to != nullptr, "info is NULL");
  const uint32_t size = to->struct_size;
  check_size<Info>(size, "it must be set before the call");
  std::memcpy(static_cast<void*>(to), &from, std::min<size_t>(size, sizeof(Info)));
  to->struct_size = size;
}

// The two-call protocol for texts.
inline void copy_text(const std::string& from, char* text, size_t capacity, size_t* needed) {
  require(needed != nullptr || text != nullptr, "both text and needed are NULL");
  const size_t size = from.size() + 1;
  if (needed) *needed = size;
  if (!text) {
    require(capacity == 0, "text is NULL but capacity is not 0");
    return;
  }
  if (capacity < size) {
    throw Error(UPS_ERROR_BUFFER_TOO_SMALL,
                "the text needs " + std::to_string(size) + " bytes, capacity is " + std::to_string(capacity));
  }
  std::memcpy(text, from.c_str(), size);
}

}  // namespace ups::extras
