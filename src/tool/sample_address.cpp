// See sample_address.h.
#include "tool/sample_address.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace ups::tool {

namespace {

constexpr size_t listed_samples = 16;
constexpr const char* walk_words[] = {"eye", "light"};  // UPS_WALK_*
constexpr const char* form =
    "an address is NAME/INDEX/ITERATION/eye/PATH/SEED or NAME/INDEX/ITERATION/light/PATH/SEED, of a camera with "
    "COLUMN,ROW for INDEX, as `ups render --json` lists them in largest_samples";

template <class Number>
bool parse(const std::string& text, Number& out) {
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, out);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

// From the right, as a name may have slashes.
std::array<std::string, 6> split(const std::string& address) {
  std::array<std::string, 6> parts;
  size_t end = address.size();
  for (size_t i = parts.size(); i-- > 1;) {
    const size_t slash = end == 0 ? std::string::npos : address.rfind('/', end - 1);
    if (slash == std::string::npos) throw Failure("--sample " + address + ": " + form);
    parts[i] = address.substr(slash + 1, end - slash - 1);
    end = slash;
  }
  parts[0] = address.substr(0, end);
  return parts;
}

bool parse_index(const SensorEntry& sensor, const std::string& text, uint32_t& index) {
  if (sensor.info.kind != SensorKind::camera) return parse(text, index);
  const size_t comma = text.find(',');
  uint32_t column, row;
  if (comma == std::string::npos || !parse(text.substr(0, comma), column) || !parse(text.substr(comma + 1), row) ||
      column >= sensor.info.width || row >= sensor.info.height)
    return false;
  index = row * sensor.info.width + column;
  return true;
}

}  // namespace

std::string address_of(const SensorEntry& sensor, const ups_sample& s) {
  const uint32_t width = sensor.info.width;
  const std::string index = sensor.info.kind == SensorKind::camera
                                ? std::to_string(s.index % width) + "," + std::to_string(s.index / width)
                                : std::to_string(s.index);
  return sensor.name + "/" + index + "/" + std::to_string(s.iteration) + "/" + walk_words[s.walk] + "/" +
         std::to_string(s.path) + "/" + std::to_string(s.seed);
}

ups_sample sample_at(const LoadedScene& scene, const std::string& address) {
  const std::array<std::string, 6> parts = split(address);
  ups_sample s{};
  std::string names;
  const SensorEntry* sensor = nullptr;
  for (const SensorEntry& entry : scene.sensors) {
    if (entry.info.kind == SensorKind::goniometer) continue;
    names += (names.empty() ? "" : ", ") + entry.name;
    if (entry.name == parts[0]) sensor = &entry;
  }
  const auto fail = [&](const std::string& what) { throw Failure("--sample " + address + ": " + what + "; " + form); };
  if (!sensor) fail("the scene has no camera or meters '" + parts[0] + "'; there are: " + names);
  s.sensor = sensor->info.sensor;
  if (!parse_index(*sensor, parts[1], s.index)) fail("'" + parts[1] + "' is no index of " + sensor->name);
  if (!parse(parts[2], s.iteration)) fail("'" + parts[2] + "' is no iteration");
  if (parts[3] != walk_words[UPS_WALK_EYE] && parts[3] != walk_words[UPS_WALK_LIGHT])
    fail("'" + parts[3] + "' is neither eye nor light");
  s.walk = parts[3] == walk_words[UPS_WALK_LIGHT] ? UPS_WALK_LIGHT : UPS_WALK_EYE;
  if (!parse(parts[4], s.path)) fail("'" + parts[4] + "' is no path's number");
  if (!parse(parts[5], s.seed)) fail("'" + parts[5] + "' is no seed");
  return s;
}

std::vector<SampleReport> read_largest_samples(const LoadedScene& scene, const ups_result* result) {
  std::vector<SampleReport> all;
  for (const SensorEntry& sensor : scene.sensors) {
    if (sensor.info.kind == SensorKind::goniometer) continue;
    const auto read = [&](ups_sample* to, size_t capacity, size_t* needed) {
      return ups_result_read_largest_samples(result, sensor.info.sensor, to, capacity, needed);
    };
    for (const ups_sample& s : read_array<ups_sample>(read)) all.push_back({sensor.name, address_of(sensor, s), s});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const SampleReport& a, const SampleReport& b) { return a.sample.share > b.sample.share; });
  if (all.size() > listed_samples) all.resize(listed_samples);
  return all;
}

}  // namespace ups::tool
