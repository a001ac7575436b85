// Exports of a document: tables, a sheet to print, images.
#include <gtest/gtest.h>

#include <sstream>

#include "core/layout/file/taxels_csv.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns lines that choose an item of the menu File, type a name and press Enter.
Lines exported(const std::string& label, const std::string& file) {
  return {press("File"), kIdle, press("Export"), kIdle, press(label), kIdle, type(file), kIdle, key("Enter"), kIdle};
}

std::string in(const StudioProgram& studio, const char* name) {
  return (studio.folder() / name).string();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Export, WritesTablesOfTaxelsAndSamples) {
  const StudioProgram studio;
  studio.play(joined({{kLayoutMode, kIdle},
                      exported("Export taxels (CSV)...", in(studio, "taxels")),
                      exported("Export samples (CSV)...", in(studio, "samples.csv")),
                      {dump("state.json")}}),
              {kLayoutFile});
  const Json state = studio.state("state.json");
  const CsvTaxels table = parse_taxels_csv(file_text(studio.folder() / "taxels.csv"));
  ASSERT_EQ(table.taxels.size(), 12U) << "the name was completed";
  EXPECT_EQ(table.taxels[3].center, vector_of(taxel_of(state["document"]["layout"], table.taxels[3].id)["center"]));
  EXPECT_EQ(lines_of(file_text(studio.folder() / "samples.csv")).size(),
            state["document"]["samples"].get<std::size_t>() + 1);
#ifdef TAXEL_PROGRAM
  run_program(TAXEL_PROGRAM, {"samples", kLayoutFile, "--out", "same.csv"}, studio.folder());
  EXPECT_EQ(file_text(studio.folder() / "samples.csv"), file_text(studio.folder() / "same.csv"))
      << "the bytes that the command line writes";
#endif
}

TEST(Export, ReportsTheLossesOfTheFormatOfTheFileName) {
  const StudioProgram studio;
  studio.play({kLayoutMode, kIdle, key("e", kCtrl), kIdle, type(in(studio, "table.csv")), kIdle, key("Enter"), kIdle,
               dump("state.json")},
              {kLayoutFile});
  EXPECT_EQ(parse_taxels_csv(file_text(studio.folder() / "table.csv")).taxels.size(), 12U);
  EXPECT_NE(studio.state("state.json")["messages"].dump().find("a table holds no mesh"), std::string::npos);
}

TEST(Export, WritesASheetWithFourViewsAndTheIds) {
  const StudioProgram studio;
  studio.play(joined({{kLayoutMode, kIdle},
                      exported("Export sheet to print (HTML)...", in(studio, "sheet.html")),
                      {dump("state.json")}}),
              {kLayoutFile});
  const std::string html = file_text(studio.folder() / "sheet.html");
  EXPECT_EQ(count(html, "<figure"), 4U);
  EXPECT_EQ(count(html, "data:image/png;base64,iVBOR"), 4U);
  for (int id = 0; id < 12; ++id)
    EXPECT_NE(html.find("%\">" + std::to_string(id) + "</span>"), std::string::npos) << id << " is seen in some view";
  EXPECT_NE(html.find("12 taxels on fingertip.obj"), std::string::npos);
}

TEST(Export, WritesATransparentImageOfAnySize) {
  const StudioProgram studio;
  const std::string select_all = key("a", kCtrl);
  studio.play(joined({{kLayoutMode,
                       kIdle,
                       press("File"),
                       kIdle,
                       press("Export"),
                       kIdle,
                       press("Export picture (PNG)..."),
                       kIdle,
                       R"({"event": "double_click", "at": {"widget": "Width"}})",
                       select_all,
                       type("321"),
                       kIdle,
                       R"({"event": "double_click", "at": {"widget": "Height"}})",
                       select_all,
                       type("123"),
                       kIdle,
                       press("Path"),
                       select_all,
                       type(in(studio, "view")),
                       kIdle,
                       key("Enter"),
                       kIdle,
                       dump("state.json")}}),
              {kLayoutFile});
  const Picture picture = studio.picture("view.png");
  EXPECT_EQ(picture.width, 321);
  EXPECT_EQ(picture.height, 123);
  EXPECT_EQ(file_text(studio.folder() / "view.png")[25], 6) << "colour type: RGB and alpha";
  EXPECT_NE(studio.state("state.json")["messages"].dump().find("Exported"), std::string::npos);
}

}  // namespace
}  // namespace taxel::test
