// A core that records what the importer tells it instead of rendering: the functions of ups.h that ups_gltf calls.
// Called by the tests of the importer, which can so check every field of every desc.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "ups/ups.h"

struct RecordedMesh {
  uint32_t material;
  std::vector<float> positions, normals, uvs, tangents;
  std::vector<uint32_t> indices;
};

struct RecordedTexture {
  uint32_t width, height, channels;
  std::vector<float> texels;
};

struct RecordedMeters {
  ups_meter_kind kind;
  std::vector<double> positions;
  std::vector<float> normals, tangents;
  float cell_size_m[2];
};

struct RecordedGoniometer {
  ups_goniometer_desc desc;  // angles: dangling, never read
  std::vector<float> c_deg, gamma_deg;
};

struct RecordedLuminaire {
  ups_luminaire_desc desc;  // profile: dangling, never read
  std::string profile_bytes;
};

struct ups_fixture {
  std::vector<std::string> parts;  // the kinds, in order
  std::vector<ups_fixture_emitter_desc> emitters;
  std::vector<ups_reflector_desc> reflectors;  // pointers: dangling, never read
  std::vector<ups_lens_desc> lenses;
  std::vector<ups_collimator_desc> collimators;
  std::vector<ups_material_desc> custom;  // of CUSTOM finishes, in order
  std::vector<double> points;             // of the last polyline
};

struct RecordedFixture {
  ups_fixture_instance_desc desc;
  ups_fixture fixture;
};

struct ups_scene {  // ids are places in these, from 1
  std::vector<RecordedTexture> textures;
  std::vector<ups_material_desc> materials;
  std::vector<RecordedMesh> meshes;
  std::vector<ups_instance_desc> instances;
  std::vector<ups_light_desc> lights;
  std::vector<RecordedLuminaire> luminaires;
  std::vector<RecordedFixture> fixtures;
  std::vector<ups_camera_desc> cameras;
  std::vector<RecordedMeters> meters;
  std::vector<RecordedGoniometer> goniometers;
  double maintenance_factor = 1;
  std::vector<ups_observer_desc> observers;
};

// Profiles that were parsed and not yet destroyed.
int living_profiles();
// Fixtures that were ever made, and those not yet destroyed.
int made_fixtures();
int living_fixtures();
// The instance that a part became, both counted from 1.
constexpr uint32_t recorded_part_instance(uint32_t fixture, uint32_t part) { return 1000 * fixture + part; }
// What ups_profile_parse does not accept: bytes that start with this; it then says "recorded core: no such format".
inline constexpr const char* refused_profile = "EULUMDAT";
