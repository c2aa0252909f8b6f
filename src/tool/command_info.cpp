// ups info: what a scene file contains and calls for, what photometric files say: a page for one file, a table for many
// or for a folder, one JSON object for programs.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "tool/commands.h"
#include "tool/handles.h"
#include "tool/info_report.h"
#include "tool/profile_plot.h"

namespace ups::tool {

namespace {

void print_list(const char* title, const std::vector<std::string>& lines) {
  std::printf("%s:%s\n", title, lines.empty() ? " none" : "");
  for (const std::string& line : lines) std::printf("  %s\n", line.c_str());
}

void print_sensor(const SensorEntry& sensor) {
  const ups_gltf_sensor_info& info = sensor.info;
  if (info.kind == UPS_GLTF_CAMERA) {
    std::printf("  camera %s: %u x %u%s\n", sensor.name.c_str(), info.width, info.height,
                info.illuminance ? ", illuminance too" : "");
  } else if (info.kind == UPS_GLTF_GONIOMETER) {
    std::printf("  goniometer %s: %u planes of %u angles\n", sensor.name.c_str(), info.columns, info.rows);
  } else if (info.columns > 0) {
    std::printf("  meters %s: grid of %u x %u\n", sensor.name.c_str(), info.columns, info.rows);
  } else {
    std::printf("  meters %s: %u points\n", sensor.name.c_str(), info.meter_count);
  }
}

SceneReport scene_report_of(const std::string& file, const LoadedScene& scene) {
  SceneReport report{};
  report.file = file;
  report.info.struct_size = sizeof report.info;
  check(ups_scene_get_info(scene.scene.get(), &report.info));
  const auto text = [&](ups_scene_text topic) {
    return lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_scene_get_text(scene.scene.get(), topic, to, capacity, needed);
    }));
  };
  report.sensors = scene.sensors;
  report.effects = text(UPS_SCENE_TEXT_EFFECTS);
  report.techniques = text(UPS_SCENE_TEXT_TECHNIQUES);
  report.warnings = scene.warnings;
  return report;
}

void print_scene(const SceneReport& scene) {
  const ups_scene_info& info = scene.info;
  const auto count = [](uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf("%s\n", scene.file.c_str());
  std::printf("triangles: %llu\n", count(info.triangle_count));
  if (info.bounds_min_m[0] <= info.bounds_max_m[0]) {
    std::printf("bounds: (%g, %g, %g) to (%g, %g, %g) m\n", info.bounds_min_m[0], info.bounds_min_m[1],
                info.bounds_min_m[2], info.bounds_max_m[0], info.bounds_max_m[1], info.bounds_max_m[2]);
  }
  std::printf("emitters: %llu luminaires, %llu lights, %llu emitting instances, together %.6g lm\n",
              count(info.luminaire_count), count(info.light_count), count(info.emissive_instance_count),
              info.emitted_flux_lm);
  std::printf("sensors: %llu meters, %llu pixels\n", count(info.meter_count), count(info.pixel_count));
  for (const SensorEntry& sensor : scene.sensors) print_sensor(sensor);
  print_list("effects", scene.effects);
  print_list("techniques", scene.techniques);
  print_list("warnings", scene.warnings);
}

// The photometric files of a folder, by name; other files as they are.
std::vector<std::string> expand(const std::vector<std::string>& arguments) {
  std::vector<std::string> files;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!std::filesystem::is_directory(argument, error)) {
      files.push_back(argument);
      continue;
    }
    std::vector<std::string> found;
    for (auto entry = std::filesystem::directory_iterator(argument, error);
         !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
      std::error_code ignored;
      const std::string file = entry->path().string();
      if (photometric_format(file) && !entry->is_directory(ignored)) found.push_back(file);
    }
    if (error) throw Failure("cannot read the folder '" + argument + "': " + error.message());
    if (found.empty()) {
      throw Failure("no photometric file in the folder '" + argument +
                    "': its name would end in .ies, .ldt, .xml, .tm25ray, .sdf, .dat or .ray");
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

// One file; what is wrong with it becomes the entry's error.
InfoEntry read_entry(ups_context* context, const std::string& file, const std::vector<std::string>& plots) {
  InfoEntry entry;
  entry.file = file;
  try {
    const std::string extension = lower_extension(file);
    if (photometric_format(file)) {
      const Profile profile = read_profile(context, file);
      entry.profile = make_report(file, profile.get());
      for (const std::string& plot : plots) write_plot(plot, profile.get(), *entry.profile);
    } else if (extension == ".gltf" || extension == ".glb") {
      if (!plots.empty()) throw Failure(file + ": --plot draws photometric files, not scenes");
      entry.scene = scene_report_of(file, load_scene(file, 0, 0, 0));
    } else {
      throw Failure(file +
                    ": not a kind of file that is known here: .gltf, .glb, .ies, .ldt, .xml, .tm25ray, .sdf, "
                    ".dat or .ray");
    }
  } catch (const std::exception& e) {
    entry.error = e.what();
  }
  return entry;
}

void print_table(const std::vector<InfoEntry>& entries) {
  constexpr size_t widest = 48;
  size_t width = 4;
  for (const InfoEntry& entry : entries)
    width = std::max(width, std::filesystem::path(entry.file).filename().string().size());
  width = std::min(width, widest);
  std::fputs(table_head(width).c_str(), stdout);
  for (const InfoEntry& entry : entries) {
    const std::string line = entry.profile ? table_line(*entry.profile, width)
                             : entry.scene ? table_line(*entry.scene, width)
                                           : table_error(entry.file, entry.error, width);
    std::fputs(line.c_str(), stdout);
  }
}

}  // namespace

int info(const InfoOptions& options) {
  const std::vector<std::string> files = expand(options.files);
  if (!options.plots.empty() && files.size() != 1) throw Failure("--plot draws one photometric file at a time");
  const Context context = make_context(1);
  std::vector<InfoEntry> entries;
  for (const std::string& file : files) entries.push_back(read_entry(context.get(), file, options.plots));
  const bool single = files.size() == 1 && files == options.files;
  if (options.json) {
    std::fputs(to_json(entries).c_str(), stdout);
  } else if (!single) {
    print_table(entries);
  } else if (entries[0].error.empty()) {
    if (entries[0].scene) print_scene(*entries[0].scene);
    if (entries[0].profile) std::fputs(to_text(*entries[0].profile).c_str(), stdout);
  }
  int code = exit_done;
  for (const InfoEntry& entry : entries) {
    if (entry.error.empty()) continue;
    std::fprintf(stderr, "ups: error: %s\n", entry.error.c_str());
    code = exit_failed;
  }
  return code;
}

}  // namespace ups::tool
