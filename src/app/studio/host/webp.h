// Films as animated WebP files.
#pragma once

#include <memory>
#include <string>

#include "ui/gl/rgb_image.h"

namespace taxel::studio {

/// Largest number of images per second in a WebP film: browsers slow down films whose images last 10 ms or less.
inline constexpr int kMaxWebpRate = 60;

/// An animated WebP that is encoded image by image. Equal images give equal bytes. Equal successive images are stored
/// once, with the sum of their durations. A player repeats the film without end.
class WebpFilm {
 public:
  /// All images have this size, at most 16383 pixels each way.
  WebpFilm(int width, int height);
  ~WebpFilm();
  WebpFilm(const WebpFilm&) = delete;
  WebpFilm& operator=(const WebpFilm&) = delete;

  /// Encodes the next image, which is shown from `begin_ms` after the begin of the film. Each image begins later than
  /// the one before. Throws Error with the reason of the library.
  void add(const gl::RgbImage& image, int begin_ms);
  /// Returns the bytes of the film, whose last image is shown until `end_ms`. To be called once. Throws Error as add().
  [[nodiscard]] std::string finish(int end_ms);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taxel::studio
