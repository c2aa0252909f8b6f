// See builder.h: what a commit tells that is no error, but hardly meant.
#include <algorithm>

#include "base/text.h"
#include "scene/builder.h"
#include "scene/check.h"
#include "scene/doubts.h"
#include "scene/length_text.h"

namespace ups {

void Builder::add_warnings() {
  if (out_->emitters.size() == 0) warn("nothing in the scene emits light");
  if (out_->cameras.empty() && out_->meter_sets.empty() && out_->goniometers.empty())
    warn("the scene has no camera, no meters and no goniometer: there is nothing to measure");
  for (size_t i = 0; !out_->goniometers.empty() && i < out_->emitters.size(); ++i)
    if (out_->emitters[i].is_directional())
      warn_of(out_->sources[out_->source_of_emitter[i]],
              "parallel light: where it leaves the scene, a goniometer's intensity depends on its grid, as it would be "
              "infinite");
  warn_of_contacts();
  warn_of_missing_uvs();
  warn_of_unit();
  warn_of_maintenance();
  for (const auto& [what, ids] : shared_warnings_) warn(listed(what.first, ids) + ": " + what.second);
}

void Builder::warn_of_maintenance() {
  if (in_.maintenance_factor() == 1 || unmaintained_ == 0) return;
  warn("the maintenance factor " + check::text(in_.maintenance_factor()) + " is of luminaires and fixtures alone: " +
       std::to_string(unmaintained_) + (unmaintained_ == 1 ? " light or emitting surface keeps its"
                                                           : " lights and emitting surfaces keep their") +
       " initial flux");
}

// One place of a texture stands for all then, where its corners meet.
void Builder::warn_of_missing_uvs() {
  for (size_t i = 0; i < out_->instances.size(); ++i) {
    const Raytracer::Instance& instance = out_->instances[i];
    if (!out_->meshes[instance.mesh]->uvs.empty()) continue;
    const Material& m = out_->materials[instance.material];
    const SurfaceTexturing& t = out_->texturing[instance.material];
    const auto varies = [](const Texture* texture) { return texture && texture->texel_count() > texture->channels(); };
    const bool holes = t.alpha_mode != SurfaceTexturing::opaque && varies(t.alpha);
    if (varies(m.reflectance_texture) || varies(m.roughness_texture) || varies(m.metallic_texture) ||
        varies(t.normal) || holes)
      warn_of("instance", out_->instance_ids[i],
              "its material has textures, but its mesh no uvs, which say where they lie: one place of them is taken "
              "for all of it");
  }
}

// Metres are expected; a room in millimetres is kilometres wide, and what luminaires emit is lost in it.
void Builder::warn_of_unit() {
  constexpr double large_m = 500, dark_lx = 0.01;
  const Vec3 size = out_->raytracer->bounds_max() - out_->raytracer->bounds_min();
  const double width = double(std::max({size.x, size.y, size.z}));
  if (!(width >= large_m)) return;
  const double lx = brightest_first_light_lx(*out_);
  if (lx < 0 || lx >= dark_lx) return;
  warn("the scene is " + length_text(width) + " wide, and its luminaires light what they shine at with about " +
       short_text(lx) + " lx: lengths are in metres; were millimetres meant?");
}

}  // namespace ups
