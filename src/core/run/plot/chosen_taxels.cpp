#include "core/run/plot/chosen_taxels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/run/recording/summary.h"

namespace taxel {
namespace {

bool has_several_sensors(const PlottedRun& run) {
  return std::count_if(run.sensors.begin(), run.sensors.end(),
                       [](const PlottedSensor& sensor) { return !sensor.taxel_ids.empty(); }) > 1;
}

std::string taxel_word(const PlottedRun& run, const PlottedTaxel& taxel) {
  const PlottedSensor& sensor = run.sensors[taxel.sensor];
  return (has_several_sensors(run) ? sensor.geom + "/" : "") + std::to_string(sensor.taxel_ids[taxel.taxel]);
}

std::string label_of(const PlottedRun& run, const PlottedTaxel& taxel, bool has_names) {
  const std::string& name = run.sensors[taxel.sensor].taxel_names[taxel.taxel];
  const std::string word = taxel_word(run, taxel);
  if (!has_names || has_several_sensors(run)) return has_names && !name.empty() ? word + " " + name : word;
  return name.empty() ? "taxel " + word : word + " " + name;
}

/// Returns true if a user's word is the id of a taxel, with its sensor or without, or its name.
bool is_named(const PlottedRun& run, const PlottedTaxel& taxel, const std::string& word) {
  const PlottedSensor& sensor = run.sensors[taxel.sensor];
  const std::string id = std::to_string(sensor.taxel_ids[taxel.taxel]), name = sensor.taxel_names[taxel.taxel];
  const bool is_own = word == id || (!name.empty() && word == name);
  return is_own || word == sensor.geom + "/" + id || (!name.empty() && word == sensor.geom + "/" + name);
}

std::vector<PlottedTaxel> named_taxels(const PlottedRun& run, const std::vector<std::string>& words,
                                       const std::vector<PlottedTaxel>& all) {
  std::vector<bool> is_chosen(all.size(), false);
  for (const std::string& word : words) {
    bool is_known = false;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (is_named(run, all[i], word)) is_chosen[i] = is_known = true;
    if (is_known) continue;
    std::string known;
    for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 12); ++i)
      known += (i == 0 ? "" : ", ") + taxel_word(run, all[i]);
    throw Error(run.file, fmt::format("has no taxel \"{}\"; its taxels are {}{}", word, known,
                                      all.size() > 12 ? fmt::format(" and {} more", all.size() - 12) : ""));
  }
  std::vector<PlottedTaxel> chosen;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (is_chosen[i]) chosen.push_back(all[i]);
  return chosen;
}

}  // namespace

std::vector<std::size_t> chosen_sensors(const PlottedRun& run, const RunChartOptions& options) {
  std::vector<std::size_t> sensors;
  std::string names;
  for (std::size_t i = 0; i < run.sensors.size(); ++i) {
    if (run.sensors[i].taxel_ids.empty()) continue;
    names += (names.empty() ? "" : ", ") + run.sensors[i].geom;
    if (options.sensor.empty() || run.sensors[i].geom == options.sensor) sensors.push_back(i);
  }
  if (names.empty() && sensors.empty()) throw Error(run.file, "has no sensor with taxels");
  if (sensors.empty()) throw Error(run.file, fmt::format("has no sensor \"{}\", but {}", options.sensor, names));
  return sensors;
}

std::vector<PlottedTaxel> taxels_of(const PlottedRun& run, const RunChartOptions& options, bool has_names) {
  std::vector<PlottedTaxel> taxels;
  for (const std::size_t s : chosen_sensors(run, options))
    for (std::size_t t = 0; t < run.sensors[s].taxel_ids.size(); ++t) {
      PlottedTaxel taxel{s, t, "", 0, 0};
      taxel.label = label_of(run, taxel, has_names);
      const std::vector<double>& readings = run.sensors[s].readings[t];
      for (std::size_t row = 0; row < readings.size(); ++row)
        if (std::abs(readings[row]) > std::abs(taxel.peak)) taxel.peak = readings[row], taxel.peak_row = row;
      taxels.push_back(taxel);
    }
  return taxels;
}

std::vector<PlottedTaxel> chosen_taxels(const PlottedRun& run, const RunChartOptions& options,
                                        const std::vector<PlottedTaxel>& all, const std::vector<double>& peaks) {
  if (!options.taxels.empty()) return named_taxels(run, options.taxels, all);
  if (options.has_all_taxels) return all;
  std::map<std::string, double> largest;
  for (std::size_t i = 0; i < all.size(); ++i) {
    double& value = largest[run.sensors[all[i].sensor].unit];
    value = std::max(value, std::abs(peaks[i]));
  }
  std::vector<PlottedTaxel> chosen;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::abs(peaks[i]) > kResponds * largest[run.sensors[all[i].sensor].unit]) chosen.push_back(all[i]);
  return chosen;
}

}  // namespace taxel
