// The command line's parts: options that commands share, and what their values must be. Each check gives the text of
// what is wrong, or "". Called by main.cpp. With options_*.cpp and main.cpp all that includes CLI11.
#pragma once
#include <CLI/CLI.hpp>

#include "tool/commands.h"

namespace ups::tool {

// Method, limits, seed, threads, --json; scene: the file. `words`: those that --method takes; `aim`: what
// --target-error is of.
void add_job_options(CLI::App& command, JobOptions& options, const std::vector<std::string>& words,
                     const std::string& aim);
void add_allow_outside(CLI::App& command, bool& allow_outside);
void add_map_options(CLI::App& command, MapStyle& style);
void add_render(CLI::App& app, RenderOptions& options);
const CLI::App* add_replay(CLI::App& app, ReplayOptions& options);
const CLI::App* add_map(CLI::App& app, MapOptions& options);
const CLI::App* add_goniometer(CLI::App& app, GoniometerOptions& options);

std::string plot_file(const std::string& path);
std::string written_file(const std::string& path);  // .ies or .ldt

}  // namespace ups::tool
