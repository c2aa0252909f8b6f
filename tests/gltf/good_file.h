// Files that are right, and where things of them ended up. Called by the tests of scenes, sensors and lights.
#pragma once
#include <cmath>

#include "scene_builder.h"

inline const json upward = {-0.7071068, 0, 0, 0.7071068};  // local +Z to glTF's +Y

class GoodFile : public ImportTest {
 protected:
  std::vector<double> meter_positions(uint32_t sensor) {
    std::vector<double> positions(3 * sensor_info(sensor).meter_count);
    EXPECT_EQ(ups_gltf_read_meters(imported, sensor, positions.data(), nullptr, positions.size() / 3), UPS_OK);
    return positions;
  }
  std::vector<float> meter_normals(uint32_t sensor) {
    std::vector<float> normals(3 * sensor_info(sensor).meter_count);
    EXPECT_EQ(ups_gltf_read_meters(imported, sensor, nullptr, normals.data(), normals.size() / 3), UPS_OK);
    return normals;
  }
  template <class T>
  static void expect_near(const std::vector<T>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6) << i;
  }
  static json grid(const char* name) {
    json meters = {{"width_m", 4}, {"height_m", 2}, {"columns", 2}, {"rows", 2}};
    if (name) meters["name"] = name;
    return {{"ups", {{"meters", meters}}}};
  }
  static std::vector<double> point(const double (&m)[12], double x, double y, double z) {
    std::vector<double> result;
    for (int i = 0; i < 3; ++i) result.push_back(m[4 * i] * x + m[4 * i + 1] * y + m[4 * i + 2] * z + m[4 * i + 3]);
    return result;
  }
};
