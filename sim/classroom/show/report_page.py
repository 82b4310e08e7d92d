"""A report as HTML: the same tables in the page, in the file that is saved, and in print.

There is no script and no style in it. The questions of a form: questions.py.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.report import sentences as say
from sim.classroom.report.numerals import mean_and_sd, signed
from sim.classroom.report.sentences import TITLES
from sim.classroom.show.drawing import bars, dots
from sim.classroom.show.html_parts import Tell, listed, person, table, telling, text
from sim.classroom.show.questions import form_html
from sim.scene.notation import number
from sim.scene.said import Said, commas, counted, said, template

Row = Mapping[str, Any]
MOST_LOST = 5  # names of files that could not be read, in the first lines; all stand below
MOST_NAMED = 12  # names of files that were set aside, or beside a question to the teacher
MOST_OF_A_KIND = 2  # questions of one kind that are asked in full
ENGLISH: Mapping[str, str] = {}


def report_html(report: Row, words: Mapping[str, str] = ENGLISH) -> str:
    """The whole report as a fragment of a page; `words`: each English sentence in the language."""
    tell = telling(words)
    parts = [_count(report["files"], tell), _flags(report["flags"], tell)]
    parts += [_lesson(lesson, report, tell) for lesson in report["lessons"]]
    parts += [_refused(report["files"], tell), listed(report["notes"], tell, "notes")]
    return "".join(parts)


def _count(files: Row, tell: Tell) -> str:
    made = f'<p class="carts-class-count">{tell(say.of_files(files))}</p>'
    if lost := len(files["refused"]) + files["refused_more"]:
        names = commas([row["name"] for row in files["refused"][:MOST_LOST]])
        names = said("{names} …", names=names) if lost > MOST_LOST else names
        unread = counted("1 file could not be read: {names}",
                         "{n} files could not be read: {names}", n=lost, names=names)  # fmt: skip
        made += f'<p class="carts-class-lost">{tell(unread)}</p>'
    if files["set_aside"]:
        made += f"<p>{tell(template('Set aside:'))} {_names(files['set_aside'], tell)}</p>"
    return made


def _refused(files: Row, tell: Tell) -> str:
    refused = [said("{name}: {reason}", name=row["name"], reason=row["reason"])
               for row in files["refused"]]  # fmt: skip
    if files["refused_more"]:
        refused.append(said("and {n} more", n=f"{files['refused_more']}"))
    if not refused:
        return ""
    title = tell(template("Files that could not be read"))
    return f"<h2>{title}</h2>{listed(refused, tell, 'refused')}"


def _flags(flags: Sequence[Row], tell: Tell) -> str:
    if not flags:
        return ""
    kinds: dict[str, list[str]] = {}
    for flag in flags:
        kinds.setdefault(flag["code"], []).append(_flag(flag, tell))
    rows = "".join(_kind(rows, tell) for rows in kinds.values())
    title = tell(template("Look at this first"))
    return f'<h2>{title}</h2><ul class="carts-class-flags">{rows}</ul>'


def _flag(flag: Row, tell: Tell) -> str:
    return f"<li>{tell(flag['sentence'])} <span>{_names(flag['files'], tell)}</span></li>"


def _names(files: Sequence[str], tell: Tell) -> str:
    """The first names of files: a zip dropped beside its files sets all of these aside."""
    names = ", ".join(person(name, tell) for name in files[:MOST_NAMED])
    return names + (" …" if len(files) > MOST_NAMED else "")


def _kind(rows: Sequence[str], tell: Tell) -> str:
    """Questions of one kind: the first ones, and the others when they are asked for."""
    if len(rows) <= MOST_OF_A_KIND + 1:
        return "".join(rows)
    more = counted("1 more like these", "{n} more like these", n=len(rows) - MOST_OF_A_KIND)
    return (
        f"{''.join(rows[:MOST_OF_A_KIND])}<li><details><summary>{tell(more)}</summary>"
        f"<ul>{''.join(rows[MOST_OF_A_KIND:])}</ul></details></li>"
    )


def _lesson(lesson: Row, report: Row, tell: Tell) -> str:
    parts = [f"<h2>{text(lesson['title'])}</h2>", _means(lesson, report, tell),
             _plot(lesson, tell)]  # fmt: skip
    compared = [lesson["comparison"]] if lesson["comparison"] else []
    for row in [*compared, *lesson.get("comparisons", [])]:
        parts.append(f"<h3>{tell(beside(row))}</h3>")
        parts.append(listed([*row["sentences"], *row["refusals"]], tell))
    if lesson["gains"]:
        parts += [f"<h3>{tell(template('Before and after'))}</h3>", _gains(lesson["gains"], tell),
                  _topics(lesson, tell)]  # fmt: skip
    for row in lesson["later"]:
        parts.append(f"<h3>{tell(said('Form {form}', form=row['form']))}</h3>")
        parts.append(listed([*row["sentences"], *row["refusals"]], tell))
    parts.append(_items(lesson, tell))
    parts += [form_html(form, tell) for form in lesson["forms"]]
    return f'<section class="carts-class-lesson">{"".join(parts)}</section>'


def beside(row: Row) -> str:
    """The heading of a comparison."""
    first, second = row["groups"]
    return said("{first} beside {second}", first=first, second=second)


def of_group(name: str, sentence: str) -> str:
    """A sentence about one of several groups."""
    return said("{name}: {says}", name=name, says=sentence)


def group_in_form(form: str, group: str) -> str:
    """A group on one of the tests."""
    return said("{form}, {group}", form=form, group=group)


def _means(lesson: Row, report: Row, tell: Tell) -> str:
    """The first table: means and deviations, or why there are none."""
    rows, says = [], []
    for form in lesson["forms"]:
        for group in form["groups"]:
            if not group["n"] and len(report["groups"]) > 1:
                continue
            rows.append([tell(TITLES.get(form["form"], form["form"])), person(group["group"], tell),
                         str(group["n"]), mean_and_sd(group), tell(interval(group, form["of"])),
                         "–" if form["of"] is None else f"{form['of']}"])  # fmt: skip
            if sentence := group.get("sentence"):
                says.append(of_group(group_in_form(form["form"], group["group"]), sentence))
        if form["of"] is not None and (left := say.left_open(form["items"])):
            says.append(of_group(TITLES.get(form["form"], form["form"]), left))
        if not form["has_key"]:
            choose = template("Choose the key file as well.")
            says.append(say.unmarked(form["form"], lesson["lesson"], report, name_it=choose))
        elif form["unread"]:
            says.append(say.waiting(form))
    head = [template("form"), template("group"), template("students"),
            template("mean ± standard deviation"), template("95 % interval"),
            template("marks")]  # fmt: skip
    return table(list(map(tell, head)), rows, kind="means") + listed(says, tell)


def interval(group: Row, of: float | None) -> str:
    """From where to where."""
    if group.get("low") is None:
        return "–"
    low, high = say.within_marks(group["low"], group["high"], of)
    return said("{low} to {high}", low=number(low), high=number(high))


def _plot(lesson: Row, tell: Tell) -> str:
    rows: list[tuple[str, list[float], float, float | None]] = []
    highest = 0.0
    for form in lesson["forms"]:
        for group in form["groups"]:
            if "mean" in group:
                low = group["low"]
                half = None if low is None else group["mean"] - low
                several = len(form["groups"]) > 1
                name = group_in_form(form["form"], group["group"]) if several else form["form"]
                rows.append((name, group["totals"], group["mean"], half))
                highest = max(highest, form["of"] or group["most"])
    if not highest:  # nobody has a mark, and nobody knows how many there are: no scale
        return ""
    return f'<figure tabindex="0">{dots(rows, highest, tell)}</figure>'


ALONE = {
    "without_before": template("only after, so in no pair: {names}"),
    "without_after": template("only before, so in no pair: {names}"),
    "of_another_text": template("answered another text, so in no pair: {names}"),
}


def _gains(rows: Sequence[Row], tell: Tell) -> str:
    cells: list[list[str]] = []
    says: list[str] = []
    for row in rows:
        change = row.get("change")
        cells.append([
            person(row["group"], tell), str(row["n"]),
            mean_and_sd(row["pre"]), mean_and_sd(row["post"]),
            number(row["gain"]) if row.get("gain") is not None else "–",
            tell(_changed(change)) if change else "–",
            signed(row["d"]) if row.get("d") is not None else "–",
        ])  # fmt: skip
        found = [*row["sentences"], *row["refusals"]]
        found += [Said(words, {"names": commas(row[name])})
                  for name, words in ALONE.items() if row[name]]  # fmt: skip
        says += [of_group(row["group"], one) for one in found] if len(rows) > 1 else found
    head = [template("group"), template("took both"), template("before"), template("after"),
            template("gain g"), template("change (95 % interval)"), "d"]  # fmt: skip
    return table(list(map(tell, head)), cells, kind="gains") + listed(says, tell)


def _changed(change: Row) -> str:
    return said("{difference} ({low} to {high})", difference=signed(change["difference"]),
                low=signed(change["low"]), high=signed(change["high"]))  # fmt: skip


def _topics(lesson: Row, tell: Tell) -> str:
    """Gains topic by topic, and by how much two groups differ in each."""
    rows = lesson["topics"]
    if not rows:
        return ""
    head = [template("topic"), template("questions"), template("group"), template("took both"),
            template("before"), template("after"), template("gain g")]  # fmt: skip
    cells = [
        [
            text(row["topic"]), str(row["questions"]), person(row["group"], tell), str(row["n"]),
            mean_and_sd(row["pre"]), mean_and_sd(row["post"]),
            "–" if row["gain"] is None else number(row["gain"]),
        ]
        for row in rows
    ]  # fmt: skip
    title = tell(template("By topic"))
    made = table(list(map(tell, head)), cells, kind="topics")
    says = [row["sentence"] for row in lesson["topic_differences"]]
    return f"<h4>{title}</h4>{made}" + listed([*says, say.FEW_QUESTIONS], tell)


def _items(lesson: Row, tell: Tell) -> str:
    """Share of right answers, item by item, for all forms of at least ten students."""
    shares: dict[str, list[tuple[str, float]]] = {}
    labels: dict[str, str] = {}
    for form in lesson["forms"]:
        for item in form["items"]:
            if item["difficulty"] is not None and item["n"] >= 10:
                shares.setdefault(item["id"], []).append((form["form"], item["difficulty"]))
                labels.setdefault(item["id"], item["label"])
    shown = list(dict.fromkeys(form for values in shares.values() for form, _ in values))
    if not shares:
        return ""
    rows = [(labels[name], row) for name, row in shares.items()]
    return f'<figure tabindex="0">{bars(rows, shown, tell)}</figure>'
