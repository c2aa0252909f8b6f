// Which light can a set of techniques not sample? By patterns of paths, as in Heckbert's notation: what is between the
// emitter and the sensor, each vertex specular (S), glossy (G) or diffuse (D). Asked by render/method.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/snapshot.h"
#include "transport/plan.h"

namespace ups {

enum class SensorKind { camera, point_meter, cell };
// hittable: eye paths can run into it; punctual: next-event estimation finds it, eye paths do not; rays: neither does.
enum class SourceKind { hittable, punctual, rays };
SourceKind source_kind(const Emitter& emitter);

// Which kinds a scene has.
struct Sensors {
  bool cameras, illuminance_cameras, points, cells, goniometers;
};
Sensors sensors_of(const Snapshot& scene);

// vertices: "SD" is emitter - specular - diffuse - sensor. G is a surface that TransportSettings::glossy_alpha passes,
// D any other continuous one.
bool can_sample(std::string_view vertices, SourceKind source, SensorKind sensor, const TransportSettings& settings);
// Such a path carries light at all: a pinhole sees no source without extent, not even in a mirror.
bool is_measurable(std::string_view vertices, SourceKind source, SensorKind sensor);

// First light on so small patches is what eye paths miss for long, with errors that know nothing of it: from an even
// illuminance of a room (about 2) to a pendant below a ceiling (tens) they find it.
inline constexpr float concentrated = 64;

// A line for each kind of light of the scene that the set cannot sample, the shortest paths of it: which emitters, by
// way of which surfaces.
std::vector<std::string> missing_light(const Snapshot& scene, const TransportSettings& settings);

// What no set can: a line on the sources of the scene that none of its cameras shows (not is_measurable); or nothing.
std::string not_sampleable(const Snapshot& scene);

}  // namespace ups
