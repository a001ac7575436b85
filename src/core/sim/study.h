// Runs of a study: a scenario many times, several runs in parallel, and their batch.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/document/scenario/study.h"
#include "core/run/batch/batch_index.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Returns the sensor model of a run, or null to leave the run out. Called for one run after the other.
using StudyModel = std::function<SensorModelPtr(std::size_t run)>;
/// Receives each step of a run, on the thread of the run. Returns false to end the run; throws Error to fail it.
using StudyStep = std::function<bool(std::size_t run, const Simulator& simulator)>;
/// Receives the end of a run, on the thread of the run: why it failed, or an empty text.
using StudyEnd = std::function<void(std::size_t run, const std::string& error)>;

/// Makes the simulators one after the other, because MuJoCo's compiler must not run twice at the same time, and steps
/// them in parallel, as many as there are cores. A run that cannot be made or fails does not stop the others. The
/// results of a run depend on nothing else, so the number of threads changes no result. Throws the errors of `model`,
/// and Cancelled through `progress`.
void run_study(const std::vector<StudyRun>& runs, const StudyModel& model, const StudyStep& on_step,
               const StudyEnd& on_end, Progress& progress);

/// A study, and the folder of its batch.
struct StudyToSave {
  Study study;
  SensorModelPtr model;  ///< model of the studied layout
  std::filesystem::path folder;
  std::string program;  ///< versions of the program and of MuJoCo
};

/// Makes the runs of a study again, as `taxel batch` does, and writes their batch with numbers of 64 bits. The runs
/// are equal to those of run_study() bit for bit. Throws Error naming the folder or a file: the folder has something
/// else, or a file cannot be written; throws Cancelled, after which the same call continues.
BatchCounts save_study(const StudyToSave& what, Progress& progress);

}  // namespace taxel
