#include "app/studio/nouns/data_set/replay.h"

#include <fmt/format.h>

#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

/// Returns whether the run is that of the opened episode: the document was not edited since.
bool is_run_of_episode(const Shown& shown, const DataSetState& state) {
  const Editing& editing = shown.document.editing;
  return shown.run.simulates_document && shown.run.runs_scenario && editing.undo_depth == 0 &&
         shown.run.scenario == state.replayed->scenario;
}

std::string largest_text(const Shown& shown, const DataSetState& state) {
  const ReplayCheck& check = state.check;
  if (!shown.document.model || check.largest == 0) return "";
  const Layout& layout = shown.document.model->layout;
  const int id = check.largest_taxel < layout.taxels.size() ? layout.taxels[check.largest_taxel].id : -1;
  const ReadingUnit unit = shown_unit(layout.readout.aggregate);
  return fmt::format("; the largest difference of a reading is {:.3g} {} (taxel {} at {:.6g} s)",
                     unit.scale * check.largest, unit.text, id, check.largest_time);
}

std::string difference_text(const Shown& shown, const DataSetState& state) {
  const ReplayCheck& check = state.check;
  const auto rows = static_cast<std::size_t>(state.replayed->rows.rows);
  std::string text = fmt::format("The replay differs from episode {}", state.replayed->from.episode);
  if (!check.problem.empty()) return text + ": " + check.problem + ".";
  if (check.rows != rows) text += fmt::format(": it has {} rows, the episode has {}", check.rows, rows);
  if (check.different_rows > 0) text += fmt::format(" in {} of {} rows", check.different_rows, rows);
  text += largest_text(shown, state);
  if (check.has_other_times) text += "; times or travels differ as well";
  if (check.has_preview) text += "; some rows were read with preview samples: run again";
  return text + ". The data set was written by " + state.replayed->program + "; other versions may give other bits.";
}

}  // namespace

void follow_replay(const Shown& shown, DataSetState& state) {
  if (!state.replayed) {
    state.check = {};
    return;
  }
  const SimFramePtr& frame = shown.run.frame;
  if (!frame || !frame->trace || !is_run_of_episode(shown, state)) return;
  compare_with_episode(*frame->trace, state.replayed->rows, state.replayed->bits, state.check);
}

ReplayVerdict replay_verdict(const Shown& shown, const DataSetState& state) {
  if (!state.replayed) return ReplayVerdict::none;
  if (shown.document.editing.undo_depth > 0) return ReplayVerdict::edited;
  const ReplayCheck& check = state.check;
  if (!is_run_of_episode(shown, state) || check.rows == 0) return ReplayVerdict::none;
  if (check.different_rows > 0 || !check.problem.empty()) return ReplayVerdict::different;
  const auto rows = static_cast<std::size_t>(state.replayed->rows.rows);
  const bool is_over = shown.run.frame && shown.run.frame->finished;
  if (check.rows == rows) return ReplayVerdict::equal;
  return is_over ? ReplayVerdict::different : ReplayVerdict::running;
}

std::string replay_text(const Shown& shown, const DataSetState& state) {
  const auto rows = state.replayed ? static_cast<std::size_t>(state.replayed->rows.rows) : 0;
  switch (replay_verdict(shown, state)) {
    case ReplayVerdict::none:
      return "";
    case ReplayVerdict::edited:
      return fmt::format("Not compared with episode {}: the document was edited. Undo to compare again.",
                         state.replayed->from.episode);
    case ReplayVerdict::running:
      return fmt::format("Replay of episode {}: {} of {} rows, all equal so far.", state.replayed->from.episode,
                         state.check.rows, rows);
    case ReplayVerdict::equal:
      return fmt::format(
          "The replay equals episode {} {}: readings, times and travels of {} rows. Largest difference 0.",
          state.replayed->from.episode,
          state.replayed->bits == 64 ? "bit for bit" : "to float32, as the data set holds it", rows);
    case ReplayVerdict::different:
      return difference_text(shown, state);
  }
  return "";
}

}  // namespace taxel::ui
