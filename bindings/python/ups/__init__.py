"""UPS for Python: illuminance and luminance by Unified Path Sampling.

    context = ups.Context()
    scene = ups.Scene(context)
    white = scene.add_material(reflectance_rgb=(0.8, 0.8, 0.8))
    ...
    scene.commit()
    result = scene.render(iteration_count=100)
    result.meters(sensor)["illuminance_lx"]

The names, units and defaults are those of the C headers (include/ups), where each function and field is described:
keyword arguments are the fields of the C description of the same name. Arrays are numpy's, in and out. Every failure
raises ups.Error. Objects free themselves; close() or a `with` block does it at once, in any order.
"""
from . import _ffi
from ._core import Context, Error, translation, version
from ._ffi import (AlphaMode, Channel, CollimatorWall, Contribution, Criterion, Effect, EmitterShape, Finish,
                   GlareFlag, GlareMetric, JobState, Layer, LightKind, LightPart, Limit, LogLevel, MaterialModel,
                   MeterKind, Method, Observer, OpeningShape, PathEvent, Perturbation, PhotometricType, Photons,
                   PositionIndex, ProfileFormat, ProfileSymmetry, Projection, Reading, ReflectorProfile, ResultText,
                   SceneText, Separation, SourceKind, Status, Technique, Walk)
from ._fixture import Fixture
from ._glare import position_index, ugr
from ._grid import en12464_grid
from ._profile import Profile
from ._result import Job, ReplayedPath, Result
from ._scene import Scene

__all__ = ["AlphaMode", "Channel", "CollimatorWall", "Context", "Contribution", "Criterion", "Effect", "EmitterShape",
           "Error", "Finish", "Fixture", "GlareFlag", "GlareMetric", "Job", "JobState", "Layer", "LightKind",
           "LightPart", "Limit", "LogLevel", "MaterialModel", "MeterKind", "Method", "Observer", "OpeningShape",
           "PathEvent", "Perturbation", "PhotometricType", "Photons", "PositionIndex", "Profile", "ProfileFormat",
           "ProfileSymmetry", "Projection", "Reading", "ReflectorProfile", "ReplayedPath", "Result", "ResultText",
           "Scene", "SceneText", "Separation", "SourceKind", "Status", "Technique", "Walk", "en12464_grid",
           "position_index", "translation", "ugr", "version"]

for _class in (Context, Error, Fixture, Job, Profile, ReplayedPath, Result, Scene):
    _class.__module__ = __name__  # tracebacks say ups.Error, the name that programs know
