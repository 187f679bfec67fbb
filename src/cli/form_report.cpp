#include "cli/form_report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace vernier {
namespace {

std::string line_of(const FormTiming& one) {
  char text[256];
  const std::string name(to_string(one.form));
  if (!one.left_out.empty()) return "    " + name + std::string(18 - name.size(), ' ') + one.left_out + "\n";
  std::snprintf(text, sizeof text, "    %-17s %5.2f  (%.2f to %.2f) %9.1f ms %9.0f ms\n", name.c_str(),
                one.ratio.median, one.ratio.least, one.ratio.most, one.device_ms, one.compile_ms);
  return text;
}

}  // namespace

std::string form_table(const FormCalibration& found) {
  const std::string usual(to_string(found.usual)), best(to_string(found.best));
  std::string text = "    form              time over " + usual + "'s    a picture  compiling\n";
  for (const FormTiming& one : found.forms) text += line_of(one);
  return text + "--traversal auto is " + best + (found.best == found.usual ? ", as without a calibration" : "");
}

nlohmann::ordered_json form_json(const std::string& device, const FormCalibration& found) {
  nlohmann::ordered_json json = {
      {"device", device}, {"usual", to_string(found.usual)}, {"best", to_string(found.best)}, {"forms", {}}};
  for (const FormTiming& one : found.forms) {
    nlohmann::ordered_json timed = {{"form", to_string(one.form)}, {"left_out", one.left_out}};
    if (one.left_out.empty()) {
      timed["compile_ms"] = one.compile_ms;
      timed["device_ms"] = one.device_ms;
      timed["over_usual"] = {{"median", one.ratio.median}, {"least", one.ratio.least}, {"most", one.ratio.most}};
    } else {
      timed["compile_ms"] = timed["device_ms"] = timed["over_usual"] = nullptr;
    }
    json["forms"].push_back(timed);
  }
  return json;
}

}  // namespace vernier
