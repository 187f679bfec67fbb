#pragma once

#include <map>
#include <string>
#include <vector>

namespace vernier {

/// Counts faults by kind and remembers where the first of each was.
class FaultList {
 public:
  /// `source` starts every line.
  explicit FaultList(std::string source) : source_(std::move(source)) {}
  /// One more fault of `kind` ("triangles with a non-finite corner are dropped") at `place` ("mesh 3, triangle 7").
  void add(const std::string& kind, const std::string& place);
  /// One of the faults, without the source; empty where there is none.
  std::string first_fault() const;
  /// Appends a line for each kind: "scene.obj: mesh 3, triangle 7 and 4 more: KIND".
  void append_to(std::vector<std::string>& warnings) const;

 private:
  struct Fault {
    std::string first_place;
    std::size_t count = 0;
  };
  static std::string line_of(const std::string& kind, const Fault& fault);

  std::string source_;
  std::map<std::string, Fault> by_kind_;
};

}  // namespace vernier
