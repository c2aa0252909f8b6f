// What rendering reads: an immutable build of a scene. Made by scene/prepare, shared by every render that started from
// it. Coordinates are floats relative to `origin`, near the centre of the scene, so that a building far from zero keeps
// its precision. A later build shares the parts that are the same.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/shared_list.h"
#include "bsdf/material.h"
#include "emitter/emitter_set.h"
#include "geometry/raytracer.h"
#include "photometry/photometry.h"
#include "photometry/position_index.h"
#include "scene/contact.h"
#include "scene/flat_mirrors.h"
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
  // No emitter without extent beside a mirror-like surface, but for flat mirrors that show its image; no ray emitter.
  bool path_tracing_complete = true;
  bool ray_emitters = false;  // some light comes from the rays of a file: light paths alone carry it
  float concentration = 1;    // of first light on small patches, see scene/probe.h
  bool sharp_caster = false;  // some material has a delta lobe or a narrow one (MaterialTraits::glossy)
  bool casts = false;         // and that has most of its light (MaterialTraits::caster)
  bool images_suffice = false;  // those are flat mirrors, which reflect nobody's light in turn, and show all emitters
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

// What probe rays have told of an emitter: it holds as long as emitter and surfaces stay where they are.
struct EmitterProbe {
  Vec3 place;                 // of a source without extent, off the surface that it lies on
  float into_surface = 0;     // the share of its light that goes into that
  int lies_in_another = -1;   // of an emissive surface, see scene/footing.h; < 0: not asked for
  uint32_t starts_beyond = none;  // the same
  float error = 0;            // of an opening's surface
  float exposed = -1;         // share of its light, see scene/probe.h; < 0: not asked for
  double concentration = -1;  // the same
  uint32_t concentration_rays = 0;
};

// Warnings that take long to find: once, for all builds in which they are the same.
struct SearchedWarnings {
  std::mutex searching;  // held as long as a search takes
  std::mutex mutex;      // guards what follows, never for long
  bool known = false;
  std::vector<std::string> texts;
};

class Description;

struct Snapshot {
  std::shared_ptr<const SceneTag> tag;  // of the ids that the program has; all below are without it
  std::shared_ptr<const Description> described;  // what this is a build of
  // Multiples of a power of two near the scene's size, which is `extent`: the next build has seldom another.
  Vec3d origin;
  double extent = 0;
  Vec3 centre;       // of the bounding sphere of geometry, emitters and sensors
  float radius = 0;  // of it

  // What an instance shows, in the order of numbers.
  std::vector<Material> materials;              // by SurfacePoint::material
  std::vector<SurfaceTexturing> texturing;      // by the same index
  std::vector<uint32_t> material_numbers;       // by the same index
  std::vector<std::shared_ptr<const Texture>> textures;  // that they point to
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<Box> mesh_boxes;                  // of the triangles' vertices
  std::vector<uint32_t> mesh_numbers;
  std::shared_ptr<const Raytracer> raytracer;   // never null; may hold no triangle
  std::vector<Raytracer::Instance> instances;   // by SurfacePoint::instance
  std::vector<uint32_t> instance_ids;           // by the same index

  std::map<std::pair<ups_source_kind, uint32_t>, Contact> contacts;  // emitters near glass, by their sources
  std::vector<SearchedSurface> searched_surfaces;  // for them
  bool finds_all = false;                       // the ray tracer, for their sake, that of blended surfaces and panes

  EmitterSet emitters;
  std::vector<std::string> emitter_names;       // "luminaire 3", "instance 7": by their numbers
  std::vector<float> emitter_sizes;             // m; smallest extent of a luminaire's opening, used or not; 0: unknown
  std::vector<Source> sources;                  // all, in the order of their kinds and ids
  std::vector<uint32_t> source_of_emitter;      // index into sources
  std::vector<uint32_t> emitter_of_instance;    // none: does not emit
  std::vector<EmitterProbe> emitter_probes;     // by index in emitters
  std::shared_ptr<const DiscIndex> openings;    // null without luminous openings
  std::vector<uint32_t> emitter_of_opening;     // by DiscIndex::Crossing::disc (what surrounds it)

  std::vector<Camera> cameras;
  SharedList<MeterSet> meter_sets;
  std::vector<Goniometer> goniometers;
  std::vector<uint32_t> camera_ids, meter_set_ids, goniometer_ids;  // numbers of each
  std::vector<Observer> observers;
  std::vector<uint32_t> observer_ids;           // those of their meter sets
  std::vector<photometry::Opening> goniometer_openings;  // that their distributions are given

  Panes panes;
  FlatMirrors flat_mirrors;
  Media media;
  // What free-standing things lie in, as found by a probe ray at commit: indices into media_stacks, 0: air.
  std::vector<MediaStack> media_stacks;
  size_t sensor_media_count = 0;  // of them, those before what emitters alone lie in
  std::vector<uint32_t> media_of_camera;
  std::vector<std::vector<uint32_t>> media_of_meter;
  std::vector<uint32_t> media_of_emitter;  // as of meters, none: they differ from place to place

  SceneEffects effects;
  double maintenance_factor = 1;
  std::vector<std::string> warnings;            // but for those of `searched`
  std::map<uint32_t, std::vector<std::string>> sensor_warnings;  // the part of them that a sensor has, by its number
  std::shared_ptr<SearchedWarnings> surface_search, light_search;  // see scene/searched.h
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
