// What a result says beside its values of light that is missing or hardly known: no path has found it, or few, or a few
// bright ones made most of it; merging blurs it; shading normals lose it. A line each, or nothing. Called by the job.
#pragma once
#include <string>

#include "render/accumulator.h"

namespace ups {

std::string reading_warnings(uint32_t set_id, const MeterSet& meters, const MeterSetReading& set);

// Of an image whose first radius was asked for: where photons are merged over more than what a pixel sees, such as a thin
// rod, most of the disc misses it, and no bound that is told by the disc's halves holds.
std::string blur_notice(uint32_t camera_id, const ImageReading& image);

// Where so many photons lay about what eye paths met that only some of them were merged.
std::string crowd_notice(const WorkCounts& work);

// Where paths end after so many edges. flux: of light paths that do; without light_paths nothing is known of them.
std::string length_notice(uint32_t longest, const WorkCounts& flux, double emitted_lm);

// What of the light shading normals lose that lean from their faces: of that of light paths, flux, where there are any;
// else as eye paths of the render tell it of light that is even everywhere.
std::string leaning_notice(const WorkCounts& flux, const WorkCounts& render, double emitted_lm);

}  // namespace ups
