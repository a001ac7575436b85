// Exports of the document: layout, tables, a sheet to print, images.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/document/project_files.h"
#include "app/studio/nouns/bars/error_bars_state.h"
#include "app/studio/nouns/plot/plot_page.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "app/studio/shell/comparison.h"
#include "app/studio/shell/export/sheet_pictures.h"
#include "app/studio/shell/studio.h"
#include "app/studio/shell/window/png.h"
#include "core/base/files.h"
#include "core/base/text/shown_message.h"
#include "core/layout/file/taxels_csv.h"
#include "core/layout/formats/format_table.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/sensor/layout_sheet.h"
#include "core/sensor/samples_csv.h"

namespace taxel::studio {

namespace {

/// Returns whether an export contains samples. These must be polished, so that every export of a layout has the same
/// samples.
bool tells_of_samples(ui::FileTask task) {
  return task == ui::FileTask::export_samples || task == ui::FileTask::export_sheet;
}

std::string today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%d}", fmt::localtime(now));
}

}  // namespace

bool Studio::can_export(ui::FileTask task) const {
  if (task == ui::FileTask::export_picture) return app_.shown->document.model || app_.shown->run.frame;
  if (task == ui::FileTask::export_frame) return app_.shown->run.frame && !app_.shown->run.frame->sensors.empty();
  if (task == ui::FileTask::export_plot) return !ui::sensors_shown(app_.shown->run).empty();
  if (task == ui::FileTask::export_comparison) return ui::has_comparison_table(app_);
  if (task == ui::FileTask::export_recording) return app_.shown->run.frame && app_.shown->run.frame->history.steps > 0;
  if (task == ui::FileTask::keep_recording) return true;
  if (task == ui::FileTask::export_video)
    return app_.shown->run.frame && app_.shown->run.frame->history.steps > 0 && !video_;
  return session_.edits().is_open();
}

void Studio::carry_out(const ui::ExportFile& wanted) {
  if (!can_export(wanted.task)) return;
  if (wanted.path.empty()) return ask_for_file(wanted.task, "");
  if (!may_write(wanted.path, wanted.task, wanted.replace)) return;
  if (wanted.task == ui::FileTask::export_recording)
    return session_.export_recording(wanted.path, app_.get<ui::ErrorBarsState>().on);
  if (wanted.task == ui::FileTask::export_video)
    return begin_video(plan_video(wanted.path, steps_for_video(), app_.get<ui::VideoState>()));
  if (wanted.task == ui::FileTask::keep_recording) return session_.write_recording(wanted.path);
  if (tells_of_samples(wanted.task) && !samples_are_final()) {
    files_.pending_export = wanted;
    session_.polish();
    ui::add_message(app_.get<ui::Messages>(), Severity::note,
                    wanted.path + " will be written as soon as the samples are polished.", ImGui::GetTime(),
                    ui::Holds::while_export_waits);
    return;
  }
  try {
    const std::vector<std::string> lost = write_export(wanted);
    std::string text = "Exported " + wanted.path;
    for (const std::string& what : lost) text += fmt::format("{} {}", &what == lost.data() ? ":" : ";", what);
    ui::add_message(app_.get<ui::Messages>(), Severity::note, text, ImGui::GetTime());
  } catch (const Error& error) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    ask_for_file(wanted.task, shown_message(error));
  }
}

bool Studio::samples_are_final() const {
  return app_.shown->document.model && app_.shown->document.editing.compiled &&
         app_.shown->document.model->quality == SampleQuality::polished;
}

/// Writes the export that was requested while samples were polished. Drops the export if the document is closed or
/// cannot be compiled.
void Studio::export_when_ready() {
  if (!files_.pending_export) return;
  if (!session_.edits().is_open()) {
    files_.pending_export.reset();
  } else if (samples_are_final()) {
    files_.pending_export->replace = true;  // the user was asked before
    carry_out(*std::exchange(files_.pending_export, std::nullopt));
  } else if (session_.idle() && !app_.shown->document.polishing.active && !app_.shown->document.editing.compiled) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error,
                    files_.pending_export->path + ": not written: " + app_.shown->document.editing.problem,
                    ImGui::GetTime());
    files_.pending_export.reset();
  }
}

/// Draws the scene as the view shows it; lines and points grow with the image.
gl::RgbaImage Studio::cut_out(int width, int height) {
  ui::SceneInput scene = ui::scene_input(app_);
  if (app_.viewer->view.height > 0)
    scene.scale *= std::max(1.0, static_cast<double>(height) / app_.viewer->view.height);
  return renderer_->cut_out(scene, app_.viewer->camera(), width, height);
}

/// Writes a file. Returns the parts of the document that the format cannot hold.
std::vector<std::string> Studio::write_export(const ui::ExportFile& wanted) {
  const EditSession& edits = session_.edits();
  app_.get<ui::ViewShown>().drawn = false;  // an export may draw its images over the view's
  switch (wanted.task) {
    case ui::FileTask::export_taxels:
      write_file_atomically(wanted.path, taxels_to_csv(edits.project()->layout.taxels));
      break;
    case ui::FileTask::export_samples:
      write_file_atomically(wanted.path,
                            samples_to_csv(*app_.shown->document.model, edits.mesh()->loaded.file_face_of));
      break;
    case ui::FileTask::export_sheet: {
      const SheetContent content{session_.file(), today(), sheet_pictures(*renderer_, app_.shown->document.model)};
      write_file_atomically(wanted.path, layout_sheet(*app_.shown->document.model, content));
      break;
    }
    case ui::FileTask::export_plot: {
      const std::optional<Page> page =
          ui::displayed_plot(app_.shown->run, app_.viewer->selection, app_.get<ui::PlotState>(),
                             app_.shown->document.name + ": readings of taxels");
      if (!page) throw Error(wanted.path, "there is no curve yet: run the simulation first");
      write_file_atomically(wanted.path, wanted.path.ends_with(".pdf") ? page_to_pdf(*page) : page_to_svg(*page));
      break;
    }
    case ui::FileTask::export_comparison: {
      const std::optional<ui::ComparisonTable> table = ui::comparison_table(app_);
      if (!table) throw Error(wanted.path, "no two layouts are compared any more");
      write_file_atomically(wanted.path, table->csv);
      return {table->names};
    }
    case ui::FileTask::export_frame:
      write_file_atomically(
          wanted.path,
          frame_to_bundle(*app_.shown->run.frame,
                          {{"picture.png", png_bytes(renderer_->picture())},
                           {"state.json", state_to_json(app_, pacing_.pace(app_.get<ui::ViewShown>().draws))}}));
      break;
    case ui::FileTask::export_picture:
      if (wanted.width < 1 || wanted.height < 1)
        throw Error(wanted.path,
                    fmt::format("a picture of {} x {} pixels cannot be made", wanted.width, wanted.height));
      write_png(wanted.path, cut_out(wanted.width, wanted.height));
      break;
    default: {
      const LayoutFormat* format = layout_format_of(wanted.path);
      if (format != nullptr && format->write != nullptr && format != &layout_formats().front())
        return write_layout_as(*format, wanted.path, edits.project()->layout);
      const Project written = with_mesh_on_disk(*edits.project(), wanted.path, edits.mesh());
      taxel::export_layout(wanted.path, written);
      wrote(wanted.path, written);
    }
  }
  return {};
}

}  // namespace taxel::studio
