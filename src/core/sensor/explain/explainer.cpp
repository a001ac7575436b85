#include "core/sensor/explain/explainer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/hydro/traction.h"
#include "core/sensor/explain/counterfactual.h"
#include "core/sensor/explain/explanation.h"
#include "core/sensor/readout/aggregate.h"
#include "core/sensor/readout/reading.h"
#include "core/sensor/reference/force_integral.h"

namespace taxel {

namespace {

PolygonBehind describe(const InvertedTets& inverted, const ContactSurface& surface, int s, int p) {
  const ContactPolygon& polygon = surface.polygons[at(p)];
  PolygonBehind row;
  row.surface = s, row.polygon = p;
  row.tet = polygon.tet, row.tet_b = polygon.tet_b, row.face = polygon.face;
  row.inverted = inverted.concern(polygon);
  row.area = polygon.area;
  row.mean = polygon.pressure;  // the mean of a linear pressure is its value at the centroid
  row.lowest = std::numeric_limits<double>::infinity();
  for (int i = polygon.first; i < polygon.first + polygon.count; ++i) {
    row.lowest = std::min(row.lowest, surface.pressure[at(i)]);
    row.highest = std::max(row.highest, surface.pressure[at(i)]);
  }
  return row;
}

void add_served(const SensorModel& model, const std::vector<RayHit>& hits, const std::vector<std::size_t>& first,
                std::vector<PolygonBehind>& rows) {
  for (int k = 0; k < model.taxel_count(); ++k) {
    const int id = model.layout.taxels[at(k)].id;
    for (int e = model.fields.first[at(k)]; e < model.fields.first[at(k) + 1]; ++e) {
      const RayHit& hit = hits[at(model.readout_table.ray_of_entry[at(e)])];
      if (!hit.hit()) continue;
      std::vector<int>& taxels = rows[first[at(hit.surface)] + at(hit.polygon)].taxels;
      if (taxels.empty() || taxels.back() != id) taxels.push_back(id);
    }
  }
  for (PolygonBehind& row : rows) {
    std::sort(row.taxels.begin(), row.taxels.end());
    row.taxels.erase(std::unique(row.taxels.begin(), row.taxels.end()), row.taxels.end());
  }
}

/// Returns the polygons of all surfaces, in their order. `behind` are the taxel's samples in that step, `exact` is the
/// taxel's exact reading.
std::vector<PolygonBehind> polygons_behind(const SensorModel& model, int taxel, const SensorStep& step,
                                           const std::vector<TaxelSampleReading>& behind, const ExactReading& exact,
                                           const InvertedTets& inverted) {
  std::vector<PolygonBehind> rows;
  std::vector<std::size_t> first;  // row of each surface's first polygon
  double pressed = 0;
  for (std::size_t s = 0; s < step.surfaces.size(); ++s) {
    first.push_back(rows.size());
    for (std::size_t p = 0; p < step.surfaces[s].polygons.size(); ++p) {
      rows.push_back(describe(inverted, step.surfaces[s], static_cast<int>(s), static_cast<int>(p)));
      pressed += rows.back().area * rows.back().mean;
    }
  }
  for (PolygonBehind& row : rows) row.force_share = pressed > 0 ? row.area * row.mean / pressed : 0.0;
  const int begin = model.fields.first[at(taxel)];
  for (std::size_t i = 0; i < behind.size(); ++i) {
    const RayHit& hit = step.hits[at(model.readout_table.ray_of_entry[at(begin) + i])];
    if (!hit.hit()) continue;
    PolygonBehind& row = rows[first[at(hit.surface)] + at(hit.polygon)];
    ++row.samples;
    row.share += behind[i].share;
  }
  if (exact.value && *exact.value > 0)
    for (const PolygonPart& part : exact.parts)
      rows[first[at(part.surface)] + at(part.polygon)].exact_share = part.value / *exact.value;
  add_served(model, step.hits, first, rows);
  return rows;
}

dvec3 elastic_force_W(const SensorStep& step) {
  dvec3 force(0);
  for (const ContactSurface& surface : step.surfaces) force += step.X_WM.rotate(pressure_wrench(surface).force);
  return force;
}

ForceBudget budget_of(const SensorModel& model, int taxel, const SensorStep& step) {
  ForceBudget budget;
  budget.surfaces_W = elastic_force_W(step);
  for (const ContactSurface& surface : step.surfaces)
    for (const ContactPolygon& p : surface.polygons) budget.pressed += p.area * p.pressure;
  ForceIntegral integral;
  ForceReading force;
  integral.integrate(model, *skin_fields_for(model, IntegralKind::force), surface_pointers(step), {}, force);
  dvec3 sum(0);
  for (const dvec3& f : force.normal) sum += f;
  budget.taxels_W = step.X_WM.rotate(sum);
  budget.taxel_W = step.X_WM.rotate(force.normal[at(taxel)]);
  budget.covered = force.covered;
  budget.uncovered = std::max(0.0, force.uncovered);  // rounding may make it negative
  budget.net_W = step.force_W;
  return budget;
}

/// Adds up the change of a reading by the samples that began, ceased or continued to hit.
void count_samples(const Explanation& e, StepChange& change) {
  for (std::size_t i = 0; i < e.samples.size(); ++i) {
    const TaxelSampleReading &now = e.samples[i], &before = e.samples_before[i];
    if (!now.hit && !before.hit) continue;
    SampleChange& kind = !before.hit ? change.began : !now.hit ? change.ceased : change.stayed;
    ++kind.count;
    kind.change += now.share * change.reading.now - before.share * change.reading.before;
  }
}

/// Returns the part of an exact reading on polygons of inverted tets.
double inverted_part(const ExactReading& exact, const SensorStep& step, const InvertedTets& inverted) {
  double sum = 0;
  for (const PolygonPart& part : exact.parts)
    if (inverted.concern(step.surfaces[at(part.surface)].polygons[at(part.polygon)])) sum += part.value;
  return sum;
}

bool is_soft_contact(const SensorStep& step) {
  return std::any_of(step.surfaces.begin(), step.surfaces.end(), between_soft_bodies);
}

}  // namespace

struct Explainer::Kept {
  SensorCache cache;
  SensorModelPtr model;
  std::optional<ConvergenceModels> levels;
  std::string no_levels;
  DenserModels denser;
  InvertedTets inverted;

  /// Builds the models with other numbers of samples, as far as that is possible.
  void keep(const SensorModelPtr& wanted, Progress* progress) {
    if (wanted == model) return;
    levels.reset();
    no_levels.clear();
    denser.clear();
    inverted = InvertedTets(*wanted);
    try {
      levels = make_convergence_models(wanted, cache, progress);
      denser[Convergence::kFactors.back()] = levels->back();
    } catch (const Error& e) {
      no_levels = e.what();
    }
    model = wanted;
  }
  void read_levels(int taxel, const SensorStep& now, const SensorStep* before, Explanation& out) const {
    if (!levels) {
      out.no_levels = no_levels;
      return;
    }
    const auto read = [&](const SensorStep& step, std::array<double, 3>& values, std::array<int, 3>& samples) {
      const Convergence found = read_convergence(*levels, surface_pointers(step));
      samples = found.samples;
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = found.values[i][at(taxel)];
        if (aggregate_spec(out.aggregate).grows_with_samples && samples[i] > 0)
          values[i] *= static_cast<double>(samples[Convergence::kAsked]) / samples[i];
      }
    };
    SampleLevels& of_taxel = out.levels.emplace();
    read(now, of_taxel.now, of_taxel.samples);
    if (before != nullptr) read(*before, of_taxel.before, of_taxel.samples);
  }
  void add_even(int taxel, const SensorStep& now, const SensorStep& before, const Explanation& out,
                VerdictInput& in) const;
  void add_smooth(int taxel, const SensorStep& now, const SensorStep& before, bool crossed, VerdictInput& in) const;
  void judge(int taxel, const SensorStep& now, const SensorStep& before, const ExplainLimits& limits,
             const StepPair& worst, Explanation& out, Progress* progress);
  void advise_on_worst(int taxel, const StepPair& worst, Verdict& verdict, Progress* progress);
};

/// Tries the remedies for the explained change on the worst change of the run. More samples are tried too if the
/// explained change is no jump.
void Explainer::Kept::advise_on_worst(int taxel, const StepPair& worst, Verdict& verdict, Progress* progress) {
  if (worst.before == nullptr || worst.now == nullptr || worst.now->model != model) return;
  const double change = worst.now->readings[at(taxel)] - worst.before->readings[at(taxel)];
  if (!(std::abs(change) > std::max(std::abs(verdict.change), verdict.limit))) return;
  WorstChange& found = verdict.worst.emplace();
  found.time = worst.now->time;
  found.change = change;
  if (verdict.cause == Cause::sampling_noise || verdict.cause == Cause::none)
    found.needed = samples_that_cure(model, taxel, *worst.before, *worst.now, verdict.limit, denser, cache, progress);
  if (verdict.cause == Cause::cone)
    found.wider = angle_that_cures(model, taxel, *worst.before, *worst.now, verdict.limit, cache, progress);
}

/// Adds the readings of both contacts under uniform stiffness, and the parts on polygons of inverted tets.
void Explainer::Kept::add_even(int taxel, const SensorStep& now, const SensorStep& before, const Explanation& out,
                               VerdictInput& in) const {
  const ExactReading was = exact_reading(*model, taxel, with_even_stiffness(*model, surface_pointers(before)).pointers);
  const ExactReading is = exact_reading(*model, taxel, with_even_stiffness(*model, surface_pointers(now)).pointers);
  if (!was.value || !is.value) return;
  in.even = {*was.value, *is.value};
  in.even_inverted = {inverted_part(was, before, inverted), inverted_part(is, now, inverted)};
  in.exact_inverted = {inverted_part(*out.exact_before, before, inverted), inverted_part(out.exact, now, inverted)};
}

/// Adds the readings of both contacts with interpolated normals if edges of the mesh were crossed, and those without
/// the angle limit of the fields unless the limit cuts nothing.
void Explainer::Kept::add_smooth(int taxel, const SensorStep& now, const SensorStep& before, bool crossed,
                                 VerdictInput& in) const {
  ExactOptions how;
  if (crossed) how.rays = FieldNormals::interpolated;
  const auto read = [&](const SensorModel& other) -> std::optional<Readings> {
    const ExactReading was = exact_reading(other, taxel, surface_pointers(before), how);
    const ExactReading is = exact_reading(other, taxel, surface_pointers(now), how);
    if (!was.value || !is.value) return std::nullopt;
    return Readings{*was.value, *is.value};
  };
  if (crossed) in.smooth = read(with_interpolated_angles(*model));
  if (model->layout.receptive_field.max_angle_deg < kTriedAngles.back()) in.uncut = read(without_angle_limit(*model));
}

/// Decides by the readings of the same two contacts with other samples, under uniform stiffness, with interpolated
/// normals and without the limit of the angle.
void Explainer::Kept::judge(int taxel, const SensorStep& now, const SensorStep& before, const ExplainLimits& limits,
                            const StepPair& worst, Explanation& out, Progress* progress) {
  StepChange& change = *out.change;
  VerdictInput in;
  in.limits = limits, in.sampled = change.reading, in.force = change.force;
  if (out.exact.value && out.exact_before->value) in.exact = {*out.exact_before->value, *out.exact.value};
  if (in.exact && field_is_suspect(*model)) {
    in.soft_contact = is_soft_contact(now) || is_soft_contact(before);
    if (!in.soft_contact) add_even(taxel, now, before, out, in);
  }
  std::vector<CrossedEdge> crossed = crossed_edges(taxel, before, now);
  if (in.exact) add_smooth(taxel, now, before, !crossed.empty(), in);
  Verdict& verdict = change.verdict;
  verdict = decide(in);
  verdict.crossed = std::move(crossed);
  if (verdict.cause == Cause::mesh_edges)
    verdict.tried = settings_against_edges(model, taxel, before, now, verdict.limit, cache, progress);
  if (verdict.cause == Cause::cone)
    verdict.wider = angle_that_cures(model, taxel, before, now, verdict.limit, cache, progress);
  if (verdict.cause == Cause::sampling_noise) {
    verdict.needed = samples_that_cure(model, taxel, before, now, verdict.limit, denser, cache, progress);
    if (model->layout.sampling.weights == SampleWeights::equal)
      verdict.voronoi_change = change_with_voronoi_weights(*model, taxel, before, now);
  }
  if (is_partly_noise(verdict, in)) {
    const double half = (std::abs(verdict.change) - 0.5 * std::abs(verdict.noise)) / kCureMargin;
    verdict.needed = samples_that_cure(model, taxel, before, now, half, denser, cache, progress);
  }
  advise_on_worst(taxel, worst, verdict, progress);
  verdict.text = verdict_text(verdict, in);
}

Explainer::Explainer() : kept_(std::make_unique<Kept>()) {}
Explainer::~Explainer() = default;

Explanation Explainer::explain(int taxel, const SensorStep& now, const SensorStep* before, const ExplainLimits& limits,
                               Progress* progress, const StepPair& worst) {
  const SensorModelPtr& model = now.model;
  Explanation out;
  out.samples = samples_behind(*model, now.hits, taxel);
  const Taxel& of = model->layout.taxels[at(taxel)];
  out.taxel = taxel, out.id = of.id, out.name = of.name;
  out.aggregate = model->layout.readout.aggregate;
  out.time = now.time, out.reading = now.readings[at(taxel)];
  kept_->keep(model, progress);
  kept_->read_levels(taxel, now, before, out);
  if (progress != nullptr) progress->check(0.5);
  out.exact = exact_reading(*model, taxel, surface_pointers(now));
  out.polygons = polygons_behind(*model, taxel, now, out.samples, out.exact, kept_->inverted);
  out.budget = budget_of(*model, taxel, now);
  out.samples_at_back_faces = count_samples_at_back_faces(*model, taxel, now);
  if (before == nullptr) return out;
  out.samples_before = samples_behind(*model, before->hits, taxel);
  out.exact_before = exact_reading(*model, taxel, surface_pointers(*before));
  StepChange& change = out.change.emplace();
  change.time_before = before->time;
  change.reading = {before->readings[at(taxel)], out.reading};
  change.force = {glm::length(before->force_W), glm::length(now.force_W)};
  count_samples(out, change);
  kept_->judge(taxel, now, *before, limits, worst, out, progress);
  return out;
}

}  // namespace taxel
