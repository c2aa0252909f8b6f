/* Scenes: textures, materials, meshes, instances, and edits of them. */
#include "example.h"

static ups_texture_id textures(ups_scene *scene) {
  /* [ups_texture_desc_init ups_scene_add_texture] */
  const float checks[4] = {0.2f, 0.8f, 0.8f, 0.2f}; /* linear, row 0 at v = 0 */
  ups_texture_desc desc;
  ups_texture_id texture;
  ups_texture_desc_init(&desc, sizeof desc);
  desc.width = desc.height = 2;
  desc.channel_count = 1;
  desc.texels = checks;
  check(ups_scene_add_texture(scene, &desc, &texture));
  /* [end] */

  /* [ups_scene_set_texture] */
  const float grey[2] = {0.5f, 0.4f};
  desc.height = 1;
  desc.texels = grey;
  check(ups_scene_set_texture(scene, texture, &desc)); /* materials that have it show the new one */
  /* [end] */

  /* [ups_scene_get_texture ups_scene_read_texture] */
  ups_texture_desc now;
  now.struct_size = sizeof now;
  check(ups_scene_get_texture(scene, texture, &now)); /* its size; texels is NULL */
  const size_t count = (size_t)now.width * now.height * now.channel_count;
  float *texels = malloc(count * sizeof *texels);
  check(ups_scene_read_texture(scene, texture, texels, count, NULL));
  /* [end] */
  expect(count == 2 && texels[0] == 0.5f);
  free(texels);
  return texture;
}

static ups_material_id materials(ups_scene *scene, ups_texture_id texture) {
  /* [ups_material_desc_init ups_scene_add_material] */
  ups_material_desc desc;
  ups_material_id material;
  ups_material_desc_init(&desc, sizeof desc); /* matte, white enough; nothing emits */
  desc.reflectance_rgb[0] = 0.7f;
  desc.reflectance_rgb[1] = 0.6f;
  desc.reflectance_rgb[2] = 0.5f;
  desc.reflectance_texture = texture; /* multiplies them */
  check(ups_scene_add_material(scene, &desc, &material));
  /* [end] */

  /* [ups_scene_get_material ups_scene_set_material] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_material(scene, material, &desc)); /* as it stands */
  desc.reflectance_texture.v = 0;                        /* none */
  check(ups_scene_set_material(scene, material, &desc));
  /* [end] */
  check(ups_scene_get_material(scene, material, &desc));
  expect(desc.reflectance_texture.v == 0 && desc.reflectance_rgb[0] == 0.7f);
  return material;
}

static ups_mesh_id meshes(ups_scene *scene, ups_material_id material) {
  /* [ups_mesh_desc_init ups_scene_add_mesh] */
  const float corners[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}; /* m, in the mesh's own frame */
  const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3};              /* counter-clockwise from the front */
  ups_mesh_desc desc;
  ups_mesh_id mesh;
  ups_mesh_desc_init(&desc, sizeof desc);
  desc.vertex_count = 4;
  desc.triangle_count = 2;
  desc.positions_m = corners;
  desc.indices = triangles;
  desc.material = material;
  check(ups_scene_add_mesh(scene, &desc, &mesh));
  /* [end] */

  /* [ups_scene_set_mesh_vertices] */
  const float longer[12] = {0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0};
  check(ups_scene_set_mesh_vertices(scene, mesh, longer, NULL, 4));
  /* [end] */

  /* [ups_scene_get_mesh ups_scene_set_mesh] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_mesh(scene, mesh, &desc)); /* its arrays are the scene's own */
  desc.triangle_count = 1;
  check(ups_scene_set_mesh(scene, mesh, &desc));
  /* [end] */
  check(ups_scene_get_mesh(scene, mesh, &desc));
  expect(desc.triangle_count == 1 && desc.positions_m[3] == 2);
  return mesh;
}

static ups_instance_id instances(ups_scene *scene, ups_mesh_id mesh) {
  /* [ups_instance_desc_init ups_scene_add_instance] */
  ups_instance_desc desc;
  ups_instance_id instance;
  ups_instance_desc_init(&desc, sizeof desc); /* where it was modelled */
  desc.mesh = mesh;
  desc.to_world[11] = 0.75; /* m up */
  check(ups_scene_add_instance(scene, &desc, &instance));
  /* [end] */

  /* [ups_scene_set_transform] */
  const double quarter_turn[12] = {0, -1, 0, 3, 1, 0, 0, 2, 0, 0, 1, 0.75}; /* 3x4, row-major */
  check(ups_scene_set_transform(scene, instance, quarter_turn));
  /* [end] */

  /* [ups_scene_get_instance ups_scene_set_instance] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_instance(scene, instance, &desc));
  desc.group = 2; /* its light, for UPS_SEPARATE_GROUPS */
  check(ups_scene_set_instance(scene, instance, &desc));
  /* [end] */
  check(ups_scene_get_instance(scene, instance, &desc));
  expect(desc.group == 2 && desc.to_world[3] == 3);
  return instance;
}

int main(void) {
  ups_context *context;
  check(ups_context_create(NULL, &context));

  /* [ups_scene_create] */
  ups_scene *scene;
  check(ups_scene_create(context, &scene));
  /* [end] */
  const ups_texture_id texture = textures(scene);
  const ups_material_id material = materials(scene, texture);
  const ups_mesh_id mesh = meshes(scene, material);
  const ups_instance_id instance = instances(scene, mesh);

  expect(ups_scene_remove_mesh(scene, mesh) == UPS_ERROR_INVALID_ARGUMENT); /* the instance needs it */
  /* [ups_scene_remove_instance ups_scene_remove_mesh ups_scene_remove_material ups_scene_remove_texture] */
  check(ups_scene_remove_instance(scene, instance)); /* first what needs the others */
  check(ups_scene_remove_mesh(scene, mesh));
  check(ups_scene_remove_material(scene, material));
  check(ups_scene_remove_texture(scene, texture));
  /* [end] */
  expect(ups_scene_remove_texture(scene, texture) == UPS_ERROR_INVALID_ARGUMENT);
  expect(strstr(ups_last_error(), "removed") != NULL);

  /* [ups_scene_destroy] */
  ups_scene_destroy(scene); /* renders that run go on */
  /* [end] */
  ups_context_destroy(context);
  return 0;
}
