"""A report as HTML: the same tables in the page, in the file that is saved, and in print.

There is no script and no style in it. The questions of a form: show_items.py.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.report import sentences as say
from sim.classroom.report.sentences import files_read, many, number, signed, unmarked
from sim.classroom.show.drawing import bars, dots
from sim.classroom.show.html_parts import listed, table, text, who
from sim.classroom.show.questions import TITLES, form_html

Row = Mapping[str, Any]
MOST_LOST = 5  # names of files that could not be read, in the first lines; all stand below


def report_html(report: Row) -> str:
    """The whole report as a fragment of a page."""
    parts = [_count(report["files"]), _flags(report["flags"]), _refused(report["files"])]
    parts += [_lesson(lesson, report) for lesson in report["lessons"]]
    parts.append(listed(report["notes"], "notes"))
    return "".join(parts)


def _count(files: Row) -> str:
    counted = f"{files['counted']} of {files['read']} {files_read(files)} are counted."
    if not files["read"]:
        counted = f"No {files_read(files, one=True)} was found."
    made = f'<p class="carts-class-count">{counted}</p>'
    if lost := len(files["refused"]) + files["refused_more"]:
        names = ", ".join(text(row["name"]) for row in files["refused"][:MOST_LOST])
        more = " …" if lost > MOST_LOST else ""
        unread = f"{many(lost, 'file')} could not be read: {names}{more}"
        made += f'<p class="carts-class-lost">{unread}</p>'
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
    parts = [f"<h2>{text(lesson['title'])}</h2>", _means(lesson, report), _plot(lesson)]
    if lesson["comparison"]:
        first, second = lesson["comparison"]["groups"]
        parts.append(f"<h3>{text(first)} beside {text(second)}</h3>")
        parts.append(_comparison(lesson["comparison"]))
    for row in lesson.get("comparisons", []):
        first, second = row["groups"]
        parts.append(f"<h3>{text(first)} beside {text(second)}</h3>")
        parts.append(_comparison(row))
    if lesson["gains"]:
        parts += ["<h3>Before and after</h3>", _gains(lesson["gains"]), _topics(lesson["topics"])]
    parts += [f"<h3>Form {text(row['form'])}</h3>{listed(row['sentences'])}"
              for row in lesson["later"]]  # fmt: skip
    parts.append(_items(lesson))
    parts += [form_html(form) for form in lesson["forms"]]
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
            rows.append([text(TITLES.get(form["form"], form["form"])), who(group["group"]),
                         str(group["n"]), mean, interval,
                         "–" if form["of"] is None else f"{form['of']}"])  # fmt: skip
            if sentence := group.get("sentence"):
                prefix = f"{form['form']}, {group['group']}: "
                says.append(prefix + sentence)
        if not form["has_key"]:
            says.append(f"{unmarked(form['form'])} Choose the key file as well.")
        elif form["unread"]:
            labels = {item["id"]: item["label"] for item in form["items"]}
            waiting = ", ".join(labels.get(name, name) for name in form["unread"])
            says.append(f"Form {form['form']}: {waiting} wait to be read by you "
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
                highest = max(highest, form["of"] or group["most"])
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
