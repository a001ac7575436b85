// A recording of presses: readings of a real sensor, and where the object was at each row. Cut into presses, each with
// the readings of the sensor at rest before it.
#pragma once

#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/run/real/column_mapping.h"

namespace taxel {

/// A column with the position of the object along an axis of the world.
struct PoseColumn {
  int axis = 2;        ///< 0, 1 or 2 for x, y or z
  std::string column;  ///< name in the head of the table
  double unit = 0;     ///< displacement of 1 in the column [m]; 0 to take the unit in the column's head
};

/// Returns the columns of "x=0.001 mm, z=depth*-0.0020833 mm": an axis, optionally the name of its column (otherwise
/// that of the axis) and "*", and the displacement of 1 in the column, a length. Throws Error("", "--pose", ...).
std::vector<PoseColumn> parse_pose_columns(const std::string& text);

/// Which rows of a press are compared.
enum class PressPart {
  loading,  ///< until the object is at its deepest
  all       ///< until it has returned
};

/// How a recording is read.
struct PressedOptions {
  ColumnMapping mapping;                ///< columns of the taxels
  std::vector<PoseColumn> columns;      ///< columns of the position; empty to take x, y and z
  int axis = 2;                         ///< axis along which the object presses
  PressPart part = PressPart::loading;  ///< rows that are compared
};

/// One press: rows [first, end) of the recording.
struct Press {
  std::size_t first = 0, end = 0;
  std::vector<double> baseline;  ///< reading of each taxel at rest, in the unit of the recording
};

struct PressedRecording {
  std::string file;
  std::vector<int> taxel_ids;               ///< in the order of the mapping
  std::vector<std::string> columns;         ///< column of each taxel
  std::vector<dvec3> displacements;         ///< object at each row, world axes [m]
  std::vector<std::vector<double>> values;  ///< for each taxel, one value for each row; NaN if missing
  std::vector<Press> presses;               ///< at least one
  int lateral_axis = 0;                     ///< axis across the presses with the largest range
  std::vector<std::string> notes;           ///< sentences for the user

  /// Returns the number of rows in presses.
  [[nodiscard]] std::size_t row_count() const;
};

/// Most rows of a recording. A table of this size takes about 1 GB while it is read.
inline constexpr std::size_t kMostPressedRows = 2'000'000;
/// Part of the range of the pressing column within which the object is at rest.
inline constexpr double kAtRest = 0.02;
/// Most rows before a press of which the baseline is the mean.
inline constexpr std::size_t kBaselineRows = 10;

/// Reads a recording of presses. The object is at rest where the pressing column is within kAtRest of the end of its
/// range at which the recording begins; each run of other rows is a press. Throws Error(file, "line 7, column \"z\"",
/// ...) as parse_real_recording() does, and if a position is missing, a column has no unit, the pressing column is
/// constant or never returns, or the table has more than kMostPressedRows rows.
PressedRecording parse_pressed_recording(const std::string& text, const PressedOptions& options,
                                         const std::string& file);

}  // namespace taxel
