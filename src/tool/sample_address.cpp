// See sample_address.h.
#include "tool/sample_address.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "tool/commands.h"

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

struct Address {
  std::string name, index;  // what these may be depends on the scene
  uint32_t iteration;
  ups_walk walk;
  uint32_t path;
  uint64_t seed;
};

// Returns what is wrong; nothing: `out` is complete. From the right, as a name may have slashes.
std::string parse_address(const std::string& address, Address& out) {
  std::array<std::string, 6> parts;
  size_t end = address.size();
  for (size_t i = parts.size(); i-- > 1;) {
    const size_t slash = end == 0 ? std::string::npos : address.rfind('/', end - 1);
    if (slash == std::string::npos) return form;
    parts[i] = address.substr(slash + 1, end - slash - 1);
    end = slash;
  }
  const auto wrong = [](const std::string& part, const char* what) { return "'" + part + "' is " + what + "; " + form; };
  out.name = address.substr(0, end), out.index = parts[1];
  if (!parse(parts[2], out.iteration)) return wrong(parts[2], "no iteration");
  const bool light = parts[3] == walk_words[UPS_WALK_LIGHT];
  if (!light && parts[3] != walk_words[UPS_WALK_EYE]) return wrong(parts[3], "neither eye nor light");
  out.walk = light ? UPS_WALK_LIGHT : UPS_WALK_EYE;
  if (!parse(parts[4], out.path)) return wrong(parts[4], "no path's number");
  if (!parse(parts[5], out.seed)) return wrong(parts[5], "no seed");
  return {};
}

bool parse_index(const SensorEntry& sensor, const std::string& text, uint32_t& index) {
  if (sensor.info.kind != SensorKind::camera)
    return parse(text, index) && (sensor.info.kind != SensorKind::meters || index < sensor.info.meter_count);
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

std::string malformed_address(const std::string& address) {
  Address unused;
  return parse_address(address, unused);
}

ups_sample sample_at(const LoadedScene& scene, const std::string& address) {
  const auto fail = [&](const std::string& what) { throw WrongUsage("--sample " + address + ": " + what); };
  Address a;
  if (const std::string wrong = parse_address(address, a); !wrong.empty()) fail(wrong);
  std::string names;
  const SensorEntry* sensor = nullptr;
  for (const SensorEntry& entry : scene.sensors) {
    if (entry.info.kind == SensorKind::goniometer) continue;
    names += (names.empty() ? "" : ", ") + entry.name;
    if (entry.name == a.name) sensor = &entry;
  }
  if (!sensor) fail("the scene has no camera or meters '" + a.name + "'; there are: " + names + "; " + form);
  ups_sample s{};
  s.sensor = sensor->info.sensor;
  if (!parse_index(*sensor, a.index, s.index)) fail("'" + a.index + "' is no index of " + sensor->name + "; " + form);
  s.iteration = a.iteration, s.walk = a.walk, s.path = a.path, s.seed = a.seed;
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
