#pragma once

#include <functional>
#include <memory>
#include <string>

#include "scene/scene.h"

namespace vernier {

/// An image that textures of a scene are to have.
struct ImageJob {
  std::function<std::shared_ptr<const Texels>()> decode;  ///< by any thread, once; Error(refused) where it is broken
  std::string file = "";          ///< of its own that it is read from; empty where there is none
  std::string before_fault = "";  ///< begins the line that tells what is wrong with a broken one
  std::string after_fault = "";   ///< ends it
  bool needed = false;            ///< a broken one ends it all; else the materials go without it, with a warning
};

/// Images of a scene, decoded by threads of their own while others go on with its geometry.
class PendingImages {
 public:
  /// None.
  PendingImages();
  /// Takes the images of another, with the threads that decode them.
  PendingImages(PendingImages&&) noexcept;
  /// The same; its own end as by the destructor.
  PendingImages& operator=(PendingImages&&) noexcept;
  /// Leaves out what nobody has begun with, and waits for the rest.
  ~PendingImages();

  /// Has another image decoded, and returns what stands for it in textures until `finish`: one white texel.
  std::shared_ptr<const Texels> add(ImageJob job);

  /// Whether there are images that `finish` has to wait for.
  bool empty() const;

  /// Throws what `finish` is going to, as soon as that is known, and never waits: for who goes on meanwhile.
  void check_so_far();

  /// Waits for all images and gives them to the textures of `scene`. Names their files, in the order of `add`, and
  /// warns of broken ones, each line once and a hundred at most; their textures are taken out of the scene. Throws
  /// Error(refused) for a broken one that is needed, and a MemoryError and whatever else `decode` throws, of several
  /// images that of the one that was added first.
  void finish(Scene& scene);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace vernier
