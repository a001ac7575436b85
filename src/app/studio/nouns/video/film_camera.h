// The camera of a film that turns once around the contact of a run.
#pragma once

#include <optional>

#include "app/studio/frame/contact_center.h"
#include "core/run/frame.h"
#include "ui/scene/pick/camera.h"

namespace taxel::ui {

class FilmCamera {
 public:
  /// The film begins in the direction and at the distance of the given camera.
  explicit FilmCamera(const Camera& first) : first_(first), target_(first.target) {}

  /// Returns the camera of the next frame. `fraction` of the film is over, from 0 to 1. The camera looks at the
  /// contact in the first frame, then follows the contact smoothly, and stays while there is none.
  [[nodiscard]] Camera next(double fraction, const std::optional<dvec3>& contact_W);

 private:
  Camera first_;
  dvec3 target_;
  bool begun_ = false;
};

}  // namespace taxel::ui
