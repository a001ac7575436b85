// Videos of the recorded steps: each step is displayed and saved as an image.
#pragma once

#include <memory>
#include <optional>

#include "app/studio/frame/command.h"
#include "app/studio/nouns/video/film_camera.h"
#include "app/studio/nouns/video/video_maker.h"
#include "core/run/marks.h"

namespace taxel::ui {

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
/// Returns the recorded steps that a video shows: the loop, or all.
[[nodiscard]] StepRange steps_for_video(const Host& host);
void begin_video(Host& host, VideoPlan plan);
/// Writes one image of the video, if one is ready. Throws nothing: a problem ends the video with a message.
void make_video(Host& host);

}  // namespace taxel::studio
