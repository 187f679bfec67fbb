#include "render/film_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "shared/film_layout.h"
#include "temporary_folder.h"
#include "unit/image/expect_error.h"
#include "unit/image/file_size_limit.h"

namespace vernier {
namespace {

/// A film of 3 x 2 pixels in which every field has its own value.
SavedFilm some_film() {
  SavedFilm film{.recipe = {{"vernier:version", "1"}, {"vernier:options", "{\"spp\":\"4\"}\nx"}},
                 .area = {5, 6, 3, 2},
                 .position = {{8, 9}, 10, 11},
                 .rays = {12, 13, 14, 15},
                 .stack_overflows = 16,
                 .device_ms = 17.5,
                 .wall_ms = 18.5,
                 .sums = {},
                 .errors = {}};
  for (std::uint32_t word = 0; word < 3 * 2 * FILM_WORDS; ++word) film.sums.push_back(word * 2654435761u);
  for (std::uint32_t pixel = 0; pixel < 3 * 2; ++pixel) {
    const float value = static_cast<float>(pixel);
    film.errors.push_back({{value, value + 0.25f, value + 0.5f}, pixel, value * 3.0f, value * 7.0f});
  }
  return film;
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST(FilmFile, GivesBackEveryField) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.film");
  const SavedFilm film = some_film();
  write_film_file(path, film);
  const SavedFilm read = read_film_file(path);
  EXPECT_EQ(read.recipe, film.recipe);
  EXPECT_EQ(read.area.x, 5);
  EXPECT_EQ(read.area.y, 6);
  EXPECT_EQ(read.area.width, 3);
  EXPECT_EQ(read.area.height, 2);
  EXPECT_EQ(read.position.tile, glm::ivec2(8, 9));
  EXPECT_EQ(read.position.pass_begin, 10u);
  EXPECT_EQ(read.position.tiles_done, 11u);
  EXPECT_EQ(read.rays.primary, 12u);
  EXPECT_EQ(read.rays.shadow, 13u);
  EXPECT_EQ(read.rays.reflection, 14u);
  EXPECT_EQ(read.rays.refraction, 15u);
  EXPECT_EQ(read.stack_overflows, 16u);
  EXPECT_EQ(read.device_ms, 17.5);
  EXPECT_EQ(read.wall_ms, 18.5);
  EXPECT_EQ(read.sums, film.sums);
  ASSERT_EQ(read.errors.size(), film.errors.size());
  EXPECT_EQ(std::memcmp(read.errors.data(), film.errors.data(), film.errors.size() * sizeof(PixelError)), 0);
  EXPECT_EQ(folder.entry_count(), 1) << "no partial files";
}

TEST(FilmFile, AFilmWithoutSamplesNeedsNoSums) {
  const TemporaryFolder folder;
  SavedFilm film = some_film();
  film.sums.clear();
  film.errors.clear();
  write_film_file(folder.file("a.film"), film);
  EXPECT_TRUE(read_film_file(folder.file("a.film")).sums.empty());
}

// The checksum is over all but itself and the first word, which are compared: no byte is beyond notice.
TEST(FilmFile, DamageInAnyByteIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.film");
  write_film_file(path, some_film());
  const std::string sound = bytes_of_file(path);
  for (std::size_t place = 0; place < sound.size(); ++place) {
    for (const int flip : {1, 0x80}) {
      std::string damaged = sound;
      damaged[place] = static_cast<char>(damaged[place] ^ flip);
      write_bytes(path, damaged);
      EXPECT_THROW(read_film_file(path), Error) << "byte " << place;
    }
  }
  write_bytes(path, sound);
  EXPECT_EQ(read_film_file(path).sums, some_film().sums);
}

TEST(FilmFile, AnyOtherLengthIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.film");
  write_film_file(path, some_film());
  const std::string sound = bytes_of_file(path);
  for (std::size_t length = 0; length < sound.size(); ++length) {
    write_bytes(path, sound.substr(0, length));
    EXPECT_THROW(read_film_file(path), Error) << length << " bytes";
  }
  write_bytes(path, sound + "x");
  expect_error(ErrorKind::refused, path + ": is damaged", [&] { read_film_file(path); });
}

// Sizes are held against the length of the file before anything is allocated for them: 65536 x 65536 pixels would be
// 256 GiB, 2^61 words of a recipe more than there is.
TEST(FilmFile, AbsurdSizesTakeNoMemory) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.film");
  write_film_file(path, some_film());
  const std::string sound = bytes_of_file(path);
  const auto expect_refused = [&](std::size_t place, const std::string& bytes) {
    std::string damaged = sound;
    damaged.replace(place, bytes.size(), bytes);
    write_bytes(path, damaged);
    EXPECT_THROW(read_film_file(path), Error) << "at byte " << place;
  };
  const std::string largest(8, '\xff'), high("\0\0\0\0\0\0\0\x20", 8), side("\0\0\1\0", 4), negative("\0\0\0\x80", 4);
  for (const std::size_t field : {24u, 32u, 40u}) {  // bytes of the recipe, words of the sums, pixels with errors
    expect_refused(field, largest);
    expect_refused(field, high);
  }
  expect_refused(56, side + side);  // width and height
  for (std::size_t field = 48; field < 72; field += 4) expect_refused(field, negative);
}

TEST(FilmFile, WhatIsNoFilmIsRefusedByName) {
  const TemporaryFolder folder;
  expect_error(ErrorKind::refused, folder.file("a") + ": there is no such file",
               [&] { read_film_file(folder.file("a")); });
  expect_error(ErrorKind::refused, ": is no file", [&] { read_film_file(folder.file("")); });
  write_bytes(folder.file("b"), std::string(500, 'v'));
  expect_error(ErrorKind::refused, ": is no checkpoint of this version", [&] { read_film_file(folder.file("b")); });
}

TEST(FilmFile, AFullDiskKeepsTheFileThatWasThere) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.film");
  write_film_file(path, some_film());
  SavedFilm large = some_film();
  large.area = {0, 0, 64, 64};
  large.sums.assign(64 * 64 * FILM_WORDS, 7);
  large.errors.clear();
  {
    const FileSizeLimit limit(4096);
    expect_error(ErrorKind::failed, path + ": cannot write: ", [&] { write_film_file(path, large); });
  }
  EXPECT_EQ(read_film_file(path).sums, some_film().sums);
  EXPECT_EQ(folder.entry_count(), 1);
}

}  // namespace
}  // namespace vernier
