// The samples of a sensor and its receptive fields as tables.
#pragma once

#include <string>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// Returns a table with the columns `x,y,z,nx,ny,nz,face,area,id,used`: position [m] and normal in frame M, index of
/// the triangle in the mesh file (-1 on faces that a repair filled in, the nearest triangle on a wrapped surface), area
/// of the skin per sample [m^2], index of the sample, and 1 if a taxel uses the sample. `file_face_of` is
/// LoadedMesh::file_face_of of the model's loaded mesh.
std::string samples_to_csv(const SensorModel& model, const std::vector<int>& file_face_of);

/// Returns a table with the columns `sample,taxel,distance,weight`: index of the sample, id of the taxel, distance [m],
/// weight [m^2].
std::string fields_to_csv(const SensorModel& model);

}  // namespace taxel
