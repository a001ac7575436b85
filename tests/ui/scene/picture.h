// Pictures in tests: one offscreen context, PNG files to look at, single pixels.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "core/base/math.h"
#include "ui/gl/offscreen_context.h"
#include "ui/gl/rgb_image.h"

namespace taxel::test {

/// Made for the first test that draws, kept for all.
gl::OffscreenContext& context();

/// Writes DIR/pictures/NAME.png in the build folder.
void write_picture(const std::string& name, const gl::RgbImage& image);

/// The pixel that contains a position (from the upper left corner).
std::array<int, 3> pixel_at(const gl::RgbImage& image, const dvec2& position);

/// One window of ImGui that fills a picture; `draw` fills the window. Drawn several times, as ImGui needs.
gl::RgbImage panel_picture(int width, int height, bool dark, const std::function<void()>& draw);

}  // namespace taxel::test
