// Layouts of known sensors, each with a mesh and the sources of its numbers, and the built-in layout of this project.
//
// Sources. BioTac: electrode positions of SynTouch as public drivers repeat them (TAMS, University of Hamburg,
// tams_biotac), which approximate the skin by a cylinder of radius 7 mm with a round tip. iCub: positions and normals
// of the ftx2 fingertip as IIT publishes them (icub-tech-iit/electronics-boards-public, sensor-boards/ftx2: to some 0.5
// mm); the sensor is that of Jamali et al. 2015, "A New Design of a Fingertip for the iCub Hand". XELA: rows and
// columns of the uSPa 44 and uSPa 46, number of taxels of the curved tip for the Allegro hand (uSCuALHA). Myrmex:
// Schuermann, Koiva, Haschke, Ritter 2011, "A modular high-speed tactile sensor for human manipulation research".
// Barometers: MTL-BaroTactileSensor, 2023, and fits of its recordings (docs/real.md).
// Positions that are not public are computed from the pitch by the generators, and `unverified` lists them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

struct SensorPreset {
  std::string name;        ///< word for command lines
  std::string source;      ///< source of the numbers
  std::string unverified;  ///< numbers that are our own estimates; never empty
  Layout layout;           ///< layout.name is its title; mesh.file is NAME.obj, with its hash
  TriMeshPtr mesh;
};

/// Returns the names of all presets, in the order of lists.
const std::vector<std::string>& sensor_preset_names();

/// Builds a preset and its mesh. Deterministic. Throws Error naming all presets if there is no such preset.
SensorPreset make_sensor_preset(std::string_view name);

/// Returns a layout with the twelve taxels of the paper "Curved Tactile Sensor Simulation with Hydroelastic Contacts in
/// MuJoCo" on our own fingertip (primitives.h): the paper's centres moved to the nearest point of `skin`, with the
/// smooth surface normals there, six on the +x side and their mirror images; radius 6 mm, density 1e7 per square metre.
/// Numbers rounded to 0.1 micrometre and to 1e-6. mesh.file is "../meshes/fingertip.obj", and `mesh_sha256` is the hash
/// of this file.
Layout fingertip_layout(const MeshIndex& skin, const std::string& mesh_sha256 = "");

}  // namespace taxel
