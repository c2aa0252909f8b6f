// ups info: what a scene file contains and calls for, what photometric files say: a page for one file, a table for many
// or for a folder, one JSON object for programs.
#include <algorithm>
#include <set>

#include "platform/files.h"
#include "platform/paths.h"
#include "tool/commands.h"
#include "tool/handles.h"
#include "tool/info_report.h"
#include "tool/profile_sheet.h"
#include "tool/report.h"
#include "tool/text_format.h"

namespace ups::tool {

namespace {

std::string sensor_text(const SensorEntry& sensor) {
  const SensorInfo& info = sensor.info;
  const char* name = sensor.name.c_str();
  if (info.kind == SensorKind::camera)
    return format("  camera %s: %u x %u, %s%s\n", name, info.width, info.height, projection_word(info.projection),
                  info.illuminance ? ", illuminance too" : "");
  if (info.kind == SensorKind::goniometer)
    return format("  goniometer %s: %u planes of %u angles\n", name, info.columns, info.rows);
  if (info.kind == SensorKind::observer) return "  observer " + printable(sensor.name) + "\n";
  if (info.columns > 0) return format("  meters %s: grid of %u x %u\n", name, info.columns, info.rows);
  if (info.layout == MeterLayout::surface) return format("  meters %s: %u triangles\n", name, info.meter_count);
  if (info.layout == MeterLayout::lightmap)
    return format("  meters %s: lightmap of %u x %u\n", name, info.width, info.height);
  return format("  meters %s: %u points\n", name, info.meter_count);
}

SceneReport scene_report_of(const std::string& file, const LoadedScene& scene) {
  SceneReport report{};
  report.file = file;
  report.info.struct_size = sizeof report.info;
  check(ups_scene_get_info(scene.scene, &report.info));
  const auto text = [&](ups_scene_text topic) {
    std::vector<std::string> lines = lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_scene_get_text(scene.scene, topic, to, capacity, needed);
    }));
    for (std::string& line : lines) line = for_people(scene, line);
    return lines;
  };
  report.sensors = scene.sensors;
  report.effects = text(UPS_SCENE_TEXT_EFFECTS);
  report.techniques = text(UPS_SCENE_TEXT_TECHNIQUES);
  append_once(report.warnings, scene.warnings);
  return report;
}

std::string scene_text(const SceneReport& scene) {
  const ups_scene_info& info = scene.info;
  const auto count = [](uint64_t n) { return static_cast<unsigned long long>(n); };
  std::string text = scene.file + format("\ntriangles: %llu\n", count(info.triangle_count));
  if (info.bounds_min_m[0] <= info.bounds_max_m[0]) {
    text += format("bounds: (%g, %g, %g) to (%g, %g, %g) m\n", info.bounds_min_m[0], info.bounds_min_m[1],
                   info.bounds_min_m[2], info.bounds_max_m[0], info.bounds_max_m[1], info.bounds_max_m[2]);
  }
  text += format("emitters: %llu luminaires, %llu lights, %llu emitting instances, together %.6g lm\n",
                 count(info.luminaire_count), count(info.light_count), count(info.emissive_instance_count),
                 info.emitted_flux_lm);
  text += format("sensors: %llu meters, %llu pixels\n", count(info.meter_count), count(info.pixel_count));
  for (const SensorEntry& sensor : scene.sensors) text += sensor_text(sensor);
  return text + list_text("effects", scene.effects) + list_text("techniques", scene.techniques) +
         list_text("warnings", scene.warnings);
}

InfoEntry failed(const std::string& file, const std::string& name, const std::string& error) {
  InfoEntry entry;
  entry.file = file;
  entry.name = name;
  entry.error = error;
  return entry;
}

// The photometric files, by name, of a folder and of those below it, in the order of their paths. Links to folders are
// not followed, so there is an end. A folder that cannot be read is an entry of its own.
std::vector<InfoEntry> search(const std::string& top) {
  std::vector<InfoEntry> found;
  std::vector<std::string> folders = {top};
  while (!folders.empty()) {
    const std::string folder = std::move(folders.back());
    folders.pop_back();
    std::error_code error;
    for (const platform::FolderEntry& entry : platform::entries_of(folder, error)) {
      if (entry.is_folder) {
        if (!entry.is_link) folders.push_back(entry.path);
      } else if (photometric_format(entry.path)) {
        found.push_back(failed(entry.path, platform::relative_to(top, entry.path), ""));
      }
    }
    if (!error) continue;
    const std::string message = "cannot read the folder '" + folder + "': " + platform::message_of(error);
    if (folder == top) throw Failure(message);
    found.push_back(failed(folder, platform::relative_to(top, folder), message));
  }
  if (found.empty())
    throw Failure("no photometric file in the folder '" + top + "': its name would end in " + known_extensions);
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
  return found;
}

std::vector<InfoEntry> expand(const std::vector<std::string>& arguments) {
  std::vector<InfoEntry> entries;
  for (const std::string& argument : arguments) {
    if (platform::is_folder(argument)) {
      const std::vector<InfoEntry> found = search(argument);
      entries.insert(entries.end(), found.begin(), found.end());
    } else {
      entries.push_back(failed(argument, platform::file_name_of(argument), ""));
    }
  }
  return entries;
}

// Reads one file; what is wrong with it becomes the entry's error.
void read_entry(ups_context* context, const InfoOptions& options, const std::vector<std::string>& plots,
                bool with_sheet, InfoEntry& entry) {
  if (!entry.error.empty()) return;  // a folder
  try {
    if (is_scene_file(entry.file)) {
      if (!plots.empty()) throw Failure(entry.file + ": --plot draws photometric files, not scenes");
      if (options.csv) throw Failure(entry.file + ": --csv has data sheets of photometric files, none of scenes");
      entry.scene = scene_report_of(entry.file, load_scene(entry.file, {0, 0, 0, options.allow_outside}));
    } else {
      const Profile profile = read_profile(context, entry.file);
      entry.profile = report_of_file(entry.file, profile.get());
      if (with_sheet) entry.sheet = data_sheet_of(*entry.profile, profile.get());
      for (const std::string& plot : plots) write_plot(plot, profile.get(), *entry.profile);
    }
  } catch (const std::exception& e) {
    entry.error = e.what();
  }
}

// Where the plots of one of several files go: OUT.svg becomes OUT_NAME.svg, with NAME from the file's, each once.
std::vector<std::string> plots_of(const InfoEntry& entry, const InfoOptions& options, bool several,
                                  std::set<std::string>& taken) {
  if (!several) return options.plots;
  std::vector<std::string> plots;
  for (const std::string& plot : options.plots) {
    const std::string base = one_line(platform::stem_of(plot) + "_" + platform::stem_of(entry.file));
    const auto path_of = [&](const std::string& stem) {
      return platform::joined(platform::folder_of(plot), stem + platform::extension_of(plot));
    };
    std::string path = path_of(base);
    for (int i = 2; !taken.insert(path).second; ++i) path = path_of(base + "_" + std::to_string(i));
    plots.push_back(path);
  }
  return plots;
}

std::string table_text(const std::vector<InfoEntry>& entries) {
  constexpr size_t widest = 48;
  size_t width = 4;
  for (const InfoEntry& entry : entries) width = std::max(width, printable(entry.name).size());
  width = std::min(width, widest);
  std::string text = table_head(width);
  for (const InfoEntry& entry : entries) {
    const std::string name = printable(entry.name);
    text += entry.profile ? table_line(*entry.profile, name, width)
            : entry.scene ? table_line(*entry.scene, name, width)
                          : table_error(entry.file, entry.error, name, width);
  }
  return text;
}

std::string csv_text(const std::vector<InfoEntry>& entries) {
  std::string text = csv_header();
  for (const InfoEntry& entry : entries)
    if (entry.sheet) text += csv_rows(entry.file, *entry.sheet);
  return text;
}

}  // namespace

int info(const InfoOptions& options) {
  std::vector<InfoEntry> entries = expand(options.files);
  const Context context = make_context(1);
  std::set<std::string> taken;
  const bool single = entries.size() == 1 && entries[0].file == options.files[0];
  for (InfoEntry& entry : entries)
    read_entry(context.get(), options, plots_of(entry, options, entries.size() > 1, taken),
               single || options.json || options.csv, entry);
  if (options.json) {
    put(stdout, to_json(entries));
  } else if (options.csv) {
    put(stdout, csv_text(entries));
  } else if (!single) {
    put(stdout, table_text(entries));
  } else if (entries[0].error.empty()) {
    put(stdout, entries[0].scene ? scene_text(*entries[0].scene)
                                 : to_text(*entries[0].profile) + to_text(*entries[0].sheet));
  }
  int code = exit_done;
  for (const InfoEntry& entry : entries) {
    if (entry.error.empty()) continue;
    put_error(entry.error);
    code = exit_failed;
  }
  return code;
}

}  // namespace ups::tool
