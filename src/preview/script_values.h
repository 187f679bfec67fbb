#pragma once

#include "preview/panels.h"
#include "preview/script.h"

namespace vernier {

/// What `set NAME VALUE` changes: the panels' state as the widgets would, and what follows from it. Throws Error(usage)
/// with the line for an unknown name or a value that makes no sense.
void set_by_script(const ScriptEvent& event, PanelState& state, PanelActions& actions);

}  // namespace vernier
