#pragma once

#include <string>

#include "cli/render_command.h"
#include "render/render_statistics.h"

namespace vernier {

/// `text` as one word of a POSIX shell: as it is where no character means anything to a shell, else in single quotes.
std::string shell_word(const std::string& text);

/// The command line, for a POSIX shell, that renders `scene` to the file `output` by the options of `render`. Those
/// that are at their defaults are left out.
std::string short_render_command(const SceneArguments& scene, const RenderArguments& render, const std::string& output);

/// The command line, for a POSIX shell, that traces the sample at `place` of the render that `plan` describes, and
/// nothing else: every option that decides a bit of the image, and the device the render ran on. It writes sample.exr.
std::string sample_command(const RenderPlan& plan, const std::string& device, const SamplePlace& place);

/// The end of a line about a render that was stopped, `; go on by: vernier render ...`: the command line, for a POSIX
/// shell, that resumes it from its checkpoint on the device it ran on. Empty without a checkpoint.
std::string resume_hint(const RenderPlan& plan, const std::string& device);

/// What ended a render before its end, as words of a message.
std::string stop_reason();

/// The line about a render that ended before its first sample.
std::string no_sample_text(const RenderPlan& plan, const std::string& device);

}  // namespace vernier
