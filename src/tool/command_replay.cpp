// ups replay: one sample of a render traced again, as text, JSON and drawing.
#include "tool/commands.h"
#include "report/drawing_file.h"
#include "tool/handles.h"
#include "tool/inputs.h"
#include "tool/output.h"
#include "tool/path_plot.h"
#include "report/profile_plot.h"
#include "tool/render_job.h"
#include "tool/report.h"
#include "tool/text_format.h"

namespace ups::tool {

int replay(const ReplayOptions& options) {
  if (!options.plot.empty()) prepare_file("--plot", options.plot);
  const LoadedScene scene =
      load_scene(options.scene, {options.threads, options.width, options.height, options.allow_outside});
  if (!options.plot.empty()) spare_inputs(options.scene, {{"--plot", options.plot}});
  const ups_sample sample = sample_at(scene, options.sample);
  ups_path* traced = nullptr;
  check_options(ups_replay(scene.scene, &options.desc, &sample, &traced));
  const Path path(traced);
  PathReport report{options.scene, options.sample, {}, {}, {}, {}};
  report.info.struct_size = sizeof report.info;
  check(ups_path_get_info(path.get(), &report.info));
  report.vertices = read_array<ups_path_vertex>([&](ups_path_vertex* to, size_t capacity, size_t* needed) {
    return ups_path_read_vertices(path.get(), to, capacity, needed);
  });
  report.contributions =
      read_array<ups_path_contribution>([&](ups_path_contribution* to, size_t capacity, size_t* needed) {
        return ups_path_read_contributions(path.get(), to, capacity, needed);
      });
  report.text = read_text([&](char* to, size_t capacity, size_t* needed) {
    return ups_path_get_text(path.get(), to, capacity, needed);
  });
  if (!options.plot.empty()) {
    const std::string title = options.scene + ", sample " + options.sample;
    write_drawing(options.plot, plot_of(scene.scene, report.vertices, report.contributions, title), {title, ""});
  }
  put(stdout, options.json ? to_json(report) : report.text);
  return exit_done;
}

}  // namespace ups::tool
