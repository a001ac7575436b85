#include "app/studio/nouns/files/export.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/host.h"
#include "app/studio/host/png.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/files/watched_files.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/real/real_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/message.h"
#include "core/layout/file/taxels_csv.h"
#include "core/layout/formats/layout_format.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/sensor/layout_sheet.h"
#include "core/sensor/samples_csv.h"
#include "ui/scene/scene_labels.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::studio {

gl::RgbaImage cut_out(Host& host, int width, int height) {
  ui::SceneInput scene = ui::scene_input(host.app);
  if (host.app.viewer->view.height > 0)
    scene.scale *= std::max(1.0, static_cast<double>(height) / host.app.viewer->view.height);
  return host.screen.renderer->cut_out(scene, host.app.viewer->camera(), width, height);
}

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
  for (const ui::SceneLabel& label : ui::scene_labels(scene, camera, kWidth, kHeight, {.text_height = kLabelHeight}))
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

std::string today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%d}", fmt::localtime(now));
}

bool has_document(const Host& host) {
  return host.edits().is_open();
}

bool has_scene(const Host& host) {
  return host.app.shown->document.model || host.app.shown->run.frame;
}

bool has_sensors(const Host& host) {
  return host.app.shown->run.frame && !host.app.shown->run.frame->sensors.empty();
}

bool has_plot(const Host& host) {
  return !ui::sensors_shown(host.app.shown->run).empty();
}

bool has_steps(const Host& host) {
  return host.app.shown->run.frame && host.app.shown->run.frame->history.steps > 0;
}

bool samples_are_final(const Host& host) {
  return host.app.shown->document.model && host.app.shown->document.editing.compiled &&
         host.app.shown->document.model->quality == SampleQuality::polished;
}

// Each of the following writes a file, and returns the parts of the document that its format cannot hold.

using Lost = std::vector<std::string>;

Lost write_taxels(Host& host, const ui::ExportFile& wanted) {
  write_file_atomically(wanted.path, taxels_to_csv(host.edits().project()->layout.taxels));
  return {};
}

Lost write_samples(Host& host, const ui::ExportFile& wanted) {
  write_file_atomically(wanted.path,
                        samples_to_csv(*host.app.shown->document.model, host.edits().mesh()->loaded.file_face_of));
  return {};
}

Lost write_sheet(Host& host, const ui::ExportFile& wanted) {
  const SensorModelPtr& model = host.app.shown->document.model;
  const SheetContent content{host.document.file(), today(), sheet_pictures(*host.screen.renderer, model)};
  write_file_atomically(wanted.path, layout_sheet(*model, content));
  return {};
}

Lost write_plot(Host& host, const ui::ExportFile& wanted) {
  const std::optional<Page> page =
      ui::displayed_plot(host.app.shown->run, host.app.viewer->selection, host.app.get<ui::PlotState>(),
                         host.app.get<ui::RealState>(), host.app.shown->document.name + ": readings of taxels");
  if (!page) throw Error(wanted.path, "there is no curve yet: run the simulation first");
  write_file_atomically(wanted.path, wanted.path.ends_with(".pdf") ? page_to_pdf(*page) : page_to_svg(*page));
  return {};
}

Lost write_comparison(Host& host, const ui::ExportFile& wanted) {
  const std::optional<ui::ComparisonTable> table = ui::comparison_table(host.app);
  if (!table) throw Error(wanted.path, "no two layouts are compared any more");
  write_file_atomically(wanted.path, table->csv);
  return {table->names};
}

Lost write_fits(Host& host, const ui::ExportFile& wanted) {
  write_file_atomically(wanted.path, ui::table_of_fits(host.app));
  return {};
}

Lost write_step(Host& host, const ui::ExportFile& wanted) {
  write_file_atomically(wanted.path, frame_to_bundle(*host.app.shown->run.frame,
                                                     {{"picture.png", png_bytes(host.screen.renderer->picture())},
                                                      {"state.json", host.screen.state()}}));
  return {};
}

Lost write_picture(Host& host, const ui::ExportFile& wanted) {
  if (wanted.width < 1 || wanted.height < 1)
    throw Error(wanted.path, fmt::format("a picture of {} x {} pixels cannot be made", wanted.width, wanted.height));
  write_png(wanted.path, cut_out(host, wanted.width, wanted.height));
  return {};
}

Lost write_layout(Host& host, const ui::ExportFile& wanted) {
  const EditSession& edits = host.edits();
  const LayoutFormat* format = layout_format_of(wanted.path);
  if (format != nullptr && format->write != nullptr && format != &layout_formats().front())
    return write_layout_as(*format, wanted.path, edits.project()->layout);
  const Project written = with_mesh_on_disk(*edits.project(), wanted.path, edits.mesh());
  taxel::export_layout(wanted.path, written);
  wrote(host, wanted.path, written);
  return {};
}

// Each of the following begins an export that ends later, with a message of its own.

/// Exports the recorded steps, or those of the loop.
void begin_recording(Host& host, const std::string& file) {
  if (can_play_or_report(host))
    host.run.simulation->send(ExportHistoryCommand{file, host.run.cursor.loop, host.app.get<ui::ErrorBarsState>().on});
}

void begin_kept_recording(Host& host, const std::string& file) {
  host.run.simulation->send(WriteRecordingCommand{file});
}

void begin_video_of_steps(Host& host, const std::string& file) {
  ui::VideoState& settings = host.app.get<ui::VideoState>();
  settings.source = video_source(host.app);
  begin_video(host, plan_video(file, chosen_steps(settings), settings));
}

/// How the files of a task are written. A row has `write` or `begin`.
struct Export {
  ui::FileTask task;
  bool (*can)(const Host& host);
  Lost (*write)(Host& host, const ui::ExportFile& wanted) = nullptr;
  void (*begin)(Host& host, const std::string& file) = nullptr;
  bool has_samples = false;  ///< these must be polished, so that every export of a layout has the same ones
};

constexpr std::array kExports = {
    Export{ui::FileTask::export_layout, has_document, write_layout},
    Export{ui::FileTask::export_taxels, has_document, write_taxels},
    Export{ui::FileTask::export_samples, has_document, write_samples, nullptr, true},
    Export{ui::FileTask::export_sheet, has_document, write_sheet, nullptr, true},
    Export{ui::FileTask::export_picture, has_scene, write_picture},
    Export{ui::FileTask::export_plot, has_plot, write_plot},
    Export{ui::FileTask::export_comparison, [](const Host& host) { return ui::has_comparison_table(host.app); },
           write_comparison},
    Export{ui::FileTask::export_fits, [](const Host& host) { return ui::has_fits(host.app); }, write_fits},
    Export{ui::FileTask::export_frame, has_sensors, write_step},
    Export{ui::FileTask::export_recording, has_steps, nullptr, begin_recording},
    Export{ui::FileTask::keep_recording, [](const Host&) { return true; }, nullptr, begin_kept_recording},
    Export{ui::FileTask::export_video,
           [](const Host& host) { return has_steps(host) && !host.app.get<VideoJob>().maker; }, nullptr,
           begin_video_of_steps},
};

}  // namespace

void carry_out(const ui::ExportFile& wanted, Host& host) {
  const auto* const row =
      std::find_if(kExports.begin(), kExports.end(), [&](const Export& each) { return each.task == wanted.task; });
  if (row == kExports.end() || !row->can(host)) return;
  if (wanted.path.empty()) return ask_for_file(host.app, wanted.task, "");
  if (!may_write(host, wanted.path, wanted.task, wanted.replace)) return;
  if (row->begin != nullptr) return row->begin(host, wanted.path);
  if (row->has_samples && !samples_are_final(host)) {
    host.app.get<ui::FilesState>().pending_export = wanted;
    polish(host);
    ui::add_message(host.app.get<ui::Messages>(), Severity::note,
                    wanted.path + " will be written as soon as the samples are polished.", ImGui::GetTime(),
                    ui::Holds::while_export_waits);
    return;
  }
  try {
    host.app.get<ui::ViewShown>().drawn = false;  // an export may draw its images over the view's
    const Lost lost = row->write(host, wanted);
    std::string text = "Exported " + wanted.path;
    for (const std::string& part : lost) text += fmt::format("{} {}", &part == lost.data() ? ":" : ";", part);
    ui::add_message(host.app.get<ui::Messages>(), Severity::note, text, ImGui::GetTime());
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    ask_for_file(host.app, wanted.task, shown_message(error));
  }
}

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
