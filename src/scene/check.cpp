// See check.h.
#include "scene/check.h"

#include <charconv>
#include <limits>

namespace ups::check {

std::string text(double value) {
  char buffer[32];
  const bool fits = !std::isfinite(value) || std::abs(value) <= double(std::numeric_limits<float>::max());
  const auto end = fits ? std::to_chars(buffer, buffer + sizeof buffer, float(value))
                        : std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end.ptr};
}

void finite(double value, const std::string& field) {
  if (!std::isfinite(value)) fail_argument(field + " is " + text(value) + "; it must be finite");
}

void range(double value, double low, double high, const std::string& field) {
  if (std::isnan(value) || value < low || value > high)
    fail_argument(field + " is " + text(value) + "; it must lie in [" + text(low) + ", " + text(high) + "]");
}

void at_least(double value, double low, const std::string& field) {
  if (!std::isfinite(value) || value < low)
    fail_argument(field + " is " + text(value) + "; it must be finite and at least " + text(low));
}

void flag(int32_t value, const std::string& field) {
  if (value != 0 && value != 1) fail_argument(field + " is " + std::to_string(value) + "; it must be 0 or 1");
}

void pointer(const void* p, const std::string& field) {
  if (!p) fail_argument(field + " is NULL; it must point to data");
}

void enumeration(int32_t value, int32_t last, const std::string& field, const char* names) {
  if (value < 0 || value > last)
    fail_argument(field + " is " + std::to_string(value) + "; it must be one of " + names + " (0 to " +
                  std::to_string(last) + ")");
}

void colour(const float (&rgb)[3], double low, double high, const std::string& field) {
  for (size_t i = 0; i < 3; ++i) {
    if (std::isinf(high))
      at_least(double(rgb[i]), low, element(field, i));
    else
      range(double(rgb[i]), low, high, element(field, i));
  }
}

void transform(const double (&m)[12], const std::string& field) {
  for (size_t i = 0; i < 12; ++i) finite(m[i], element(field, i));
  Affine a;
  std::copy(std::begin(m), std::end(m), a.m);
  const double sizes = length(a.column(0)) * length(a.column(1)) * length(a.column(2));
  for (int k = 0; k < 3; ++k)  // of shorter ones squares have no digits left
    if (!(max_abs(a.column(k)) >= 1e-100))
      fail_argument(field + " is singular: its axis " + std::to_string(k) +
                    " is shorter than 1e-100; it must be invertible");
  // Flat to within rounding counts as flat: the inverse would have no digits left.
  if (!(std::abs(a.determinant()) > 1e-14 * sizes && std::isfinite(sizes)))
    fail_argument(field + " is singular (determinant " + text(a.determinant()) + "); it must be invertible");
}

void all_finite(const Floats& floats, const std::string& field, const std::string& stride_field) {
  if (floats.stride != 0 && (floats.stride < 4 * floats.width || floats.stride % 4 != 0))
    fail_argument(stride_field + " is " + std::to_string(floats.stride) +
                  "; it must be 0 (tight) or a multiple of 4 of at least " + std::to_string(4 * floats.width));
  for (size_t i = 0; i < floats.count; ++i) {
    const float* p = floats.at(i);
    for (size_t k = 0; k < floats.width; ++k)
      if (!std::isfinite(p[k]))
        fail_argument(field + ": element " + std::to_string(i) + ", component " + std::to_string(k) + " is " +
                      text(double(p[k])) + "; it must be finite");
  }
}

}  // namespace ups::check
