#include "app/studio/nouns/video/film_camera.h"

#include <cmath>

namespace taxel::ui {
namespace {

constexpr double kFollow = 0.08;  // fraction of the way to the contact by which each frame moves the target

}  // namespace

Camera FilmCamera::next(double fraction, const std::optional<dvec3>& contact_W) {
  if (contact_W) target_ = begun_ ? glm::mix(target_, *contact_W, kFollow) : *contact_W;
  begun_ = true;
  Camera camera = first_;
  camera.target = target_;
  camera.azimuth_deg = std::remainder(first_.azimuth_deg + 360 * fraction, 360.0);
  return camera;
}

}  // namespace taxel::ui
