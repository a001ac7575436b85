"""Microseconds per contact surface, ours, Drake's and brute force's, pose by pose in turn."""
import dataclasses

import numpy as np

import drake_peer
from taxel_peer import Refused

ROUNDS = 10  # how often a path is gone through


@dataclasses.dataclass
class Row:
    name: str
    path: str
    polygons: float = 0          # ours, mean over the poses
    drake_polygons: float = 0
    ours_us: float = 0           # mean over the poses of the fastest repetition
    drake_us: float = 0          # the same, less the overhead of an empty query
    area_difference: float = 0   # largest over the poses, relative to the path's largest area
    force_difference: float = 0  # the same for the force vector
    back_faces: float = 0        # polygons that our rule of faces leaves out, wholly or in part, mean
    brute_us: float = 0          # every tet against every triangle or tet, at the path's middle pose, once
    brute_ratio: float = 0       # that over ours at the same pose
    brute_difference: float = 0  # the larger one of area and force, relative
    refused: str = ""

    @property
    def ratio(self):
        return self.drake_us / self.ours_us if self.ours_us > 0 else 0.0


def overhead(case):
    """Microseconds of a Drake query that finds nothing: interpreter, binding, broad phase."""
    far = np.array([0, 0, -10.0, 1, 0, 0, 0])  # below, as half-spaces end nowhere else
    query = case.drakes.place(np.array([0, 0, 0, 1.0, 0, 0, 0]), far)
    return drake_peer.nanoseconds(query, 1000) / 1e3


def difference(mine, theirs):
    """Largest distance of two columns (of numbers or vectors), relative to the largest of theirs."""
    mine, theirs = np.asarray(mine), np.asarray(theirs)
    if mine.ndim == 1:
        mine, theirs = mine[:, None], theirs[:, None]
    largest = np.max(np.linalg.norm(theirs, axis=1))
    return float(np.max(np.linalg.norm(mine - theirs, axis=1)) / largest) if largest > 0 else 0.0


def beside_brute_force(case, pose, row):
    ours = case.all_faces.contact(*pose, repeat=100)
    try:
        brute = case.all_faces.brute_force(*pose)
    except Refused:  # a half-space
        return
    row.brute_us, row.brute_ratio = brute.nanoseconds / 1e3, brute.nanoseconds / ours.nanoseconds
    row.brute_difference = max(difference([ours.area], [brute.area]), difference([list(ours.force)], [list(brute.force)]))


def measure(case, path, poses, empty_us, brute_force):
    row = Row(case.name, path)
    try:
        ours = [case.ours.contact(*pose) for pose in poses]
    except Refused as reason:
        row.refused = str(reason)
        return row
    drakes = [case.drakes.contact(*pose) for pose in poses]
    mine, theirs = np.full(len(poses), np.inf), np.full(len(poses), np.inf)
    for _ in range(ROUNDS):
        for i, pose in enumerate(poses):
            query = case.drakes.place(*pose)
            theirs[i] = min(theirs[i], drake_peer.nanoseconds(query, 3) / 1e3)
            mine[i] = min(mine[i], case.ours.contact(*pose, repeat=4).nanoseconds / 1e3)
    row.polygons = np.mean([c.polygons for c in ours])
    row.drake_polygons = np.mean([c.polygons if c else 0 for c in drakes])
    row.ours_us, row.drake_us = np.mean(mine), np.mean(theirs) - empty_us
    row.area_difference = difference([c.area for c in ours], [c.area if c else 0.0 for c in drakes])
    row.force_difference = difference([list(c.force) for c in ours], [c.force if c else np.zeros(3) for c in drakes])
    row.back_faces = np.mean([c.back_faces for c in ours])
    if brute_force:
        beside_brute_force(case, poses[len(poses) // 2], row)
    return row


def run(cases, report, brute_force=True):
    """All rows; `report` is called with each as it is known."""
    rows, empties = [], []
    for case in cases:
        empties.append(overhead(case))
        for path, poses in case.paths.items():
            rows.append(measure(case, path, poses, empties[-1], brute_force))
            report(rows[-1])
    return rows, max(empties)
