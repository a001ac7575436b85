// The verdict on contacts whose artifact is known by construction.
#include <gtest/gtest.h>

#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

using test::LabelledCase;

void show(const char* label, const Explanation& e) {
  const Verdict& v = e.change->verdict;
  const double s = 100 * 0.1 / v.limit;
  fmt::print("{:<16} -> {:<16} change {:6.1f} noise {:6.1f} field {:6.1f} contact {:6.1f} | {}\n", label,
             to_word(v.cause), s * v.change, s * v.noise, s * v.field, s * v.contact, v.text);
}

TEST(VerdictCases, Explore) {
  for (const double bump : {0.0, 0.00005, 0.0001, 0.0002, 0.0003})
    for (const FieldKind field : {FieldKind::star, FieldKind::pad}) {
      LabelledCase c;
      c.model = test::preview_model(test::capsule_layout(field, 5e6), test::bumpy_capsule(bump, 7));
      const auto* soft = std::get_if<SoftBody>(&c.model->body->geometry);
      c.other = test::rigid_ball(0.004);
      c.path = test::along_side(0.004, 0.001, -0.01, 0.0005, 40);
      show(fmt::format("bump {} {} inv {}", bump * 1e3, field == FieldKind::star ? "star" : "pad", soft->field->report().inverted).c_str(), c.explain_largest_jump());
    }
}

}  // namespace
}  // namespace taxel
