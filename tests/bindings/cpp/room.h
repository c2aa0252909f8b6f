// A room of 4 x 3 x 2.5 m with a luminaire, four meters and a camera, for tests of ups.hpp.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ups/ups.hpp"

// The call must throw so, and its message must hold every one of the words.
template <class Call>
void expect_error(ups_status status, const std::vector<std::string> &words, Call call) {
  try {
    call();
    ADD_FAILURE() << "nothing was thrown; expected " << ups_status_name(status);
  } catch (const ups::Error &error) {
    EXPECT_EQ(error.status(), status) << error.what();
    for (const std::string &word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << "'" << word << "' not in: " << error.what();
  }
}

inline ups::ContextDesc two_threads() {
  ups::ContextDesc desc;
  desc.thread_count = 2;
  return desc;
}

inline ups::Profile downlight(const ups::Context &context) {
  const std::vector<float> c_deg = {0}, gamma_deg = {0, 30, 60, 90}, intensity_cd = {1000, 740, 190, 0};
  return {context, {c_deg, gamma_deg, intensity_cd}};
}

struct Room {
  const std::vector<float> positions = {0, 0, 0,    4, 0, 0,    4, 3, 0,    0, 3, 0,
                                        0, 0, 2.5f, 4, 0, 2.5f, 4, 3, 2.5f, 0, 3, 2.5f};
  const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5,
                                              1, 6, 2, 1, 5, 6, 2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4};
  const std::vector<double> points = {1, 1, 0.75, 3, 1, 0.75, 1, 2, 0.75, 3, 2, 0.75};
  const std::vector<float> up = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};

  ups::Context context{two_threads()};
  ups::Scene scene{context};
  ups_material_id material = scene.add_material(ups::MaterialDesc(0.6f));
  ups_mesh_id mesh = scene.add_mesh({positions, indices, material});
  ups_instance_id instance = scene.add_instance({mesh});
  ups_luminaire_id lamp = scene.add_luminaire({downlight(context), ups::Transform::translation(2, 1.5, 2.4)});
  ups_sensor_id meters = scene.add_meters({points, up});
  ups_sensor_id camera = scene.add_camera({8, 6, ups::Transform::look_at({0.5, 1.5, 1.25}, {3, 1.5, 1.25})});

  // Of few paths: a render of it takes a few milliseconds.
  static ups::RenderDesc few(std::uint32_t iterations = 8) {
    ups::RenderDesc desc;
    desc.method = UPS_METHOD_UPS;
    desc.iteration_count = iterations;
    desc.light_paths_per_iteration = 1024;
    desc.seed = 5;
    return desc;
  }
};
