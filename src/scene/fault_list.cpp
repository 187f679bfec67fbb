#include "scene/fault_list.h"

namespace vernier {

void FaultList::add(const std::string& kind, const std::string& place) {
  Fault& fault = by_kind_[kind];
  if (fault.count++ == 0) fault.first_place = place;
}

void FaultList::append_to(std::vector<std::string>& warnings) const {
  for (const auto& [kind, fault] : by_kind_) {
    const std::string more = fault.count > 1 ? " and " + std::to_string(fault.count - 1) + " more" : "";
    warnings.push_back(source_ + ": " + fault.first_place + more + ": " + kind);
  }
}

}  // namespace vernier
