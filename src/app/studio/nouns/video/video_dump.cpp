// The video in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/video/video_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_video(const App& app, nlohmann::ordered_json& state) {
  const VideoState& video = app.get<VideoState>();
  state["video"] = {{"active", video.progress.active},
                    {"checking", video.progress.checking},
                    {"done", video.progress.done},
                    {"total", video.progress.total},
                    {"annotated", video.annotated},
                    {"bars", video.bars},
                    {"orbit", video.orbit},
                    {"from", video.from},
                    {"to", video.to},
                    {"size", static_cast<int>(video.size)}};
}

}  // namespace taxel::ui
