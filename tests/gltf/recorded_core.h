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

struct ups_scene {  // ids are places in these, from 1
  std::vector<RecordedTexture> textures;
  std::vector<ups_material_desc> materials;
  std::vector<RecordedMesh> meshes;
  std::vector<ups_instance_desc> instances;
  std::vector<ups_light_desc> lights;
  std::vector<RecordedLuminaire> luminaires;
  std::vector<ups_camera_desc> cameras;
  std::vector<RecordedMeters> meters;
  std::vector<RecordedGoniometer> goniometers;
};

// Profiles that were parsed and not yet destroyed.
int living_profiles();
// What ups_profile_parse does not accept: bytes that start with this; it then says "recorded core: no such format".
inline constexpr const char* refused_profile = "EULUMDAT";
