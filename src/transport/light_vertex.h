// Vertices of the light paths of one iteration, as connections and merges read them.
#pragma once
#include <cstdint>
#include <vector>

#include "transport/subpath.h"

namespace ups {

struct LightVertex {
  Vec3 p, ng, ns;
  Vec3 wo;   // towards the vertex before
  Textured textured;
  Rgb flux;  // lm that this light path carries here; divide by N for a photon
  float error = 0;
  uint32_t material = 0;
  uint32_t emitter = 0;  // that the path started from
  float relative_ior = 1;  // where it is of glass, see Encounter
  uint16_t depth = 0;   // a of x_a
  bool merge = false;   // photons are merged here: the material's gate and g_1
  bool lit = true;      // from the front of its shading normal; else merged alone
  bool lambertian = false;  // scatters continuously by Lambertian lobes alone
  bool both_sides = false;  // Bsdf::transmits_continuously
  mis::LightState mis;

  // Into one that is used again: its other members stay as they were made.
  void fill(const Snapshot& scene, LightEnd& e) const {
    e.surface.p = p;
    e.surface.ng = ng;
    e.surface.shading = Frame(ns);
    e.surface.error = error;
    e.bsdf.emplace(scene.materials[material], relative_ior, textured);
    e.wo = wo;
    e.local_wo = e.surface.shading.to_local(wo);
    e.state = mis;
    e.merge = merge;
    e.caster = e.bsdf->is_glossy(default_glossy_alpha);
    e.edges = depth;
    e.carried = flux;
  }
};

struct LightPaths {
  std::vector<LightVertex> vertices;  // path by path
  std::vector<uint32_t> begin;        // N + 1
  MemoryShare share;                  // of both
};

}  // namespace ups
