#include "render/film_file.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include "error.h"
#include "image/file_metadata.h"
#include "image/whole_file.h"
#include "render/checksum.h"
#include "render/setting_limits.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

namespace fs = std::filesystem;

/// Begins every file; the last character counts the layouts.
constexpr std::string_view kMagic = "vernier-film--2\n";

/// What stands before the recipe's text and the sums. No padding: every byte counts.
struct FileHeader {
  std::array<char, 16> magic;
  std::uint64_t checksum;  // of everything behind it
  std::uint64_t recipe_bytes;
  std::uint64_t sum_words;
  std::uint64_t error_count;
  std::int32_t x, y, width, height;
  std::int32_t tile_width, tile_height;
  std::uint32_t pass_begin, tiles_done;
  std::uint64_t primary, shadow, reflection, refraction, stack_overflows;
  double device_ms, wall_ms;
};
static_assert(sizeof(FileHeader) == 136 && kMagic.size() == 16);
constexpr std::size_t kUncheckedBytes = offsetof(FileHeader, recipe_bytes);

/// `recipe` is the text of the film's.
std::uint64_t checksum_of(const FileHeader& header, const std::string& recipe, const SavedFilm& film) {
  std::uint64_t sum = checksum(std::as_bytes(std::span(&header, 1)).subspan(kUncheckedBytes));
  sum = checksum(std::as_bytes(std::span(recipe)), sum);
  sum = checksum(std::as_bytes(std::span(film.sums)), sum);
  return checksum(std::as_bytes(std::span(film.errors)), sum);
}

FileHeader header_of(const SavedFilm& film, const std::string& recipe) {
  FileHeader header{};
  std::memcpy(header.magic.data(), kMagic.data(), kMagic.size());
  header.recipe_bytes = recipe.size();
  header.sum_words = film.sums.size();
  header.error_count = film.errors.size();
  header.x = film.area.x;
  header.y = film.area.y;
  header.width = film.area.width;
  header.height = film.area.height;
  header.tile_width = film.position.tile.x;
  header.tile_height = film.position.tile.y;
  header.pass_begin = film.position.pass_begin;
  header.tiles_done = film.position.tiles_done;
  header.primary = film.rays.primary;
  header.shadow = film.rays.shadow;
  header.reflection = film.rays.reflection;
  header.refraction = film.rays.refraction;
  header.stack_overflows = film.stack_overflows;
  header.device_ms = film.device_ms;
  header.wall_ms = film.wall_ms;
  header.checksum = checksum_of(header, recipe, film);
  return header;
}

SavedFilm film_of(const FileHeader& header) {
  return {.recipe = {},
          .area = {header.x, header.y, header.width, header.height},
          .position = {{header.tile_width, header.tile_height}, header.pass_begin, header.tiles_done},
          .rays = {header.primary, header.shadow, header.reflection, header.refraction},
          .stack_overflows = header.stack_overflows,
          .device_ms = header.device_ms,
          .wall_ms = header.wall_ms,
          .sums = {},
          .errors = {}};
}

/// Refuses a header whose sizes do not add up to the file's, before any of them is believed.
void check_header(const std::string& path, const FileHeader& header, std::uint64_t file_bytes) {
  if (std::string_view(header.magic.data(), header.magic.size()) != kMagic) {
    refuse(path, "is no checkpoint of this version");
  }
  const std::uint64_t rest = file_bytes - sizeof header;
  const auto is_side = [](std::int32_t side) { return side >= 1 && side <= kMaxSide_px; };
  const bool sound = is_side(header.width) && is_side(header.height) && is_side(header.tile_width) &&
                     is_side(header.tile_height) && header.x >= 0 && header.y >= 0 && header.recipe_bytes <= rest;
  if (!sound) refuse(path, "is damaged");
  const std::uint64_t pixels = static_cast<std::uint64_t>(header.width) * static_cast<std::uint64_t>(header.height);
  if (header.sum_words != 0 && header.sum_words != FILM_WORDS * pixels) refuse(path, "is damaged");
  if (header.error_count != 0 && header.error_count != pixels) refuse(path, "is damaged");
  const std::uint64_t expected =
      header.recipe_bytes + sizeof(std::uint32_t) * header.sum_words + sizeof(PixelError) * header.error_count;
  if (rest < expected) refuse(path, "is cut short");
  if (rest > expected) refuse(path, "is damaged");
}

template <typename Value>
void read_values(std::ifstream& stream, const std::string& path, std::span<Value> values) {
  if (values.empty()) return;
  if (!stream.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()))) {
    refuse(path, "is cut short");
  }
}

std::string reason_of_errno() {
  return std::generic_category().message(errno);
}

/// Writes all of `bytes`, or throws.
void put(std::FILE* file, const std::string& path, std::span<const std::byte> bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) {
    throw Error(ErrorKind::failed, path + ": cannot write: " + reason_of_errno());
  }
}

}  // namespace

bool is_film_file(const std::string& path) {
  std::string begin(kMagic.size(), '\0');
  std::ifstream stream(path, std::ios::binary);
  return stream.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == kMagic;
}

void write_film_file(const std::string& path, const SavedFilm& film) {
  const std::string recipe = text_of_metadata(film.recipe);
  const FileHeader header = header_of(film, recipe);
  write_whole(path, [&](const std::string& name) {
    const auto close = [](std::FILE* file) { std::fclose(file); };
    const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(name.c_str(), "wb"), close);
    if (!file) throw Error(ErrorKind::failed, path + ": cannot write: " + reason_of_errno());
    put(file.get(), path, std::as_bytes(std::span(&header, 1)));
    put(file.get(), path, std::as_bytes(std::span(recipe)));
    put(file.get(), path, std::as_bytes(std::span(film.sums)));
    put(file.get(), path, std::as_bytes(std::span(film.errors)));
    // On the disk before the rename: else a power failure could leave the new name with nothing behind it.
    if (std::fflush(file.get()) != 0 || ::fsync(::fileno(file.get())) != 0) {
      throw Error(ErrorKind::failed, path + ": cannot write: " + reason_of_errno());
    }
  });
}

SavedFilm read_film_file(const std::string& path) {
  std::error_code failure;
  if (!fs::exists(path, failure)) refuse(path, "there is no such file");
  if (!fs::is_regular_file(path, failure)) refuse(path, "is no file");
  const std::uint64_t file_bytes = fs::file_size(path, failure);
  std::ifstream stream(path, std::ios::binary);
  if (failure || !stream) refuse(path, "cannot be read");
  if (file_bytes < sizeof(FileHeader)) refuse(path, "is cut short");
  FileHeader header{};
  read_values(stream, path, std::span(&header, 1));
  check_header(path, header, file_bytes);
  SavedFilm film = film_of(header);
  std::string recipe(header.recipe_bytes, '\0');
  film.sums.resize(header.sum_words);
  film.errors.resize(header.error_count);
  read_values(stream, path, std::span(recipe));
  read_values(stream, path, std::span(film.sums));
  read_values(stream, path, std::span(film.errors));
  if (checksum_of(header, recipe, film) != header.checksum) refuse(path, "is damaged");
  film.recipe = metadata_of_text(recipe);
  return film;
}

}  // namespace vernier
