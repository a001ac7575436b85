// What the Generate panel holds: the pattern as it is set, and the taxels that it would add.
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

/// What a preview is made of; it is asked for again when this changes.
struct PatternJob {
  Pattern pattern;
  PlacingFrame frame;
  SensorFrame sensor;
  std::shared_ptr<const MeshIndex> skin;
  FaceSet region;                            ///< painted faces of the mesh as loaded
  std::shared_ptr<const std::string> table;  ///< text of a file; null: none chosen
  std::string table_file;
  std::shared_ptr<const GreyImage> image;
  bool operator==(const PatternJob&) const = default;
};

/// A preset in the list.
struct PresetNote {
  std::string name, title, source, unverified;
};

struct GenerateState {
  using PerDocument = GenerateState;  ///< another document resets all of it
  bool open = false;
  bool wants_focus = false;  ///< the panel comes to the front in the next picture
  bool sized = false;        ///< lengths were set for this mesh
  bool dragging = false;     ///< the frame follows the pointer
  Pattern pattern;
  std::vector<PatternShape> shapes = each_alternative<PatternShape>();  ///< last values of each kind
  PlacingFrame frame;
  std::string table_path, image_path;  ///< what the fields say
  std::shared_ptr<const std::string> table;
  std::string table_file;
  std::shared_ptr<const GreyImage> image;
  std::string file_problem;  ///< why the file that was asked for last could not be read

  PatternJob asked;                                  ///< what the newest preview is made of
  std::uint64_t number = 0;                          ///< of that request
  std::uint64_t shown = 0;                           ///< of the request that what follows answers
  std::shared_ptr<const std::vector<Taxel>> ghosts;  ///< null: none
  int left_out = 0;
  double least_distance = 0;  ///< [m]; 0: not told
  std::string problem;        ///< why there are none
  std::vector<PresetNote> presets;

  [[nodiscard]] bool waiting() const { return shown != number; }
};

}  // namespace taxel::ui
