"""Runs the groups of a batch in the actors of a Ray cluster. This process keeps the journal and writes the lists."""

from __future__ import annotations

import collections
import hashlib
import pathlib
import re
import sys
import typing

from taxel.batch_process import BatchProcess
from taxel.errors import Error
from taxel.group_worker import GroupWorker, reason_of_ends

#: Answer of an actor: ("ready", versions), ("shard", bytes) or ("error", reason).
Answer = typing.Tuple[str, typing.Any]


class GroupActor:
    """A Ray actor with one worker process. Its methods raise nothing, so that an exception means a lost actor."""

    def __init__(self, max_restarts: int) -> None:
        self._worker = GroupWorker(max_restarts)

    def start(self) -> Answer:
        """Starts the process, and returns the versions of its program."""
        try:
            return "ready", self._worker.versions()
        except Error as error:
            return "error", str(error)

    def run(self, package: dict[str, typing.Any], files: dict[str, typing.Any]) -> Answer:
        """Runs a group. `files` are references of Ray to the bytes of files by their SHA-256."""
        import ray

        try:
            return "shard", self._worker.run(package, lambda sha256: ray.get(files[sha256]))
        except Error as error:
            return "error", str(error)


def run_on_ray(
    arguments: list[str],
    files: dict[str, str],
    watch: typing.Callable[[dict[str, typing.Any]], None],
    workers: int | None,
    max_restarts: int,
) -> None:
    """Runs `taxel batch` with these arguments on the cluster to which Ray is connected, or on a new one here."""
    ray = _import_ray()
    is_own = not ray.is_initialized()
    if is_own:
        ray.init(include_dashboard=False, configure_logging=False, log_to_driver=False)
    try:
        count = workers if workers is not None else max(1, int(ray.cluster_resources().get("CPU", 1)))
        # A few more groups than actors are out, so that an actor that becomes free has its next group at once.
        out_at_a_time = min(4096, count + count // 8 + 1)
        with BatchProcess([*arguments, "--workers", str(out_at_a_time)], files, remote=True) as process:
            pool = _ActorPool(ray, process, count, max_restarts)
            try:
                pool.run(watch)
            finally:
                pool.close()
    finally:
        if is_own:
            ray.shutdown()


def _import_ray() -> typing.Any:
    try:
        import ray
    except ImportError as error:
        raise Error("", "executor", f'"ray" needs Ray: pip install "ray>=2.60" ({error})') from error
    return ray


def _without_colors(text: str) -> str:
    return re.sub(r"\x1b\[[0-9;]*m", "", text)


class _ActorPool:
    """Gives groups to actors, one at a time to each, and their answers to the program."""

    def __init__(self, ray: typing.Any, process: BatchProcess, count: int, max_restarts: int) -> None:
        self._ray = ray
        self._process = process
        self._max_restarts = max_restarts
        self._versions = ""
        self._groups: collections.deque[dict[str, typing.Any]] = collections.deque()
        self._files: dict[str, typing.Any] = {}
        actor = ray.remote(num_cpus=1, max_restarts=max_restarts, max_task_retries=max_restarts)(GroupActor)
        self._actors = [actor.remote(max_restarts) for _ in range(count)]
        self._idle: list[typing.Any] = []
        # The actor and the group of each task. The first task of an actor has no group.
        self._tasks = {actor.start.remote(): (actor, None) for actor in self._actors}

    def run(self, watch: typing.Callable[[dict[str, typing.Any]], None]) -> None:
        """Runs until the program has ended. Raises Error if no actor is left."""
        while not self._process.has_ended:
            self._take_events(watch)
            while self._idle and self._groups:
                self._give(self._idle.pop(), self._groups.popleft())
            if self._tasks:
                done, _ = self._ray.wait(list(self._tasks), timeout=0.05)
                for task in done:
                    self._finish(task)

    def close(self) -> None:
        for actor in self._actors:
            self._ray.kill(actor)

    def _take_events(self, watch: typing.Callable[[dict[str, typing.Any]], None]) -> None:
        """Takes the events that are there. Waits for one if no actor works."""
        timeout = 0 if self._tasks and not (self._idle and not self._groups) else 0.02
        while (event := self._process.next_event(timeout)) is not None:
            timeout = 0
            if event["event"] == "group":
                self._groups.append(event["package"])
            elif event["event"] == "program":
                self._versions = event["program"]
            else:
                watch(event)

    def _give(self, actor: typing.Any, group: dict[str, typing.Any]) -> None:
        try:
            files = {sha256: self._reference_to(path, sha256) for path, sha256 in group["files"].items()}
        except Error as error:
            self._idle.append(actor)
            self._process.send_failure(group["group"], str(error))
            return
        self._tasks[actor.run.remote(group, files)] = (actor, group)

    def _reference_to(self, path: str, sha256: str) -> typing.Any:
        """Returns Ray's reference to the bytes of a file, which travel to each node once."""
        if sha256 not in self._files:
            try:
                data = pathlib.Path(path).read_bytes()
            except OSError as error:
                raise Error(path, "", f"cannot be read: {error}") from error
            if hashlib.sha256(data).hexdigest() != sha256:
                raise Error(path, "", "has changed since the batch began: run the batch in another folder")
            self._files[sha256] = self._ray.put(data)
        return self._files[sha256]

    def _finish(self, task: typing.Any) -> None:
        actor, group = self._tasks.pop(task)
        try:
            kind, value = self._ray.get(task)
        except (self._ray.exceptions.RayActorError, self._ray.exceptions.RayTaskError) as error:
            self._lose(actor, group, error)
            return
        if kind == "ready":
            self._check_versions(value)
        elif kind == "shard":
            self._process.send_shard(group["group"], value)
        elif group is None:
            raise Error("", "", f"a Ray worker cannot run: {value}")
        else:
            self._process.send_failure(group["group"], value)
        self._idle.append(actor)

    def _check_versions(self, versions: str) -> None:
        """Other versions may compute other bits."""
        while not self._versions and not self._process.has_ended:
            self._take_events(lambda event: None)
        if self._versions and versions != self._versions:
            raise Error("", "", f"a Ray node has {versions}, this machine has {self._versions}: install one version on all")

    def _lose(self, actor: typing.Any, group: dict[str, typing.Any] | None, error: Exception) -> None:
        """Goes on without an actor that has ended for good."""
        self._actors = [other for other in self._actors if other is not actor]
        text = str(error).strip() or type(error).__name__
        if "No module named 'taxel'" in text:
            raise Error("", "", "a Ray node has no package taxel: install the version of this machine on all nodes") from error
        reason = _without_colors(text.splitlines()[0])
        if not self._actors:
            raise Error("", "", f"all Ray workers have ended, the last one {self._max_restarts + 1} times ({reason}); "
                                "all finished groups are kept, and the same call continues")
        print(f"taxel: a Ray worker is lost, and the others go on: {reason}", file=sys.stderr)
        if group is not None:
            self._process.send_failure(group["group"], reason_of_ends(self._max_restarts + 1, reason))
