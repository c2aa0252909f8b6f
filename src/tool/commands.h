// The program's commands and their options. The command line (main.cpp, options*.cpp) fills the options; main.cpp turns
// what is thrown into exit codes.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/handles.h"
#include "report/map.h"
#include "tool/library.h"
#include "ups/ups_render.h"
#include "ups/ups_sensor.h"

namespace ups::tool {

// Words of the command line that do not go with what the file holds.
class WrongUsage : public Failure {
 public:
  using Failure::Failure;
};

inline constexpr int exit_done = 0, exit_failed = 1, exit_usage = 2;  // interrupted: see platform/process.h

// Of every command that renders.
struct JobOptions {
  std::string scene;
  ups_render_desc desc;  // limits: 0 where not given
  int threads = 0;
  bool json = false, allow_outside = false;

  JobOptions() { ups_render_desc_init(&desc, sizeof desc); }
};

// How luminance images become pictures.
struct PictureOptions {
  std::optional<double> ev100;  // none: chosen from each image
  bool smooth = false;
};

struct RenderOptions : JobOptions {
  std::string out;
  bool report = false;
  std::string targets;  // a file; empty: none
  std::vector<std::string> arguments;  // of the program, as it was called
  MapStyle map;
  PictureOptions picture;
  uint32_t width = 0, height = 0;  // 0: as the file says
  std::vector<double> above;                                // lx
  std::vector<std::pair<std::string, std::string>> ratios;  // names of sets of meters
};

struct ReplayOptions : JobOptions {
  std::string sample, plot;        // an address; a drawing, empty: not asked for
  uint32_t width = 0, height = 0;  // 0: as the file says
};

// Options of `ups replay` that must be those of the render, as they change its samples.
struct OptionWord {
  std::string name;  // "--method"
  bool has_value;
};
std::vector<OptionWord> options_of_samples();

struct GoniometerOptions : JobOptions {
  std::string name;                // of the scene's goniometer; empty: the only one
  std::string out, errors;         // .ies or .ldt, .csv; empty: not asked for
  std::vector<std::string> plots;  // .svg, .png, .pdf
  std::vector<std::pair<std::string, std::string>> keywords;
  // Of a goniometer for a scene that has none; grid: the first option that asked for it, empty where there was none.
  ups_goniometer_desc grid;
  std::string grid_option;

  GoniometerOptions() { ups_goniometer_desc_init(&grid, sizeof grid); }
};

struct InfoOptions {
  std::vector<std::string> files;  // or folders
  std::vector<std::string> plots;  // .svg, .png, .pdf
  bool json = false, csv = false, allow_outside = false;
};

struct MapOptions {
  std::string file, scene, title;  // scene, title: empty where not given
  std::vector<std::string> out;    // .svg, .png, .pdf
  bool illuminance = false, allow_outside = false;
  MapStyle style;
};

int render(const RenderOptions& options);
int replay(const ReplayOptions& options);
int goniometer(const GoniometerOptions& options);
int info(const InfoOptions& options);
int convert(const std::string& in, const std::string& out);
int map(const MapOptions& options);
int compare(const std::string& a, const std::string& b, bool json);

}  // namespace ups::tool
