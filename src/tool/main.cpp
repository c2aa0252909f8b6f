// The program `ups`: its command line; the options of the commands that render are in options_*.cpp.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

#include "platform/process.h"
#include "tool/options.h"
#include "tool/report.h"
#include "tool/text_format.h"

namespace {

using ups::tool::GoniometerOptions;
using ups::tool::InfoOptions;
using ups::tool::MapOptions;
using ups::tool::RenderOptions;
using ups::tool::ReplayOptions;

const CLI::App* add_info(CLI::App& app, InfoOptions& options) {
  CLI::App* command = app.add_subcommand("info", "What a scene or photometric files contain");
  command->add_option("FILE", options.files, "Scenes, photometric files, folders of photometric files")->required();
  command->add_option("--plot", options.plots,
                      "Polar diagram and cone of FILE, as OUT.svg, .png or .pdf, or several: --plot A.svg B.png; of "
                      "several files A_NAME.svg each")
      ->allow_extra_args(false)
      ->check(CLI::Validator(ups::tool::plot_file, ""))
      ->type_name("OUT");
  ups::tool::add_allow_outside(*command, options.allow_outside);
  const auto json = command->add_flag("--json", options.json, "Print one JSON object on standard output");
  command->add_flag("--csv", options.csv, "Print the data sheets of photometric files as CSV, a value a line")
      ->excludes(json);
  // CLI11 takes what follows the first OUT for a FILE; no file that is read is an image.
  command->parse_complete_callback([&options] {
    if (options.plots.empty()) return;
    const auto plots = std::stable_partition(options.files.begin(), options.files.end(),
                                             [](const auto& file) { return !ups::tool::plot_file(file).empty(); });
    options.plots.insert(options.plots.end(), plots, options.files.end());
    options.files.erase(plots, options.files.end());
    if (options.files.empty()) throw CLI::RequiredError("FILE");
  });
  command->footer(
      "A file is read by what is in it, whatever its name. A folder is searched in depth for .ies, .ldt, .xml, "
      ".tm25ray,\n.sdf, .dat and .ray. One file: a page; several or a folder: a table, with files that cannot be read "
      "in it; the\nexit code is then 1.\n"
      "Flux is by the band rule. Beam angle: 50 % of the plane's peak, field angle: 10 %.");
  return command;
}

const CLI::App* add_convert(CLI::App& app, std::string& in, std::string& out) {
  CLI::App* command = app.add_subcommand("convert", "Write a photometric file as IES LM-63-2019 or EULUMDAT");
  command->add_option("IN", in, "A photometric file")->required();
  command->add_option("OUT", out, "A .ies or .ldt file")
      ->required()
      ->check(CLI::Validator(ups::tool::written_file, ""));
  command->footer(
      "The distribution reads back the same; tables of type A and B are resampled for EULUMDAT.\n"
      "Of several lamp sets the first is written.");
  return command;
}

// A command that is reserved: known, but not yet for anything.
void add_later(CLI::App& app, const std::string& name) {
  app.add_subcommand(name)->allow_extras()->group("")->parse_complete_callback(
      [name] { throw CLI::ValidationError("ups " + name, "is not built yet"); });
}

// --help and --version are no errors.
int tell_usage(const CLI::App& app, const CLI::ParseError& e) {
  std::ostringstream out, err;
  const int code = app.exit(e, out, err);
  ups::tool::put(stdout, out.str());
  ups::tool::put(stderr, err.str());
  return code == 0 ? ups::tool::exit_done : ups::tool::exit_usage;
}

// CLI11 asks for a command where it does not know the one that is there. Nothing: it does.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].empty() || arguments[0][0] == '-') return {};
  if (app.get_option_no_throw(arguments[0])) return {};  // not built yet
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == arguments[0]) return {};
    if (!command->get_group().empty()) names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return "'" + arguments[0] + "' is no command; there are " + names;
}

int run(const std::vector<std::string>& arguments) {
  CLI::App app("Illuminance and luminance by Unified Path Sampling", "ups");
  app.set_version_flag("--version", "ups " + ups::tool::version_number());
  app.require_subcommand(1);
  RenderOptions render_options;
  ups::tool::add_render(app, render_options);
  ReplayOptions replay_options;
  const CLI::App* replay = ups::tool::add_replay(app, replay_options);
  GoniometerOptions goniometer_options;
  const CLI::App* goniometer = ups::tool::add_goniometer(app, goniometer_options);
  InfoOptions info_options;
  const CLI::App* info = add_info(app, info_options);
  MapOptions map_options;
  const CLI::App* map = ups::tool::add_map(app, map_options);
  std::string in, out;
  const CLI::App* convert = add_convert(app, in, out);
  for (const char* name : {"merge", "report"}) add_later(app, name);
  std::string a, b;
  bool json = false;
  CLI::App* compare = app.add_subcommand("compare", "How far the image A is from the reference B");
  compare->add_option("A.exr", a)->required();
  compare->add_option("B.exr", b, "The reference")->required();
  compare->add_flag("--json", json, "Print one JSON object on standard output");
  compare->footer(
      "Over luminance Y of R, G, B, or the channel Y. With B as R:\n"
      "relative_mse = mean[(A - R)^2 / (R^2 + 0.01 mean(R)^2)]; -1: unknown, as B is black.\n"
      "channels: means over all pixels and channels; mse and relative_mse (with R still the luminance in the\n"
      "denominator) of the differences, noise_a, noise_b and relative_noise_b of the squared standard errors of A and "
      "B\n(-1: not in the file); trimmed_...: without the 0.1 % of the pixels that differ most. mse - noise_b is the "
      "mean\nsquared error of A without the noise of the reference.");
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // CLI11 takes the last word first
  } catch (const CLI::ParseError& e) {
    if (const std::string unknown = unknown_command(app, arguments); !unknown.empty()) {
      ups::tool::put_error(unknown);
      return ups::tool::exit_usage;
    }
    return tell_usage(app, e);
  }
  if (info->parsed()) return ups::tool::info(info_options);
  if (replay->parsed()) return ups::tool::replay(replay_options);
  if (goniometer->parsed()) return ups::tool::goniometer(goniometer_options);
  if (map->parsed()) return ups::tool::map(map_options);
  if (convert->parsed()) return ups::tool::convert(in, out);
  if (compare->parsed()) return ups::tool::compare(a, b, json);
  render_options.arguments = arguments;
  return ups::tool::render(render_options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    ups::platform::let_large_files_fail();
    const int code = run(ups::platform::program_arguments(argc, argv));
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) {  // what did not fit its buffer may have failed before
      ups::tool::put_error("cannot write to standard output");
      return ups::tool::exit_failed;
    }
    return code;
  } catch (const ups::tool::WrongUsage& e) {
    ups::tool::put_error(e.what());
    return ups::tool::exit_usage;
  } catch (const std::exception& e) {
    ups::tool::put_error(e.what());
    return ups::tool::exit_failed;
  }
}
