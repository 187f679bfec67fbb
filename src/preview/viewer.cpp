#include "preview/viewer.h"

#include <cstdio>
#include <optional>

#include "error.h"
#include "math/elapsed.h"
#include "preview/view_window.h"

namespace vernier {
namespace {

using Clock = std::chrono::steady_clock;

/// A device that is lost again so soon is beyond repair.
constexpr double kLostAgainSeconds = 10.0;

/// Room for small pictures, so that the panels can be read beside them.
const glm::ivec2 kLeastRoom(480, 680);

}  // namespace

void view_scene(const ViewPlan& plan) {
  const auto load = [](const ViewPlan& wanted) {
    const RenderSettings& settings = wanted.settings;
    return wanted.load_scene(wanted.source, wanted.words, aspect_of(settings));
  };
  ViewedScene first = load(plan);
  const glm::ivec2 room = glm::max(glm::ivec2(plan.settings.width, plan.settings.height), kLeastRoom);
  Window window("Vernier", room + glm::ivec2(kPanelWidth, 0));
  ViewPlan current = plan;
  while (true) {
    const Clock::time_point start = Clock::now();
    ViewWindow view(current, window, std::move(first));
    try {
      return view.run();
    } catch (const Error& error) {
      const bool again = !current.message.empty() && seconds_since(start) < kLostAgainSeconds;
      if (error.kind() != ErrorKind::device_lost || again) throw;
      ViewPlan anew = view.plan_of_now();
      anew.message = std::string(error.what()) + "; it was opened anew";
      current = std::move(anew);
    }
    first = load(current);
  }
}

}  // namespace vernier
