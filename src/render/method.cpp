#include "render/method.h"

#include "base/error.h"
#include "scene/snapshot.h"
#include "ups/ups_render.h"
#include "ups/ups_scene.h"

namespace ups {

namespace {

constexpr uint32_t hit = UPS_TECHNIQUE_EMITTER_HIT, light_sample = UPS_TECHNIQUE_LIGHT_SAMPLE, connect = UPS_TECHNIQUE_CONNECT,
                   sensor_connect = UPS_TECHNIQUE_SENSOR_CONNECT, merge = UPS_TECHNIQUE_MERGE, sensor_hit = UPS_TECHNIQUE_SENSOR_HIT;

uint32_t techniques_of(int32_t method) {
  switch (method) {
    case UPS_METHOD_UPS: return hit | light_sample | connect | sensor_connect | merge | sensor_hit;
    case UPS_METHOD_PATH_TRACING: return hit | light_sample;
    case UPS_METHOD_LIGHT_TRACING: return sensor_connect | sensor_hit;
    case UPS_METHOD_BIDIRECTIONAL: return hit | light_sample | connect | sensor_connect;
    case UPS_METHOD_PPM:
    case UPS_METHOD_SPPM:
    case UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING: return hit | merge | sensor_hit;
    default: throw Error(UPS_ERROR_INVALID_ARGUMENT, "method: " + std::to_string(method) + " is not a UPS_METHOD_* value");
  }
}

struct Sensors {
  bool cameras, points, cells;
};
Sensors sensors_of(const Snapshot& scene) {
  Sensors s{!scene.cameras.empty(), false, false};
  for (const MeterSet& m : scene.meter_sets) (m.is_cell() ? s.cells : s.points) = true;
  return s;
}

// Without a caster that is sharp, and where eye paths reach all light, photons add nothing that eye paths lack.
int32_t automatic(const Snapshot& scene) {
  return scene.effects.path_tracing_complete && !scene.effects.sharp_caster ? UPS_METHOD_PATH_TRACING : UPS_METHOD_UPS;
}

void describe(std::string& text, uint32_t techniques, uint32_t bit, const char* name, const std::string& on, const std::string& off) {
  text += std::string(name) + ((techniques & bit) ? ": on, " + on : ": off, " + off) + "\n";
}

std::string words(const Snapshot& scene, uint32_t t, const Sensors& s, bool was_automatic) {
  const std::string chosen = was_automatic ? "" : " (the method asked for leaves it out)";
  std::string text;
  describe(text, t, hit, "emitter_hit", "eye paths that run into an emitter", "not in the set" + chosen);
  describe(text, t, light_sample, "light_sample", "next-event estimation at each diffuse or glossy vertex", "not in the set" + chosen);
  const std::string diffuse = "no surface is specular or nearly so: eye paths find all light, light paths would cost more than they bring";
  describe(text, t, connect, "connect", "eye and light subpaths are joined by an edge", was_automatic ? diffuse : "not in the set" + chosen);
  describe(text, t, sensor_connect, "sensor_connect", "light paths are joined to the camera",
           !s.cameras ? "the scene has no camera: no light image" : was_automatic ? diffuse : "not in the set" + chosen);
  describe(text, t, merge, "merge",
           scene.effects.path_tracing_complete ? "caustics: photons are merged at diffuse vertices and meters"
                                               : "some light reaches diffuse surfaces through specular ones alone: only photons carry it",
           was_automatic ? "no photon index and no merging: " + diffuse : "not in the set" + chosen);
  describe(text, t, sensor_hit, "sensor_hit", "light paths are counted where they land on a meter's cell",
           !s.cells ? "no meter measures a cell" : was_automatic ? diffuse : "not in the set" + chosen);
  return text;
}

std::vector<std::string> unsampled(const Snapshot& scene, int32_t method, uint32_t t, const Sensors& s) {
  std::vector<std::string> w;
  if (!(t & merge) && !scene.effects.path_tracing_complete && (t & (hit | light_sample)))
    w.push_back("light of sources without extent that reaches a meter or a diffuse surface only through mirrors or glass is missing: "
                "this set of techniques cannot sample it; method ups can");
  if (method == UPS_METHOD_LIGHT_TRACING && s.cameras)
    w.push_back("light tracing cannot reach the camera by way of mirrors and glass: surfaces seen through them are black");
  if (method == UPS_METHOD_LIGHT_TRACING && s.points && scene.effects.sharp_caster)
    w.push_back("light tracing connects diffuse surfaces to point meters: light that comes to them straight from mirrors or glass is "
                "missing; measure cells instead (area meters)");
  return w;
}

}  // namespace

MethodChoice choose_method(const Snapshot& scene, int32_t requested, uint32_t allowed) {
  MethodChoice choice;
  const bool is_automatic = requested == UPS_METHOD_AUTO;
  choice.method = is_automatic ? automatic(scene) : requested;
  choice.techniques = techniques_of(choice.method);
  const Sensors s = sensors_of(scene);
  if (!s.cameras) choice.techniques &= ~sensor_connect;
  if (!s.cells) choice.techniques &= ~sensor_hit;
  if (choice.method == UPS_METHOD_LIGHT_TRACING && s.points) choice.techniques |= connect;  // t = 1 of a point meter
  if (allowed) choice.techniques &= allowed;
  if (choice.techniques == 0 && (s.cameras || s.points || s.cells))
    throw Error(UPS_ERROR_INVALID_ARGUMENT, "techniques: none of the method's techniques is allowed; 0 allows them all");
  choice.text = words(scene, choice.techniques, s, is_automatic);
  choice.warnings = unsampled(scene, choice.method, choice.techniques, s);
  return choice;
}

}  // namespace ups
