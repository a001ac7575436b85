// The steps of a repair, in the order in which they run. Each removes one kind of fault and returns a report of it.
#pragma once

#include "core/mesh/repair/draft.h"

namespace taxel {

/// Removes duplicates of faces with the same three corners and the same winding.
RepairStep remove_repeated(Draft& draft);
/// Pairs of faces with the same three corners and opposite winding are removed: they enclose nothing.
RepairStep remove_folded(Draft& draft);
/// Removes the second of the two faces of each pair of remove_folded().
RepairStep remove_back_faces(Draft& draft);
/// Removes patches that hang on an edge of more than two faces and end open, the smallest first, as long as they make
/// up at most 2 % of the loaded area.
RepairStep remove_fins(Draft& draft, const RepairLimits& limits);
/// Joins the ends of edges that are no longer than the rounding of their points, 1e-9 of the diagonal: poles of globes.
RepairStep join_short_edges(Draft& draft, const RepairLimits& limits);
/// Joins points of open edges that rounding has torn apart. `length` is the largest distance between joined points.
/// A joined point gets the position of the one with the lowest number; `moved` counts the others.
RepairStep join_rims(Draft& draft, const RepairLimits& limits);
/// Flips the longest edge of each face without area, so that its apex splits the face across.
RepairStep turn_flat_faces(Draft& draft);
/// Splits an open edge at each rim point that is on the edge within 1e-5 of the diagonal.
RepairStep split_junctions(Draft& draft, const RepairLimits& limits);
/// Turns faces so that neighbours wind alike. `unorientable` gets bands on which this fails (a Moebius strip): a
/// nonzero entry for each of their faces. A body on which it fails keeps a seam of open edges.
RepairStep wind_alike(Draft& draft, std::vector<char>& unorientable);
/// Separates surfaces that only touch along an edge or at a point, so that solid lies between the faces of each.
RepairStep part_touching(Draft& draft, RepairChanges& changes);
/// Fills every hole.
RepairStep fill_holes(Draft& draft, const RepairLimits& limits);
/// Turns shells so that their volume is positive, or negative if they are cavities inside another shell.
RepairStep orient_shells(Draft& draft);
/// Replaces shells that overlap, touch along faces or lie inside each other by the union of the outward ones minus the
/// cavities. `area` is that of the surface that went inside.
RepairStep unite_shells(Draft& draft, const RepairLimits& limits);

}  // namespace taxel
