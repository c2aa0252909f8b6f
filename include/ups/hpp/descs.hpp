// UPS for C++17: descriptions of what a scene has and of a render, filled with the defaults. See ups.hpp.
#ifndef UPS_HPP_DESCS_HPP
#define UPS_HPP_DESCS_HPP

#include "profile.hpp"
#include "transform.hpp"

namespace ups {
inline namespace v0_1 {

struct TextureDesc : ups_texture_desc {
  TextureDesc() noexcept { ups_texture_desc_init(this, sizeof(ups_texture_desc)); }
  // width * height * channels linear values, row 0 first, tight; 1, 3 or 4 channels.
  TextureDesc(std::uint32_t columns, std::uint32_t rows, std::uint32_t channels, Span<const float> values)
      : TextureDesc() {
    detail::expect(values.size(), std::size_t{columns} * rows * channels, "values");
    width = columns;
    height = rows;
    channel_count = channels;
    texels = values.data();
  }
};

struct MaterialDesc : ups_material_desc {
  MaterialDesc() noexcept { ups_material_desc_init(this, sizeof(ups_material_desc)); }
  // Grey of that reflectance, 0 to 1.
  explicit MaterialDesc(float reflectance) noexcept : MaterialDesc() {
    for (float &r : reflectance_rgb) r = reflectance;
  }
  // GLAZING, by angle of incidence, as the fields pane_*; without reflectances those of a clear pane.
  void set_pane(Span<const float> angles_deg, Span<const float> transmittances,
                Span<const float> reflectances = {}) {
    detail::expect(transmittances.size(), angles_deg.size(), "transmittances");
    pane_reflectance = detail::optional_array(reflectances, angles_deg.size(), "reflectances");
    pane_angle_count = detail::count(angles_deg.size(), 1, "angles_deg");
    pane_angle_deg = angles_deg.data();
    pane_transmittance = transmittances.data();
  }
};

struct MeshDesc : ups_mesh_desc {
  MeshDesc() noexcept { ups_mesh_desc_init(this, sizeof(ups_mesh_desc)); }
  // 3 values a vertex, 3 indices a triangle, counter-clockwise from its front.
  MeshDesc(Span<const float> positions, Span<const std::uint32_t> corners, ups_material_id of) : MeshDesc() {
    vertex_count = detail::count(positions.size(), 3, "positions");
    triangle_count = detail::count(corners.size(), 3, "corners");
    positions_m = positions.data();
    indices = corners.data();
    material = of;
  }
  // 3 values a vertex; 2 values; 4 values. An empty array: none.
  void set_normals(Span<const float> values) {
    normals = detail::optional_array(values, std::size_t{vertex_count} * 3, "normals");
  }
  void set_uvs(Span<const float> values) {
    uvs = detail::optional_array(values, std::size_t{vertex_count} * 2, "uvs");
  }
  void set_tangents(Span<const float> values) {
    tangents = detail::optional_array(values, std::size_t{vertex_count} * 4, "tangents");
  }
};

struct InstanceDesc : ups_instance_desc {
  InstanceDesc() noexcept { ups_instance_desc_init(this, sizeof(ups_instance_desc)); }
  InstanceDesc(ups_mesh_id of, const Transform &at = Transform()) noexcept : InstanceDesc() {
    mesh = of;
    at.copy_to(to_world);
  }
};

struct LightDesc : ups_light_desc {
  LightDesc() noexcept { ups_light_desc_init(this, sizeof(ups_light_desc)); }
  LightDesc(ups_light_kind of, const Transform &at) noexcept : LightDesc() {
    kind = of;
    at.copy_to(to_world);
  }
};

struct LuminaireDesc : ups_luminaire_desc {
  LuminaireDesc() noexcept { ups_luminaire_desc_init(this, sizeof(ups_luminaire_desc)); }
  // The profile must be there until the desc was used. One that was moved from is refused here: a desc without a profile
  // leaves a luminaire the one that it has.
  LuminaireDesc(const Profile &of, const Transform &at) : LuminaireDesc() {
    if (!of) throw Error(UPS_ERROR_INVALID_ARGUMENT, "LuminaireDesc: profile is NULL");
    profile = of.get();
    at.copy_to(to_world);
  }
};

struct CameraDesc : ups_camera_desc {
  CameraDesc() noexcept { ups_camera_desc_init(this, sizeof(ups_camera_desc)); }
  // Transform::look_at gives where it is.
  CameraDesc(std::uint32_t columns, std::uint32_t rows, const Transform &at) noexcept : CameraDesc() {
    width = columns;
    height = rows;
    at.copy_to(to_world);
  }
};

struct MeterDesc : ups_meter_desc {
  MeterDesc() noexcept { ups_meter_desc_init(this, sizeof(ups_meter_desc)); }
  // 3 values a meter in each.
  MeterDesc(Span<const double> positions, Span<const float> directions) : MeterDesc() {
    detail::expect(directions.size(), positions.size(), "directions");
    count = detail::count(positions.size(), 3, "positions");
    positions_m = positions.data();
    normals = directions.data();
  }
  // Means over rectangles: the first side's direction, 3 values a meter, and the sides' lengths.
  void set_cells(Span<const float> first_sides, float along_m, float across_m) {
    detail::expect(first_sides.size(), std::size_t{count} * 3, "first_sides");
    tangents = first_sides.data();
    cell_size_m[0] = along_m;
    cell_size_m[1] = across_m;
  }
};

struct SurfaceMetersDesc : ups_surface_meters_desc {
  SurfaceMetersDesc() noexcept { ups_surface_meters_desc_init(this, sizeof(ups_surface_meters_desc)); }
  explicit SurfaceMetersDesc(Span<const ups_instance_id> of) : SurfaceMetersDesc() {
    instance_count = detail::count(of.size(), 1, "instances");
    instances = of.data();
  }
};

struct LightmapDesc : ups_lightmap_desc {
  LightmapDesc() noexcept { ups_lightmap_desc_init(this, sizeof(ups_lightmap_desc)); }
  LightmapDesc(Span<const ups_instance_id> of, std::uint32_t columns, std::uint32_t rows) : LightmapDesc() {
    instance_count = detail::count(of.size(), 1, "instances");
    instances = of.data();
    width = columns;
    height = rows;
  }
};

struct GoniometerDesc : ups_goniometer_desc {
  GoniometerDesc() noexcept { ups_goniometer_desc_init(this, sizeof(ups_goniometer_desc)); }
  GoniometerDesc(Span<const float> c_planes_deg, Span<const float> gammas_deg) : GoniometerDesc() {
    c_count = detail::count(c_planes_deg.size(), 1, "c_planes_deg");
    gamma_count = detail::count(gammas_deg.size(), 1, "gammas_deg");
    c_deg = c_planes_deg.data();
    gamma_deg = gammas_deg.data();
  }
};

struct ObserverDesc : ups_observer_desc {
  ObserverDesc() noexcept { ups_observer_desc_init(this, sizeof(ups_observer_desc)); }
  // Transform::look_at gives where the eye is.
  explicit ObserverDesc(const Transform &at) noexcept : ObserverDesc() { at.copy_to(to_world); }
};

struct CommitDesc : ups_commit_desc {
  CommitDesc() noexcept { ups_commit_desc_init(this, sizeof(ups_commit_desc)); }
};

struct RenderDesc : ups_render_desc {
  RenderDesc() noexcept { ups_render_desc_init(this, sizeof(ups_render_desc)); }
};

}  // namespace v0_1
}  // namespace ups

#endif
