// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <string>

#include "ui/gl/rgb_image.h"

namespace taxel::studio {
/// The bytes of a PNG file. The same picture gives the same bytes. Throws Error.
std::string png_bytes(const gl::RgbImage& image);
std::string png_bytes(const gl::RgbaImage& image);
/// Written beside and renamed. The same picture gives the same bytes. Throws Error naming the file.
void write_png(const std::filesystem::path& file, const gl::RgbImage& image);
void write_png(const std::filesystem::path& file, const gl::RgbaImage& image);
}  // namespace taxel::studio
