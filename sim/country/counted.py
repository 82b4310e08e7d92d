"""Which files of a table count, as one expression: the rules of `report.flags` for two claims.

One file for each student and form. Equal files count once; of two saves of one beginning the later
counts; else none, for two students may have one code word. Places of files in a table are unique,
so no order of the backend decides.
"""

from __future__ import annotations

from typing import Any

PLACE = ["site", "lesson", "form", "person"]
FORM = ["site", "lesson", "form"]

ONE_BY_ONE = ("sheet_rows", "sheet_order", "file", *FORM, "group", "group_order", "class",
              "student", "person", "created", "saved", "digest", "digest_timed")  # fmt: skip


def sheets_of(answers: Any) -> Any:
    """One row a file: what all its rows say, how many there are, whether it is foreign."""
    whole = {name: answers[name].max() for name in ONE_BY_ONE}
    return answers.group_by("sheet").agg(
        **whole,
        keyed=answers.keyed.any(),
        foreign=answers.foreign.any(),
        rows=answers.count(),
    )


def judged(sheets: Any) -> Any:
    """Files with `counts` and with the `claim` of their place: once, same, again, doubled."""
    import ibis

    places = sheets.group_by(PLACE).agg(
        claims=sheets.count(),
        typed=sheets.created.isnull().any(),
        contents=sheets.digest.nunique(),
        contents_timed=sheets.digest_timed.nunique(),
        begun=sheets.created.nunique() + sheets.created.isnull().any().cast("int64"),
    )
    ranked = sheets.mutate(
        first=ibis.row_number().over(
            group_by=PLACE, order_by=[sheets.sheet_order.asc(), sheets.sheet.asc()]
        ),
        latest=ibis.row_number().over(
            group_by=PLACE,
            order_by=[sheets.saved.desc(), sheets.sheet_order.asc(), sheets.sheet.asc()],
        ),
    )
    found = ranked.join(places, PLACE)
    once = found.claims == 1
    same = found.typed.ifelse(found.contents, found.contents_timed) == 1
    again = (found.begun == 1) & ~found.typed
    counts = once | (same & (found["first"] == 0)) | (~same & again & (found.latest == 0))
    claim = once.ifelse("once", same.ifelse("same", again.ifelse("again", "doubled")))
    return found.mutate(counts=counts, claim=claim)
