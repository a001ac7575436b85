// Layout files without the directions of the finger. The directions are guessed from the shape and the taxels.
#include "core/sensor/layout_source.h"

#include <gtest/gtest.h>

#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

const std::string kLayout = TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json";

/// The project's fingertip and its layout, rotated so that it points along +y and touches along +x.
std::filesystem::path turned_layout(const test::TempFolder& folder, bool with_frame) {
  const dmat3 R(dvec3(0, 0, 1), dvec3(-1, 0, 0), dvec3(0, 1, 0));  // columns: images of x, y, z
  const TriMeshPtr mesh = load_mesh(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj").mesh;
  std::vector<dvec3> vertices = mesh->vertices();
  for (dvec3& v : vertices) v = R * v;
  save_mesh(folder / "turned.obj", TriMesh(std::move(vertices), mesh->faces()));
  Layout layout = read_layout(kLayout);
  layout.mesh = {"turned.obj", dvec3(1), ""};
  for (Taxel& taxel : layout.taxels) {
    taxel.center = R * taxel.center;
    taxel.normal = R * taxel.normal;
  }
  std::string text = layout_to_json(layout);
  if (!with_frame) {
    const std::size_t begin = text.find("  \"frame\""), end = text.find("  \"sampling\"");
    EXPECT_LT(begin, end);
    text.erase(begin, end - begin);
  }
  return folder.write("turned.taxels.json", text);
}

TEST(ImportedSource, GuessesTheFrameIfTheFileHasNone) {
  const test::TempFolder folder;
  const ImportedSource read = read_any_source(turned_layout(folder, false), {});
  EXPECT_TRUE(read.frame_is_guess);
  EXPECT_EQ(read.source.layout.frame.distal, dvec3(0, 1, 0));
  EXPECT_EQ(read.source.layout.frame.pad, dvec3(1, 0, 0));
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_EQ(read.notes[0],
            "the file does not say where the sensor points: distal is [0, 1, 0], pad is [1, 0, 0], guessed from its "
            "shape");
}

TEST(ImportedSource, KeepsTheFrameOfTheFile) {
  const test::TempFolder folder;
  const ImportedSource read = read_any_source(turned_layout(folder, true), {});
  EXPECT_FALSE(read.frame_is_guess);
  EXPECT_EQ(read.source.layout.frame, SensorFrame{}) << "even where the shape says otherwise";
  EXPECT_TRUE(read.notes.empty());
}

}  // namespace
}  // namespace taxel
