#include "cli/diff_report.h"

#include <cstdio>

#include "image/color_image.h"

namespace vernier {
namespace {

// `name   figure`, the figures in one column.
std::string line(const char* name, const char* format, double value) {
  char figure[64];
  std::snprintf(figure, sizeof figure, format, value);
  char text[96];
  std::snprintf(text, sizeof text, "%-12s %s", name, figure);
  return std::string(text) + "\n";
}

}  // namespace

ImageFile flip_map_image(const FlipError& flip) {
  std::vector<float> values;
  values.reserve(flip.map.size() * 3);
  for (const float error : flip.map) {
    values.insert(values.end(), {error, error, error});
  }
  return file_of_image(Image{flip.width, flip.height, 3, std::move(values)});
}

std::string diff_table(const DiffReport& report) {
  const Difference& difference = report.difference;
  if (difference.compared_pixels == 0) return "no pixel is finite in both images\n";
  std::string table = line("RMSE", "%.9g", difference.rmse) + line("relMSE", "%.9g", difference.rel_mse) +
                      line("PSNR", "%.6g dB", difference.psnr_db) + line("max", "%.9g", difference.max_absolute);
  if (difference.max_absolute > 0.0) {
    table.back() = ' ';
    table += "at pixel " + std::to_string(difference.max_x) + "," + std::to_string(difference.max_y) + "\n";
  }
  table += line("FLIP mean", "%.6g", report.flip.mean) + line("FLIP p99", "%.6g", report.flip.p99);
  table += "non-finite   " + std::to_string(difference.non_finite_a) + " pixels in A, " +
           std::to_string(difference.non_finite_b) + " in B\n";
  return table;
}

nlohmann::ordered_json diff_json(const DiffReport& report) {
  const Difference& difference = report.difference;
  return {{"schema", 1},
          {"a", report.a},
          {"b", report.b},
          {"width", report.flip.width},
          {"height", report.flip.height},
          {"rmse", difference.rmse},
          {"rel_mse", difference.rel_mse},
          {"psnr_db", difference.psnr_db},
          {"max", difference.compared_pixels > 0 ? nlohmann::ordered_json(difference.max_absolute) : nullptr},
          {"max_pixel", {difference.max_x, difference.max_y}},
          {"mean_signed", difference.mean_signed},
          {"flip", {{"mean", report.flip.mean}, {"p99", report.flip.p99}}},
          {"non_finite", {{"a", difference.non_finite_a}, {"b", difference.non_finite_b}}},
          {"compared_pixels", difference.compared_pixels}};
}

}  // namespace vernier
