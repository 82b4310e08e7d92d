"""Random scenes: any carts in a row, any walls, any contact laws, mixed."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

LAWS = ("bumper", "paper", "push-only", "push-only-uncorrected", "instant", "velcro")


def decimals(low: float, high: float, places: int = 3) -> st.SearchStrategy[str]:
    scale = 10**places
    whole = st.integers(round(low * scale), round(high * scale))
    return whole.map(lambda n: f"{n / scale:.{places}f}")


@st.composite
def contacts(draw: st.DrawFn) -> dict[str, Any]:
    law = draw(st.sampled_from(LAWS))
    contact: dict[str, Any] = {"law": law}
    if law != "velcro":
        least = 0.05 if law.startswith("push-only") else 0.0
        contact["restitution"] = draw(
            st.one_of(st.sampled_from(["1", "0.5"]), decimals(least, 1, 2))
        )
        if law.startswith("push-only") and float(contact["restitution"]) == 0:
            contact["restitution"] = "0.05"
    if law not in ("instant", "velcro"):
        contact["stiffness"] = draw(st.sampled_from([30, 400, 5000, 1e6]))
    return contact


@st.composite
def scenes(draw: st.DrawFn) -> dict[str, Any]:
    count = draw(st.integers(1, 5))
    edge, carts = 0.0, {}
    for k in range(count):
        gap = float(draw(st.one_of(st.just("0"), decimals(0, 0.3))))
        edge += gap
        carts[f"c{k}"] = {
            "mass": draw(st.one_of(st.sampled_from(["1", "2", "1000"]), decimals(0.05, 5, 2))),
            "position": f"{edge + 0.1:.6f}",
            "velocity": draw(st.one_of(st.sampled_from(["0", "1", "-1"]), decimals(-2, 2))),
        }
        edge += 0.2
    room = float(draw(decimals(0, 0.4)))
    plain: dict[str, Any] = {
        "carts": carts,
        "track": {
            "left": draw(st.sampled_from(["open", "wall"])),
            "right": draw(st.sampled_from(["open", "wall"])),
            "length": f"{edge + room:.6f}",
        },
        "contact": draw(contacts()),
        "until": draw(decimals(0.05, 3, 2)),
    }
    bodies = [
        *(["left"] if plain["track"]["left"] == "wall" else []),
        *carts,
        *(["right"] if plain["track"]["right"] == "wall" else []),
    ]
    if len(bodies) > 1 and draw(st.booleans()):
        k = draw(st.integers(0, len(bodies) - 2))
        plain["contact"]["pairs"] = {f"{bodies[k]}-{bodies[k + 1]}": draw(contacts())}
    return plain
