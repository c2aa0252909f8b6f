// A path in its room, in plan and in section. Called by the replay command.
#pragma once
#include "report/drawing.h"
#include "tool/handles.h"

namespace ups::tool {

Drawing plot_of(const ups_scene* scene, const std::vector<ups_path_vertex>& vertices,
                const std::vector<ups_path_contribution>& contributions, const std::string& title);

}  // namespace ups::tool
