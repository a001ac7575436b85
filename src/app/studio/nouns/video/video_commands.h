// Videos of the recorded steps: each step is displayed and saved as an image. The camera of a film turns once around
// the contact of the run.
#pragma once

#include <memory>
#include <optional>

#include "app/studio/frame/command.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/nouns/video/video_maker.h"
#include "core/run/frame.h"
#include "core/run/history/lanes.h"
#include "core/run/scene.h"
#include "ui/scene/camera.h"

namespace taxel::ui {

/// The camera of a film that turns once around the contact of a run.
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

struct CancelVideo {};
/// Makes a film for a talk: the camera turns once around the contact during the recorded run.
struct MakeFilm {};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::CancelVideo& command, Host& host);
void carry_out(const ui::MakeFilm& command, Host& host);

/// The video that is being made.
struct VideoJob {
  std::shared_ptr<VideoMaker> maker;     ///< or null if no video is being made
  std::optional<ui::FilmCamera> camera;  ///< camera of a film, which turns around the contact
};
/// Returns the recorded steps of `within` from one time to another [s]; empty if there is none.
[[nodiscard]] std::optional<StepRange> steps_between(const HistoryLanes& lanes, const StepRange& within, double from,
                                                     double to);
/// Returns the steps, the view and the programs of which a video can be made now.
[[nodiscard]] ui::VideoSource video_source(const ui::App& app);
void begin_video(Host& host, VideoPlan plan);
/// Writes one image of the video, if one is ready. Throws nothing: a problem ends the video with a message.
void make_video(Host& host);

}  // namespace taxel::studio
