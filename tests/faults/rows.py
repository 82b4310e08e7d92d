"""All faults, and two processes that try them."""

from __future__ import annotations

import atexit
import multiprocessing
from collections.abc import Iterator
from contextlib import ExitStack

from playwright.sync_api import sync_playwright

from .files import of_files
from .killed import killed
from .limited import of_limits
from .look import usual
from .machine import of_machines
from .poor import of_browsers
from .served import of_servers
from .table import LESSON, PACKAGES, Fault
from .tried import Bench, Row, address, tried

WORKERS = 2  # a browser waits for its clocks most of the time; more would make them late


def faults() -> Iterator[Fault]:
    """All of them, the same in every run."""
    yield Fault("nothing")
    yield Fault("nothing, http", mode="http")
    for rows in (of_files, of_browsers, of_servers, of_machines, of_limits):
        yield from rows()


class Worker:
    """What one process needs for its rows, opened once."""

    bench: Bench
    usual: dict[str, frozenset[str]]

    @classmethod
    def open(cls) -> None:
        stack = ExitStack()
        cls.bench = stack.enter_context(Bench.open(stack.enter_context(sync_playwright())))
        atexit.register(stack.close)
        cls.usual = {}
        for page in (LESSON, PACKAGES):
            fault = Fault("", page=page, folder=cls.bench.whole.name)
            with address(fault, cls.bench.whole.parent) as where:
                cls.usual[page] = usual(cls.bench.browser.new_context(), where)

    @classmethod
    def row(cls, number: int) -> Row:
        fault = list(faults())[number]
        return tried(cls.bench, fault, cls.usual[fault.page])


def rows(words: list[str]) -> Iterator[Row]:
    """In the order of the table."""
    wanted = [
        number
        for number, fault in enumerate(faults())
        if not words or any(word in fault.name for word in words)
    ]
    context = multiprocessing.get_context("spawn")
    with context.Pool(WORKERS, Worker.open) as pool:
        yield from pool.imap(Worker.row, wanted)
        pool.close()
        pool.join()
    if not words or "killed" in words:
        yield from killed()
