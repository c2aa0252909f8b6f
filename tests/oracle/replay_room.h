// A small scene that has something of everything that the weights know: emitters with and without extent, panes in the
// way, mirrors, glass, sharp and blunt lobes, a camera, point meters and cells of every kind.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "../support/shapes.h"
#include "scene/prepare.h"

namespace ups::test {

struct Pane {  // a parallelogram
  Vec3d corner, u, v;
  uint32_t material;
};

struct Room {
  std::shared_ptr<const Snapshot> scene;
  std::vector<Pane> panes;  // in the snapshot's coordinates
};

class RoomBuilder {
 public:
  static ups_material_desc material(ups_material_model model, float reflectance = 0.6f, float roughness = 0) {
    ups_material_desc m = default_material();
    m.struct_size = sizeof m;
    m.model = model;
    m.roughness = roughness;
    std::fill_n(m.reflectance_rgb, 3, reflectance);
    return m;
  }
  void add(const Shape& shape, const ups_material_desc& m) {
    std::vector<float> p, n;
    for (const P3& v : shape.vertices) p.insert(p.end(), {float(v.x), float(v.y), float(v.z)});
    for (const P3& v : shape.normals) n.insert(n.end(), {float(v.x), float(v.y), float(v.z)});
    std::vector<uint32_t> indices;
    for (const auto& t : shape.triangles) indices.insert(indices.end(), t.begin(), t.end());
    ups_mesh_desc mesh{};
    mesh.vertex_count = uint32_t(shape.vertices.size());
    mesh.triangle_count = uint32_t(shape.triangles.size());
    if (!shares_material_) material_ = description_.add_material(m), ++materials_;
    mesh.material = material_;
    mesh.positions_m = p.data(), mesh.indices = indices.data();
    if (!n.empty()) mesh.normals = n.data();
    ups_instance_desc instance{};
    instance.mesh = description_.add_mesh(mesh);
    place(instance.to_world, {});
    last_ = description_.add_instance(instance);
  }
  void share_material() { shares_material_ = true; }  // of what was added last, from now on
  void add_pane(const P3& corner, const P3& u, const P3& v, float transmittance) {
    ups_material_desc m = material(UPS_MATERIAL_GLAZING);
    std::fill_n(m.transmittance_rgb, 3, transmittance);
    add(quad(corner, u, v), m);
    const auto vec = [](const P3& a) { return Vec3d{a.x, a.y, a.z}; };
    panes_.push_back({vec(corner), vec(u), vec(v), materials_ - 1});
  }
  void add_light(ups_light_kind kind, const P3& p, float intensity, double tilt = 0, double turn = 0) {
    ups_light_desc light{};
    light.kind = kind;
    place(light.to_world, p, tilt, turn);
    std::fill_n(light.intensity_rgb, 3, intensity);
    light.outer_cone_rad = 0.8f;
    description_.add_light(light);
  }
  void add_luminaire(const P3& p, bool opening) {
    const std::string ies =
        "IESNA:LM-63-2002\n[TEST] -\n[TESTLAB] -\n[ISSUEDATE] -\n[MANUFAC] -\nTILT=NONE\n"
        "1 -1 1 5 1 1 2 0.3 0.4 0.15\n1 1 1\n0 25 50 75 90\n0\n300 280 190 60 0\n";  // a box
    ups_luminaire_desc luminaire{};
    luminaire.use_opening = opening;
    luminaire.flux_lm = -1;
    luminaire.dimming = luminaire.intensity_scale = 1;
    std::fill_n(luminaire.color_rgb, 3, 1.0f);
    place(luminaire.to_world, p);
    description_.add_luminaire(luminaire,
                               std::make_shared<photometry::Photometry>(photometry::read_ies(ies.data(), ies.size())));
  }
  void add_camera(const P3& p, uint32_t size, double tilt) {
    ups_camera_desc camera{};
    camera.width = camera.height = size;
    camera.vertical_fov_rad = 1.2f;
    camera.illuminance = 1;
    place(camera.to_world, p, tilt);
    description_.add_camera(camera);
  }
  void add_meters(const std::vector<double>& positions, const std::vector<float>& normals, float cell = 0,
                  bool discs = false, ups_meter_kind kind = UPS_METER_PLANAR) {
    std::vector<float> tangents;
    for (size_t i = 0; i < normals.size(); i += 3) tangents.insert(tangents.end(), {1, 0, 0});
    ups_meter_desc meters{};
    meters.kind = kind;
    meters.count = uint32_t(positions.size() / 3);
    meters.positions_m = positions.data(), meters.normals = normals.data();
    if (cell > 0) meters.tangents = tangents.data();
    if (discs)
      meters.footprint_m = cell;
    else
      meters.cell_size_m[0] = meters.cell_size_m[1] = cell;
    description_.add_meters(meters);
  }
  void add_surface_meters() {  // on what was added last
    ups_surface_meters_desc meters{};
    meters.instances = &last_;
    meters.instance_count = 1;
    description_.add_surface_meters(meters);
  }
  Room build() {
    ThreadPool pool(1);
    Room room{prepare(description_, pool), panes_};
    for (Pane& p : room.panes) p.corner = p.corner - room.scene->origin;
    return room;
  }

 private:
  static void place(double (&m)[12], const P3& p, double tilt = 0, double turn = 0) {  // about x, then z
    const double c = std::cos(tilt), s = std::sin(tilt), x = std::cos(turn), y = std::sin(turn),
                 at[12] = {x, -y * c, y * s, p.x, y, x * c, -x * s, p.y, 0, s, c, p.z};
    std::copy(std::begin(at), std::end(at), m);
  }
  Description description_;
  uint32_t materials_ = 0;
  ups_material_id material_{};
  bool shares_material_ = false;
  ups_instance_id last_{};
  std::vector<Pane> panes_;
};

enum class Cells { rectangles, discs, triangles };

// nested: glass within glass, so that media nest.
inline Room make_room(bool nested, Cells cells) {
  RoomBuilder b;
  const auto make = &RoomBuilder::material;
  const ups_material_desc matte = make(UPS_MATERIAL_MATTE, 0.6f, 0);
  b.add(quad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), matte);
  b.add(quad({0, 0, 3}, {0, 4, 0}, {4, 0, 0}), matte);
  b.add(quad({0, 0, 0}, {0, 4, 0}, {0, 0, 3}), matte);
  b.add(quad({4, 0, 0}, {0, 0, 3}, {0, 4, 0}), matte);
  b.add(quad({0, 4, 0}, {4, 0, 0}, {0, 0, 3}), matte);
  b.add_pane({0, 0, 0}, {4, 0, 0}, {0, 0, 3}, 0.8f);              // the window
  b.add_pane({0.9, 1.2, 2.3}, {1.5, 0, 0}, {0, 1.6, 0.1}, 0.6f);  // below the lamp
  b.add_pane({0.8, 1.1, 2.1}, {1.7, 0, 0}, {0, 1.8, 0.1}, 0.7f);  // and below that
  b.add_pane({0.6, 1.0, 0.4}, {0, 1.2, 0}, {0, 0, 0.8}, 0.7f);    // in the sun
  ups_material_desc lamp = make(UPS_MATERIAL_MATTE, 0.3f, 0);
  std::fill_n(lamp.luminance_cd_m2, 3, 4000.0f);
  b.add(quad({1.4, 1.7, 2.7}, {0, 0.5, 0}, {0.5, 0, 0}), lamp);
  std::fill_n(lamp.luminance_cd_m2, 3, 100.0f);
  b.add(quad({2.3, 1.8, 2.95}, {0, 1.9, 0}, {1.5, 0, 0}), lamp);
  std::fill_n(lamp.luminance_cd_m2, 3, 1500.0f);
  b.add(icosphere({0.5, 1.0, 2.0}, 0.15, 1), lamp);
  lamp.emits_both_sides = 1;
  b.add(quad({1.7, 3.2, 1.2}, {0.5, 0, 0.1}, {0, 0.1, 0.5}), lamp);
  b.add(quad({0.05, 0.5, 0.3}, {0, 2, 0}, {0, 0, 1.8}), make(UPS_MATERIAL_MIRROR, 0.85f, 0));
  const P3 center{2.6, 2.2, 0.9};
  Shape ball = icosphere(center, 0.4, 3);
  for (const P3& v : ball.vertices) ball.normals.push_back(normalize(v - center));
  b.add(ball, make(UPS_MATERIAL_GLASS, 1, 0));
  if (nested) {
    ups_material_desc core = make(UPS_MATERIAL_GLASS, 1, 0);
    core.ior = 1.8f;
    b.add(box(center - P3{0.15, 0.15, 0.15}, center + P3{0.15, 0.15, 0.15}), core);
  }
  b.add(box({3.0, 1.0, 0.3}, {3.4, 1.4, 0.8}), make(UPS_MATERIAL_GLASS, 1, 0.5f));
  b.add(quad({1.0, 3.6, 0.1}, {1.6, 0, 0}, {0, 0.3, 1.5}), make(UPS_MATERIAL_METAL, 0.8f, 0.42f));
  b.add(box({0.6, 2.6, 0.01}, {1.2, 3.2, 0.6}), make(UPS_MATERIAL_PLASTIC, 0.5f, 0));
  b.add(box({2.9, 3.0, 0.01}, {3.6, 3.6, 0.5}), make(UPS_MATERIAL_PLASTIC, 0.5f, 0.5f));
  ups_material_desc diffuser = make(UPS_MATERIAL_DIFFUSER, 0.3f, 0);
  std::fill_n(diffuser.transmittance_rgb, 3, 0.5f);
  b.add(quad({3.2, 1.8, 1.7}, {0.6, 0, 0.1}, {0, 0.8, 0}), diffuser);
  b.add_light(UPS_LIGHT_POINT, {3.3, 2.8, 2.2}, 100);
  b.add_light(UPS_LIGHT_SPOT, {1.8, 0.6, 2.8}, 300);
  b.add_light(UPS_LIGHT_DIRECTIONAL, {}, 30, 0.9, 0.5);  // through the window, to the mirror too
  b.add_luminaire({2.8, 1.2, 2.6}, true);
  b.add_luminaire({1.0, 3.0, 2.7}, false);
  b.add_camera({2, 0.4, 1.9}, 48, 1.25);
  b.add_meters({1.6, 2, 1, 2.6, 2.2, 0.3, 3.2, 1.2, 0.15, 2, 2, 1.6, 1.5, 1, 1.2, 2.6, 2.9, 0.5},
               {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0.3f, -1, -1, 0, 0.2f, 0, 0, 1});
  if (cells == Cells::triangles) {  // all of the same size
    b.add(quad({1.2, 1.7, 0.01}, {1.4, 0, 0}, {0.1, 0.9, 0}), matte);
    b.add_surface_meters();
  } else {
    b.add_meters({1.5, 1.5, 0.01, 2.6, 2.2, 0.01, 1.6, 2.8, 0.8}, {0, 0, 1, 0, 0, 1, 0, 0, 1}, 0.5f,
                 cells == Cells::discs);
  }
  for (const ups_meter_kind kind : {UPS_METER_CYLINDRICAL, UPS_METER_SEMICYLINDRICAL, UPS_METER_HEMISPHERICAL,
                                    UPS_METER_SPHERICAL, UPS_METER_VECTOR}) {
    b.add_meters({1.6, 2, 1, 2.6, 2.2, 0.3}, {0.2f, 0.1f, 1, 1, 0, 0.5f}, 0, false, kind);
    b.add_meters({1.5, 1.5, 0.6}, {0.3f, 0, 1}, 0.5f, cells == Cells::discs, kind);
  }
  return b.build();
}

}  // namespace ups::test
