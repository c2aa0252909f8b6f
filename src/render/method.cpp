// See method.h: techniques of each method, UPS_METHOD_AUTO's choice, and the words of both.
#include "render/method.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "render/coverage.h"
#include "scene/snapshot.h"
#include "transport/integrator.h"
#include "ups/ups_scene.h"

namespace ups {

namespace {

constexpr uint32_t hit = UPS_TECHNIQUE_EMITTER_HIT, light_sample = UPS_TECHNIQUE_LIGHT_SAMPLE,
                   connect = UPS_TECHNIQUE_CONNECT, sensor_connect = UPS_TECHNIQUE_SENSOR_CONNECT,
                   merge = UPS_TECHNIQUE_MERGE, sensor_hit = UPS_TECHNIQUE_SENSOR_HIT,
                   mirror_sample = UPS_TECHNIQUE_MIRROR_SAMPLE;

// Without a caster that is sharp, and where eye paths reach all light, photons add nothing that eye paths lack.
int32_t automatic(const Snapshot& scene, const Sensors& s) {
  if (s.goniometers) return s.cameras || s.points || s.cells ? UPS_METHOD_UPS : UPS_METHOD_LIGHT_TRACING;
  const SceneEffects& e = scene.effects;
  return e.path_tracing_complete && !e.sharp_caster && e.concentration < concentrated ? UPS_METHOD_PATH_TRACING
                                                                                      : UPS_METHOD_UPS;
}

bool images_suffice(const SceneEffects& e, const Sensors& s) {
  return e.images_suffice && e.concentration < concentrated && !s.goniometers;
}

// Why a technique is off. on: those that are not; allowed: those that the caller left, where the caller named any.
std::string why_off(const Snapshot& scene, const Sensors& s, uint32_t technique, uint32_t on, bool was_automatic,
                    uint32_t allowed) {
  const SceneEffects& e = scene.effects;
  if (!(allowed & technique)) return "not in the set (the techniques asked for leave it out)";
  if (!was_automatic) return "not in the set (the method asked for leaves it out)";
  if (!s.cameras && !s.points && !s.cells) return "not in the set: a goniometer counts what light paths carry out";
  if (technique & (hit | light_sample | mirror_sample)) return "not in the set";
  const std::string cost = "light paths would cost more than they bring";
  if (!e.path_tracing_complete || (on & (connect | sensor_connect | merge | sensor_hit))) return "for this " + cost;
  return std::string(technique == merge ? "no photon index and no merging: " : "") +
         (!e.sharp_caster ? "no surface is specular or nearly so: eye paths find all light, "
          : scene.flat_mirrors.complete ? "eye paths find all light, lights' images in flat mirrors too: "
                                        : "eye paths find all light: ") +
         cost;
}

std::string words(const Snapshot& scene, uint32_t t, const Sensors& s, bool was_automatic, uint32_t allowed) {
  std::string text;
  const auto describe = [&](uint32_t bit, const char* name, const std::string& on, const char* off = nullptr) {
    const std::string why = off ? off : why_off(scene, s, bit, t, was_automatic, allowed);
    text += std::string(name) + (t & bit ? ": on, " + on : ": off, " + why) + "\n";
  };
  describe(hit, "emitter_hit", "eye paths that run into an emitter");
  describe(light_sample, "light_sample", "next-event estimation at each diffuse or glossy vertex");
  if (!scene.flat_mirrors.empty())
    describe(mirror_sample, "mirror_sample",
             "next-event estimation by way of flat mirrors and panes, in which lights have images");
  describe(connect, "connect", "eye and light subpaths are joined by an edge");
  describe(sensor_connect, "sensor_connect", "light paths are joined to the camera",
           s.cameras ? nullptr : "the scene has no camera: no light image");
  describe(merge, "merge",
           scene.effects.ray_emitters ? "the light of a ray file is carried by light paths alone"
           : !scene.effects.path_tracing_complete
               ? "some light reaches diffuse surfaces through specular ones alone: only photons carry it"
           : !scene.effects.sharp_caster && scene.effects.concentration >= concentrated
               ? "light first meets patches of the surfaces that are so small that eye paths find them by chance alone"
               : "caustics: photons are merged at diffuse vertices and meters");
  describe(sensor_hit, "sensor_hit",
           s.goniometers
               ? "light paths are counted where they leave the scene for a goniometer, or land on a meter's cell"
               : "light paths are counted where they land on a meter's cell",
           s.cells || s.goniometers ? nullptr : "no meter measures a cell");
  return text + not_sampleable(scene);
}

}  // namespace

TransportSettings settings_of(const ups_render_desc& d, const MethodChoice& m) {
  TransportSettings s;
  s.method = *method_of(m.method);
  s.techniques = m.techniques;
  s.automatic = m.selects;
  s.prefers_eye_paths = m.selects && m.method == UPS_METHOD_PATH_TRACING;
  if (s.prefers_eye_paths) {
    s.method = *method_of(UPS_METHOD_UPS);
    s.techniques = m.possible & ~merge;
  }
  if (s.method.passes_glossy) s.glossy_alpha = d.glossy_alpha > 0 ? d.glossy_alpha : default_glossy_alpha;
  s.actual_perturbation = d.perturbation == UPS_PERTURBATION_ACTUAL;
  s.technique_edges = d.technique_images;
  if (d.radius_alpha > 0) s.radius_alpha = d.radius_alpha;
  s.separation = d.separation;
  s.seed = d.seed;
  s.max_path_length = d.max_path_length;
  s.light_paths = d.light_paths_per_iteration;
  s.merge_radius = d.merge_radius_m;
  return s;
}

MethodChoice choose_method(const Snapshot& scene, const ups_render_desc& desc) {
  MethodChoice choice;
  const Sensors s = sensors_of(scene);
  const bool is_automatic = desc.method == UPS_METHOD_AUTO;
  choice.method = is_automatic ? automatic(scene, s) : desc.method;
  const Method* method = method_of(choice.method);
  if (!method)
    throw Error(UPS_ERROR_INVALID_ARGUMENT,
                "method: " + std::to_string(choice.method) + " is not a UPS_METHOD_* value");
  choice.possible = (s.cameras ? ~0u : ~sensor_connect) & (s.cells || s.goniometers ? ~0u : ~sensor_hit) &
                    (scene.flat_mirrors.empty() || desc.perturbation == UPS_PERTURBATION_ACTUAL ? ~mirror_sample : ~0u);
  choice.techniques = method->techniques & choice.possible;
  if (method->eye_end == Method::EyeEnd::first_surface && !s.points && !s.illuminance_cameras)
    choice.techniques &= ~connect;
  if (desc.techniques) choice.techniques &= desc.techniques;
  if (!(choice.techniques & light_sample)) choice.techniques &= ~mirror_sample;
  if (choice.techniques == 0 && (s.cameras || s.points || s.cells || s.goniometers))
    throw Error(UPS_ERROR_INVALID_ARGUMENT,
                "techniques: none of the method's techniques is allowed; 0 allows them all");
  choice.possible &= method_of(UPS_METHOD_UPS)->techniques;
  choice.selects = is_automatic && !desc.techniques && !desc.technique_images && !s.goniometers &&
                   !scene.effects.ray_emitters && desc.perturbation == UPS_PERTURBATION_VIRTUAL &&
                   scene.emitters.flux_lm() > 0 && (s.cameras || s.points || s.cells);
  if (choice.selects && choice.method == UPS_METHOD_UPS && images_suffice(scene.effects, s)) {
    choice.method = UPS_METHOD_PATH_TRACING;
    choice.techniques &= hit | light_sample | mirror_sample;
  }
  choice.text = words(scene, choice.techniques, s, is_automatic, desc.techniques ? desc.techniques : ~0u);
  choice.warnings = missing_light(scene, settings_of(desc, choice));
  return choice;
}

void tell_selection(const Integrator& integrator, MethodChoice& method) {
  const Selection& chosen = integrator.selection();
  if (chosen.shares.empty()) return;
  const Snapshot& scene = integrator.scene();
  method.techniques = integrator.settings().techniques;
  const bool light = integrator.settings().traces_light();
  const bool as_path_tracing = !light && !(method.techniques & mirror_sample);
  method.method = as_path_tracing ? UPS_METHOD_PATH_TRACING : UPS_METHOD_UPS;
  method.text = words(scene, method.techniques, sensors_of(scene), true, ~0u);
  method.text += light ? "light paths: " + std::to_string(chosen.light_paths) + " an iteration" +
                             (integrator.plan().traces_caustics_alone()
                                  ? ", for what mirrors, glass and gloss focus alone: all other light is found from the "
                                    "sensors\n"
                                  : "\n")
                       : "light paths: none: all light is found from the sensors\n";
  for (size_t i = 0; i < chosen.sensors.size(); ++i) {
    const ups_sensor_choice& sensor = chosen.sensors[i];
    const bool camera = i < scene.cameras.size();
    const auto uses = [&](uint32_t t) { return (sensor.techniques & t) != 0; };
    constexpr const char* photons[] = {"", ", caustic photons", ", photons"};  // UPS_PHOTONS_*
    constexpr double large = 99;  // beyond, short trials tell no more than that
    const std::string gain = std::string("predicted: ") + (sensor.predicted_gain > large ? "over " : "") +
                             short_number(std::min(sensor.predicted_gain, large), 2) +
                             " times as fast as all techniques";
    method.text += (camera ? "camera " + std::to_string(scene.camera_ids[i])
                           : "meters " + std::to_string(scene.meter_set_ids[i - scene.cameras.size()])) +
                   ": eye paths" + (uses(connect) ? ", connections" : "") + (uses(sensor_connect) ? ", splats" : "") +
                   (uses(sensor_hit) ? ", landings" : "") + photons[sensor.photons] + "; " + gain + "\n";
  }
}

}  // namespace ups
