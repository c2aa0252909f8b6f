// Does a render in C++ have the same bits as in C? UPS_SAME_BITS names the file that same_bits.c wrote, of the scene
// that is described there and here.
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "room.h"

namespace {

void add_surfaces(ups::Scene &scene) {
  Room room;
  std::vector<float> positions = room.positions;
  std::vector<std::uint32_t> indices = room.indices;
  positions.insert(positions.end(), {1, 1, 1.5f, 2, 1, 1.5f, 2, 2, 1.5f, 1, 2, 1.5f});
  indices.insert(indices.end(), {8, 9, 10, 8, 10, 11});
  ups::MaterialDesc material;
  material.model = UPS_MATERIAL_PLASTIC;
  material.reflectance_rgb[0] = 0.5f;
  material.reflectance_rgb[1] = 0.6f;
  material.reflectance_rgb[2] = 0.7f;
  material.roughness = 0.4f;
  scene.add_instance({scene.add_mesh({positions, indices, scene.add_material(material)})});
}

TEST(SameBits, AsInC) {
  const char *const path = std::getenv("UPS_SAME_BITS");
  ASSERT_NE(path, nullptr) << "UPS_SAME_BITS must name the file that same_bits wrote";
  std::ifstream file(path, std::ios::binary);
  const std::string wanted{std::istreambuf_iterator<char>(file), {}};

  std::vector<double> points;
  std::vector<float> normals;
  for (int i = 0; i < 35; ++i) {
    points.insert(points.end(), {(i % 7 + 0.5) * 4 / 7, (i / 7 + 0.5) * 3 / 5, 0.75});
    normals.insert(normals.end(), {0, 0, 1});
  }
  ups::Context context;
  ups::Scene scene(context);
  add_surfaces(scene);
  scene.add_luminaire({downlight(context), ups::Transform::translation(2, 1.5, 2.4)});
  const auto meters = scene.add_meters({points, normals});
  const auto camera = scene.add_camera({24, 16, ups::Transform::look_at({0.5, 1.5, 1.25}, {4, 1.5, 1.25})});
  scene.commit();
  ups::RenderDesc render;
  render.method = UPS_METHOD_UPS;
  render.iteration_count = 8;
  render.seed = 20;
  const ups::Result result = scene.render(render);
  const auto readings = result.read_meters(meters);
  const auto image = result.read_image(camera, UPS_CHANNEL_LUMINANCE_RGB, 24, 16);
  ASSERT_EQ(readings.size(), 35u);
  for (const ups_meter_reading &r : readings) EXPECT_GT(r.illuminance_lx, 1) << "there is light";
  const std::size_t of_readings = readings.size() * sizeof readings[0], of_image = image.size() * sizeof image[0];
  ASSERT_EQ(wanted.size(), of_readings + of_image);
  EXPECT_EQ(std::memcmp(wanted.data(), readings.data(), of_readings), 0);
  EXPECT_EQ(std::memcmp(wanted.data() + of_readings, image.data(), of_image), 0);
}

}  // namespace
