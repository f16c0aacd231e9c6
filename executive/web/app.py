"""The addresses of the page's server: the page, what is known of the robot, and what may be asked of it."""

from __future__ import annotations

import json
import logging
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from importlib.resources import files
from types import MappingProxyType
from typing import Final

from pydantic import FiniteFloat, JsonValue, TypeAdapter, ValidationError
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket

from tandem.executive.client.errors import (
    ClientError,
    DeclinedError,
    NotConnectedError,
    RefusedError,
    RejectedError,
    UnknownTaskError,
)
from tandem.executive.render.failure_words import explain, what_next
from tandem.executive.security.links import LinkError
from tandem.executive.web.audience import Audience, FullError
from tandem.executive.web.camera import Camera
from tandem.executive.web.gate import CLOSED, Gate, cookie_of
from tandem.executive.web.history import Filter, Past
from tandem.executive.web.kept_records import Asked, Kept, UnreadableError
from tandem.executive.web.meshes import MEDIA, mesh, named_in
from tandem.executive.web.replay import Move, Replay
from tandem.executive.web.robot import REPLAY, Robot, Who
from tandem.executive.web.sessions import COOKIE, LONGEST, Sessions
from tandem.executive.web.sockets import serve_viewer
from tandem.executive.web.verbs import REQUESTING, VERBS, allowed, in_the_name_of
from tandem.skills.ports.failure import KINDS
from tandem.skills.ports.message import MAX_REQUEST_BYTES
from tandem.skills.ports.problems import problems_of
from tandem.skills.ports.tasks import REQUEST

STATUS: Final[Mapping[type[ClientError], int]] = MappingProxyType(
    {
        RejectedError: 422,
        RefusedError: 409,
        UnknownTaskError: 404,
        DeclinedError: 429,
        NotConnectedError: 503,
    }
)
"""What each error is in HTTP; any other is of another version (502)."""
_LOG = logging.getLogger(__name__)
Pages = Mapping[str, str]
"""Addresses of the pages of other robots of the site, by robot."""
NO_PAGES: Final[Pages] = MappingProxyType({})
BUNDLE: Final = {"app.js": "text/javascript", "app.css": "text/css", "LICENSES.txt": "text/plain"}
"""All files of the page that are served, and their media types; any other name is a 404."""


class WrongError(Exception):
    """A document that can't be taken: its HTTP status and what is told."""

    def __init__(self, status: int, words: str, **more: JsonValue) -> None:
        super().__init__(words)
        self.status, self.told = status, {"error": words, **more}


@dataclass
class Site:
    """What the addresses share."""

    robot: Robot
    audience: Audience
    past: Past = field(default_factory=Past)
    eye: Camera = field(default_factory=Camera)
    kept: Kept = field(default_factory=Kept)
    sessions: Sessions | None = None
    """Who has logged in; None: on this host nobody logs in."""
    named: frozenset[str] = frozenset()
    """Files of the robot's URDF."""
    pages: Pages = field(default_factory=lambda: NO_PAGES)

    async def session(self, request: Request) -> Response:
        """Tell where the robot is, who asks, and which verbs are allowed."""
        where, who, own = self.robot.options, self._who(request), allowed(self.robot.who)
        may: list[JsonValue] = [each for each in allowed(who) if each in own]
        return JSONResponse(
            {
                "site": where.site,
                "robot": where.robot,
                "endpoint": where.endpoint,
                "who": who.name,
                "role": who.role,
                "keys": who.rights is not None,
                "login": self.sessions is not None,
                "may": may,
                "pages": dict(self.pages),
            }
        )

    async def robot_told(self, request: Request) -> Response:
        """Tell who the robot is, with its URDF."""
        del request
        described = await (await self.robot.client()).description()
        self.named = named_in(described.urdf)
        return Response(described.model_dump_json(), media_type="application/json")

    async def place(self, request: Request) -> Response:
        """Tell the place that it works in."""
        del request
        found = await (await self.robot.client()).site()
        return Response(found.model_dump_json(), media_type="application/json")

    async def kinds(self, request: Request) -> Response:
        """Tell the kinds of task with their schemas, and which of them this robot can't do."""
        del request
        client = await self.robot.client()
        offered, info = await client.kinds(), await client.info()
        return JSONResponse({**offered.model_dump(mode="json"), "unable": info.unable})

    async def task(self, request: Request) -> Response:
        """Tell all of one task, with its failure in words."""
        status = await (await self.robot.client()).status(request.path_params["task"])
        told: dict[str, JsonValue] = {
            "status": status.model_dump(mode="json"),
            "words": explain(status),
            "timeline": await self._spans(status.task),
        }
        if status.failure is not None:
            kind = KINDS[status.failure.reason.kind]
            told |= {"next": what_next(status.failure), "meaning": kind.meaning, "helper": str(kind.helper)}
        return JSONResponse(told)

    async def records(self, request: Request) -> Response:
        """Tell which records have a task, and how they are looked at."""
        client = await self.robot.client()
        status = await client.status(request.path_params["task"])
        try:
            return JSONResponse(await self.kept.of(client, status))
        except ClientError:
            return JSONResponse({"boxes": [], "recordings": [], "silent": True})

    async def moment(self, request: Request) -> Response:
        """Tell what was known at a robot time of a task."""
        asked = request.query_params.get("seconds", "")
        try:
            seconds = TypeAdapter(FiniteFloat).validate_strings(asked)
        except ValidationError as error:
            raise WrongError(422, f"seconds: expected robot seconds; found {asked!r}") from error
        client = await self.robot.client()
        status = await client.status(request.path_params["task"])
        moment = Asked(seconds, request.query_params.get("boot", ""))
        try:
            told = await self.kept.moment(client, status, moment)
        except UnreadableError as error:
            raise WrongError(404, str(error)) from error
        return JSONResponse(told)

    async def _spans(self, task: str) -> JsonValue:
        """Return when which node ran; nothing of an executive that does not tell."""
        try:
            found = await (await self.robot.client()).timeline(task)
        except ClientError:
            return []
        return [each.model_dump(mode="json") for each in found.spans]

    async def picture(self, request: Request) -> Response:
        """Send the camera's picture of an attempt."""
        client = await self.robot.client()
        found = await client.picture(request.path_params["task"], request.path_params["number"])
        if not found:
            raise WrongError(404, "the picture is not kept any more")
        return Response(found, media_type="image/jpeg")

    async def camera(self, request: Request) -> Response:
        """Send what a camera sees now."""
        name = request.query_params.get("name", "")
        jpeg, age = await self.eye.picture(await self.robot.client(), name)
        if not jpeg:
            raise WrongError(404, "the camera sends no picture")
        headers = {"Cache-Control": "no-store", "X-Age": f"{age:.1f}"}
        return Response(jpeg, media_type="image/jpeg", headers=headers)

    async def history(self, request: Request) -> Response:
        """Tell the tasks that pass a filter."""
        try:
            wanted = Filter.model_validate_strings(dict(request.query_params))
        except ValidationError as error:
            raise _misshapen(error) from error
        client = await self.robot.client()
        await self.past.refresh(client)
        item = (await client.site()).meant(wanted.item) if wanted.item else None
        also = () if item is None else (item.name, str(item.item))
        return Response(self.past.answer(wanted, also), media_type="application/json")

    async def request(self, request: Request) -> Response:
        """Send a request to the executive."""
        document = await _document(request)
        who = self._allow(request, REQUESTING, REQUEST)
        task = await (await self.robot.client()).submit(in_the_name_of(who, document))
        return JSONResponse({"task": task})

    async def verb(self, request: Request) -> Response:
        """Ask a verb."""
        name = request.path_params["verb"]
        verb = VERBS.get(name)
        if verb is None:
            raise WrongError(404, f"expected one of {', '.join(VERBS)}; found {name!r}")
        document = await _document(request)
        who = self._allow(request, name, verb.key)
        try:
            answer = await verb.ask(await self.robot.client(), who, document)
        except ValidationError as error:
            raise _misshapen(error) from error
        return JSONResponse({"answer": answer})

    async def replay(self, request: Request) -> Response:
        """Go to another moment of a record."""
        if not isinstance(self.robot, Replay):
            raise WrongError(409, "this page shows a robot, not a record")
        try:
            asked = Move.model_validate(await _document(request))
        except ValidationError as error:
            raise _misshapen(error) from error
        self.past = Past()
        return JSONResponse(self.robot.move(asked))

    async def mesh(self, request: Request) -> Response:
        """Send a file that the robot's URDF names."""
        if not self.named:
            await self.robot_told(request)
        found = mesh(request.path_params["path"], self.named)
        if found is None:
            raise WrongError(404, "the robot's description names no such file")
        headers = {"Cache-Control": "max-age=3600"}
        return FileResponse(found, media_type=MEDIA[found.suffix.lower()], headers=headers)

    async def live(self, socket: WebSocket) -> None:
        """Tell one viewer what happens, until it leaves."""
        await socket.accept()
        try:
            viewer = self.audience.enter()
        except FullError as error:
            await socket.close(CLOSED, str(error))
            return
        sessions, secret = self.sessions, cookie_of(socket.headers)
        try:
            await serve_viewer(
                socket, viewer, lambda: sessions is None or sessions.who(secret, uses=False) is not None
            )
        finally:
            self.audience.leave(viewer)

    async def log_in(self, request: Request) -> Response:
        """Begin a session with a word of ``tandem keys link``."""
        document = await _document(request)
        if self.sessions is None:
            raise WrongError(409, "on this host nobody logs in")
        try:
            address = "" if request.client is None else request.client.host
            secret, who = self.sessions.log_in(str(document.get("word", "")), address)
        except LinkError as error:
            raise WrongError(401, str(error)) from error
        _LOG.info("%s (%s) has logged in", who.name, who.role)
        answer = JSONResponse({"who": who.name, "role": who.role})
        answer.set_cookie(
            COOKIE, secret, max_age=int(LONGEST), path="/", secure=True, httponly=True, samesite="strict"
        )
        return answer

    async def log_out(self, request: Request) -> Response:
        """End a session."""
        if self.sessions is not None:
            self.sessions.log_out(cookie_of(request.headers))
        answer = JSONResponse({})
        answer.delete_cookie(COOKIE, path="/", secure=True, httponly=True, samesite="strict")
        return answer

    def _who(self, request: Request) -> Who:
        found: Who | None = request.scope.get("who")
        return self.robot.who if found is None else found

    def _allow(self, request: Request, name: str, key: str) -> Who:
        who = self._who(request)
        if who.role == REPLAY:
            raise WrongError(403, "this is a record: the past takes no orders")
        for each in (who, self.robot.who):
            if not each.may_ask(key):
                raise WrongError(403, f"the key of {each.name} ({each.role}) does not allow {name}")
        return who


def application(
    robot: Robot,
    audience: Audience | None = None,
    sessions: Sessions | None = None,
    pages: Pages = NO_PAGES,
) -> Starlette:
    """Return the server for a robot; with ``sessions`` every viewer logs in; ``pages`` are other robots'."""
    site = Site(robot, Audience(robot) if audience is None else audience, sessions=sessions, pages=pages)

    @asynccontextmanager
    async def living(_: Starlette) -> AsyncIterator[None]:
        yield
        await site.audience.close()
        site.kept.close()
        await robot.close()

    return Starlette(
        routes=[
            Route("/api/session", site.session),
            Route("/api/robot", site.robot_told),
            Route("/api/site", site.place),
            Route("/api/kinds", site.kinds),
            Route("/api/history", site.history),
            Route("/api/camera", site.camera),
            Route("/api/task/{task}", site.task),
            Route("/api/task/{task}/picture/{number}", site.picture),
            Route("/api/task/{task}/records", site.records),
            Route("/api/task/{task}/moment", site.moment),
            Route("/api/request", site.request, methods=["POST"]),
            Route("/api/verb/{verb}", site.verb, methods=["POST"]),
            Route("/api/login", site.log_in, methods=["POST"]),
            Route("/api/logout", site.log_out, methods=["POST"]),
            Route("/api/replay", site.replay, methods=["POST"]),
            Route("/mesh/{path:path}", site.mesh),
            WebSocketRoute("/live", site.live),
            Route("/static/{name}", _static),
            Route("/{page:path}", _page),
        ],
        middleware=[Middleware(Gate, sessions=sessions), Middleware(GZipMiddleware, minimum_size=1024)],
        exception_handlers={ClientError: _tell_client, WrongError: _tell_wrong},
        lifespan=living,
    )


def bundled(name: str) -> bytes:
    """Return a file of the page."""
    return files("tandem.executive.web").joinpath("bundle", name).read_bytes()


async def _page(request: Request) -> Response:
    if request.path_params["page"].startswith(("api/", "mesh/", "static/")):
        raise WrongError(404, "there is nothing at this address")
    return Response(bundled("index.html"), media_type="text/html")


async def _static(request: Request) -> Response:
    name = request.path_params["name"]
    if name not in BUNDLE:
        raise WrongError(404, "there is nothing at this address")
    return Response(bundled(name), media_type=BUNDLE[name])


async def _document(request: Request) -> dict[str, JsonValue]:
    body = b""
    async for part in request.stream():
        body += part
        if len(body) > MAX_REQUEST_BYTES:
            raise WrongError(413, f"expected at most {MAX_REQUEST_BYTES} bytes")
    try:
        document = json.loads(body)
    except (ValueError, RecursionError) as error:
        raise WrongError(400, f"expected a JSON object: {error}") from error
    if not isinstance(document, dict):
        raise WrongError(400, f"expected a JSON object; found {type(document).__name__}")
    return document


def _misshapen(error: ValidationError) -> WrongError:
    problems: list[JsonValue] = [each.model_dump(mode="json") for each in problems_of(error)]
    return WrongError(422, "the document is not as it should be", problems=problems)


async def _tell_client(request: Request, error: Exception) -> Response:
    del request
    status = next((code for kind, code in STATUS.items() if isinstance(error, kind)), 502)
    told: dict[str, JsonValue] = {"error": str(error)}
    if isinstance(error, RejectedError):
        told["problems"] = [each.model_dump(mode="json") for each in error.problems]
    return JSONResponse(told, status)


async def _tell_wrong(request: Request, error: Exception) -> Response:
    del request
    assert isinstance(error, WrongError)
    return JSONResponse(error.told, error.status)
