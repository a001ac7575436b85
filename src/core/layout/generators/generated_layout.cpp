#include "core/layout/generators/generated_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/files.h"
#include "core/layout/generators/image_dots.h"
#include "core/layout/generators/place.h"
#include "core/layout/sensor_frame.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel {
namespace {

constexpr double kSamplesPerField = 60;  ///< samples in a receptive field, for the density
constexpr double kParallelSine = 1e-3;   ///< sine of the smallest angle between pad and distal
constexpr double kPadModulus = 5e4;      ///< [Pa], as the built-in fingertip
constexpr double kPadThickness = 0.002;  ///< [m]
constexpr double kPadDissipation = 5;    ///< [s/m]

/// Returns the axis of the file along which the mesh is longest, at right angles to `pad`.
dvec3 longest_across(const TriMesh& mesh, const dvec3& pad) {
  const dvec3 extent = mesh.bounds().extent();
  dvec3 best(0);
  double most = -1;
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 along(0);
    along[axis] = 1;
    along -= glm::dot(along, pad) * pad;
    const double length = glm::length(along) * extent[axis];
    if (glm::length(along) < 0.5 || length <= most) continue;
    most = length;
    best = glm::normalize(along);
  }
  return best;
}

/// Returns the directions of the request, completed by a guess from the shape. Adds a note for a guess.
SensorFrame frame_of(const GenerateRequest& request, const TriMesh& mesh, std::vector<std::string>& notes) {
  std::optional<SensorFrame> guess;
  if (!request.pad || !request.distal) guess = guess_frame(mesh);
  if (!request.pad && !guess)
    throw Error("", "pad", "the touching side cannot be guessed from the shape: give it with --pad X,Y,Z");
  SensorFrame frame;
  frame.pad = require_direction("", "pad", request.pad.value_or(guess ? guess->pad : dvec3(0)));
  const bool is_guess_usable = guess && glm::length(glm::cross(guess->distal, frame.pad)) > kParallelSine;
  const dvec3 distal = request.distal    ? require_direction("", "distal", *request.distal)
                       : is_guess_usable ? guess->distal
                                         : longest_across(mesh, frame.pad);
  if (!(glm::length(glm::cross(distal, frame.pad)) > kParallelSine))
    throw Error("", "distal", "must not be parallel to pad");
  frame.distal = glm::normalize(distal - glm::dot(distal, frame.pad) * frame.pad);
  if (request.pad && request.distal) return frame;
  notes.push_back(fmt::format("directions from the shape: distal {:.3g}, {:.3g}, {:.3g}; pad {:.3g}, {:.3g}, {:.3g}",
                              frame.distal.x, frame.distal.y, frame.distal.z, frame.pad.x, frame.pad.y, frame.pad.z));
  return frame;
}

/// Returns a point outside of the mesh, over the middle of the touching side.
dvec3 outside_pad(const SensorFrame& sensor, const Aabb& box) {
  return box.center() + 2 * box.diagonal() * sensor.pad;
}

}  // namespace

std::optional<PlacingFrame> frame_on_pad(const SensorFrame& sensor, const MeshIndex& skin) {
  const dvec3 outside = outside_pad(sensor, skin.mesh().bounds());
  const auto at = skin_under(skin, outside, -sensor.pad, Beyond::leave_out, "", "");
  if (!at) return std::nullopt;
  return PlacingFrame{at->position, sensor.pad, row_direction(sensor, sensor.pad)};
}

namespace {

/// Returns the frame of the pattern: at the point of the request, or in the middle of the touching side.
PlacingFrame placing_frame(const GenerateRequest& request, const SensorFrame& sensor, const MeshIndex& skin) {
  const Aabb& box = skin.mesh().bounds();
  SurfacePoint at;
  if (request.at) {
    at = skin.closest_point(*request.at);
    const double farthest = box.diagonal();
    if (!(at.distance < farthest))
      throw Error("", "at", fmt::format("is {:.3g} m from the skin, which is {:.3g} m large", at.distance, farthest));
  } else if (const std::optional<PlacingFrame> on_pad = frame_on_pad(sensor, skin)) {
    return *on_pad;
  } else {
    at = skin.closest_point(outside_pad(sensor, box));
  }
  PlacingFrame frame;
  frame.center = at.position;
  frame.normal = request.at ? smooth_normal(skin.mesh(), at) : sensor.pad;
  frame.along_row = row_direction(sensor, frame.normal);
  return frame;
}

PatternSource source_of(const GenerateRequest& request, const SensorFrame& sensor, const MeshIndex& skin) {
  PatternSource source;
  source.sensor = sensor;
  source.frame = placing_frame(request, sensor, skin);
  source.painted = !request.region.empty();
  if (source.painted) source.faces = faces_where(request.region, skin.mesh());
  if (!request.table.empty()) {
    source.table = read_file(request.table);
    source.table_file = request.table.string();
  }
  if (!request.image.empty()) source.image = std::make_shared<const GreyImage>(read_grey_image(request.image));
  return source;
}

/// Returns the density with kSamplesPerField samples in the smallest field, with two digits, at most the default.
double density_for_fields(const std::vector<Taxel>& taxels) {
  double radius = taxels.front().radius;
  for (const Taxel& taxel : taxels) radius = std::min(radius, taxel.radius);
  const double wanted = kSamplesPerField / (kPi * radius * radius);
  const double digit = std::pow(10.0, std::floor(std::log10(wanted)) - 1);
  return std::min(Sampling{}.density, std::ceil(wanted / digit) * digit);
}

/// Reads the mesh with the scale of the request or, with a note, a guessed one.
LoadedMesh read_skin(const std::filesystem::path& file, const GenerateRequest& request, dvec3& scale,
                     std::vector<std::string>& notes, Progress* progress) {
  scale = request.scale.value_or(dvec3(1));
  LoadedMesh mesh = load_mesh(file, scale, progress);
  if (request.scale) return mesh;
  const UnitGuess unit = guess_unit(*mesh.mesh);
  notes.push_back(fmt::format("unit of the mesh from its size: {} (--scale {})", unit.unit, unit.scale));
  if (unit.scale == 1) return mesh;
  scale = dvec3(unit.scale);
  return load_mesh(file, scale, progress);
}

}  // namespace

GeneratedLayout generate_layout(const std::filesystem::path& mesh, const GenerateRequest& request, Progress* progress) {
  GeneratedLayout out;
  const Pattern pattern = pattern_of_texts(request.kind, request.values);
  if (!request.region.empty() && !has_region(pattern))
    throw Error("", "region", fmt::format("does not limit the pattern {}", request.kind));
  dvec3 scale(1);
  const LoadedMesh loaded = read_skin(mesh, request, scale, out.notes, progress);
  try {
    const MeshIndex skin(loaded.mesh);
    Layout& layout = out.layout;
    layout.name = mesh.stem().string();
    layout.mesh = {mesh.string(), scale, loaded.sha256};
    layout.frame = frame_of(request, *loaded.mesh, out.notes);
    const PatternSource source = source_of(request, layout.frame, skin);
    PatternTaxels made = make_pattern(pattern, source, skin, progress);
    for (Taxel& taxel : made.taxels) taxel = rounded(std::move(taxel));
    layout.taxels = std::move(made.taxels);
    layout.sampling.density = density_for_fields(layout.taxels);
    if (source.painted) layout.sampling.region = source.faces;
    layout.material.modulus = kPadModulus;
    layout.material.thickness = kPadThickness;
    layout.material.dissipation = kPadDissipation;
    out.left_out = made.left_out;
  } catch (const Error& error) {
    throw Error(error.file().empty() ? mesh.string() : error.file(), error.where(), error.message());
  }
  return out;
}

}  // namespace taxel
