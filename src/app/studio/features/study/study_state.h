// The state of the panel of parameter studies: the fields, the requested study and its runs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/document/scenario/study_curves.h"

namespace taxel::ui {

/// A study to be run, with a unique number.
struct StudyRequest {
  std::uint64_t number = 0;
  Study study;
  bool operator==(const StudyRequest& other) const { return number == other.number; }
};

/// The displayed runs.
struct StudyShown {
  StudyCurvesPtr curves;  ///< curves of the runs, or null without runs
  bool busy = false;
  double fraction = 0;
};

struct StudyState {
  using PerDocument = StudyState;  ///< another document resets all of it
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

}  // namespace taxel::ui
