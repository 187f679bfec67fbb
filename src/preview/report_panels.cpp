// The sections that tell of the scene, of time and of the pixel under the mouse.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "preview/panels.h"

namespace vernier {
namespace {

/// Memory of the program that is in use, as Linux tells it; 0 where it does not.
std::uint64_t resident_bytes() {
  constexpr std::uint64_t kPageBytes = 4096;
  std::ifstream file("/proc/self/statm");
  std::uint64_t total = 0, resident = 0;
  return file >> total >> resident ? resident * kPageBytes : 0;
}

std::string camera_text(const Scene& scene, std::size_t index) {
  const std::string& name = scene.cameras[index].name;
  return std::to_string(index + 1) + "  " + (name.empty() ? "camera" : name);
}

/// A number or name of what a pixel sees.
std::string numbered(const char* what, std::uint32_t index, const std::string& name) {
  return std::string(what) + " " + std::to_string(index) + (name.empty() ? "" : " " + name);
}

void draw_error_plot(const std::vector<ErrorHistory::Point>& points) {
  std::vector<float> logarithms;
  for (const ErrorHistory::Point& point : points) logarithms.push_back(std::log10(std::max(point.error, 1e-7f)));
  const auto [least, most] = std::ranges::minmax(logarithms);
  const std::string title =
      format_text("%.2g after %.1f s", static_cast<double>(points.back().error), points.back().seconds);
  const ImVec2 size{ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 5.0f};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  canvas.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 4.0f);
  const float pad = ImGui::GetFontSize() * 0.7f;
  const auto place = [&](std::size_t index) {
    const auto along = static_cast<float>(points[index].seconds / std::max(points.back().seconds, 1e-9));
    const float up = (logarithms[index] - least) / std::max(most - least, 0.1f);
    return ImVec2{corner.x + pad + along * (size.x - 2.0f * pad), corner.y + size.y - pad - up * (size.y - 2.0f * pad)};
  };
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_PlotHistogram);
  for (std::size_t index = 0; index < points.size(); ++index) {
    if (index > 0) canvas.AddLine(place(index - 1), place(index), ink, 2.0f);
    canvas.AddCircleFilled(place(index), 3.0f, ink);
  }
  ImGui::Dummy(size);
  quiet_text("error below " + title + " (sqrt relMSE, 95 %)");
}

}  // namespace

void draw_scene_section(const ViewSession& session, PanelState& state, PanelActions& actions) {
  if (!section("Scene", true)) return;
  const Scene& scene = session.scene();
  const std::string& source = session.viewed().source;
  ImGui::TextWrapped("%s", source.empty() ? "the built-in scene" : source.c_str());
  quiet_text(counted(session.packed().triangle_count, "triangle") + ", " + counted(scene.instances.size(), "instance") +
             ", " + counted(scene.materials.size(), "material") + ", " + counted(scene.textures.size(), "texture") +
             ", " + counted(scene.lights.size(), "light"));
  quiet_text(byte_text(session.device_bytes()) + " on the device, " + byte_text(resident_bytes()) +
             " of memory; read in " + format_text("%.2f s", session.viewed().load_ms / 1000.0));
  for (std::size_t index = 0; index < scene.cameras.size(); ++index) {
    // Until it is moved.
    const bool is_looked_through = session.camera().world_from_camera == scene.cameras[index].world_from_camera;
    if (ImGui::Selectable((camera_text(scene, index) + "##" + std::to_string(index)).c_str(), is_looked_through))
      actions.camera = index;
    note_place(state.places, "Camera " + std::to_string(index + 1));
  }
  for (const std::string& warning : scene.warnings) alarm_text(warning);
}

void draw_time_section(const ViewSession& session) {
  if (!section("Time", true)) return;
  const PictureState& picture = session.state();
  quiet_text(
      format_text("%.2f million rays per second, %.0f ms per tile", picture.rays_per_s * 1e-6, picture.ms_per_tile));
  quiet_text(
      format_text("%.1f s for this picture; %.0f ms while the camera moves", picture.seconds, picture.coarse_ms));
  const ErrorHistory& errors = session.errors();
  if (errors.not_finite() > 0) {
    alarm_text("Not finite: " + counted(errors.not_finite(), "pixel"));
  } else if (errors.points().empty()) {
    quiet_text("The error is estimated once every pixel has two passes.");
  } else {
    draw_error_plot(errors.points());
  }
}

void draw_pixel_section(const ViewSession& session, const PanelState& state) {
  if (!section("Pixel", true)) return;
  // Always three lines, so that nothing below jumps.
  if (!state.pixel) {
    quiet_text("Point at the picture to see what is there.");
    quiet_text(" \n ");
    return;
  }
  const PixelFacts& pixel = *state.pixel;
  ImGui::TextUnformatted(format_text("%d, %d   %.4g  %.4g  %.4g", state.pixel_place.x, state.pixel_place.y,
                                     static_cast<double>(pixel.color.x), static_cast<double>(pixel.color.y),
                                     static_cast<double>(pixel.color.z))
                             .c_str());
  const std::string counts = format_text("%u samples, %.1f rays each", pixel.samples, pixel.rays);
  if (pixel.object == std::numeric_limits<std::uint32_t>::max()) {
    quiet_text(counts + "\nbackground");
    return;
  }
  const Scene& scene = session.scene();
  const auto name_of = [](const auto& things, std::uint32_t index) {
    return index < things.size() ? things[index].name : std::string();
  };
  quiet_text(counts + format_text(", %.4g m away", static_cast<double>(pixel.depth_m)) + "\n" +
             numbered("triangle", pixel.primitive, "") + ", " + numbered("object", pixel.object, "") + ", " +
             numbered("material", pixel.material, name_of(scene.materials, pixel.material)));
}

}  // namespace vernier
