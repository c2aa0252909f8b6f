// See descs.h: the page of a scene and its result.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>

#include "platform/files.h"
#include "platform/paths.h"
#include "report/descs.h"

namespace ups::report {
namespace {

using extras::require;

size_t place_of(const LitScene& scene, ups_sensor_id id, SensorKind kind, const std::string& where) {
  for (size_t i = 0; i < scene.sensors.size(); ++i)
    if (scene.sensors[i].info.sensor.v == id.v && scene.sensors[i].info.kind == kind) return i;
  throw Failure(where + (kind == SensorKind::camera ? " is no camera" : " is no set of meters") +
                " among the page's sensors");
}

bool is_in(const ups_scene* scene, ups_source_kind kind, uint32_t id) {
  ups_luminaire_desc luminaire{};
  ups_light_desc light{};
  ups_instance_desc instance{};
  luminaire.struct_size = sizeof luminaire, light.struct_size = sizeof light, instance.struct_size = sizeof instance;
  return kind == UPS_SOURCE_INSTANCE ? ups_scene_get_instance(scene, {id}, &instance) == UPS_OK
                                     : ups_scene_get_luminaire(scene, {id}, &luminaire) == UPS_OK ||
                                           ups_scene_get_light(scene, {id}, &light) == UPS_OK;
}

void take_sources(const ups_report_page_desc& d, LitScene& scene) {
  require_array(d.sources, d.source_count, "sources");
  std::map<std::pair<ups_source_kind, uint32_t>, SourceWords> words;
  for (uint32_t i = 0; i < d.source_count; ++i) {
    const ups_report_source& s = d.sources[i];
    const std::string where = "sources[" + std::to_string(i) + "]";
    if (s.kind != UPS_SOURCE_LUMINAIRE && s.kind != UPS_SOURCE_INSTANCE)
      throw Failure(where + ": kind must be UPS_SOURCE_LUMINAIRE or UPS_SOURCE_INSTANCE");
    if (!is_in(d.scene, s.kind, s.id))
      throw Failure(where + ": the scene has no " + (s.kind == UPS_SOURCE_INSTANCE ? "instance " : "luminaire or light ") +
                    std::to_string(s.id));
    SourceWords named = scene.source_words(s.kind, s.id);
    if (s.name) named.name = s.name;
    named.file = text_of(s.file);
    if (!words.try_emplace({s.kind, s.id}, named).second) throw Failure(where + " is named twice");
  }
  scene.source_words = [words = std::move(words), others = scene.source_words](ups_source_kind kind, uint32_t id) {
    const auto found = words.find({kind, id});
    return found == words.end() ? others(kind, id) : found->second;
  };
}

std::vector<uint8_t> bytes_of(const ups_report_picture& p, const std::string& where) {
  std::vector<uint8_t> bytes;
  if (p.path) {
    if (platform::is_regular_file(p.path)) {
      auto file = platform::open_to_read(p.path);
      bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    if (bytes.empty())
      throw Failure(where + ": cannot read '" + p.path + "': no file, not readable, or empty", UPS_ERROR_IO);
  } else {
    bytes.assign(p.png, p.png + p.png_size);
  }
  // Its signature, the header's chunk first and the end's last (ISO/IEC 15948, 5.2 and 5.6).
  constexpr uint8_t begin[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R'},
                    end[] = {0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
  if (bytes.size() < sizeof begin + sizeof end || std::memcmp(bytes.data(), begin, sizeof begin) != 0 ||
      std::memcmp(bytes.data() + bytes.size() - sizeof end, end, sizeof end) != 0)
    throw Failure(where + ": is no PNG" + (p.path ? std::string(": '") + p.path + "'" : ""), UPS_ERROR_PARSE);
  return bytes;
}

using Pictures = std::map<size_t, std::vector<uint8_t>>;  // by the camera's place among the sensors

Pictures take_pictures(const ups_report_page_desc& d, const LitScene& scene, Report& report) {
  require_array(d.pictures, d.picture_count, "pictures");
  Pictures pictures;
  for (uint32_t i = 0; i < d.picture_count; ++i) {
    const ups_report_picture& p = d.pictures[i];
    const std::string where = "pictures[" + std::to_string(i) + "]";
    if ((p.path != nullptr) == (p.png != nullptr)) throw Failure(where + ": needs path or png, one of the two");
    if (p.reserved != 0) throw Failure(where + ": reserved must be 0");
    if (p.smoothed != 0 && p.smoothed != 1) throw Failure(where + ": smoothed must be 0 or 1");
    if (p.exposure < UPS_REPORT_EXPOSURE_UNTOLD || p.exposure > UPS_REPORT_EXPOSURE_GIVEN)
      throw Failure(where + ": exposure must be one of UPS_REPORT_EXPOSURE_*");
    if (!(std::abs(p.ev100) <= 100)) throw Failure(where + ": ev100 must be within -100 and 100");
    const size_t camera = place_of(scene, p.camera, SensorKind::camera, where);
    if (!pictures.try_emplace(camera, bytes_of(p, where)).second)
      throw Failure(where + ": the camera '" + scene.sensors[camera].name + "' has a picture already");
    for (CameraReport& told : report.cameras)
      if (told.sensor == camera)
        told.picture = {p.ev100, p.exposure == UPS_REPORT_EXPOSURE_GIVEN, p.smoothed == 1,
                        p.exposure != UPS_REPORT_EXPOSURE_UNTOLD};
  }
  return pictures;
}

MeterQuestions questions_of(const ups_report_page_desc& d, const LitScene& scene) {
  require_array(d.thresholds_lx, d.threshold_count, "thresholds_lx");
  require_array(d.ratios, d.ratio_count, "ratios");
  MeterQuestions questions;
  for (uint32_t i = 0; i < d.threshold_count; ++i) {
    if (!(d.thresholds_lx[i] > 0) || !std::isfinite(d.thresholds_lx[i]))
      throw Failure("thresholds_lx[" + std::to_string(i) + "] must be finite and greater than 0");
    questions.above.push_back(d.thresholds_lx[i]);
  }
  for (uint32_t i = 0; i < d.ratio_count; ++i) {
    const std::string where = "ratios[" + std::to_string(i) + "]: ";
    questions.ratios.emplace_back(place_of(scene, d.ratios[i].numerator, SensorKind::meters, where + "numerator"),
                                  place_of(scene, d.ratios[i].denominator, SensorKind::meters, where + "denominator"));
  }
  return questions;
}

std::optional<Targets> targets_of(const ups_report_page_desc& d, const LitScene& scene) {
  if (!d.targets_json) return std::nullopt;
  std::vector<std::string> folders;
  if (d.targets_folder) folders.push_back(d.targets_folder);
  Targets targets = parse_targets(d.targets_json, text_of(d.targets_name, "targets"), folders);
  check_names(targets, scene);
  return targets;
}

}  // namespace

ups_report_page_desc page_defaults() {
  ups_report_page_desc desc{};
  desc.struct_size = sizeof desc;
  return desc;
}

std::string page_of(const ups_report_page_desc& d) {
  require(d.scene != nullptr, "scene is NULL");
  require(d.result != nullptr, "result is NULL");
  require(d.target_relative_error >= 0 && d.target_relative_error <= 1e6,
          "target_relative_error must be from 0, none, to 1,000,000");
  const Style style = style_of(d.style);
  LitScene scene = lit_scene_of(d.scene, d.result, d.sensors, d.sensor_count);
  take_sources(d, scene);
  const std::optional<Targets> targets = targets_of(d, scene);
  Report report = make_report(text_of(d.scene_name), scene, d.result, questions_of(d, scene));
  report.target_error = d.target_relative_error;
  if (targets) take_verdicts(*targets, report);
  const Pictures pictures = take_pictures(d, scene, report);
  const auto picture = [&](size_t sensor) {
    const auto found = pictures.find(sensor);
    return found == pictures.end() ? std::vector<uint8_t>() : found->second;
  };
  return report_page({scene, d.result, report, targets ? &*targets : nullptr, style.map, text_of(d.title, "Lighting"),
                      text_of(d.repeat), text_of(d.date), picture});
}

}  // namespace ups::report
