// Digits, signs and nonsense typed into every field of the inspector and the table: the layout stays valid, or the
// field reports the reason.
#include <gtest/gtest.h>

#include <algorithm>

#include <set>

#include "core/base/files.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/file/layout_json.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

const std::vector<std::string> kNonsense = {
    "-1",
    "1e999",
    "--",
    "1/0",
    "99999999999999999999999999999999999999999",
    "nonsense",
    "\\u03c0\\u00b0\\u00b2 (",
    "0",
    "%s%n",
    "2 N",
    "sqrt(-1)",
};
constexpr std::size_t kEach = 2;  ///< number of nonsense texts for each field

/// Returns the fingertip with a subtaxel and a complete calibration, so that all their fields exist.
std::string full_layout(const StudioProgram& studio) {
  Json layout = Json::parse(read_file(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  Json& taxel = layout["taxels"][3];
  taxel["subtaxels"] = {{{"center", taxel["center"]}, {"normal", taxel["normal"]}, {"radius", 0.002}}};
  layout["calibration"] = {{"seed", 1},
                           {"relaxation", {{{"amplitude", 0.1}, {"time", 1}}}},
                           {"hysteresis", {{"width", 1.0}, {"fraction", 0.5}}},
                           {"low_pass", {{"time", 0.01}}},
                           {"crosstalk", {{"fraction", 0.1}, {"reach", 0.006}}},
                           {"tare", 5.0},
                           {"gain", 0.002},
                           {"noise", 0.1},
                           {"range", {0, 255}},
                           {"quantisation", {{"bits", 8}}},
                           {"rate", 100},
                           {"dead", {{"fraction", 0.01}, {"value", 0}}}};
  const std::string file = (studio.folder() / "full.taxels.json").string();
  write_text(file, layout.dump(1));
  return file;
}

/// Returns the names of the fields that are visible with taxel 3 selected. Fields of the table are included for two
/// rows only.
std::vector<std::string> fields_of(const Json& state) {
  std::vector<std::string> fields;
  for (const Json& widget : state["widgets"]) {
    const std::string label = widget["label"], panel = widget["panel"];
    if (!widget["field"] || (panel != "Inspector" && panel != "Taxels")) continue;
    const bool row = label.starts_with("Taxel ");
    if (!row || label.starts_with("Taxel 3 ") || label.starts_with("Taxel 11 ")) fields.push_back(panel + "/" + label);
  }
  return fields;
}

/// Returns a name as in a line of a script.
std::string escaped(const std::string& text) {
  const std::string quoted = Json(text).dump(-1, ' ', true);
  return quoted.substr(1, quoted.size() - 2);
}

std::string file_of(std::size_t field, std::size_t piece) {
  return "state" + std::to_string(field) + "_" + std::to_string(piece) + ".json";
}

/// Expects that the layout breaks no rule of values.
void expect_usable(const Json& state, const std::string& what) {
  const Layout layout = parse_layout(state["document"]["layout"].dump(), "edited");
  for (const Problem& problem : check_layout_values(layout, ""))
    EXPECT_NE(problem.severity, Severity::error) << what << ": " << problem.pointer << " " << problem.message;
}

TEST(BadInput, IsRefusedInWordsOrHarmlessInEveryField) {
  const StudioProgram studio;
  std::vector<std::string> arguments = tall_window(studio, full_layout(studio));
  *std::find(arguments.begin(), arguments.end(), "1500x2700") = "1500x3400";  // for all fields of the inspector
  // The table becomes as wide as all its columns: the border between the view and the column of panels is dragged.
  const Lines begin{kLayoutMode,
                    kIdle,
                    R"({"event": "mouse_down", "at": {"view": [1.0008, 0.5]}})",
                    kIdle,
                    R"({"event": "mouse_move", "at": {"view": [0.55, 0.5]}})",
                    kIdle,
                    R"({"event": "mouse_up"})",
                    kIdle,
                    press("Taxel 3"),
                    kIdle,
                    dump("begin.json"),
                    R"({"do": "screenshot", "file": "begin.png"})"};
  studio.play(begin, arguments);
  const std::vector<std::string> fields = fields_of(studio.state("begin.json"));
  const std::set<std::string> distinct_fields(fields.begin(), fields.end());
  EXPECT_GT(distinct_fields.size(), 50U);
  for (const char* field : {"Inspector/Id", "Inspector/Normal Z", "Inspector/Seed", "Inspector/Dead value",
                            "Inspector/Arm 1 time (s)", "Inspector/Latency (s)", "Inspector/Pad Z",
                            "Inspector/Subtaxel 0 radius (mm)", "Taxels/Taxel 11 nz", "Taxels/Filter taxels"})
    EXPECT_TRUE(distinct_fields.contains(field)) << field;

  Lines script = begin;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    for (std::size_t k = 0; k < kEach; ++k) {
      const bool cell = fields[f].starts_with("Taxels/Taxel ");
      // An undone new id is no longer selected. Rows of the table select themselves.
      const bool lost = k == 0 || fields[f] == "Inspector/Id";
      if (lost && fields[f].starts_with("Inspector/"))
        script.insert(script.end(), {kIdle, press("Taxels/Taxel 3"), kIdle});
      script.push_back(R"({"event": ")" + std::string(cell ? "double_click" : "click") + R"(", "at": {"widget": ")" +
                       escaped(fields[f]) + R"("}})");
      script.insert(script.end(), {kIdle, key("a", kCtrl), type(kNonsense[(kEach * f + k) % kNonsense.size()]),
                                   key("Enter"), kIdle, dump(file_of(f, k)), key("z", kCtrl)});
      if (fields[f].ends_with("Filter taxels"))
        script.insert(script.end(),
                      {press("Taxels/Filter taxels"), kIdle, key("a", kCtrl), key("Delete"), key("Enter"), kIdle});
    }
  }
  script.insert(script.end(), {kIdle, dump("end.json")});
  studio.play(script, arguments);

  std::size_t refused = 0;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    for (std::size_t k = 0; k < kEach; ++k) {
      const Json state = studio.state(file_of(f, k));
      const std::string what = fields[f] + " <- " + kNonsense[(kEach * f + k) % kNonsense.size()];
      expect_usable(state, what);
      const bool changed = state["history"]["depth"] > 0;
      if (changed) continue;
      const Json& refusal = state["refused"];
      if (refusal.is_null()) continue;  // the value is unchanged, or the field is a filter
      // A value that is equal to the last one leaves the words on the field before.
      const std::string& typed = kNonsense[(kEach * f + k) % kNonsense.size()];
      if (refusal["typed"] != typed && f > 0 && fields[f - 1].ends_with("/" + refusal["field"].get<std::string>()))
        continue;
      ++refused;
      EXPECT_EQ("Inspector/" + refusal["field"].get<std::string>() == fields[f] ||
                    "Taxels/" + refusal["field"].get<std::string>() == fields[f],
                true)
          << what << ": " << refusal;
      EXPECT_FALSE(refusal["words"].get<std::string>().empty());
    }
  }
  EXPECT_GT(refused, fields.size()) << "most of it is nonsense";
  EXPECT_EQ(studio.state("end.json")["document"]["layout"], studio.state("begin.json")["document"]["layout"]);
  for (const Json& message : studio.state("end.json")["messages"])  // the key of undo says why it does nothing
    EXPECT_EQ(message["text"], "There is no edit to undo") << "fields say it, once";
}

}  // namespace
}  // namespace taxel::test
