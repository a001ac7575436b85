// What the panel of parameter studies holds.
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

/// The runs as they are shown.
struct StudyShown {
  StudyCurvesPtr curves;  ///< null: none were run
  bool busy = false;
  double fraction = 0;
};

struct StudyState {
  using PerDocument = StudyState;  ///< another document resets all of it
  StudyShown shown;
  std::string key = "depth";
  double from = 0, to = 0;  ///< SI; both 0: not chosen yet
  int count = 4;
  std::string key2;  ///< empty: one parameter
  double from2 = 0, to2 = 0;
  int count2 = 2;
  std::optional<StudyRequest> request;  ///< study that runs or is displayed
  std::optional<StudyRequest> before;   ///< study that was displayed when `request` began
  std::uint64_t number = 0;
  bool cancelled = false;  ///< the last one was
  std::string problem;     ///< why it cannot run
};

}  // namespace taxel::ui
