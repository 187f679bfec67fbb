#include "scene/fault_list.h"

namespace vernier {

void FaultList::add(const std::string& kind, const std::string& place) {
  Fault& fault = by_kind_[kind];
  if (fault.count++ == 0) fault.first_place = place;
}

std::string FaultList::line_of(const std::string& kind, const Fault& fault) {
  const std::string more = fault.count > 1 ? " and " + std::to_string(fault.count - 1) + " more" : "";
  return fault.first_place + more + ": " + kind;
}

std::string FaultList::first_fault() const {
  return by_kind_.empty() ? "" : line_of(by_kind_.begin()->first, by_kind_.begin()->second);
}

void FaultList::append_to(std::vector<std::string>& warnings) const {
  for (const auto& [kind, fault] : by_kind_) warnings.push_back(source_ + ": " + line_of(kind, fault));
}

}  // namespace vernier
