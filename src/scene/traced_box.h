// What an instance takes up in the scene, as rays find it.
#pragma once
#include "scene/snapshot.h"

namespace ups {

inline Box traced_box(const Snapshot& scene, const Raytracer::Instance& i) {
  const Mesh& mesh = *scene.meshes[i.mesh];
  return (mesh.revolution ? bounding_box(mesh) : scene.mesh_boxes[i.mesh]).transformed(i.to_scene);
}

}  // namespace ups
