"""A run that was stopped before its end: what there was too much of, and what would help.

Only what can help is named: a larger restitution where something is lost in a contact, more events
where events were counted, an earlier end where the run had begun.
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.scene.model import Scene


@dataclass(frozen=True, slots=True)
class Stopped:
    """What there was too much of."""

    what: str  # with its number
    more: bool  # would the run go on with more events? Not where the same ones come for ever
    steps: bool = False  # it was steps within contacts

    def __str__(self) -> str:
        return self.what

    def sentence(self, scene: Scene, t: float) -> str:
        """What happened at `t` [s], and what would help."""
        told = f"The run was stopped at t = {t:.6g} s after {self.what}."
        helps = self._helps(scene, t)
        return f"{told} Ask for {_or(helps)}." if helps else told

    def _helps(self, scene: Scene, t: float) -> list[str]:
        helps = []
        if t > 0.0:
            helps.append("an earlier end (until)")
        elif not self.more and not self.steps:
            helps.append("room between those that touch")
        if self.more:
            helps.append("more events (--max-events)")
        contacts = [contact for contact in scene.contacts if contact is not None]
        if any((contact.restitution or 0.0) < 1.0 for contact in contacts if not contact.joins):
            helps.append("a larger restitution")
        stiff = {contact.stiffness for contact in contacts if contact.stiffness is not None}
        stiff |= {
            e.numbers["stiffness"] for e in scene.effects if e.active and "stiffness" in e.numbers
        }
        differ = ["stiffnesses"] if len(stiff) > 1 else []
        differ += ["masses"] if len({cart.mass for cart in scene.carts}) > 1 else []
        if differ:
            helps.append(f"{' and '.join(differ)} that differ less")
        if self.steps and len(stiff) == 1:
            helps.append("a smaller stiffness")
        return helps


def _or(helps: list[str]) -> str:
    """A, B, or C."""
    if len(helps) < 3:
        return " or ".join(helps)
    return f"{', '.join(helps[:-1])}, or {helps[-1]}"
