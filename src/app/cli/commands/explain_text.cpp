#include "app/cli/commands/explain_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/text/message.h"
#include "core/layout/words.h"
#include "core/sensor/explain/explanation.h"

namespace taxel::cli {
namespace {

std::string vector_text(const dvec3& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}

std::string change_text(const Explanation& e) {
  if (!e.change) return "There is no previous row to compare with.\n";
  const StepChange& c = *e.change;
  const Verdict& v = c.verdict;
  std::string text = v.text + "\n";
  text += fmt::format(
      "\nchange since {:.6g} s: {:+.6g} {}, of it samples {:+.6g}, field {:+.6g}, cone {:+.6g}, mesh edges {:+.6g}, "
      "contact {:+.6g}; limit "
      "{:.6g}\n",
      c.time_before, v.change, reading_unit(e.aggregate), v.noise, v.field, v.cone, v.edges, v.contact, v.limit);
  text += fmt::format("{:>16} {:>8} {:>14}\n", "samples that", "count", "change");
  for (const auto& [what, part] :
       {std::pair("began to hit", &c.began), {"ceased to hit", &c.ceased}, {"stayed", &c.stayed}})
    text += fmt::format("{:>16} {:>8} {:>+14.6g}\n", what, part->count, part->change);
  return text;
}

std::string value_text(const ExactReading& exact) {
  return exact.value ? fmt::format("{:.6g} (+-{:.2g})", *exact.value, exact.error) : exact.missing;
}

std::string levels_text(const Explanation& e) {
  if (!e.levels) return fmt::format("\nno other numbers of samples: {}\n", e.no_levels);
  std::string text = fmt::format("\n{:>10} {:>14} {:>14}\n", "samples", "now", "before");
  for (std::size_t i = 0; i < e.levels->samples.size(); ++i) {
    text += fmt::format("{:>10} {:>14.6g}", e.levels->samples[i], e.levels->now[i]);
    text += e.change ? fmt::format(" {:>14.6g}\n", e.levels->before[i]) : "\n";
  }
  return text;
}

std::string budget_text(const ForceBudget& b) {
  std::string text = "\nforce on the sensor, world [N]\n";
  text += fmt::format("{:>16} {}\n", "surfaces", vector_text(b.surfaces_W));
  text += fmt::format("{:>16} {}\n", "taxels", vector_text(b.taxels_W));
  text += fmt::format("{:>16} {}\n", "this taxel", vector_text(b.taxel_W));
  text += fmt::format("{:>16} {}\n", "as simulated", vector_text(b.net_W));
  text += fmt::format("normal force {:.6g} N, of it inside fields {:.6g} N, outside fields {:.6g} N\n", b.pressed,
                      b.covered, b.uncovered);
  return text;
}

std::string polygons_text(const Explanation& e) {
  std::vector<const PolygonBehind*> rows;
  for (const PolygonBehind& p : e.polygons)
    if (p.samples > 0 || p.exact_share > 0) rows.push_back(&p);
  std::stable_sort(rows.begin(), rows.end(), [](auto* a, auto* b) {
    return std::pair(a->share, a->exact_share) > std::pair(b->share, b->exact_share);
  });
  std::string text = fmt::format("\n{} of {} polygons in its field\n", rows.size(), e.polygons.size());
  text +=
      fmt::format("{:>8} {:>8} {:>8} {:>8} {:>10} {:>10} {:>10} {:>10} {:>8} {:>8}  {}\n", "polygon", "share %",
                  "exact %", "force %", "area mm^2", "lowest Pa", "mean Pa", "highest Pa", "samples", "tet", "taxels");
  for (const PolygonBehind* p : rows)
    text += fmt::format("{:>8} {:>8.3g} {:>8.3g} {:>8.3g} {:>10.4g} {:>10.5g} {:>10.5g} {:>10.5g} {:>8} {:>8}  {}{}\n",
                        fmt::format("{}/{}", p->surface, p->polygon), 100 * p->share, 100 * p->exact_share,
                        100 * p->force_share, 1e6 * p->area, p->lowest, p->mean, p->highest, p->samples, p->tet,
                        fmt::join(p->taxels, " "), p->inverted ? " inverted" : "");
  return text;
}

std::string samples_text(const Explanation& e) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < e.samples.size(); ++i)
    if (e.samples[i].hit || (!e.samples_before.empty() && e.samples_before[i].hit)) rows.push_back(i);
  std::stable_sort(rows.begin(), rows.end(),
                   [&](std::size_t a, std::size_t b) { return e.samples[a].share > e.samples[b].share; });
  std::string text = fmt::format("\n{} of {} samples hit, now or before\n", rows.size(), e.samples.size());
  text += fmt::format("{:>8} {:>8} {:>10} {:>12} {:>12} {:>12}\n", "sample", "share %", "depth mm", "pressure Pa",
                      "before Pa", "weight mm^2");
  for (const std::size_t i : rows) {
    const TaxelSampleReading& s = e.samples[i];
    const std::string before = e.samples_before.empty() ? "" : fmt::format("{:.5g}", e.samples_before[i].pressure);
    text += fmt::format("{:>8} {:>8.3g} {:>10.4g} {:>12.5g} {:>12} {:>12.4g}\n", s.sample, 100 * s.share, 1e3 * s.depth,
                        s.pressure, before, 1e6 * s.weight);
  }
  return text;
}

}  // namespace

std::string explain_text(const Explanation& e) {
  std::string text = change_text(e);
  const std::string name = e.name.empty() ? "" : fmt::format(" ({})", e.name);
  text += fmt::format("\ntaxel {}{} at {:.6g} s, {} [{}]\n", e.id, name, e.time, to_word(e.aggregate),
                      reading_unit(e.aggregate));
  constexpr int kDigits = 6;
  const NumberPair readings = number_pair(e.reading, e.change ? e.change->reading.before : e.reading, kDigits);
  text += fmt::format("{:>16} {}", "reading", readings.first);
  text += e.change ? fmt::format(", before {}\n", readings.second) : "\n";
  text += fmt::format("{:>16} {}", "exact integral", value_text(e.exact));
  text += e.exact_before ? fmt::format(", before {}\n", value_text(*e.exact_before)) : "\n";
  if (const std::string back = back_faces_text(e); !back.empty()) text += "\n" + back + "\n";
  return text + levels_text(e) + budget_text(e.budget) + polygons_text(e) + samples_text(e);
}

}  // namespace taxel::cli
