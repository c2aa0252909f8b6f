// Do triangles lie exactly on one another? Then rounding decides which of the two a ray hits: worth a warning, but for
// faces that two solids of glass share, which are one boundary.
// Asked once, by scene/prepare.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "scene/media.h"

namespace ups {

struct Duplicates {
  size_t count = 0;  // triangles with the same corners as an earlier one, whichever way round
  struct Triangle {
    uint32_t instance, primitive;
  } first{}, second{};  // an example
};

Duplicates find_duplicates(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                           const std::vector<Raytracer::Instance>& instances, const Media& media);

}  // namespace ups
