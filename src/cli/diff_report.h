#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "image/difference.h"
#include "image/flip.h"
#include "image/image.h"

namespace vernier {

/// What `vernier diff` found.
struct DiffReport {
  std::string a;
  std::string b;
  Difference difference;
  FlipError flip;
};

/// The FLIP map as a colour layer R = G = B for write_image.
ImageFile flip_map_image(const FlipError& flip);

/// A line per figure for people.
std::string diff_table(const DiffReport& report);

/// {"schema": 1, "a", "b", "width", "height", "rmse", "rel_mse", "psnr_db", "max", "max_pixel", "mean_signed", "flip":
/// {"mean", "p99"}, "non_finite": {"a", "b"}, "compared_pixels"}; null for what is infinite (psnr_db of equal images)
/// or not a number.
nlohmann::ordered_json diff_json(const DiffReport& report);

}  // namespace vernier
