// The comparison of the run with a second layout, as menus, files and exports use it.
#pragma once

#include <optional>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/command.h"
#include "app/studio/host/document/file_watch.h"

namespace taxel::ui {

/// Compares the run with a second layout, or with the paper's released model. An empty path asks for the layout.
struct CompareLayout {
  std::string path = {};
  bool paper = false;
  bool operator==(const CompareLayout&) const = default;
};

/// Begins a comparison with a layout file, or with the paper's released model if `file` is empty, and opens its panel.
void compare_with(App& app, const std::string& file);

/// Returns the file of the second layout, or an empty text.
[[nodiscard]] std::string second_layout_file(const App& app);
/// Requests the file of the second layout to be read again.
void reread_second_layout(App& app);

/// A comparison as a table.
struct ComparisonTable {
  std::string csv;
  std::string names;  ///< names of A and B, as one sentence
};
/// Returns the displayed comparison. Empty if nothing is compared, or no row was read.
[[nodiscard]] std::optional<ComparisonTable> comparison_table(const App& app);
/// Returns whether comparison_table() has a result.
[[nodiscard]] bool has_comparison_table(const App& app);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::CompareLayout& command, Host& host);

/// Reads a second layout again that another program has changed. A deleted one stays as it was read.
void tell_second_layout(Host& host, FileChange change);

}  // namespace taxel::studio
