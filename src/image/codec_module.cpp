#include "image/codec_module.h"

#include <dlfcn.h>

#include <string>

#include "error.h"

namespace vernier {
namespace {

[[noreturn]] void fail() {
  throw Error(ErrorKind::failed, std::string("image files can be neither read nor written: ") + dlerror());
}

// It lies beside the program, or where the program's search path for libraries (CMakeLists.txt) says.
void* open_module() {
  void* const module = dlopen("libvernier_codecs.so", RTLD_LAZY | RTLD_LOCAL);
  if (module == nullptr) fail();
  return module;
}

// One for the process, as the system's loader has it, and never closed.
void* loaded_module() {
  static void* const module = open_module();
  return module;
}

}  // namespace

void load_codecs() {
  loaded_module();
}

void* codec_address(const char* name) {
  void* const address = dlsym(loaded_module(), name);
  if (address == nullptr) fail();
  return address;
}

}  // namespace vernier
