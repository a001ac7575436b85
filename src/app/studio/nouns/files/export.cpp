#include "app/studio/nouns/files/export.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/host/document/project_files.h"
#include "app/studio/host/host.h"
#include "app/studio/host/png.h"
#include "app/studio/nouns/bars/error_bars_state.h"
#include "app/studio/nouns/compare/compare_commands.h"
#include "app/studio/nouns/files/ask_for_file.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_task.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/files/watched_files.h"
#include "app/studio/nouns/plot/plot_page.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/shown_message.h"
#include "core/layout/file/taxels_csv.h"
#include "core/layout/formats/format_table.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/sensor/layout_sheet.h"
#include "core/sensor/samples_csv.h"
#include "ui/scene/scene_labels.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::studio {

namespace {

constexpr int kWidth = 1000, kHeight = 900;
constexpr double kLabelHeight = 30;  // [pixels], of the 86 mm that a picture is wide on paper
constexpr double kSteepest = 89;     // of a camera, which has z up [degrees]

ui::Camera camera_from(const dvec3& direction, const Aabb& box) {
  ui::Camera camera;
  const dvec3 d = glm::normalize(direction);
  camera.elevation_deg = std::clamp(glm::degrees(std::asin(std::clamp(d.z, -1.0, 1.0))), -kSteepest, kSteepest);
  camera.azimuth_deg = std::hypot(d.x, d.y) > 1e-6 ? glm::degrees(std::atan2(d.y, d.x)) : -90;
  camera.frame(box);
  return camera;
}

SheetPicture picture_from(ui::SceneRenderer& renderer, const ui::SceneInput& scene, const ui::Camera& camera,
                          const char* caption) {
  SheetPicture picture{caption, png_bytes(renderer.cut_out(scene, camera, kWidth, kHeight)), {}};
  for (const ui::SceneLabel& label : ui::scene_labels(scene, camera, kWidth, kHeight, kLabelHeight))
    picture.labels.push_back({label.pixel.x / kWidth, label.pixel.y / kHeight, label.text, label.occluded});
  return picture;
}

/// Draws the sensor from its pad, its back and both sides, which its frame defines, with the ids of its taxels.
std::vector<SheetPicture> sheet_pictures(ui::SceneRenderer& renderer, const SensorModelPtr& model) {
  ui::SceneInput scene;
  scene.document_model = model;
  scene.overlays.sensor_transparent = false;
  scene.overlays.samples = false;
  scene.dark = false;
  const SensorFrame& frame = model->layout.frame;
  const dvec3 side = glm::cross(frame.distal, frame.pad);
  const Aabb box = model->mesh->bounds();
  return {picture_from(renderer, scene, camera_from(frame.pad, box), "Pad side"),
          picture_from(renderer, scene, camera_from(-frame.pad, box), "Back"),
          picture_from(renderer, scene, camera_from(side, box), "One side"),
          picture_from(renderer, scene, camera_from(-side, box), "Other side")};
}

/// Returns whether an export contains samples. These must be polished, so that every export of a layout has the same
/// samples.
bool tells_of_samples(ui::FileTask task) {
  return task == ui::FileTask::export_samples || task == ui::FileTask::export_sheet;
}

std::string today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%d}", fmt::localtime(now));
}

bool can_export(const Host& host, ui::FileTask task) {
  if (task == ui::FileTask::export_picture) return host.app.shown->document.model || host.app.shown->run.frame;
  if (task == ui::FileTask::export_frame)
    return host.app.shown->run.frame && !host.app.shown->run.frame->sensors.empty();
  if (task == ui::FileTask::export_plot) return !ui::sensors_shown(host.app.shown->run).empty();
  if (task == ui::FileTask::export_comparison) return ui::has_comparison_table(host.app);
  if (task == ui::FileTask::export_recording)
    return host.app.shown->run.frame && host.app.shown->run.frame->history.steps > 0;
  if (task == ui::FileTask::keep_recording) return true;
  if (task == ui::FileTask::export_video)
    return host.app.shown->run.frame && host.app.shown->run.frame->history.steps > 0 && !host.app.get<VideoJob>().maker;
  return host.edits().is_open();
}

bool samples_are_final(const Host& host) {
  return host.app.shown->document.model && host.app.shown->document.editing.compiled &&
         host.app.shown->document.model->quality == SampleQuality::polished;
}

/// Writes the recorded steps, or those of the loop.
void export_recording(Host& host, const std::string& file) {
  if (can_play_or_report(host))
    host.run.send(ExportHistoryCommand{file, host.run.cursor().loop, host.app.get<ui::ErrorBarsState>().on});
}

/// Writes a file. Returns the parts of the document that the format cannot hold.
std::vector<std::string> write_export(Host& host, const ui::ExportFile& wanted) {
  const EditSession& edits = host.edits();
  host.app.get<ui::ViewShown>().drawn = false;  // an export may draw its images over the view's
  switch (wanted.task) {
    case ui::FileTask::export_taxels:
      write_file_atomically(wanted.path, taxels_to_csv(edits.project()->layout.taxels));
      break;
    case ui::FileTask::export_samples:
      write_file_atomically(wanted.path,
                            samples_to_csv(*host.app.shown->document.model, edits.mesh()->loaded.file_face_of));
      break;
    case ui::FileTask::export_sheet: {
      const SheetContent content{host.document.file(), today(),
                                 sheet_pictures(*host.screen.renderer, host.app.shown->document.model)};
      write_file_atomically(wanted.path, layout_sheet(*host.app.shown->document.model, content));
      break;
    }
    case ui::FileTask::export_plot: {
      const std::optional<Page> page =
          ui::displayed_plot(host.app.shown->run, host.app.viewer->selection, host.app.get<ui::PlotState>(),
                             host.app.shown->document.name + ": readings of taxels");
      if (!page) throw Error(wanted.path, "there is no curve yet: run the simulation first");
      write_file_atomically(wanted.path, wanted.path.ends_with(".pdf") ? page_to_pdf(*page) : page_to_svg(*page));
      break;
    }
    case ui::FileTask::export_comparison: {
      const std::optional<ui::ComparisonTable> table = ui::comparison_table(host.app);
      if (!table) throw Error(wanted.path, "no two layouts are compared any more");
      write_file_atomically(wanted.path, table->csv);
      return {table->names};
    }
    case ui::FileTask::export_frame:
      write_file_atomically(wanted.path, frame_to_bundle(*host.app.shown->run.frame,
                                                         {{"picture.png", png_bytes(host.screen.renderer->picture())},
                                                          {"state.json", host.screen.state()}}));
      break;
    case ui::FileTask::export_picture:
      if (wanted.width < 1 || wanted.height < 1)
        throw Error(wanted.path,
                    fmt::format("a picture of {} x {} pixels cannot be made", wanted.width, wanted.height));
      write_png(wanted.path, cut_out(host, wanted.width, wanted.height));
      break;
    default: {
      const LayoutFormat* format = layout_format_of(wanted.path);
      if (format != nullptr && format->write != nullptr && format != &layout_formats().front())
        return write_layout_as(*format, wanted.path, edits.project()->layout);
      const Project written = with_mesh_on_disk(*edits.project(), wanted.path, edits.mesh());
      taxel::export_layout(wanted.path, written);
      wrote(host, wanted.path, written);
    }
  }
  return {};
}

}  // namespace

gl::RgbaImage cut_out(Host& host, int width, int height) {
  ui::SceneInput scene = ui::scene_input(host.app);
  if (host.app.viewer->view.height > 0)
    scene.scale *= std::max(1.0, static_cast<double>(height) / host.app.viewer->view.height);
  return host.screen.renderer->cut_out(scene, host.app.viewer->camera(), width, height);
}

void carry_out(const ui::ExportFile& wanted, Host& host) {
  if (!can_export(host, wanted.task)) return;
  if (wanted.path.empty()) return ask_for_file(host.app, wanted.task, "");
  if (!may_write(host, wanted.path, wanted.task, wanted.replace)) return;
  if (wanted.task == ui::FileTask::export_recording) return export_recording(host, wanted.path);
  if (wanted.task == ui::FileTask::export_video)
    return begin_video(host, plan_video(wanted.path, steps_for_video(host), host.app.get<ui::VideoState>()));
  if (wanted.task == ui::FileTask::keep_recording) return (void)host.run.send(WriteRecordingCommand{wanted.path});
  if (tells_of_samples(wanted.task) && !samples_are_final(host)) {
    host.app.get<ui::FilesState>().pending_export = wanted;
    polish(host);
    ui::add_message(host.app.get<ui::Messages>(), Severity::note,
                    wanted.path + " will be written as soon as the samples are polished.", ImGui::GetTime(),
                    ui::Holds::while_export_waits);
    return;
  }
  try {
    const std::vector<std::string> lost = write_export(host, wanted);
    std::string text = "Exported " + wanted.path;
    for (const std::string& what : lost) text += fmt::format("{} {}", &what == lost.data() ? ":" : ";", what);
    ui::add_message(host.app.get<ui::Messages>(), Severity::note, text, ImGui::GetTime());
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    ask_for_file(host.app, wanted.task, shown_message(error));
  }
}

/// Writes the export that was requested while samples were polished. Drops the export if the document is closed or
/// cannot be compiled.
void export_when_ready(Host& host) {
  std::optional<ui::Command>& pending = host.app.get<ui::FilesState>().pending_export;
  if (!pending) return;
  if (!host.edits().is_open()) {
    pending.reset();
  } else if (samples_are_final(host)) {
    ui::ExportFile wanted = *pending->get_if<ui::ExportFile>();
    pending.reset();
    wanted.replace = true;  // the user was asked before
    carry_out(wanted, host);
  } else if (host.is_idle() && !host.app.shown->document.polishing.active &&
             !host.app.shown->document.editing.compiled) {
    ui::add_message(
        host.app.get<ui::Messages>(), Severity::error,
        pending->get_if<ui::ExportFile>()->path + ": not written: " + host.app.shown->document.editing.problem,
        ImGui::GetTime());
    pending.reset();
  }
}

}  // namespace taxel::studio
