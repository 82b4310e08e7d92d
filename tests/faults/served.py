"""Servers and networks that answer wrongly, late, in part or not at all; odd names of folders."""

from __future__ import annotations

import time
from collections.abc import Iterator
from http.server import SimpleHTTPRequestHandler
from pathlib import Path

from .files import CARTS, LOGIN, RUNTIME, cut, login, missing, to
from .table import Answer, Fault, Must

Handler = SimpleHTTPRequestHandler
HANGS = 60.0  # s, longer than anybody looks
FOLDERS = (
    "with blank",
    "100% done",
    "%41%2F%00",
    "naïve #1 & co",
    "Übung Öß",
    "物理",
    "a+b=c;d",
    "q?uestion",
    "lessons.zip",
    "a'b\"c",
    "..hidden..",
    "<b>bold",
    "😀",
    "long" * 55,
)
DEEP = "/".join(["a-folder-in-a-folder"] * 40)


def status(code: int) -> Answer:
    def answer(its: Handler, _: str) -> bool:
        its.send_error(code)
        return True

    return answer


def sent(content: bytes, kind: str = "text/html", **headers: str) -> Answer:
    def answer(its: Handler, _: str) -> bool:
        its.send_response(200)
        its.send_header("Content-Type", kind)
        its.send_header("Content-Length", str(len(content)))
        for name, value in headers.items():
            its.send_header(name.replace("_", "-"), value)
        its.end_headers()
        its.wfile.write(content)
        return True

    return answer


def as_type(kind: str, **headers: str) -> Answer:
    """The right file under a wrong name of its kind."""

    def answer(its: Handler, path: str) -> bool:
        return sent(Path(its.translate_path(path)).read_bytes(), kind, **headers)(its, path)

    return answer


def redirected(to_path: str) -> Answer:
    def answer(its: Handler, path: str) -> bool:
        if path == to_path:
            return sent(LOGIN)(its, path)
        its.send_response(302)
        its.send_header("Location", to_path or path)
        its.end_headers()
        return True

    return answer


def broken_off(its: Handler, path: str) -> bool:
    """The head promises all, the body ends in the middle."""
    content = Path(its.translate_path(path)).read_bytes()
    its.send_response(200)
    its.send_header("Content-Type", "text/javascript")
    its.send_header("Content-Length", str(len(content)))
    its.end_headers()
    its.wfile.write(content[: len(content) // 2])
    its.close_connection = True
    return True


def hangs(its: Handler, _: str) -> bool:
    time.sleep(HANGS)
    its.close_connection = True
    return True


def late(seconds: float) -> Answer:
    def answer(_: Handler, __: str) -> bool:
        time.sleep(seconds)
        return False

    return answer


def only(part: str, answer: Answer) -> Answer:
    """Only for paths that hold these letters, and where a login page leads to."""

    def some(its: Handler, path: str) -> bool:
        return (part in path or path == "/log-in") and answer(its, path)

    return some


JS = "/assets/carts/"
PARTS = "/runtime/"


def of_servers() -> Iterator[Fault]:
    """All from 127.0.0.1, over plain http."""
    for name, answer in (
        ("404", status(404)),
        ("403", status(403)),
        ("500", status(500)),
        ("503", status(503)),
        ("a login page", sent(LOGIN)),
        ("a redirect to a login page", redirected("/log-in")),
        ("a redirect to itself", redirected("")),
        ("half, then nothing", broken_off),
        ("gzip that is none", as_type("text/javascript", Content_Encoding="gzip")),
        ("pictures, and no guessing", as_type("image/png", X_Content_Type_Options="nosniff")),
        ("no answer", hangs),
    ):
        yield Fault(f"http, runtime: {name}", "says", mode="http", answer=only(PARTS, answer))
        own = only("answers.js", answer)
        yield Fault(f"http, answers.js: {name}", "closed", mode="http", answer=own)
    yield Fault("http, carts.js: no answer", "says", mode="http", answer=only("carts.js", hangs))
    for name in ("carts.css", "stylesheets/main"):  # ours and the theme's
        yield Fault(f"http, a style, {name}: no answer", mode="http", answer=only(name, hangs))
    for kind in ("text/plain", "application/octet-stream"):
        yield Fault(f"http, scripts: {kind}", mode="http", answer=only(JS, as_type(kind)))
    latin = as_type("text/javascript; charset=iso-8859-1")
    yield Fault(
        "http, scripts said to be Latin-1", "either", mode="http", answer=only(".js", latin)
    )
    yield Fault("http, all a second late", mode="http", answer=only(PARTS, late(1)))
    yield from _half_updated()
    for folder in FOLDERS:
        yield Fault(f"a folder called “{folder[:20]}”", folder=folder)
        yield Fault(f"the same over http: “{folder[:20]}”", folder=folder, mode="http")
    yield Fault("a path of 840 letters", folder=DEEP)
    yield Fault("a path of 840 letters, http", folder=DEEP, mode="http")


def _half_updated() -> Iterator[Fault]:
    """Old and new mixed: what the new names is gone, or the old is still there."""
    gone: dict[str, tuple[Must, str]] = {
        "a new index, the old parts": ("says", f"{RUNTIME}/*.*.*.js"),
        "a new index, the old snapshot": ("lives", f"{RUNTIME}/memory*"),
        "a new index, the old wheel": ("lives", f"{RUNTIME}/newtons_carts-*"),  # as the snapshot
        "a new page, the old prepared runs": ("lives", f"{CARTS}/prepared/*"),
    }
    for name, (must, pattern) in gone.items():
        yield Fault(f"half updated: {name}", must, to(missing, pattern), mode="http")
    stale = to(_another_version, f"{RUNTIME}/index.js")
    yield Fault("half updated: the old index, new parts", "says", stale, mode="http")
    for name in ("carts.js", "answers.js"):
        old = to(cut, f"{CARTS}/{name}")
        yield Fault(f"half updated: {name} half written", "says", old, mode="http")
    yield Fault("a login page for every script", "closed", to(login, f"{CARTS}/*.js"), mode="http")


def _another_version(file: Path) -> None:
    """An index whose parts were other files."""
    text = file.read_text("utf-8")
    file.unlink()
    file.write_text(text.replace('.js"', '.old.js"'), "utf-8")
