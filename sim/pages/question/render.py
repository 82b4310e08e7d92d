"""From questions to `<carts-question>` and `<carts-quiz>`, which can be printed as they are."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from markupsafe import Markup

from sim.lesson import Question
from sim.lesson.form import Form
from sim.lesson.goal import NEAR
from sim.lesson.kinds.table import Table
from sim.lesson.question import CERTAINTY
from sim.pages.language import mark, tr, tr_html
from sim.pages.question.challenge import Challenge
from sim.pages.question.diagram import diagram
from sim.pages.question.inside import to_html, to_inline
from sim.pages.templates import script_json, templates

LINES = {"short": 1, "long": 5, "number": 1, "reading": 1}
LEVELS = {"core": "", "support": mark("a bit of help"), "stretch": mark("for more")}
FORM_NAMES = {"pre": mark("Before"), "post": mark("After"), "delayed": mark("Some time later")}
SURE = {"guess": mark("a guess"), "think": mark("I think so"), "sure": mark("I am sure")}


def the_run(scene: str, runs: int) -> Markup:
    """A link to what is watched first."""
    said = tr("the run above") if runs == 1 else tr("all the runs above")
    return Markup('<a href="#{}">{}</a>').format(scene, said)


def waits_line(scene: str, runs: int) -> str:
    """The line that stands in the place of text that waits for a scene."""
    link = the_run(scene, runs)
    told = tr_html("This part opens when you have watched {the_run}.", the_run=link)
    return f'<p class="carts-q-waits">{told}</p>'


def render_question(
    question: Question,
    *,
    number: int | None = None,
    key: bool = True,
    scope: str = "",
    after: str = "",
    runs: int = 1,
    found: bool = False,
) -> str:
    """HTML of the element. With `key` the page marks at once; without, nothing tells the answer.

    `number` is printed before the question. `scope` is the form it belongs to: the element's id
    and the form's name of the answer are `scope-id`. `after`: the scene that is watched first,
    in so many `runs`; with `found` its hidden forces are found first.
    """
    common = question.common
    element = f"{scope}-{common.id}" if scope else common.id
    texts = {name: Markup(to_inline(text)) for name, text in question.texts().items()}
    data = question.data(key=key) | {"element": element}
    view = {
        "id": element,
        "kind": question.KIND,
        "number": number,
        "after": after,
        "found": found,
        "the_run": the_run(after, 1 if found else runs),
        "level": common.level,
        "level_words": tr(LEVELS[common.level]),
        "minutes": common.minutes,
        "ask": Markup(to_html(common.ask)),
        "texts": texts,
        "data": data,
        "facts": script_json(data),
        "axes": _axes(question) if isinstance(question, Table) else (),
        "diagram": diagram(data["objects"]) if question.KIND == "interactions" else None,
        "lines": LINES.get(question.KIND, 0),
        "hints": [Markup(to_html(hint)) for hint in common.hints] if key else [],
        "feedback": _feedback(question) if key else {},
        "checks": key
        and question.MARKED  # else nothing is said to it
        and not (question.free and not common.explain),  # nothing to compare with
        "free": question.free,
        "certainty": [(word, tr(SURE[word])) for word in CERTAINTY],
        "sure": common.sure and question.KIND != "confidence",
    }
    return str(templates("sim.pages.question").get_template("question.html.j2").render(view))


def render_quiz(form: Form) -> str:
    """HTML of the element. An exam's holds no key, no hint and no feedback."""
    practice = form.mode == "practice"
    view: dict[str, Any] = {
        "id": form.id,
        "form": form.form,
        "mode": form.mode,
        "title": form.title or tr(FORM_NAMES[form.form]),
        "intro": Markup(to_html(form.intro)),
        "minutes": form.minutes,
        "count": len(form.items),
        "closed": bool(form.open.facts(form.id)),
        "asks_word": bool(form.open.word),
        "facts": script_json(form.facts()),
        "items": [
            Markup(render_question(item, number=k, key=practice, scope=form.id))
            for k, item in enumerate(form.items, start=1)
        ],
    }
    return str(templates("sim.pages.question").get_template("quiz.html.j2").render(view))


def render_challenge(challenge: Challenge) -> str:
    """HTML of `<carts-challenge>`, with what its script needs to judge a run."""
    labels = {
        control.set: {"label": str(control.label), "unit": control.unit, "per": control.per}
        for control in challenge.scene.controls
    }
    facts = {
        "scene": challenge.scene.id, "goal": asdict(challenge.goal), "near": NEAR, "labels": labels,
    }  # fmt: skip
    view = {
        "id": challenge.id,
        "ask": Markup(to_html(challenge.ask)),
        "facts": script_json(facts),
    }
    return str(templates("sim.pages.question").get_template("challenge.html.j2").render(view))


def _axes(question: Table) -> list[str]:
    """What stands at the axes of the points: the heads of their columns, with the unit."""
    made = []
    for column in question.plot or ():
        unit = question.unit_of(column)
        made.append(question.columns[column] + (tr(" in {unit}", unit=unit) if unit else ""))
    return made


def _feedback(question: Question) -> dict[str, Markup]:
    texts = dict(question.feedback())
    if question.common.explain:
        texts["explain"] = question.common.explain
    return {name: Markup(to_html(text)) for name, text in texts.items()}
