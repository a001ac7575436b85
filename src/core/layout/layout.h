// A taxel layout: plain values with the content of a `*.taxels.json` file. Lengths are in metres in the frame M of the
// mesh file (after `scale`), angles in degrees if the name says so.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/material.h"
#include "core/base/math.h"
#include "core/base/shared_value.h"
#include "core/layout/calibration_settings.h"
#include "core/mesh/repair/repair_recipe.h"

namespace taxel {

enum class Metric { euclidean, geodesic };
enum class Misses { zero, omit };
enum class SampleWeights { equal, voronoi };
enum class Shells { outer, all };
enum class RayDirection { surface_normal, taxel_normal };
enum class Aggregate { weighted_mean, weighted_sum, mean, nearest, max, force };

struct Subtaxel {
  dvec3 center{0}, normal{0, 0, 1};
  double radius = 0.0;
  bool operator==(const Subtaxel&) const = default;
};

struct Taxel {
  int id = 0;
  std::string name;
  dvec3 center{0};        ///< [m], frame M
  dvec3 normal{0, 0, 1};  ///< outward; as stored, not normalised
  double radius = 0.006;  ///< radius of the receptive field [m]
  std::vector<Subtaxel> subtaxels;
  bool operator==(const Taxel&) const = default;
};

struct MeshRef {
  std::string file;  ///< relative to the layout file, or absolute
  dvec3 scale{1.0};
  std::string sha256;     ///< hash of the mesh file's bytes; unchecked if empty
  RepairRecipe repair{};  ///< how the file's triangles become a solid
  bool operator==(const MeshRef&) const = default;
};

/// Where the finger points and where it touches, in frame M; unit vectors at right angles.
struct SensorFrame {
  dvec3 distal{0, 0, 1}, pad{0, -1, 0};
  bool operator==(const SensorFrame&) const = default;
};

/// Faces of the mesh as loaded, ascending.
using FaceSet = SharedValue<std::vector<int>>;

struct Sampling {
  double density = 1.0e7;  ///< samples per m^2
  std::uint64_t seed = 42;
  SampleWeights weights = SampleWeights::equal;
  Shells shells = Shells::outer;  ///< all: those inside other ones, cavities and islands, are sampled as well
  FaceSet region{};               ///< the part that senses: samples lie on these faces only; empty: on all of them
  bool operator==(const Sampling&) const = default;
};

struct ReceptiveFieldRule {
  Metric metric = Metric::euclidean;
  double max_angle_deg = 45.0;
  bool operator==(const ReceptiveFieldRule&) const = default;
};

struct Readout {
  Aggregate aggregate = Aggregate::weighted_mean;
  Misses misses = Misses::zero;
  RayDirection ray = RayDirection::surface_normal;
  double max_depth = 0.0;  ///< [m]; 0: twice the thickness for a pad, the largest radius for a star
  bool shear = false;      ///< record the friction that each taxel feels as well
  bool operator==(const Readout&) const = default;
};

struct Layout {
  std::string name;
  MeshRef mesh;
  SensorFrame frame;
  Sampling sampling;
  ReceptiveFieldRule receptive_field;
  Readout readout;
  Material material{FieldKind::pad, 5.0e4, 0.002, 5.0, 0.5};
  std::vector<Taxel> taxels;  ///< order = index in the output
  std::optional<Calibration> calibration;
  /// Keys that this version does not know: JSON pointer -> JSON text. Written back where they were.
  std::map<std::string, std::string> unknown;
  bool operator==(const Layout&) const = default;
};

}  // namespace taxel
