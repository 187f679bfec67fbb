#pragma once

#include <cstddef>
#include <functional>
#include <mutex>

namespace vernier {

/// Told of `count` more triangles that a stage of the build has done with, by any of its threads; may be empty.
using CountDone = std::function<void(std::size_t count)>;

/// Adds up what the stages of a build have done.
class BuildProgress {
 public:
  /// `tell(share)`, may be empty, gets the share in [0, 1] that is done of a build of `triangle_count` triangles: from
  /// any thread, never from two at once, and never less than before.
  BuildProgress(std::function<void(double share)> tell, std::size_t triangle_count);

  /// For the stage that makes the binary tree: three quarters of all, roughly.
  CountDone tree_stage();
  /// For the stage that writes records.
  CountDone record_stage();

 private:
  CountDone stage(double share);

  std::mutex mutex_;
  std::function<void(double share)> tell_;
  double share_per_triangle_;
  double done_ = 0.0;
};

}  // namespace vernier
