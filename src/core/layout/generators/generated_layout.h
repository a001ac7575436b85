// A layout that a pattern makes on a mesh without a window: the frame of the pattern follows from the directions of the
// sensor, and settings that the pattern does not give are those of a fingertip.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/layout/generators/pattern_text.h"
#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns the faces, ascending, whose centroid (x, y, z; a number without a unit is in metres) and unit normal (nx,
/// ny, nz) satisfy all conditions, such as "z > 5 mm, ny < -0.3". A condition is a variable, < or >, and a number with
/// arithmetic and units; commas separate conditions. Throws Error("", "region", ...) naming the condition that cannot
/// be read, or if no face is left.
std::vector<int> faces_where(std::string_view conditions, const TriMesh& mesh);

/// Returns the frame of a pattern in the middle of the touching side: at the point of the skin under `sensor.pad`, seen
/// along it and straight with the sensor. Empty if the mesh has no skin there.
std::optional<PlacingFrame> frame_on_pad(const SensorFrame& sensor, const MeshIndex& skin);

/// The pattern that a user asks for, and its place.
struct GenerateRequest {
  std::string kind = "hexagonal";    ///< word of the pattern
  PatternTexts values = {};          ///< fields of the pattern; defaults for the others
  std::string region = {};           ///< conditions of faces_where(); the whole skin if empty
  std::optional<dvec3> pad = {};     ///< direction of the touching side, frame M; guessed if empty
  std::optional<dvec3> distal = {};  ///< direction in which the sensor points, frame M; guessed if empty
  std::optional<dvec3> at = {};      ///< middle of the pattern [m]; by default the middle of the side `pad`
  std::filesystem::path table = {};  ///< file of the pattern `table`
  std::filesystem::path image = {};  ///< file of the pattern `image`
  std::optional<dvec3> scale = {};   ///< factors from the mesh file to metres; guessed (m or mm) if empty
};

struct GeneratedLayout {
  Layout layout;                   ///< mesh.file is the path of the request
  int left_out = 0;                ///< number of points of the pattern that are not over the skin
  std::vector<std::string> notes;  ///< sentences on values that were guessed
};

/// Reads the mesh and makes the layout. Its material is the soft pad of the built-in fingertip (2 mm, 50 kPa), and its
/// density gives 60 samples in the smallest receptive field. Throws Error naming the mesh file and the option of the
/// request: a mesh that cannot be read or has no surface, directions that cannot be guessed or are parallel, fields and
/// ranges as pattern_of_texts() and make_pattern() do, a pattern of which no point is over the skin; and Cancelled.
GeneratedLayout generate_layout(const std::filesystem::path& mesh, const GenerateRequest& request,
                                Progress* progress = nullptr);

}  // namespace taxel
