"""A report as HTML: the same tables in the page, in the file that is saved, and in print.

Everything that came out of a file is escaped here, in one place, `text`. There is no script and no
style in it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from sim.classroom import sentences as say
from sim.classroom.drawing import bars, dots
from sim.classroom.escaped import escape
from sim.classroom.sentences import number, signed

Row = Mapping[str, Any]
TITLES = {"pre": "before (pre)", "post": "after (post)", "delayed": "later (delayed)",
          "worksheet": "worksheet"}  # fmt: skip
_MARKDOWN = re.compile(r"\*\*|__|`|\\[()]")
LONGEST = 400


def text(value: object) -> str:
    """Any value as text of a page, with the marks of Markdown taken out."""
    plain = _MARKDOWN.sub("", str(value))
    plain = plain if len(plain) <= LONGEST else f"{plain[:LONGEST]}…"
    return escape(plain)


def who(value: object) -> str:
    """A name that somebody typed: kept apart, so that its direction changes nothing around it."""
    return f"<bdi>{text(value)}</bdi>"


def table(head: Sequence[str], rows: Iterable[Sequence[str]], *, kind: str = "") -> str:
    """A table; cells are HTML already."""
    header = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    body = "".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in rows)
    return (
        f'<div class="carts-class-table {kind}" tabindex="0"><table class="carts-class-cells">'
        f"<thead><tr>{header}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def listed(sentences: Iterable[str], kind: str = "says") -> str:
    """Sentences as a list, or nothing."""
    items = "".join(f"<li>{text(sentence)}</li>" for sentence in sentences if sentence)
    return f'<ul class="carts-class-{kind}">{items}</ul>' if items else ""


def report_html(report: Row) -> str:
    """The whole report as a fragment of a page."""
    parts = [_count(report["files"]), _flags(report["flags"]), _refused(report["files"])]
    parts += [_lesson(lesson, report) for lesson in report["lessons"]]
    parts.append(listed(report["notes"], "notes"))
    return "".join(parts)


def _count(files: Row) -> str:
    counted = f"{files['counted']} of {files['read']} files of answers are counted."
    if not files["read"]:
        counted = "No file of answers was found."
    made = f'<p class="carts-class-count">{counted}</p>'
    if files["set_aside"]:
        made += f"<p>Set aside: {', '.join(map(who, files['set_aside']))}.</p>"
    return made


def _refused(files: Row) -> str:
    refused = [f"{row['name']}: {row['reason']}" for row in files["refused"]]
    if files["refused_more"]:
        refused.append(f"and {files['refused_more']} more")
    if not refused:
        return ""
    return f"<h2>Files that could not be read</h2>{listed(refused, 'refused')}"


def _flags(flags: Sequence[Row]) -> str:
    if not flags:
        return ""
    rows = [
        f"<li>{text(flag['sentence'])} <span>{', '.join(map(who, flag['files'][:12]))}"
        f"{' …' if len(flag['files']) > 12 else ''}</span></li>"
        for flag in flags
    ]
    return f'<h2>Look at this first</h2><ul class="carts-class-flags">{"".join(rows)}</ul>'


def _lesson(lesson: Row, report: Row) -> str:
    parts = [f"<h2>{text(lesson['lesson'])}</h2>", _means(lesson, report), _plot(lesson)]
    if lesson["comparison"]:
        first, second = lesson["comparison"]["groups"]
        parts.append(f"<h3>{text(first)} beside {text(second)}</h3>")
        parts.append(_comparison(lesson["comparison"]))
    if lesson["gains"]:
        parts += ["<h3>Before and after</h3>", _gains(lesson["gains"]), _topics(lesson["topics"])]
    parts += [f"<h3>Form {text(row['form'])}</h3>{listed(row['sentences'])}"
              for row in lesson["later"]]  # fmt: skip
    parts.append(_items(lesson))
    parts += [_form(form) for form in lesson["forms"]]
    return f'<section class="carts-class-lesson">{"".join(parts)}</section>'


def _means(lesson: Row, report: Row) -> str:
    """The first table: means and deviations, or why there are none."""
    rows, says = [], []
    for form in lesson["forms"]:
        for group in form["groups"]:
            if not group["n"] and len(report["groups"]) > 1:
                continue
            mean = f"{number(group['mean'])} ± {number(group['sd'])}" if "mean" in group else "–"
            low = group.get("low")
            interval = "–" if low is None else f"{number(low)} to {number(group['high'])}"
            rows.append([TITLES.get(form["form"], form["form"]), who(group["group"]),
                         str(group["n"]), mean, interval, f"{form['of']}"])  # fmt: skip
            if sentence := group.get("sentence"):
                prefix = f"{form['form']}, {group['group']}: "
                says.append(prefix + sentence)
        if not form["has_key"]:
            says.append(f"Form {form['form']}: there is no key for it, so nothing is marked. "
                        "Choose the key file as well.")  # fmt: skip
        elif form["unread"]:
            says.append(f"Form {form['form']}: {', '.join(form['unread'])} wait to be read by you "
                        "and are in no total yet.")  # fmt: skip
    head = ["form", "group", "students", "mean ± standard deviation", "95 % interval", "marks"]
    return table(head, rows, kind="means") + listed(says)


def _plot(lesson: Row) -> str:
    rows: list[tuple[str, list[float], float, float | None]] = []
    highest = 0.0
    for form in lesson["forms"]:
        for group in form["groups"]:
            if "mean" in group:
                low = group["low"]
                half = None if low is None else group["mean"] - low
                several = len(form["groups"]) > 1
                name = f"{form['form']}, {group['group']}" if several else form["form"]
                rows.append((name, group["totals"], group["mean"], half))
                highest = max(highest, form["of"])
    return f"<figure>{dots(rows, highest)}</figure>" if rows else ""


def _comparison(row: Row) -> str:
    return listed([*row["sentences"], *row["refusals"]])


def _gains(rows: Sequence[Row]) -> str:
    head = ["group", "took both", "before", "after", "gain g", "change (95 % interval)", "d"]
    cells, says = [], []
    for row in rows:
        change = row.get("change")
        pre, post = row["pre"], row["post"]
        cells.append([
            who(row["group"]), str(row["n"]),
            f"{number(pre['mean'])} ± {number(pre['sd'])}" if pre else "–",
            f"{number(post['mean'])} ± {number(post['sd'])}" if post else "–",
            number(row["gain"]) if row.get("gain") is not None else "–",
            f"{signed(change['difference'])} ({signed(change['low'])} to {signed(change['high'])})"
            if change else "–",
            signed(row["d"]) if row.get("d") is not None else "–",
        ])  # fmt: skip
        several = f"{row['group']}: " if len(rows) > 1 else ""
        says += [several + sentence for sentence in [*row["sentences"], *row["refusals"]]]
        for name, missing in (("without_before", "only after"), ("without_after", "only before")):
            if row[name]:
                says.append(f"{several}{missing}, so in no pair: {', '.join(row[name])}")
    return table(head, cells, kind="gains") + listed(says)


def _topics(rows: Sequence[Row]) -> str:
    """Gains topic by topic."""
    if not rows:
        return ""
    head = ["topic", "questions", "group", "took both", "before", "after", "gain g"]
    cells = [
        [
            text(row["topic"]), str(row["questions"]), who(row["group"]), str(row["n"]),
            *(f"{number(row[k]['mean'])} ± {number(row[k]['sd'])}" for k in ("pre", "post")),
            "–" if row["gain"] is None else number(row["gain"]),
        ]
        for row in rows
    ]  # fmt: skip
    return f"<h4>By topic</h4>{table(head, cells, kind='topics')}" + listed([say.FEW_QUESTIONS])


def _items(lesson: Row) -> str:
    """Share of right answers, item by item, for all forms of at least ten students."""
    shares: dict[str, list[tuple[str, float]]] = {}
    for form in lesson["forms"]:
        for item in form["items"]:
            if item["difficulty"] is not None and item["n"] >= 10:
                shares.setdefault(item["id"], []).append((form["form"], item["difficulty"]))
    shown = list(dict.fromkeys(form for values in shares.values() for form, _ in values))
    return f"<figure>{bars(list(shares.items()), shown)}</figure>" if shares else ""


def _form(form: Row) -> str:
    title = text(TITLES.get(form["form"], form["form"]))
    items = [item for item in form["items"] if item["n"]]
    parts = [f"<h3>Form {title}: questions</h3>", _overview(items)]
    if form["beliefs"]:
        parts.append("<h4>Beliefs behind two answers or more of a student</h4>")
        parts.append(listed(row["sentence"] for row in form["beliefs"]))
    each = "".join(map(_item, items))
    parts.append(f"<details><summary>Question by question: form {title}</summary>{each}</details>")
    parts.append(_students(form))
    return "".join(parts)


def _overview(items: Sequence[Row]) -> str:
    """One line for each question, with the wrong answer that was chosen most."""
    rows = []
    for item in items:
        wrong = [c for c in item["choices"] if not c.get("correct") and c["count"] > 1]
        most = max(wrong, key=lambda c: c["count"], default=None) if item["worth"] else None
        chosen = f"{most['option'].upper()} ({most['count']})" if most else ""
        right = f"{item['right']} of {item['n']}" if item["worth"] else "–"
        if item["unread"]:
            right = f"{item['unread']} to read"
        numbers = ("difficulty", "discrimination", "point_biserial")
        rows.append([
            text(item["id"]), right, str(item["empty"]),
            *("–" if item[n] is None else number(item[n]) for n in numbers),
            text(chosen), text(most.get("says", "") if most else ""),
        ])  # fmt: skip
    head = ["question", "right", "open", "difficulty", "discrimination", "r", "chosen most, wrong",
            "students who choose it often think"]  # fmt: skip
    return table(head, rows, kind="overview") if rows else ""


def _item(item: Row) -> str:
    title = f'<h4>{text(item["id"])}</h4><p class="carts-class-ask">{text(item["ask"])}</p>'
    rows = [
        [
            f"{text(choice['option'].upper())}{' ✓' if choice.get('correct') else ''}",
            text(choice["text"]),
            str(choice["count"]),
            text(choice.get("says", "")),
        ]
        for choice in item["choices"]
    ]
    head = ["letter", "answer", "chosen", "students who choose it often think"]
    facts = [item["sentence"], *item["notes"]]
    if item["point_biserial"] is not None:
        facts.append(
            f"Correlation with the other questions, rough: {signed(item['point_biserial'])}."
        )
    made = table(head, rows, kind="item") if rows else ""
    return f'<div class="carts-class-item">{title}{made}{listed(facts)}</div>'


def _students(form: Row) -> str:
    rows = [
        [
            who(row["student"]), who(row["group"]),
            "–" if row["total"] is None else f"{row['total']}",
            text(", ".join(row["open"])) or "–", text(", ".join(row["waiting"])) or "–",
            who(row["file"]),
        ]
        for row in form["students"]
    ]  # fmt: skip
    head = ["code word", "group", f"marks of {form['of']}", "left open", "to be read", "file"]
    title = f"Who left what open: form {text(form['form'])}"
    return f"<details><summary>{title}</summary>{table(head, rows, kind='students')}</details>"
