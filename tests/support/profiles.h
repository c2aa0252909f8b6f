// Profiles that tests make of tables.
#pragma once
#include <memory>
#include <vector>

#include "scene_builder.h"

namespace ups::test {

using Profile = std::unique_ptr<ups_profile, decltype(&ups_profile_destroy)>;

// Gamma rows of an axial profile with an opening.
inline Profile profile_of(ups_context* context, const std::vector<float>& gamma, const std::vector<float>& cd,
                          ups_opening_shape shape, float x, float y, float z) {
  const float c = 0;
  auto d = make_desc<ups_profile_desc>(ups_profile_desc_init);
  d.c_count = 1, d.gamma_count = uint32_t(gamma.size());
  d.c_deg = &c, d.gamma_deg = gamma.data(), d.intensity_cd = cd.data();
  d.opening_shape = shape;
  d.opening_m[0] = x, d.opening_m[1] = y, d.opening_m[2] = z;
  ups_profile* profile = nullptr;
  check(ups_profile_create(context, &d, &profile), "ups_profile_create");
  return {profile, ups_profile_destroy};
}

}  // namespace ups::test
