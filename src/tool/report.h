// A render's numbers as text and JSON. Called by the commands that render.
#pragma once
#include <string>
#include <vector>

#include "report/findings.h"
#include "tool/handles.h"
#include "tool/sample_address.h"

namespace ups::tool {

struct RenderReport : Report {
  std::vector<SampleReport> largest_samples;
  std::string replay;  // the shell's words that trace the first of them again
  ups_memory_estimate memory{};
};

std::string percent_text(double fraction);               // "1.25 %"; "unknown" below 0
std::string bound_text(double bound, const char* unit);  // " +- 3.1 lm (95 %)"; " +- unknown" below 0
const char* projection_word(ups_projection projection);  // as in a scene file

std::string to_text(const RenderReport& report);
std::string to_json(const RenderReport& report);

// A sample traced again.
struct PathReport {
  std::string scene, address;
  ups_path_info info;
  std::vector<ups_path_vertex> vertices;
  std::vector<ups_path_contribution> contributions;
  std::string text;
};
std::string to_json(const PathReport& report);

// Means over all pixels and channels of squared differences and of squared standard errors; -1: not known. trimmed: of
// the pixels without the thousandth that differs most. relative: each pixel divided as for relative_mse.
struct ChannelErrors {
  double mse, relative_mse, trimmed_mse;
  double noise_a, noise_b, relative_noise_b, trimmed_noise_b;
};

struct Comparison {
  double rmse, relative_mse, mean_a, mean_b;
  uint32_t worst_x, worst_y;
  ChannelErrors channels;
};
std::string to_json(const Comparison& comparison);

}  // namespace ups::tool
