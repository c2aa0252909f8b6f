// Options of `ups render` and those that all commands that render share.
#include <cfloat>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

#include "report/drawing_file.h"
#include "tool/options.h"
#include "tool/profile_file.h"
#include "tool/report.h"
#include "tool/sample_address.h"

namespace ups::tool {

std::string plot_file(const std::string& path) {
  return is_drawing_file(path) ? "" : "must end in .svg, .png or .pdf, not '" + path + "'";
}

std::string written_file(const std::string& path) {
  return is_written_format(path) ? "" : "must end in .ies or .ldt, not '" + path + "'";
}

void add_allow_outside(CLI::App& command, bool& allow_outside) {
  command.add_flag("--allow-outside", allow_outside,
                   "Files that the scene names may lie anywhere, not only in its folder and below it");
}

namespace {

std::string positive(const std::string& text) {
  double value = 0;
  const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
  return good ? "" : "must be a number greater than 0, not '" + text + "'";
}

std::string between(const std::string& text, double smallest, double largest, const std::string& words) {
  double value = 0;
  const bool good = CLI::detail::lexical_cast(text, value) && value >= smallest && value <= largest;
  return good ? "" : "must be a number " + words + ", not '" + text + "'";
}

std::string finite(const std::string& text) { return between(text, -DBL_MAX, DBL_MAX, "that is finite"); }

// ups_render_desc holds both as floats: beyond these they would be 0, hence off, or infinite, or 1.
std::string target(const std::string& text) { return between(text, 1e-30, 1e30, "from 1e-30 to 1e30, such as 0.02"); }
std::string fraction(const std::string& text) { return between(text, 1e-6, 0.999999, "between 0 and 1"); }

// Decimal digits for CLI11, which would read "010" as octal, let "-1" wrap around and cut what is too large.
CLI::Validator whole(uint64_t least, uint64_t most) {
  const std::string range = std::to_string(least) + " - " + std::to_string(most);
  return {[=](std::string& text) -> std::string {
            uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto parsed = std::from_chars(text.data(), end, value);
            if (parsed.ec != std::errc() || parsed.ptr != end || value < least || value > most)
              return "must be a whole number from " + std::to_string(least) + " to " + std::to_string(most) + ", not '" +
                     text + "'";
            text = std::to_string(value);
            return "";
          },
          most < UINT64_MAX ? "UINT in [" + range + "]" : ""};
}

// WxH into the two numbers; the text of what is wrong, or none.
std::string parse_size(const std::string& text, uint32_t& width, uint32_t& height) {
  constexpr uint32_t max_side = 16384;
  const size_t cross = text.find('x');
  const auto number = [](const std::string& digits, uint32_t& out) {
    if (digits.empty() || digits.size() > 5 || digits.find_first_not_of("0123456789") != std::string::npos)
      return false;
    out = uint32_t(std::stoul(digits));
    return out >= 1 && out <= max_side;
  };
  if (cross != std::string::npos && number(text.substr(0, cross), width) && number(text.substr(cross + 1), height)) {
    return {};
  }
  return "must be WIDTHxHEIGHT, each from 1 to 16384, such as 640x480, not '" + text + "'";
}

// A number of bytes, with K, M, G or T thousands of them and so on; the text of what is wrong, or none.
std::string parse_bytes(const std::string& text, uint64_t& bytes) {
  constexpr std::string_view units = "KMGT";
  double value = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  const std::string_view unit(parsed.ptr, size_t(end - parsed.ptr));
  const size_t power = unit.empty() ? 0 : units.find(unit[0]) + 1;
  const bool known = unit.empty() || (power > 0 && (unit.size() == 1 || unit.substr(1) == "B"));
  value *= std::pow(1000.0, double(power));
  if (parsed.ec == std::errc() && known && value >= 1 && value <= 1e18) {
    bytes = uint64_t(value);
    return {};
  }
  return "must be a number of bytes such as 800M, 2.5G or 4000000000, not '" + text + "'";
}

// Within the method: for comparisons and for those who know what they look for.
void add_method_options(CLI::App& command, ups_render_desc& desc) {
  static const std::string group = "Method in detail";
  command
      .add_option_function<std::vector<std::string>>(
          "--techniques",
          [&desc](const std::vector<std::string>& words) {
            for (const std::string& word : words) desc.techniques |= technique_bit(word);
          },
          "Only these of the method's: emitter_hit,light_sample,connect,sensor_connect,merge,sensor_hit,mirror_sample")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Validator(
          [](const std::string& word) {
            return technique_bit(word) ? std::string() : "'" + word + "' is no technique";
          },
          ""))
      ->type_name("LIST")
      ->group(group);
  command
      .add_option("--max-path-length", desc.max_path_length, "Edges of the longest path; without it there is no limit")
      ->transform(whole(1, UINT32_MAX))
      ->type_name("N")
      ->group(group);
  command.add_option("--light-paths", desc.light_paths_per_iteration, "Of an iteration; rounded up to a power of two")
      ->transform(whole(1, uint32_t(1) << 24))
      ->type_name("N")
      ->group(group);
  command.add_option("--merge-radius", desc.merge_radius_m,
                     "First radius of merging, of meters the widest, m; without it the scene decides")
      ->check(CLI::Validator(target, ""))
      ->type_name("M")
      ->group(group);
  command.add_option("--alpha", desc.radius_alpha,
                     "How slowly the radius of pixels and walks falls, between 0 and 1 (2/3)")
      ->check(CLI::Validator(fraction, ""))
      ->type_name("A")
      ->group(group);
  command
      .add_option("--glossy-alpha", desc.glossy_alpha,
                  "sppm passes metal and rough glass sharper than this GGX alpha (0.2)")
      ->check(CLI::Validator(fraction, ""))
      ->type_name("A")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--perturbation",
          [&desc](const std::string& word) {
            desc.perturbation = word == "actual" ? UPS_PERTURBATION_ACTUAL : UPS_PERTURBATION_VIRTUAL;
          },
          "virtual, or actual: connect to points drawn within the merging radius, as biased as merging is")
      ->check(CLI::IsMember({"virtual", "actual"}))
      ->type_name("WORD")
      ->group(group);
  command
      .add_option(
          "--technique-images", desc.technique_images,
          "With --out: NAME_techniques.exr, what each technique brings for paths of up to so many edges (at most 16)")
      ->transform(whole(1, 16))
      ->type_name("N")
      ->group(group);
}

// What a render is of and how it goes on its way, but not where it ends.
void add_scene_options(CLI::App& command, JobOptions& options, const std::vector<std::string>& words) {
  static const std::map<std::string, int32_t> methods = {
      {"auto", UPS_METHOD_AUTO},         {"ups", UPS_METHOD_UPS},
      {"pt", UPS_METHOD_PATH_TRACING},   {"lt", UPS_METHOD_LIGHT_TRACING},
      {"bpt", UPS_METHOD_BIDIRECTIONAL}, {"ppm", UPS_METHOD_PPM},
      {"sppm", UPS_METHOD_SPPM},         {"bpm", UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING}};
  std::string listed;
  for (size_t i = 1; i < words.size(); ++i) listed += ", " + words[i];
  command.add_option("SCENE", options.scene, "A .gltf or .glb file")->required();
  command
      .add_option_function<std::string>(
          "--method", [&options](const std::string& word) { options.desc.method = methods.at(word); },
          "auto (the scene decides)" + listed)
      ->check(CLI::IsMember(words))
      ->type_name("METHOD");
  command.add_option("--threads", options.threads, "0: all hardware threads")
      ->transform(whole(0, 1024))
      ->type_name("N");
  add_allow_outside(command, options.allow_outside);
  command.add_flag("--json", options.json, "Print one JSON object on standard output");
}

const std::vector<std::string> method_words = {"auto", "ups", "pt", "lt", "bpt", "ppm", "sppm", "bpm"};

void add_size(CLI::App& command, uint32_t& width, uint32_t& height) {
  command
      .add_option_function<std::string>(
          "--size", [&](const std::string& text) { parse_size(text, width, height); },
          "Size of every camera's image, instead of the file's")
      ->check(CLI::Validator(
          [](const std::string& text) {
            uint32_t w, h;
            return parse_size(text, w, h);
          },
          ""))
      ->type_name("WxH");
}

std::string ev(const std::string& text) { return between(text, -100, 100, "from -100 to 100, such as 6.5"); }

void add_picture(CLI::App& command, PictureOptions& options) {
  command
      .add_option("--exposure", options.ev100,
                  "Of pictures, EV at ISO 100: a luminance of 2^EV / 8 cd/m2 is shown as an 18 % grey. Without it that is "
                  "the geometric mean between the image's 5th and 95th percentile")
      ->check(CLI::Validator(ev, ""))
      ->type_name("EV");
  command.add_flag("--smooth", options.smooth,
                   "Pictures (PNG) with less noise, for looking at: neighbouring pixels are averaged within their "
                   "errors. Images (EXR) and numbers stay as they are");
}

// A word that is reserved: known, but not yet for anything.
void add_later(CLI::App& command, const std::string& word) {
  command.add_option(word)
      ->check(CLI::Validator([word](const std::string&) { return word + " is not built yet"; }, ""))
      ->group("");
}

void add_separation(CLI::App& command, ups_render_desc& desc, const std::string& what) {
  command
      .add_option_function<std::string>(
          "--separate",
          [&desc](const std::string& word) {
            desc.separation = word == "groups" ? UPS_SEPARATE_GROUPS : UPS_SEPARATE_LUMINAIRES;
          },
          "luminaires or groups" + what)
      ->check(CLI::IsMember({"luminaires", "groups"}))
      ->type_name("WORD");
}

}  // namespace

void add_job_options(CLI::App& command, JobOptions& options, const std::vector<std::string>& words,
                     const std::string& aim) {
  add_scene_options(command, options, words);
  command.add_option("--time", options.desc.time_limit_s, "Stop after this many seconds")
      ->check(CLI::Validator(positive, ""))
      ->type_name("S");
  command.add_option("--iterations", options.desc.iteration_count, "Stop after this many iterations")
      ->transform(whole(1, UINT32_MAX))
      ->type_name("N");
  command
      .add_option("--target-error", options.desc.target_relative_error,
                   "Stop when " + aim + " is below: 0.02 is 2 %")
      ->check(CLI::Validator(target, ""))
      ->type_name("R");
  command.add_option("--seed", options.desc.seed, "Same seed and iterations, same result (1)")
      ->transform(whole(0, UINT64_MAX))
      ->type_name("N");
  command
      .add_option_function<std::string>(
          "--memory-limit", [&options](const std::string& text) { parse_bytes(text, options.desc.memory_limit_bytes); },
          "That scene and render may take together, such as 500M or 2G; without it what the machine and its control "
          "groups leave")
      ->check(CLI::Validator(
          [](const std::string& text) {
            uint64_t bytes;
            return parse_bytes(text, bytes);
          },
          ""))
      ->type_name("BYTES");
}

void add_render(CLI::App& app, RenderOptions& options) {
  CLI::App* command = app.add_subcommand("render", "Compute illuminance and luminance of a glTF scene");
  add_job_options(*command, options, method_words,
                  "the worst meter's relative error, without meters the mean pixel's,");
  static const std::map<std::string, ups_criterion> criteria = {{"worst", UPS_CRITERION_WORST},
                                                                {"p95", UPS_CRITERION_P95},
                                                                {"mean", UPS_CRITERION_MEAN},
                                                                {"median", UPS_CRITERION_MEDIAN}};
  command
      ->add_option_function<std::string>(
          "--target-of", [&options](const std::string& word) { options.desc.target_criterion = criteria.at(word); },
          "worst, p95, mean or median: which error over all meters, without meters over all pixels, --target-error and "
          "predictions are of")
      ->check(CLI::IsMember({"worst", "p95", "mean", "median"}))
      ->type_name("WORD");
  add_size(*command, options.width, options.height);
  add_picture(*command, options.picture);
  add_separation(*command, options.desc,
                 ": with --out, a table NAME_luminaires.csv of what each contributes to each meter");
  command->add_option("--above", options.above, "The share of each set's meters with at least so many lx")
      ->check(CLI::Validator(finite, ""))
      ->allow_extra_args(false)
      ->type_name("LX");
  command
      ->add_option_function<std::vector<std::string>>(
          "--ratio",
          [&options](const std::vector<std::string>& all) {
            for (const std::string& text : all)
              options.ratios.emplace_back(text.substr(0, text.find('/')), text.substr(text.find('/') + 1));
          },
          "The mean of the meters A over that of the meters B, by their names; of sets of as many meters the least and "
          "greatest ratio meter by meter, too (cylindrical over horizontal: the modelling index)")
      ->check(CLI::Validator(
          [](const std::string& text) {
            const size_t slash = text.find('/');
            return slash != std::string::npos && slash > 0 && slash + 1 < text.size() && text.find('/', slash + 1) == std::string::npos
                       ? std::string()
                       : text + " is not two names such as task/surround";
          },
          ""))
      ->allow_extra_args(false)
      ->type_name("A/B");
  command->add_option("--out", options.out, "Folder for images and tables; without it no file is written")
      ->check(CLI::Validator(
          [](const std::string& text) { return std::string(text.empty() ? "must name a folder" : ""); }, ""))
      ->type_name("DIR");
  command
      ->add_flag("--report", options.report,
                 "With --out: report.html, one page to hand in: plan, luminaires, results, accuracy")
      ->needs("--out");
  command
      ->add_option("--targets", options.targets,
                   "What meters and observers must reach, a JSON file: verdicts in the text, the JSON and the report")
      ->type_name("FILE");
  add_map_options(*command, options.map);
  add_method_options(*command, options.desc);
  for (const char* word : {"--state", "--resume"}) add_later(*command, word);
  command->footer(
      "Without --time, --iterations or --target-error a render stops at 2 % or after 60 s.\n"
      "Ctrl-C, SIGTERM or SIGHUP stops it; the results so far are written.");
}

const CLI::App* add_replay(CLI::App& app, ReplayOptions& options) {
  CLI::App* command = app.add_subcommand("replay", "Trace one sample of a render again, and tell all of its path");
  add_scene_options(*command, options, method_words);
  command->add_option("--sample", options.sample, "As largest_samples in the JSON of `ups render` lists them")
      ->required()
      ->check(CLI::Validator(malformed_address, ""))
      ->type_name("ADDRESS");
  command->add_option("--plot", options.plot, "Plan and section of the path, as OUT.svg, .png or .pdf")
      ->check(CLI::Validator(plot_file, ""))
      ->type_name("OUT");
  add_size(*command, options.width, options.height);
  add_separation(*command, options.desc, ", where the render told them apart");
  add_method_options(*command, options.desc);
  command->footer("The options of method must be those of the render that the sample is of.");
  return command;
}

// All that the command has but those of the replay itself: an option of method that is added later is among them.
std::vector<OptionWord> options_of_samples() {
  const std::set<std::string> own = {"--help", "--threads", "--json", "--sample", "--plot"};
  CLI::App app;
  ReplayOptions unused;
  std::vector<OptionWord> all;
  for (const CLI::Option* option : add_replay(app, unused)->get_options()) {
    const std::string name = option->get_name();
    if (name.compare(0, 2, "--") == 0 && own.count(name) == 0)
      all.push_back({name, option->get_items_expected_max() > 0});
  }
  return all;
}

}  // namespace ups::tool
