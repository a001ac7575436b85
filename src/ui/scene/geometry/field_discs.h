// The receptive fields of all taxels as triangles of the skin that contain them. Each vertex carries its place in the
// frame of the disc and the normal of the skin, so that each pixel decides whether it is inside the field.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

#include "core/sensor/sensor_model.h"
#include "ui/scene/geometry/render_mesh.h"

namespace taxel::ui {

/// A corner of a triangle that contains a part of a field.
struct FieldVertex {
  glm::vec3 position{0};  ///< [m], frame of the mesh
  /// Its length is the distance from the centre as a fraction of the radius. If the metric is Euclidean, this is the
  /// vector from the centre in the frame of the disc, so that the length is exact between the corners, too.
  glm::vec3 from_center{0};
  glm::vec3 normal{0, 0, 1};  ///< normal of the skin in the frame of the disc, whose z axis is the disc's normal
  float taxel = 0;            ///< index in layout order, set by join_shapes()
};

struct FieldShape {
  std::vector<FieldVertex> vertices;
  std::vector<std::uint32_t> corners;  ///< three vertices for each triangle, with the winding of the skin
};

struct FieldDiscs {
  FieldShape shape;           ///< triangles of all taxels, one taxel after another
  std::vector<int> first{0};  ///< corners of taxel k: [first[k], first[k + 1])
  double min_cosine = 0;      ///< cosine of the angle limit, at which a field ends
};

/// Makes the shapes of fields on one skin. The angle limit refers to normals that are interpolated over round parts of
/// the skin. If the layout takes the normals of faces, its fields end along faces, and the drawn line is smooth, at
/// most one face away.
class FieldShapes {
 public:
  /// `unfolded` is needed if the metric of the layout is geodesic.
  FieldShapes(const SensorModel& model, std::shared_ptr<const UnfoldedMesh> unfolded);

  /// Returns the shape of one taxel. With subtaxels, this is the union of their fields: each triangle belongs to the
  /// nearest one. The field of one Euclidean disc has whole faces. Others have faces that are halved until their edges
  /// are at most a quarter of the radius. May be called by several threads.
  [[nodiscard]] FieldShape of(const Taxel& taxel) const;

 private:
  struct Cut;
  [[nodiscard]] bool is_facing(int face, const FieldDisc& disc) const;
  [[nodiscard]] glm::vec3 normal_at(int face, const dvec3& p) const;
  void append_whole(const FieldDisc& disc, Cut& cut) const;
  template <class FromCenter>
  void append_halved(const FieldDisc& disc, const dvec3& middle, int face, const FromCenter& from_center,
                     Cut& cut) const;
  void append_geodesic(const FieldDisc& disc, Cut& cut) const;

  const SensorModel& model_;
  std::shared_ptr<const UnfoldedMesh> unfolded_;
  RenderMesh smooth_;  ///< skin with the normals that limits refer to
  double min_cosine_;
};

/// Returns the shapes one after another, with the numbers of their taxels.
[[nodiscard]] FieldDiscs join_shapes(const SensorModel& model, const std::vector<FieldShape>& shapes);

/// Returns the opacity of a disc, 0 to 0.9, for a reading as a fraction of its range: 0 without a reading, and more
/// than 0.75 from a tenth of the range on, so that the colour of the disc is that of the legend.
[[nodiscard]] float disc_alpha(double fraction);

}  // namespace taxel::ui
