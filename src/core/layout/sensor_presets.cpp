// The presets with their published numbers, and the fingertip with the taxels of the paper.

#include "core/layout/sensor_presets.h"

#include <fmt/format.h>

#include "core/base/files.h"
#include "core/layout/generators/arrays.h"
#include "core/layout/generators/place.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

constexpr double kMillimetre = 1e-3;
/// Radius of a receptive field over the pitch of its grid: a little more than 1/sqrt(2), so that fields cover the area.
constexpr double kRadiusOverPitch = 0.75;

SensorPreset begin(const std::string& name, const std::string& title, TriMeshPtr mesh) {
  SensorPreset preset;
  preset.name = name;
  preset.layout.name = title;
  preset.layout.mesh = {name + ".obj", dvec3(1.0), sha256_hex(write_obj(*mesh))};
  preset.mesh = std::move(mesh);
  return preset;
}

SensorPreset fingertip() {
  SensorPreset preset = begin("fingertip", "", std::make_shared<TriMesh>(make_fingertip()));
  const MeshRef mesh = preset.layout.mesh;
  preset.layout = fingertip_layout(MeshIndex(preset.mesh), mesh.sha256);
  preset.layout.mesh = mesh;
  preset.source =
      "centres and normals of the paper \"Curved Tactile Sensor Simulation with Hydroelastic Contacts in MuJoCo\"";
  preset.unverified = "the mesh is our own design; centres are moved to its nearest points";
  return preset;
}

/// A capsule along x whose ends are round about x = `low` and x = `high`.
TriMeshPtr capsule_along_x(double radius, double low, double high, double edge_length) {
  const TriMesh upright = make_capsule(radius, 0.5 * (high - low), edge_length);
  std::vector<dvec3> vertices = upright.vertices();
  for (dvec3& v : vertices) v = dvec3(v.z + 0.5 * (high + low), v.x, v.y);  // a rotation: z to x, x to y, y to z
  return std::make_shared<TriMesh>(std::move(vertices), upright.faces());
}

struct PublishedTaxel {
  dvec3 center_mm, normal;
};

/// Taxels 0 to 11 of the ftx2 board; the finger points to -x, its pad to +y.
constexpr PublishedTaxel kIcub[] = {
    {{-10.3, 2.2, -3.8}, {0, 0.5, -0.866025}},
    {{-10.3, 4.4, 0}, {0, 1, 0}},
    {{-10.3, 2.2, 3.8}, {0, 0.5, 0.866025}},
    {{-12.5, -1.4, 4.4}, {0, 0, 1}},
    {{-12.5, -1.4, -4.4}, {0, 0, -1}},
    {{-14.1, 2.2, 3.8}, {0, 0.5, 0.866025}},
    {{-14.1, 4.4, 0}, {0, 1, 0}},
    {{-14.1, 2.2, -3.8}, {0, 0.5, -0.866025}},
    {{-18.7, 1.6, -2.5}, {-0.5, 0.471671, -0.72631}},
    {{-18.7, 3.15, 0}, {-0.5, 0.866025, 0}},
    {{-18.7, 1.6, 2.5}, {-0.5, 0.471671, 0.72631}},
    {{-20.9, 0, 0}, {-1, 0, 0}},
};

SensorPreset icub() {
  // The taxels lie 4.4 mm from the axis, and the tip has the normals of a sphere of that radius.
  const double radius = 4.4 * kMillimetre, front = -20.9 * kMillimetre + radius, back = -6.4 * kMillimetre;
  SensorPreset preset = begin("icub", "iCub fingertip, 12 taxels", capsule_along_x(radius, front, back, 0.0005));
  preset.layout.frame = {dvec3(-1, 0, 0), dvec3(0, 1, 0)};
  const MeshIndex skin(preset.mesh);
  for (const PublishedTaxel& published : kIcub) {
    const int id = static_cast<int>(preset.layout.taxels.size());
    Taxel taxel = taxel_on(*preset.mesh, skin.closest_point(published.center_mm * kMillimetre), id, 0.003);
    taxel.normal = glm::normalize(published.normal);
    taxel.name = fmt::format("taxel {}", id);
    preset.layout.taxels.push_back(rounded(taxel));
  }
  preset.source =
      "positions and normals: icub-tech-iit/electronics-boards-public, sensor-boards/ftx2 (positions to some 0.5 mm)";
  preset.unverified =
      "the mesh is a capsule of radius 4.4 mm through the published points, centres are moved to its nearest points "
      "(up to 0.6 mm); receptive radius 3 mm; material";
  return preset;
}

/// Electrodes E1 to E19, on the core; the finger points to +x, its pad to -z.
constexpr dvec3 kBioTac_mm[] = {
    {0.993, -4.855, -1.116},   {-2.700, -3.513, -3.670},  {-6.200, -3.513, -3.670}, {-8.000, -4.956, -1.116},
    {-10.500, -3.513, -3.670}, {-13.400, -4.956, -1.116}, {4.763, 0.000, -2.330},   {3.031, -1.950, -3.330},
    {3.031, 1.950, -3.330},    {1.299, 0.000, -4.330},    {0.993, 4.855, -1.116},   {-2.700, 3.513, -3.670},
    {-6.200, 3.513, -3.670},   {-8.000, 4.956, -1.116},   {-10.500, 3.513, -3.670}, {-13.400, 4.956, -1.116},
    {-2.800, 0.000, -5.080},   {-9.800, 0.000, -5.080},   {-13.600, 0.000, -5.080},
};

SensorPreset biotac() {
  const double radius = 7.0 * kMillimetre, back = -20.0 * kMillimetre;
  SensorPreset preset = begin("biotac", "BioTac, 19 electrodes", capsule_along_x(radius, back, 0.0, 0.0008));
  preset.layout.frame = {dvec3(1, 0, 0), dvec3(0, 0, -1)};
  const MeshIndex skin(preset.mesh);
  for (const dvec3& electrode_mm : kBioTac_mm) {
    const int id = static_cast<int>(preset.layout.taxels.size());
    Taxel taxel = taxel_on(*preset.mesh, skin.closest_point(electrode_mm * kMillimetre), id, 0.003);
    taxel.name = fmt::format("E{}", id + 1);
    preset.layout.taxels.push_back(rounded(taxel));
  }
  preset.source =
      "electrode positions: SynTouch, as public drivers repeat them (TAMS, University of Hamburg, tams_biotac), which "
      "take the skin for a cylinder of radius 7 mm with a round tip";
  preset.unverified =
      "numbers are not checked against SynTouch's own manual; centres are the points of the skin over the electrodes, "
      "which lie on the core; the skin's length; receptive "
      "radius 3 mm; material (the real sensor is filled with liquid)";
  return preset;
}

/// Rows x columns in the top of a box that ends half a pitch beyond them.
SensorPreset flat_array(const std::string& name, const std::string& title, int rows, int columns, double pitch,
                        double thickness) {
  const dvec3 half = 0.5 * dvec3(columns * pitch, rows * pitch, thickness);
  SensorPreset preset = begin(name, title, std::make_shared<TriMesh>(make_box(half)));
  preset.layout.frame = {dvec3(0, 1, 0), dvec3(0, 0, 1)};
  Grid grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.row_pitch = grid.column_pitch = pitch;
  grid.center = dvec3(0, 0, half.z);
  grid.radius = kRadiusOverPitch * pitch;
  for (const Taxel& taxel : planar_grid(grid)) preset.layout.taxels.push_back(rounded(taxel));
  const double samples_per_taxel = 100.0;
  preset.layout.sampling.density = std::round(samples_per_taxel / (kPi * grid.radius * grid.radius) / 1e4) * 1e4;
  preset.unverified = "outline and thickness of the pad; receptive radius (0.75 of the pitch); material";
  return preset;
}

SensorPreset xela(int columns) {
  SensorPreset preset =
      flat_array(fmt::format("xela-4x{}", columns), fmt::format("XELA uSPa 4{0}, 4 x {0} taxels", columns), 4, columns,
                 4.7 * kMillimetre, 5.0 * kMillimetre);
  preset.source = fmt::format("XELA Robotics, uSPa 4{0}: 4 x {0} taxels at a pitch of 4.7 mm", columns);
  preset.unverified = "the pitch is as commonly quoted, not checked against a data sheet; " + preset.unverified;
  return preset;
}

SensorPreset xela_curved() {
  const double radius = 13.0 * kMillimetre, pitch = 4.7 * kMillimetre;
  SensorPreset preset = begin("xela-curved", "XELA curved fingertip, 30 taxels",
                              capsule_along_x(radius, -20.0 * kMillimetre, 0.0, 0.0015));
  preset.layout.frame = {dvec3(1, 0, 0), dvec3(0, 0, -1)};
  Grid grid;
  grid.rows = 6;
  grid.columns = 5;
  grid.row_pitch = grid.column_pitch = pitch;
  grid.center = dvec3(-6.0 * kMillimetre, 0, -2.0 * radius);
  grid.along_row = dvec3(0, 1, 0);
  grid.normal = dvec3(0, 0, -1);
  grid.radius = kRadiusOverPitch * pitch;
  for (const Taxel& taxel : curved_grid(grid, dvec3(0, 0, 1), MeshIndex(preset.mesh)))
    preset.layout.taxels.push_back(rounded(taxel));
  preset.source = "XELA Robotics, curved tip for the Allegro hand (uSCuALHA): 30 taxels";
  preset.unverified =
      "the coordinates are not public: 6 x 5 at the 4.7 mm pitch of the flat sensors, projected onto a capsule of "
      "radius 13 mm; receptive radius (0.75 of the pitch); material";
  return preset;
}

SensorPreset myrmex() {
  SensorPreset preset = flat_array("myrmex", "Myrmex, 16 x 16 taxels", 16, 16, 5.0 * kMillimetre, 6.0 * kMillimetre);
  preset.source = "Schuermann, Koiva, Haschke, Ritter 2011: 16 x 16 taxels on 80 x 80 mm, a pitch of 5 mm";
  preset.unverified =
      "number and pitch, which we know at second hand; thickness of the pad; receptive radius (0.75 of the pitch); "
      "material";
  return preset;
}

/// Four barometers under a strip of silicone, with the field of docs/real.md.
SensorPreset barometers() {
  const double pitch = 6.0 * kMillimetre;
  const dvec3 half = 0.5 * kMillimetre * dvec3(120, 40, 12);
  SensorPreset preset = begin("barometers", "Strip of barometers, 4 taxels", std::make_shared<TriMesh>(make_box(half)));
  preset.layout.frame = {dvec3(1, 0, 0), dvec3(0, 0, 1)};
  Grid grid;
  grid.rows = 1;
  grid.columns = 4;
  grid.row_pitch = grid.column_pitch = pitch;
  grid.center = dvec3(0, 0, half.z);
  grid.radius = 6.85 * kMillimetre;
  for (const Taxel& taxel : planar_grid(grid)) preset.layout.taxels.push_back(rounded(taxel));
  preset.layout.sampling.density = 2e6;
  preset.layout.readout.method = ReadingMethod::exact;
  preset.layout.material.modulus = 1e5;
  preset.layout.material.thickness = 5.0 * kMillimetre;
  preset.source =
      "MTL-BaroTactileSensor (2023): four barometers MPL3115A2 in silicone, 6.0 mm apart; receptive radius fitted to a "
      "recording (docs/real.md)";
  preset.unverified =
      "outline of the strip; modulus, known only as its product with a gain for each taxel; thickness of the pad";
  return preset;
}

SensorPreset dense() {
  SensorPreset preset = flat_array("dense", "Dense grid, 26 x 27 taxels", 26, 27, 1.0 * kMillimetre, 5.0 * kMillimetre);
  preset.source = "no real sensor: 702 taxels at a pitch of 1 mm, to try the readings and the cost of a dense skin";
  preset.unverified = "all of it is ours";
  return preset;
}

}  // namespace

const std::vector<std::string>& sensor_preset_names() {
  static const std::vector<std::string> names{"fingertip",   "icub",   "biotac",     "xela-4x4", "xela-4x6",
                                              "xela-curved", "myrmex", "barometers", "dense"};
  return names;
}

SensorPreset make_sensor_preset(std::string_view name) {
  if (name == "fingertip") return fingertip();
  if (name == "icub") return icub();
  if (name == "biotac") return biotac();
  if (name == "xela-4x4") return xela(4);
  if (name == "xela-4x6") return xela(6);
  if (name == "xela-curved") return xela_curved();
  if (name == "myrmex") return myrmex();
  if (name == "barometers") return barometers();
  if (name == "dense") return dense();
  throw Error("presets", "NAME",
              fmt::format("{} is unknown, there are {}", name, fmt::join(sensor_preset_names(), ", ")));
}

namespace {

/// One taxel of the paper's +x side, in millimetres as published; the other six are its mirror images in x.
struct Published {
  const char* place;
  dvec3 center_mm, normal;
};
constexpr Published kPublished[] = {
    {"pad low", {4.1518, -6.1507, 14.6462}, {0.3739, -0.9233, 0.0878}},
    {"side low", {8.6195, 0.4629, 13.1657}, {0.9990, -0.0327, 0.0315}},
    {"side mid", {8.3022, 0.7405, 19.4511}, {0.9954, -0.0372, 0.0879}},
    {"pad mid", {3.5417, -5.0062, 23.8569}, {0.3660, -0.8935, 0.2603}},
    {"tip", {2.6699, 0.5571, 30.2862}, {0.3521, -0.1378, 0.9257}},
    {"side high", {7.1384, 0.9784, 25.8859}, {0.9230, -0.0631, 0.3795}},
};
constexpr double kRadius = 0.006;  // radius of the paper's receptive fields [m]

}  // namespace

Layout fingertip_layout(const MeshIndex& skin, const std::string& mesh_sha256) {
  Layout layout;
  layout.name = "Fingertip, 12 taxels";
  layout.mesh = {"../meshes/fingertip.obj", dvec3(1.0), mesh_sha256};
  layout.readout.max_depth = 0.004;
  for (const double side : {1.0, -1.0}) {
    for (const Published& published : kPublished) {
      const SurfacePoint at = skin.closest_point(published.center_mm * kMillimetre);
      const dvec3 mirror(side, 1.0, 1.0);
      Taxel taxel = rounded(taxel_on(skin.mesh(), at, static_cast<int>(layout.taxels.size()), kRadius));
      taxel.name = (side > 0.0 ? "right " : "left ") + std::string(published.place);
      taxel.center *= mirror;
      taxel.normal *= mirror;
      layout.taxels.push_back(taxel);
    }
  }
  return layout;
}

}  // namespace taxel
