// Equal primitives are built once. Bodies that differ in any value are not shared.
#include "core/hydro/hydro_body.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/hydro/kernel/index/wide_tree.h"

namespace taxel {
namespace {

Shape sphere(double radius) {
  Shape shape;
  shape.size = dvec3(radius, 0, 0);
  return shape;
}

const FacetTree* tree_of(const HydroBodyPtr& body) {
  return std::get<RigidMesh>(body->geometry).tree.get();
}

TEST(BodyCache, SharesTheGeometryOfEqualPrimitivesWithOwnNames) {
  const HydroBodyPtr a = share_body(sphere(0.01), {}, "a"), b = share_body(sphere(0.01), {}, "b");
  EXPECT_EQ(tree_of(a), tree_of(b));
  EXPECT_EQ(a->name, "a");
  EXPECT_EQ(b->name, "b");
}

TEST(BodyCache, DoesNotShareDifferentBodies) {
  const HydroBodyPtr a = share_body(sphere(0.01), {}, "a");
  Shape finer = sphere(0.01);
  finer.resolution = 0.001;
  Material slippery;
  slippery.friction = 0.1;
  EXPECT_NE(tree_of(a), tree_of(share_body(sphere(0.011), {}, "b")));
  EXPECT_NE(tree_of(a), tree_of(share_body(finer, {}, "b")));
  const HydroBodyPtr other = share_body(sphere(0.01), slippery, "b");
  EXPECT_NE(tree_of(a), tree_of(other));
  EXPECT_EQ(other->material.friction, 0.1);
}

TEST(BodyCache, KeepsTheGeometryIfTheFirstBodyIsDestroyed) {
  HydroBodyPtr first = share_body(sphere(0.012), {}, "first");
  const HydroBodyPtr second = share_body(sphere(0.012), {}, "second");
  first.reset();
  EXPECT_EQ(tree_of(share_body(sphere(0.012), {}, "third")), tree_of(second));
}

TEST(BodyCache, RefusesABadShapeEveryTime) {
  for (int i = 0; i < 2; ++i) EXPECT_THROW(share_body(sphere(-1), {}, "bad"), Error);
}

}  // namespace
}  // namespace taxel
