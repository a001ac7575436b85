// The inspector and the outliner: fields of the edited layout and of the selected taxels, each change of which is one
// undoable edit, numbers about the compiled layout, and its problems.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/document/fixes.h"
#include "core/document/project.h"
#include "core/hydro/material/pad_modulus.h"
#include "core/layout/layout.h"
#include "core/sensor/sensor_model.h"

namespace taxel::ui {

/// All values of the layout and of the selection.
extern const Feature kInspector;
/// A tree of the document's sensor and of the bodies of the running scene.
extern const Feature kOutliner;
/// Sets "problems" and "region".
void dump_inspector(const App& app, nlohmann::ordered_json& state);

/// The data sheet from which the inspector computes the modulus of a pad.
struct MaterialState {
  using PerDocument = MaterialState;                     ///< another document resets all of it
  bool is_open = false;                                  ///< whether the fields are shown
  std::string preset;                                    ///< word of the elastomer of `layer`, or empty
  ElasticLayer layer{60e3, 0.49, 0, LayerBase::bonded};  ///< thickness 0: that of the layout
  std::optional<double> contact_radius;                  ///< radius for which the force is right [m]; empty: wide
  std::optional<PadModulus> result;                      ///< nothing if the values are bad, or not yet computed
  std::string problem;                                   ///< reason why there is no result
};

/// Numbers about a compiled layout that are always visible: coverage, overlap, and how well taxels fit the skin.
struct ModelSummary {
  SensorModelPtr model;                 ///< model that the numbers describe, or null
  int used_samples = 0;                 ///< samples in at least one receptive field
  int shared_samples = 0;               ///< samples in more than one receptive field
  double skin_area = 0, used_area = 0;  ///< areas of the skin and of its used samples [m^2]
  std::vector<int> samples_of_taxel;
  std::vector<double> distance_to_skin;   ///< distance of each taxel's centre to the skin [m]
  std::vector<double> angle_to_skin_deg;  ///< angle of each normal to the skin's at the nearest point
};

/// Returns the numbers about a model. Costs O(samples + taxels * log faces).
ModelSummary summarize(const SensorModelPtr& model);

/// Problems of the edited layout, listed by taxel.
struct LayoutProblems {
  ProjectPtr project;     ///< project with the problems, or null if nothing is edited
  SensorModelPtr model;   ///< model with the mesh that the problems refer to
  bool compiled = false;  ///< whether `model` was compiled from `project`, so samples are checked too
  Problems list;
  std::unordered_map<int, std::vector<std::size_t>> of_taxel;  ///< id -> indices in `list`
  std::vector<std::size_t> of_settings;                        ///< indices in `list` of all other problems

  /// Returns the indices in `list` of a taxel's problems; empty if there are none.
  [[nodiscard]] std::vector<std::size_t> of(int id) const;
  [[nodiscard]] Severity worst(int id) const;  ///< worst severity of the taxel, or `note` without problems
};

/// Returns every rule that the project breaks. If `model` was compiled from the project (`compiled`) and its samples
/// are polished, the list includes taxels that got no sample. Costs microseconds per taxel.
LayoutProblems layout_problems(const ProjectPtr& project, const SensorModelPtr& model, bool compiled,
                               const std::string& mesh_sha256);

/// Returns the indices of the problems of the selected taxels, in the order of the selection; of all problems if no
/// taxel is selected.
[[nodiscard]] std::vector<std::size_t> displayed_problems(const Selection& selection, const LayoutProblems& problems);

/// Draws the problems of the selected taxels, or all problems if no taxel is selected, and the button that repairs the
/// whole layout.
void draw_problem_list(WindowUi& ui, const Selection& selection, const DocumentView& document,
                       const LayoutProblems& problems, Messages& messages);

/// Opens the data sheet with the numbers of an elastomer, which must be known by this word.
void choose_elastomer(MaterialState& material, const std::string& word);

/// Draws the fields of name, frame, sampling, receptive fields, readout and material.
void draw_layout_settings(WindowUi& ui, const DocumentView& document, const ModelSummary& summary,
                          MaterialState& material);
/// Draws the fields of the calibration, which models how a device reports the readings. A switch adds or removes the
/// calibration.
void draw_calibration_settings(WindowUi& ui, const Layout& layout);

/// Returns the fields and buttons of the inspector, those of the mesh and of the scenario too.
[[nodiscard]] std::vector<PanelPart> inspector_parts();

/// Draws the fields of the selected taxels as rows of a table of properties. A typed value applies to all of them.
void draw_taxel_fields(WindowUi& ui, Selection& selection, const Project& project);

/// Draws the fields of the subtaxels of a taxel, and the buttons Delete and Add, which make edits of the taxel.
void draw_subtaxels(WindowUi& ui, const Taxel& taxel);

}  // namespace taxel::ui
