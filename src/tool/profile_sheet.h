// The diagrams of a data sheet: the polar diagram, and the cone below the luminaire with its table. Called by the
// commands info and goniometer.
#pragma once
#include "report/profile_plot.h"
#include "tool/profile_file.h"

namespace ups::tool {

Drawing plot_of(const ups_profile* profile, const ProfileReport& report);

// Writes plot_of to a .svg, .png or .pdf file.
void write_plot(const std::string& path, const ups_profile* profile, const ProfileReport& report);

// In a file of its own, cone_plot.cpp.
void draw_cone(Drawing& drawing, const Frame& frame, const ups_profile* profile, const ProfileReport& report);

}  // namespace ups::tool
