// The files of `ups render --out`: images and tables of every sensor. Called by the render command.
#pragma once
#include <string>
#include <vector>

#include "tool/handles.h"

namespace ups::tool {

// RGB channels: 3 floats a pixel; illuminance: 1. Row 0 at the top.
std::vector<float> read_image(const ups_result* result, const SensorEntry& camera, ups_channel channel);

// Throws Failure where the folder cannot be made or takes no file: better before a long render than after it.
void prepare_folder(const std::string& folder);

// Each file on its own: one that cannot be written does not take the others with it.
struct Written {
  std::vector<std::string> errors, warnings;  // each names its file
};
Written write_outputs(const std::string& folder, const LoadedScene& scene, const ups_result* result);

}  // namespace ups::tool
