"""Server of the viewer on one port of this machine: access control and messages.

Clients without the token receive only the page itself. The token is in the part of the address behind #, which browsers
do not send, and is the first message of the page. Messages of the browser are JSON; they are not evaluated.
"""

from __future__ import annotations

import asyncio
import hmac
import json
import secrets
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from http import HTTPStatus
from pathlib import Path
from typing import Any

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.datastructures import Headers
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response

from dalembert._live.connection import PageConnection
from dalembert._live.messages import Picture, Piece

HOST = "127.0.0.1"
LONGEST = 1 << 20  # bytes of a message from a page
PAGES = 16  # maximum number of simultaneous connections
PATIENCE = 5.0  # s, for the token
WAITING = 64  # messages for a page that does not read
SILENCE = 600.0  # s, after which a page is lost: behind a slow line, an answer comes after all of a large scene

FOLDER = Path(__file__).resolve().parent.parent / "_pictures" / "page"
FILES = {"/": ("live.html", "text/html"), "/bundle.js": ("bundle.js", "text/javascript")}


@dataclass(eq=False)
class Page:
    """A connected browser; `ready`: it has drawn the last message."""

    number: int
    connection: PageConnection
    ready: bool = True
    scene: int = -1
    picture: int = 0  # the last that it was sent
    waiting: int = 0
    tasks: set[asyncio.Task[None]] = field(default_factory=set)


class PageServer:
    """Runs in a thread of its own; `receive(page number, message)` is called there, and has to be quick."""

    def __init__(self, receive: Callable[[int, dict[str, Any]], None], port: int = 0, shows: str = "live") -> None:
        """`shows`: "live", the systems of a viewer, or "monitor", curves."""
        self._shows = shows
        self.token = secrets.token_urlsafe(24)
        self.port = 0
        self._receive, self._pages, self._count, self._open = receive, dict[int, Page](), 0, 0
        self._newest, self._published = Picture(-1, bytes, ()), 0  # and how many there have been
        self._lock = threading.RLock()  # guards the state of the messages
        self._loop = asyncio.new_event_loop()
        self._waking = threading.Lock()  # other threads write to a socket of the loop, which must not be closed by then
        self._started: threading.Event = threading.Event()
        self._failure: Exception | None = None
        self._thread = threading.Thread(target=self._run, args=(port,), name="dalembert page", daemon=True)
        self._thread.start()
        self._started.wait()
        if self._failure is not None:
            raise self._failure

    @property
    def address(self) -> str:
        """Return the address of the page, with its token."""
        return f"http://{HOST}:{self.port}/#{self.token}"

    @property
    def pages(self) -> int:
        """Return how many pages are open."""
        return len(self._pages)

    @property
    def wanted(self) -> bool:
        """Return whether a page waits for something to draw."""
        return any(page.ready for page in list(self._pages.values()))

    def answers(self) -> bool:
        """Return whether messages can be received now; always true for a server with its own thread."""
        return True

    def publish(self, picture: Picture) -> None:
        """Send a frame, or the whole scene to browsers with another scene; busy browsers receive it when they are
        ready."""
        with self._lock:
            self._newest, self._published = picture, self._published + 1
            for page in list(self._pages.values()):
                self._show(page)

    def tell(self, message: dict[str, Any], page: int | None = None) -> None:
        """Send a message to one page, or to all."""
        self._do(self._tell, json.dumps(message), page)

    def stop(self) -> None:
        """Close all pages and the port."""
        self._do(self._end.set)
        self._thread.join(2.0)

    def _do(self, function: Callable[..., object], *arguments: Any) -> None:
        with self._waking:
            if not self._loop.is_closed():
                self._loop.call_soon_threadsafe(function, *arguments)

    # ---- called in the thread of the server --------------------------------------------------------------------------

    def _run(self, port: int) -> None:
        try:
            self._loop.run_until_complete(self._serve(port))
        except Exception as error:  # OSError: the port is in use
            self._failure = error
        finally:
            self._started.set()
            if rest := asyncio.all_tasks(self._loop):  # tasks of connections that are being closed
                self._loop.run_until_complete(asyncio.wait(rest, timeout=1.0))
            with self._waking:
                self._loop.close()

    async def _serve(self, port: int) -> None:
        self._end = asyncio.Event()
        options: dict[str, Any] = {"compression": None, "max_size": LONGEST, "process_request": self._answer}
        options |= {"ping_timeout": SILENCE, "close_timeout": 1, "server_header": None}
        options["create_connection"] = PageConnection
        async with serve(self._talk, HOST, port, **options) as server:
            self.port = _port(server)
            self._hosts = {f"{HOST}:{self.port}", f"localhost:{self.port}"}
            self._started.set()
            await self._end.wait()

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """Serve the page to requests with a name of this machine; only pages of this server may open the socket."""
        if request.headers.get("Host") not in self._hosts:
            return connection.respond(HTTPStatus.FORBIDDEN, "unknown host\n")
        if request.path == "/socket":
            allowed = request.headers.get("Origin") in {f"http://{host}" for host in self._hosts}
            return None if allowed else connection.respond(HTTPStatus.FORBIDDEN, "unknown origin\n")
        if request.path not in FILES:
            return connection.respond(HTTPStatus.NOT_FOUND, "not found\n")
        name, kind = FILES[request.path]
        return self._file(self._filled((FOLDER / name).read_text("utf-8")), kind)

    def _filled(self, text: str) -> bytes:
        return text.replace("@STYLE@", _style()).replace("@SHOWS@", self._shows).encode()

    def _file(self, data: bytes, kind: str) -> Response:
        sockets = " ".join(f"ws://{host}" for host in sorted(self._hosts))
        policy = (
            f"default-src 'none'; script-src 'self'; style-src 'unsafe-inline'; img-src data: blob:; "
            f"connect-src {sockets}; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
        )
        headers = Headers(
            {
                "Content-Type": f"{kind}; charset=utf-8",
                "Content-Length": str(len(data)),
                "Cache-Control": "no-store",
                "Content-Security-Policy": policy,
                "Cross-Origin-Resource-Policy": "same-origin",
                "Referrer-Policy": "no-referrer",
                "X-Content-Type-Options": "nosniff",
                "X-Frame-Options": "DENY",
            }
        )
        return Response(HTTPStatus.OK, "OK", headers, data)

    async def _talk(self, connection: ServerConnection) -> None:
        assert isinstance(connection, PageConnection)
        if self._open >= PAGES:
            await connection.close(1013, "too many pages")
            return
        self._open += 1
        page = None
        try:
            if not await self._knows_token(connection):
                await connection.close(1008, "wrong token")
                return
            self._count += 1
            page = self._pages[self._count] = Page(self._count, connection)
            connection.on_shown = partial(self._shown, page)
            self._receive(page.number, {"kind": "opened"})
            async for text in connection:
                self._take(page, text)
        except ConnectionClosed:
            pass
        finally:
            self._open -= 1
            connection.end_pictures()
            if page is not None:
                del self._pages[page.number]
                self._receive(page.number, {"kind": "closed"})

    async def _knows_token(self, connection: ServerConnection) -> bool:
        try:
            first = _message(await asyncio.wait_for(connection.recv(), PATIENCE))
        except TimeoutError:
            return False
        token = first.get("token") if first.get("kind") == "hello" else None
        return isinstance(token, str) and hmac.compare_digest(token.encode(), self.token.encode())

    def _take(self, page: Page, text: str | bytes) -> None:
        message = _message(text)
        if message.get("kind") == "shown":
            self._shown(page)
        elif message:
            self._receive(page.number, message)

    def _shown(self, page: Page) -> None:
        with self._lock:
            page.ready = True
            self._show(page)

    def _show(self, page: Page) -> None:
        """Send the newest picture to a browser that is ready and does not have it; the caller has the lock."""
        picture, number = self._newest, self._published
        if page.ready and page.picture < number:
            if page.scene != picture.scene:
                pieces: Sequence[Piece] = [picture.whole()]
            else:
                pieces = picture.after(page.picture == number - 1)
            page.ready, page.picture, page.scene = False, number, picture.scene
            page.connection.send_picture(pieces)

    def _tell(self, text: str, number: int | None) -> None:
        for page in list(self._pages.values()):
            if number in (None, page.number) and page.waiting < WAITING:
                self._send(page, text)

    def _send(self, page: Page, data: bytes | str) -> None:
        page.waiting += 1
        task = self._loop.create_task(self._deliver(page, data))
        page.tasks.add(task)
        task.add_done_callback(page.tasks.discard)

    async def _deliver(self, page: Page, data: bytes | str) -> None:
        try:
            await page.connection.send(data)
        except ConnectionClosed:
            pass
        finally:
            page.waiting -= 1


def _style() -> str:
    return (FOLDER / "style.css").read_text("utf-8")


def _port(server: Server) -> int:
    return int(next(iter(server.sockets)).getsockname()[1])


def _message(text: str | bytes) -> dict[str, Any]:
    """Return a message; {} if it is invalid."""
    if not isinstance(text, str):
        return {}
    try:
        message = json.loads(text)
    except (ValueError, RecursionError):
        return {}
    return message if isinstance(message, dict) and isinstance(message.get("kind"), str) else {}
