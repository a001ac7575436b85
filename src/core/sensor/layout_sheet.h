// A layout on paper, for the lab: views, every taxel with its numbers, the settings, and what is wrong.
#pragma once

#include <string>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// Text over a picture, its middle at these parts of the width and the height from the upper left corner.
struct SheetLabel {
  double x = 0, y = 0;
  std::string text;
  bool faint = false;  ///< what it names is hidden in the picture
};

struct SheetPicture {
  std::string caption;
  std::string png;  ///< bytes of the file
  std::vector<SheetLabel> labels;
};

struct SheetContent {
  std::string file;  ///< of the layout or project; may be empty
  std::string date;  ///< as it is to be printed; may be empty
  std::vector<SheetPicture> pictures;
};

/// One HTML document that needs no other file and prints on A4: millimetres, degrees, kilopascals. The same bytes for
/// the same content. Of each taxel: index in the output, id, name, centre, normal, radius, samples, distance of the
/// centre from the skin and angle of the normal against the skin's there; subtaxels in rows below it.
std::string layout_sheet(const SensorModel& model, const SheetContent& content);

}  // namespace taxel
