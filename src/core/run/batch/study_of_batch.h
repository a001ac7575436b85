// Parameter studies as batches: a study is one line of a list of jobs, and its batch is read as a study again.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/document/scenario/study.h"

namespace taxel {

/// Returns the line of a list of jobs that gives the runs of a study of the default layout (core/document/batch).
std::string job_line_of(const Study& study);

/// Reads a batch as the runs of a study. One or two numbers vary: numbers of the scenario, or density and seed of the
/// samples. If one or two numbers are changed, they need not vary. Each combination of their values has one episode or
/// one failed job. The values are in ascending order. Throws Error naming the folder, the parameter and the remedy if
/// the batch is no study, and the errors of read_batch_index() and Shard; throws Cancelled.
StudyCurves read_study_of_batch(const std::filesystem::path& folder, Progress& progress);

}  // namespace taxel
