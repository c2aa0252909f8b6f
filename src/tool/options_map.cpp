// Options of maps: those of `ups render` and `ups map` alike, and the latter's own.
#include <cmath>
#include <map>

#include "report/drawing_file.h"
#include "tool/options.h"

namespace ups::tool {
namespace {

bool parse_number(const std::string& text, double& out) {
  return CLI::detail::lexical_cast(text, out) && std::isfinite(out);
}

// LOW:HIGH; the text of what is wrong, or none.
std::string parse_range(const std::string& text, double& low, double& high) {
  const size_t colon = text.find(':');
  const bool good = colon != std::string::npos && parse_number(text.substr(0, colon), low) &&
                    parse_number(text.substr(colon + 1), high) && is_range(low, high);
  return good ? "" : "must be LOW:HIGH, two numbers from 0 on, the second larger, such as 0:1000, not '" + text + "'";
}

std::string threshold(const std::string& text) {
  double value;
  return parse_number(text, value) && value > 0 ? "" : "must be a number greater than 0, not '" + text + "'";
}

}  // namespace

void add_map_options(CLI::App& command, MapStyle& style) {
  static const std::string group = "Maps";
  static const std::map<std::string, MapScale> scales = {{"linear", MapScale::linear}, {"log", MapScale::logarithmic}};
  static const std::map<std::string, MapColours> colours = {
      {"viridis", MapColours::viridis}, {"cividis", MapColours::cividis}, {"grey", MapColours::grey}};
  command
      .add_option_function<std::string>(
          "--map-scale", [&style](const std::string& word) { style.scale = scales.at(word); },
          "linear or log: of the colours and the isolines (linear)")
      ->check(CLI::IsMember({"linear", "log"}))
      ->type_name("WORD")
      ->group(group);
  const auto add_range = [&](const char* name, double& low, double& high, const char* words) {
    const auto check = [](const std::string& text) {
      double from, to;
      return parse_range(text, from, to);
    };
    command
        .add_option_function<std::string>(
            name, [&low, &high](const std::string& text) { parse_range(text, low, high); }, words)
        ->check(CLI::Validator(check, ""))
        ->type_name("LOW:HIGH")
        ->group(group);
  };
  add_range("--map-range", style.low, style.high,
            "Ends of the colours of illuminances, LOW:HIGH; without it the values decide");
  add_range("--map-range-luminance", style.luminance_low, style.luminance_high, "The same of cameras' luminances");
  command
      .add_option("--map-threshold", style.threshold,
                  "Of illuminances: which meet this, which do not, and of which the 95 % bound crosses it, in three colours")
      ->check(CLI::Validator(threshold, ""))
      ->type_name("LX")
      ->group(group);
  command.add_option("--map-threshold-luminance", style.luminance_threshold, "The same of cameras' luminances")
      ->check(CLI::Validator(threshold, ""))
      ->type_name("CD_M2")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--map-colours", [&style](const std::string& word) { style.colours = colours.at(word); },
          "viridis, cividis or, for print, grey: all rise evenly in lightness (viridis)")
      ->check(CLI::IsMember({"viridis", "cividis", "grey"}))
      ->type_name("WORD")
      ->group(group);
  command.add_flag("--map-cells", style.cells, "Each cell in one colour, without what lies between the values")
      ->group(group);
  command.parse_complete_callback([&style] {
    const auto check = [&](const char* name, double low, double high) {
      if (style.scale == MapScale::logarithmic && high > 0 && !(low > 0))
        throw CLI::ValidationError(name, "a logarithmic scale must begin above 0");
    };
    check("--map-range", style.low, style.high);
    check("--map-range-luminance", style.luminance_low, style.luminance_high);
  });
}

const CLI::App* add_map(CLI::App& app, MapOptions& options) {
  CLI::App* command = app.add_subcommand("map", "Draw a map of what `ups render --out` wrote, without rendering again");
  command->add_option("FILE", options.file, "NAME.csv of meters, NAME.exr of a camera or a grid")->required();
  command->add_option("OUT", options.out, "The drawing, .svg, .png or .pdf; of several names each")
      ->required()
      ->check(CLI::Validator(
          [](const std::string& path) {
            return is_drawing_file(path) ? "" : "must end in .svg, .png or .pdf, not '" + path + "'";
          },
          ""));
  command->add_option("--scene", options.scene, "The .gltf or .glb file that was rendered: meters get its plan")
      ->type_name("SCENE");
  command->add_option("--title", options.title, "Instead of the file's name")->type_name("TEXT");
  command->add_flag("--illuminance", options.illuminance, "Of a camera the illuminance, not the luminance");
  add_allow_outside(*command, options.allow_outside);
  add_map_options(*command, options.style);
  command->footer(
      "Meters in one plane become a map in false colours with isolines, seen against their normals; those of a list\n"
      "get the cells of the lattice they lie on, else each its nearest surroundings. North is +Y.");
  return command;
}

}  // namespace ups::tool
