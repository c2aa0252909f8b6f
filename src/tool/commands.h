// The program's commands and their options. main.cpp fills the options and turns what is thrown into exit codes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ups/ups_render.h"

namespace ups::tool {

inline constexpr int exit_done = 0, exit_failed = 1, exit_usage = 2, exit_interrupted = 130;

struct RenderOptions {
  std::string scene, out;
  ups_render_desc desc;  // limits: 0 where not given
  int threads = 0;
  uint32_t width = 0, height = 0;  // 0: as the file says
  bool json = false;

  RenderOptions() { ups_render_desc_init(&desc, sizeof desc); }
};

struct InfoOptions {
  std::vector<std::string> files;  // or folders
  std::vector<std::string> plots;  // .svg, .png
  bool json = false;
};

int render(const RenderOptions& options);
int info(const InfoOptions& options);
int convert(const std::string& in, const std::string& out);
int compare(const std::string& a, const std::string& b, bool json);

}  // namespace ups::tool
