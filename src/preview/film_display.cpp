#include "preview/film_display.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "shared/bindings.h"
#include "spirv/display.h"

namespace vernier {
namespace {

constexpr std::uint32_t kWorkgroupSide = 8;

std::vector<std::byte> bytes_of(const DisplayConstants& constants) {
  std::vector<std::byte> bytes(sizeof(constants));
  std::memcpy(bytes.data(), &constants, sizeof(constants));
  return bytes;
}

}  // namespace

FilmDisplay::FilmDisplay(const Device& device, Film& film)
    : film_(film),
      words_(device, std::uint64_t{4} * film.area().width * film.area().height, BufferUse::storage),
      submitter_(device) {
  for (Film::Band& band : film.bands()) {
    const std::vector<Binding> bindings = {
        {BINDING_FILM, &band.sums}, {BINDING_AOVS, &band.aovs}, {BINDING_DISPLAY, &words_}};
    if (bindings_.empty()) {
      pipeline_ = ComputePipeline(device, kDisplaySpirv, bindings, sizeof(DisplayConstants), {});
    }
    bindings_.emplace_back(device, pipeline_, bindings);
  }
}

void FilmDisplay::draw(glm::ivec2 size, const DisplaySettings& settings) {
  std::vector<Dispatch> dispatches;
  for (std::size_t index = 0; index < film_.bands().size(); ++index) {
    const Film::Band& band = film_.bands()[index];
    const int rows = std::min(band.row_count, size.y - band.first_row);
    if (rows <= 0) break;
    DisplayConstants constants{};
    constants.width = static_cast<std::uint32_t>(size.x);
    constants.height = static_cast<std::uint32_t>(rows);
    constants.row_pixels = static_cast<std::uint32_t>(film_.area().width);
    constants.first_row = static_cast<std::uint32_t>(band.first_row);
    constants.exposure = std::exp2(settings.exposure_ev);
    constants.far_depth = settings.far_depth_m;
    constants.layer = settings.layer;
    dispatches.push_back({.pipeline = &pipeline_,
                          .bindings = &bindings_[index],
                          .push_constants = bytes_of(constants),
                          .group_count_x = (constants.width + kWorkgroupSide - 1) / kWorkgroupSide,
                          .group_count_y = (constants.height + kWorkgroupSide - 1) / kWorkgroupSide,
                          .group_count_z = 1});
  }
  submitter_.run(dispatches);
}

}  // namespace vernier
