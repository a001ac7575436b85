"""A process of `taxel batch --worker`, which keeps compiled layouts and runs one group of jobs after the other."""

from __future__ import annotations

import collections
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import typing

from taxel import programs
from taxel.errors import Error

#: Returns the bytes of a file by their SHA-256.
Fetch = typing.Callable[[str], bytes]
Package = typing.Dict[str, typing.Any]


class WorkerEnded(Exception):
    """The process has ended while it ran the job with the index `job` of its group."""

    def __init__(self, job: int, reason: str) -> None:
        super().__init__(job, reason)
        self.job = job
        self.reason = reason


def reason_of_ends(count: int, reason: str) -> str:
    """Returns the reason why a job fails whose worker has ended `count` times."""
    return f"the worker that ran this job ended {'once' if count == 1 else f'{count} times'}: {reason}"


class GroupWorker:
    """Runs groups of jobs in a process that lives as long as the object."""

    def __init__(self, max_restarts: int) -> None:
        """A job that ends the process more than `max_restarts` times fails, and the others of its group go on."""
        self._max_restarts = max_restarts
        self._folder = tempfile.TemporaryDirectory(prefix="taxel")
        self._process: subprocess.Popen[bytes] | None = None
        self._messages: typing.IO[bytes] | None = None
        self._versions = ""

    def versions(self) -> str:
        """Returns the versions of the program and of MuJoCo on this machine. Raises Error if it cannot be started."""
        self._start()
        return self._versions

    def run(self, package: Package, fetch: Fetch) -> bytes:
        """Runs a group and returns the bytes of its shard. Raises Error if the program refuses the group."""
        files = {path: self._copy_of(path, sha256, fetch) for path, sha256 in package["files"].items()}
        package = {**package, "files": files}
        ends: collections.Counter[int] = collections.Counter()
        while True:
            try:
                self._start()
                return self._run_once(package)
            except WorkerEnded as ended:
                self._close()
                ends[ended.job] += 1
                if ends[ended.job] > self._max_restarts:
                    package["jobs"][ended.job]["error"] = reason_of_ends(ends[ended.job], ended.reason)

    def close(self) -> None:
        """Ends the process and removes the copies of files."""
        self._close()
        self._folder.cleanup()

    def _copy_of(self, path: str, sha256: str, fetch: Fetch) -> str:
        copy = pathlib.Path(self._folder.name) / sha256 / pathlib.Path(path).name
        if not copy.exists():
            data = fetch(sha256)
            if hashlib.sha256(data).hexdigest() != sha256:
                raise Error(path, "", "has changed since the batch began: run the batch in another folder")
            copy.parent.mkdir(exist_ok=True)
            part = copy.with_name("part")
            part.write_bytes(data)
            os.replace(part, copy)
        return str(copy)

    def _start(self) -> None:
        if self._process is not None:
            return
        command = [str(programs.path_of("taxel")), "batch", "--worker"]
        self._messages = tempfile.TemporaryFile()
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._messages, cwd=self._folder.name
        )
        line = self._process.stdout.readline()
        if not line.endswith(b"\n"):
            reason = self._reason()
            self._close()
            raise Error("", "", f"{command[0]} cannot be started: {reason}")
        self._versions = json.loads(line)["program"]

    def _run_once(self, package: Package) -> bytes:
        process, job = self._process, 0
        try:
            process.stdin.write(json.dumps(package).encode() + b"\n")
            process.stdin.flush()
            while True:
                line = process.stdout.readline()
                if not line.endswith(b"\n"):
                    break
                event = json.loads(line)
                if event["event"] == "job":
                    job += 1
                    continue
                shard = process.stdout.read(event["bytes"])
                if len(shard) == event["bytes"]:
                    return shard
                break
        except BrokenPipeError:
            pass
        reason = self._reason()
        if 0 < process.returncode < 128:  # the program has refused the group, and would do so again
            self._close()
            raise Error("", "", reason)
        raise WorkerEnded(min(job, len(package["jobs"]) - 1), reason)

    def _reason(self) -> str:
        """Waits for the end of the process and returns the reason for it."""
        status = self._process.wait()
        self._messages.seek(0)
        lines = self._messages.read().decode("utf-8", "replace").splitlines()
        if status < 0:
            try:
                return f"by the signal {signal.Signals(-status).name}"
            except ValueError:
                return f"by the signal {-status}"
        return lines[-1].removeprefix("taxel: ") if lines else f"with the status {status}"

    def _close(self) -> None:
        if self._process is None:
            return
        self._process.kill()
        for stream in (self._process.stdin, self._process.stdout, self._messages):
            try:
                stream.close()
            except BrokenPipeError:
                pass
        self._process.wait()
        self._process = None
