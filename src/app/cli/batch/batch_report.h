// The result of a batch, as `taxel batch` prints it.
#pragma once

#include <string>

#include "app/cli/report_writer.h"
#include "core/sim/batch/run_batch.h"

namespace taxel::cli {

struct BatchReport {
  const JobList& list;
  const BatchResult& result;
  std::string folder;
  double wall = 0;  ///< wall time of this run [s]

  [[nodiscard]] std::size_t failed() const { return result.counts.failed.size(); }

  void visit(ReportWriter& w) const;
  [[nodiscard]] std::string text() const;
};

}  // namespace taxel::cli
