"""The search: scenes at random, then around the worst, until the budget of questions is used up.

The first scene is always the same usual one: a law that is wrong everywhere is shown there, where
it is easiest to read, unless another scene shows it far more. While a law still holds everywhere,
scenes are drawn at random; every other turn goes to the neighbourhood of the worst scene of a law
that is broken, for some turns of each.

A page asks in parts, so that it can tell how far the judge is: each part goes on from what the one
before has found, with random numbers of its own.
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.mine.instance import Written, read_law
from sim.mine.judge.chance import Chance
from sim.mine.judge.checks import CHECKS, FORCES, Found
from sim.mine.judge.scenes import WIDE, Draft, Space, at_random, draft_of, near, plain, usual
from sim.mine.judge.trial import Counter, Trial
from sim.mine.judge.verdict import Judgement, Verdict
from sim.scene.model import Scene

PARTS, IN_A_PART = 6, 10_000
"""What a page has time for within 5 s: parts, and questions to a law in each (four scenes)."""

IN_A_PAGE = PARTS * IN_A_PART

SEED = 20
FINER = 1_000.0
"""A suspicion is tried again with so much smaller errors: what the steps have made is gone then (a
law may have a kink in it), and what the law does is still there."""

CLEAR = 1e-2
"""No error of steps is so large."""

TRIES_NEAR = 6
"""Neighbours of the worst scene of one law."""


@dataclass(slots=True)
class Worst:
    """Of one law so far."""

    draft: Draft
    found: Found
    tries: int = 0


def judge(text: str, file: str = "mine.py", *, scene: Scene | None = None, seed: int = SEED,
          budget: int = IN_A_PAGE, space: Space = WIDE) -> Judgement:  # fmt: skip
    """Judge the law in `text`; raises `WrongLawError` where it gives no force.

    `scene`: where the judge begins, with the numbers that its contact has.
    """
    judged: Judgement | None = None
    for part in range(PARTS):
        judged = judge_part(
            text, file, part, judged, scene=scene, seed=seed, budget=budget // PARTS, space=space
        )
    assert judged is not None
    return judged


def judge_part(text: str, file: str, part: int, before: Judgement | None, *,
               scene: Scene | None = None, seed: int = SEED, budget: int = IN_A_PART,
               space: Space = WIDE) -> Judgement:  # fmt: skip
    """One part of the search, from what the part before it has found."""
    written, first = read_law(text, file), usual(scene)
    chance = Chance(seed + 1_000_003 * part)
    counter = Counter(budget * (part + 1), before.calls if before else 0)
    worst = {
        verdict.check: Worst(
            draft_of(verdict.scene) if verdict.scene else first,
            Found(verdict.amount, verdict.sentence),
        )
        for verdict in (before.verdicts if before else ())
    }
    scenes, draft = 0, first if part == 0 else _next(chance, written, first, worst, space)
    while not counter.over and scenes < budget:  # a law that is never asked costs nothing
        _look(written, draft, counter, worst)
        scenes += 1
        draft = _next(chance, written, first, worst, space)
    return Judgement(
        file,
        seed,
        scenes + (before.scenes if before else 0),
        counter.asked,
        tuple(_verdict(name, worst.get(name), written) for name in CHECKS),
    )


def _look(written: Written, draft: Draft, counter: Counter, worst: dict[str, Worst]) -> None:
    """All six in one scene."""
    trial = Trial(plain(draft, written.text, written.file), counter)
    finer = Trial(trial.plain, counter, FINER)
    for name, check in CHECKS.items():
        kept = check.kept_by_form(written)
        found = Found(0.0, "") if kept else check.of(trial)
        before = worst.get(name)
        if found is None or (before is not None and found.amount <= before.found.amount):
            continue
        if check.limit < found.amount < CLEAR and check.limit != FORCES:
            found = min(found, check.of(finer) or found, key=lambda one: one.amount)
        if before is None:
            worst[name] = Worst(draft, found)
        elif found.amount > before.found.amount:
            before.draft, before.found = draft, found


def _next(
    chance: Chance, written: Written, first: Draft, worst: dict[str, Worst], space: Space
) -> Draft:
    """Around a scene that is bad already, or anywhere."""
    broken = [
        one for name, one in worst.items()
        if one.found.amount > CHECKS[name].limit and one.tries < TRIES_NEAR
    ]  # fmt: skip
    if broken and chance.number() < 0.5:
        one = chance.one_of(broken)
        one.tries += 1
        return near(chance, one.draft, space, written.wants)
    return at_random(chance, space, written.wants, first)


def _verdict(name: str, worst: Worst | None, written: Written) -> Verdict:
    check = CHECKS[name]
    if worst is None or worst.found.amount <= check.limit:
        amount = worst.found.amount if worst else 0.0
        return Verdict(name, check.says, True, amount, check.limit, "", None)
    scene = plain(worst.draft, written.text, written.file)
    return Verdict(
        name, check.says, False, worst.found.amount, check.limit, worst.found.sentence, scene
    )
