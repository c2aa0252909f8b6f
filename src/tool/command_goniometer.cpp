// ups goniometer: a fixture in, its luminous intensity distribution out: loads a scene, measures what leaves it, writes
// .ies or .ldt, a table of errors and diagrams, prints the flux balance.

#include "common/atomic_file.h"
#include "platform/paths.h"
#include "tool/commands.h"
#include "tool/goniometer_report.h"
#include "tool/inputs.h"
#include "tool/interrupt.h"
#include "tool/output.h"
#include "tool/profile_sheet.h"
#include "tool/render_job.h"
#include "tool/tables.h"
#include "tool/text_format.h"

namespace ups::tool {

namespace {

std::vector<Output> outputs_of(const GoniometerOptions& options) {
  std::vector<Output> outputs;
  if (!options.out.empty()) outputs.emplace_back("--out", options.out);
  if (!options.errors.empty()) outputs.emplace_back("--errors", options.errors);
  for (const std::string& plot : options.plots) outputs.emplace_back("--plot", plot);
  return outputs;
}

// The scene's own goniometer that is meant; none: it has none.
const SensorEntry* find_goniometer(const LoadedScene& scene, const GoniometerOptions& options) {
  const SensorEntry* found = nullptr;
  std::string names;
  size_t count = 0;
  for (const SensorEntry& sensor : scene.sensors) {
    if (sensor.info.kind != SensorKind::goniometer) continue;
    names += (names.empty() ? "" : ", ") + sensor.name;
    ++count;
    if (options.name.empty() || options.name == sensor.name) found = &sensor;
  }
  if (!options.name.empty() && count == 0)
    throw WrongUsage(options.scene + ": --name " + options.name +
                     ": the scene has no goniometer; without --name it gets one");
  if (!options.name.empty() && !found)
    throw WrongUsage(options.scene + ": --name " + options.name + ": the scene's goniometers are " + names);
  if (options.name.empty() && count > 1)
    throw WrongUsage(options.scene + ": has " + std::to_string(count) + " goniometers; choose one with --name: " +
                     names);
  if (found && !options.grid_option.empty())
    throw WrongUsage(options.scene + ": " + options.grid_option +
                     " is for scenes without a goniometer; this one has its own, " + found->name +
                     ", whose angles and symmetry stand in the file: change them there");
  return found;
}

SensorEntry add_own_goniometer(ups_scene* scene, const ups_goniometer_desc& grid) {
  SensorEntry entry;
  entry.name = "goniometer";
  entry.info.kind = SensorKind::goniometer;
  entry.info.columns = grid.c_count;
  entry.info.rows = grid.gamma_count;
  check(ups_scene_add_goniometer(scene, &grid, &entry.info.sensor));
  return entry;
}

// Scene files state no opening.
void state_opening(ups_scene* scene, ups_sensor_id goniometer, const ups_goniometer_desc& stated) {
  ups_goniometer_desc desc;
  ups_goniometer_desc_init(&desc, sizeof desc);
  check(ups_scene_get_goniometer(scene, goniometer, &desc));
  desc.opening_shape = stated.opening_shape;
  std::copy(std::begin(stated.opening_m), std::end(stated.opening_m), desc.opening_m);
  check(ups_scene_set_goniometer(scene, goniometer, &desc));
}

// The scene with one goniometer and no other sensor.
LoadedScene load(const GoniometerOptions& options) {
  LoadedScene scene = import_scene(options.scene, {options.threads, 0, 0, options.allow_outside});
  const SensorEntry* own = find_goniometer(scene, options);
  const SensorEntry chosen = own ? *own : add_own_goniometer(scene.owned.get(), options.grid);
  if (own) state_opening(scene.owned.get(), chosen.info.sensor, options.grid);
  for (const SensorEntry& sensor : scene.sensors)
    if (sensor.info.sensor.v != chosen.info.sensor.v)
      check(ups_scene_remove_sensor(scene.owned.get(), sensor.info.sensor));
  scene.sensors = {chosen};
  double maintenance = 1;
  check(ups_scene_get_maintenance_factor(scene.owned.get(), &maintenance));
  if (maintenance != 1) {  // of an installation: a photometric file holds what a luminaire gives when it is new
    check(ups_scene_set_maintenance_factor(scene.owned.get(), 1));
    put_warning(format("the scene's maintenance factor of %g is left out of what is measured", maintenance));
  }
  commit_scene(scene, options.scene);
  ups_scene_info info{};
  info.struct_size = sizeof info;
  check(ups_scene_get_info(scene.scene, &info));
  if (!(info.emitted_flux_lm > 0))
    throw Failure(options.scene +
                  ": nothing in it emits light; add a fixture, a luminaire, a light or an emitting material");
  return scene;
}

void check_light(const GoniometerOptions& options, const ups_goniometer_info& info) {
  if (info.flux_lm <= 0)
    throw Failure(options.scene +
                  ": no light leaves the scene, so there is none to measure; put the fixture alone into it");
  if (info.flux_lm <= info.outside_flux_lm)
    throw Failure(options.scene + ": all light leaves the scene beyond the goniometer's range of gamma");
}

Written write_files(const GoniometerOptions& options, const SensorEntry& goniometer, const ups_result* result,
                    const ups_profile* profile, const ProfileReport& report) {
  Written written;
  if (!options.out.empty())
    attempt(written, options.out, [&](const std::string& path) {
      const WrittenProfile made = make_profile(path, profile);
      extras::write_file(path, made.bytes.data(), made.bytes.size());
      for (const std::string& lack : made.lacks) put_warning(path + ": " + lack);
    });
  if (!options.errors.empty())
    attempt(written, options.errors, [&](const std::string& path) { write_goniometer_csv(path, goniometer, result); });
  for (const std::string& plot : options.plots)
    attempt(written, plot, [&](const std::string& path) { write_plot(path, profile, report); });
  return written;
}

}  // namespace

int goniometer(const GoniometerOptions& options) {
  install_interrupt_handler();
  const std::vector<Output> outputs = outputs_of(options);
  for (const auto& [option, path] : outputs) prepare_file(option, path);
  const LoadedScene scene = load(options);
  spare_inputs(options.scene, outputs);
  const Finished finished = run_render(scene.scene, options.desc);
  tell_interruption(finished);
  if (!finished.result) return finished.exit_code();
  const ups_result* result = finished.result.get();
  const SensorEntry& sensor = scene.sensors[0];
  Report render = make_report(options.scene, scene, result);
  check_light(options, render.goniometers[0].info);
  // A file of photometry has a line of UTF-8 for it.
  Profile profile = make_profile(result, sensor, render, one_line(platform::stem_of(options.scene)));
  for (const auto& [name, value] : options.keywords) profile = with_keyword(profile, name, value);
  const Measurement measurement =
      measure(options.out.empty() ? options.scene : options.out, sensor, result, profile.get(), std::move(render));
  const Written written = write_files(options, sensor, result, profile.get(), measurement.profile);
  put(stdout, options.json ? to_json(measurement) : to_text(measurement));
  for (const std::string& error : written.errors) put_error(error);
  return written.errors.empty() ? finished.exit_code() : exit_failed;
}

}  // namespace ups::tool
