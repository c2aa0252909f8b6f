// Options of `ups goniometer`: its grid, its files, the keywords of what it writes.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "tool/options.h"
#include "tool/profile_file.h"
#include "tool/text_format.h"

namespace ups::tool {

namespace {

constexpr double finest_step_deg = 0.1;
constexpr uint64_t most_nodes = 4000000;  // ups_goniometer_desc

// The number of steps that make up `whole` degrees; 0: they do not.
uint32_t steps_of(const std::string& text, double whole) {
  double step = 0;
  if (!CLI::detail::lexical_cast(text, step) || !(step >= finest_step_deg && step <= whole)) return 0;
  const double count = std::round(whole / step);
  return std::abs(count * step - whole) <= 1e-6 * whole ? uint32_t(count) : 0;
}

// An option of the grid: remembered, as the scene's own goniometer leaves no choice of it.
template <class Take>
CLI::Option* add_grid_option(CLI::App& command, GoniometerOptions& options, const std::string& name, const Take& take,
                             const std::string& help) {
  return command.add_option_function<std::string>(
      name,
      [&options, name, take](const std::string& text) {
        take(text, options.grid);
        if (options.grid_option.empty()) options.grid_option = name;
      },
      help);
}

void add_step(CLI::App& command, GoniometerOptions& options, const std::string& name, double whole, bool with_last,
              const std::string& help) {
  add_grid_option(
      command, options, name,
      [=](const std::string& text, ups_goniometer_desc& grid) {
        (with_last ? grid.gamma_count : grid.c_count) = steps_of(text, whole) + with_last;
      },
      help)
      ->check(CLI::Validator(
          [whole](const std::string& text) {
            return steps_of(text, whole)
                       ? std::string()
                       : format("must be from 0.1 to %g degrees and divide %g, not '%s'", whole, whole, text.c_str());
          },
          ""))
      ->type_name("DEG");
}

void add_symmetry(CLI::App& command, GoniometerOptions& options) {
  static const std::map<std::string, ups_profile_symmetry> words = {{"none", UPS_SYMMETRY_NONE},
                                                                    {"axial", UPS_SYMMETRY_AXIAL},
                                                                    {"c0-c180", UPS_SYMMETRY_C0_C180},
                                                                    {"c90-c270", UPS_SYMMETRY_C90_C270},
                                                                    {"quadrants", UPS_SYMMETRY_QUADRANTS}};
  add_grid_option(
      command, options, "--symmetry",
      [](const std::string& word, ups_goniometer_desc& grid) { grid.symmetry = words.at(word); },
      "Of the fixture, known to you: none, axial, c0-c180, c90-c270, quadrants. Directions that it makes alike share "
      "their light, which lessens noise")
      ->check(CLI::IsMember({"none", "axial", "c0-c180", "c90-c270", "quadrants"}))
      ->type_name("WORD");
}

// "disc:0.05", "rectangle:0.6x0.3" into the desc; the text of what is wrong, or none.
std::string parse_opening(const std::string& text, ups_goniometer_desc& grid) {
  const std::string problem =
      "must be disc:DIAMETER or rectangle:XxY, lengths in metres, such as disc:0.05, not '" + text + "'";
  const size_t colon = text.find(':');
  if (colon == std::string::npos) return problem;
  const std::string shape = text.substr(0, colon), sizes = text.substr(colon + 1);
  const size_t cross = shape == "disc" ? std::string::npos : sizes.find('x');
  if (shape != "disc" && (shape != "rectangle" || cross == std::string::npos)) return problem;
  double x = 0, y = 0;
  const auto length = [](const std::string& word, double& out) {
    return CLI::detail::lexical_cast(word, out) && out > 0 && out <= 1000;
  };
  if (!length(sizes.substr(0, cross), x)) return problem;
  if (shape == "disc") {
    y = x;
  } else if (!length(sizes.substr(cross + 1), y)) {
    return problem;
  }
  grid.opening_shape = shape == "disc" ? UPS_OPENING_DISC : UPS_OPENING_RECTANGLE;
  grid.opening_m[0] = float(x);
  grid.opening_m[1] = float(y);
  grid.opening_m[2] = 0;
  return {};
}

void add_opening(CLI::App& command, GoniometerOptions& options) {
  command
      .add_option_function<std::string>(
          "--opening", [&options](const std::string& text) { parse_opening(text, options.grid); },
          "Luminous opening that the file states: disc:DIAMETER or rectangle:XxY, m; without it a point")
      ->check(CLI::Validator(
          [](const std::string& text) {
            ups_goniometer_desc ignored{};
            return parse_opening(text, ignored);
          },
          ""))
      ->type_name("SIZE");
}

// NAME=VALUE; the names that LM-63 knows or a user's own, which begin with _.
std::string keyword(const std::string& text) {
  const size_t equals = text.find('=');
  const bool named = equals != std::string::npos && equals >= 1 && equals <= 64 &&
                     std::all_of(text.begin(), text.begin() + ptrdiff_t(equals),
                                 [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (named && text == one_line(text) && text.size() - equals - 1 <= 1000) return {};
  return "must be NAME=VALUE, such as MANUFAC=Example, the name of letters, digits and _, the value one line of UTF-8, "
         "at most 1000 bytes, not '" +
         text.substr(0, 200) + "'";
}

void add_files(CLI::App& command, GoniometerOptions& options) {
  command.add_option("--out", options.out, "The distribution, as a .ies or .ldt file")
      ->check(CLI::Validator(written_file, ""))
      ->type_name("FILE");
  command.add_option("--errors", options.errors, "Intensity and its errors of every node, as a .csv file")
      ->check(CLI::Validator(
          [](const std::string& path) {
            return lower_extension(path) == ".csv" ? std::string() : "must end in .csv, not '" + path + "'";
          },
          ""))
      ->type_name("FILE");
  command.add_option("--plot", options.plots, "Polar diagram and cone, as OUT.svg, .png or .pdf")
      ->allow_extra_args(false)
      ->check(CLI::Validator(plot_file, ""))
      ->type_name("OUT");
  command
      .add_option_function<std::vector<std::string>>(
          "--keyword",
          [&options](const std::vector<std::string>& words) {
            for (const std::string& word : words)
              options.keywords.emplace_back(word.substr(0, word.find('=')), word.substr(word.find('=') + 1));
          },
          "Of the file, such as MANUFAC=Example or LUMCAT=A1; may be given several times")
      ->allow_extra_args(false)
      ->check(CLI::Validator(keyword, ""))
      ->type_name("NAME=VALUE");
}

// What no option says alone.
void check_grid(const CLI::App& command, const GoniometerOptions& options) {
  const ups_goniometer_desc& grid = options.grid;
  const bool about_90 = grid.symmetry == UPS_SYMMETRY_C90_C270 || grid.symmetry == UPS_SYMMETRY_QUADRANTS;
  const auto given = [&](const char* name) { return command.count(name) > 0; };
  if (grid.symmetry == UPS_SYMMETRY_AXIAL) {
    if (given("--c-step")) throw CLI::ValidationError("--c-step", "symmetry axial has one plane; leave --c-step out");
  } else if (grid.c_count == 1) {
    throw CLI::ValidationError("--c-step", "360 leaves one plane; that is --symmetry axial");
  } else if (about_90 && grid.c_count % 4 != 0) {
    throw CLI::ValidationError("--c-step",
                               "symmetry about C90-C270 needs planes at 90 and 270: the step must divide 90");
  } else if (grid.symmetry == UPS_SYMMETRY_C0_C180 && grid.c_count % 2 != 0) {
    throw CLI::ValidationError("--c-step", "symmetry about C0-C180 needs a plane at 180: the step must divide 180");
  }
  if (uint64_t(grid.c_count) * grid.gamma_count > most_nodes) {
    throw CLI::ValidationError("--c-step, --gamma-step",
                               format("%u planes of %u angles are more than the 4000000 nodes that there may be; "
                                      "take a larger step",
                                      grid.c_count, grid.gamma_count));
  }
}

}  // namespace

const CLI::App* add_goniometer(CLI::App& app, GoniometerOptions& options) {
  CLI::App* command = app.add_subcommand("goniometer", "Measure the luminous intensity of a fixture, as .ies or .ldt");
  add_job_options(*command, options, {"auto", "ups", "lt", "bpt", "ppm", "sppm", "bpm"},
                  "the 95 % noise of the intensities, in the mean over the light,");
  command->add_option("--name", options.name, "Of several goniometers in the scene this one")->type_name("NAME");
  add_step(*command, options, "--c-step", 360, false, "Between the C-planes (15)");
  add_step(*command, options, "--gamma-step", 180, true, "Between the angles gamma (2.5)");
  add_symmetry(*command, options);
  add_opening(*command, options);
  add_files(*command, options);
  command->parse_complete_callback([command, &options] {
    if (options.grid.symmetry == UPS_SYMMETRY_AXIAL && command->count("--c-step") == 0) options.grid.c_count = 1;
    check_grid(*command, options);
  });
  command->footer(
      "Light that leaves the scene is measured at infinity, so put the fixture alone into the scene; meters and "
      "cameras\n"
      "are left out. A scene without a goniometer gets one: nadir (gamma 0) is down, -Z of the results' frame, C0 is "
      "+X.\n"
      "The file is relative photometry: its lamp lumens are what the sources emit. The photometric centre is the\n"
      "fixture's place of your choice: the file has none. Methods are those that trace light paths.\n"
      "Without --time, --iterations or --target-error it stops at 2 % or after 60 s.\n"
      "Ctrl-C, SIGTERM or SIGHUP stops it; the results so far are written.");
  return command;
}

}  // namespace ups::tool
