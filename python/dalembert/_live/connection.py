"""The socket of a page: pictures are written to it by the thread that has drawn them, which need not wake another one.

All else is written in the thread of the server, by the library. A lock keeps messages whole.
"""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Sequence
from typing import Any

from websockets.asyncio.server import ServerConnection
from websockets.frames import Frame, Opcode
from websockets.protocol import State

from dalembert._live.messages import Piece

SHOWN = b'{"kind":"shown"}'  # message of the browser after each picture
MOST_PIECES = 500  # maximum number of pieces of a message in one call
BINARY = 0x82  # first byte of the head of a message that is one piece


class PageConnection(ServerConnection):
    """Connection of a page; `on_shown` is called in the thread of the server when the page has drawn a picture."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        """Same arguments as in the library."""
        super().__init__(*arguments, **options)
        self.on_shown: Callable[[], object] | None = None
        self._writing = threading.RLock()
        self._socket: socket.socket | None = None
        self._busy = True  # something may be waiting to be written in the thread of the server
        self._rest: list[Piece] = []  # pieces of pictures that could not be written at once

    def send_picture(self, pieces: Sequence[Piece]) -> None:
        """Send a binary message; callable from any thread. It does not wait: remaining data is written later."""
        if len(pieces) > MOST_PIECES:
            pieces = [b"".join(pieces)]
        size = sum(map(len, pieces))
        rest: list[Piece] = [_head(size), *pieces]
        size += len(rest[0])
        with self._writing:
            if self.state is not State.OPEN or self.transport.is_closing():
                return
            sent = 0
            if self._socket is not None and not self._busy and not self._rest:
                try:
                    sent = self._socket.sendmsg(rest)
                except BlockingIOError:
                    pass
                except OSError:
                    return  # it is lost, as the library will see
            if sent < size:
                while sent >= len(rest[0]):
                    sent -= len(rest.pop(0))
                self._rest += [memoryview(rest[0])[sent:], *rest[1:]]
                self.loop.call_soon_threadsafe(self.send_data)

    def end_pictures(self) -> None:
        """Stop sending pictures; called before the connection ends."""
        with self._writing:
            self._rest.clear()
            self._busy = True
            if self._socket is not None:
                self._socket.close()
                self._socket = None

    # ---- called in the thread of the server --------------------------------------------------------------------------

    def connection_made(self, transport: Any) -> None:
        """Keep a socket of its own for pictures, where one can write several pieces at once."""
        super().connection_made(transport)
        if hasattr(socket.socket, "sendmsg"):
            self._socket = transport.get_extra_info("socket").dup()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget pictures."""
        self.end_pictures()
        super().connection_lost(exc)

    def send_data(self) -> None:
        """Write data of the library, after the remaining pictures."""
        with self._writing:
            if not self.transport.is_closing():
                for part in self._rest:
                    self.transport.write(part)
            self._rest.clear()
            super().send_data()
            self._look_whether_busy()

    def process_event(self, event: Any) -> None:
        """Handle the most frequent message at once, without the task that waits for messages."""
        heard = isinstance(event, Frame) and event.opcode is Opcode.TEXT and event.fin and event.data == SHOWN
        if self.on_shown is None or not heard:
            super().process_event(event)
            return
        with self._writing:
            self._look_whether_busy()
        self.on_shown()

    def _look_whether_busy(self) -> None:
        self._busy = self._socket is None or self.transport.get_write_buffer_size() > 0


def _head(size: int) -> bytes:
    if size < 126:
        return bytes([BINARY, size])
    return (
        bytes([BINARY, 126]) + size.to_bytes(2, "big")
        if size < 1 << 16
        else bytes([BINARY, 127]) + size.to_bytes(8, "big")
    )
