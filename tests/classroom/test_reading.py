"""Files of answers, keys and marks, alone, in folders and in zips."""

from __future__ import annotations

import json
import zipfile

import pytest

from sim.classroom.files import archive
from sim.classroom.files.archive import LARGEST
from sim.classroom.files.reading import Reading, Source
from tests.classroom.given.makers import answers, bank, keys, packed, random_class, sources, zipped
from tests.web.scene.given.widget_site import in_node

BANK = bank(6)
GOOD = sources(random_class(BANK, 5))


def test_files_folders_and_zips_are_read_alike() -> None:
    plain = Reading.of(GOOD)
    packed_too = Reading.of([Source("class.zip", zipped(GOOD))])
    assert [f.answers for f in plain.files] == [f.answers for f in packed_too.files]
    assert not plain.refused
    assert not packed_too.refused
    assert packed_too.files[0].name.startswith("class.zip/")


def test_what_students_zipped_is_read_from_the_zip_of_a_platform() -> None:
    whole = packed(lambda a: [a.writestr(f"{k}.zip", zipped([one])) for k, one in enumerate(GOOD)])
    reading = Reading.of([Source("all.zip", whole)])
    assert len(reading.files) == len(GOOD)
    assert reading.files[0].name.startswith("all.zip/0.zip/")


def test_a_zip_that_is_cut_short_is_told_also_where_its_last_entry_is_a_zip(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    inner = zipped(GOOD)
    most = len(inner) + sum(len(one.content) for one in GOOD[:-1])
    monkeypatch.setattr(archive, "MOST_UNPACKED", most)
    reading = Reading.of([Source("all.zip", packed(lambda a: a.writestr("class.zip", inner)))])
    assert len(reading.files) == len(GOOD) - 1
    assert [refused.name for refused in reading.refused] == ["all.zip"]
    assert "the rest was not read" in reading.refused[0].reason


def test_a_key_file_is_recognised_by_what_is_in_it() -> None:
    reading = Reading.of([*GOOD, Source("whatever.json", keys(BANK).encode())])
    assert [key.form for key in reading.keys] == ["pre", "post"]


def test_marks_that_the_page_saved_are_read_however_many_students_there_are() -> None:
    row = {"lesson": "newton-3", "form": "worksheet", "item": "explain-why", "marks": 1}
    rows = [{**row, "student": f"BLUE-FOX-{k}"} for k in range(20_000)]
    saved = {"format": 1, "kind": "newtons-carts-marks", "marks": rows}
    content = json.dumps(saved, indent=1).encode()  # as sim/web/src/class/saves.js
    for source in ("all.marks.json", content), ("all.zip", zipped([Source("m.json", content)])):
        reading = Reading.of([Source(*source)])
        assert not reading.refused
        assert len(reading.given) == len(rows)


def test_each_kind_of_file_has_its_own_limit() -> None:
    answered = json.dumps(answers(BANK, "FOX", "pre", {"item-0": "a"}))
    marked = '{"format": 1, "kind": "newtons-carts-marks", "marks": []}'
    for text, most, kind in (
        (answered, 2_000_000, "answers"),
        (keys(BANK), 5_000_000, "key file"),
        (marked, 30_000_000, "too large"),  # larger than any kind: it is not looked into
    ):
        assert not Reading.of([Source("a.json", text.ljust(most).encode())]).refused
        (refused,) = Reading.of([Source("a.json", text.ljust(most + 1).encode())]).refused
        assert "too large" in refused.reason and kind in refused.reason


def test_the_page_sends_what_python_reads() -> None:
    most = 'give((await import(source + "/class/intake.js")).MOST_JSON);'
    assert in_node(most, None) == LARGEST


def test_a_file_from_a_windows_editor_is_read() -> None:
    text = json.dumps(answers(BANK, "FOX", "pre", {"item-0": "a"}))
    encoded = [text.encode("utf-8-sig"), text.encode("utf-16")]
    reading = Reading.of([Source("a.json", content) for content in encoded])
    assert len(reading.files) == 2


def test_names_that_point_elsewhere_are_only_names() -> None:
    content = json.dumps(answers(BANK, "FOX", "pre", {"item-0": "a"}))

    def fill(archive: zipfile.ZipFile) -> None:
        for name in ("../../evil.json", "/etc/evil.json", "C:\\evil.json", "a" * 5000 + ".json"):
            archive.writestr(name, content)

    reading = Reading.of([Source("class.zip", packed(fill))])
    assert len(reading.files) == 4
    assert all(len(file.name) < 250 for file in reading.files)
