"""The results as Markdown."""


def _small(value):
    return "< 1e-12" if value < 1e-12 else f"{value:.1e}"


def _table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]) + "\n"


def speed(rows, overhead_us):
    head = ["class", "path", "polygons ours / Drake", "ours [us]", "Drake [us]", "Drake / ours", "ours [ns per polygon]",
            "area difference", "force difference", "back faces", "brute force [us]", "brute force / ours",
            "difference from it"]
    cells = [(r.name, r.path, r.refused, *[""] * 10) if r.refused else
             (r.name, r.path, f"{r.polygons:.0f} / {r.drake_polygons:.0f}", f"{r.ours_us:.1f}", f"{r.drake_us:.1f}",
              f"**{r.ratio:.1f}**", f"{1e3 * r.ours_us / r.polygons:.0f}", _small(r.area_difference),
              _small(r.force_difference), f"{r.back_faces:.1f}", f"{r.brute_us:.0f}", f"{r.brute_ratio:.0f}", _small(r.brute_difference))
             for r in rows]
    return ("## Time of one contact surface\n\n"
            "Both sides get the same tets and triangles, bit for bit, and the same 20 poses of a path, in turn, in one process on one core. "
            "Per pose the fastest of some repetitions counts; the table gives means over a path. Differences are the largest over "
            "a path, relative to the path's largest value. Drake is called through pydrake: the time of a query that finds "
            f"nothing ({overhead_us:.1f} us at most: interpreter, binding, broad phase) is subtracted. Ours is timed in C++ around `intersect`. "
            "Brute force takes every tet against every triangle or tet, once, at the path's middle pose; its ratio is to ours at that pose, "
            "its difference the larger one of area and force.\n\n"
            + _table(head, cells) +
            "\nDrake leaves out polygons whose normal makes an angle of more than 5 pi/8 with the pressure gradient, we by a factor that "
            "falls between two angles around it: that is the difference on the finger. Brute force counts all faces, and so does ours "
            "where it is compared with it. Drake takes every vertex of the boundary for skin, so it needs the finger's core filled with tets; "
            "`core filled` gives us these tets too, otherwise we have the pad alone. The contact lies in the pad.\n")


def agreement(rows):
    head = ["soft", "against", "tets", "poses", "filtered", "area", "force", "centroid"]
    cells = [(r.soft, r.other, r.tets, r.poses, r.filtered, _small(r.area), _small(r.force), _small(r.centroid)) for r in rows]
    return ("## The same tets on both sides\n\n"
            "Drake on its own tets, and our kernel on these tets, exported unscaled. Random poses; those with faces that oppose the "
            "pressure are counted as filtered and not compared, because Drake's limit of angles is hard and ours is smooth. Largest relative differences; centroid relative to the root of "
            "the area. Bound: 1e-6.\n\n" + _table(head, cells))


def thin(rows):
    head = ["body", "poses", "force difference", "if all faces of ours counted"]
    cells = [(r.name, r.poses, _small(r.force), _small(r.all_faces)) for r in rows]
    return ("## Thin bodies\n\n"
            "Rigid bodies in a soft box, on Drake's tets of the box, tilted by up to 10 degrees and 0.5 to 3 mm deep: the far faces of these "
            "bodies oppose the pressure, and both sides leave them out. Largest differences of the force, relative to Drake's. Bound: 2 %.\n\n"
            + _table(head, cells))


def accuracy(rows):
    def ratio(drake, ours):
        return "both exact" if drake < 1e-12 and ours < 1e-12 else f"{drake / ours:.0f}" if ours > 1e-12 else "> 1e6"

    head = ["soft shape on a rigid plane, or two", "tets ours / Drake", "force error ours", "Drake", "Drake / ours",
            "area error ours", "Drake", "Drake / ours"]
    cells = [(r.name, f"{r.tets} / {r.drake_tets}", _small(r.force), _small(r.drake_force), ratio(r.drake_force, r.force),
              _small(r.area), _small(r.drake_area), ratio(r.drake_area, r.area)) for r in rows]
    return ("## Error against closed forms\n\n"
            "Each side tessellates the shape itself, ours with no more tets than Drake's. Mean relative errors over 100 directions. "
            "Bound: a fifth of Drake's error, or rounding.\n\n" + _table(head, cells))
