// Parameter studies: the scenario run with several values of one or two parameters. The fields of the panel, the
// requested study and its runs, and the commands about the files of studies.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "core/document/scenario/study.h"

namespace taxel::ui {

/// A study to be run, or a batch to be read as a study, with a unique number.
struct StudyRequest {
  std::uint64_t number = 0;
  Study study;
  std::string folder = {};  ///< batch to be read; empty if the study is to be run
  bool operator==(const StudyRequest& other) const { return number == other.number; }
};

/// The displayed runs.
struct StudyShown {
  StudyCurvesPtr curves;  ///< curves of the runs, or null without runs
  bool busy = false;
  double fraction = 0;
};

/// The displayed study, to be written as a batch, with a unique number.
struct StudySaveRequest {
  std::uint64_t number = 0;
  std::string folder;
  bool operator==(const StudySaveRequest& other) const { return number == other.number; }
};

/// A study that is written as a batch, or was written last.
struct StudySaving {
  bool busy = false;
  double fraction = 0;
};

/// The part of the state that belongs to the document.
struct StudyOfDocument {
  StudyShown shown;
  std::string key = "depth";
  double from = 0, to = 0;  ///< range in SI units; both 0 if not chosen yet
  int count = 4;
  std::string key2;  ///< second parameter; empty if only one is varied
  double from2 = 0, to2 = 0;
  int count2 = 2;
  std::optional<StudyRequest> request;  ///< study that runs or is displayed
  std::optional<StudyRequest> before;   ///< study that was displayed when `request` began
  std::uint64_t number = 0;
  bool cancelled = false;  ///< whether the last study was cancelled
  std::string problem;     ///< reason why the study cannot run
};

/// Another document ends neither the writing of a study nor the display of a batch, which needs no document.
struct StudyState : StudyOfDocument {
  void forget_document() {
    if (!request || request->folder.empty()) static_cast<StudyOfDocument&>(*this) = {};
  }
  std::optional<StudySaveRequest> save;  ///< batch that is written, or was written last
  std::uint64_t save_number = 0;         ///< number of the last request
  StudySaving saving;
};

/// Writes the displayed study as a batch. An empty path asks for the folder.
struct SaveStudy {
  std::string path = {};
  bool operator==(const SaveStudy&) const = default;
};
/// Shows the runs of a batch in the panel of studies. An empty path asks for its batch.json.
struct OpenStudy {
  std::string path = {};
  bool operator==(const OpenStudy&) const = default;
};

/// The panel, which draws the runs of a study as small multiples.
extern const Feature kStudy;
/// Sets "study": its runs, none if no study was made.
void dump_study(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::SaveStudy& command, Host& host);
void carry_out(const ui::OpenStudy& command, Host& host);

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_study_job(JobExecutor& executor);

}  // namespace taxel::studio
