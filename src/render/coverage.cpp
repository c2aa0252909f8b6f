// See coverage.h: whether one technique can sample one pattern, the patterns that a scene's materials can make, and the
// words for those that are missing.
#include "render/coverage.h"

#include <algorithm>

#include "scene/effects.h"
#include "ups/ups_render.h"

namespace ups {

namespace {

constexpr size_t longest = 3;       // vertices: longer patterns bring no new kind of missing light
constexpr size_t most_patterns = 3;  // of a warning for one kind of emitter and sensor

bool is_specular(char v) { return v == 'S'; }
bool is_continuous(char v) { return v != 'S'; }

using EyeEnd = Method::EyeEnd;

bool can_hit(std::string_view v, SensorKind sensor, const TransportSettings& s) {
  const bool camera = sensor == SensorKind::camera;
  if (s.method.eye_end == EyeEnd::first_surface) return camera && v.empty();
  if (!s.has(UPS_TECHNIQUE_EMITTER_HIT)) return false;
  if (!s.method.hits_after_specular) return true;
  return camera && v.find('D') == std::string_view::npos &&
         (s.method.passes_glossy || v.find('G') == std::string_view::npos);
}

bool can_light_sample(std::string_view v, SensorKind sensor, const TransportSettings& s) {
  if (s.method.eye_end == EyeEnd::first_surface) return sensor == SensorKind::point_meter && v.empty();
  if (!s.has(UPS_TECHNIQUE_LIGHT_SAMPLE)) return false;
  return v.empty() ? sensor != SensorKind::camera : is_continuous(v.front());
}

// A light in a flat mirror.
bool can_mirror_sample(std::string_view v, SourceKind source, SensorKind sensor, const TransportSettings& s) {
  return source != SourceKind::rays && s.has(UPS_TECHNIQUE_MIRROR_SAMPLE) && !v.empty() && is_specular(v[0]) &&
         (v.size() > 1 ? is_continuous(v[1]) : sensor != SensorKind::camera);
}

bool can_connect(std::string_view v, SensorKind sensor, const TransportSettings& s) {
  if (!s.has(UPS_TECHNIQUE_CONNECT) || v.empty()) return false;
  const bool to_meter = sensor != SensorKind::camera && is_continuous(v.back());
  if (s.method.eye_end == EyeEnd::first_surface) return to_meter && sensor == SensorKind::point_meter;
  const auto both = [](char a, char b) { return is_continuous(a) && is_continuous(b); };
  return to_meter || std::adjacent_find(v.begin(), v.end(), both) != v.end();
}

// Whether light straight from such an emitter is left to next-event estimation (mis::Gates).
bool is_gated(SourceKind source, const TransportSettings& s) {
  return source != SourceKind::rays && s.has(UPS_TECHNIQUE_LIGHT_SAMPLE);
}

bool can_splat(std::string_view v, SourceKind source, SensorKind sensor, const TransportSettings& s) {
  if (sensor != SensorKind::camera || !s.has(UPS_TECHNIQUE_SENSOR_CONNECT) || v.empty()) return false;
  const bool gated = v.size() == 1 && is_gated(source, s);
  return is_continuous(v.back()) && !gated;
}

bool can_merge(std::string_view v, SourceKind source, SensorKind sensor, const TransportSettings& s) {
  if (!s.has(UPS_TECHNIQUE_MERGE)) return false;
  const bool gated = is_gated(source, s);  // no photons straight from an emitter
  if (sensor == SensorKind::point_meter && (!v.empty() || !gated)) return true;
  if (s.method.eye_end == EyeEnd::first_merge)
    return sensor == SensorKind::camera && v.find_first_of(s.method.passes_glossy ? "D" : "DG") != std::string_view::npos;
  return std::any_of(v.begin() + (gated && !v.empty()), v.end(), is_continuous);
}

}  // namespace

Sensors sensors_of(const Snapshot& scene) {
  Sensors s{!scene.cameras.empty(), false, false, false, !scene.goniometers.empty()};
  for (const Camera& c : scene.cameras) s.illuminance_cameras |= c.illuminance();
  for (const MeterSet& m : scene.meter_sets) (m.is_cell() ? s.cells : s.points) = true;
  return s;
}

SourceKind source_kind(const Emitter& emitter) {
  return !emitter.is_delta() ? SourceKind::hittable : emitter.is_direct() ? SourceKind::punctual : SourceKind::rays;
}

bool can_sample(std::string_view v, SourceKind source, SensorKind sensor, const TransportSettings& s) {
  return (source == SourceKind::hittable && can_hit(v, sensor, s)) ||
         (source != SourceKind::rays && can_light_sample(v, sensor, s)) || can_mirror_sample(v, source, sensor, s) ||
         can_connect(v, sensor, s) ||
         can_splat(v, source, sensor, s) || can_merge(v, source, sensor, s) ||
         (sensor == SensorKind::cell && s.has(UPS_TECHNIQUE_SENSOR_HIT));
}

bool is_measurable(std::string_view v, SourceKind source, SensorKind sensor) {
  return source == SourceKind::hittable || sensor != SensorKind::camera ||
         !std::all_of(v.begin(), v.end(), is_specular);
}

namespace {

// In order of length.
std::vector<std::string> patterns(const std::string& letters) {
  std::vector<std::string> all = {""};
  for (size_t i = 0; i < all.size(); ++i)
    if (all[i].size() < longest)
      for (char letter : letters) all.push_back(all[i] + letter);
  return all;
}

bool contains(const std::string& longer, const std::string& part) {
  size_t at = 0;
  for (char c : longer) at += at < part.size() && c == part[at];
  return at == part.size();
}

// Straight from one mirror to another.
bool begins_with_two_mirrors(std::string_view v) { return v.size() > 1 && is_specular(v[0]) && is_specular(v[1]); }

// All light of such emitters that flat mirrors reflect straight is that of images.
bool is_shown(SourceKind source, const FlatMirrors& mirrors) {
  return source == SourceKind::punctual || (source == SourceKind::hittable && mirrors.of_all);
}

// The shortest; others that contain one of them are not listed.
std::vector<std::string> missing_patterns(const std::string& letters, SourceKind source, SensorKind sensor,
                                          const TransportSettings& s, const FlatMirrors& mirrors) {
  std::vector<std::string> missing;
  for (const std::string& v : patterns(letters)) {
    if (s.max_path_length && v.size() + 1 > s.max_path_length) continue;  // not asked for
    if (!is_measurable(v, source, sensor) || can_sample(v, source, sensor, s)) continue;
    const bool all_shown = mirrors.complete && is_shown(source, mirrors);
    if (all_shown && begins_with_two_mirrors(v)) continue;  // there are none
    const bool known =
        std::any_of(missing.begin(), missing.end(), [&](const std::string& m) { return !m.empty() && contains(v, m); });
    if (!known && missing.size() < most_patterns) missing.push_back(v);
  }
  return missing;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < std::min<size_t>(names.size(), 3); ++i) text += (i ? ", " : "") + names[i];
  return names.size() > 3 ? text + " and " + std::to_string(names.size() - 3) + " more" : text;
}

// Which surfaces stand behind a letter.
struct Letters {
  std::string available;
  std::string specular, glossy, diffuse;

  Letters(const Snapshot& scene, const TransportSettings& settings) {
    specular = materials_of(scene, [](const Material& m) { return traits_of(m).delta; });
    glossy = materials_of(scene, [&](const Material& m) { return glossy_parts(m, settings.glossy_alpha).glossy; });
    diffuse = materials_of(scene, [&](const Material& m) { return glossy_parts(m, settings.glossy_alpha).other; });
    if (!specular.empty()) available += 'S';
    if (!glossy.empty()) available += 'G';
    if (!diffuse.empty()) available += 'D';
  }
  std::string words(const std::string& vertices) const {
    std::string text = "emitter";
    for (char v : vertices)
      text += v == 'S'   ? " - specular (" + specular + ")"
              : v == 'G' ? " - glossy (" + glossy + ")"
                         : " - diffuse (" + diffuse + ")";
    return text;
  }
};

}  // namespace

std::string not_sampleable(const Snapshot& scene) {
  std::vector<std::string> emitters;
  for (size_t i = 0; i < scene.emitters.size(); ++i)
    if (source_kind(scene.emitters[i]) != SourceKind::hittable) emitters.push_back(scene.emitter_names[i]);
  if (scene.cameras.empty() || emitters.empty()) return {};
  const std::string specular = materials_of(scene, [](const Material& m) { return traits_of(m).delta; });
  return "not_sampleable: sources without extent, or of rays (" + listed(emitters) + "), straight to a camera" +
         (specular.empty() ? "" : " or by way of specular surfaces alone (" + specular + ")") +
         ": pixels show what they light; what has a luminous opening or surface is seen itself\n";
}

std::vector<std::string> missing_light(const Snapshot& scene, const TransportSettings& of_render) {
  const Sensors has = sensors_of(scene);
  TransportSettings settings = of_render;
  std::vector<std::pair<SensorKind, const char*>> sensors;
  if (has.cameras) sensors.emplace_back(SensorKind::camera, "camera");
  if (has.illuminance_cameras) sensors.emplace_back(SensorKind::point_meter, "illuminance camera");
  if (has.points) sensors.emplace_back(SensorKind::point_meter, "point meter");
  if (has.cells) sensors.emplace_back(SensorKind::cell, "area meter");
  const Letters letters(scene, settings);
  constexpr const char* remark[] = {"", " (without extent)", " (rays of a file: light paths alone carry it)"};
  std::vector<std::string> lines;
  for (SourceKind source : {SourceKind::hittable, SourceKind::punctual, SourceKind::rays}) {
    std::vector<std::string> emitters;
    for (size_t i = 0; i < scene.emitters.size(); ++i)
      if (source_kind(scene.emitters[i]) == source) emitters.push_back(scene.emitter_names[i]);
    if (emitters.empty()) continue;
    const bool shown = scene.flat_mirrors.all_flat && is_shown(source, scene.flat_mirrors);
    settings.techniques = of_render.techniques & (shown ? ~0u : ~uint32_t(UPS_TECHNIQUE_MIRROR_SAMPLE));
    for (const auto& [kind, name] : sensors)
      for (const std::string& v : missing_patterns(letters.available, source, kind, settings, scene.flat_mirrors))
        lines.push_back("light of " + listed(emitters) + remark[int(source)] + " on paths " + letters.words(v) + " - " +
                        name + " is missing: no technique of this set samples it; method ups with all of its has one");
  }
  if (!sensors.empty() && scene.effects.concentration >= concentrated && !settings.traces_light())
    lines.push_back(
        "light first meets patches of the surfaces that are so small that eye paths find them by chance alone, and no "
        "technique of this set starts paths from the light: readings may be too low, whatever their bounds say; methods "
        "ups and bpt find it");
  if (has.goniometers && !settings.traces_light())
    lines.push_back(
        "the goniometer measures nothing: this set of techniques traces no light paths; methods lt and ups do");
  return lines;
}

}  // namespace ups
