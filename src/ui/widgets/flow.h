// Flow layout: places items side by side and starts a new row if the window is too narrow, so nothing is cut off.
#pragma once

namespace taxel::ui {

/// Flow layout of the current ImGui window.
class Flow {
 public:
  explicit Flow(float gap);  ///< `gap` is the distance between items [pixels]

  /// Moves the cursor to the place of the next item, which is `width` pixels wide: in this row, or in a new one.
  void next(float width) { place(width, gap_); }
  void next(float width, float gap) { place(width, gap); }
  /// Moves the cursor to the place of the last item, at the right end of the row. The row is chosen so that it has room
  /// for `most`, the largest width that the item may have.
  void last(float width, float most = 0);
  [[nodiscard]] int rows() const { return rows_; }

 private:
  void place(float width, float gap);
  float gap_, right_;
  int rows_ = 0;
};

}  // namespace taxel::ui
