// The room of samples/c/small_room.c in C++17. With the library installed:
// c++ -std=c++17 small_room.cpp $(pkg-config --cflags --libs ups) -o small_room && ./small_room
#include <ups/ups.hpp>

#include <cstdio>

static const std::string ies =
    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 10 1 1 2 0 0 0\n1 1 20\n"
    "0 10 20 30 40 50 60 70 80 90\n0\n1000 970 880 740 560 370 190 70 15 0\n";

int main() {
  try {
    const std::vector<float> corners = {0, 0, 0,    4, 0, 0,    4, 3, 0,    0, 3, 0,  // metres
                                        0, 0, 2.6f, 4, 0, 2.6f, 4, 3, 2.6f, 0, 3, 2.6f};
    const std::vector<std::uint32_t> faces = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5,  // from inside
                                              1, 6, 2, 1, 5, 6, 2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4};
    const ups::Context context;
    ups::Scene scene(context);
    scene.add_instance({scene.add_mesh({corners, faces, scene.add_material(ups::MaterialDesc(0.6f))})});
    const ups::Profile profile = ups::Profile::parse(context, ies);
    scene.add_luminaire({profile, ups::Transform::translation(2, 1.5, 2.5)});

    std::vector<double> places;
    std::vector<float> up;
    for (int i = 0; i < 12; ++i) {
      places.insert(places.end(), {i % 4 + 0.5, i / 4 + 0.5, 0.75});
      up.insert(up.end(), {0, 0, 1});
    }
    const ups_sensor_id meters = scene.add_meters({places, up});
    scene.commit();
    ups::RenderDesc render;
    render.iteration_count = 256;
    const ups::Result result = scene.render(render);
    for (const ups_meter_reading &r : result.read_meters(meters))
      std::printf("%6.1f +- %.1f lx\n", double(r.illuminance_lx), double(r.error_bound_lx));
    const unsigned version = ups::version();
    std::printf("UPS %u.%u.%u: mean %.6f lx\n", version / 10000, version / 100 % 100, version % 100,
                double(result.get_meter_statistics(meters).mean_lx));
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
