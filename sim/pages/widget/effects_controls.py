"""The card with switches and sliders of what acts. Twin of its behaviour: `web/src/switches.js`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.pages.language import heard, tr
from sim.pages.widget.effects_scale import effect_target
from sim.pages.widget.panel import control_view


def effect_cards(fence: Any, header: Mapping[str, Any]) -> list[dict[str, Any]]:
    """One card, or none where the lesson offers nothing of that kind."""
    own = [c for c in fence.controls if effect_target(c.set, header["effects"]) is not None]
    switches = [{"set": s.set, "label": heard(s.label), "value": s.value} for s in fence.switches]
    if not own and not switches:
        return []
    sliders = [control_view(control, "") for control in own]
    return [{"title": tr("What acts"), "switches": switches, "controls": sliders}]
