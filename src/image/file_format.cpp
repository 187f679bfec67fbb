#include "image/file_format.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace vernier {

std::string lower_case_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

FileFormat file_format(const std::string& path, ErrorKind kind_if_unknown) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".exr") return FileFormat::exr;
  if (extension == ".png") return FileFormat::png;
  if (extension == ".jpg" || extension == ".jpeg") return FileFormat::jpeg;
  if (extension == ".hdr") return FileFormat::hdr;
  if (extension == ".tif" || extension == ".tiff") return FileFormat::tiff;
  throw Error(kind_if_unknown, path + ": unknown image format; possible are .exr .png .jpg .jpeg .hdr .tif .tiff");
}

}  // namespace vernier
