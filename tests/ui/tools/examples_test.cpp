// The examples that travel inside the program: complete, named as their layouts, and written as they are shipped.
#include "app/studio/host/examples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/layout/sensor_presets.h"
#include "fixtures/run_program.h"

namespace taxel::studio {
namespace {

namespace fs = std::filesystem;
using test::file_text;
using test::write_text;

const Example* preset_example(const std::string& name) {
  for (const Example& example : examples())
    if (example.name == "built-in: preset " + name) return &example;
  return nullptr;
}

fs::path fresh(const std::string& name) {
  return test::fresh_folder(fs::path(TAXEL_BINARY_DIR) / "example_tests", name);
}

TEST(Examples, HaveEveryKnownSensorUnderTheTitleOfItsLayout) {
  for (const std::string& name : sensor_preset_names()) {
    if (name == "fingertip") continue;  // the sweep is of this one
    const Example* example = preset_example(name);
    ASSERT_NE(example, nullptr) << name;
    EXPECT_EQ(example->label, make_sensor_preset(name).layout.name);
  }
  EXPECT_EQ(examples().size(), 3 + sensor_preset_names().size() - 1);
}

TEST(Examples, HaveNamesAndLabelsOfTheirOwn) {
  std::set<std::string> names, labels;
  for (const Example& example : examples()) {
    EXPECT_TRUE(names.insert(example.name).second) << example.name;
    EXPECT_TRUE(labels.insert(example.label).second) << example.label;
    EXPECT_NE(is_built_in(example.name), is_scene_example(example.name)) << example.name;
    EXPECT_FALSE(example.tip.empty());
  }
}

TEST(Examples, LoadADocumentForEachBuiltInName) {
  for (const Example& example : examples()) {
    if (!is_built_in(example.name)) continue;
    SensorBuild how;
    how.quality = SampleQuality::preview;
    const LoadedDocument document = load_built_in(example.name, how);
    EXPECT_TRUE(document.problem.empty()) << example.name << ": " << document.problem;
    ASSERT_NE(document.project, nullptr) << example.name;
    EXPECT_FALSE(document.project->layout.taxels.empty()) << example.name;
    const bool preset = example.name.find("preset") != std::string::npos;
    EXPECT_EQ(document.remarks.size(), preset ? 2U : 0U) << "source and estimates";
  }
  EXPECT_THROW((void)load_built_in("built-in: preset nothing", SensorBuild{}), Error);
  EXPECT_THROW((void)load_built_in("built-in: nothing", SensorBuild{}), Error);
}

TEST(Examples, WriteTheFilesOfEachScene) {
  const fs::path folder = fresh("written");
  write_examples(folder);
  for (const Example& example : examples()) {
    if (is_scene_example(example.name)) {
      EXPECT_TRUE(fs::exists(folder / scene_of_example(example.name)));
    }
  }
  for (const char* file : {"layouts/fingertip.taxels.json", "meshes/fingertip.obj", "meshes/hand_palm.obj"})
    EXPECT_EQ(file_text(folder / file), file_text(fs::path(TAXEL_SOURCE_DIR) / "assets" / file)) << file;
  EXPECT_FALSE(fs::exists(folder / "pictures"));
}

TEST(Examples, NameTheFileThatCannotBeWritten) {
  const fs::path folder = fresh("blocked");
  write_text(folder / "meshes", "a file where a folder has to be");
  try {
    write_examples(folder);
    FAIL() << "a file has the name of the folder";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find((folder / "meshes").string()), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace taxel::studio
