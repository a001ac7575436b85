#include "app/studio/nouns/video/video_commands.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/host.h"
#include "app/studio/host/png.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "core/base/error.h"
#include "core/base/text/message.h"
#include "ui/scene/scene_input.h"
#include "ui/scene/scene_renderer.h"
#include "ui/theme.h"
#include "ui/widgets/pressure_legend.h"

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

namespace taxel::ui {
namespace {

/// The texts and colours of an image.
struct VideoNotes {
  std::string time;                      ///< such as "0.250 s"
  const PressureRange* range = nullptr;  ///< range of the legend, or null without a legend
  bool dark = true;
};

constexpr int kBands = 64, kTicks = 4;

/// A list to draw into, and the size of its texts.
struct VideoPage {
  ImDrawList& list;
  ImFont* font;
  float line;  ///< height of texts [pixels]
  const Palette& colors;

  [[nodiscard]] ImVec2 size_of(const std::string& text, float scale = 1) const {
    return font->CalcTextSizeA(scale * line, FLT_MAX, 0, text.c_str());
  }
  void text(ImVec2 at, const ImVec4& color, const std::string& what, float scale = 1) const {
    list.AddText(font, scale * line, {std::round(at.x), std::round(at.y)}, to_u32(color), what.c_str());
  }
};

void draw_time(const VideoPage& page, int height, const std::string& time) {
  const float pad = 0.4f * page.line;
  const ImVec2 size = page.size_of(time, 1.3f);
  const ImVec2 lo(page.line, static_cast<float>(height) - page.line - size.y - 2 * pad);
  page.list.AddRectFilled(lo, {lo.x + size.x + 2 * pad, lo.y + size.y + 2 * pad}, to_u32(page.colors.panel, 0.82f),
                          0.25f * page.line);
  page.text({lo.x + pad, lo.y + pad}, page.colors.text, time, 1.3f);
}

void draw_legend(const VideoPage& page, int width, const PressureRange& range) {
  const std::vector<std::string> texts = legend_texts(range, kTicks);
  float numbers = 0;
  for (const std::string& text : texts) numbers = std::max(numbers, page.size_of(text).x);
  const std::string title = "Pressure [kPa]";
  const float line = page.line, pad = 0.6f * line, bar = 1.1f * line;
  const float inner = std::max(page.size_of(title).x, bar + 0.7f * line + numbers);
  const ImVec2 hi(static_cast<float>(width) - line, 14.5f * line), lo(hi.x - inner - 2 * pad, line);
  page.list.AddRectFilled(lo, hi, to_u32(page.colors.panel, 0.82f), 0.25f * line);
  page.text({lo.x + pad, lo.y + 0.4f * line}, page.colors.text, title);
  const float top = lo.y + 2.4f * line, bottom = hi.y - 1.0f * line, left = lo.x + pad;
  const auto pressure_at = [&](double part) { return range.lo + part * (range.hi - range.lo); };
  const auto y_at = [&](double part) { return bottom + (top - bottom) * static_cast<float>(part); };
  for (int i = 0; i < kBands; ++i) {
    const double a = static_cast<double>(i) / kBands, b = static_cast<double>(i + 1) / kBands;
    const ImU32 below = pressure_color(range, pressure_at(a)), above = pressure_color(range, pressure_at(b));
    page.list.AddRectFilledMultiColor({left, y_at(b)}, {left + bar, y_at(a)}, above, above, below, below);
  }
  for (int i = 0; i <= kTicks; ++i) {
    const float y = y_at(static_cast<double>(i) / kTicks);
    page.list.AddLine({left + bar, y}, {left + bar + 0.3f * line, y}, to_u32(page.colors.text),
                      std::max(1.0f, 0.06f * line));
    const std::string& text = texts[static_cast<std::size_t>(i)];
    page.text({left + bar + 0.6f * line, y - 0.5f * page.size_of(text).y}, page.colors.text, text);
  }
}

/// Draws the time into the lower left corner and the legend into the upper right one, in sizes that follow the image's.
void draw_video_notes(ImDrawList& list, int width, int height, const VideoNotes& notes) {
  const float line = std::max(10.0f, std::round(0.024f * static_cast<float>(std::min(width, height))));
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  const VideoPage page{list, fonts.Fonts[0], line, palette(notes.dark)};
  if (notes.range != nullptr) draw_legend(page, width, *notes.range);
  draw_time(page, height, notes.time);
}

}  // namespace

}  // namespace taxel::ui

namespace taxel::studio {
namespace {

/// Draws notes over the bound framebuffer, as ImGui draws a window.
void draw_notes(int width, int height, const ui::VideoNotes& notes) {
  ImDrawList list(ImGui::GetDrawListSharedData());
  const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
  list._ResetForNewFrame();
  list.PushTexture(ImGui::GetIO().Fonts->TexRef);
  list.PushClipRect({0, 0}, size);
  ui::draw_video_notes(list, width, height, notes);
  list.PopClipRect();
  list.PopTexture();
  ImDrawData data;
  data.Valid = true;
  data.DisplaySize = size;
  data.FramebufferScale = {1, 1};
  data.Textures = &ImGui::GetPlatformIO().Textures;  // glyphs of a new size are sent to the graphics card
  data.AddDrawList(&list);
  ImGui_ImplOpenGL3_RenderDrawData(&data);
}

gl::RgbImage black_image(int width, int height) {
  return {width, height, std::vector<unsigned char>(std::size_t{3} * static_cast<std::size_t>(width * height))};
}

/// Returns the image of the displayed step for the video that is being made.
gl::RgbImage video_image(Host& host) {
  VideoJob& job = host.app.get<VideoJob>();
  const VideoPlan& plan = job.maker->plan();
  if (plan.window) return host.screen.picture();
  const bool as_view = plan.width == host.app.viewer->view.width && plan.height == host.app.viewer->view.height;
  if (as_view && !plan.annotated && !plan.orbit) return host.screen.renderer->picture();
  ui::SceneInput scene = ui::scene_input(host.app);
  if (host.app.viewer->view.height > 0)
    scene.scale *= std::max(1.0, static_cast<double>(plan.height) / host.app.viewer->view.height);
  const SimFrame& frame = *host.app.shown->run.frame;
  const ui::Camera camera =
      job.camera ? job.camera->next(job.maker->fraction(), ui::contact_center(frame)) : host.app.viewer->camera();
  const ui::VideoNotes notes{fmt::format("{:.3f} s", frame.time),
                             host.app.shown->state(*host.app.viewer) != nullptr ? &host.app.viewer->range : nullptr,
                             host.app.ui->dark};
  host.app.get<ui::ViewShown>().drawn = false;  // the image is drawn over the view's
  return host.screen.renderer->image(scene, camera, plan.width, plan.height, [&] {
    if (plan.annotated) draw_notes(plan.width, plan.height, notes);
  });
}

}  // namespace

StepRange steps_for_video(const Host& host) {
  const HistoryState& history = host.app.shown->run.frame->history;
  const std::optional<StepRange>& loop = host.app.shown->run.loop;
  if (!loop) return {history.first, history.last};
  return {std::max(loop->first, history.first), std::min(loop->last, history.last)};
}

void begin_video(Host& host, VideoPlan plan) {
  VideoJob& job = host.app.get<VideoJob>();
  const bool is_film = plan.path.starts_with("film-");
  set_playing(host, false);
  host.app.viewer->mode = ui::Mode::simulate;  // the mode that displays steps
  job.camera.reset();
  if (plan.orbit) job.camera.emplace(host.app.viewer->camera());
  if (plan.window) {
    plan.width = static_cast<int>(ImGui::GetIO().DisplaySize.x);
    plan.height = static_cast<int>(ImGui::GetIO().DisplaySize.y);
  }
  const std::string path = plan.path;
  try {
    job.maker = std::make_shared<VideoMaker>(std::move(plan), host.app.shown->run.frame->step);
    const std::string sample = job.maker->sample_file();
    if (!sample.empty()) write_png(sample, black_image(job.maker->plan().width, job.maker->plan().height));
  } catch (const Error& error) {
    job.maker.reset();
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    if (!is_film) ask_for_file(host.app, ui::FileTask::export_video, shown_message(error));
  }
}

void carry_out(const ui::CancelVideo&, Host& host) {
  host.app.get<VideoJob>().maker.reset();
}

void carry_out(const ui::MakeFilm&, Host& host) {
  if (!host.app.shown->run.has_history()) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning,
                    "There is no recorded step to make a film of. Space runs the scenario.", ImGui::GetTime());
    return;
  }
  begin_video(host, plan_film(free_name("film-", ".mp4"), steps_for_video(host), host.app.get<ui::VideoState>()));
}

void make_video(Host& host) {
  VideoJob& job = host.app.get<VideoJob>();
  if (!job.maker) return;
  try {
    if (!job.maker->is_ready()) return;
    const std::optional<std::uint64_t> wanted = job.maker->wanted();
    if (wanted) {
      const HistoryState& history = host.app.shown->run.frame->history;
      if (host.run.playback.plays || *wanted < history.first || *wanted > history.last)
        throw Error("The video is not made: the simulation ran on.");
      if (host.app.shown->run.frame->step != *wanted) return scrub(host, *wanted);
      write_png(job.maker->next_file(), video_image(host));
      job.maker->taken();
      if (job.maker->wanted()) scrub(host, *job.maker->wanted());
      return;
    }
    const std::optional<VideoMade> made = job.maker->finish();
    if (!made) return;
    ui::add_message(host.app.get<ui::Messages>(), made->complete ? Severity::note : Severity::warning, made->text,
                    ImGui::GetTime());
    scrub(host, job.maker->shown_before());
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
  }
  job.maker.reset();
}

}  // namespace taxel::studio
