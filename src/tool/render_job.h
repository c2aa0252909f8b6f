// A render as the commands run it: with the program's limits, a bar on standard error, and Ctrl-C. Called by the
// commands render and goniometer; replay has its desc checked.
#pragma once
#include "tool/commands.h"
#include "tool/handles.h"

namespace ups::tool {

struct Finished {
  Result result;  // none: interrupted before the first iteration
  bool complete;  // false: interrupted
  double target, time_limit_s;  // that the render had; 0: none
  ups_memory_estimate memory;
  std::string failure;          // why it ended early, where it has results all the same
  int exit_code() const;
};

// Of a call with the desc that the command line filled: throws what the core says of it, with options for the desc's
// fields; WrongUsage where they do not go with each other or the scene.
void check_options(ups_status status);

// desc: without any limit it gets those of the program, 2 % and 60 s. Throws Failure.
Finished run_render(const ups_scene* scene, ups_render_desc desc);

// On standard error, what a render has that was interrupted or ran out of memory; nothing of a complete one.
void tell_interruption(const Finished& finished);

}  // namespace ups::tool
