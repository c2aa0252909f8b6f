// UPS for C++17: the C API as classes that free what they own. Header only; link the library as a C program does.
//
//   ups::Context context;
//   ups::Scene scene(context);
//   const auto walls = scene.add_mesh({positions, indices, scene.add_material(ups::MaterialDesc(0.8f))});
//   scene.add_instance({walls});
//   const auto lamp = scene.add_luminaire({profile, ups::Transform::translation(2, 1.5, 2.5)});
//   const auto grid = scene.add_meters({points, normals});
//   scene.commit();
//   ups::RenderDesc render;  // filled with the defaults
//   render.target_relative_error = 0.02f;
//   for (const auto &reading : scene.render(render).read_meters(grid)) use(reading.illuminance_lx);
//   scene.set_luminaire_transform(lamp, ups::Transform::aim({2, 1.5, 2.5}, {3, 1.5, 0.75}));
//
// Rules, beside those of ups_base.h
//   - A class is a C handle, a method the C function without its prefix: Scene::set_dimming is ups_scene_set_dimming.
//     What it does, its units, ranges and errors are told there. What C writes to its last argument is returned; two
//     functions that ask for a count and for one of them are one that returns all. Ids, enumerators and plain structs
//     are C's own.
//   - XDesc is ups_x_desc, filled with the defaults; constructors take what a program nearly always sets. Its arrays
//     are the caller's: they must be there until the call that takes the desc.
//   - Handles are moved, never copied, and freed by their destructors, in any order. Of one that was moved from every
//     method that can fail throws Error of UPS_ERROR_INVALID_ARGUMENT, as the library refuses NULL. get() lends the C
//     handle, for any C function; release() gives it up.
//   - Failures are exceptions of class Error, which has the status; std::bad_alloc comes from arrays that are returned.
//     Where a method throws nothing has changed, as in C. A program without exceptions uses the C API: its statuses are
//     the way that does not throw. Destructors and moves do not throw.
//   - A method may run beside others where its C function may: the table is in ups_base.h. const is as in C.
#ifndef UPS_HPP
#define UPS_HPP

#include "hpp/base.hpp"
#include "hpp/transform.hpp"
#include "hpp/profile.hpp"
#include "hpp/descs.hpp"
#include "hpp/fixture.hpp"
#include "hpp/replay.hpp"
#include "hpp/result.hpp"
#include "hpp/job.hpp"
#include "hpp/scene.hpp"
#include "hpp/standards.hpp"

#endif
