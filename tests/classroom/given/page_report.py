"""The report on a class as the page makes it: every answer goes out and comes back."""

from __future__ import annotations

import json
from typing import Any

from sim.classroom.files.reading import Reading, Source
from sim.classroom.files.records import as_record, from_record
from sim.classroom.report.report import Asked, class_report
from tests.classroom.given.makers import sources


def report_of(files: list[dict[str, Any]], key: str = "") -> dict[str, Any]:
    extra = [Source("key.json", key.encode())] if key else []
    reading = Reading.of([*sources(files), *extra])
    assert not reading.refused
    # As the page does: rows go out and come back.
    read = [from_record(json.loads(json.dumps(as_record(one)))) for one in reading.files]
    return class_report([(one, "class") for one in read], reading.keys, [], Asked())
