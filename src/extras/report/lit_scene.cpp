// See lit_scene.h: what the core tells of a sensor by its id.
#include "report/lit_scene.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "report/map_data.h"
#include "report/meter_places.h"

namespace ups::report {
namespace {

// Ids number the sensors of a scene in their low bits.
constexpr uint32_t number_bits = 0xffffff;

// The description of a sensor, where it is of that kind.
template <class Desc>
bool read(const ups_scene* scene, ups_sensor_id id, void (*init)(Desc*, uint32_t),
          ups_status (*get)(const ups_scene*, ups_sensor_id, Desc*), Desc& desc) {
  init(&desc, sizeof desc);
  const ups_status status = get(scene, id, &desc);
  if (status == UPS_ERROR_OUT_OF_MEMORY) check(status);
  return status == UPS_OK;
}

bool read_camera(const ups_scene* scene, SensorInfo& info) {
  ups_camera_desc camera;
  if (!read(scene, info.sensor, ups_camera_desc_init, ups_scene_get_camera, camera)) return false;
  info.kind = SensorKind::camera;
  info.width = camera.width, info.height = camera.height;
  info.illuminance = camera.illuminance == 1;
  info.projection = camera.projection;
  info.layers = camera.layers;
  return true;
}

bool read_lightmap(const ups_scene* scene, SensorInfo& info) {
  ups_lightmap_desc map;
  if (!read(scene, info.sensor, ups_lightmap_desc_init, ups_scene_get_lightmap, map)) return false;
  info.layout = MeterLayout::lightmap;
  info.width = map.width, info.height = map.height;
  info.meter_count = map.width * map.height;
  return true;
}

bool read_surface(const ups_scene* scene, SensorInfo& info) {
  ups_surface_meters_desc surface;
  if (!read(scene, info.sensor, ups_surface_meters_desc_init, ups_scene_get_surface_meters, surface)) return false;
  info.layout = MeterLayout::surface;
  size_t count = 0;
  check(ups_scene_read_meter_places(scene, info.sensor, nullptr, 0, &count));
  info.meter_count = uint32_t(count);
  return true;
}

bool read_points(const ups_scene* scene, SensorInfo& info) {
  ups_meter_desc meters;
  if (!read(scene, info.sensor, ups_meter_desc_init, ups_scene_get_meters, meters)) return false;
  info.meter_kind = meters.kind;
  info.meter_count = meters.count;
  info.columns = columns_of(meters.positions_m, meters.count);
  if (info.columns == 0) return true;
  info.rows = meters.count / info.columns;
  return true;
}

bool read_observer(const ups_scene* scene, SensorInfo& info) {
  ups_observer_desc observer;
  if (!read(scene, info.sensor, ups_observer_desc_init, ups_scene_get_observer, observer)) return false;
  info.kind = SensorKind::observer;
  return true;
}

bool read_goniometer(const ups_scene* scene, SensorInfo& info) {
  ups_goniometer_desc goniometer;
  if (!read(scene, info.sensor, ups_goniometer_desc_init, ups_scene_get_goniometer, goniometer)) return false;
  info.kind = SensorKind::goniometer;
  info.columns = goniometer.c_count, info.rows = goniometer.gamma_count;
  return true;
}

const char* word_of(SensorKind kind) {
  constexpr const char* words[] = {"camera ", "meters ", "goniometer ", "observer "};
  return words[int(kind)];
}

}  // namespace

SensorEntry sensor_entry(const ups_scene* scene, ups_sensor_id sensor, const std::string& name) {
  SensorEntry entry{{}, name};
  entry.info.sensor = sensor;
  const std::string number = std::to_string(sensor.v & number_bits);
  bool found = false;
  for (const auto read_kind : {read_points, read_camera, read_observer, read_surface, read_lightmap, read_goniometer})
    if ((found = read_kind(scene, entry.info))) break;
  if (!found) throw Failure("sensor id " + number + " is not a sensor of the scene");
  if (name.empty()) entry.name = word_of(entry.info.kind) + number;
  return entry;
}

Eye eye_of(const LitScene& scene, const SensorEntry& observer) {
  ups_observer_desc desc;
  ups_observer_desc_init(&desc, sizeof desc);
  check(ups_scene_get_observer(scene.scene, observer.info.sensor, &desc));
  const double* m = desc.to_world;
  const double length = std::sqrt(m[2] * m[2] + m[6] * m[6] + m[10] * m[10]);
  return {{m[3], m[7], m[11]}, {-m[2] / length, -m[6] / length, -m[10] / length}};
}

std::string source_name(const LitScene& scene, ups_source_kind kind, uint32_t id) {
  return kind == UPS_SOURCE_GROUP ? "group_" + std::to_string(id) : scene.source_words(kind, id).name;
}

ups_scene_info info_of(const LitScene& scene) {
  auto info = sized<ups_scene_info>();
  check(ups_scene_get_info(scene.scene, &info));
  return info;
}

namespace {

struct Noun {
  std::string_view one, many;
};
constexpr Noun nouns[] = {{"material", "materials"}, {"mesh", "meshes"}, {"instance", "instances"},
                          {"luminaire", "luminaires"}, {"fixture", "fixtures"}};

bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

// A number that stands alone at `at`, which moves beyond it.
std::optional<uint32_t> whole_number(std::string_view text, size_t& at) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
  const size_t next = size_t(end - text.data());
  if (error != std::errc() || (next < text.size() && is_letter_or_digit(text[next])) ||
      (next + 1 < text.size() && text[next] == '.' && is_letter_or_digit(text[next + 1])))
    return {};
  at = next;
  return number;
}

// "material 3", "instances 1, 2 and 5 more" at `at`, which moves beyond what it has words for; none: nothing of that kind.
std::string words_at(const LitScene& scene, std::string_view line, size_t& at) {
  for (const Noun& noun : nouns)
    for (const std::string_view word : {noun.many, noun.one}) {
      if (line.substr(at, word.size()) != word) continue;
      size_t end = at + word.size();
      if (line.substr(end, 3) == " id") end += 3;
      if (line.substr(end, 1) != " ") continue;
      std::string words;
      std::string_view before;
      for (size_t next = end + 1;;) {
        const std::optional<uint32_t> number = whole_number(line, next);
        if (!number || line.substr(next, 5) == " more") break;
        const std::string part = scene.part_words(noun.one, *number);
        if (part.empty()) return {};
        (words += before) += part;
        end = next;
        before = line.substr(end, 2) == ", " ? ", " : line.substr(end, 5) == " and " ? " and " : "";
        if (before.empty()) break;
        next = end + before.size();
      }
      if (!words.empty()) at = end;
      return words;
    }
  return {};
}

std::string with_part_words(const LitScene& scene, std::string_view line) {
  std::string out;
  for (size_t at = 0; at < line.size();) {
    const bool starts = at == 0 || !is_letter_or_digit(line[at - 1]);
    const std::string words = starts ? words_at(scene, line, at) : std::string();
    words.empty() ? out += line[at++] : out += words;
  }
  return out;
}

}  // namespace

// The library knows sensors and parts of a scene by their numbers, and tells programmers what to call.
std::string for_people(const LitScene& scene, std::string line) {
  if (scene.part_words) line = with_part_words(scene, line);
  if (const size_t call = line.find("; see ups_"); call != std::string::npos) line.erase(call);
  for (const SensorEntry& sensor : scene.sensors) {
    const bool observer = sensor.info.kind == SensorKind::observer;  // to the library, also meters at an eye
    const std::string kind = observer                                     ? "observer "
                             : sensor.info.kind == SensorKind::meters     ? "meters "
                             : sensor.info.kind == SensorKind::goniometer ? "goniometer "
                                                                          : "camera ";
    for (const std::string& told : {kind, std::string(observer ? "meters " : kind)}) {
      const std::string number = told + std::to_string(sensor.info.sensor.v & number_bits);
      if (line.compare(0, number.size(), number) == 0 && line.find_first_of(":,", number.size()) == number.size())
        return line.replace(0, number.size(), kind + sensor.name);
    }
  }
  return line;
}

}  // namespace ups::report
