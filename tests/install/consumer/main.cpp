// The same through ups.hpp.
#include <cstdio>
#include <ups/ups.hpp>

int main() {
  try {
    const float positions[] = {-5, -5, 0, 5, -5, 0, 5, 5, 0, -5, 5, 0};
    const std::uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    const double point[] = {0, 0, 0.5};
    const float up[] = {0, 0, 1};
    const ups::Context context;
    ups::Scene scene(context);
    scene.add_instance({scene.add_mesh({positions, indices, scene.add_material(ups::MaterialDesc())})});
    ups::LightDesc light(UPS_LIGHT_POINT, ups::Transform::translation(0, 0, 2.5));
    for (float &i : light.intensity_rgb) i = 400;
    scene.add_light(light);
    const ups_sensor_id meter = scene.add_meters({point, up});
    scene.commit();
    ups::RenderDesc render;
    render.iteration_count = 16;
    const double lux = static_cast<double>(scene.render(render).read_meters(meter)[0].illuminance_lx);
    const unsigned version = ups::version();
    std::printf("UPS %u.%u.%u: %.3f lx\n", version / 10000, version / 100 % 100, version % 100, lux);
    return lux > 99.9 && lux < 100.1 ? 0 : 1;
  } catch (const ups::Error &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
