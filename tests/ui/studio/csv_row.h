// A row of a table that the command line wrote.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace taxel::test {

/// Returns the row of a CSV file whose value in `key`, a column, is nearest to `value`, by the names of its columns.
inline std::map<std::string, double> csv_row(const std::filesystem::path& file, double value,
                                             const std::string& key = "time") {
  std::ifstream in(file);
  std::string line, cell;
  std::getline(in, line);
  std::vector<std::string> names;
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
  std::map<std::string, double> best;
  while (std::getline(in, line)) {
    std::map<std::string, double> row;
    std::istringstream cells(line);
    for (const std::string& name : names)
      if (std::getline(cells, cell, ',')) row[name] = cell.empty() ? std::nan("") : std::stod(cell);
    if (best.empty() || std::abs(row[key] - value) < std::abs(best[key] - value)) best = row;
  }
  return best;
}

}  // namespace taxel::test
