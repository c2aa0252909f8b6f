// The methods as a table. Nothing else decides what a method does: the walks, the weights, the analysis of missing light
// and the words read these rows.
#pragma once
#include <cstdint>

#include "ups/ups_render.h"

namespace ups {

struct Method {
  int32_t id;            // UPS_METHOD_*
  uint32_t techniques;   // UPS_TECHNIQUE_* that it samples
  // Where its eye walks end: with the path; at the first vertex where photons are merged; at the first surface, of which
  // they only see what it emits, while a meter's own point samples and connects as a light path's vertex would.
  enum class EyeEnd { of_path, first_merge, first_surface } eye_end = EyeEnd::of_path;
  bool hits_after_specular = false;  // emitters are seen directly or through mirrors and glass alone
  bool passes_glossy = false;        // eye walks pass sharp gloss as they pass mirrors
  bool weighted = true;              // balance heuristic; else each path has one technique
};

namespace method_detail {
constexpr uint32_t eye = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE,
                   light = UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_SENSOR_HIT,
                   photons = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT;
}  // namespace method_detail

inline constexpr Method methods[] = {
    {UPS_METHOD_UPS, method_detail::eye | method_detail::light | UPS_TECHNIQUE_CONNECT | UPS_TECHNIQUE_MERGE |
                         UPS_TECHNIQUE_MIRROR_SAMPLE},
    {UPS_METHOD_PATH_TRACING, method_detail::eye},
    // A point's t = 1 are connections.
    {UPS_METHOD_LIGHT_TRACING, method_detail::light | UPS_TECHNIQUE_CONNECT, Method::EyeEnd::first_surface, false,
     false, false},
    {UPS_METHOD_BIDIRECTIONAL, method_detail::eye | UPS_TECHNIQUE_CONNECT | UPS_TECHNIQUE_SENSOR_CONNECT},
    // Hachisuka et al. 2008.
    {UPS_METHOD_PPM, method_detail::photons, Method::EyeEnd::first_merge, true, false, false},
    // Hachisuka, Jensen 2009.
    {UPS_METHOD_SPPM, method_detail::photons, Method::EyeEnd::first_merge, true, true, false},
    // Vorba 2011.
    {UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING, method_detail::photons, Method::EyeEnd::of_path, true},
};

// Null where there is none of that id.
inline const Method* method_of(int32_t id) {
  for (const Method& m : methods)
    if (m.id == id) return &m;
  return nullptr;
}

}  // namespace ups
