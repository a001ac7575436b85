// A layout as a printed sheet: views, a table of the taxels, the settings and the problems.
#pragma once

#include <string>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// A text over an image. Its middle is at these fractions of the width and height from the upper left corner.
struct SheetLabel {
  double x = 0, y = 0;
  std::string text;
  bool faint = false;  ///< true if the labelled thing is hidden in the image
};

/// An image of the sheet.
struct SheetPicture {
  std::string caption;
  std::string png;  ///< bytes of a PNG file
  std::vector<SheetLabel> labels;
};

/// The parts of the sheet that are not in the model.
struct SheetContent {
  std::string file;  ///< name of the layout or project; may be empty
  std::string date;  ///< date as printed; may be empty
  std::vector<SheetPicture> pictures;
};

/// Returns one HTML document that needs no other file and prints on A4, in millimetres, degrees and kilopascals. The
/// same content gives the same bytes. A taxel's row has index, id, name, centre, normal, radius, number of samples,
/// distance of the centre from the skin, and angle between its normal and the skin's. Subtaxels have rows below their
/// taxel.
std::string layout_sheet(const SensorModel& model, const SheetContent& content);

}  // namespace taxel
