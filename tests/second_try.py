"""A browser test that fails is tried once more, and said so.

A browser on a busy machine sometimes stalls for seconds: that is no fault of a page. A fault fails
twice. What needed its second try is listed at the end of the run, so that it is not forgotten.
"""

from __future__ import annotations

import pytest
from _pytest.runner import runtestprotocol

TWICE = ("tried", 2)
_second: list[str] = []


def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> bool | None:
    """Run a test that drives a browser up to twice; leave all others to pytest."""
    if item.get_closest_marker("browser") is None:
        return None
    item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
    reports = runtestprotocol(item, nextitem=nextitem, log=False)
    if any(report.failed for report in reports):
        item._initrequest()  # type: ignore[attr-defined]  # fixtures of one test are made anew
        reports = runtestprotocol(item, nextitem=nextitem, log=False)
        for report in reports:
            report.user_properties.append(TWICE)
    for report in reports:
        item.ihook.pytest_runtest_logreport(report=report)
    item.ihook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
    return True


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Collect them, from all processes that run tests."""
    if TWICE in map(tuple, report.user_properties) and report.when == "call":
        _second.append(report.nodeid)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """List the tests that were tried twice."""
    if _second:
        terminalreporter.section("tried a second time")
        for name in _second:
            terminalreporter.write_line(name)
