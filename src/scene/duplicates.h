// Do triangles lie exactly on one another? Then rounding decides which of the two a ray hits: worth a warning.
// Asked once, by scene/prepare.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/raytracer.h"

namespace ups {

struct Duplicates {
  size_t count = 0;  // triangles with the same corners as an earlier one, whichever way round
  struct Triangle {
    uint32_t instance, primitive;
  } first{}, second{};  // an example
};

Duplicates find_duplicates(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                           const std::vector<Raytracer::Instance>& instances);

}  // namespace ups
