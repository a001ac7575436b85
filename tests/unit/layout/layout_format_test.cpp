// One function for all formats of layouts: the file name selects the format, and values that a format cannot hold are
// reported.
#include "core/layout/file/layout_format.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

Layout some_layout() {
  Layout layout;
  layout.name = "tip";
  layout.mesh.file = "m.obj";
  layout.taxels = {{7, "a", dvec3(1, 2, 3), dvec3(0, 1, 0), 0.006, {{dvec3(1, 2, 3), dvec3(0, 0, 1), 0.001}}}};
  return layout;
}

TEST(LayoutFormats, AreChosenByTheFileName) {
  EXPECT_EQ(layout_format_of("a/b.TAXELS.json")->name, "Taxel layout");
  EXPECT_EQ(layout_format_of("b.json")->name, "Taxel layout");
  EXPECT_EQ(layout_format_of("b.Csv")->name, "Table of taxels");
  EXPECT_EQ(layout_format_of("csv"), nullptr);
  EXPECT_EQ(test::complaint_of([] { import_layout("b.obj"); }),
            "b.obj: is no layout by its name; known are .taxels.json, .json, .csv, .yaml, .yml");
}

/// Each format that writes reads the written taxels unchanged. The project's own format keeps all values.
TEST(LayoutFormats, KeepTaxelsInARoundTrip) {
  const test::TempFolder folder;
  int written = 0;
  for (const LayoutFormat& format : layout_formats()) {
    if (format.write == nullptr) continue;
    ++written;
    const auto path = folder / fmt::format("a{}", format.extensions[0]);
    const std::vector<std::string> lost = format.write(path, some_layout());
    const ImportedLayout read = import_layout(path);
    EXPECT_EQ(read.layout.taxels, some_layout().taxels) << format.name;
    EXPECT_EQ(read.layout == some_layout(), lost.empty()) << format.name << " says so where it cannot hold all";
    EXPECT_EQ(read.notes.empty(), lost.empty()) << format.name;
  }
  EXPECT_GE(written, 2) << "the project's own format and tables";
}

TEST(LayoutFormats, NameTheValuesThatATableCannotHold) {
  const test::TempFolder folder;
  EXPECT_EQ(import_layout(folder.write("a.csv", "x,y,z\n1,2,3\n")).notes.size(), 3U);
  const auto bad = folder.write("b.csv", "x,y,z\n1,2,?\n");
  EXPECT_EQ(test::complaint_of([&] { import_layout(bad); }),
            bad.string() + ": line 2, column Z: must be a number, is \"?\"");
}

}  // namespace
}  // namespace taxel
