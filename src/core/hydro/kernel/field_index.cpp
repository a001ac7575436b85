#include "core/hydro/kernel/field_index.h"

namespace taxel {
namespace {

PackedTet packed(const PressureField& field, const Tet& tet) {
  PackedTet out;
  for (std::size_t i = 0; i < 4; ++i) {
    const int corner = static_cast<int>(i);
    out.nx[i] = tet.normal[i].x;
    out.ny[i] = tet.normal[i].y;
    out.nz[i] = tet.normal[i].z;
    out.offset[i] = tet.offset[i];
    out.neighbour[i] = tet.neighbour[corner];
    if (field.report().core && tet.neighbour[corner] < 0 && !field.is_skin(tet, corner)) out.core_faces |= 1u << i;
  }
  out.gradient = {tet.gradient.x, tet.gradient.y, tet.gradient.z};
  out.constant = tet.constant;
  out.size = tet.size;
  return out;
}

}  // namespace

FieldIndex::FieldIndex(PressureFieldPtr field_ptr) : field_(std::move(field_ptr)), grid_(*field_) {
  const PressureField& field = *field_;
  std::vector<Aabb> boxes;
  boxes.reserve(field.tets().size());
  tets_.reserve(field.tets().size());
  for (const Tet& tet : field.tets()) {
    tets_.push_back(packed(field, tet));
    mean_tet_size_ += tet.size;
    Aabb& box = boxes.emplace_back();
    for (int i = 0; i < 4; ++i) box.include(field.vertices()[static_cast<std::size_t>(tet.vertices[i])]);
  }
  if (!tets_.empty()) mean_tet_size_ /= static_cast<double>(tets_.size());
  tree_ = WideBvh(boxes);
  index_boundary();
}

void FieldIndex::index_boundary() {
  std::vector<Aabb> boxes;
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    for (int face = 0; face < 4; ++face) {
      if (tets_[t].neighbour[static_cast<std::size_t>(face)] >= 0) continue;
      const bool skin = field_->is_skin(field_->tets()[t], face);
      ends_inside_ = ends_inside_ || !skin;
      BoundaryFace boundary{{}, static_cast<std::int32_t>(t), skin};
      Aabb& box = boxes.emplace_back();
      std::size_t k = 0;
      for (int i = 0; i < 4; ++i) {
        if (i == face) continue;
        boundary.vertices[k] = field_->tets()[t].vertices[i];
        box.include(vertex(boundary.vertices[k++]));
      }
      boundary_faces_.push_back(boundary);
    }
  }
  boundary_tree_ = WideBvh(boxes);
}

}  // namespace taxel
