"""The C API of UPS as ctypes. Written by bindings/generate.py from include/ups; do not edit."""
from __future__ import annotations

import enum
from ctypes import (POINTER, Array, Structure, c_char_p, c_double, c_float, c_int32, c_size_t, c_uint8,
                    c_uint32, c_uint64, c_void_p)
from typing import Any

from ._id import Id

HEADER_VERSION = (0, 1, 0)


class Status(enum.IntEnum):
    OK = 0
    ERROR_INTERNAL = -1
    ERROR_INVALID_ARGUMENT = -2
    ERROR_INVALID_STATE = -3
    ERROR_OUT_OF_MEMORY = -4
    ERROR_PARSE = -5
    ERROR_UNSUPPORTED = -6
    ERROR_BUFFER_TOO_SMALL = -7
    ERROR_IO = -8
    TIMEOUT = 1
    CANCELLED = 2


class Priority(enum.IntEnum):
    NORMAL = 0
    LOW = 1


class LogLevel(enum.IntEnum):
    INFO = 0
    WARNING = 1


class ProfileFormat(enum.IntEnum):
    AUTO = 0
    IES_LM63 = 1
    EULUMDAT = 2
    TM33_XML = 3
    TM25_RAYS = 4
    ZEMAX_RAYS = 5
    LIGHTTOOLS_RAYS = 6


class OpeningShape(enum.IntEnum):
    POINT = 0
    RECTANGLE = 1
    DISC = 2
    BOX = 3
    CYLINDER = 4
    SPHERE = 5


class ProfileSymmetry(enum.IntEnum):
    NONE = 0
    AXIAL = 1
    C0_C180 = 2
    C90_C270 = 3
    QUADRANTS = 4


class PhotometricType(enum.IntEnum):
    C = 0
    B = 1
    A = 2


class ProfileText(enum.IntEnum):
    WARNINGS = 0
    KEYWORDS = 1
    FORMAT = 2
    TILT_FILE = 3
    TILT_TABLE = 4
    LAMP_TYPES = 5
    LAMP_COLOURS = 6
    LAMP_RENDERINGS = 7


class MaterialModel(enum.IntEnum):
    MATTE = 0
    PLASTIC = 1
    METAL = 2
    MIRROR = 3
    GLASS = 4
    GLAZING = 5
    DIFFUSER = 6


class AlphaMode(enum.IntEnum):
    OPAQUE = 0
    MASK = 1
    BLEND = 2


class LightKind(enum.IntEnum):
    POINT = 0
    SPOT = 1
    DIRECTIONAL = 2


class Effect(enum.IntFlag):
    SPECULAR_REFLECTION = 1
    TRANSMISSION = 2
    CAUSTICS = 4
    GLOSSY = 8
    INTERREFLECTION = 16
    COLOUR = 32
    TEXTURES = 64


class SceneText(enum.IntEnum):
    WARNINGS = 0
    EFFECTS = 1
    TECHNIQUES = 2


class Finish(enum.IntEnum):
    SPECULAR_ALUMINIUM = 0
    ENHANCED_ALUMINIUM = 1
    SEMI_SPECULAR_ALUMINIUM = 2
    MATTE_WHITE = 3
    BLACK = 4
    OPAL = 5
    PMMA = 6
    POLYCARBONATE = 7
    GLASS = 8
    FROSTED_PMMA = 9
    CUSTOM = 10


class EmitterShape(enum.IntEnum):
    DISC = 0
    RECTANGLE = 1
    SPHERE = 2
    CYLINDER = 3


class ReflectorProfile(enum.IntEnum):
    PARABOLOID = 0
    ELLIPSOID = 1
    CONE = 2
    CYLINDER = 3
    POLYLINE = 4


class CollimatorWall(enum.IntEnum):
    PARALLEL = 0
    PARABOLOID = 1
    POLYLINE = 2


class Projection(enum.IntEnum):
    PERSPECTIVE = 0
    EQUIDISTANT = 1
    EQUISOLID = 2
    PANORAMA = 3


class Layer(enum.IntFlag):
    ALBEDO = 1
    NORMAL = 2
    DEPTH = 4
    ID = 8


class MeterKind(enum.IntEnum):
    PLANAR = 0
    CYLINDRICAL = 1
    SEMICYLINDRICAL = 2
    HEMISPHERICAL = 3
    SPHERICAL = 4
    VECTOR = 5


class Method(enum.IntEnum):
    AUTO = 0
    UPS = 1
    PATH_TRACING = 2
    LIGHT_TRACING = 3
    BIDIRECTIONAL = 4
    PPM = 5
    SPPM = 6
    BIDIRECTIONAL_PHOTON_MAPPING = 7


class Technique(enum.IntFlag):
    EMITTER_HIT = 1
    LIGHT_SAMPLE = 2
    CONNECT = 4
    SENSOR_CONNECT = 8
    MERGE = 16
    SENSOR_HIT = 32
    MIRROR_SAMPLE = 64


class Perturbation(enum.IntEnum):
    VIRTUAL = 0
    ACTUAL = 1


class Separation(enum.IntEnum):
    NOTHING = 0
    LUMINAIRES = 1
    GROUPS = 2


class Criterion(enum.IntEnum):
    DEFAULT = 0
    WORST = 1
    P95 = 2
    MEAN = 3
    MEDIAN = 4


class JobState(enum.IntEnum):
    RUNNING = 0
    FINISHED = 1
    CANCELLED = 2
    FAILED = 3


class Reading(enum.IntFlag):
    EXACT = 1
    UNKNOWN = 2
    FEW_PATHS = 4
    SINGLE_PATH = 8
    HEAVY_TAIL = 16


class Limit(enum.IntEnum):
    UNKNOWN = 0
    NOISE = 1
    BIAS = 2


class Photons(enum.IntEnum):
    NONE = 0
    CAUSTIC = 1
    ALL = 2


class LightPart(enum.IntEnum):
    DIRECT = 0
    INDIRECT = 1
    ALL = 2


class SourceKind(enum.IntEnum):
    LUMINAIRE = 0
    INSTANCE = 1
    GROUP = 2


class Channel(enum.IntEnum):
    LUMINANCE_RGB = 0
    STANDARD_ERROR_RGB = 1
    ILLUMINANCE = 2
    PATH_INTEGRATION_RGB = 3
    DENSITY_ESTIMATION_RGB = 4
    BIAS = 5
    ERROR_BOUND = 6
    ROBUST_RGB = 7
    ILLUMINANCE_STANDARD_ERROR = 8
    ALBEDO_RGB = 9
    NORMAL = 10
    DEPTH = 11
    ID = 12
    ILLUMINANCE_BIAS = 13
    ILLUMINANCE_ERROR_BOUND = 14


class Contribution(enum.IntEnum):
    WEIGHTED = 0
    UNWEIGHTED = 1


class ResultText(enum.IntEnum):
    WARNINGS = 0
    EFFECTS = 1
    TECHNIQUES = 2
    DROPPED = 3


class Walk(enum.IntEnum):
    EYE = 0
    LIGHT = 1


class PathEvent(enum.IntEnum):
    START = 0
    END = 1
    SCATTERED = 2
    MIRRORED = 3
    REFRACTED = 4


class PositionIndex(enum.IntEnum):
    TABLE = 0
    GUTH = 1


class GlareMetric(enum.IntEnum):
    GLARE_METRIC_UGR = 0


class Observer(enum.IntFlag):
    NO_SOURCE = 1
    NO_BACKGROUND = 2
    LARGE_SOURCE = 4
    POINT_SOURCE = 8
    UNRATED_SOURCE = 16
    FIXTURE = 32
    COVERED_SOURCE = 64


class GlareFlag(enum.IntFlag):
    SMALL = 1
    POINT = 2
    LARGE = 4
    HIDDEN = 8


class GltfSensorKind(enum.IntEnum):
    CAMERA = 0
    METERS = 1
    GONIOMETER = 2
    OBSERVER = 3


class GltfLayout(enum.IntEnum):
    POINTS = 0
    GRID = 1
    EN12464 = 2
    LINE = 3
    SURFACE = 4
    LIGHTMAP = 5


class GltfPart(enum.IntEnum):
    MATERIAL = 0
    MESH = 1
    INSTANCE = 2
    LUMINAIRE = 3
    FIXTURE = 4


class ReportScale(enum.IntEnum):
    LINEAR = 0
    LOGARITHMIC = 1


class ReportColours(enum.IntEnum):
    VIRIDIS = 0
    CIVIDIS = 1
    GREY = 2


class ReportQuantity(enum.IntEnum):
    AUTO = 0
    ILLUMINANCE = 1
    LUMINANCE = 2


class ReportExposure(enum.IntEnum):
    UNTOLD = 0
    CHOSEN = 1
    GIVEN = 2


class TextureId(Id, Structure):
    v: int
    _fields_ = [
        ("v", c_uint32),
    ]


class MaterialId(Id, Structure):
    v: int
    _fields_ = [
        ("v", c_uint32),
    ]


class MeshId(Id, Structure):
    v: int
    _fields_ = [
        ("v", c_uint32),
    ]


class InstanceId(Id, Structure):
    v: int
    _fields_ = [
        ("v", c_uint32),
    ]


class LuminaireId(Id, Structure):
    v: int
    _fields_ = [
        ("v", c_uint32),
    ]


class SensorId(Id, Structure):
    v: int
    _fields_ = [
        ("v", c_uint32),
    ]


class ContextDesc(Structure):
    struct_size: int
    thread_count: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("thread_count", c_int32),
    ]


class ProfileDesc(Structure):
    struct_size: int
    c_count: int
    gamma_count: int
    reserved: int
    c_deg: Any
    gamma_deg: Any
    intensity_cd: Any
    opening_shape: int
    opening_m: Array[c_float]
    opening_axis: int
    input_power_w: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("c_count", c_uint32),
        ("gamma_count", c_uint32),
        ("reserved", c_uint32),
        ("c_deg", POINTER(c_float)),
        ("gamma_deg", POINTER(c_float)),
        ("intensity_cd", POINTER(c_float)),
        ("opening_shape", c_int32),
        ("opening_m", c_float * 3),
        ("opening_axis", c_int32),
        ("input_power_w", c_float),
    ]


class ProfileParseDesc(Structure):
    struct_size: int
    format: int
    bytes: Any
    size: int
    tilt_file: Any
    tilt_file_size: int
    tilt_deg: float
    lamp_set: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("format", c_int32),
        ("bytes", c_void_p),
        ("size", c_size_t),
        ("tilt_file", c_void_p),
        ("tilt_file_size", c_size_t),
        ("tilt_deg", c_float),
        ("lamp_set", c_uint32),
    ]


class ProfileInfo(Structure):
    struct_size: int
    warning_count: int
    flux_lm: float
    interpolated_flux_lm: float
    rated_flux_lm: float
    input_power_w: float
    peak_cd: float
    peak_c_deg: float
    peak_gamma_deg: float
    opening_m: Array[c_float]
    opening_shape: int
    symmetry: int
    c_count: int
    gamma_count: int
    photometric_type: int
    ray_count: int
    up_flux_lm: float
    down_flux_lm: float
    light_output_ratio: float
    beam_angle_deg: Array[c_float]
    field_angle_deg: Array[c_float]
    opening_axis: int
    lamp_set_count: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("warning_count", c_uint32),
        ("flux_lm", c_double),
        ("interpolated_flux_lm", c_double),
        ("rated_flux_lm", c_double),
        ("input_power_w", c_double),
        ("peak_cd", c_float),
        ("peak_c_deg", c_float),
        ("peak_gamma_deg", c_float),
        ("opening_m", c_float * 3),
        ("opening_shape", c_int32),
        ("symmetry", c_int32),
        ("c_count", c_uint32),
        ("gamma_count", c_uint32),
        ("photometric_type", c_int32),
        ("ray_count", c_uint32),
        ("up_flux_lm", c_double),
        ("down_flux_lm", c_double),
        ("light_output_ratio", c_double),
        ("beam_angle_deg", c_float * 2),
        ("field_angle_deg", c_float * 2),
        ("opening_axis", c_int32),
        ("lamp_set_count", c_uint32),
    ]


class ProfileBeam(Structure):
    struct_size: int
    peak_cd: float
    peak_deg: float
    from_deg: float
    to_deg: float
    angle_deg: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("peak_cd", c_float),
        ("peak_deg", c_float),
        ("from_deg", c_float),
        ("to_deg", c_float),
        ("angle_deg", c_float),
    ]


class ProfileLampSet(Structure):
    struct_size: int
    count: int
    flux_lm: float
    input_power_w: float
    colour_temperature_k: float
    colour_rendering_index: float
    chosen: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("count", c_int32),
        ("flux_lm", c_double),
        ("input_power_w", c_float),
        ("colour_temperature_k", c_float),
        ("colour_rendering_index", c_float),
        ("chosen", c_int32),
    ]


class TextureDesc(Structure):
    struct_size: int
    width: int
    height: int
    channel_count: int
    texels: Any
    row_stride_bytes: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("channel_count", c_uint32),
        ("texels", POINTER(c_float)),
        ("row_stride_bytes", c_size_t),
    ]


class MaterialDesc(Structure):
    struct_size: int
    model: int
    reflectance_rgb: Array[c_float]
    transmittance_rgb: Array[c_float]
    roughness: float
    ior: float
    ior_rgb: Array[c_float]
    ior_k_rgb: Array[c_float]
    absorption_per_m_rgb: Array[c_float]
    metallic: float
    alpha_mode: int
    alpha: float
    alpha_cutoff: float
    luminance_cd_m2: Array[c_float]
    emits_both_sides: int
    normal_scale: float
    reflectance_texture: TextureId
    roughness_texture: TextureId
    metallic_texture: TextureId
    normal_texture: TextureId
    alpha_texture: TextureId
    priority: int
    pane_angle_deg: Any
    pane_transmittance: Any
    pane_reflectance: Any
    pane_angle_count: int
    reserved: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("model", c_int32),
        ("reflectance_rgb", c_float * 3),
        ("transmittance_rgb", c_float * 3),
        ("roughness", c_float),
        ("ior", c_float),
        ("ior_rgb", c_float * 3),
        ("ior_k_rgb", c_float * 3),
        ("absorption_per_m_rgb", c_float * 3),
        ("metallic", c_float),
        ("alpha_mode", c_int32),
        ("alpha", c_float),
        ("alpha_cutoff", c_float),
        ("luminance_cd_m2", c_float * 3),
        ("emits_both_sides", c_int32),
        ("normal_scale", c_float),
        ("reflectance_texture", TextureId),
        ("roughness_texture", TextureId),
        ("metallic_texture", TextureId),
        ("normal_texture", TextureId),
        ("alpha_texture", TextureId),
        ("priority", c_int32),
        ("pane_angle_deg", POINTER(c_float)),
        ("pane_transmittance", POINTER(c_float)),
        ("pane_reflectance", POINTER(c_float)),
        ("pane_angle_count", c_uint32),
        ("reserved", c_uint32),
    ]


class MeshDesc(Structure):
    struct_size: int
    vertex_count: int
    triangle_count: int
    material: MaterialId
    positions_m: Any
    position_stride_bytes: int
    normals: Any
    normal_stride_bytes: int
    uvs: Any
    uv_stride_bytes: int
    tangents: Any
    tangent_stride_bytes: int
    indices: Any
    _fields_ = [
        ("struct_size", c_uint32),
        ("vertex_count", c_uint32),
        ("triangle_count", c_uint32),
        ("material", MaterialId),
        ("positions_m", POINTER(c_float)),
        ("position_stride_bytes", c_size_t),
        ("normals", POINTER(c_float)),
        ("normal_stride_bytes", c_size_t),
        ("uvs", POINTER(c_float)),
        ("uv_stride_bytes", c_size_t),
        ("tangents", POINTER(c_float)),
        ("tangent_stride_bytes", c_size_t),
        ("indices", POINTER(c_uint32)),
    ]


class InstanceDesc(Structure):
    struct_size: int
    mesh: MeshId
    to_world: Array[c_double]
    group: int
    reserved: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("mesh", MeshId),
        ("to_world", c_double * 12),
        ("group", c_uint32),
        ("reserved", c_uint32),
    ]


class LightDesc(Structure):
    struct_size: int
    kind: int
    to_world: Array[c_double]
    intensity_rgb: Array[c_float]
    inner_cone_rad: float
    outer_cone_rad: float
    group: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("to_world", c_double * 12),
        ("intensity_rgb", c_float * 3),
        ("inner_cone_rad", c_float),
        ("outer_cone_rad", c_float),
        ("group", c_uint32),
    ]


class LuminaireDesc(Structure):
    struct_size: int
    use_opening: int
    profile: Any
    to_world: Array[c_double]
    color_rgb: Array[c_float]
    flux_lm: float
    dimming: float
    intensity_scale: float
    group: int
    reserved: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("use_opening", c_int32),
        ("profile", c_void_p),
        ("to_world", c_double * 12),
        ("color_rgb", c_float * 3),
        ("flux_lm", c_float),
        ("dimming", c_float),
        ("intensity_scale", c_float),
        ("group", c_uint32),
        ("reserved", c_uint32),
    ]


class CommitDesc(Structure):
    struct_size: int
    thread_limit: int
    priority: int
    reserved: int
    memory_limit_bytes: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("thread_limit", c_uint32),
        ("priority", c_int32),
        ("reserved", c_uint32),
        ("memory_limit_bytes", c_uint64),
    ]


class SceneInfo(Structure):
    struct_size: int
    effects: int
    techniques: int
    method: int
    triangle_count: int
    luminaire_count: int
    light_count: int
    emissive_instance_count: int
    meter_count: int
    pixel_count: int
    emitted_flux_lm: float
    bounds_min_m: Array[c_double]
    bounds_max_m: Array[c_double]
    maintenance_factor: float
    revision: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("effects", c_uint32),
        ("techniques", c_uint32),
        ("method", c_int32),
        ("triangle_count", c_uint64),
        ("luminaire_count", c_uint64),
        ("light_count", c_uint64),
        ("emissive_instance_count", c_uint64),
        ("meter_count", c_uint64),
        ("pixel_count", c_uint64),
        ("emitted_flux_lm", c_double),
        ("bounds_min_m", c_double * 3),
        ("bounds_max_m", c_double * 3),
        ("maintenance_factor", c_double),
        ("revision", c_uint64),
    ]


class Segment(Structure):
    from_m: Array[c_double]
    to_m: Array[c_double]
    _fields_ = [
        ("from_m", c_double * 3),
        ("to_m", c_double * 3),
    ]


class FixturePartId(Id, Structure):
    v: int
    _fields_ = [
        ("v", c_uint32),
    ]


class FixtureId(Id, Structure):
    v: int
    _fields_ = [
        ("v", c_uint32),
    ]


class FixtureEmitterDesc(Structure):
    struct_size: int
    shape: int
    to_fixture: Array[c_double]
    radius_m: float
    width_m: float
    length_m: float
    chord_tolerance_m: float
    flux_lm: float
    color_rgb: Array[c_float]
    reflectance: float
    reserved: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("shape", c_int32),
        ("to_fixture", c_double * 12),
        ("radius_m", c_double),
        ("width_m", c_double),
        ("length_m", c_double),
        ("chord_tolerance_m", c_double),
        ("flux_lm", c_float),
        ("color_rgb", c_float * 3),
        ("reflectance", c_float),
        ("reserved", c_float),
    ]


class ReflectorDesc(Structure):
    struct_size: int
    profile: int
    to_fixture: Array[c_double]
    focal_length_m: float
    semi_axis_m: float
    half_distance_m: float
    inner_radius_m: float
    aperture_radius_m: float
    depth_m: float
    profile_rz_m: Any
    profile_point_count: int
    smooth: int
    facets_around: int
    facets_along: int
    chord_tolerance_m: float
    normal_tolerance_rad: float
    finish: int
    finish_reflectance: float
    finish_transmittance: float
    finish_roughness: float
    material: Any
    _fields_ = [
        ("struct_size", c_uint32),
        ("profile", c_int32),
        ("to_fixture", c_double * 12),
        ("focal_length_m", c_double),
        ("semi_axis_m", c_double),
        ("half_distance_m", c_double),
        ("inner_radius_m", c_double),
        ("aperture_radius_m", c_double),
        ("depth_m", c_double),
        ("profile_rz_m", POINTER(c_double)),
        ("profile_point_count", c_uint32),
        ("smooth", c_int32),
        ("facets_around", c_uint32),
        ("facets_along", c_uint32),
        ("chord_tolerance_m", c_double),
        ("normal_tolerance_rad", c_double),
        ("finish", c_int32),
        ("finish_reflectance", c_float),
        ("finish_transmittance", c_float),
        ("finish_roughness", c_float),
        ("material", POINTER(MaterialDesc)),
    ]


class LensDesc(Structure):
    struct_size: int
    finish: int
    to_fixture: Array[c_double]
    radius_m: float
    thickness_m: float
    entry_radius_m: float
    entry_conic: float
    entry_coefficients: Array[c_double]
    exit_radius_m: float
    exit_conic: float
    exit_coefficients: Array[c_double]
    chord_tolerance_m: float
    normal_tolerance_rad: float
    facets_around: int
    finish_roughness: float
    finish_absorption_per_m: float
    finish_ior: float
    material: Any
    _fields_ = [
        ("struct_size", c_uint32),
        ("finish", c_int32),
        ("to_fixture", c_double * 12),
        ("radius_m", c_double),
        ("thickness_m", c_double),
        ("entry_radius_m", c_double),
        ("entry_conic", c_double),
        ("entry_coefficients", c_double * 4),
        ("exit_radius_m", c_double),
        ("exit_conic", c_double),
        ("exit_coefficients", c_double * 4),
        ("chord_tolerance_m", c_double),
        ("normal_tolerance_rad", c_double),
        ("facets_around", c_uint32),
        ("finish_roughness", c_float),
        ("finish_absorption_per_m", c_float),
        ("finish_ior", c_float),
        ("material", POINTER(MaterialDesc)),
    ]


class CollimatorDesc(Structure):
    struct_size: int
    finish: int
    to_fixture: Array[c_double]
    cavity_radius_m: float
    cavity_depth_m: float
    lens_radius_m: float
    lens_conic: float
    wall: int
    smooth: int
    wall_thickness_m: float
    wall_focal_length_m: float
    height_m: float
    wall_rz_m: Any
    wall_point_count: int
    facets_around: int
    exit_radius_m: float
    exit_conic: float
    chord_tolerance_m: float
    normal_tolerance_rad: float
    exit_facets_along: int
    finish_roughness: float
    finish_absorption_per_m: float
    finish_ior: float
    material: Any
    _fields_ = [
        ("struct_size", c_uint32),
        ("finish", c_int32),
        ("to_fixture", c_double * 12),
        ("cavity_radius_m", c_double),
        ("cavity_depth_m", c_double),
        ("lens_radius_m", c_double),
        ("lens_conic", c_double),
        ("wall", c_int32),
        ("smooth", c_int32),
        ("wall_thickness_m", c_double),
        ("wall_focal_length_m", c_double),
        ("height_m", c_double),
        ("wall_rz_m", POINTER(c_double)),
        ("wall_point_count", c_uint32),
        ("facets_around", c_uint32),
        ("exit_radius_m", c_double),
        ("exit_conic", c_double),
        ("chord_tolerance_m", c_double),
        ("normal_tolerance_rad", c_double),
        ("exit_facets_along", c_uint32),
        ("finish_roughness", c_float),
        ("finish_absorption_per_m", c_float),
        ("finish_ior", c_float),
        ("material", POINTER(MaterialDesc)),
    ]


class FixturePartDesc(Structure):
    struct_size: int
    finish: int
    to_fixture: Array[c_double]
    mesh: Any
    finish_reflectance: float
    finish_transmittance: float
    finish_roughness: float
    finish_absorption_per_m: float
    finish_ior: float
    reserved: float
    material: Any
    _fields_ = [
        ("struct_size", c_uint32),
        ("finish", c_int32),
        ("to_fixture", c_double * 12),
        ("mesh", POINTER(MeshDesc)),
        ("finish_reflectance", c_float),
        ("finish_transmittance", c_float),
        ("finish_roughness", c_float),
        ("finish_absorption_per_m", c_float),
        ("finish_ior", c_float),
        ("reserved", c_float),
        ("material", POINTER(MaterialDesc)),
    ]


class FixtureInfo(Structure):
    struct_size: int
    part_count: int
    triangle_count: int
    flux_lm: float
    emitter_area_m2: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("part_count", c_uint32),
        ("triangle_count", c_uint64),
        ("flux_lm", c_double),
        ("emitter_area_m2", c_double),
    ]


class FixtureInstanceDesc(Structure):
    struct_size: int
    dimming: float
    to_world: Array[c_double]
    flux_lm: float
    group: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("dimming", c_float),
        ("to_world", c_double * 12),
        ("flux_lm", c_float),
        ("group", c_uint32),
    ]


class CameraDesc(Structure):
    struct_size: int
    projection: int
    width: int
    height: int
    to_world: Array[c_double]
    vertical_fov_rad: float
    illuminance: int
    layers: int
    reserved: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("projection", c_int32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("to_world", c_double * 12),
        ("vertical_fov_rad", c_float),
        ("illuminance", c_int32),
        ("layers", c_uint32),
        ("reserved", c_uint32),
    ]


class MeterDesc(Structure):
    struct_size: int
    kind: int
    positions_m: Any
    normals: Any
    tangents: Any
    cell_size_m: Array[c_float]
    count: int
    reserved: int
    footprint_m: float
    reserved_2: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("positions_m", POINTER(c_double)),
        ("normals", POINTER(c_float)),
        ("tangents", POINTER(c_float)),
        ("cell_size_m", c_float * 2),
        ("count", c_uint32),
        ("reserved", c_uint32),
        ("footprint_m", c_float),
        ("reserved_2", c_uint32),
    ]


class SurfaceMetersDesc(Structure):
    struct_size: int
    instance_count: int
    instances: Any
    back: int
    reserved: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("instance_count", c_uint32),
        ("instances", POINTER(InstanceId)),
        ("back", c_int32),
        ("reserved", c_uint32),
    ]


class LightmapDesc(Structure):
    struct_size: int
    instance_count: int
    instances: Any
    width: int
    height: int
    back: int
    reserved: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("instance_count", c_uint32),
        ("instances", POINTER(InstanceId)),
        ("width", c_uint32),
        ("height", c_uint32),
        ("back", c_int32),
        ("reserved", c_uint32),
    ]


class En12464Desc(Structure):
    struct_size: int
    corner_count: int
    corners_m: Any
    hole_corners_m: Any
    hole_corner_counts: Any
    hole_count: int
    reserved: int
    border_m: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("corner_count", c_uint32),
        ("corners_m", POINTER(c_double)),
        ("hole_corners_m", POINTER(c_double)),
        ("hole_corner_counts", POINTER(c_uint32)),
        ("hole_count", c_uint32),
        ("reserved", c_uint32),
        ("border_m", c_double),
    ]


class En12464Info(Structure):
    struct_size: int
    columns: int
    rows: int
    point_count: int
    origin_m: Array[c_double]
    cell_m: Array[c_double]
    largest_spacing_m: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("columns", c_uint32),
        ("rows", c_uint32),
        ("point_count", c_uint32),
        ("origin_m", c_double * 2),
        ("cell_m", c_double * 2),
        ("largest_spacing_m", c_double),
    ]


class En12464Point(Structure):
    x_m: float
    y_m: float
    column: int
    row: int
    _fields_ = [
        ("x_m", c_double),
        ("y_m", c_double),
        ("column", c_uint32),
        ("row", c_uint32),
    ]


class MeterPlace(Structure):
    position_m: Array[c_double]
    normal: Array[c_float]
    area_m2: float
    valid: int
    triangle: int
    _fields_ = [
        ("position_m", c_double * 3),
        ("normal", c_float * 3),
        ("area_m2", c_float),
        ("valid", c_int32),
        ("triangle", c_uint32),
    ]


class GoniometerDesc(Structure):
    struct_size: int
    symmetry: int
    c_deg: Any
    gamma_deg: Any
    c_count: int
    gamma_count: int
    to_world: Array[c_double]
    opening_shape: int
    opening_m: Array[c_float]
    _fields_ = [
        ("struct_size", c_uint32),
        ("symmetry", c_int32),
        ("c_deg", POINTER(c_float)),
        ("gamma_deg", POINTER(c_float)),
        ("c_count", c_uint32),
        ("gamma_count", c_uint32),
        ("to_world", c_double * 12),
        ("opening_shape", c_int32),
        ("opening_m", c_float * 3),
    ]


class RenderDesc(Structure):
    struct_size: int
    method: int
    seed: int
    time_limit_s: float
    target_relative_error: float
    merge_radius_m: float
    iteration_count: int
    max_path_length: int
    light_paths_per_iteration: int
    techniques: int
    radius_alpha: float
    glossy_alpha: float
    perturbation: int
    technique_images: int
    separation: int
    reserved: int
    flux_paths: int
    target_criterion: int
    reserved2: int
    memory_limit_bytes: int
    thread_limit: int
    priority: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_int32),
        ("seed", c_uint64),
        ("time_limit_s", c_double),
        ("target_relative_error", c_float),
        ("merge_radius_m", c_float),
        ("iteration_count", c_uint32),
        ("max_path_length", c_uint32),
        ("light_paths_per_iteration", c_uint32),
        ("techniques", c_uint32),
        ("radius_alpha", c_float),
        ("glossy_alpha", c_float),
        ("perturbation", c_int32),
        ("technique_images", c_uint32),
        ("separation", c_int32),
        ("reserved", c_uint32),
        ("flux_paths", c_uint64),
        ("target_criterion", c_int32),
        ("reserved2", c_uint32),
        ("memory_limit_bytes", c_uint64),
        ("thread_limit", c_uint32),
        ("priority", c_int32),
    ]


class Progress(Structure):
    struct_size: int
    state: int
    elapsed_s: float
    remaining_s: float
    iterations_done: int
    fraction: float
    worst_relative_error: float
    median_relative_error: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("state", c_int32),
        ("elapsed_s", c_double),
        ("remaining_s", c_double),
        ("iterations_done", c_uint32),
        ("fraction", c_float),
        ("worst_relative_error", c_float),
        ("median_relative_error", c_float),
    ]


class ResultInfo(Structure):
    struct_size: int
    iterations: int
    elapsed_s: float
    rays: int
    light_paths: int
    eye_paths: int
    merges: int
    connections: int
    emitted_flux_lm: float
    absorbed_flux_lm: float
    escaped_flux_lm: float
    seed: int
    dropped_samples: int
    method: int
    techniques: int
    effects: int
    threads: int
    flux_balance_standard_error_lm: float
    maintenance_factor: float
    revision: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("iterations", c_uint32),
        ("elapsed_s", c_double),
        ("rays", c_uint64),
        ("light_paths", c_uint64),
        ("eye_paths", c_uint64),
        ("merges", c_uint64),
        ("connections", c_uint64),
        ("emitted_flux_lm", c_double),
        ("absorbed_flux_lm", c_double),
        ("escaped_flux_lm", c_double),
        ("seed", c_uint64),
        ("dropped_samples", c_uint64),
        ("method", c_int32),
        ("techniques", c_uint32),
        ("effects", c_uint32),
        ("threads", c_int32),
        ("flux_balance_standard_error_lm", c_double),
        ("maintenance_factor", c_double),
        ("revision", c_uint64),
    ]


class MeterReading(Structure):
    illuminance_lx: float
    standard_error_lx: float
    bias_lx: float
    error_bound_lx: float
    direct_lx: float
    indirect_lx: float
    _fields_ = [
        ("illuminance_lx", c_float),
        ("standard_error_lx", c_float),
        ("bias_lx", c_float),
        ("error_bound_lx", c_float),
        ("direct_lx", c_float),
        ("indirect_lx", c_float),
    ]


class VectorReading(Structure):
    vector_lx: Array[c_float]
    standard_error_lx: Array[c_float]
    error_bound_lx: Array[c_float]
    _fields_ = [
        ("vector_lx", c_float * 3),
        ("standard_error_lx", c_float * 3),
        ("error_bound_lx", c_float * 3),
    ]


class MeterPartReading(Structure):
    illuminance_lx: float
    standard_error_lx: float
    bias_lx: float
    error_bound_lx: float
    _fields_ = [
        ("illuminance_lx", c_float),
        ("standard_error_lx", c_float),
        ("bias_lx", c_float),
        ("error_bound_lx", c_float),
    ]


class VectorPartReading(Structure):
    vector_lx: Array[c_float]
    standard_error_lx: Array[c_float]
    bias_lx: Array[c_float]
    error_bound_lx: Array[c_float]
    _fields_ = [
        ("vector_lx", c_float * 3),
        ("standard_error_lx", c_float * 3),
        ("bias_lx", c_float * 3),
        ("error_bound_lx", c_float * 3),
    ]


class ConvergencePoint(Structure):
    elapsed_s: float
    iterations: int
    reserved: int
    median_relative_error: float
    p95_relative_error: float
    worst_relative_error: float
    bias_share: float
    _fields_ = [
        ("elapsed_s", c_double),
        ("iterations", c_uint32),
        ("reserved", c_uint32),
        ("median_relative_error", c_float),
        ("p95_relative_error", c_float),
        ("worst_relative_error", c_float),
        ("bias_share", c_float),
    ]


class MeterStatistics(Structure):
    struct_size: int
    count: int
    mean_lx: float
    min_lx: float
    max_lx: float
    uniformity: float
    mean_standard_error_lx: float
    median_relative_error_bound: float
    p95_relative_error_bound: float
    worst_relative_error_bound: float
    mean_bias_lx: float
    mean_error_bound_lx: float
    min_low_lx: float
    min_high_lx: float
    max_low_lx: float
    max_high_lx: float
    uniformity_low: float
    uniformity_high: float
    percentile_5_lx: float
    percentile_5_low_lx: float
    percentile_5_high_lx: float
    diversity: float
    diversity_low: float
    diversity_high: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("count", c_uint32),
        ("mean_lx", c_double),
        ("min_lx", c_double),
        ("max_lx", c_double),
        ("uniformity", c_double),
        ("mean_standard_error_lx", c_double),
        ("median_relative_error_bound", c_double),
        ("p95_relative_error_bound", c_double),
        ("worst_relative_error_bound", c_double),
        ("mean_bias_lx", c_double),
        ("mean_error_bound_lx", c_double),
        ("min_low_lx", c_double),
        ("min_high_lx", c_double),
        ("max_low_lx", c_double),
        ("max_high_lx", c_double),
        ("uniformity_low", c_double),
        ("uniformity_high", c_double),
        ("percentile_5_lx", c_double),
        ("percentile_5_low_lx", c_double),
        ("percentile_5_high_lx", c_double),
        ("diversity", c_double),
        ("diversity_low", c_double),
        ("diversity_high", c_double),
    ]


class CurvePoint(Structure):
    struct_size: int
    iterations: int
    elapsed_s: float
    median_relative_error: float
    p95_relative_error: float
    worst_relative_error: float
    mean_relative_error: float
    bias_share: float
    reserved: int
    rays: int
    light_paths: int
    eye_paths: int
    resident_bytes: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("iterations", c_uint32),
        ("elapsed_s", c_double),
        ("median_relative_error", c_float),
        ("p95_relative_error", c_float),
        ("worst_relative_error", c_float),
        ("mean_relative_error", c_float),
        ("bias_share", c_float),
        ("reserved", c_uint32),
        ("rays", c_uint64),
        ("light_paths", c_uint64),
        ("eye_paths", c_uint64),
        ("resident_bytes", c_uint64),
    ]


class Prediction(Structure):
    struct_size: int
    limited_by: int
    seconds: float
    seconds_low: float
    seconds_high: float
    iterations: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("limited_by", c_int32),
        ("seconds", c_double),
        ("seconds_low", c_double),
        ("seconds_high", c_double),
        ("iterations", c_double),
    ]


class LargestError(Structure):
    struct_size: int
    sensor: SensorId
    index: int
    relative_error: float
    bias_share: float
    reserved: int
    position_m: Array[c_double]
    _fields_ = [
        ("struct_size", c_uint32),
        ("sensor", SensorId),
        ("index", c_uint32),
        ("relative_error", c_float),
        ("bias_share", c_float),
        ("reserved", c_uint32),
        ("position_m", c_double * 3),
    ]


class MemoryEstimate(Structure):
    struct_size: int
    reserved: int
    scene_bytes: int
    working_bytes: int
    light_bytes: int
    result_bytes: int
    peak_bytes: int
    allowed_bytes: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("scene_bytes", c_uint64),
        ("working_bytes", c_uint64),
        ("light_bytes", c_uint64),
        ("result_bytes", c_uint64),
        ("peak_bytes", c_uint64),
        ("allowed_bytes", c_uint64),
    ]


class SensorChoice(Structure):
    struct_size: int
    techniques: int
    light_paths_per_iteration: int
    photons: int
    predicted_gain: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("techniques", c_uint32),
        ("light_paths_per_iteration", c_uint32),
        ("photons", c_int32),
        ("predicted_gain", c_double),
    ]


class SourceInfo(Structure):
    struct_size: int
    kind: int
    id: int
    reserved: int
    flux_lm: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("id", c_uint32),
        ("reserved", c_uint32),
        ("flux_lm", c_double),
    ]


class SceneSource(Structure):
    struct_size: int
    kind: int
    id: int
    group: int
    light_kind: int
    maintained: int
    flux_lm: float
    to_world: Array[c_double]
    bounds_min_m: Array[c_double]
    bounds_max_m: Array[c_double]
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("id", c_uint32),
        ("group", c_uint32),
        ("light_kind", c_int32),
        ("maintained", c_uint32),
        ("flux_lm", c_double),
        ("to_world", c_double * 12),
        ("bounds_min_m", c_double * 3),
        ("bounds_max_m", c_double * 3),
    ]


class GoniometerInfo(Structure):
    struct_size: int
    c_count: int
    gamma_count: int
    reserved: int
    flux_lm: float
    flux_standard_error_lm: float
    outside_flux_lm: float
    emitted_flux_lm: float
    absorbed_flux_lm: float
    light_output_ratio: float
    light_output_ratio_standard_error: float
    worst_relative_error_bound: float
    median_relative_error_bound: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("c_count", c_uint32),
        ("gamma_count", c_uint32),
        ("reserved", c_uint32),
        ("flux_lm", c_double),
        ("flux_standard_error_lm", c_double),
        ("outside_flux_lm", c_double),
        ("emitted_flux_lm", c_double),
        ("absorbed_flux_lm", c_double),
        ("light_output_ratio", c_double),
        ("light_output_ratio_standard_error", c_double),
        ("worst_relative_error_bound", c_double),
        ("median_relative_error_bound", c_double),
    ]


class IntensityReading(Structure):
    intensity_cd: float
    standard_error_cd: float
    bias_cd: float
    error_bound_cd: float
    _fields_ = [
        ("intensity_cd", c_float),
        ("standard_error_cd", c_float),
        ("bias_cd", c_float),
        ("error_bound_cd", c_float),
    ]


class GoniometerBeam(Structure):
    struct_size: int
    angle_deg: float
    standard_error_deg: float
    bias_deg: float
    low_deg: float
    high_deg: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("angle_deg", c_float),
        ("standard_error_deg", c_float),
        ("bias_deg", c_float),
        ("low_deg", c_float),
        ("high_deg", c_float),
    ]


class TechniqueInfo(Structure):
    struct_size: int
    technique: int
    light_vertices: int
    eye_vertices: int
    edges: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("technique", c_uint32),
        ("light_vertices", c_uint32),
        ("eye_vertices", c_uint32),
        ("edges", c_uint32),
    ]


class Sample(Structure):
    seed: int
    sensor: SensorId
    index: int
    iteration: int
    walk: int
    path: int
    value: float
    share: float
    reserved: int
    _fields_ = [
        ("seed", c_uint64),
        ("sensor", SensorId),
        ("index", c_uint32),
        ("iteration", c_uint32),
        ("walk", c_int32),
        ("path", c_uint32),
        ("value", c_float),
        ("share", c_float),
        ("reserved", c_uint32),
    ]


class PathInfo(Structure):
    struct_size: int
    walks: int
    value: float
    contributions: int
    reserved: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("walks", c_uint32),
        ("value", c_double),
        ("contributions", c_uint32),
        ("reserved", c_uint32),
    ]


class PathVertex(Structure):
    position_m: Array[c_double]
    normal: Array[c_float]
    throughput: float
    pdf: float
    pdf_reverse: float
    survival: float
    walk: int
    instance: InstanceId
    event: int
    _fields_ = [
        ("position_m", c_double * 3),
        ("normal", c_float * 3),
        ("throughput", c_float),
        ("pdf", c_float),
        ("pdf_reverse", c_float),
        ("survival", c_float),
        ("walk", c_uint32),
        ("instance", InstanceId),
        ("event", c_int32),
    ]


class PathContribution(Structure):
    from_m: Array[c_double]
    to_m: Array[c_double]
    value: float
    weight: float
    technique: int
    edges: int
    light_vertices: int
    walk: int
    light_path: int
    source_kind: int
    source: int
    reserved: int
    _fields_ = [
        ("from_m", c_double * 3),
        ("to_m", c_double * 3),
        ("value", c_float),
        ("weight", c_float),
        ("technique", c_uint32),
        ("edges", c_uint32),
        ("light_vertices", c_uint32),
        ("walk", c_uint32),
        ("light_path", c_uint32),
        ("source_kind", c_int32),
        ("source", c_uint32),
        ("reserved", c_uint32),
    ]


class Interval(Structure):
    value: float
    low: float
    high: float
    _fields_ = [
        ("value", c_double),
        ("low", c_double),
        ("high", c_double),
    ]


class UgrTable(Structure):
    struct_size: int
    lamp_flux_lm: float
    room_across_h: Array[c_float]
    room_along_h: Array[c_float]
    reflectances: Array[c_float]
    crosswise: Array[c_float]
    endwise: Array[c_float]
    _fields_ = [
        ("struct_size", c_uint32),
        ("lamp_flux_lm", c_float),
        ("room_across_h", c_float * 19),
        ("room_along_h", c_float * 19),
        ("reflectances", c_float * 15),
        ("crosswise", c_float * 95),
        ("endwise", c_float * 95),
    ]


class DataSheet(Structure):
    struct_size: int
    flux_code: Array[c_float]
    luminance_cd_m2: Array[c_float]
    highest_luminance_cd_m2: float
    highest_luminance_c_deg: float
    highest_luminance_gamma_deg: float
    spacing_criterion: Array[c_float]
    nema_horizontal: int
    nema_vertical: int
    front_lm: Array[c_float]
    back_lm: Array[c_float]
    up_lm: Array[c_float]
    backlight_rating: int
    uplight_rating: int
    glare_rating: int
    bug_type_v: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("flux_code", c_float * 5),
        ("luminance_cd_m2", c_float * 3),
        ("highest_luminance_cd_m2", c_float),
        ("highest_luminance_c_deg", c_float),
        ("highest_luminance_gamma_deg", c_float),
        ("spacing_criterion", c_float * 3),
        ("nema_horizontal", c_int32),
        ("nema_vertical", c_int32),
        ("front_lm", c_float * 4),
        ("back_lm", c_float * 4),
        ("up_lm", c_float * 2),
        ("backlight_rating", c_int32),
        ("uplight_rating", c_int32),
        ("glare_rating", c_int32),
        ("bug_type_v", c_int32),
    ]


class UtilisationTable(Structure):
    struct_size: int
    room_index: Array[c_float]
    reflectances: Array[c_float]
    factors: Array[c_float]
    _fields_ = [
        ("struct_size", c_uint32),
        ("room_index", c_float * 10),
        ("reflectances", c_float * 30),
        ("factors", c_float * 100),
    ]


class ObserverDesc(Structure):
    struct_size: int
    metric: int
    position_index: int
    ceiling_area_m2: float
    to_world: Array[c_double]
    _fields_ = [
        ("struct_size", c_uint32),
        ("metric", c_int32),
        ("position_index", c_int32),
        ("ceiling_area_m2", c_float),
        ("to_world", c_double * 12),
    ]


class ObserverReading(Structure):
    struct_size: int
    flags: int
    ugr: float
    ugr_standard_error: float
    ugr_low: float
    ugr_high: float
    background_cd_m2: float
    background_standard_error_cd_m2: float
    background_error_bound_cd_m2: float
    source_count: int
    ceiling_coverage: float
    ggr: float
    ggr_low: float
    ggr_high: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("ugr", c_float),
        ("ugr_standard_error", c_float),
        ("ugr_low", c_float),
        ("ugr_high", c_float),
        ("background_cd_m2", c_float),
        ("background_standard_error_cd_m2", c_float),
        ("background_error_bound_cd_m2", c_float),
        ("source_count", c_uint32),
        ("ceiling_coverage", c_float),
        ("ggr", c_float),
        ("ggr_low", c_float),
        ("ggr_high", c_float),
    ]


class GlareSource(Structure):
    struct_size: int
    kind: int
    id: int
    flags: int
    luminance_cd_m2: float
    solid_angle_sr: float
    intensity_cd: float
    distance_m: float
    visible_share: float
    position_index: float
    share: float
    direction: Array[c_float]
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("id", c_uint32),
        ("flags", c_uint32),
        ("luminance_cd_m2", c_float),
        ("solid_angle_sr", c_float),
        ("intensity_cd", c_float),
        ("distance_m", c_float),
        ("visible_share", c_float),
        ("position_index", c_float),
        ("share", c_float),
        ("direction", c_float * 3),
    ]


class GltfImportDesc(Structure):
    struct_size: int
    camera_width: int
    camera_height: int
    reserved: int
    allow_outside: int
    camera_layers: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("camera_width", c_uint32),
        ("camera_height", c_uint32),
        ("reserved", c_uint32),
        ("allow_outside", c_int32),
        ("camera_layers", c_uint32),
    ]


class GltfSensorInfo(Structure):
    struct_size: int
    kind: int
    sensor: SensorId
    width: int
    height: int
    illuminance: int
    meter_count: int
    columns: int
    rows: int
    reserved: int
    layout: int
    cell_size_m: Array[c_float]
    cell_side: Array[c_float]
    meter_kind: int
    projection: int
    layers: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("sensor", SensorId),
        ("width", c_uint32),
        ("height", c_uint32),
        ("illuminance", c_int32),
        ("meter_count", c_uint32),
        ("columns", c_uint32),
        ("rows", c_uint32),
        ("reserved", c_uint32),
        ("layout", c_int32),
        ("cell_size_m", c_float * 2),
        ("cell_side", c_float * 3),
        ("meter_kind", c_int32),
        ("projection", c_int32),
        ("layers", c_uint32),
    ]


class ExrChannel(Structure):
    name: bytes | None
    data: Any
    pixel_stride_bytes: int
    row_stride_bytes: int
    _fields_ = [
        ("name", c_char_p),
        ("data", POINTER(c_float)),
        ("pixel_stride_bytes", c_size_t),
        ("row_stride_bytes", c_size_t),
    ]


class ExrAttribute(Structure):
    name: bytes | None
    value: bytes | None
    _fields_ = [
        ("name", c_char_p),
        ("value", c_char_p),
    ]


class OcioPictureDesc(Structure):
    struct_size: int
    width: int
    height: int
    smoothed: int
    luminance_rgb: Any
    exposure: float
    exposure_chosen: int
    reserved: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("smoothed", c_int32),
        ("luminance_rgb", POINTER(c_float)),
        ("exposure", c_double),
        ("exposure_chosen", c_int32),
        ("reserved", c_uint32),
    ]


class OcioSmoothDesc(Structure):
    struct_size: int
    width: int
    height: int
    reserved: int
    luminance_rgb: Any
    standard_error_rgb: Any
    albedo_rgb: Any
    normal: Any
    depth: Any
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("reserved", c_uint32),
        ("luminance_rgb", POINTER(c_float)),
        ("standard_error_rgb", POINTER(c_float)),
        ("albedo_rgb", POINTER(c_float)),
        ("normal", POINTER(c_float)),
        ("depth", POINTER(c_float)),
    ]


class OcioFalseColorDesc(Structure):
    struct_size: int
    columns: int
    rows: int
    first_row_at_bottom: int
    values: Any
    title: bytes | None
    unit: bytes | None
    scale_min: float
    scale_max: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("columns", c_uint32),
        ("rows", c_uint32),
        ("first_row_at_bottom", c_int32),
        ("values", POINTER(c_float)),
        ("title", c_char_p),
        ("unit", c_char_p),
        ("scale_min", c_double),
        ("scale_max", c_double),
    ]


class ReportStyleDesc(Structure):
    struct_size: int
    scale: int
    colours: int
    isolines: int
    numbers: int
    cells: int
    low: float
    high: float
    threshold_lx: float
    threshold_cd_m2: float
    width: float
    height: float
    zoom: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("scale", c_int32),
        ("colours", c_int32),
        ("isolines", c_int32),
        ("numbers", c_int32),
        ("cells", c_int32),
        ("low", c_double),
        ("high", c_double),
        ("threshold_lx", c_double),
        ("threshold_cd_m2", c_double),
        ("width", c_double),
        ("height", c_double),
        ("zoom", c_double),
    ]


class ReportSensor(Structure):
    sensor: SensorId
    reserved: int
    name: bytes | None
    _fields_ = [
        ("sensor", SensorId),
        ("reserved", c_uint32),
        ("name", c_char_p),
    ]


class ReportMapDesc(Structure):
    struct_size: int
    quantity: int
    scene: Any
    result: Any
    sensor: SensorId
    sensor_count: int
    sensors: Any
    title: bytes | None
    style: Any
    positions_m: Any
    normals: Any
    values: Any
    error_bounds: Any
    count: int
    columns: int
    _fields_ = [
        ("struct_size", c_uint32),
        ("quantity", c_int32),
        ("scene", c_void_p),
        ("result", c_void_p),
        ("sensor", SensorId),
        ("sensor_count", c_uint32),
        ("sensors", POINTER(ReportSensor)),
        ("title", c_char_p),
        ("style", POINTER(ReportStyleDesc)),
        ("positions_m", POINTER(c_double)),
        ("normals", POINTER(c_float)),
        ("values", POINTER(c_float)),
        ("error_bounds", POINTER(c_float)),
        ("count", c_uint32),
        ("columns", c_uint32),
    ]


class ReportSource(Structure):
    kind: int
    id: int
    name: bytes | None
    file: bytes | None
    _fields_ = [
        ("kind", c_int32),
        ("id", c_uint32),
        ("name", c_char_p),
        ("file", c_char_p),
    ]


class ReportPicture(Structure):
    camera: SensorId
    exposure: int
    ev100: float
    smoothed: int
    reserved: int
    path: bytes | None
    png: Any
    png_size: int
    _fields_ = [
        ("camera", SensorId),
        ("exposure", c_int32),
        ("ev100", c_double),
        ("smoothed", c_int32),
        ("reserved", c_uint32),
        ("path", c_char_p),
        ("png", POINTER(c_uint8)),
        ("png_size", c_size_t),
    ]


class ReportRatio(Structure):
    numerator: SensorId
    denominator: SensorId
    _fields_ = [
        ("numerator", SensorId),
        ("denominator", SensorId),
    ]


class ReportPageDesc(Structure):
    struct_size: int
    sensor_count: int
    source_count: int
    picture_count: int
    threshold_count: int
    ratio_count: int
    scene: Any
    result: Any
    sensors: Any
    sources: Any
    pictures: Any
    title: bytes | None
    scene_name: bytes | None
    repeat: bytes | None
    date: bytes | None
    targets_json: bytes | None
    targets_name: bytes | None
    targets_folder: bytes | None
    style: Any
    thresholds_lx: Any
    ratios: Any
    target_relative_error: float
    _fields_ = [
        ("struct_size", c_uint32),
        ("sensor_count", c_uint32),
        ("source_count", c_uint32),
        ("picture_count", c_uint32),
        ("threshold_count", c_uint32),
        ("ratio_count", c_uint32),
        ("scene", c_void_p),
        ("result", c_void_p),
        ("sensors", POINTER(ReportSensor)),
        ("sources", POINTER(ReportSource)),
        ("pictures", POINTER(ReportPicture)),
        ("title", c_char_p),
        ("scene_name", c_char_p),
        ("repeat", c_char_p),
        ("date", c_char_p),
        ("targets_json", c_char_p),
        ("targets_name", c_char_p),
        ("targets_folder", c_char_p),
        ("style", POINTER(ReportStyleDesc)),
        ("thresholds_lx", POINTER(c_double)),
        ("ratios", POINTER(ReportRatio)),
        ("target_relative_error", c_double),
    ]


# Of each library: result and parameters of each function, and which are integers that need a check.
PROTOTYPES: dict[str, dict[str, tuple[Any, list[Any], dict[int, str]]]] = {
    "ups": {
        "ups_version": (c_uint32, [], {}),
        "ups_status_name": (c_char_p, [c_int32], {0: "status"}),
        "ups_last_error": (c_char_p, [], {}),
        "ups_context_desc_init": (None, [POINTER(ContextDesc), c_uint32], {}),
        "ups_context_create": (c_int32, [POINTER(ContextDesc), POINTER(c_void_p)], {}),
        "ups_context_destroy": (None, [c_void_p], {}),
        "ups_context_get_thread_count": (c_int32, [c_void_p, POINTER(c_int32)], {}),
        "ups_context_pop_log": (c_int32, [c_void_p, c_char_p, c_size_t, POINTER(c_size_t), POINTER(c_int32)], {}),
        "ups_profile_desc_init": (None, [POINTER(ProfileDesc), c_uint32], {}),
        "ups_profile_create": (c_int32, [c_void_p, POINTER(ProfileDesc), POINTER(c_void_p)], {}),
        "ups_profile_parse": (c_int32, [c_void_p, c_void_p, c_size_t, c_int32, POINTER(c_void_p)], {3: "format"}),
        "ups_profile_parse_desc_init": (None, [POINTER(ProfileParseDesc), c_uint32], {}),
        "ups_profile_parse_with": (c_int32, [c_void_p, POINTER(ProfileParseDesc), POINTER(c_void_p)], {}),
        "ups_profile_write": (c_int32, [c_void_p, c_int32, c_char_p, c_size_t, POINTER(c_size_t)], {1: "format"}),
        "ups_profile_get_write_warnings": (c_int32, [c_void_p, c_int32, c_char_p, c_size_t, POINTER(c_size_t)],
            {1: "format"}),
        "ups_profile_get_info": (c_int32, [c_void_p, POINTER(ProfileInfo)], {}),
        "ups_profile_get_lamp_set": (c_int32, [c_void_p, c_uint32, POINTER(ProfileLampSet)], {1: "index"}),
        "ups_profile_get_text": (c_int32, [c_void_p, c_int32, c_char_p, c_size_t, POINTER(c_size_t)], {1: "topic"}),
        "ups_profile_get_keyword": (c_int32, [c_void_p, c_char_p, c_char_p, c_size_t, POINTER(c_size_t)], {}),
        "ups_profile_with_keyword": (c_int32, [c_void_p, c_char_p, c_char_p, POINTER(c_void_p)], {}),
        "ups_profile_eval": (c_int32, [c_void_p, POINTER(c_float), c_size_t, POINTER(c_float)], {}),
        "ups_profile_get_luminance": (c_int32, [c_void_p, POINTER(c_float), c_size_t, POINTER(c_float)], {}),
        "ups_profile_get_zonal_flux": (c_int32, [c_void_p, POINTER(c_float), c_size_t, POINTER(c_double)], {}),
        "ups_profile_get_beam": (c_int32, [c_void_p, c_float, c_float, POINTER(ProfileBeam)], {}),
        "ups_profile_destroy": (None, [c_void_p], {}),
        "ups_texture_desc_init": (None, [POINTER(TextureDesc), c_uint32], {}),
        "ups_material_desc_init": (None, [POINTER(MaterialDesc), c_uint32], {}),
        "ups_mesh_desc_init": (None, [POINTER(MeshDesc), c_uint32], {}),
        "ups_instance_desc_init": (None, [POINTER(InstanceDesc), c_uint32], {}),
        "ups_light_desc_init": (None, [POINTER(LightDesc), c_uint32], {}),
        "ups_luminaire_desc_init": (None, [POINTER(LuminaireDesc), c_uint32], {}),
        "ups_scene_create": (c_int32, [c_void_p, POINTER(c_void_p)], {}),
        "ups_scene_destroy": (None, [c_void_p], {}),
        "ups_scene_add_texture": (c_int32, [c_void_p, POINTER(TextureDesc), POINTER(TextureId)], {}),
        "ups_scene_add_material": (c_int32, [c_void_p, POINTER(MaterialDesc), POINTER(MaterialId)], {}),
        "ups_scene_add_mesh": (c_int32, [c_void_p, POINTER(MeshDesc), POINTER(MeshId)], {}),
        "ups_scene_add_instance": (c_int32, [c_void_p, POINTER(InstanceDesc), POINTER(InstanceId)], {}),
        "ups_scene_add_light": (c_int32, [c_void_p, POINTER(LightDesc), POINTER(LuminaireId)], {}),
        "ups_scene_add_luminaire": (c_int32, [c_void_p, POINTER(LuminaireDesc), POINTER(LuminaireId)], {}),
        "ups_scene_set_texture": (c_int32, [c_void_p, TextureId, POINTER(TextureDesc)], {}),
        "ups_scene_set_material": (c_int32, [c_void_p, MaterialId, POINTER(MaterialDesc)], {}),
        "ups_scene_set_mesh": (c_int32, [c_void_p, MeshId, POINTER(MeshDesc)], {}),
        "ups_scene_set_mesh_vertices": (c_int32, [c_void_p, MeshId, POINTER(c_float), POINTER(c_float), c_uint32],
            {4: "vertex_count"}),
        "ups_scene_set_instance": (c_int32, [c_void_p, InstanceId, POINTER(InstanceDesc)], {}),
        "ups_scene_set_transform": (c_int32, [c_void_p, InstanceId, POINTER(c_double)], {}),
        "ups_scene_set_light": (c_int32, [c_void_p, LuminaireId, POINTER(LightDesc)], {}),
        "ups_scene_set_luminaire": (c_int32, [c_void_p, LuminaireId, POINTER(LuminaireDesc)], {}),
        "ups_scene_set_luminaire_transform": (c_int32, [c_void_p, LuminaireId, POINTER(c_double)], {}),
        "ups_scene_set_dimming": (c_int32, [c_void_p, LuminaireId, c_float], {}),
        "ups_scene_set_maintenance_factor": (c_int32, [c_void_p, c_double], {}),
        "ups_scene_get_texture": (c_int32, [c_void_p, TextureId, POINTER(TextureDesc)], {}),
        "ups_scene_read_texture": (c_int32, [c_void_p, TextureId, POINTER(c_float), c_size_t, POINTER(c_size_t)], {}),
        "ups_scene_get_material": (c_int32, [c_void_p, MaterialId, POINTER(MaterialDesc)], {}),
        "ups_scene_get_mesh": (c_int32, [c_void_p, MeshId, POINTER(MeshDesc)], {}),
        "ups_scene_get_instance": (c_int32, [c_void_p, InstanceId, POINTER(InstanceDesc)], {}),
        "ups_scene_get_light": (c_int32, [c_void_p, LuminaireId, POINTER(LightDesc)], {}),
        "ups_scene_get_luminaire": (c_int32, [c_void_p, LuminaireId, POINTER(LuminaireDesc)], {}),
        "ups_scene_get_luminaire_profile": (c_int32, [c_void_p, LuminaireId, POINTER(c_void_p)], {}),
        "ups_scene_get_dimming": (c_int32, [c_void_p, LuminaireId, POINTER(c_float)], {}),
        "ups_scene_get_maintenance_factor": (c_int32, [c_void_p, POINTER(c_double)], {}),
        "ups_scene_remove_texture": (c_int32, [c_void_p, TextureId], {}),
        "ups_scene_remove_material": (c_int32, [c_void_p, MaterialId], {}),
        "ups_scene_remove_mesh": (c_int32, [c_void_p, MeshId], {}),
        "ups_scene_remove_instance": (c_int32, [c_void_p, InstanceId], {}),
        "ups_scene_remove_luminaire": (c_int32, [c_void_p, LuminaireId], {}),
        "ups_scene_remove_sensor": (c_int32, [c_void_p, SensorId], {}),
        "ups_scene_commit": (c_int32, [c_void_p], {}),
        "ups_scene_start_commit": (c_int32, [c_void_p, POINTER(c_void_p)], {}),
        "ups_commit_desc_init": (None, [POINTER(CommitDesc), c_uint32], {}),
        "ups_scene_start_commit_with": (c_int32, [c_void_p, POINTER(CommitDesc), POINTER(c_void_p)], {}),
        "ups_scene_is_dirty": (c_int32, [c_void_p, POINTER(c_int32)], {}),
        "ups_scene_get_info": (c_int32, [c_void_p, POINTER(SceneInfo)], {}),
        "ups_scene_get_text": (c_int32, [c_void_p, c_int32, c_char_p, c_size_t, POINTER(c_size_t)], {1: "topic"}),
        "ups_scene_read_section": (c_int32, [c_void_p, POINTER(c_double), POINTER(c_double), POINTER(Segment), c_size_t,
            POINTER(c_size_t)], {}),
        "ups_scene_read_outlines": (c_int32, [c_void_p, POINTER(c_double), POINTER(c_double), c_double,
            POINTER(Segment), c_size_t, POINTER(c_size_t)], {}),
        "ups_fixture_emitter_desc_init": (None, [POINTER(FixtureEmitterDesc), c_uint32], {}),
        "ups_reflector_desc_init": (None, [POINTER(ReflectorDesc), c_uint32], {}),
        "ups_lens_desc_init": (None, [POINTER(LensDesc), c_uint32], {}),
        "ups_collimator_desc_init": (None, [POINTER(CollimatorDesc), c_uint32], {}),
        "ups_fixture_part_desc_init": (None, [POINTER(FixturePartDesc), c_uint32], {}),
        "ups_fixture_instance_desc_init": (None, [POINTER(FixtureInstanceDesc), c_uint32], {}),
        "ups_fixture_create": (c_int32, [c_void_p, POINTER(c_void_p)], {}),
        "ups_fixture_destroy": (None, [c_void_p], {}),
        "ups_fixture_add_emitter": (c_int32, [c_void_p, POINTER(FixtureEmitterDesc), POINTER(FixturePartId)], {}),
        "ups_fixture_add_reflector": (c_int32, [c_void_p, POINTER(ReflectorDesc), POINTER(FixturePartId)], {}),
        "ups_fixture_add_lens": (c_int32, [c_void_p, POINTER(LensDesc), POINTER(FixturePartId)], {}),
        "ups_fixture_add_collimator": (c_int32, [c_void_p, POINTER(CollimatorDesc), POINTER(FixturePartId)], {}),
        "ups_fixture_add_part": (c_int32, [c_void_p, POINTER(FixturePartDesc), POINTER(FixturePartId)], {}),
        "ups_fixture_get_info": (c_int32, [c_void_p, POINTER(FixtureInfo)], {}),
        "ups_scene_add_fixture": (c_int32, [c_void_p, c_void_p, POINTER(FixtureInstanceDesc), POINTER(FixtureId)], {}),
        "ups_scene_get_fixture_instance": (c_int32, [c_void_p, FixtureId, FixturePartId, POINTER(InstanceId)], {}),
        "ups_scene_set_fixture": (c_int32, [c_void_p, FixtureId, POINTER(FixtureInstanceDesc)], {}),
        "ups_scene_get_fixture": (c_int32, [c_void_p, FixtureId, POINTER(FixtureInstanceDesc)], {}),
        "ups_scene_set_fixture_dimming": (c_int32, [c_void_p, FixtureId, c_float], {}),
        "ups_scene_set_fixture_transform": (c_int32, [c_void_p, FixtureId, POINTER(c_double)], {}),
        "ups_scene_remove_fixture": (c_int32, [c_void_p, FixtureId], {}),
        "ups_camera_desc_init": (None, [POINTER(CameraDesc), c_uint32], {}),
        "ups_meter_desc_init": (None, [POINTER(MeterDesc), c_uint32], {}),
        "ups_surface_meters_desc_init": (None, [POINTER(SurfaceMetersDesc), c_uint32], {}),
        "ups_lightmap_desc_init": (None, [POINTER(LightmapDesc), c_uint32], {}),
        "ups_scene_add_camera": (c_int32, [c_void_p, POINTER(CameraDesc), POINTER(SensorId)], {}),
        "ups_scene_add_meters": (c_int32, [c_void_p, POINTER(MeterDesc), POINTER(SensorId)], {}),
        "ups_scene_add_surface_meters": (c_int32, [c_void_p, POINTER(SurfaceMetersDesc), POINTER(SensorId)], {}),
        "ups_scene_add_lightmap": (c_int32, [c_void_p, POINTER(LightmapDesc), POINTER(SensorId)], {}),
        "ups_scene_set_camera": (c_int32, [c_void_p, SensorId, POINTER(CameraDesc)], {}),
        "ups_scene_set_meters": (c_int32, [c_void_p, SensorId, POINTER(MeterDesc)], {}),
        "ups_scene_set_surface_meters": (c_int32, [c_void_p, SensorId, POINTER(SurfaceMetersDesc)], {}),
        "ups_scene_set_lightmap": (c_int32, [c_void_p, SensorId, POINTER(LightmapDesc)], {}),
        "ups_scene_set_goniometer": (c_int32, [c_void_p, SensorId, POINTER(GoniometerDesc)], {}),
        "ups_scene_get_camera": (c_int32, [c_void_p, SensorId, POINTER(CameraDesc)], {}),
        "ups_scene_get_meters": (c_int32, [c_void_p, SensorId, POINTER(MeterDesc)], {}),
        "ups_scene_get_surface_meters": (c_int32, [c_void_p, SensorId, POINTER(SurfaceMetersDesc)], {}),
        "ups_scene_get_lightmap": (c_int32, [c_void_p, SensorId, POINTER(LightmapDesc)], {}),
        "ups_scene_get_goniometer": (c_int32, [c_void_p, SensorId, POINTER(GoniometerDesc)], {}),
        "ups_scene_read_meter_places": (c_int32, [c_void_p, SensorId, POINTER(MeterPlace), c_size_t, POINTER(c_size_t)],
            {}),
        "ups_en12464_desc_init": (None, [POINTER(En12464Desc), c_uint32], {}),
        "ups_en12464_grid": (c_int32, [POINTER(En12464Desc), POINTER(En12464Info), POINTER(En12464Point), c_size_t,
            POINTER(c_size_t)], {}),
        "ups_goniometer_desc_init": (None, [POINTER(GoniometerDesc), c_uint32], {}),
        "ups_scene_add_goniometer": (c_int32, [c_void_p, POINTER(GoniometerDesc), POINTER(SensorId)], {}),
        "ups_render_desc_init": (None, [POINTER(RenderDesc), c_uint32], {}),
        "ups_scene_estimate_memory": (c_int32, [c_void_p, POINTER(RenderDesc), POINTER(MemoryEstimate)], {}),
        "ups_render": (c_int32, [c_void_p, POINTER(RenderDesc), POINTER(c_void_p)], {}),
        "ups_job_start": (c_int32, [c_void_p, POINTER(RenderDesc), POINTER(c_void_p)], {}),
        "ups_job_poll": (c_int32, [c_void_p, POINTER(Progress)], {}),
        "ups_job_wait": (c_int32, [c_void_p, c_uint32], {1: "timeout_ms"}),
        "ups_job_get_prediction": (c_int32, [c_void_p, c_double, POINTER(Prediction)], {}),
        "ups_job_get_memory_estimate": (c_int32, [c_void_p, POINTER(MemoryEstimate)], {}),
        "ups_job_get_curve_count": (c_int32, [c_void_p, POINTER(c_uint32)], {}),
        "ups_job_get_curve_point": (c_int32, [c_void_p, c_uint32, POINTER(CurvePoint)], {1: "index"}),
        "ups_job_get_largest_error": (c_int32, [c_void_p, POINTER(LargestError)], {}),
        "ups_job_cancel": (None, [c_void_p], {}),
        "ups_job_result": (c_int32, [c_void_p, POINTER(c_void_p)], {}),
        "ups_job_destroy": (None, [c_void_p], {}),
        "ups_result_get_info": (c_int32, [c_void_p, POINTER(ResultInfo)], {}),
        "ups_result_get_choice": (c_int32, [c_void_p, SensorId, POINTER(SensorChoice)], {}),
        "ups_result_read_meters": (c_int32, [c_void_p, SensorId, POINTER(MeterReading), c_size_t], {}),
        "ups_result_view_meters": (c_int32, [c_void_p, SensorId, POINTER(POINTER(MeterReading)), POINTER(c_size_t)],
            {}),
        "ups_result_read_vectors": (c_int32, [c_void_p, SensorId, POINTER(VectorReading), c_size_t], {}),
        "ups_result_read_meter_part": (c_int32, [c_void_p, SensorId, c_int32, POINTER(MeterPartReading), c_size_t],
            {2: "part"}),
        "ups_result_read_vector_part": (c_int32, [c_void_p, SensorId, c_int32, POINTER(VectorPartReading), c_size_t],
            {2: "part"}),
        "ups_result_read_meter_flags": (c_int32, [c_void_p, SensorId, POINTER(c_uint32), c_size_t], {}),
        "ups_result_get_meter_statistics": (c_int32, [c_void_p, SensorId, POINTER(MeterStatistics)], {}),
        "ups_result_get_source_count": (c_int32, [c_void_p, POINTER(c_uint32)], {}),
        "ups_result_get_source": (c_int32, [c_void_p, c_uint32, POINTER(SourceInfo)], {1: "index"}),
        "ups_result_read_source_meters": (c_int32, [c_void_p, c_uint32, SensorId, POINTER(MeterReading), c_size_t],
            {1: "source"}),
        "ups_scene_get_source_count": (c_int32, [c_void_p, POINTER(c_uint32)], {}),
        "ups_scene_get_source": (c_int32, [c_void_p, c_uint32, POINTER(SceneSource)], {1: "index"}),
        "ups_scene_get_source_profile": (c_int32, [c_void_p, c_uint32, POINTER(c_void_p)], {1: "index"}),
        "ups_result_get_goniometer_info": (c_int32, [c_void_p, SensorId, POINTER(GoniometerInfo)], {}),
        "ups_result_read_goniometer": (c_int32, [c_void_p, SensorId, POINTER(IntensityReading), c_size_t], {}),
        "ups_result_get_goniometer_angles": (c_int32, [c_void_p, SensorId, POINTER(c_float), c_size_t, POINTER(c_float),
            c_size_t], {}),
        "ups_result_get_goniometer_beam": (c_int32, [c_void_p, SensorId, c_float, c_float, POINTER(GoniometerBeam)],
            {}),
        "ups_result_get_goniometer_profile": (c_int32, [c_void_p, SensorId, POINTER(c_void_p)], {}),
        "ups_result_read_image": (c_int32, [c_void_p, SensorId, c_int32, POINTER(c_float), c_size_t, c_size_t],
            {2: "channel"}),
        "ups_result_view_image": (c_int32, [c_void_p, SensorId, c_int32, POINTER(POINTER(c_float)), POINTER(c_uint32),
            POINTER(c_uint32)], {2: "channel"}),
        "ups_result_get_technique_count": (c_int32, [c_void_p, SensorId, POINTER(c_uint32)], {}),
        "ups_result_get_technique": (c_int32, [c_void_p, SensorId, c_uint32, POINTER(TechniqueInfo)], {2: "index"}),
        "ups_result_read_technique": (c_int32, [c_void_p, SensorId, c_uint32, c_int32, POINTER(c_float), c_size_t,
            c_size_t], {2: "index", 3: "contribution"}),
        "ups_result_read_convergence": (c_int32, [c_void_p, POINTER(ConvergencePoint), c_size_t, POINTER(c_size_t)],
            {}),
        "ups_result_get_prediction": (c_int32, [c_void_p, c_double, POINTER(Prediction)], {}),
        "ups_result_get_curve_count": (c_int32, [c_void_p, POINTER(c_uint32)], {}),
        "ups_result_get_curve_point": (c_int32, [c_void_p, c_uint32, POINTER(CurvePoint)], {1: "index"}),
        "ups_result_get_largest_error": (c_int32, [c_void_p, POINTER(LargestError)], {}),
        "ups_result_get_text": (c_int32, [c_void_p, c_int32, c_char_p, c_size_t, POINTER(c_size_t)], {1: "topic"}),
        "ups_result_destroy": (None, [c_void_p], {}),
        "ups_result_read_largest_samples": (c_int32, [c_void_p, SensorId, POINTER(Sample), c_size_t, POINTER(c_size_t)],
            {}),
        "ups_replay": (c_int32, [c_void_p, POINTER(RenderDesc), POINTER(Sample), POINTER(c_void_p)], {}),
        "ups_path_destroy": (None, [c_void_p], {}),
        "ups_path_get_info": (c_int32, [c_void_p, POINTER(PathInfo)], {}),
        "ups_path_read_vertices": (c_int32, [c_void_p, POINTER(PathVertex), c_size_t, POINTER(c_size_t)], {}),
        "ups_path_read_contributions": (c_int32, [c_void_p, POINTER(PathContribution), c_size_t, POINTER(c_size_t)],
            {}),
        "ups_path_get_text": (c_int32, [c_void_p, c_char_p, c_size_t, POINTER(c_size_t)], {}),
        "ups_result_get_meter_percentile": (c_int32, [c_void_p, SensorId, c_double, POINTER(Interval)], {}),
        "ups_result_get_meter_share": (c_int32, [c_void_p, SensorId, c_double, POINTER(Interval)], {}),
        "ups_result_get_meter_ratio": (c_int32, [c_void_p, SensorId, SensorId, POINTER(Interval)], {}),
        "ups_result_read_meter_ratios": (c_int32, [c_void_p, SensorId, SensorId, POINTER(Interval), c_size_t], {}),
        "ups_glare_get_position_index": (c_int32, [c_int32, POINTER(c_float), c_size_t, POINTER(c_float)], {0: "kind"}),
        "ups_glare_get_ugr": (c_int32, [POINTER(c_float), POINTER(c_float), POINTER(c_float), c_size_t, c_double,
            POINTER(c_float)], {}),
        "ups_profile_get_ugr_table": (c_int32, [c_void_p, POINTER(UgrTable)], {}),
        "ups_profile_get_data_sheet": (c_int32, [c_void_p, c_float, POINTER(DataSheet)], {}),
        "ups_profile_get_utilisation": (c_int32, [c_void_p, POINTER(UtilisationTable)], {}),
        "ups_observer_desc_init": (None, [POINTER(ObserverDesc), c_uint32], {}),
        "ups_scene_add_observer": (c_int32, [c_void_p, POINTER(ObserverDesc), POINTER(SensorId)], {}),
        "ups_scene_set_observer": (c_int32, [c_void_p, SensorId, POINTER(ObserverDesc)], {}),
        "ups_scene_get_observer": (c_int32, [c_void_p, SensorId, POINTER(ObserverDesc)], {}),
        "ups_result_get_observer": (c_int32, [c_void_p, SensorId, POINTER(ObserverReading)], {}),
        "ups_result_get_glare_source": (c_int32, [c_void_p, SensorId, c_uint32, POINTER(GlareSource)], {2: "index"}),
    },
    "ups_gltf": {
        "ups_gltf_import_desc_init": (None, [POINTER(GltfImportDesc), c_uint32], {}),
        "ups_gltf_import_file": (c_int32, [c_void_p, c_char_p, POINTER(GltfImportDesc), c_void_p, POINTER(c_void_p)],
            {}),
        "ups_gltf_import_destroy": (None, [c_void_p], {}),
        "ups_gltf_get_sensor_count": (c_int32, [c_void_p, POINTER(c_uint32)], {}),
        "ups_gltf_get_sensor": (c_int32, [c_void_p, c_uint32, POINTER(GltfSensorInfo)], {1: "index"}),
        "ups_gltf_get_sensor_name": (c_int32, [c_void_p, c_uint32, c_char_p, c_size_t, POINTER(c_size_t)],
            {1: "index"}),
        "ups_gltf_get_source_name": (c_int32, [c_void_p, c_int32, c_uint32, c_char_p, c_size_t, POINTER(c_size_t)],
            {1: "kind", 2: "id"}),
        "ups_gltf_get_source_file": (c_int32, [c_void_p, c_int32, c_uint32, c_char_p, c_size_t, POINTER(c_size_t)],
            {1: "kind", 2: "id"}),
        "ups_gltf_get_place": (c_int32, [c_void_p, c_int32, c_uint32, c_char_p, c_size_t, POINTER(c_size_t)],
            {1: "part", 2: "id"}),
        "ups_gltf_read_meters": (c_int32, [c_void_p, c_uint32, POINTER(c_double), POINTER(c_float), c_size_t],
            {1: "index"}),
        "ups_gltf_get_warnings": (c_int32, [c_void_p, c_char_p, c_size_t, POINTER(c_size_t)], {}),
        "ups_gltf_last_error": (c_char_p, [], {}),
    },
    "ups_exr": {
        "ups_exr_write": (c_int32, [c_char_p, c_uint32, c_uint32, POINTER(ExrChannel), c_uint32, POINTER(ExrAttribute),
            c_uint32], {1: "width", 2: "height", 4: "channel_count", 6: "attribute_count"}),
        "ups_exr_read": (c_int32, [c_char_p, POINTER(c_void_p)], {}),
        "ups_exr_image_destroy": (None, [c_void_p], {}),
        "ups_exr_get_size": (c_int32, [c_void_p, POINTER(c_uint32), POINTER(c_uint32)], {}),
        "ups_exr_get_channel_count": (c_int32, [c_void_p, POINTER(c_uint32)], {}),
        "ups_exr_get_channel_name": (c_int32, [c_void_p, c_uint32, c_char_p, c_size_t, POINTER(c_size_t)],
            {1: "index"}),
        "ups_exr_get_attribute": (c_int32, [c_void_p, c_char_p, c_char_p, c_size_t, POINTER(c_size_t)], {}),
        "ups_exr_read_channel": (c_int32, [c_void_p, c_char_p, POINTER(c_float), c_size_t], {}),
        "ups_exr_last_error": (c_char_p, [], {}),
    },
    "ups_ocio": {
        "ups_ocio_choose_exposure": (c_int32, [POINTER(c_float), c_uint32, c_uint32, POINTER(c_double)],
            {1: "width", 2: "height"}),
        "ups_ocio_get_ev100": (c_int32, [c_double, POINTER(c_double)], {}),
        "ups_ocio_get_exposure": (c_int32, [c_double, POINTER(c_double)], {}),
        "ups_ocio_write_png": (c_int32, [c_char_p, POINTER(c_float), c_uint32, c_uint32, c_double],
            {2: "width", 3: "height"}),
        "ups_ocio_picture_desc_init": (None, [POINTER(OcioPictureDesc), c_uint32], {}),
        "ups_ocio_write_picture_png": (c_int32, [c_char_p, POINTER(OcioPictureDesc)], {}),
        "ups_ocio_smooth_desc_init": (None, [POINTER(OcioSmoothDesc), c_uint32], {}),
        "ups_ocio_smooth": (c_int32, [POINTER(OcioSmoothDesc), POINTER(c_float)], {}),
        "ups_ocio_false_color_desc_init": (None, [POINTER(OcioFalseColorDesc), c_uint32], {}),
        "ups_ocio_write_false_color_png": (c_int32, [c_char_p, POINTER(OcioFalseColorDesc)], {}),
        "ups_ocio_write_pixels_png": (c_int32, [c_char_p, POINTER(c_uint8), c_uint32, c_uint32],
            {2: "width", 3: "height"}),
        "ups_ocio_last_error": (c_char_p, [], {}),
    },
    "ups_report": {
        "ups_report_style_desc_init": (None, [POINTER(ReportStyleDesc), c_uint32], {}),
        "ups_report_map_desc_init": (None, [POINTER(ReportMapDesc), c_uint32], {}),
        "ups_report_write_map": (c_int32, [c_char_p, POINTER(ReportMapDesc)], {}),
        "ups_report_page_desc_init": (None, [POINTER(ReportPageDesc), c_uint32], {}),
        "ups_report_write_page": (c_int32, [c_char_p, POINTER(ReportPageDesc)], {}),
        "ups_report_last_error": (c_char_p, [], {}),
    },
}

# Function that fills each description with its defaults.
INIT: dict[Any, str] = {
    ContextDesc: "ups_context_desc_init",
    ProfileDesc: "ups_profile_desc_init",
    ProfileParseDesc: "ups_profile_parse_desc_init",
    TextureDesc: "ups_texture_desc_init",
    MaterialDesc: "ups_material_desc_init",
    MeshDesc: "ups_mesh_desc_init",
    InstanceDesc: "ups_instance_desc_init",
    LightDesc: "ups_light_desc_init",
    LuminaireDesc: "ups_luminaire_desc_init",
    CommitDesc: "ups_commit_desc_init",
    FixtureEmitterDesc: "ups_fixture_emitter_desc_init",
    ReflectorDesc: "ups_reflector_desc_init",
    LensDesc: "ups_lens_desc_init",
    CollimatorDesc: "ups_collimator_desc_init",
    FixturePartDesc: "ups_fixture_part_desc_init",
    FixtureInstanceDesc: "ups_fixture_instance_desc_init",
    CameraDesc: "ups_camera_desc_init",
    MeterDesc: "ups_meter_desc_init",
    SurfaceMetersDesc: "ups_surface_meters_desc_init",
    LightmapDesc: "ups_lightmap_desc_init",
    En12464Desc: "ups_en12464_desc_init",
    GoniometerDesc: "ups_goniometer_desc_init",
    RenderDesc: "ups_render_desc_init",
    ObserverDesc: "ups_observer_desc_init",
    GltfImportDesc: "ups_gltf_import_desc_init",
    OcioPictureDesc: "ups_ocio_picture_desc_init",
    OcioSmoothDesc: "ups_ocio_smooth_desc_init",
    OcioFalseColorDesc: "ups_ocio_false_color_desc_init",
    ReportStyleDesc: "ups_report_style_desc_init",
    ReportMapDesc: "ups_report_map_desc_init",
    ReportPageDesc: "ups_report_page_desc_init",
}
