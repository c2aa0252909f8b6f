"""UPS for Python: illuminance and luminance by Unified Path Sampling.

    context = ups.Context()
    scene = ups.Scene(context)
    white = scene.add_material(reflectance_rgb=(0.8, 0.8, 0.8))
    ...
    scene.commit()
    result = scene.render(iteration_count=100, progress=True)
    result.meters(sensor)["illuminance_lx"]

The names, units and defaults are those of the C headers (include/ups), where each function and field is described:
keyword arguments are the fields of the C description of the same name. Arrays are numpy's, in and out. Every failure
raises ups.Error, which has the library's status; a value of a wrong type, shape or range TypeError or ValueError.
Objects free themselves; close() or a `with` block does it at once, in any order. Pictures with matplotlib: ups.plot.
"""
from . import _ffi
from ._convert import translation
from ._core import Context, version
from ._ffi import (AlphaMode, Channel, CollimatorWall, Contribution, Criterion, Effect, EmitterShape, Finish,
                   FixtureId, FixturePartId, GlareFlag, GlareMetric, GltfLayout, GltfPart, GltfSensorKind, InstanceId,
                   JobState, Layer, LightKind, LightPart, Limit, LogLevel, LuminaireId, MaterialId, MaterialModel, MeshId,
                   MeterKind, Method, Observer, OpeningShape, PathEvent, Perturbation, PhotometricType, Photons,
                   PositionIndex, Priority, ProfileFormat, ProfileSymmetry, Progress, Projection, Reading,
                   ReflectorProfile, ReportColours, ReportExposure, ReportQuantity, ReportScale, ResultText, SceneText,
                   SensorId, Separation, SourceKind, Status, Technique, TextureId, Walk)
from ._edits import CommitJob
from ._fixture import Fixture
from ._glare import position_index, ugr
from ._gltf import GltfImport, GltfSensor
from ._grid import en12464_grid
from ._images import (ExrImage, choose_exposure, ev100, exposure_of_ev100, read_exr, smooth, write_exr,
                      write_false_color_png, write_png)
from ._job import Job
from ._profile import Profile
from ._report import Picture, write_image_map, write_map, write_points_map, write_report
from ._result import ReplayedPath, Result
from ._scene import Scene
from ._status import Error

__all__ = ["AlphaMode", "Channel", "CollimatorWall", "CommitJob", "Context", "Contribution", "Criterion", "Effect",
           "EmitterShape", "Error", "ExrImage", "Finish", "Fixture", "FixtureId", "FixturePartId", "GlareFlag",
           "GlareMetric", "GltfImport", "GltfLayout", "GltfPart", "GltfSensor", "GltfSensorKind", "InstanceId", "Job",
           "JobState", "Layer", "LightKind", "LightPart", "Limit", "LogLevel", "LuminaireId", "MaterialId", "MaterialModel",
           "MeshId", "MeterKind", "Method", "Observer", "OpeningShape", "PathEvent", "Perturbation", "PhotometricType",
           "Photons", "Picture", "PositionIndex", "Priority", "Profile", "ProfileFormat", "ProfileSymmetry", "Progress",
           "Projection", "Reading", "ReflectorProfile", "ReplayedPath", "ReportColours", "ReportExposure",
           "ReportQuantity", "ReportScale", "Result", "ResultText", "Scene", "SceneText", "SensorId", "Separation",
           "SourceKind", "Status", "Technique", "TextureId", "Walk", "choose_exposure", "en12464_grid", "ev100",
           "exposure_of_ev100", "position_index", "read_exr", "smooth", "translation", "ugr", "version", "write_exr",
           "write_false_color_png", "write_image_map", "write_map", "write_png", "write_points_map", "write_report"]

for _class in (CommitJob, Context, Error, ExrImage, Fixture, GltfImport, GltfSensor, Job, Picture, Profile, ReplayedPath,
               Result, Scene):
    _class.__module__ = __name__  # tracebacks say ups.Error, the name that programs know
