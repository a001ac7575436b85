// The samples of a sensor and its receptive fields as tables.
#pragma once

#include <string>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// `x,y,z,nx,ny,nz,face,area,id,used`: position [m] and normal in frame M, triangle of the mesh file from 0 (-1 on
/// faces that a repair filled in, the nearest one on a wrapped surface), area of the skin per sample [m^2], number,
/// 1 where a taxel uses it. `file_face_of`: for each face of the model's loaded mesh its number in the file
/// (LoadedMesh).
std::string samples_to_csv(const SensorModel& model, const std::vector<int>& file_face_of);

/// `sample,taxel,distance,weight`: number of the sample, id of the taxel, distance [m], weight [m^2].
std::string fields_to_csv(const SensorModel& model);

}  // namespace taxel
