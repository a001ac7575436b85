"""The process of `taxel batch` with --events: it keeps the journal and writes the lists of the batch."""

from __future__ import annotations

import json
import queue
import subprocess
import sys
import tempfile
import threading
import typing

from taxel import programs

Event = typing.Dict[str, typing.Any]


class BatchProcess:
    """Runs `taxel batch`. As a context manager, it raises Error at the end if the program has failed, and ends the
    program if the block raises. Finished groups are kept in any case.
    """

    def __init__(self, arguments: typing.Sequence[str], files: typing.Mapping[str, str], remote: bool = False,
                 policy: bool = False) -> None:
        """Starts the program. With `remote`, its events "group" are to be answered by send_shard() or send_failure(), with
        `policy` its events "observation" by send_action()."""
        command = [str(programs.path_of("taxel")), "batch", *arguments, "--events", "--quiet"]
        self._files = files
        self._messages = tempfile.TemporaryFile()
        command += [flag for flag, is_set in {"--remote": remote, "--policy": policy}.items() if is_set]
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE if remote or policy else subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=self._messages,
        )
        self._events: queue.Queue[Event | None] = queue.Queue()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        self._has_ended = False

    def __enter__(self) -> BatchProcess:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if kind is not None:
            self._process.terminate()
        if self._process.stdin is not None:
            self._close_input()
        status = self._process.wait()
        self._reader.join()
        self._process.stdout.close()
        with self._messages as file:
            file.seek(0)
            messages = file.read().decode("utf-8", "replace")
        if kind is None and status not in (0, 1):  # 1: some jobs have failed, and the batch is complete
            raise programs.error_of(["batch"], messages, status, self._files)

    def next_event(self, timeout: float | None = None) -> Event | None:
        """Returns the next event; None if none comes within `timeout` seconds, or at the end. Prints notes."""
        try:
            event = self._events.get_nowait() if timeout == 0 else self._events.get(timeout=timeout)
        except queue.Empty:
            return None
        if event is None:
            self._has_ended = True
        elif event["event"] == "note":
            print(f"taxel: {event['message']}", file=sys.stderr)
        return event

    @property
    def has_ended(self) -> bool:
        """True after next_event() has returned the last event."""
        return self._has_ended

    def all_events(self) -> typing.Iterator[Event]:
        """Yields all events until the end of the program."""
        while not self._has_ended:
            event = self.next_event()
            if event is not None:
                yield event

    def send_shard(self, group: str, shard: bytes) -> None:
        self._send({"group": group, "bytes": len(shard)}, shard)

    def send_failure(self, group: str, reason: str) -> None:
        self._send({"group": group, "error": reason})

    def send_action(self, job: str, action: list[float]) -> None:
        self._send({"job": job, "action": action})

    def _send(self, reply: Event, shard: bytes = b"") -> None:
        try:
            self._process.stdin.write(json.dumps(reply).encode() + b"\n" + shard)
            self._process.stdin.flush()
        except BrokenPipeError:
            pass  # the program has failed: its last event follows, and its message is raised at the end

    def _close_input(self) -> None:
        try:
            self._process.stdin.close()
        except BrokenPipeError:
            pass

    def _read(self) -> None:
        for line in self._process.stdout:
            self._events.put(json.loads(line))
        self._events.put(None)
