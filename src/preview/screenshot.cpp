#include "preview/screenshot.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "image/color_image.h"
#include "image/srgb_curve.h"
#include "image/write_image.h"

namespace vernier {

void write_screenshot(const std::string& path, const Image& picture) {
  std::error_code failure;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failure);
  // What writes pictures applies the curve: taken off here, it gives the same bytes back.
  std::vector<float> linear(picture.values.size());
  for (std::size_t value = 0; value < linear.size(); ++value) {
    linear[value] = static_cast<float>(linear_from_srgb(static_cast<double>(picture.values[value])));
  }
  write_image(path, file_of_image({picture.width, picture.height, 3, std::move(linear)}), {});
}

std::string places_json(const WidgetPlaces& places, const ViewSession& session, bool settled,
                        const std::string& message) {
  nlohmann::ordered_json json;
  for (const auto& [name, place] : places) json["places"][name] = {place.x, place.y, place.z, place.w};
  json["samples"] = session.state().samples_done;
  json["share"] = session.state().samples_done / session.settings().spp;
  json["rendering"] = session.state().rendering;
  json["settled"] = settled;
  json["message"] = message;
  return json.dump() + "\n";
}

}  // namespace vernier
