// Which lighting effects can a scene show, and what in it causes them? What no effect calls for is not simulated.
// Asked at commit by scene/prepare; read by render's choice of techniques and by people.
#pragma once
#include <functional>
#include <string>

#include "scene/snapshot.h"

namespace ups {

SceneEffects find_effects(const Snapshot& scene);
// "material 3 (mirror) and 2 more", ids of the API: those in use of which it holds; or nothing.
std::string materials_of(const Snapshot& scene, const std::function<bool(const Material&)>& holds);

}  // namespace ups
