"""pygeodesic (exact, by trimmed windows) on the sources of bench_geodesics. peer.py FOLDER"""
import pathlib
import sys
import time

try:
    import numpy
    from pygeodesic.geodesic import PyGeodesicAlgorithmExact
except ImportError as error:
    print(f"pygeodesic: skipped: {error}; pip install pygeodesic numpy, and name that Python in PYTHON")
    sys.exit(0)


def compare(folder, name):
    # In millimetres: in metres its absolute tolerances cost it up to 1e-3 of a distance here.
    vertices = 1e3 * numpy.loadtxt(folder / f"{name}.vertices")
    faces = numpy.loadtxt(folder / f"{name}.faces", dtype=numpy.int32)
    rows = numpy.loadtxt(folder / f"{name}.distances")
    peer = PyGeodesicAlgorithmExact(vertices, faces)
    theirs, ours, worst = [], [], 0.0
    for source in dict.fromkeys(rows[:, 0].astype(int)):
        mine = rows[rows[:, 0] == source]
        targets = mine[:, 1].astype(numpy.int32)
        best = float("inf")
        for _ in range(5):  # it stops when the targets, those within 6 mm, are reached
            start = time.thread_time()
            distances, _ = peer.geodesicDistances(numpy.array([source], dtype=numpy.int32), targets)
            best = min(best, time.thread_time() - start)
        theirs.append(1e3 * best)
        ours.append(mine[0, 3])
        away = mine[:, 2] > 0
        worst = max(worst, numpy.max(numpy.abs(1e-3 * distances[away] / mine[away, 2] - 1)))
    whole = []
    for source in list(dict.fromkeys(rows[:, 0].astype(int)))[:5]:
        start = time.thread_time()
        peer.geodesicDistances(numpy.array([source], dtype=numpy.int32), None)
        whole.append(1e3 * (time.thread_time() - start))
    ratio = numpy.median(numpy.array(theirs) / numpy.array(ours))
    print(f"{name}: pygeodesic {numpy.median(theirs):.3f} ms in the median, {numpy.mean(theirs):.3f} in the mean: "
          f"{ratio:.1f} times ours (median ratio); distances differ by {worst:.1e} at most; "
          f"the whole mesh {numpy.median(whole):.1f} ms")


folder = pathlib.Path(sys.argv[1])
for file in sorted(folder.glob("*.distances")):
    compare(folder, file.stem)
