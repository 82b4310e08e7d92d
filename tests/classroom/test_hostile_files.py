"""Hostile and damaged files: the bad one is named with a reason, the others are analysed."""

from __future__ import annotations

import json
import random
import struct
import tracemalloc
import zipfile
from collections.abc import Callable

import pytest

from sim.classroom.files.archive import MOST_ENTRIES, is_zip
from sim.classroom.files.reading import MOST_NAMED, Reading, Source
from sim.classroom.report.report import Asked, class_report
from sim.lesson.answer_file import read_answer_file
from tests.classroom.given.makers import answers, bank, keys, packed, random_class, sources, zipped

BANK = bank(6)
GOOD = sources(random_class(BANK, 5))


def bomb() -> bytes:
    return packed(lambda a: a.writestr("bomb.json", b"0" * 300_000_000))


def lying_bomb() -> bytes:
    """A file that unpacks to 50 MB and claims 100 bytes."""
    content = packed(lambda a: a.writestr("bomb.json", b"0" * 50_000_000))
    size = struct.pack("<L", 50_000_000)
    assert content.count(size) == 2
    return content.replace(size, struct.pack("<L", 100))


def million() -> bytes:
    """A million empty entries, without making each by hand."""
    names = b"".join(
        b"PK\x01\x02"
        + b"\x14\0" * 2
        + b"\0" * 18
        + struct.pack("<5H2L", 1, 0, 0, 0, 0, 0, 0)[:-4]
        + struct.pack("<L", 0)
        + b"x"
        for _ in range(1)
    )
    table = names * 1_000_000
    end = b"PK\x05\x06" + struct.pack("<4H2LH", 0, 0, 1000, 1000, len(table), 0, 0)
    return b"PK\x03\x04" + table + end


def many_entries() -> bytes:
    def fill(archive: zipfile.ZipFile) -> None:
        for k in range(MOST_ENTRIES + 1):
            archive.writestr(f"{k}.json", b"")

    return packed(fill, zipfile.ZIP_STORED)


def nested() -> bytes:
    inner = packed(lambda a: a.writestr("inner.zip", zipped(GOOD)))
    return packed(lambda a: a.writestr("outer.zip", inner))


def encrypted() -> bytes:
    content = bytearray(packed(lambda a: a.writestr("secret.json", b"{}")))
    for at, flag in ((0, 6), (bytes(content).find(b"PK\x01\x02"), 8)):
        content[at + flag] |= 1
    return bytes(content)


def strange_way() -> bytes:
    return packed(lambda a: a.writestr("a.json", b"{}"), zipfile.ZIP_LZMA)


def with_more(key: str) -> bytes:
    """An answer file whose first answer has one more key, as text."""
    text = json.dumps(answers(BANK, "F", "pre", {"item-0": "a"}))
    return text.replace('"tries": 0', f'"tries": 0, {key}', 1).encode()


def named(student: str) -> bytes:
    return json.dumps(answers(BANK, "F", "pre", {})).replace('"F"', student, 1).encode()


BAD: dict[str, tuple[Callable[[], bytes], str]] = {
    "bomb": (bomb, "too large"),
    "lying bomb": (lying_bomb, "damaged|too large"),
    "a million entries": (million, "more than 20,000 entries"),
    "more entries than a class": (many_entries, "more than 20,000 entries"),
    "a zip in a zip in a zip": (nested, "too many zips"),
    "a password": (encrypted, "password"),
    "packed in another way": (strange_way, "not known here"),
    "cut": (lambda: zipped(GOOD)[:-30], "damaged"),
    "only a beginning": (lambda: b"PK\x03\x04", "damaged"),
    "a picture": (lambda: b"\x89PNG\r\n\x1a\n" + bytes(range(256)), "no text file"),
    "nothing": (lambda: b"", "not a file of answers"),
    "huge text": (lambda: b" " * 3_000_000, "too large"),
    "deep": (lambda: b"[" * 1_000_000, "damaged"),
    "half a character": (lambda: named('"\\udc80"'), "damaged"),
    "half a character in an answer": (lambda: with_more('"said": "\\ud83d"'), "damaged"),
    "a large number": (
        lambda: (
            json.dumps(answers(BANK, "F", "pre", {"item-0": "a"}))
            .replace('"tries": 0', '"tries": ' + "9" * 10_000)
            .encode()
        ),
        "damaged",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_a_bad_file_is_named_and_the_others_are_read(name: str) -> None:
    make, reason = BAD[name]
    bad = make()
    tracemalloc.start()
    reading = Reading.of([GOOD[0], Source("bad.file", bad), *GOOD[1:]])
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert len(reading.files) == len(GOOD)
    assert reading.refused
    assert reading.refused[0].name.startswith("bad.file")
    assert any(word in reading.refused[0].reason for word in reason.split("|"))
    assert peak < 100_000_000


def test_a_number_of_400_digits_is_no_reading_and_stops_nothing() -> None:
    reading = Reading.of([Source("large.json", with_more('"own": ' + "9" * 400))])
    assert [file.answers.items[0].own for file in reading.files] == [None]


def test_a_file_that_nobody_thought_of_is_refused_and_the_others_are_read(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def surprising(text: str) -> object:
        if "surprise" in text:
            raise ZeroDivisionError
        return read_answer_file(text)

    monkeypatch.setattr("sim.classroom.files.reading.read_answer_file", surprising)
    reading = Reading.of([GOOD[0], Source("odd.json", b"surprise"), GOOD[1]])
    assert len(reading.files) == 2
    assert reading.refused[0].reason == "this file cannot be read (ZeroDivisionError)"


def test_truncation_at_any_byte_is_survived() -> None:
    content = zipped(GOOD[:2])
    for end in range(len(content)):
        Reading.of([Source("cut.zip", content[:end])])
    text = GOOD[0].content
    for end in range(len(text)):
        assert len(Reading.of([Source("cut.json", text[:end])]).refused) == 1


def test_ten_thousand_mutations_are_refused_or_read_and_never_break_the_report() -> None:
    dice = random.Random(77)
    text = GOOD[0].content
    kept = Reading.of([Source("key.json", keys(BANK).encode())])
    for _ in range(10_000):
        mutant = bytearray(text)
        for _ in range(dice.randint(1, 3)):
            at = dice.randrange(len(mutant))
            choice = dice.randrange(3)
            if choice == 0:
                mutant[at] = dice.randrange(256)
            elif choice == 1:
                del mutant[at : at + dice.randint(1, 20)]
            else:
                mutant[at:at] = bytes([dice.choice(b'{}[]",:0-9enul\\\x00\xff')])
        reading = Reading.of([Source("mutant.json", bytes(mutant))])
        assert len(reading.files) + len(reading.refused) + len(reading.keys) == 1
        if reading.files:
            report = class_report([(reading.files[0], "class")], kept.keys, [], Asked())
            json.dumps(report, allow_nan=False)


def test_mutated_zips_are_survived() -> None:
    dice = random.Random(78)
    content = zipped(GOOD)
    for _ in range(1_000):
        mutant = bytearray(content)
        for _ in range(dice.randint(1, 4)):
            mutant[dice.randrange(len(mutant))] = dice.randrange(256)
        reading = Reading.of([Source("mutant.zip", bytes(mutant))])
        if not is_zip(bytes(mutant)):
            assert reading.refused


def test_thousands_of_bad_files_are_counted_and_not_all_named() -> None:
    reading = Reading.of([Source(f"{k}.json", b"x") for k in range(1_000)])
    report = class_report([], [], reading.refused, Asked())
    assert len(report["files"]["refused"]) == MOST_NAMED
    assert report["files"]["refused_more"] == 1_000 - MOST_NAMED


@pytest.mark.parametrize("packed_up", [False, True])
def test_what_a_mac_put_beside_the_files_is_told_of_to_nobody(packed_up: bool) -> None:
    beside = [Source(f"7b/._{one.name}", b"\0\5\26\7") for one in GOOD]
    given = [*GOOD, *beside]
    reading = Reading.of([Source("class.zip", zipped(given))] if packed_up else given)
    assert (len(reading.files), reading.refused) == (len(GOOD), [])
