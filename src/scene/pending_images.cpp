#include "scene/pending_images.h"

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "error.h"
#include "math/parallel_for.h"

namespace vernier {

/// An image, and what became of it.
struct PendingImage {
  ImageJob job;
  std::shared_ptr<const Texels> placeholder;
  std::shared_ptr<const Texels> texels = nullptr;
  std::string fault = "";
  bool has_ended = false;
};

namespace {

/// Nobody reads more.
constexpr std::size_t kMaxWarnings = 100;

void decode(PendingImage& image) {
  // What it holds of the file is let go with it.
  const auto decode_it = std::exchange(image.job.decode, nullptr);
  try {
    image.texels = decode_it();
  } catch (const MemoryError&) {
    throw;
  } catch (const Error& failure) {
    if (failure.kind() != ErrorKind::refused) throw;  // not the image's fault
    image.fault = image.job.before_fault + failure.what() + image.job.after_fault;
    if (image.job.needed) throw Error(ErrorKind::refused, image.fault);
  }
}

/// Adds `faults` to `warnings`, each line once: an image may be decoded for several uses.
void tell_faults(const std::vector<std::string>& faults, std::vector<std::string>& warnings) {
  std::unordered_set<std::string> told(warnings.begin(), warnings.end());
  std::size_t count = 0;
  for (const std::string& fault : faults) {
    if (!told.insert(fault).second || count > kMaxWarnings) continue;
    warnings.push_back(count++ < kMaxWarnings ? fault : "further broken images are left out");
  }
}

/// Takes out the textures without texels; who uses one goes without.
void drop_textures_without_texels(Scene& scene) {
  std::vector<int> number;
  int count = 0;
  for (const Texture& texture : scene.textures) number.push_back(texture.texels != nullptr ? count++ : -1);
  if (static_cast<std::size_t>(count) == scene.textures.size()) return;
  std::erase_if(scene.textures, [](const Texture& texture) { return texture.texels == nullptr; });
  const auto renumber = [&](int& texture) {
    if (texture >= 0) texture = number[static_cast<std::size_t>(texture)];
  };
  for (Material& material : scene.materials) {
    for (TextureUse& use : material.textures) renumber(use.texture);
  }
  renumber(scene.environment.texture);
}

}  // namespace

/// What the threads share.
struct PendingImages::Work {
  std::mutex mutex;
  std::condition_variable has_changed;
  std::deque<PendingImage> images;  // stay where they are when others are added
  std::size_t next = 0;             // that nobody has begun with
  bool is_complete = false;         // no image will be added
  std::exception_ptr failure;
  std::size_t failed = 0;  // image of the failure
  std::vector<std::jthread> threads;

  ~Work() {
    {
      const std::scoped_lock lock(mutex);
      next = images.size();
    }
    complete();
  }

  /// Lets threads end that find no image.
  void complete() {
    {
      const std::scoped_lock lock(mutex);
      is_complete = true;
    }
    has_changed.notify_all();
  }

  /// Decodes images until there are none and none will be added.
  void take_part() {
    std::unique_lock lock(mutex);
    while (true) {
      has_changed.wait(lock, [this] { return next < images.size() || is_complete; });
      if (next == images.size()) return;
      const std::size_t number = next++;
      PendingImage& image = images[number];
      lock.unlock();
      std::exception_ptr thrown;
      try {
        decode(image);
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      image.has_ended = true;
      if (!thrown) continue;
      // Images before this one have been begun, so that it does not hang on the threads which fails first in order.
      if (!failure || number < failed) {
        failure = thrown;
        failed = number;
      }
      next = images.size();
    }
  }
};

PendingImages::PendingImages() : work_(std::make_unique<Work>()) {}
PendingImages::PendingImages(PendingImages&&) noexcept = default;
PendingImages& PendingImages::operator=(PendingImages&&) noexcept = default;
PendingImages::~PendingImages() = default;

std::shared_ptr<const Texels> PendingImages::add(ImageJob job) {
  auto placeholder = std::make_shared<const Texels>(Texels{TEXTURE_FORMAT_LINEAR8, 1, 1, {0xffffffffu}});
  {
    const std::scoped_lock lock(work_->mutex);
    if (work_->failure) return placeholder;
    work_->images.push_back({std::move(job), placeholder});
  }
  work_->has_changed.notify_one();
  if (work_->threads.size() >= resolve_thread_count(0)) return placeholder;
  try {
    work_->threads.emplace_back([work = work_.get()] { work->take_part(); });
  } catch (const std::exception&) {
    // No more threads, or no memory for them: `finish` decodes what is left.
  }
  return placeholder;
}

bool PendingImages::empty() const {
  return work_->images.empty();
}

void PendingImages::check_so_far() {
  const std::scoped_lock lock(work_->mutex);
  if (!work_->failure) return;
  // Not waited for: they may wait for memory that the caller has.
  const auto first = work_->images.begin();
  const auto failed = first + static_cast<std::ptrdiff_t>(work_->failed);
  if (std::all_of(first, failed, std::mem_fn(&PendingImage::has_ended))) std::rethrow_exception(work_->failure);
}

void PendingImages::finish(Scene& scene) {
  work_->complete();
  work_->take_part();
  work_->threads.clear();  // waits for each
  if (work_->failure) std::rethrow_exception(work_->failure);
  std::unordered_map<const Texels*, const PendingImage*> image_of;
  std::vector<std::string> faults;
  for (const PendingImage& image : work_->images) {
    image_of.emplace(image.placeholder.get(), &image);
    if (image.texels == nullptr) {
      faults.push_back(image.fault);
    } else if (!image.job.file.empty()) {
      note_file(scene.files, image.job.file);
    }
  }
  tell_faults(faults, scene.warnings);
  for (Texture& texture : scene.textures) {
    const auto found = image_of.find(texture.texels.get());
    if (found != image_of.end()) texture.texels = found->second->texels;
  }
  drop_textures_without_texels(scene);
  work_ = std::make_unique<Work>();
}

}  // namespace vernier
