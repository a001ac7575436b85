// Images as PNG files.
#pragma once

#include <filesystem>
#include <string>

#include "ui/gl/rgb_image.h"

namespace taxel::studio {
/// Returns the bytes of a PNG file. Equal images give equal bytes. Throws Error.
std::string png_bytes(const gl::RgbImage& image);
std::string png_bytes(const gl::RgbaImage& image);
/// Writes a PNG file through a temporary file that is renamed. Equal images give equal bytes. Throws Error naming the
/// file.
void write_png(const std::filesystem::path& file, const gl::RgbImage& image);
void write_png(const std::filesystem::path& file, const gl::RgbaImage& image);
}  // namespace taxel::studio
