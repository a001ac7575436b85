// Items side by side, in as many rows as they need: a narrow window or large text cuts nothing off.
#pragma once

namespace taxel::ui {

/// Of the current window, whose content it is.
class Flow {
 public:
  explicit Flow(float gap);  ///< between items [pixels]

  /// Before each item of so many pixels: the cursor goes on in this row, or to the next one.
  void next(float width) { place(width, gap_); }
  void next(float width, float gap) { place(width, gap); }
  /// Before the last item: to the right end of the row that has room for the most that it may ever need.
  void last(float width, float most = 0);
  [[nodiscard]] int rows() const { return rows_; }

 private:
  void place(float width, float gap);
  float gap_, right_;
  int rows_ = 0;
};

}  // namespace taxel::ui
