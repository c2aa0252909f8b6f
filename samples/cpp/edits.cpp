// What a CAD program does with a scene that it keeps: an L-shaped room, ten luminaires, two grids, a camera. One
// luminaire is moved, dimmed, aimed and removed; each is one call and a commit, where a program that describes all anew
// makes a call for each thing. Prints what either takes, and fails where the light of the edited scene has not the same
// bits as that of a new one.
//
//   edits_cpp
#include <ups/ups.hpp>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <map>

namespace {

using ups::Transform;

// Of a new scene: the scene, material, mesh, instance, two grids, camera, commit; luminaires come on top.
constexpr int luminaires = 10, calls_of_an_empty_room = 8, calls_of_an_edit = 2;
constexpr std::size_t meters = 20;
constexpr std::uint32_t width = 32, height = 24;

// [anew]
// 7 x 2 m along X and 2 x 6.5 m along Y share a corner; 2.7 m high.
ups_mesh_id add_walls(ups::Scene &scene, ups_material_id material) {
  const float outline[6][2] = {{0, 0}, {7, 0}, {7, 2}, {2, 2}, {2, 6.5f}, {0, 6.5f}};
  std::vector<float> positions;
  for (const float z : {0.0f, 2.7f})
    for (const auto &corner : outline) positions.insert(positions.end(), {corner[0], corner[1], z});
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t i : {0u, 1u, 2u, 3u}) {
    indices.insert(indices.end(), {0, i + 1, i + 2});  // the floor, then the ceiling
    indices.insert(indices.end(), {6, i + 8, i + 7});
  }
  for (std::uint32_t a = 0; a < 6; ++a) {
    const std::uint32_t b = (a + 1) % 6;
    indices.insert(indices.end(), {a, a + 6, b + 6, a, b + 6, b});
  }
  return scene.add_mesh({positions, indices, material});
}

ups_sensor_id add_grid(ups::Scene &scene, double x, double y) {
  std::vector<double> points;
  std::vector<float> up;
  for (std::size_t i = 0; i < meters; ++i) {
    points.insert(points.end(), {x + 0.3 * static_cast<double>(i % 5), y + 0.3 * static_cast<double>(i / 5), 0.75});
    up.insert(up.end(), {0, 0, 1});
  }
  return scene.add_meters({points, up});
}
// [end]

struct Placed {
  Transform to_world;
  float dimming = 1;
};

struct Light {
  ups_meter_reading near[meters], far[meters];
  float image[3 * width * height];
};

// What is in the room, and the ids of it in the scene that was described last.
struct Room {
  const ups::Context &context;
  ups::Profile profile;
  std::map<int, Placed> placed;
  std::map<int, ups_luminaire_id> ids;
  ups_sensor_id near{}, far{}, camera{};

  explicit Room(const ups::Context &of) : context(of), profile(downlight(of)) {
    for (int i = 0; i < luminaires; ++i)
      placed[i].to_world = Transform::translation(i < 6 ? 1 + i : 1, i < 6 ? 1 : i - 4, 2.6);
  }

  static ups::Profile downlight(const ups::Context &context) {
    const float c_deg[] = {0}, gamma_deg[] = {0, 30, 60, 90}, intensity_cd[] = {1000, 740, 190, 0};
    return ups::Profile(context, {c_deg, gamma_deg, intensity_cd});
  }

  // [anew]
  // The whole room as a new scene, committed.
  ups::Scene describe() {
    ups::Scene scene(context);
    scene.add_instance({add_walls(scene, scene.add_material(ups::MaterialDesc(0.6f)))});
    for (const auto &[i, at] : placed) {
      ups::LuminaireDesc luminaire(profile, at.to_world);
      luminaire.dimming = at.dimming;
      ids[i] = scene.add_luminaire(luminaire);
    }
    near = add_grid(scene, 4, 0.5);
    far = add_grid(scene, 0.4, 4);
    camera = scene.add_camera({width, height, Transform::look_at({0.5, 1, 1.5}, {7, 1, 1.5})});
    scene.commit();
    return scene;
  }
  // [end]

  std::unique_ptr<Light> render(const ups::Scene &scene) const {
    ups::RenderDesc desc;
    desc.iteration_count = 2;
    desc.light_paths_per_iteration = 2048;
    desc.seed = 11;
    const ups::Result result = scene.render(desc);
    auto light = std::make_unique<Light>();  // the library writes there
    result.read_meters(near, light->near);
    result.read_meters(far, light->far);
    result.read_image(camera, UPS_CHANNEL_LUMINANCE_RGB, light->image);
    return light;
  }
};

template <typename Call>
double milliseconds(Call call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// An edit of a scene that is kept, and of what is described anew: whether both have the same bits.
template <typename Edit, typename Change>
bool show(const char *what, const Room &room, ups::Scene &kept, Room &other, Edit edit, Change change) {
  const double edited_ms = milliseconds([&] {
    edit();
    kept.commit();
  });
  const auto light = room.render(kept);
  change(other.placed);
  ups::Scene anew(nullptr);
  const double described_ms = milliseconds([&] { anew = other.describe(); });
  const bool same = std::memcmp(light.get(), other.render(anew).get(), sizeof *light) == 0;
  std::printf("%-7s %d calls, %.1f ms; anew %d calls, %.1f ms; %6.1f lx, %6.1f lx; %s\n", what, calls_of_an_edit,
              edited_ms, calls_of_an_empty_room + static_cast<int>(other.placed.size()), described_ms, static_cast<double>(light->near[7].illuminance_lx),
              static_cast<double>(light->far[7].illuminance_lx), same ? "the same bits" : "OTHER BITS");
  return same;
}

bool run() {
  const ups::Context context;
  Room room(context), other(context);
  ups::Scene scene = room.describe();
  const ups_luminaire_id lamp = room.ids[3];
  const Transform moved = Transform::translation(4.5, 0.8, 2.4), aimed = Transform::aim({4.5, 0.8, 2.4}, {3, 0.8, 0});
  using All = std::map<int, Placed>;
  bool same = show("move", room, scene, other, [&] { scene.set_luminaire_transform(lamp, moved); },
                   [&](All &all) { all[3].to_world = moved; });
  same &= show("dim", room, scene, other, [&] { scene.set_dimming(lamp, 0.5f); },
               [](All &all) { all[3].dimming = 0.5f; });
  same &= show("aim", room, scene, other, [&] { scene.set_luminaire_transform(lamp, aimed); },
               [&](All &all) { all[3].to_world = aimed; });
  same &= show("remove", room, scene, other, [&] { scene.remove_luminaire(lamp); }, [](All &all) { all.erase(3); });
  return same;
}

}  // namespace

int main() {
  try {
    return run() ? 0 : 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
