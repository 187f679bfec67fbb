#include "render/merge_parts.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <stdexcept>

#include "error.h"
#include "render/develop.h"
#include "render/film_layer.h"
#include "render/setting_limits.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

std::string title_of(const std::string& layer) {
  return layer.empty() ? "colours" : "layer `" + layer + "`";
}

std::string place_text(std::int64_t x, std::int64_t y) {
  return std::to_string(x) + "," + std::to_string(y);
}

bool has_all_samples(const ImagePart& part, std::uint32_t spp) {
  return part.sample_begin == 0 && part.sample_end == spp;
}

void check_part(const ImagePart& part, const ImagePart& first, std::uint32_t spp) {
  const ImageFile& image = part.image;
  if (image.full_width != first.image.full_width || image.full_height != first.image.full_height) {
    refuse(part.name, "is of " + std::to_string(image.full_width) + "x" + std::to_string(image.full_height) +
                          " pixels, " + first.name + " of " + std::to_string(first.image.full_width) + "x" +
                          std::to_string(first.image.full_height));
  }
  if (image.full_width > kMaxSide_px || image.full_height > kMaxSide_px) refuse(part.name, "is of too large an image");
  if (image.x < 0 || image.y < 0 || image.width > image.full_width - image.x ||
      image.height > image.full_height - image.y) {
    refuse(part.name, "reaches beyond its full image");
  }
  if (part.sample_begin >= part.sample_end || part.sample_end > spp) {
    refuse(part.name, "has samples beyond the " + std::to_string(spp) + " of the image");
  }
}

/// Whether [begin_a, begin_a + length_a) and the same of b have a number in common.
bool overlap(std::int64_t begin_a, std::int64_t length_a, std::int64_t begin_b, std::int64_t length_b) {
  return begin_a < begin_b + length_b && begin_b < begin_a + length_a;
}

void check_apart(const ImagePart& a, const ImagePart& b) {
  const bool share_pixels = overlap(a.image.x, a.image.width, b.image.x, b.image.width) &&
                            overlap(a.image.y, a.image.height, b.image.y, b.image.height);
  const bool share_samples =
      overlap(a.sample_begin, a.sample_end - a.sample_begin, b.sample_begin, b.sample_end - b.sample_begin);
  if (!share_pixels || !share_samples) return;
  refuse(b.name, "holds samples that " + a.name + " holds too, the first of them: pixel " +
                     place_text(std::max(a.image.x, b.image.x), std::max(a.image.y, b.image.y)) + ", sample " +
                     std::to_string(std::max(a.sample_begin, b.sample_begin)));
}

std::uint64_t sample_count(const ImagePart& part) {
  return static_cast<std::uint64_t>(part.image.width) * part.image.height * (part.sample_end - part.sample_begin);
}

using PartRefs = std::vector<const ImagePart*>;

/// 0 and where each part ends along an axis, in order: something missing begins at one of these.
template <typename End>
std::set<std::int64_t> starts_along(const PartRefs& parts, End end) {
  std::set<std::int64_t> starts{0};
  for (const ImagePart* part : parts) starts.insert(end(*part));
  return starts;
}

/// Those of `parts` whose [begin, begin + length) holds `place`.
template <typename Begin, typename Length>
PartRefs parts_at(const PartRefs& parts, std::int64_t place, Begin begin, Length length) {
  PartRefs there;
  std::ranges::copy_if(parts, std::back_inserter(there),
                       [&](const ImagePart* part) { return overlap(place, 1, begin(*part), length(*part)); });
  return there;
}

/// Throws for the first sample that none of the parts holds, which there is.
[[noreturn]] void refuse_missing(const PartRefs& all, std::uint32_t spp) {
  const ImageFile& image = all.front()->image;
  for (const std::int64_t y : starts_along(all, [](const ImagePart& p) { return p.image.y + p.image.height; })) {
    const PartRefs in_row = parts_at(
        all, y, [](const ImagePart& p) { return p.image.y; }, [](const ImagePart& p) { return p.image.height; });
    for (const std::int64_t x : starts_along(in_row, [](const ImagePart& p) { return p.image.x + p.image.width; })) {
      const PartRefs at_pixel = parts_at(
          in_row, x, [](const ImagePart& p) { return p.image.x; }, [](const ImagePart& p) { return p.image.width; });
      for (const std::int64_t s : starts_along(at_pixel, [](const ImagePart& p) { return p.sample_end; })) {
        const bool inside = y < image.full_height && x < image.full_width && s < spp;
        const auto holds = [&](const ImagePart* p) { return p->sample_begin <= s && s < p->sample_end; };
        if (!inside || std::ranges::any_of(at_pixel, holds)) continue;
        throw Error(ErrorKind::refused, "parts are missing: none holds pixel " + place_text(x, y) + ", sample " +
                                            std::to_string(s) + " of " + std::to_string(spp));
      }
    }
  }
  throw std::logic_error("merge_parts: nothing is missing");
}

/// Parts that lie apart within the image hold all of it exactly when they hold as many samples. Before anything of the
/// size of the full image is allocated.
void check_complete(const std::vector<ImagePart>& parts, std::uint32_t spp) {
  std::uint64_t held = 0;
  PartRefs refs;
  for (const ImagePart& part : parts) {
    held += sample_count(part);
    refs.push_back(&part);
  }
  const ImageFile& image = parts.front().image;
  if (held < static_cast<std::uint64_t>(image.full_width) * image.full_height * spp) refuse_missing(refs, spp);
}

/// The whole image while it is put together.
struct Canvas {
  ImageFile image;
  std::vector<std::uint32_t> sums;  // of pixels that come in parts of their samples; empty without any

  std::size_t pixel_count() const { return static_cast<std::size_t>(image.width) * image.height; }
};

/// Calls `visit(pixel of the part, pixel of the canvas)` for each pixel of `part`.
template <typename Visit>
void for_each_pixel(const ImageFile& part, Visit visit) {
  for (int y = 0; y < part.height; ++y) {
    const std::size_t from = static_cast<std::size_t>(y) * part.width;
    const std::size_t to = static_cast<std::size_t>(part.y + y) * part.full_width + part.x;
    for (int x = 0; x < part.width; ++x) visit(from + x, to + x);
  }
}

/// Copies the values of `from` to the same channels of `to`: pixel `a` of one to pixel `b` of the other for each pair
/// that `each` visits. Both have the same channels and type.
template <typename EachPair>
void copy_layer(const Layer& from, Layer& to, EachPair each) {
  std::visit(
      [&](auto& target) {
        const auto& source = std::get<std::decay_t<decltype(target)>>(from.values);
        const std::size_t count = to.channels.size();
        for (std::size_t c = 0; c < count; ++c) {
          const auto channel = std::ranges::find(from.channels, to.channels[c]) - from.channels.begin();
          each([&](std::size_t a, std::size_t b) { target[b * count + c] = source[a * count + channel]; });
        }
      },
      to.values);
}

/// Whether copy_layer may copy between them.
bool same_shape(const Layer& a, const Layer& b) {
  return a.values.index() == b.values.index() && std::ranges::is_permutation(a.channels, b.channels);
}

Canvas empty_canvas(const ImagePart& first, const std::vector<std::string>& aovs) {
  Canvas canvas;
  canvas.image.width = canvas.image.full_width = first.image.full_width;
  canvas.image.height = canvas.image.full_height = first.image.full_height;
  std::vector<std::string> names = aovs;
  names.insert(names.begin(), "");
  for (const std::string& name : names) {
    const Layer* model = find_layer(first.image, name);
    if (model == nullptr) refuse(first.name, "lacks " + title_of(name));
    Layer layer = *model;
    std::visit([&](auto& values) { values.assign(canvas.pixel_count() * layer.channels.size(), {}); }, layer.values);
    canvas.image.layers.push_back(std::move(layer));
  }
  return canvas;
}

/// Adds the film of a part to the canvas.
void add_film(const ImagePart& part, Canvas& canvas) {
  const Layer* layer = find_layer(part.image, kFilmLayer);
  const std::vector<std::uint32_t> film = layer ? sums_of_layer(*layer) : std::vector<std::uint32_t>{};
  if (film.empty()) refuse(part.name, "has a part of the samples, but not the layers film.* with their sums");
  canvas.sums.resize(canvas.pixel_count() * FILM_WORDS);
  for_each_pixel(part.image, [&](std::size_t from, std::size_t to) {
    const std::span words = std::span(film).subspan(from * FILM_WORDS, FILM_WORDS);
    if (words[FILM_SAMPLES] != part.sample_end - part.sample_begin) {
      refuse(part.name, "lacks samples of pixel " +
                            place_text(part.image.x + from % part.image.width, part.image.y + from / part.image.width));
    }
    for (const std::uint32_t color : {FILM_RED, FILM_GREEN, FILM_BLUE}) {
      if (words[color + 2] == FILM_PLAIN_SUM) refuse(part.name, "has sums of floats, which have other bits in parts");
    }
    add_sums(std::span(canvas.sums).subspan(to * FILM_WORDS, FILM_WORDS), words);
  });
}

void paste(const ImagePart& part, Canvas& canvas) {
  for (Layer& layer : canvas.image.layers) {
    const Layer* own = find_layer(part.image, layer.name);
    if (own == nullptr || !same_shape(*own, layer)) refuse(part.name, "lacks " + title_of(layer.name));
    copy_layer(*own, layer, [&](auto copy) { for_each_pixel(part.image, copy); });
  }
}

/// Replaces what comes from the sums where they were added up: one part's own mean says nothing.
void develop_sums(const ImagePart& first, const std::vector<std::string>& aovs, Canvas& canvas) {
  DevelopedFilm developed = develop(canvas.sums, {0, 0, canvas.image.width, canvas.image.height});
  std::vector<std::string> summed;
  std::ranges::copy_if(aovs, std::back_inserter(summed), is_film_aov);
  std::vector<Layer> layers = aov_layers(summed, {}, developed);
  layers.push_back({"", {"R", "G", "B", "A"}, std::move(developed.color)});
  for (Layer& target : canvas.image.layers) {
    const auto source = std::ranges::find(layers, target.name, &Layer::name);
    if (source == layers.end()) continue;
    if (!same_shape(*source, target)) refuse(first.name, title_of(target.name) + " are not as a render writes them");
    copy_layer(*source, target, [&](auto copy) {
      for (std::size_t pixel = 0; pixel < developed.sample_count.size(); ++pixel) {
        if (developed.sample_count[pixel] > 0) copy(pixel, pixel);
      }
    });
  }
}

}  // namespace

ImageFile merge_parts(const std::vector<ImagePart>& parts, std::uint32_t spp, const std::vector<std::string>& aovs) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    check_part(parts[i], parts.front(), spp);
    for (std::size_t j = 0; j < i; ++j) check_apart(parts[j], parts[i]);
  }
  check_complete(parts, spp);
  Canvas canvas = empty_canvas(parts.front(), aovs);
  for (const ImagePart& part : parts) {
    paste(part, canvas);
    if (!has_all_samples(part, spp)) add_film(part, canvas);
  }
  if (!canvas.sums.empty()) develop_sums(parts.front(), aovs, canvas);
  return std::move(canvas.image);
}

}  // namespace vernier
