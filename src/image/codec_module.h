#pragma once

namespace vernier {

/// Loads the module of codecs (`src/codecs`), once; waits where another thread does so already. Loading takes a quarter
/// of a second, OpenImageIO and the 260 libraries that it links: worth calling beside other work, where an image will
/// be read or written. Throws Error(failed) with the loader's reason where the module is missing.
void load_codecs();

/// Address of the function `name` of the module, which is loaded where it is not yet. Any thread may ask. Throws
/// Error(failed) as load_codecs does, and where there is no such function.
void* codec_address(const char* name);

/// The function `name` of the module, declared as `Function`. Throws what codec_address does.
template <typename Function>
Function& codec(const char* name) {
  return *reinterpret_cast<Function*>(codec_address(name));
}

}  // namespace vernier
