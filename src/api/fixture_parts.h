// What a fixture is made of: triangles and a material of each part, from the descs of ups_fixture.h. Used by
// src/api/fixture.cpp, which adds parts and places fixtures.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/rgb.h"
#include "photometry/optics.h"
#include "scene/description.h"
#include "ups/ups_fixture.h"

namespace ups::api {

struct FixturePart {
  optics::Mesh mesh;  // without normals where the caller's has none
  std::shared_ptr<const Revolution> revolution;  // of round reflectors and solids: traced in place of the mesh
  Affine to_fixture;
  ups_material_desc material;
  double flux_lm = -1, area_m2 = 0;  // of emitters; < 0: no emitter
  Rgb color;                         // luminance 1
};

// Throw Error or std::invalid_argument that name the field.
FixturePart make_part(const ups_fixture_emitter_desc& desc);
FixturePart make_part(const ups_reflector_desc& desc);
FixturePart make_part(const ups_lens_desc& desc);
FixturePart make_part(const ups_collimator_desc& desc);
FixturePart make_part(const ups_fixture_part_desc& desc);

// A rotation and a translation, or an error.
Affine rigid(const double (&m)[12], const std::string& field);

// A fixture in a scene.
struct PlacedFixture {
  struct Part {
    ups_instance_id instance;
    std::shared_ptr<const FixturePart> part;
    ups_material_id material;  // its own, of emitters; else 0
  };
  std::vector<Part> parts;
  double flux_scale = 1;
};

}  // namespace ups::api
