#include <tiffio.h>

namespace vernier {
namespace {

// libtiff prints what it finds wrong to standard error, beside the one line that the program has for it;
// OpenImageIO 2.5 leaves some of that to libtiff. Set when the module is loaded, so that OpenImageIO's own handlers
// come later and stay.
[[maybe_unused]] const bool kIsQuiet = [] {
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  return true;
}();

}  // namespace
}  // namespace vernier
