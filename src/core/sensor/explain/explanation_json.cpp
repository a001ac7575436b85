#include "core/sensor/explain/explanation.h"

#include <nlohmann/json.hpp>

#include "core/layout/words.h"

namespace taxel {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson vector_of(const dvec3& v) {
  return OrderedJson::array({v.x, v.y, v.z});
}

OrderedJson exact_object(const ExactReading& exact) {
  OrderedJson json;
  json["value"] = exact.value ? OrderedJson(*exact.value) : OrderedJson(nullptr);
  json["error"] = exact.error;
  if (!exact.value) json["missing"] = exact.missing;
  return json;
}

OrderedJson sample_object(const Explanation& e, std::size_t i) {
  const TaxelSampleReading& s = e.samples[i];
  OrderedJson json{{"sample", s.sample},     {"hit", s.hit},       {"depth", s.depth},
                   {"pressure", s.pressure}, {"weight", s.weight}, {"share", s.share}};
  if (!e.samples_before.empty()) {
    json["hit_before"] = e.samples_before[i].hit;
    json["pressure_before"] = e.samples_before[i].pressure;
  }
  return json;
}

OrderedJson polygon_object(const PolygonBehind& p) {
  return {{"surface", p.surface},
          {"polygon", p.polygon},
          {"area", p.area},
          {"lowest_pressure", p.lowest},
          {"mean_pressure", p.mean},
          {"highest_pressure", p.highest},
          {"force_share", p.force_share},
          {"samples", p.samples},
          {"share", p.share},
          {"exact_share", p.exact_share},
          {"tet", p.tet},
          {"tet_b", p.tet_b},
          {"face", p.face},
          {"inverted", p.inverted},
          {"taxels", p.taxels}};
}

OrderedJson budget_object(const ForceBudget& b) {
  return {{"surfaces", vector_of(b.surfaces_W)},
          {"taxels", vector_of(b.taxels_W)},
          {"taxel", vector_of(b.taxel_W)},
          {"pressed", b.pressed},
          {"covered", b.covered},
          {"uncovered", b.uncovered},
          {"net", vector_of(b.net_W)}};
}

OrderedJson verdict_object(const Verdict& v) {
  OrderedJson json{{"cause", to_word(v.cause)}, {"text", v.text},
                   {"change", v.change},        {"noise", v.noise},
                   {"field", v.field},          {"cone", v.cone},
                   {"edges", v.edges},          {"contact", v.contact},
                   {"limit", v.limit},          {"force_stays", v.force_stays}};
  if (v.needed)
    json["samples_needed"] = {{"samples", v.needed->samples},
                              {"factor", v.needed->factor},
                              {"change", v.needed->change},
                              {"cures", v.needed->cures}};
  if (v.voronoi_change) json["voronoi_change"] = *v.voronoi_change;
  if (v.wider)
    json["wider"] = {{"angle_deg", v.wider->angle_deg}, {"change", v.wider->change}, {"cures", v.wider->cures}};
  if (v.worst) {
    json["worst"] = {{"time", v.worst->time}, {"change", v.worst->change}};
    if (v.worst->needed)
      json["worst"]["factor"] = v.worst->needed->factor, json["worst"]["cures"] = v.worst->needed->cures;
  }
  json["crossed_edges"] = OrderedJson::array();
  for (const CrossedEdge& e : v.crossed)
    json["crossed_edges"].push_back(
        {{"faces", e.faces}, {"bend_deg", e.bend_deg}, {"distance", e.distance}, {"force", e.force}});
  if (v.cause == Cause::mesh_edges) {
    json["tried"] = OrderedJson::array();
    for (const SettingTried& s : v.tried)
      json["tried"].push_back({{"setting", s.text}, {"change", s.change}, {"cures", s.cures}});
  }
  return json;
}

OrderedJson change_object(const StepChange& c) {
  const auto samples = [](const SampleChange& s) { return OrderedJson{{"count", s.count}, {"change", s.change}}; };
  return {{"time_before", c.time_before},   {"before", c.reading.before}, {"now", c.reading.now},
          {"force_before", c.force.before}, {"force_now", c.force.now},   {"began", samples(c.began)},
          {"ceased", samples(c.ceased)},    {"stayed", samples(c.stayed)}};
}

}  // namespace

std::string explanation_to_json(const Explanation& e) {
  OrderedJson json;
  json["taxel"] = {{"id", e.id}, {"name", e.name}};
  json["time"] = e.time;
  json["aggregate"] = to_word(e.aggregate);
  json["unit"] = reading_unit(e.aggregate);
  json["reading"] = e.reading;
  json["verdict"] = e.change ? verdict_object(e.change->verdict) : OrderedJson(nullptr);
  json["change"] = e.change ? change_object(*e.change) : OrderedJson(nullptr);
  json["exact"] = exact_object(e.exact);
  json["exact_before"] = e.exact_before ? exact_object(*e.exact_before) : OrderedJson(nullptr);
  json["convergence"] = nullptr;
  if (e.levels) {
    json["convergence"] = {
        {"factors", Convergence::kFactors}, {"samples", e.levels->samples}, {"values", e.levels->now}};
    if (e.change) json["convergence"]["values_before"] = e.levels->before;
  } else {
    json["no_convergence"] = e.no_levels;
  }
  json["budget"] = budget_object(e.budget);
  json["samples_at_back_faces"] = e.samples_at_back_faces;
  json["polygons"] = OrderedJson::array();
  for (const PolygonBehind& p : e.polygons) json["polygons"].push_back(polygon_object(p));
  json["samples"] = OrderedJson::array();
  for (std::size_t i = 0; i < e.samples.size(); ++i) json["samples"].push_back(sample_object(e, i));
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace taxel
