#include "gpu/pipeline_store.h"

#include <algorithm>

namespace vernier {

std::shared_ptr<const CompiledPipeline> PipelineStore::find_or_make(const Key& key,
                                                                    const std::function<CompiledPipeline()>& make) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(pipelines_, key, &decltype(pipelines_)::value_type::first);
    if (found != pipelines_.end()) {
      pipelines_.splice(pipelines_.begin(), pipelines_, found);
      return found->second;
    }
  }
  const auto made = std::make_shared<const CompiledPipeline>(
      make());  // takes seconds: others need not wait, and two may make the same
  const std::lock_guard lock(mutex_);
  pipelines_.emplace_front(key, made);
  if (pipelines_.size() > kMostPipelines) pipelines_.pop_back();
  return made;
}

}  // namespace vernier
