// The state of the Generate panel: the pattern with its settings, and the taxels that the panel would add.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/shared_value.h"
#include "core/base/text/alternatives.h"
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

}  // namespace taxel::ui
