// Lambertian surfaces: matte (reflects) and diffuser (reflects and transmits), alike on both sides. evaluate() is in
// models.h.
#include "bsdf/models.h"

namespace ups::diffuse {
Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, const Vec2& u, BsdfSample& out) {
  const bool reflected = u_lobe < reflection_probability(p);
  if (is_black(reflected ? p.reflectance : p.transmittance)) return Sampled::none;
  out.wi = square_to_cosine_hemisphere(u);
  if ((wo.z > 0) != reflected) out.wi.z = -out.wi.z;
  return Sampled::direction;
}

}  // namespace ups::diffuse
