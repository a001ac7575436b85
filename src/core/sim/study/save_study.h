// Writes a parameter study as a data set.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/document/scenario/study.h"
#include "core/run/batch/data_set.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// A study, and the folder of its data set.
struct StudyToSave {
  Study study;
  SensorModelPtr model;  ///< model of the studied layout
  std::filesystem::path folder;
  std::string program;  ///< versions of the program and of MuJoCo
};

/// Makes the runs of a study again, as `taxel batch` does, and writes their data set with numbers of 64 bits. The runs
/// are equal to those of run_study() bit for bit. Throws Error naming the folder or a file: the folder has something
/// else, or a file cannot be written; throws Cancelled, after which the same call continues.
DataSetCounts save_study(const StudyToSave& what, Progress& progress);

}  // namespace taxel
