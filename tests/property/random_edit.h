// Edits of every kind from a few random numbers. Most of the edits are possible.
#pragma once

#include <algorithm>

#include "core/base/rng.h"
#include "core/document/edit.h"

namespace taxel {

/// Seed of an edit. RapidCheck draws and shrinks it.
struct EditSeed {
  unsigned kind = 0;
  std::uint64_t seed = 0;
};

class RandomEdit {
 public:
  RandomEdit(const Project& project, const EditSeed& from)
      : project_(project), layout_(project.layout), rng_(from.seed), kind_(from.kind) {}

  Edit make() {
    switch (kind_ % 20) {
      case 0:
      case 1:
        return add();
      case 2:
        return remove();
      case 3:
      case 4:
      case 5:
        return set();
      case 6:
        return renumber();
      case 7: {
        std::vector<int> ids = all_ids();
        for (std::size_t i = ids.size(); i > 1; --i) std::swap(ids[i - 1], ids[below(i)]);
        return ReorderTaxels{ids};
      }
      case 8:
        return MirrorTaxels{some_ids(), plane(), 1e-6};
      case 9: {
        const std::vector<int> ids = some_ids();
        if (ids.size() < 2) return UnlinkTaxels{ids};
        return LinkTaxels{{{ids[0], ids[1]}}, plane()};
      }
      case 10:
        return UnlinkTaxels{some_ids()};
      case 11:
        return SetHidden{some_ids()};
      default:
        return settings();
    }
  }

 private:
  double uniform() { return rng_.uniform(next_++); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(uniform() * static_cast<double>(n)); }
  dvec3 point() { return dvec3(uniform(), uniform(), uniform()) * 0.02 - 0.01; }
  /// Returns one of three planes, so that a taxel has several mirror planes. Two of the planes are not at right angles.
  MirrorPlane plane() {
    const MirrorPlane planes[] = {{dvec3(0), {1, 0, 0}}, {dvec3(0, 1e-3, 0), {0, 2, 0}}, {dvec3(0), {0.6, 0.3, -0.2}}};
    return planes[below(3)];
  }
  std::vector<int> all_ids() const {
    std::vector<int> ids;
    for (const Taxel& taxel : layout_.taxels) ids.push_back(taxel.id);
    return ids;
  }
  std::vector<int> some_ids() {
    std::vector<int> ids = all_ids();
    std::erase_if(ids, [&](int) { return uniform() < 0.6; });
    return ids;
  }
  std::vector<Subtaxel> subtaxels() {
    std::vector<Subtaxel> made(below(3));
    for (Subtaxel& s : made) s = {point(), point(), 1e-3 + uniform() * 1e-3};
    return made;
  }
  Edit add() {
    AddTaxels edit;
    for (const int id : unused_ids(layout_, 1 + below(3)))
      edit.taxels.push_back(
          {id, uniform() < 0.5 ? "left" : "", point(), point(), 0.001 + 0.01 * uniform(), subtaxels()});
    if (!layout_.taxels.empty() && uniform() < 0.5) edit.before = layout_.taxels[below(layout_.taxels.size())].id;
    return edit;
  }
  Edit remove() {
    DeleteTaxels edit;
    for (const int id : some_ids())
      if (edit.ids.size() < 2) edit.ids.push_back(id);
    return edit;
  }
  Edit set() {
    SetTaxels edit;
    for (const int id : some_ids()) {
      TaxelChange& change = edit.changes.emplace_back();
      change.id = id;
      if (uniform() < 0.5) change.center = point();
      if (uniform() < 0.3) change.normal = point();
      if (uniform() < 0.3) change.radius = 0.001 + 0.01 * uniform();
      if (uniform() < 0.3) change.name = "name " + std::to_string(below(5));
      if (uniform() < 0.1) change.subtaxels = subtaxels();
    }
    edit.twins_follow = uniform() < 0.8;
    return edit;
  }
  Edit renumber() {
    RenumberTaxels edit;
    std::vector<int> from = some_ids(), to = from;
    if (!to.empty()) std::rotate(to.begin(), to.begin() + 1, to.end());
    for (std::size_t i = 0; i < from.size(); ++i) edit.ids.emplace_back(from[i], to[i]);
    if (from.size() == 1) edit.ids[0].second = unused_ids(layout_, 1)[0];
    return edit;
  }
  std::vector<int> some_faces() {
    std::vector<int> faces;
    for (int face = 0; face < 100; ++face)
      if (uniform() < 0.7) faces.push_back(face);
    return faces;
  }
  Edit settings() {
    Layout layout = layout_;
    switch (kind_ % 20) {
      case 12:
        return SetRegion{some_faces()};
      case 13:
        return SetName{"layout " + std::to_string(below(3))};
      case 14:
        return SetFrame{{dvec3(0, 0, 1 + uniform()), dvec3(1, uniform(), 0)}};
      case 15:
        return SetSampling{{1e6 * (1 + uniform()), below(10), SampleWeights::voronoi, Shells::outer, {}}};
      case 16:
        return SetMaterial{{FieldKind::star, 1e5 * uniform(), 0.001, uniform(), 0.5}};
      case 17: {
        Calibration calibration;
        calibration.gain = 1 + uniform();
        for (const int id : some_ids())
          calibration.taxels.push_back({.id = id, .tare = 1, .gain = 2, .curve = {}, .dead = {}});
        return SetCalibration{calibration};
      }
      case 18: {
        Scenario scenario = project_.scenario;
        *find_number(scenario, "depth") = 1e-3 * (1 + uniform());
        return SetScenario{scenario};
      }
      default:
        return ReplaceMesh{{"/meshes/m.obj", dvec3(1 + uniform()), "abc"}, some_faces()};
    }
  }

  const Project& project_;
  const Layout& layout_;
  CounterRng rng_;
  unsigned kind_;
  std::uint64_t next_ = 0;
};

}  // namespace taxel
