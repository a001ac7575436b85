"""Files that appear in a folder together: they are written next to their places, and moved when all are complete."""

from __future__ import annotations

import contextlib
import dataclasses
import fcntl
import hashlib
import json
import os
import pathlib
import shutil
import typing

from taxel import json_text
from taxel.errors import Error

_OWN = ".data_set"


@dataclasses.dataclass(frozen=True)
class PublishedFile:
    """A file as it was written."""

    name: str  #: path below the folder
    bytes: int
    sha256: str


def described(folder: pathlib.Path, name: str) -> PublishedFile:
    """Returns the description of a file. Raises Error that names it."""
    path = folder / name
    try:
        with path.open("rb") as file:
            return PublishedFile(name, path.stat().st_size, hashlib.file_digest(file, "sha256").hexdigest())
    except OSError as error:
        raise Error(str(path), "", f"cannot be read: {error.strerror or error}") from error


def read_descriptions(entries: typing.Any) -> set[PublishedFile]:
    """Returns the descriptions in a JSON list. Raises ValueError if it is of something else."""
    if not isinstance(entries, list):
        raise ValueError("must be a list")
    files = set()
    for entry in entries:
        if not isinstance(entry, dict) or set(entry) != {"name", "bytes", "sha256"}:
            raise ValueError("must have name, bytes and sha256 of each file")
        file = PublishedFile(**entry)
        if [type(value) for value in dataclasses.astuple(file)] != [str, int, str]:
            raise ValueError("must have two texts and a number of each file")
        if ".." in file.name.split("/") or file.name.startswith("/"):
            raise ValueError("must have names below the folder")
        files.add(file)
    return files


class PublishedFolder:
    """A folder whose files are published. As a context manager, it is locked against other processes.

    Errors of the system are raised as Error that names the file.
    """

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        self.staging = folder / _OWN / "files"  #: files before they are moved to their places
        self._list = folder / _OWN / "files.json"
        self._lock = -1
        self._is_new = False

    def __enter__(self) -> PublishedFolder:
        with self._errors(self.folder):
            self._is_new = not self.folder.exists()
            self.folder.mkdir(parents=True, exist_ok=True)
            self._lock = os.open(self.folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            self._check_own()
        except BlockingIOError as error:
            os.close(self._lock)
            raise Error(str(self.folder), "", "another process writes a data set into this folder: wait for its end") from error
        except BaseException:
            os.close(self._lock)
            raise
        return self

    def __exit__(self, *_: object) -> None:
        """Removes what is not published, but for the list of files that an interrupted call has moved."""
        shutil.rmtree(self.staging, ignore_errors=True)
        with contextlib.suppress(OSError):
            (self.folder / _OWN).rmdir()
        if self._is_new:
            with contextlib.suppress(OSError):
                self.folder.rmdir()
        os.close(self._lock)

    def interrupted(self) -> set[PublishedFile]:
        """Returns the files that an interrupted call was moving to their places, or has replaced."""
        try:
            return read_descriptions(json.loads(self._list.read_bytes()))
        except FileNotFoundError:
            return set()
        except (OSError, ValueError) as error:
            raise Error(str(self._list), "", f"is damaged ({error}): remove it") from error

    def missing(self, files: typing.Iterable[PublishedFile]) -> bool:
        """Returns whether a file is gone, or is one of interrupted(). Raises Error that names another file which is not as
        it was written.
        """
        is_missing = False
        interrupted = self.interrupted()
        for file in sorted(files, key=lambda file: file.name):
            if not os.path.lexists(self.folder / file.name):
                is_missing = True
                continue
            existing = described(self.folder, file.name)
            if existing != file and existing in interrupted:
                is_missing = True
            elif existing != file:
                raise Error(str(self.folder / file.name), "", "is not as it was written: remove it to have it written again, "
                                                              "or give another folder")
        return is_missing

    def empty_staging(self) -> pathlib.Path:
        """Returns the empty folder for the files."""
        with self._errors(self.staging):
            if self.staging.exists():
                shutil.rmtree(self.staging)
            self.staging.mkdir(parents=True)
        return self.staging

    def staged(self) -> list[PublishedFile]:
        """Returns the files in the staging folder."""
        names = (path.relative_to(self.staging).as_posix() for path in self.staging.rglob("*") if path.is_file())
        return [described(self.staging, name) for name in sorted(names)]

    def publish(self, files: typing.Sequence[PublishedFile], known: set[PublishedFile], last: str) -> None:
        """Moves staged files to their places, `last` last. Replaces only equal files and those of `known`, the files of
        earlier calls; raises Error naming another one before any file is moved.
        """
        for file in files:
            if not os.path.lexists(self.folder / file.name):
                continue
            existing = described(self.folder, file.name)
            if existing != file and existing not in known:
                raise Error(str(self.folder / file.name), "", "exists, and is not of this data set: remove it, or give "
                                                              "another folder")
        with self._errors(self._list):
            self._write_list(known | set(files))
        with self._errors(self.folder / last):
            (self.folder / last).unlink(missing_ok=True)  # the set is not complete until it is there again
        names = {file.name for file in files}
        for old in known:
            if old.name not in names and (self.folder / old.name).exists() and described(self.folder, old.name) == old:
                with self._errors(self.folder / old.name):
                    (self.folder / old.name).unlink()
        for name in sorted(names, key=lambda name: (name == last, name)):
            with self._errors(self.folder / name):
                (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
                (self.staging / name).replace(self.folder / name)
        self.forget_interrupted()

    def forget_interrupted(self) -> None:
        """Removes the list of interrupted(), because all files are in their places."""
        with self._errors(self._list):
            self._list.unlink(missing_ok=True)

    def _write_list(self, files: set[PublishedFile]) -> None:
        temporary = self._list.with_suffix(".tmp")
        entries = [dataclasses.asdict(file) for file in sorted(files, key=lambda file: (file.name, file.sha256))]
        with temporary.open("w", encoding="utf-8") as stream:
            stream.write(json_text.document(entries) + "\n")
            stream.flush()
            os.fsync(stream.fileno())
        temporary.replace(self._list)

    def _check_own(self) -> None:
        """Raises Error if the name of the staging folder is taken by something else."""
        own = self.folder / _OWN
        has_other = own.is_dir() and {path.name for path in own.iterdir()} - {"files", "files.json", "files.tmp"}
        if own.is_symlink() or (own.exists() and not own.is_dir()) or has_other:
            raise Error(str(own), "", "is of something else, and data sets are prepared in a folder of this name: remove it")

    @contextlib.contextmanager
    def _errors(self, path: pathlib.Path) -> typing.Iterator[None]:
        try:
            yield
        except OSError as error:
            raise Error(str(path), "", f"cannot be written: {error.strerror or error}") from error
