"""What every request passes: a limit on its body, a look at its address, and headers that browsers obey."""

from starlette.datastructures import MutableHeaders
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.web.errors import TooLargeError, problem, respond

SECURITY_HEADERS = {
    # Plotly writes style attributes; everything else comes from this server only.
    "content-security-policy": (
        "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; object-src 'none'; "
        "base-uri 'none'; form-action 'self'; frame-ancestors 'none'"
    ),
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",  # the address of a project is its key
    "cross-origin-opener-policy": "same-origin",
}
DRAINED_BYTES = 32 * 1024 * 1024
"""So much of a refused body is read and dropped: most clients look at the answer only after they have sent all."""


class Guard:
    """Limits bodies on the stream, refuses NUL in addresses and adds the headers for browsers."""

    def __init__(self, app: ASGIApp, max_body_bytes: int) -> None:
        self._app = app
        self._limit = max_body_bytes

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in SECURITY_HEADERS.items():
                    headers.setdefault(name, value)
            await send(message)

        if "\0" in scope["path"] or b"%00" in scope["query_string"]:
            refused = respond(Request(scope), problem(400, "The address holds a NUL character."))
            await refused(scope, receive, send_with_headers)
            return
        length = dict(scope["headers"]).get(b"content-length", b"0")
        too_large = length.isdigit() and int(length[:20]) > self._limit
        if too_large:
            await _drain(receive)
            error = TooLargeError(self._limit)
            refused = respond(Request(scope), problem(413, error.detail))
            await refused(scope, receive, send_with_headers)
            return
        await self._app(scope, self._counting(receive), send_with_headers)

    def _counting(self, receive: Receive) -> Receive:
        """The stream of the body, cut off with TooLargeError where it passes the limit."""
        seen = 0

        async def counted() -> Message:
            nonlocal seen
            message = await receive()
            seen += len(message.get("body", b""))
            if seen > self._limit:
                if message.get("more_body"):
                    await _drain(receive)
                raise TooLargeError(self._limit)
            return message

        return counted


async def _drain(receive: Receive) -> None:
    seen = 0
    while seen <= DRAINED_BYTES:
        message = await receive()
        seen += len(message.get("body", b""))
        if message["type"] != "http.request" or not message.get("more_body"):
            return
