"""Answers that are kept: a stateless calculation is a pure function of the bytes asked and the catalogue loaded.

The same question therefore gets the same bytes without being calculated again, as long as neither changes. The store
is bounded in entries and bytes, oldest use first out, and belongs to one process.
"""

import hashlib
import threading
from collections import OrderedDict

MAX_ENTRIES = 512
MAX_BYTES = 64 * 1024 * 1024


class AnswerCache:
    """Bodies of successful answers by (kind of question, catalogue version, question)."""

    def __init__(self, max_entries: int = MAX_ENTRIES, max_bytes: int = MAX_BYTES) -> None:
        self._max_entries = max_entries
        self._max_bytes = max_bytes
        self._kept: OrderedDict[bytes, bytes] = OrderedDict()
        self._bytes = 0
        self._lock = threading.Lock()

    @staticmethod
    def key(kind: str, version: str, question: bytes) -> bytes:
        """What identifies an answer."""
        return hashlib.blake2b(f"{kind}\0{version}\0".encode() + question, digest_size=32).digest()

    def get(self, key: bytes) -> bytes | None:
        """The kept answer, or None."""
        with self._lock:
            found = self._kept.get(key)
            if found is not None:
                self._kept.move_to_end(key)
            return found

    def put(self, key: bytes, answer: bytes) -> None:
        """Keep an answer; one that would fill a quarter of the store alone is not kept."""
        if len(answer) * 4 > self._max_bytes:
            return
        with self._lock:
            old = self._kept.pop(key, b"")
            self._kept[key] = answer
            self._bytes += len(answer) - len(old)
            while len(self._kept) > self._max_entries or self._bytes > self._max_bytes:
                _, dropped = self._kept.popitem(last=False)
                self._bytes -= len(dropped)
