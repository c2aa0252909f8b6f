// Figures for README.md's table: told by the full form.
#pragma once
#include <cstdarg>
#include <cstdio>

#include "full.h"

namespace ups::test {

[[gnu::format(printf, 1, 2)]] inline void measured(const char* format, ...) {
  if (!full()) return;
  std::va_list values;
  va_start(values, format);
  std::printf("[ MEASURED ] ");
  std::vprintf(format, values);
  std::printf("\n");
  va_end(values);
}

}  // namespace ups::test
