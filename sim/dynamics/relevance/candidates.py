"""The same scene with one thing added, or with one thing left out.

Added is what a scene does not list: at the size of the scene's own `estimate`, or else at the usual
one that the effect's folder tells. Left out is what it lists. Contacts count too: one that takes
time is made sudden, a sudden one is given the default bumper.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from sim.effects.estimates import estimate_of, usual
from sim.laws.lookup import contact_law
from sim.scene.effects import Effect, kinds
from sim.scene.laws import laws
from sim.scene.model import Contact, Scene
from sim.scene.said import said

CONTACT = "contact"
"""What the row about the time that contacts take is called, beside the names of effects."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidate:
    """One thing that a scene has or has not. `scene` None: there is nothing to run, and `why`."""

    effect: str
    called: str
    listed: bool
    scene: Scene | None
    size: str = ""
    source: str = ""
    why: str = ""


def candidates(scene: Scene) -> Iterator[Candidate]:
    """One for each kind of effect in the order of lists, then that of the contacts."""
    for name, kind in kinds().items():
        called = kind.called or name
        if any(effect.kind == name for effect in scene.effects):
            kept = tuple(effect for effect in scene.effects if effect.kind != name)
            without = replace(scene, effects=kept)
            yield Candidate(effect=name, called=called, listed=True, scene=without)
        else:
            yield _added(name, called, scene)
    if any(contact is not None for contact in scene.contacts):
        yield _other_contacts(scene)


def _added(name: str, called: str, scene: Scene) -> Candidate:
    own = [effect for effect in scene.estimates if effect.kind == name and effect.active]
    added: list[Effect] = own or [e for e in (usual(name, scene),) if e is not None]
    if not added:
        why = said("it has no usual size; give one under estimate")
        return Candidate(effect=name, called=called, listed=False, scene=None, why=why)
    found = None if own else estimate_of(name)
    if found is not None:
        size, source = found.size, found.source
    else:
        size, source = ", ".join(map(_numbers, own)), said("given by the scene")
    first = 1 + max((effect.index for effect in scene.effects), default=-1)
    acting = (*scene.effects, *(replace(e, index=first + k) for k, e in enumerate(added)))
    changed = replace(scene, effects=acting)
    return Candidate(
        effect=name, called=called, listed=False, scene=changed, size=size, source=source
    )


def _numbers(effect: Effect) -> str:
    fields = {field.key: field for field in kinds()[effect.kind].fields}
    told = (
        f"{value:g} {fields[key].dimension.si}".strip()
        for key, value in effect.numbers.items()
        if key in fields and value
    )
    return ", ".join(told)


def _other_contacts(scene: Scene) -> Candidate:
    """Sudden contacts where they took time; else the bumper that a scene has by default."""
    soft = next(law for law in laws().values() if law.stiffness is not None)
    sudden = next(law for law in laws().values() if law.stiffness is None and law.restitution)
    listed = any(contact is not None and not contact.sudden for contact in scene.contacts)
    called = said("the time that contacts take")
    usual_stiffness = soft.stiffness.default if soft.stiffness is not None else None
    stiffness = float(usual_stiffness or 0.0)

    def other(contact: Contact | None) -> Contact | None:
        if contact is None or contact.joins or contact.sudden == listed:
            return contact
        if listed:
            # A law may deliver another e than its key asks for: that is not what is left out.
            e = getattr(contact_law(contact), "delivered", contact.restitution)
            return replace(contact, law=sudden.name, stiffness=None, restitution=e)
        return replace(contact, law=soft.name, stiffness=stiffness)

    if listed and any(gap < 0.0 for gap in scene.gaps):
        why = said("bumpers are pressed in at the start")
        return Candidate(effect=CONTACT, called=called, listed=True, scene=None, why=why)
    changed = replace(scene, contacts=tuple(map(other, scene.contacts)))
    if changed.contacts == scene.contacts:
        why = said("what touches stays together")
        return Candidate(effect=CONTACT, called=called, listed=False, scene=None, why=why)
    if listed:
        return Candidate(effect=CONTACT, called=called, listed=True, scene=changed)
    size, source = f"{stiffness:g} N/m", said("the bumper of a scene that says nothing else")
    return Candidate(
        effect=CONTACT, called=called, listed=False, scene=changed, size=size, source=source
    )
