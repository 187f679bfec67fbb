#pragma once

#include <string>

#include "accuracy/cost_plan.h"
#include "cli/render_options.h"
#include "cli/sample_command.h"
#include "cli/scene_options.h"

namespace vernier {

/// The command line, for a POSIX shell, that renders with the settings of `point`, a point of a sweep whose scene,
/// options and size these are. It writes render.exr.
std::string point_command(SceneArguments scene, RenderArguments render, const RenderSettings& settings,
                          const CostPoint& point);

}  // namespace vernier
