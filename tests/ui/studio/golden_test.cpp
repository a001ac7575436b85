// Keys of the settings file and of state dumps that scripts rely on, compared with lists in tests/golden. After an
// intended change, copy the file that the message names.
#include <gtest/gtest.h>

#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Adds "pointer type" of each value below `pointer`. Elements of arrays share one pointer, with * for their number.
void collect_keys(const Json& value, const std::string& pointer, std::set<std::string>& keys) {
  if (!pointer.empty() && !value.is_null()) keys.insert(pointer + " " + value.type_name());
  if (value.is_object())
    for (const auto& [key, below] : value.items()) collect_keys(below, pointer + "/" + key, keys);
  if (value.is_array())
    for (const Json& below : value) collect_keys(below, pointer + "/*", keys);
}

void expect_golden(const std::set<std::string>& keys, const std::string& name, const std::filesystem::path& folder) {
  std::string text;
  for (const std::string& key : keys) text += key + "\n";
  write_text(folder / name, text);
  EXPECT_EQ(text, file_text(std::filesystem::path(TAXEL_SOURCE_DIR "/tests/golden") / name))
      << "now: " << (folder / name).string();
}

TEST(Golden, KeepsTheKeysOfTheSettings) {
  const StudioProgram studio;
  std::set<std::string> keys;
  studio.play({kIdle}, {"--state-dir", "state", kLayoutFile});
  collect_keys(studio.state("state/settings.json"), "", keys);
  expect_golden(keys, "settings_keys.txt", studio.folder());
}

/// A script through both modes: probe, measure, patterns, clip plane, jumps, Explain, models, a study, a recording.
TEST(Golden, KeepsTheKeysOfTheStateDump) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 5e5;  // few samples, whose readings jump
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  Lines lines{kIdle, kLayoutMode, kIdle,    dump("0.json"), click(taxel(3)),
              kIdle, key("s"),    key("n"), kIdle,          dump("1.json")};
  const Lines tools{key("x"),
                    kIdle,
                    R"({"event": "mouse_move", "at": {"taxel": 3}})",
                    kIdle,
                    dump("2.json"),
                    key("Esc"),
                    kIdle,
                    key("m"),
                    kIdle,
                    click(taxel(3)),
                    kIdle,
                    click(taxel(9)),
                    kIdle,
                    dump("3.json"),
                    key("Esc"),
                    kIdle,
                    key("g", kCtrl),
                    kIdle,
                    dump("4.json"),
                    key("Esc"),
                    kIdle,
                    R"({"event": "wheel", "y": 1, "at": {"view": [0.471, 0.507]}, "mods": ["shift"]})",
                    kIdle,
                    key("Home"),
                    kIdle,
                    key("f"),
                    kIdle,
                    type("9999"),
                    kIdle,
                    dump("5.json"),
                    key("Esc"),
                    kIdle};
  const Lines jump{key("2", kCtrl),
                   kIdle,
                   key("="),
                   key("="),
                   press("Tracks"),
                   kIdle,
                   press("Jump"),
                   key("a", kCtrl),
                   type("1"),
                   key("Enter"),
                   key("b", kShift),
                   key("r", kCtrl),
                   R"({"frame": 300, "do": "wait_idle"})",
                   dump("6.json")};
  const Lines panels{key("v"),        key("e"), kIdle,           kIdle, dump("7.json"),
                     press("Panels"), kIdle,    press("Models"), kIdle, key("F2"),
                     key("F3"),       kIdle,    key("Right"),    kIdle, dump("8.json")};
  studio.play(joined({lines, tools, jump, panels}), {"coarse.taxels.json"});
  std::set<std::string> keys;
  for (int i = 0; i <= 8; ++i) collect_keys(studio.state(std::to_string(i) + ".json"), "", keys);
  expect_golden(keys, "dump_keys.txt", studio.folder());
}

}  // namespace
}  // namespace taxel::test
