// Pictures of luminance images, as PNG: their exposure, and less noise where that is asked for. Called by the render
// command and by output.cpp.
#pragma once
#include <string>

#include "tool/commands.h"
#include "tool/report.h"

namespace ups::tool {

inline constexpr uint32_t layers_that_steer_smoothing = UPS_LAYER_ALBEDO | UPS_LAYER_NORMAL | UPS_LAYER_DEPTH;

// Of each camera in the report.
void add_exposures(const LoadedScene& scene, const ups_result* result, const PictureOptions& options, Report& report);

void write_picture(const std::string& path, const SensorEntry& camera, const ups_result* result,
                   const PictureOptions& options);

}  // namespace ups::tool
