"""Compares our reader and writer of Parquet files with pyarrow: each file that pyarrow writes is read by copy_table and
written again, and pyarrow must find the same table, bit for bit. Exits with 77 if pyarrow is not installed."""
import pathlib
import struct
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import pyarrow as pa
    import pyarrow.parquet as pq
except ImportError as error:
    print(f"skipped: {error} (scripts/setup installs pyarrow)")
    sys.exit(77)

COPY = sys.argv[1]


def tables():
    """Yields a name and a table of the types that are read."""
    rng = np.random.default_rng(7)
    bits = np.frombuffer(rng.bytes(8 * 5000), dtype=np.float64)  # any bits, also of numbers that are not numbers
    readings = np.where(rng.random(6000) < 0.7, 0.0, rng.random(6000))
    yield "numbers", pa.table({"a": rng.integers(-(2**62), 2**62, 5000), "b": bits, "c": rng.random(5000).astype(np.float32)})
    yield "texts", pa.table({"task": ["", "slide", "Ä press", "x" * 3000] * 50})
    yield "lists", pa.table({
        "fixed": pa.array(readings.reshape(-1, 12).tolist(), pa.list_(pa.float64())),
        "names": pa.array([["taxel"] * (i % 4) for i in range(500)], pa.list_(pa.string())),
        "float": pa.array([[float(i)] * (i % 3) for i in range(500)], pa.list_(pa.float32()))})
    yield "constant", pa.table({"a": [7] * 70000, "b": [0.25] * 70000})
    yield "empty", pa.table({"a": pa.array([], pa.int64()), "b": pa.array([], pa.list_(pa.float64()))})
    yield "one", pa.table({"a": [1], "b": [[2.5, 3.5]]})


def same_bits(left, right):
    """Compares values, and numbers by their bits."""
    def flat(column):
        column = column.combine_chunks()
        lengths = column.value_lengths().to_pylist() if pa.types.is_list(column.type) else None
        values = column.flatten() if lengths is not None else column
        kind = {"double": "d", "float": "f"}.get(str(values.type))
        plain = values.to_pylist()
        return lengths, [struct.pack(kind, v) for v in plain] if kind else plain
    if left.column_names != right.column_names or left.num_rows != right.num_rows:
        return False
    return all(flat(left[name]) == flat(right[name]) for name in left.column_names)


def copy(source, target):
    return subprocess.run([COPY, source, target], capture_output=True, text=True)


def check_copies(folder):
    styles = {
        "dictionary": dict(use_dictionary=True), "plain": dict(use_dictionary=False), "groups": dict(row_group_size=700),
        "small pages": dict(data_page_size=1000), "uncompressed": dict(compression="none"),
        "level 19": dict(compression_level=19)}
    for name, table in tables():
        for style, options in styles.items():
            source, target = folder / "in.parquet", folder / "out.parquet"
            pq.write_table(table, source, **{"compression": "zstd", **options})
            result = copy(source, target)
            assert result.returncode == 0, f"{name}, {style}: {result.stderr}"
            assert same_bits(pq.read_table(source), pq.read_table(target)), f"{name}, {style}: another table"
            again = folder / "again.parquet"
            assert copy(target, again).returncode == 0 and again.read_bytes() == target.read_bytes(), f"{name}, {style}"
    split = pa.table({"a": np.random.default_rng(1).random(3000)})
    pq.write_table(split, source, compression="zstd", use_dictionary=False, column_encoding={"a": "BYTE_STREAM_SPLIT"})
    assert copy(source, target).returncode == 0 and same_bits(split, pq.read_table(target)), "split streams"
    counted = pa.table({"a": np.concatenate([np.arange(5000), np.random.default_rng(2).integers(-(2**63), 2**63 - 1, 300)])})
    pq.write_table(counted, source, compression="zstd", use_dictionary=False, column_encoding={"a": "DELTA_BINARY_PACKED"})
    assert copy(source, target).returncode == 0 and same_bits(counted, pq.read_table(target)), "differences"


def check_refusals(folder):
    source, target = folder / "in.parquet", folder / "refused.parquet"
    table = pa.table({"a": [1.5, 2.5]})
    cases = {
        "is compressed by method 1": (table, dict(compression="snappy")),
        "has a page of version 2": (table, dict(compression="zstd", data_page_version="2.0")),
        "has a missing value": (pa.table({"a": [1.5, None]}), dict(compression="zstd")),
        "has a type that is not read": (pa.table({"a": [True, False]}), dict(compression="zstd")),
        "is a structure": (pa.table({"a": [{"x": 1, "y": 2}]}), dict(compression="zstd")),
        "is a list of lists": (pa.table({"a": [[[1.5]]]}), dict(compression="zstd")),
        "has the encoding 7": (pa.table({"a": ["x", "xy"]}), dict(compression="zstd", use_dictionary=False,
                                                                  column_encoding={"a": "DELTA_BYTE_ARRAY"}))}
    for message, (refused, options) in cases.items():
        pq.write_table(refused, source, **options)
        result = copy(source, target)
        assert result.returncode == 2 and message in result.stderr, f"{message}: {result.stderr}"
        assert str(source) in result.stderr and not target.exists(), result.stderr


with tempfile.TemporaryDirectory() as name:
    check_copies(pathlib.Path(name))
    check_refusals(pathlib.Path(name))
print(f"pyarrow {pa.__version__} reads and writes the same tables")
