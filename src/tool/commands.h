// The program's commands and their options. main.cpp fills the options and turns what is thrown into exit codes.
#pragma once
#include <cstdint>
#include <string>

#include "ups/ups_base.h"

namespace ups::tool {

inline constexpr int exit_done = 0, exit_failed = 1, exit_usage = 2, exit_interrupted = 130;

struct RenderOptions {
  std::string scene, out;
  int32_t method = 0;  // UPS_METHOD_*
  double time_s = 0;   // 0: not given, as for the next two
  uint32_t iterations = 0;
  double target_error = 0;
  uint64_t seed = 1;
  int threads = 0;
  uint32_t width = 0, height = 0;  // 0: as the file says
  bool json = false;
};

int render(const RenderOptions& options);
int info(const std::string& file);
int compare(const std::string& a, const std::string& b, bool json);

}  // namespace ups::tool
