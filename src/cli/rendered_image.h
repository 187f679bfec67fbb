#pragma once

#include <map>
#include <string>

#include "cli/render_command.h"
#include "cli/render_report.h"
#include "image/image.h"

namespace vernier {

/// An image with its recipe in the metadata, and what it took.
struct RenderedImage {
  ImageFile image;
  RenderReport report;
};

/// `recipe` and what else the metadata tell of the finished `image`, which took `statistics`: the error, where it was
/// stopped, exposure, legend of the costs.
std::map<std::string, std::string> describe_image(const RenderPlan& plan, const ImageFile& image,
                                                  const RenderStatistics& statistics,
                                                  std::map<std::string, std::string> recipe);

/// Does what `plan` says up to the image, which is not written: reads the scene, opens the device, resumes, renders
/// with a progress bar and checkpoints; Ctrl-C, where it is caught, stops it early. Warnings go to stderr. Metadata of
/// an image that lacks samples have vernier:stopped_at, the samples every pixel has got. Throws Error as render_image,
/// read_film_file and the scene's loader do; refused for a checkpoint of another render, device_lost with the command
/// that goes on.
RenderedImage render_planned(RenderPlan plan);

}  // namespace vernier
