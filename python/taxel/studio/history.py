"""Readings of the last seconds, for the plot."""

from __future__ import annotations

import numpy as np

_NUMBERS = 4_000_000  # most numbers that a history holds


class History:
    """Rows of readings by ascending time. The oldest rows are dropped."""

    def __init__(self, columns: int) -> None:
        self._capacity = int(np.clip(_NUMBERS // max(columns, 1), 1000, 20000))
        self._times = np.empty(2 * self._capacity)
        self._rows = np.empty((2 * self._capacity, columns), np.float32)
        self._end = 0

    def __len__(self) -> int:
        return min(self._end, self._capacity)

    @property
    def times(self) -> np.ndarray:
        """Times of the rows [s], ascending, shape (k,)."""
        return self._times[self._end - len(self) : self._end]

    @property
    def rows(self) -> np.ndarray:
        """Readings, shape (k, n), single precision."""
        return self._rows[self._end - len(self) : self._end]

    def append(self, time: float, row: np.ndarray) -> None:
        """Appends a row. Rows of the same time and of later times are removed first: the user went back."""
        while self._end > 0 and self._times[self._end - 1] >= time:
            self._end -= 1
        if self._end == len(self._times):
            self._times[: self._capacity] = self._times[self._capacity :]
            self._rows[: self._capacity] = self._rows[self._capacity :]
            self._end = self._capacity
        self._times[self._end] = time
        self._rows[self._end] = row
        self._end += 1

    def curves(self, seconds: float, points: int) -> tuple[np.ndarray, np.ndarray]:
        """Returns times (p,) and readings (p, n) of the last `seconds`, at most `points` + 1 rows.

        Neighbouring rows become one row with their largest readings, so that no peak is lost.
        """
        if len(self) == 0:
            return self.times, self.rows
        first = int(np.searchsorted(self.times, self.times[-1] - seconds))
        times, rows = self.times[first:], self.rows[first:]
        group = -(-len(times) // points)
        if group <= 1:
            return times, rows
        # Groups begin at multiples of their size, so that a curve does not flicker while it moves.
        skipped = (self._end - len(times)) % group
        starts = np.concatenate([[0], np.arange(group - skipped, len(times), group)]) if skipped else np.arange(0, len(times), group)
        return times[starts], np.maximum.reduceat(rows, starts, axis=0)
