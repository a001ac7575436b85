// Pictures as PNG files.
#pragma once

#include <filesystem>

#include "ui/gl/rgb_image.h"

namespace taxel::studio {
/// Written beside and renamed. The same picture gives the same bytes. Throws Error naming the file.
void write_png(const std::filesystem::path& file, const gl::RgbImage& image);
void write_png(const std::filesystem::path& file, const gl::RgbaImage& image);
}  // namespace taxel::studio
