// See ids.h: which tags are in use, for the whole process.
#include "scene/ids.h"

#include <algorithm>
#include <array>
#include <mutex>

namespace ups {
namespace {

std::mutex mutex;
std::array<uint32_t, SceneTag::last> scenes_of{};  // by tag - 1
uint32_t next = 0;
uint64_t scenes = 0;  // that there have been

}  // namespace

SceneTag::SceneTag() {
  const std::lock_guard lock(mutex);
  const uint32_t fewest = *std::min_element(scenes_of.begin(), scenes_of.end());
  while (scenes_of[next] != fewest) next = (next + 1) % last;
  ++scenes_of[next];
  value_ = ++next;
  next %= last;
  first_revision_ = ++scenes << 40;
}

SceneTag::~SceneTag() {
  const std::lock_guard lock(mutex);
  --scenes_of[value_ - 1];
}

}  // namespace ups
