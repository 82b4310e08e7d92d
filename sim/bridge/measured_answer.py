"""Readings of real carts, as the wire delivers them. This side keeps nothing between requests.

    {"id": 8, "kind": "measured", "do": "read", "texts": ["…"], "units": {"length": "cm"},
     "synthetic": false,     whether a program made them: they are evidence for no law
     "own": true}            whether the reader brought them; a lesson's own may be a question
    {"id": 9, "kind": "measured", "do": "model", …as read…, "law": "bumper", "hand": {…}}
    {"id": 10, "kind": "measured", "do": "fit", …as read…, "law": …, "effect": "friction",
     "distance": null, "together": false, "masses": {"A": 0.5}}
                                    effect "called": what the readings call for
    {"id": 11, "kind": "measured", "do": "tracker", …as fit…}
    {"id": 12, "kind": "measured", "do": "segments", …as read…, "segments": […]}
    {"id": 13, "kind": "measured", "do": "unzip", "zip": "UEsDB…"}      base64

What cannot be read or fitted is answered with `refused`: rows of line, reason and hint. Sentences
go as templates with their values (`wire` of sim.scene.said).
"""

from __future__ import annotations

from array import array
from binascii import a2b_base64
from collections.abc import Callable, Mapping
from dataclasses import replace
from math import isfinite
from typing import Any, cast

from sim.measured.analysis import Analysis, Wanted, analysed, happened
from sim.measured.events.by_hand import Given
from sim.measured.events.frames import moved
from sim.measured.events.story import Hints, Story
from sim.measured.events.stretch import KINDS
from sim.measured.model.contact import Law
from sim.measured.model.effects import rms_residual
from sim.measured.model.fit import warm_up
from sim.measured.model.motion import Parameters
from sim.measured.model.unknowns import Effect
from sim.measured.overlay import Overlay, by_hand, first_try, frequency, overlay
from sim.measured.refusal import FitError, ReadingError
from sim.measured.report import forces_report, model_as_tracker
from sim.measured.story_report import segment_rows
from sim.measured.third_law import third_law
from sim.measured.tracks import Measured, between, read_measured
from sim.measured.units import Units
from sim.measured.zipped import texts_of
from sim.scene.said import Said, said, wire

SHORTEST = 1e-4
"""s. A contact that a reader can set by hand."""


def measured_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """The header of the answer; there are no numbers beside it."""
    ways: dict[str, Callable[[Mapping[str, Any]], dict[str, Any]]] = {
        "read": _read,
        "model": _model,
        "segments": _segments,
        "fit": _fit,
        "tracker": _tracker,
        "ready": _ready,
        "unzip": _unzip,
    }
    try:
        header = ways[str(request.get("do"))](request)
        if not _finite(header):  # JSON has no infinity, and a picture no place for it
            raise FitError(said("with numbers as large or small as these it cannot be computed"))
    except ReadingError as error:
        rows = [{"line": f.line, "reason": f.reason, "hint": f.hint} for f in error.faults]
        header = {"refused": rows, "source": error.source}
    except FitError as error:
        header = {"refused": [{"line": None, "reason": error.reason, "hint": error.hint}]}
    return _wired(header), array("d")


def _finite(value: Any) -> bool:
    """Whether every number in it is."""
    if isinstance(value, (Mapping, list, tuple)):
        return all(map(_finite, value.values() if isinstance(value, Mapping) else value))
    return not isinstance(value, float) or isfinite(value)


def _wired(value: Any) -> Any:
    """The same with every sentence in it as the wire has it; numbers, which are many, are passed
    over."""
    if isinstance(value, Said):
        return wire(value)
    if isinstance(value, Mapping):
        return {key: _wired(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)) and value and not isinstance(value[0], float):
        return [_wired(one) for one in value]
    return value


def _measured(request: Mapping[str, Any]) -> Measured:
    units = request.get("units") or {}
    known = {key: str(units[key]) for key in ("time", "length", "force") if units.get(key)}
    chosen = Units(**known, run=str(request.get("run") or ""))
    found = read_measured([str(text) for text in request["texts"]], chosen)
    found = replace(found, synthetic=bool(request.get("synthetic")))
    begin, end = request.get("from"), request.get("until")
    return found if begin is None and end is None else between(found, begin, end)


def _law(request: Mapping[str, Any]) -> Law:
    return "paper" if request.get("law") == "paper" else "bumper"


def _read(request: Mapping[str, Any]) -> dict[str, Any]:
    """What stands in the text; for forces the comparison too, for carts a model to start with."""
    measured = _measured(request)
    answer = measured.plain() | {"run": measured.run, "runs": list(measured.runs)}
    if measured.kind != "length":
        pair = third_law(measured)
        return answer | {
            "report": forces_report(measured, pair),
            "forces": {"t": list(pair.t), "F": [list(force) for force in pair.forces]},
        }
    law = _law(request)
    return answer | _drawn(by_hand(measured, first_try(measured, law), law))


def _parameters(hand: Mapping[str, Any], start: Parameters, law: Law) -> Parameters:
    """What a reader has set, in SI; the rest as in `start`."""
    e = min(1.0, max(0.0, float(hand["e"])))
    return replace(
        start,
        touch=float(hand["touch"]),
        v=(float(hand["v"][0]), float(hand["v"][1])),
        ratio=max(1e-3, float(hand["ratio"])),
        e=e,
        w0=frequency(law, e, max(SHORTEST, float(hand["duration"]))),
    )


def _model(request: Mapping[str, Any]) -> dict[str, Any]:
    measured, law = _measured(request), _law(request)
    start = first_try(measured, law)
    return _drawn(by_hand(measured, _parameters(request["hand"], start, law), law))


def _analysed(request: Mapping[str, Any]) -> tuple[Measured, Analysis]:
    measured = _measured(request)
    if measured.kind != "length":
        raise FitError(said("these are no positions: the model is fitted to positions"))
    chosen = request.get("effect") or "none"
    effect: Effect | None = None if chosen == "called" else cast(Effect, chosen)
    weighed = request.get("masses") or {}
    masses = {name: float(weighed[name]) for name in measured.names if weighed.get(name)}
    # Of a lesson's readings they are named on request only: which one is missing is to be found.
    every = _named(request)
    hints = Hints(distance=request.get("distance"), together=bool(request.get("together")),
                  segments=_given(request, measured.names))  # fmt: skip
    found = analysed(measured, Wanted(
        law=_law(request), effect=effect, every=every, masses=masses, hints=hints,
    ))  # fmt: skip
    return measured, found


def _named(request: Mapping[str, Any]) -> bool:
    """Whether the answer may name which effect the readings call for."""
    return bool(request.get("compare") or request.get("own"))


def _given(request: Mapping[str, Any], names: tuple[str, str]) -> tuple[Given, ...]:
    """Segments that were set by hand; what names no cart here is left out."""
    rows = [row for row in request.get("segments") or () if row["kind"] in KINDS]
    rows = [row for row in rows if row.get("cart") in (None, *names)]
    return tuple(
        Given(row["kind"], float(row["from"]), float(row["until"]),
              None if row.get("cart") is None else names.index(row["cart"]))
        for row in rows
    )  # fmt: skip


def _segments(request: Mapping[str, Any]) -> dict[str, Any]:
    """What each cart did: found before anything is fitted. None where these are no positions."""
    measured = _measured(request)
    if measured.kind != "length":
        return {"names": list(measured.names), "segments": []}
    story = happened(measured, Hints(segments=_given(request, measured.names)))
    return {"names": list(measured.names), "segments": segment_rows(story)}


def _fit(request: Mapping[str, Any]) -> dict[str, Any]:
    measured, found = _analysed(request)
    if found.refused:  # what was found is shown all the same: a boundary may be set by hand
        one = found.refused
        return {"refused": [{"line": None, "reason": one.reason, "hint": one.hint}],
                "names": found.report["names"], "segments": found.report["segments"]}  # fmt: skip
    report = found.report if _named(request) else found.report | {"calls_for": None}
    law = _law(request)
    if found.fit is not None:
        frames = found.story.frames
        joined = frames is not None and frames.joined
        whole = moved(measured, frames) if frames and joined else measured  # set aside ones too
        drawn = overlay(whole, found.fit.parameters, law)
    else:
        drawn = by_hand(measured, first_try(measured, law), law)
        return {"report": report} | _drawn(drawn)
    shown = {"spread": rms_residual(found.fit), "counted": sum(map(len, found.fit.residuals))}
    return {"report": report} | _drawn(_as_read(drawn, found.story)) | shown


def _as_read(made: Overlay, story: Story) -> Overlay:
    """Curves and residuals on the axes on which the sensors read."""
    if story.frames is None or not story.frames.joined:
        return made
    axes = story.frames.axes
    x = [tuple(axis.sign * v + axis.zero for v in values)
         for axis, values in zip(axes, made.x, strict=True)]  # fmt: skip
    left = [tuple(axis.sign * r for r in values)
            for axis, values in zip(axes, made.residuals, strict=True)]  # fmt: skip
    return replace(made, x=(x[0], x[1]), residuals=(left[0], left[1]))


def _tracker(request: Mapping[str, Any]) -> dict[str, Any]:
    _, found = _analysed(request)
    if found.refused:
        raise found.refused
    if found.fit is None:
        raise FitError(said("the model's run is written for a bounce only"))
    return {"text": model_as_tracker(found.story.measured, found.fit)}


def _ready(_: Mapping[str, Any]) -> dict[str, Any]:
    """Imports what a fit needs: on a slow computer that takes some seconds."""
    return {"ready": warm_up()}


def _unzip(request: Mapping[str, Any]) -> dict[str, Any]:
    """The readings in a zip, as phyphox and Tracker make them."""
    (text,) = texts_of(a2b_base64(request["zip"]))
    return {"text": text}


def _drawn(made: Overlay) -> dict[str, Any]:
    p = made.parameters
    return {
        "parameters": {
            "touch": p.touch,
            "x": p.x,
            "distance": p.distance,
            "v": list(p.v),
            "ratio": p.ratio,
            "e": p.e,
            "duration": min(made.duration, 1e9),
        },
        "curve": {"t": list(made.t), "x": [list(x) for x in made.x]},
        "residuals": [list(track) for track in made.residuals],
        "spread": made.spread,
    }
