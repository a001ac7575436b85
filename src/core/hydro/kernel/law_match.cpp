#include "core/hydro/kernel/law_match.h"

#include <algorithm>
#include <cmath>

#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/law_pass.h"

namespace taxel {
namespace {

constexpr int kTablePoints = 256;  // of the function T, for the choice of its pieces
constexpr int kFitPoints = 64;     // of each piece: more change the ends by less than 1e-4

/// Sets the pressures of a table to least squares of the relative error of a function f. The normal equations of hat
/// functions are tridiagonal.
template <class F>
void fit_pieces(const F& f, std::vector<LawPoint>& table) {
  const std::size_t count = table.size();
  std::vector<double> diagonal(count, 0.0), off(count, 0.0), right(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double begin = i > 0 ? table[i - 1].strain : 0.0, width = table[i].strain - begin;
    for (int n = 0; n < kFitPoints; ++n) {
      // Weights of 1/f^1.5 and pieces of even error: small pressures count as much as large ones.
      const double t = (n + 0.5) / kFitPoints, p = f(begin + t * width), w = width / (p * std::sqrt(p));
      diagonal[i] += w * t * t;
      right[i] += w * t * p;
      if (i == 0) continue;
      diagonal[i - 1] += w * (1 - t) * (1 - t);
      off[i] += w * t * (1 - t);
      right[i - 1] += w * (1 - t) * p;
    }
  }
  for (std::size_t i = 1; i < count; ++i) {
    const double factor = off[i] / diagonal[i - 1];
    diagonal[i] -= factor * off[i];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = count; i-- > 0;)
    table[i].pressure = (right[i] - (i + 1 < count ? off[i + 1] * table[i + 1].pressure : 0.0)) / diagonal[i];
}

}  // namespace

bool LawMatch::is_identity() const {
  if (own_->law.is_linear() && other_->law.is_linear()) return true;
  return own_->modulus == other_->modulus && own_->law == other_->law;
}

double LawMatch::operator()(double q) const {
  const double E = own_->modulus, F = other_->modulus;
  if (!(q > 0)) return q * own_->law.gradient(0) / other_->law.gradient(0);
  return F * other_->law.strain(E * own_->law.pressure(q / E) / F);
}

double LawMatch::inverse(double p) const {
  if (!(p > 0)) return p * other_->law.gradient(0) / own_->law.gradient(0);
  return LawMatch(*other_, *own_)(p);
}

double LawMatch::steepest() const {
  return own_->law.slopes().most / other_->law.slopes().least;
}

PressureLaw LawMatch::pieces() const {
  const double E = own_->modulus;
  const auto of_strain = [&](double e) { return (*this)(E * e) / E; };
  PressureLaw fine{LawKind::table, 0, {}}, pieces{LawKind::table, 0, {}};
  for (int i = 1; i <= kTablePoints; ++i) {
    const double e = static_cast<double>(i) / kTablePoints;
    fine.table.push_back({e, of_strain(e)});
  }
  for (const double e : law_levels(fine, kLawLevels)) pieces.table.push_back({e, 0});
  pieces.table.push_back({1, 0});
  fit_pieces(of_strain, pieces.table);
  return pieces;
}

std::shared_ptr<const MatchedField> MatchedFields::get(const PressureField& field, const TriMesh* skin,
                                                       const Material& own, const Material& other) {
  constexpr std::size_t kMostFields = 4;
  const std::lock_guard lock(mutex_);
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    if (entry->modulus != other.modulus || entry->law != other.law) continue;
    entries_.splice(entries_.begin(), entries_, entry);
    return entries_.front().field;
  }
  if (entries_.size() == kMostFields) entries_.pop_back();
  PressureLaw pieces = LawMatch(own, other).pieces();
  DividedField divided = divide_field(field, pieces, own.modulus);
  auto index = std::make_shared<const FieldIndex>(divided.field, skin);
  auto made = std::make_shared<const MatchedField>(
      MatchedField{std::move(index), std::move(divided.parents), std::move(pieces)});
  entries_.push_front({other.modulus, other.law, made});
  return made;
}

}  // namespace taxel
