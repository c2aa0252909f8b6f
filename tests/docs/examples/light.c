/* Luminaires and lights, and what of a committed scene may emit. */
#include "example.h"

static ups_luminaire_id luminaires(ups_context *context, ups_scene *scene) {
  ups_profile *profile = make_downlight(context);
  /* [ups_luminaire_desc_init ups_scene_add_luminaire] */
  ups_luminaire_desc desc;
  ups_luminaire_id luminaire;
  ups_luminaire_desc_init(&desc, sizeof desc); /* full light, white, as the profile has it, nadir down */
  desc.profile = profile;
  desc.to_world[3] = 2; /* m */
  desc.to_world[7] = 1.5;
  desc.to_world[11] = 2.45;
  desc.flux_lm = 1200; /* instead of the profile's */
  check(ups_scene_add_luminaire(scene, &desc, &luminaire));
  /* [end] */
  ups_profile_destroy(profile);

  /* [ups_scene_get_luminaire ups_scene_set_luminaire] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_luminaire(scene, luminaire, &desc)); /* profile is NULL: it stays as it is */
  desc.use_opening = 0;                                    /* emit from a point */
  check(ups_scene_set_luminaire(scene, luminaire, &desc));
  /* [end] */

  /* [ups_scene_get_luminaire_profile] */
  ups_profile *same;
  check(ups_scene_get_luminaire_profile(scene, luminaire, &same));
  /* [end] */
  const float down[3] = {0, 0, -1};
  float cd;
  check(ups_profile_eval(same, down, 1, &cd));
  expect(cd == 1000);
  ups_profile_destroy(same);

  /* [ups_scene_set_luminaire_transform] */
  const double turned[12] = {0, -1, 0, 1, 1, 0, 0, 1.5, 0, 0, 1, 2.45}; /* a quarter about the vertical, and moved */
  check(ups_scene_set_luminaire_transform(scene, luminaire, turned));
  /* [end] */

  /* [ups_scene_set_dimming ups_scene_get_dimming] */
  float dimming;
  check(ups_scene_get_dimming(scene, luminaire, &dimming));
  check(ups_scene_set_dimming(scene, luminaire, dimming / 2));
  /* [end] */
  check(ups_scene_get_dimming(scene, luminaire, &dimming));
  expect(dimming == 0.5f);
  return luminaire;
}

static ups_luminaire_id lights(ups_scene *scene) {
  /* [ups_light_desc_init ups_scene_add_light] */
  ups_light_desc desc;
  ups_luminaire_id light; /* lights are dimmed, moved and removed as luminaires are */
  ups_light_desc_init(&desc, sizeof desc);
  desc.kind = UPS_LIGHT_SPOT;
  desc.intensity_rgb[0] = desc.intensity_rgb[1] = desc.intensity_rgb[2] = 200; /* cd */
  desc.inner_cone_rad = 0.2f;
  desc.outer_cone_rad = 0.3f;
  desc.to_world[11] = 2;
  check(ups_scene_add_light(scene, &desc, &light));
  /* [end] */

  /* [ups_scene_get_light ups_scene_set_light] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_light(scene, light, &desc));
  desc.outer_cone_rad = 0.5f;
  check(ups_scene_set_light(scene, light, &desc));
  /* [end] */
  check(ups_scene_get_light(scene, light, &desc));
  expect(desc.outer_cone_rad == 0.5f && desc.kind == UPS_LIGHT_SPOT);
  return light;
}

static void read_flux(const ups_scene *scene, double lm[2]) {
  /* [ups_scene_get_source_count ups_scene_get_source] */
  uint32_t count;
  check(ups_scene_get_source_count(scene, &count)); /* of the committed scene */
  for (uint32_t i = 0; i < count; ++i) {
    ups_scene_source source;
    source.struct_size = sizeof source;
    check(ups_scene_get_source(scene, i, &source));
    lm[i] = source.flux_lm; /* dimming and maintenance factor included */
  }
  /* [end] */
  expect(count == 2);
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  const ups_luminaire_id luminaire = luminaires(context, scene);
  const ups_luminaire_id light = lights(scene);
  check(ups_scene_commit(scene));
  double lm[2], maintained_lm[2];
  read_flux(scene, lm);

  /* [ups_scene_set_maintenance_factor ups_scene_get_maintenance_factor] */
  double factor;
  check(ups_scene_get_maintenance_factor(scene, &factor)); /* 1 at first */
  check(ups_scene_set_maintenance_factor(scene, 0.8));
  /* [end] */
  expect(factor == 1);
  check(ups_scene_commit(scene));
  read_flux(scene, maintained_lm);
  expect(near(lm[0], 600, 30) && near(maintained_lm[0], 0.8 * lm[0], 1e-3) && maintained_lm[1] == lm[1]); /* a light */

  /* [ups_scene_get_source_profile] */
  ups_profile *profile;
  check(ups_scene_get_source_profile(scene, 0, &profile)); /* the first is a luminaire */
  /* [end] */
  ups_profile_destroy(profile);
  expect(ups_scene_get_source_profile(scene, 1, &profile) == UPS_ERROR_INVALID_ARGUMENT);

  /* [ups_scene_remove_luminaire] */
  check(ups_scene_remove_luminaire(scene, light)); /* a luminaire or a light */
  /* [end] */
  expect(ups_scene_remove_luminaire(scene, light) == UPS_ERROR_INVALID_ARGUMENT);
  expect(luminaire.v != 0);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
