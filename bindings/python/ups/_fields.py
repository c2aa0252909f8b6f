"""The keyword arguments that stand for C descriptions, for type checkers alone: no program imports this.
Written by bindings/generate.py from include/ups; do not edit.
"""
from typing import SupportsFloat, SupportsIndex, TypedDict

from numpy.typing import ArrayLike

from . import _ffi


class ContextDescFields(TypedDict, total=False):
    thread_count: SupportsIndex


class ProfileDescFields(TypedDict, total=False):
    opening_shape: SupportsIndex
    opening_m: ArrayLike
    opening_axis: SupportsIndex
    input_power_w: SupportsFloat


class ProfileParseDescFields(TypedDict, total=False):
    tilt_deg: SupportsFloat
    lamp_set: SupportsIndex


class TextureDescFields(TypedDict, total=False):
    width: SupportsIndex
    height: SupportsIndex
    channel_count: SupportsIndex
    row_stride_bytes: SupportsIndex


class MaterialDescFields(TypedDict, total=False):
    model: SupportsIndex
    reflectance_rgb: ArrayLike
    transmittance_rgb: ArrayLike
    roughness: SupportsFloat
    ior: SupportsFloat
    ior_rgb: ArrayLike
    ior_k_rgb: ArrayLike
    absorption_per_m_rgb: ArrayLike
    metallic: SupportsFloat
    alpha_mode: SupportsIndex
    alpha: SupportsFloat
    alpha_cutoff: SupportsFloat
    luminance_cd_m2: ArrayLike
    emits_both_sides: SupportsIndex
    normal_scale: SupportsFloat
    reflectance_texture: _ffi.TextureId
    roughness_texture: _ffi.TextureId
    metallic_texture: _ffi.TextureId
    normal_texture: _ffi.TextureId
    alpha_texture: _ffi.TextureId
    priority: SupportsIndex


class MeshDescFields(TypedDict, total=False):
    vertex_count: SupportsIndex
    triangle_count: SupportsIndex
    material: _ffi.MaterialId
    position_stride_bytes: SupportsIndex
    normal_stride_bytes: SupportsIndex
    uv_stride_bytes: SupportsIndex
    tangent_stride_bytes: SupportsIndex


class InstanceDescFields(TypedDict, total=False):
    to_world: ArrayLike
    group: SupportsIndex


class LightDescFields(TypedDict, total=False):
    kind: SupportsIndex
    to_world: ArrayLike
    intensity_rgb: ArrayLike
    inner_cone_rad: SupportsFloat
    outer_cone_rad: SupportsFloat
    group: SupportsIndex


class LuminaireDescFields(TypedDict, total=False):
    use_opening: SupportsIndex
    to_world: ArrayLike
    color_rgb: ArrayLike
    flux_lm: SupportsFloat
    dimming: SupportsFloat
    intensity_scale: SupportsFloat
    group: SupportsIndex


class CommitDescFields(TypedDict, total=False):
    thread_limit: SupportsIndex
    priority: SupportsIndex
    memory_limit_bytes: SupportsIndex


class FixtureEmitterDescFields(TypedDict, total=False):
    shape: SupportsIndex
    to_fixture: ArrayLike
    radius_m: SupportsFloat
    width_m: SupportsFloat
    length_m: SupportsFloat
    chord_tolerance_m: SupportsFloat
    flux_lm: SupportsFloat
    color_rgb: ArrayLike
    reflectance: SupportsFloat


class ReflectorDescFields(TypedDict, total=False):
    profile: SupportsIndex
    to_fixture: ArrayLike
    focal_length_m: SupportsFloat
    semi_axis_m: SupportsFloat
    half_distance_m: SupportsFloat
    inner_radius_m: SupportsFloat
    aperture_radius_m: SupportsFloat
    depth_m: SupportsFloat
    smooth: SupportsIndex
    facets_around: SupportsIndex
    facets_along: SupportsIndex
    chord_tolerance_m: SupportsFloat
    normal_tolerance_rad: SupportsFloat
    finish: SupportsIndex
    finish_reflectance: SupportsFloat
    finish_transmittance: SupportsFloat
    finish_roughness: SupportsFloat


class LensDescFields(TypedDict, total=False):
    finish: SupportsIndex
    to_fixture: ArrayLike
    radius_m: SupportsFloat
    thickness_m: SupportsFloat
    entry_radius_m: SupportsFloat
    entry_conic: SupportsFloat
    entry_coefficients: ArrayLike
    exit_radius_m: SupportsFloat
    exit_conic: SupportsFloat
    exit_coefficients: ArrayLike
    chord_tolerance_m: SupportsFloat
    normal_tolerance_rad: SupportsFloat
    facets_around: SupportsIndex
    finish_roughness: SupportsFloat
    finish_absorption_per_m: SupportsFloat
    finish_ior: SupportsFloat


class CollimatorDescFields(TypedDict, total=False):
    finish: SupportsIndex
    to_fixture: ArrayLike
    cavity_radius_m: SupportsFloat
    cavity_depth_m: SupportsFloat
    lens_radius_m: SupportsFloat
    lens_conic: SupportsFloat
    wall: SupportsIndex
    smooth: SupportsIndex
    wall_thickness_m: SupportsFloat
    wall_focal_length_m: SupportsFloat
    height_m: SupportsFloat
    facets_around: SupportsIndex
    exit_radius_m: SupportsFloat
    exit_conic: SupportsFloat
    chord_tolerance_m: SupportsFloat
    normal_tolerance_rad: SupportsFloat
    exit_facets_along: SupportsIndex
    finish_roughness: SupportsFloat
    finish_absorption_per_m: SupportsFloat
    finish_ior: SupportsFloat


class FixturePartDescFields(TypedDict, total=False):
    finish: SupportsIndex
    to_fixture: ArrayLike
    finish_reflectance: SupportsFloat
    finish_transmittance: SupportsFloat
    finish_roughness: SupportsFloat
    finish_absorption_per_m: SupportsFloat
    finish_ior: SupportsFloat


class FixtureInstanceDescFields(TypedDict, total=False):
    dimming: SupportsFloat
    to_world: ArrayLike
    flux_lm: SupportsFloat
    group: SupportsIndex


class CameraDescFields(TypedDict, total=False):
    projection: SupportsIndex
    to_world: ArrayLike
    vertical_fov_rad: SupportsFloat
    illuminance: SupportsIndex
    layers: SupportsIndex


class MeterDescFields(TypedDict, total=False):
    kind: SupportsIndex
    cell_size_m: ArrayLike
    footprint_m: SupportsFloat


class SurfaceMetersDescFields(TypedDict, total=False):
    back: SupportsIndex


class LightmapDescFields(TypedDict, total=False):
    back: SupportsIndex


class En12464DescFields(TypedDict, total=False):
    corner_count: SupportsIndex
    hole_count: SupportsIndex
    border_m: SupportsFloat


class GoniometerDescFields(TypedDict, total=False):
    symmetry: SupportsIndex
    c_count: SupportsIndex
    gamma_count: SupportsIndex
    to_world: ArrayLike
    opening_shape: SupportsIndex
    opening_m: ArrayLike


class RenderDescFields(TypedDict, total=False):
    method: SupportsIndex
    seed: SupportsIndex
    time_limit_s: SupportsFloat
    target_relative_error: SupportsFloat
    merge_radius_m: SupportsFloat
    iteration_count: SupportsIndex
    max_path_length: SupportsIndex
    light_paths_per_iteration: SupportsIndex
    techniques: SupportsIndex
    radius_alpha: SupportsFloat
    glossy_alpha: SupportsFloat
    perturbation: SupportsIndex
    technique_images: SupportsIndex
    separation: SupportsIndex
    flux_paths: SupportsIndex
    target_criterion: SupportsIndex
    memory_limit_bytes: SupportsIndex
    thread_limit: SupportsIndex
    priority: SupportsIndex


class ObserverDescFields(TypedDict, total=False):
    metric: SupportsIndex
    position_index: SupportsIndex
    ceiling_area_m2: SupportsFloat
    to_world: ArrayLike


class GltfImportDescFields(TypedDict, total=False):
    camera_width: SupportsIndex
    camera_height: SupportsIndex
    allow_outside: SupportsIndex
    camera_layers: SupportsIndex


class OcioPictureDescFields(TypedDict, total=False):
    width: SupportsIndex
    height: SupportsIndex
    smoothed: SupportsIndex
    exposure: SupportsFloat
    exposure_chosen: SupportsIndex


class OcioSmoothDescFields(TypedDict, total=False):
    width: SupportsIndex
    height: SupportsIndex


class OcioFalseColorDescFields(TypedDict, total=False):
    columns: SupportsIndex
    rows: SupportsIndex
    first_row_at_bottom: SupportsIndex
    scale_min: SupportsFloat
    scale_max: SupportsFloat


class ReportStyleDescFields(TypedDict, total=False):
    scale: SupportsIndex
    colours: SupportsIndex
    isolines: SupportsIndex
    numbers: SupportsIndex
    cells: SupportsIndex
    low: SupportsFloat
    high: SupportsFloat
    threshold_lx: SupportsFloat
    threshold_cd_m2: SupportsFloat
    width: SupportsFloat
    height: SupportsFloat
    zoom: SupportsFloat


class ReportMapDescFields(TypedDict, total=False):
    quantity: SupportsIndex
    sensor: _ffi.SensorId
    sensor_count: SupportsIndex
    count: SupportsIndex
    columns: SupportsIndex


class ReportPageDescFields(TypedDict, total=False):
    sensor_count: SupportsIndex
    source_count: SupportsIndex
    picture_count: SupportsIndex
    threshold_count: SupportsIndex
    ratio_count: SupportsIndex
    target_relative_error: SupportsFloat
