// Images in tests: one offscreen context, PNG files to look at, single pixels.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "core/base/math.h"
#include "ui/gl/offscreen_context.h"
#include "ui/gl/rgb_image.h"

namespace taxel::test {

/// Returns the offscreen context, which the first drawing test creates and all tests share.
gl::OffscreenContext& context();

/// Writes DIR/pictures/NAME.png in the build folder.
void write_picture(const std::string& name, const gl::RgbImage& image);

/// Returns the pixel that contains a position (from the upper left corner).
std::array<int, 3> pixel_at(const gl::RgbImage& image, const dvec2& position);

/// Returns the difference of two colours as people see it (CIE 1976, Delta E of L*a*b* under D65): about 2 is just
/// visible, 15 is seen at a glance.
double color_difference(const std::array<int, 3>& a, const std::array<int, 3>& b);

/// Returns the image of one ImGui window that fills it; `draw` draws the content. ImGui needs several frames, so the
/// window is drawn several times.
gl::RgbImage panel_picture(int width, int height, bool dark, const std::function<void()>& draw);

}  // namespace taxel::test
