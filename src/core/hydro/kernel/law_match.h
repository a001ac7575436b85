// Two soft bodies with pressure laws. Their kernels find where two linear pressures are equal, so the pressures of one
// body are replaced by those of an equal linear pressure of the other one.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/material.h"
#include "core/hydro/fields/pressure_field.h"

namespace taxel {

class FieldIndex;

/// The function T from the linear pressures q = E e of one body to those of another one at which the pressures by their
/// laws are equal: E L(q/E) = E' L'(T(q)/E').
class LawMatch {
 public:
  LawMatch(const Material& own, const Material& other) : own_(&own), other_(&other) {}

  /// Returns whether T(q) = q, so that both bodies remain as they are.
  [[nodiscard]] bool is_identity() const;
  /// Returns T(q) [Pa]; linear with its first slope for negative pressures.
  [[nodiscard]] double operator()(double q) const;
  /// Returns the pressure at which T is p [Pa].
  [[nodiscard]] double inverse(double p) const;
  /// Returns an upper bound of the derivative of T.
  [[nodiscard]] double steepest() const;
  /// Returns T(E e)/E as a table of straight pieces from e = 0 to 1, of even relative error: their ends are those of
  /// least squares, so the errors of a press nearly cancel. E is the body's own modulus.
  [[nodiscard]] PressureLaw pieces() const;

 private:
  const Material *own_, *other_;
};

/// A field for a pair, in the form that the kernel reads, with the tets of the body's own field that its tets are in.
struct MatchedField {
  std::shared_ptr<const FieldIndex> index;
  std::vector<int> parents;
  PressureLaw pieces;  ///< LawMatch::pieces()
};

/// The fields of one body for the materials that it meets. May be used from any thread.
class MatchedFields {
 public:
  /// Returns the field whose pressures are those of T. It is made for the first pair with such materials. `skin` is
  /// that of a field that continues beyond its tets, or null.
  std::shared_ptr<const MatchedField> get(const PressureField& field, const TriMesh* skin, const Material& own,
                                          const Material& other);

 private:
  struct Entry {
    double modulus;
    PressureLaw law;
    std::shared_ptr<const MatchedField> field;
  };
  std::mutex mutex_;
  std::list<Entry> entries_;  // latest one first
};

}  // namespace taxel
