"""Other samplers on the meshes of bench_samples, on one core. peer.py FOLDER

Reads cases.txt and the meshes there; leaves points and peers.txt for `bench_samples table FOLDER`.
Times are of the processor, best of three where one takes less than two seconds.
"""
import os
import pathlib
import sys
import time

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):  # read when the libraries are loaded
    os.environ[variable] = "1"
os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])

try:
    import numpy
except ImportError as error:
    print(f"other samplers: skipped: {error}", file=sys.stderr)
    sys.exit(0)


def lloyd():
    """Lloyd's relaxation, projected (point-cloud-utils, by Geogram)"""
    import point_cloud_utils
    return lambda vertices, faces, count: point_cloud_utils.sample_mesh_lloyd(vertices, faces, count)


def elimination():
    """Weighted sample elimination (Yuksel 2015) in Open3D, from its own pool"""
    import open3d
    def sample(vertices, faces, count):
        mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(vertices), open3d.utility.Vector3iVector(faces))
        open3d.utility.random.seed(42)
        return numpy.asarray(mesh.sample_points_poisson_disk(count).points)
    return sample


def pruning(exact):
    """Constrained Poisson-disk sampling (Corsini, Cignoni, Scopigno 2012) by VCGlib in MeshLab"""
    import pymeshlab
    def sample(vertices, faces, count):
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(vertices, faces))
        meshes.generate_sampling_poisson_disk(samplenum=count, exactnumflag=exact)
        return meshes.current_mesh().vertex_matrix()
    return sample


METHODS = {"Lloyd": lloyd, "Open3D": elimination, "MeshLab": lambda: pruning(False),
           "MeshLab, exact count": lambda: pruning(True)}


def measure(sample, vertices, faces, count):
    best = float("inf")
    for _ in range(3):
        start = time.process_time()
        points = sample(vertices, faces, count)
        taken = 1e3 * (time.process_time() - start)
        best = min(best, taken)
        if taken > 2000:
            break
    return points, best


def main(folder):
    methods = {}
    for name, load in METHODS.items():
        try:
            methods[name] = load()
        except ImportError as error:
            print(f"{name}: skipped: {error}", file=sys.stderr)
    done = 0
    for case in (folder / "cases.txt").read_text().splitlines():
        mesh, count, file = case.split("|")
        # In millimetres: absolute tolerances of theirs would tell in metres.
        vertices = numpy.ascontiguousarray(1e3 * numpy.loadtxt(folder / f"{file}.vertices"))
        faces = numpy.ascontiguousarray(numpy.loadtxt(folder / f"{file}.faces", dtype=numpy.int32))
        for name, sample in methods.items():
            if name == "MeshLab, exact count" and int(count) > 10000:
                continue  # minutes
            points, taken = measure(sample, vertices, faces, int(count))
            left = f"{done}.points"
            done += 1
            numpy.savetxt(folder / left, 1e-3 * points, fmt="%.17g")
            with open(folder / "peers.txt", "a") as peers:
                peers.write(f"{mesh}|{count}|{name}|{taken}|{left}\n")


main(pathlib.Path(sys.argv[1]))
