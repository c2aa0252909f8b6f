// Which lighting effects can a scene show, and what in it causes them? What no effect calls for is not simulated.
// Asked at commit by scene/prepare; read by render's choice of techniques and by people.
#pragma once
#include <vector>

#include "scene/snapshot.h"

namespace ups {

// used: by material index, whether any instance bears it. Ids in the text are those of the API.
SceneEffects find_effects(const Snapshot& scene, const std::vector<bool>& used);

}  // namespace ups
