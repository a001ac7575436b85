// Mirror twins: created once, and updated with each later edit of the other twin.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/rng.h"
#include "core/document/edit.h"
#include "core/layout/generators/place.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

const MirrorPlane kX{};  // the plane x = 0
const MirrorPlane kY{dvec3(0), dvec3(0, 3, 0)};

/// Returns six taxels on the +x side.
Project six() {
  Project project;
  project.layout.mesh.file = "/m.obj";
  for (int i = 0; i < 6; ++i)
    project.layout.taxels.push_back(
        {i, i == 0 ? "right pad" : "", dvec3(4 + i, i - 6, 14.6462) * 1e-3, dvec3(0.4, -0.9, 0.1), 0.006, {}});
  return project;
}

const Taxel& taxel_of(const Project& project, int id) {
  return project.layout.taxels[taxel_index(project.layout, id)];
}

SetTaxels move(int id, const dvec3& center) {
  TaxelChange change;
  change.id = id;
  change.center = center;
  return {{change}};
}

dvec3 flipped_x(const dvec3& v) {
  return {-v.x, v.y, v.z};
}

TEST(MirrorLink, MakesTwelveTaxelsOfSix) {
  const Project project = apply_edit(six(), MirrorTaxels{{0, 1, 2, 3, 4, 5}, kX});
  ASSERT_EQ(project.layout.taxels.size(), 12U);
  ASSERT_EQ(project.mirrors.size(), 1U);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(project.mirrors[0].links[static_cast<std::size_t>(i)], (MirrorLink{i, i + 6}));
    EXPECT_EQ(taxel_of(project, i + 6).center, flipped_x(taxel_of(project, i).center));
    EXPECT_EQ(taxel_of(project, i + 6).normal, flipped_x(taxel_of(project, i).normal));
  }
  EXPECT_EQ(taxel_of(project, 6).name, "left pad");
  EXPECT_EQ(apply_edit(project, MirrorTaxels{{0, 1, 2, 3, 4, 5, 6, 7}, kX}), project) << "twice is once";
}

TEST(MirrorLink, LinksAnExistingTwinAndSkipsTaxelsInThePlane) {
  Project project = six();
  project.layout.taxels[1].center = flipped_x(project.layout.taxels[0].center);
  project.layout.taxels[2].center.x = 0;
  project = apply_edit(project, MirrorTaxels{{0, 2}, kX});
  EXPECT_EQ(project.layout.taxels.size(), 6U);
  EXPECT_EQ(project.mirrors[0].links, (std::vector<MirrorLink>{{0, 1}}));
  EXPECT_TRUE(apply_edit(six(), MirrorTaxels{{}, kX}).mirrors.empty());
}

/// Returns a taxel of 6 mm whose image would be 0.2 mm away, like one that was placed with the mouse near the middle.
Project near_the_plane(const dvec3& normal) {
  Project project;
  project.layout.mesh.file = "/m.obj";
  project.layout.taxels.push_back({3, "", dvec3(1e-4, -0.006, 0.02), glm::normalize(normal), 0.006, {}});
  return project;
}

TEST(MirrorLink, MovesATaxelThatCoversItsImageIntoThePlane) {
  const Project before = near_the_plane(dvec3(0.1, -1, 0.2));
  const Project project = apply_edit(before, MirrorTaxels{{3}, kX});
  ASSERT_EQ(project.layout.taxels.size(), 1U);
  EXPECT_TRUE(project.mirrors.empty());
  EXPECT_EQ(project.layout.taxels[0].center, dvec3(0, -0.006, 0.02));
  EXPECT_NEAR(glm::distance(project.layout.taxels[0].normal, glm::normalize(dvec3(0, -1, 0.2))), 0, 1e-15);
  EXPECT_EQ(apply_edit(project, MirrorTaxels{{3}, kX}), project) << "twice is once";
  // At half the radius from the plane the two discs share 39 %, so they are a pair.
  Project apart = before;
  apart.layout.taxels[0].center.x = 0.003;
  EXPECT_EQ(apply_edit(apart, MirrorTaxels{{3}, kX}).layout.taxels.size(), 2U);
  // The normals on the two sides of a thin tongue point away from each other.
  EXPECT_EQ(apply_edit(near_the_plane(dvec3(1, 0.1, 0)), MirrorTaxels{{3}, kX}).layout.taxels.size(), 2U);
}

TEST(MirrorLink, UpdatesTwinsOfATaxelThatIsMovedIntoAPlane) {
  Project project = apply_edit(near_the_plane(dvec3(0.1, -1, 0.2)), MirrorTaxels{{3}, kY});
  ASSERT_EQ(project.layout.taxels.size(), 2U);
  project = apply_edit(project, MirrorTaxels{{3}, kX});
  EXPECT_EQ(project.layout.taxels[1].center, dvec3(0, 0.006, 0.02));
}

TEST(MirrorLink, ProjectsImagesOntoAnAsymmetricSkin) {
  // The centre of the ball is 0.3 mm off the plane, so the mirror image of a point on the ball is up to 0.6 mm off the
  // ball.
  std::vector<dvec3> vertices = make_icosphere(0.02, 4).vertices();
  for (dvec3& v : vertices) v.x += 3e-4;
  const auto mesh = std::make_shared<const TriMesh>(std::move(vertices), make_icosphere(0.02, 4).faces());
  const auto skin = std::make_shared<const MeshIndex>(mesh);
  Project project = near_the_plane(dvec3(1, -1, 0.2));
  project.layout.taxels[0].center = dvec3(0.015, -0.014, 0.002);
  project.layout.taxels = onto_skin(project.layout.taxels, *skin);
  project.layout.taxels[0].radius = 0.003;
  const Taxel free = apply_edit(project, MirrorTaxels{{3}, kX}).layout.taxels[1];
  EXPECT_GT(skin->closest_point(free.center).distance, 1e-4);
  const Taxel put = apply_edit(project, MirrorTaxels{{3}, kX, 1e-6, skin}).layout.taxels[1];
  EXPECT_LT(skin->closest_point(put.center).distance, 1e-12);
  EXPECT_EQ(put.center, onto_skin({free}, *skin)[0].center);
  EXPECT_EQ(put.normal, onto_skin({free}, *skin)[0].normal);
  // The image of a taxel that is intentionally off the skin is off the skin as well.
  project.layout.taxels[0].center *= 0.9;
  EXPECT_EQ(apply_edit(project, MirrorTaxels{{3}, kX, 1e-6, skin}), apply_edit(project, MirrorTaxels{{3}, kX}));
}

TEST(MirrorLink, CopiesOnlyChangedValuesBetweenTwins) {
  Project project = apply_edit(six(), MirrorTaxels{{0}, kX});
  TaxelChange nudge;  // like a tool that projects the image onto a mesh that is not quite symmetric
  nudge.id = 6;
  nudge.center = dvec3(-0.0041, -0.006, 0.0146);
  project = apply_edit(project, SetTaxels{{nudge}, false});
  EXPECT_EQ(taxel_of(project, 0).center, six().layout.taxels[0].center);

  TaxelChange resize;
  resize.id = 0;
  resize.radius = 0.004;
  project = apply_edit(project, SetTaxels{{resize}});
  EXPECT_EQ(taxel_of(project, 6).radius, 0.004);
  EXPECT_EQ(taxel_of(project, 6).center, *nudge.center) << "its place is not what changed";

  resize.radius = 0.003;
  project = apply_edit(project, SetTaxels{{resize}, false});
  project = apply_edit(project, move(6, {-0.001, 0.002, 0.003}));
  EXPECT_EQ(taxel_of(project, 0).radius, 0.003) << "nor is the radius now";
  EXPECT_EQ(taxel_of(project, 0).center, dvec3(0.001, 0.002, 0.003));
  EXPECT_EQ(taxel_of(project, 0).name, "right pad");
}

TEST(MirrorLink, KeepsTheValuesOfTwinsThatAreBothEdited) {
  const Project project = apply_edit(six(), MirrorTaxels{{0}, kX});
  SetTaxels both = move(0, {1, 0, 0});
  both.changes.push_back(move(6, {2, 0, 0}).changes[0]);
  EXPECT_EQ(taxel_of(apply_edit(project, both), 0).center, dvec3(1, 0, 0));
  EXPECT_EQ(taxel_of(apply_edit(project, both), 6).center, dvec3(2, 0, 0));
}

TEST(MirrorLink, FollowsAcrossTwoPlanes) {
  Project project = apply_edit(six(), MirrorTaxels{{0}, kX});
  project = apply_edit(project, MirrorTaxels{{0, 6}, kY});
  ASSERT_EQ(project.layout.taxels.size(), 9U);  // 6: -x, 7: -y, 8: -x -y
  project = apply_edit(project, move(7, {0.001, -0.002, 0.003}));
  EXPECT_EQ(taxel_of(project, 0).center, dvec3(0.001, 0.002, 0.003));
  EXPECT_EQ(taxel_of(project, 6).center, dvec3(-0.001, 0.002, 0.003));
  EXPECT_EQ(taxel_of(project, 8).center, dvec3(-0.001, -0.002, 0.003));
}

TEST(MirrorLink, MirrorsSubtaxels) {
  Project project = six();
  project.layout.taxels[0].subtaxels = {{dvec3(1, 2, 3), dvec3(1, 0, 0), 0.001}};
  project = apply_edit(project, MirrorTaxels{{0}, kX});
  EXPECT_EQ(taxel_of(project, 6).subtaxels[0].center, dvec3(-1, 2, 3));
  project = apply_edit(project, move(0, taxel_of(project, 0).center + dvec3(1, 0, 0)));
  EXPECT_EQ(taxel_of(project, 6).subtaxels[0].center, dvec3(-2, 2, 3));
  EXPECT_EQ(taxel_of(project, 6).subtaxels[0].normal, dvec3(-1, 0, 0));
}

TEST(MirrorLink, LeavesUnlinkedTaxelsUnchanged) {
  Project project = apply_edit(six(), MirrorTaxels{{0, 1}, kX});
  project = apply_edit(project, UnlinkTaxels{{6}});
  EXPECT_EQ(project.mirrors[0].links, (std::vector<MirrorLink>{{1, 7}}));
  project = apply_edit(project, move(0, {1, 0, 0}));
  EXPECT_EQ(taxel_of(project, 6).center, flipped_x(six().layout.taxels[0].center));
  EXPECT_TRUE(apply_edit(project, UnlinkTaxels{{1}}).mirrors.empty());
}

/// Applies the mirror edit by its definition, comparing every pair of taxels: creates the images and links.
Project mirrored_by_hand(Project project, const MirrorTaxels& edit) {
  Mirror mirror{edit.plane, {}};
  const auto is_linked = [&](int id) {
    return std::any_of(mirror.links.begin(), mirror.links.end(),
                       [id](const MirrorLink& link) { return link.taxel == id || link.image == id; });
  };
  for (const int id : edit.ids) {
    const Taxel taxel = taxel_of(project, id);
    Taxel image = mirror_images({taxel}, edit.plane).front();
    if (is_linked(id) || glm::distance(image.center, taxel.center) <= edit.tolerance) continue;
    int nearest = -1;
    double least = edit.tolerance;
    for (const Taxel& other : project.layout.taxels) {
      const double distance = glm::distance(other.center, image.center);
      if (other.id == id || is_linked(other.id) || !(nearest < 0 ? distance <= least : distance < least)) continue;
      nearest = other.id;
      least = distance;
    }
    if (nearest < 0) {
      image.id = nearest = unused_ids(project.layout, 1).front();
      image.name = mirrored_name(image.name);
      project.layout.taxels.push_back(image);
    }
    mirror.links.push_back({id, nearest});
  }
  project.mirrors.push_back(mirror);
  return project;
}

TEST(MirrorLink, EqualsTheSearchOverAllPairs) {
  const CounterRng rng(11);
  for (const double tolerance : {0.0, 1e-6, 2e-3}) {
    Project project;
    project.layout.mesh.file = "/m.obj";
    std::vector<int> ids;
    // A coarse raster, so that taxels coincide with images, each other and the plane, also at equal distances.
    for (int i = 0; i < 400; ++i) {
      const auto raster = [&](int axis) {
        const auto step = static_cast<int>(rng.bits(static_cast<std::uint64_t>(3 * i + axis)) % 13);
        return 1e-3 * (step - 6);
      };
      project.layout.taxels.push_back({3 * i, "", dvec3(raster(0), raster(1), raster(2)), dvec3(1, 0, 0), 0.002, {}});
      if (i % 4 != 0) ids.push_back(3 * i);
    }
    const MirrorTaxels edit{ids, kX, tolerance};
    const Project expected = mirrored_by_hand(project, edit), made = apply_edit(project, edit);
    EXPECT_EQ(made.layout, expected.layout) << tolerance;
    EXPECT_EQ(made.mirrors, expected.mirrors) << tolerance;
    EXPECT_GT(made.layout.taxels.size(), project.layout.taxels.size());
    EXPECT_LT(made.layout.taxels.size(), project.layout.taxels.size() + ids.size()) << "some are linked, not added";
  }
}

TEST(MirrorLink, NamesTaxelsThatCannotBeLinked) {
  const auto complaint = [](const Edit& edit) {
    return test::complaint_of([&] { apply_edit(apply_edit(six(), LinkTaxels{{{0, 1}}, kX}), edit); });
  };
  EXPECT_EQ(complaint(LinkTaxels{{{2, 2}}, kX}), "taxel 2: cannot be its own mirror image");
  EXPECT_EQ(complaint(LinkTaxels{{{2, 0}}, kX}), "taxel 0: is already linked with taxel 1");
  EXPECT_EQ(complaint(LinkTaxels{{{2, 0}}, kY}), "accepted");
  EXPECT_EQ(complaint(LinkTaxels{{{2, 9}}, kX}), "taxel 9: is not in the layout");
  EXPECT_EQ(complaint(MirrorTaxels{{9}, kX}), "taxel 9: is not in the layout");
  EXPECT_EQ(complaint(MirrorTaxels{{2}, {dvec3(0), dvec3(0)}}), "mirror: normal: must be a direction, is [0, 0, 0]");
}

}  // namespace
}  // namespace taxel
