// What rendering reads: an immutable build of a scene. Made by scene/prepare, shared by every render that started from
// it. Coordinates are floats relative to `origin`, the centre of the scene,
// so that a building far from zero keeps its precision.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "bsdf/material.h"
#include "emitter/emitter_set.h"
#include "geometry/raytracer.h"
#include "photometry/photometry.h"
#include "photometry/position_index.h"
#include "scene/ids.h"
#include "scene/media.h"
#include "scene/panes.h"
#include "sensor/camera.h"
#include "sensor/goniometer.h"
#include "sensor/meters.h"
#include "ups/ups_render.h"

namespace ups {

inline constexpr float largest_meter_disc = 0.1f;  // radius within which a point meter merges photons, of the scene's

struct SceneEffects {
  uint32_t effects = 0;       // UPS_EFFECT_*
  bool path_tracing_complete = true;  // no emitter without extent beside a mirror-like surface, and no ray emitter
  bool ray_emitters = false;  // some light comes from the rays of a file: light paths alone carry it
  float concentration = 1;    // of first light on small patches, see scene/probe.h
  bool sharp_caster = false;  // some material has a delta lobe or a continuous lobe with alpha < 0.2
  bool transmits_solid = false;
  bool coloured = false;
  std::string text;           // a line per effect, with its cause
};

// A luminaire, light or emissive instance as the program added it; it may emit nothing. Its id is without the tag.
struct Source {
  ups_source_kind kind;
  uint32_t id, group;
  int32_t light_kind = -1;  // UPS_LIGHT_* of a light
  Affine to_world{};
  bool of_fixture = false;
  Vec3d bounds_min, bounds_max;  // world: of the opening that emits, of the surface; without extent its place
  std::shared_ptr<const photometry::Photometry> profile;  // of a luminaire
};

// An eye: it looks along -frame.n, frame.t is up. What it measures is a meter set of one, which faces what it looks at.
struct Observer {
  uint32_t meter_set;
  Frame frame;
  photometry::PositionIndex position_index;
  double ceiling_area;  // m^2; 0: the scene's extent
};

struct Snapshot {
  std::shared_ptr<const SceneTag> tag;  // of the ids that the program has; all below are without it
  Vec3d origin;
  float radius = 0;  // of the bounding sphere of geometry, emitters and sensors about the origin

  std::vector<std::shared_ptr<const Texture>> textures;
  std::vector<Material> materials;              // by SurfacePoint::material
  std::vector<SurfaceTexturing> texturing;      // by the same index
  std::vector<bool> material_used;              // by the same index: some instance bears it
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::unique_ptr<Raytracer> raytracer;         // never null; may hold no triangle
  std::vector<uint32_t> instance_ids;           // by SurfacePoint::instance

  EmitterSet emitters;
  std::vector<std::string> emitter_names;       // "luminaire 3", "instance 7": by their numbers
  std::vector<float> emitter_sizes;             // m; smallest extent of a luminaire's opening, used or not; 0: unknown
  std::vector<Source> sources;                  // all, in the order of their kinds and ids
  std::vector<uint32_t> source_of_emitter;      // index into sources
  std::vector<uint32_t> emitter_of_instance;    // none: does not emit
  std::unique_ptr<DiscIndex> openings;          // null without luminous openings
  std::vector<uint32_t> emitter_of_opening;     // by DiscIndex::Crossing::disc (what surrounds it)

  std::vector<Camera> cameras;
  std::vector<MeterSet> meter_sets;
  std::vector<Goniometer> goniometers;
  std::vector<uint32_t> camera_ids, meter_set_ids, goniometer_ids;  // numbers of each
  std::vector<Observer> observers;
  std::vector<uint32_t> observer_ids;           // those of their meter sets
  std::vector<photometry::Opening> goniometer_openings;  // that their distributions are given

  Panes panes;
  Media media;
  // What free-standing things lie in, as found by a probe ray at commit: indices into media_stacks, 0: air.
  std::vector<MediaStack> media_stacks;
  std::vector<uint32_t> media_of_camera;
  std::vector<std::vector<uint32_t>> media_of_meter;
  std::vector<uint32_t> media_of_emitter;

  SceneEffects effects;
  double maintenance_factor = 1;
  std::vector<std::string> warnings;
  uint64_t pixel_count() const {
    uint64_t n = 0;
    for (const Camera& c : cameras) n += c.pixel_count();
    return n;
  }
  uint64_t meter_count() const {  // of those that measure
    uint64_t n = 0;
    for (const MeterSet& s : meter_sets) n += s.meters.size();
    return n;
  }
  size_t luminaire_count = 0, light_count = 0, emissive_instance_count = 0;
};

}  // namespace ups
