// Generating many taxels at once: the pattern with its settings, its frame on the skin, the taxels that the panel would
// add, and adding them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/base/shared_value.h"
#include "core/base/text/field_spec.h"
#include "core/layout/generators/pattern.h"

namespace taxel::ui {

/// The inputs of a preview. A change of the inputs requests a new preview.
struct PatternInputs {
  Pattern pattern;
  PlacingFrame frame;
  SensorFrame sensor;
  std::shared_ptr<const MeshIndex> skin;
  FaceSet region;                            ///< painted faces of the mesh as loaded
  std::shared_ptr<const std::string> table;  ///< text of a file, or null if none is chosen
  std::string table_file;
  std::shared_ptr<const GreyImage> image;
  bool operator==(const PatternInputs&) const = default;
};

/// A preset in the list.
struct PresetNote {
  std::string name, title, source, unverified;
};

struct GenerateState {
  using PerDocument = GenerateState;  ///< another document resets all of it
  bool open = false;
  bool wants_focus = false;  ///< whether the panel comes to the front in the next frame
  bool sized = false;        ///< whether lengths were set for this mesh
  bool dragging = false;     ///< whether the frame follows the pointer
  Pattern pattern;
  std::vector<PatternShape> shapes = each_alternative<PatternShape>();  ///< last values of each kind
  PlacingFrame frame;
  std::string table_path, image_path;  ///< texts of the path fields
  std::shared_ptr<const std::string> table;
  std::string table_file;
  std::shared_ptr<const GreyImage> image;
  std::string file_problem;  ///< reason why the last requested file could not be read

  PatternInputs asked;                               ///< inputs of the newest preview
  std::uint64_t number = 0;                          ///< number of the request for `asked`
  std::uint64_t shown = 0;                           ///< number of the request that gave the members below
  std::shared_ptr<const std::vector<Taxel>> ghosts;  ///< previewed taxels, or null
  int left_out = 0;
  double least_distance = 0;  ///< smallest distance of two taxels [m], or 0 if unknown
  std::string problem;        ///< reason why there are no previewed taxels
  std::vector<PresetNote> presets;

  [[nodiscard]] bool waiting() const { return shown != number; }
};

/// Opens the panel with lengths that suit the mesh, and with the frame on the pad of the layout's frame, or at the
/// middle of the view if the mesh has no skin there. Closes the panel if it is open.
void toggle_generate(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, GenerateState& generate);
/// Closes the panel and discards the previewed taxels.
void close_generate(GenerateState& generate);
/// Adds the previewed taxels as one step of the history, selects them, and closes the panel. Does nothing if there are
/// no previewed taxels.
void accept_generate(WindowUi& ui, Viewer& viewer, const Shown& shown, GenerateState& generate);
[[nodiscard]] bool can_accept_generate(const Viewer& viewer, const Shown& shown, const GenerateState& generate);

/// Requests a preview if one of its inputs has changed. Closes the panel if there is nothing to edit any more.
void keep_preview_current(const Viewer& viewer, const Shown& shown, GenerateState& generate);

/// Changes the kind of the pattern; `kind` is an index of PatternShape. Keeps the values that both kinds share. The
/// other values are the last ones of the new kind.
void change_kind(GenerateState& generate, std::size_t kind);
template <class Kind>
void change_kind(GenerateState& generate) {
  change_kind(generate, PatternShape(Kind()).index());
}
/// Returns true if the frame places the pattern.
[[nodiscard]] bool has_frame(const Pattern& pattern);

/// Places the frame while the panel is open and no tool is active. A click on the skin moves the frame there, and a
/// drag that begins on the frame's centre moves the frame. `x` and `y` are the pointer in pixels of the view. Returns
/// whether the frame used the mouse.
bool frame_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, GenerateState& generate, double x, double y,
                 bool hovered);
/// Returns the line of the view that says how to move the pattern, and whether it is out of sight behind the mesh.
/// Empty while the panel is closed, or if no frame places the pattern.
[[nodiscard]] std::string pattern_hint(const Viewer& viewer, const Shown& shown, const GenerateState& generate);
/// Turns the pattern by 5 degrees per notch of Ctrl+wheel.
void turn_pattern(GenerateState& generate, double notches);

struct ReadPoints {  ///< a table or an image for the Generate panel
  std::string path;
};
struct ToggleGenerate {};
void carry_out(const ToggleGenerate& command, App& app);

/// The panel: a pattern, its parameters, and a live preview in the view. It opens by its own state.
extern const Feature kGenerate;
/// Draws the frame of the pattern in the view: the centre, the direction of the rows and the direction across them.
void draw_pattern_frame(const Viewer& viewer, const Shown& shown, const GenerateState& generate);
/// Sets "generate", which is null while the panel is closed.
void dump_generate(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::ReadPoints& command, Host& host);

}  // namespace taxel::studio
