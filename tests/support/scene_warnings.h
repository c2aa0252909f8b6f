// What a commit tells of a scene.
#pragma once
#include <string>

#include "scene_builder.h"

namespace ups::test {

inline std::string scene_warnings(Scene& scene) {
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  size_t needed = 0;
  ups_scene_get_text(scene.get(), UPS_SCENE_TEXT_WARNINGS, nullptr, 0, &needed);
  std::string text(needed, '\0');
  check(ups_scene_get_text(scene.get(), UPS_SCENE_TEXT_WARNINGS, text.data(), needed, &needed), "ups_scene_get_text");
  text.resize(needed - 1);
  return text;
}

}  // namespace ups::test
