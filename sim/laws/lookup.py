"""From a description of a contact to its law."""

from __future__ import annotations

from functools import lru_cache
from importlib import import_module

from sim.laws.contact_law import ContactLaw
from sim.scene.laws import folder_of
from sim.scene.model import Contact


@lru_cache(maxsize=1024)
def contact_law(contact: Contact) -> ContactLaw | None:
    """The law of finite duration, or None: for a contact without, and for a law in a
    file, which only `sim.mine` can follow. One object per contact."""
    if contact.stiffness is None or contact.restitution is None or contact.written:
        return None
    module = import_module(f"sim.laws.{folder_of(contact.law)}.law")
    law: ContactLaw = module.make(contact.stiffness, contact.restitution)
    return law
