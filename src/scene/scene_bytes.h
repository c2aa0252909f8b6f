// How much memory a committed scene takes: what was added to it and what was built from that. Asked before a render.
#pragma once
#include <cstddef>

#include "scene/snapshot.h"

namespace ups {

size_t bytes_of(const Snapshot& scene);

}  // namespace ups
