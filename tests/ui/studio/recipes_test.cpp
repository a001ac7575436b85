// The recipes of the user guide: each numbered list is carried out by a script in tests/ui/guide, whose lines expect
// the values that the recipe promises, and by the commands of its section.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "script_lines.h"

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRecipes = TAXEL_SOURCE_DIR "/tests/ui/guide";
const std::string kAssets = TAXEL_SOURCE_DIR "/assets/";

/// Returns a heading as the name of its script: "Run it" becomes "run_it".
std::string script_name(const std::string& heading) {
  std::string name;
  for (const char c : heading) {
    const bool is_word = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_word) name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!is_word && !name.empty() && name.back() != '_') name += '_';
  }
  return name;
}

Lines lines_of_text(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The sections of the guide by their headings of the second level.
std::map<std::string, Lines> guide_sections() {
  std::map<std::string, Lines> sections;
  std::string heading;
  for (const std::string& line : lines_of_text(file_text(TAXEL_SOURCE_DIR "/docs/user_guide.md"))) {
    if (line.starts_with("## ")) heading = line.substr(3);
    if (!heading.empty()) sections[heading].push_back(line);
  }
  return sections;
}

/// Returns the lines of all blocks of code in a language.
Lines code_of(const Lines& section, const std::string& language) {
  Lines code;
  bool is_in = false;
  for (const std::string& line : section) {
    if (line.starts_with("```")) {
      is_in = !is_in && line == "```" + language;
    } else if (is_in) {
      code.push_back(line);
    }
  }
  return code;
}

/// Splits a command at spaces; a text in double quotes is one word.
std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words(1);
  bool is_quoted = false;
  for (const char c : command) {
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ' ' && !is_quoted) {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

/// Runs a command of the guide. The window is drawn offscreen and closes after a few frames.
void carry_out_command(const std::string& command, const fs::path& folder) {
  std::vector<std::string> words = words_of(command);
  const std::string program = words.front();
  words.erase(words.begin());
  const bool is_window = program == "taxelstudio";
  if (is_window && std::find(words.begin(), words.end(), "--headless") == words.end())
    words.insert(words.end(), {"--headless", "--frames", "3"});
#ifdef TAXEL_PROGRAM
  ASSERT_TRUE(is_window || program == "taxel") << command;
  const Outcome outcome = run_program(is_window ? STUDIO_PROGRAM : TAXEL_PROGRAM, words, folder);
  EXPECT_EQ(outcome.status, 0) << command << ": " << outcome.err;
#endif
}

/// Writes a text whose paths relative to a folder of the assets are absolute.
void write_asset(const fs::path& file, std::string text) {
  for (std::size_t at = 0; (at = text.find("\"../", at)) != std::string::npos;) text.replace(at + 1, 3, kAssets);
  write_text(file, text);
}

/// Writes the files that a recipe begins with.
void prepare(const Json& row, const fs::path& folder) {
  for (const auto& copied : row.value("copies", std::vector<std::string>{})) {
    const bool is_asset = copied.find('/') != std::string::npos;
    const fs::path from = is_asset ? fs::path(kAssets) / copied : kRecipes / copied;
    write_asset(folder / from.filename(), file_text(from));
  }
  const Json layouts = row.value("layouts", Json::object());
  for (const auto& [name, patch] : layouts.items()) {
    Json layout = Json::parse(file_text(kLayoutFile));
    layout.merge_patch(patch);
    write_asset(folder / name, layout.dump());
  }
  if (row.contains("broken")) {  // our fingertip without its last faces
    std::string mesh = file_text(kMeshFile);
    constexpr int kMissing = 5;
    for (int i = 0; i < kMissing; ++i) mesh.resize(mesh.rfind('\n', mesh.size() - 2) + 1);
    write_text(folder / row["broken"], mesh);
  }
}

std::vector<Json> recipe_rows() {
  return Json::parse(file_text(kRecipes / "recipes.json")).get<std::vector<Json>>();
}
std::vector<std::string> recipe_names() {
  std::vector<std::string> names;
  for (const Json& row : recipe_rows()) names.push_back(script_name(row["recipe"]));
  return names;
}

class Recipe : public testing::TestWithParam<std::string> {};

TEST_P(Recipe, DoesAsTheGuideSays) {
  const std::vector<Json> rows = recipe_rows();
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [](const Json& each) { return script_name(each["recipe"]) == GetParam(); });
  ASSERT_NE(row, rows.end());
  const Lines section = guide_sections()[(*row)["recipe"]];
  const StudioProgram studio;
  prepare(*row, studio.folder());
  if (row->contains("script_in_guide")) {
    std::string script;
    for (const std::string& line : code_of(section, "json")) script += line + "\n";
    write_text(studio.folder() / (*row)["script_in_guide"], script);
  }
  for (const auto& command : row->value("before", Lines{})) carry_out_command(command, studio.folder());
  studio.play(lines_of_text(file_text(kRecipes / (GetParam() + ".jsonl"))),
              (*row)["arguments"].get<std::vector<std::string>>());
  for (const std::string& command : code_of(section, "sh")) carry_out_command(command, studio.folder());
  const Json writes = row->value("writes", Json::object());
  for (const auto& [file, content] : writes.items()) {
    ASSERT_TRUE(fs::exists(studio.folder() / file)) << file;
    EXPECT_NE(file_text(studio.folder() / file).find(content.get<std::string>()), std::string::npos) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(Guide, Recipe, testing::ValuesIn(recipe_names()),
                         [](const testing::TestParamInfo<std::string>& name) { return name.param; });

TEST(Recipes, AreThoseOfTheGuideEachWithItsScript) {
  std::set<std::string> in_guide, in_table, scripts;
  for (const auto& [heading, section] : guide_sections())
    if (std::any_of(section.begin(), section.end(), [](const std::string& line) { return line.starts_with("1. "); }))
      in_guide.insert(script_name(heading));
  for (const std::string& name : recipe_names()) EXPECT_TRUE(in_table.insert(name).second) << name << " twice";
  for (const fs::directory_entry& entry : fs::directory_iterator(kRecipes))
    if (entry.path().extension() == ".jsonl") scripts.insert(entry.path().stem());
  EXPECT_EQ(in_table, in_guide);
  EXPECT_EQ(scripts, in_guide);
  EXPECT_GT(in_guide.size(), 15U);
}

TEST(Recipes, FitOnFiveThousandWords) {
  std::istringstream guide(file_text(TAXEL_SOURCE_DIR "/docs/user_guide.md"));
  int words = 0;
  for (std::string word; guide >> word;) ++words;
  EXPECT_LE(words, 5000);
}

}  // namespace
}  // namespace taxel::test
