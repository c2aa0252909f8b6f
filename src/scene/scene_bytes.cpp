// See scene_bytes.h. Large arrays are counted, small things by their number.
#include "scene/scene_bytes.h"

#include <set>

#include "emitter/rays.h"
#include "scene/description.h"

namespace ups {

namespace {

// What the description keeps of one, and what stands for it elsewhere: ids, names, panes, media.
constexpr size_t of_instance = sizeof(InstanceDescription) + sizeof(Raytracer::Instance) + 400,
                 of_source = sizeof(SourceDescription) + sizeof(Source) + 200,
                 of_material = sizeof(ups_material_desc) + sizeof(Material) + sizeof(SurfaceTexturing),
                 of_position = sizeof(Vec3d) + sizeof(Vec3);  // of a meter that was given one; without tangents
constexpr size_t of_scene = 64 << 10;  // context, description, Embree's device

size_t bytes_of(const photometry::Distribution& d) {
  const size_t values = d.c_deg().size() * d.gamma_deg().size();
  return values * (2 * sizeof(double) + sizeof(float));
}

// Luminaires of one profile share its tables, and its rays.
size_t bytes_of_profiles(const EmitterSet& emitters) {
  std::set<const void*> seen;
  size_t sum = 0;
  for (size_t i = 0; i < emitters.size(); ++i) {
    if (const auto* rays = dynamic_cast<const RayEmitter*>(&emitters[i]))
      sum += seen.insert(&rays->rays()).second ? rays->rays().bytes() : 0;
    const photometry::Distribution* d = emitters[i].outline().distribution;
    if (d && seen.insert(d).second) sum += bytes_of(*d);
  }
  return sum;
}

}  // namespace

size_t bytes_of(const Snapshot& scene) {
  size_t sum = of_scene + scene.raytracer->bytes() + scene.emitters.bytes() + bytes_of_profiles(scene.emitters);
  if (scene.described) {  // what no instance shows is kept, too
    scene.described->meshes().each([&](uint32_t, const Mesh& mesh) { sum += mesh.bytes(); });
    scene.described->textures().each([&](uint32_t, const TextureDescription& t) { sum += t.texture->bytes(); });
  }
  if (scene.openings) sum += scene.openings->bytes();
  sum += scene.flat_mirrors.bytes();
  for (const MeterSet& s : scene.meter_sets)
    sum += s.bytes() + (s.positions ? s.positions->size() * of_position : 0);
  for (const Goniometer& g : scene.goniometers)
    sum += g.node_count() * (sizeof(uint32_t) + 2 * sizeof(double));
  return sum + scene.media.of_instance.size() * of_instance + scene.sources.size() * of_source +
         scene.materials.size() * of_material + scene.meter_count() * sizeof(uint32_t);
}

}  // namespace ups
