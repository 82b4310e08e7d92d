"""What stands together on one page: scenes, questions, forms; and what does not fit together."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from sim.lesson import Question
from sim.lesson.kinds.run import Drawn, Reading
from sim.lesson.opening import Rule
from sim.pages.findings import Finding
from sim.pages.question.block import QuestionBlock
from sim.pages.question.quiz import QuizBlock
from sim.pages.text.fence_scan import Block, meant_kind, with_swallowed
from sim.scene import Fence, Problem

NO_SCENE = "no-such-scene"
OPEN = "none"  # after: none
FORCES = ".forces"  # after: SCENE.forces, until its hidden forces are found
IDEA = "idea"
BEFORE_A_RUN = (IDEA, "drawn")  # what these ask for is given before a run is seen


def watched_by(after: str) -> str:
    """The scene that a question with this `after` waits for; empty: it is open at once."""
    return "" if after == OPEN else after.removesuffix(FORCES)


@dataclass(slots=True)
class PageItems:
    """The blocks of a page that made sense, in the order of the page."""

    scenes: list[Fence] = field(default_factory=list)
    questions: list[QuestionBlock] = field(default_factory=list)
    scenes_above: list[int] = field(default_factory=list)  # of each question, how many
    quizzes: list[QuizBlock] = field(default_factory=list)
    laws: list[tuple[str, str]] = field(default_factory=list)
    """Id and hash of each block in which a reader writes a law."""
    optional: set[str] = field(default_factory=set)
    """Ids of questions in parts for who has time."""
    broken: set[str] = field(default_factory=set)
    """Ids of scenes with mistakes: they are known, and nothing more is said about them."""
    broken_questions: set[str] = field(default_factory=set)
    asking: str = ""  # the scene with a prediction that the text since the last heading is about

    @property
    def scene_ids(self) -> list[str]:
        """The ids of all scenes up to here."""
        return [scene.id for scene in self.scenes]

    def ask(self, block: QuestionBlock) -> None:
        """Take the next question of the page."""
        self.questions.append(block)
        self.scenes_above.append(len(self.scenes))

    def gate(self, question: Question) -> str:
        """The scene that is watched before the question opens; empty: it is open at once."""
        if after := question.common.after:
            return watched_by(after)
        if isinstance(question, Reading):
            own = next((s for s in self.scenes if s.id == question.scene), None)
            return question.scene if own and own.watched_first else ""
        return "" if question.KIND in BEFORE_A_RUN else self.asking

    def runs(self, scene: str) -> int:
        """How many are watched before what waits for the scene: one of each ready-made setting."""
        return max([1, *(len(one.presets) for one in self.scenes if one.id == scene)])

    def give_up(self, block: Block) -> None:
        """Remember that this block has mistakes, and so those that it swallowed."""
        for one in with_swallowed(block):
            if meant_kind(one.name) == "scene" and one.stated_id:
                self.broken.add(one.stated_id)
            if meant_kind(one.name) == "question" and one.stated_id:
                self.broken_questions.add(one.stated_id)

    def follows(self, finding: Finding) -> bool:
        """Whether it says no more than that a scene with mistakes is not there: under its own id,
        or under any where a scene has the id of another one here, and its own nobody knows."""
        return finding.code == NO_SCENE and (
            any(f"“{name}”" in finding.message for name in self.broken)
            or not self.broken.isdisjoint(self.scene_ids)
        )

    def first_causes(self, found: Iterable[Finding]) -> list[Finding]:
        """These findings and those of the whole page, without those that follow from others."""
        return [one for one in (*found, *self.findings()) if not self.follows(one)]

    @property
    def answers(self) -> bool:
        """Whether there is anything on the page to answer."""
        asked = any(s.predict for s in self.scenes)
        return bool(self.questions or self.quizzes or self.laws or asked)

    def findings(self) -> Iterator[Finding]:
        """Blocks that make sense alone but not together."""
        scenes = {scene.id: scene for scene in self.scenes}
        for block, above in zip(self.questions, self.scenes_above, strict=True):
            after = block.question.common.after
            scene = after.removesuffix(FORCES)
            if after not in ("", OPEN) and scene not in scenes:
                yield block.places.finding(self._no_such_scene("after", scene))
            elif after not in ("", OPEN) and scene not in self.scene_ids[:above]:
                message = f"the scene “{scene}” stands below this question"
                hint = "put the question below it, where the page says “the run above”"
                yield block.places.finding(Problem(("after",), "too-early", message, hint))
            elif after != scene and scenes[scene].forces != "hidden":
                message = f"the forces of “{scene}” are shown: there are none to find"
                hint = f"after: {scene}; or write forces: hidden into the scene"
                shown = Problem(("after",), "nothing-to-find", message, hint)
                yield block.places.finding(shown)
            if idea := self._no_such_idea(block.question.common.idea):
                yield block.places.finding(idea)
            if isinstance(block.question, (Reading, Drawn)):
                problem = self._misfit(block.question, scenes)
                if problem:
                    yield block.places.finding(problem)
        forms: dict[str, str] = {}
        for quiz in self.quizzes:
            other = forms.setdefault(quiz.form.form, quiz.form.id)
            if other != quiz.form.id:
                message = f"form: “{other}” is already the form “{quiz.form.form}” of this page"
                hint = "a page has one form of each kind: a student's answers are filed under it"
                yield quiz.places.finding(Problem(("form",), "twice", message, hint))
        for quiz in self.quizzes:
            before = [name for name in forms if name != quiz.form.form]
            yield from map(quiz.places.finding, self._never("open", quiz.form.open, before))
            if quiz.form.review:
                yield from map(quiz.places.finding, self._never("review", quiz.form.review, forms))

    def _never(self, key: str, rule: Rule, forms: Collection[str]) -> Iterator[Problem]:
        """What the rule waits for, where this page has no such thing to answer or to hand in."""
        if rule.done == "worksheet":
            if not self.questions and not any(scene.predict for scene in self.scenes):
                message = "this page has no question beside its forms: nothing opens this one"
                yield Problem((key, "done"), "unreachable", message, "word: FALCON")
        elif rule.done and rule.done not in forms:
            message = f"no other form of this page is “{rule.done}”: nothing opens this one"
            known = ", ".join(forms) or "none"
            yield Problem((key, "done"), "unreachable", message, f"forms of this page: {known}")

    def _no_such_idea(self, name: str) -> Problem | None:
        """What is wrong with the id of a first idea that is to be shown again."""
        ideas = [b.question.common.id for b in self.questions if b.question.KIND == IDEA]
        if not name or name in ideas or name in self.broken_questions:
            return None
        message = f"no question of type idea on this page is “{name[:40]}”"
        return Problem(("idea",), "no-such-idea", message,
                       f"first ideas of this page: {', '.join(ideas) or 'none'}")  # fmt: skip

    def _misfit(self, question: Reading | Drawn, scenes: dict[str, Fence]) -> Problem | None:
        if scene := scenes.get(question.scene):
            return _misfit(question, scene)
        return self._no_such_scene("scene", question.scene)

    def _no_such_scene(self, key: str, name: str) -> Problem:
        broken = (f"{id_} (which has mistakes)" for id_ in sorted(self.broken))
        known = ", ".join([*(scene.id for scene in self.scenes), *broken]) or "none"
        message = f"there is no scene “{name[:40]}” on this page"
        return Problem((key,), NO_SCENE, message, f"scenes of this page: {known}")

    def outline(self, lesson: str) -> dict[str, Any]:
        """What the page's script needs to know of all that can be answered here."""
        items = [
            {"id": s.id, "hash": predict_hash(s), "type": s.predict.kind, "form": "worksheet",
             "level": "core"}
            for s in self.scenes if s.predict
        ]  # fmt: skip
        items += [
            {"id": name, "hash": hash_, "type": "law", "form": "worksheet", "level": "core"}
            for name, hash_ in self.laws
        ]
        for block in self.questions:
            items.append(_item(block.question.data(key=False), "worksheet"))
        for quiz in self.quizzes:
            items += [_item(i.data(key=False), quiz.form.form) for i in quiz.form.items]
        named = "\n".join(f"{i['form']} {i['id']} {i['hash']}" for i in items)
        return {
            "lesson": lesson,
            "hash": hashlib.sha256(named.encode("utf-8")).hexdigest()[:12],
            "items": items,
        }


def predict_hash(scene: Fence) -> str:
    """Twelve hexadecimal digits that change when what is predicted does."""
    predict = scene.predict
    asked = predict and [
        predict.kind, predict.ask, predict.pairs, predict.cart, predict.options,
        *([] if predict.quantity == "F" else [predict.quantity]),  # older predictions were of F
        {key: str(value) for key, value in scene.plain.items() if key != "title"},
    ]  # fmt: skip
    text = json.dumps(asked, ensure_ascii=False, sort_keys=True)
    return hashlib.sha256(text.encode("utf-8")).hexdigest()[:12]


def _item(data: dict[str, Any], form: str) -> dict[str, Any]:
    return {name: data[name] for name in ("id", "hash", "type", "level")} | {"form": form}


def _misfit(question: Reading | Drawn, scene: Fence) -> Problem | None:
    if isinstance(question, Drawn):
        if scene.predict is None:
            message = f"the scene “{scene.id}” asks for no prediction"
            hint = "add predict: {arrows: [A-B]} to the scene"
            return Problem(("scene",), "no-prediction", message, hint)
        return None
    what, _, whose = question.quantity.partition(".")
    carts = [cart.name for cart in scene.scene.carts]
    pairs = [
        "-".join(scene.scene.names_at(k))
        for k, contact in enumerate(scene.scene.contacts)
        if contact is not None
    ]
    known_names = pairs if what == "F" else carts
    if whose not in known_names:
        message = f"the scene “{scene.id}” has no {what}.{whose}"
        hint = f"it has {', '.join(f'{what}.{name}' for name in known_names) or 'none'}"
        return Problem(("quantity",), "unknown-path", message, hint)
    if isinstance(question.at, float) and question.at > scene.scene.until:
        message = f"the run ends at {scene.scene.until:g} s, before {question.at:g} s"
        return Problem(("at",), "out-of-range", message, "at: end")
    return None
