// The boundary: every function of the C API runs its body in guard(), which turns exceptions into a status and this
// thread's message, in the floating-point environment that results are computed in. Nothing escapes. Included by
// src/api alone.
#pragma once
#include <string>
#include <type_traits>

#include "base/error.h"
#include "base/floating_point.h"
#include "photometry/photometry.h"

namespace ups::api {

// Keeps "function: message" as this thread's last error; returns status.
ups_status fail(ups_status status, const char* function, const char* message) noexcept;

template <class Body>
ups_status guard(const char* function, const Body& body) noexcept {
  const DefaultFloatingPoint environment;
  try {
    if constexpr (std::is_same_v<std::invoke_result_t<Body>, ups_status>) {
      return body();  // with a status of its own, such as UPS_TIMEOUT
    } else {
      body();
      return UPS_OK;
    }
  } catch (const photometry::ParseError& e) {
    return fail(UPS_ERROR_PARSE, function, e.what());
  } catch (const photometry::UnsupportedError& e) {
    return fail(UPS_ERROR_UNSUPPORTED, function, e.what());
  } catch (...) {
    return tell_exception([&](ups_status status, const char* message) { return fail(status, function, message); });
  }
}

// A pointer argument that must not be NULL.
template <class T>
T& require(T* pointer, const char* argument) {
  if (!pointer) fail_argument(std::string(argument) + " is NULL");
  return *pointer;
}

}  // namespace ups::api
