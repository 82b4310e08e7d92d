"""The element's own functions: `set`, `time`, `trajectory`, `ready`, and what they measure."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import live, on_scene, widget_site

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


def test_the_element_keeps_its_promises(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    told = on_scene(
        page,
        """
        await el.ready;
        const heard = [];
        el.addEventListener("carts-update", ({ detail }) => heard.push(detail));
        await el.set({ "A.mass": 2, "contact.restitution": "0.5" });
        const { trajectory, plan } = el;
        const last = trajectory.t.length - 1;
        const out = { heard, v: [trajectory.v.A[last], trajectory.v.B[last]], plan: plan.length };
        out.kinds = [trajectory.t, trajectory.x.A, trajectory.F["A-B"]].map((c) =>
          c instanceof Float64Array);
        out.events = trajectory.events.length;
        el.time = 1.25;
        out.time = el.time;
        out.measures = performance.getEntriesByName("carts:update").length;
        return out;
        """,
    )
    assert told["heard"] == [{"A.mass": 2, "contact.restitution": "0.5"}]
    assert told["kinds"] == [True] * 3
    assert told["plan"] > 1
    assert told["events"] > 3
    assert told["time"] == 1.25
    assert told["measures"] == 1
    assert page.locator("#meeting .carts-clock").inner_text().startswith("1.25")
    # 2 kg at 0.6 m/s meets 1 kg at rest, e = 0.5: 0.3 and 0.6 m/s; then B comes back from the wall
    assert min(told["v"]) < 0.3


@pytest.mark.one_browser
def test_a_value_that_makes_no_sense_is_refused_and_the_run_stays(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    told = on_scene(
        page,
        """
        const before = el.trajectory;
        const errors = [];
        for (const changes of [{ "A.mass": -1 }, { "A.mass": "1 s" }, { "Z.mass": 1 },
          { "A.mass": "NaN" }, { "contact.restitution": 2 }]) {
          await el.set(changes).catch((error) => errors.push(error.message));
        }
        const same = el.trajectory === before;
        await el.set({ "A.velocity": 0.7 });
        return { errors, same, after: el.trajectory.v.A[0] };
        """,
    )
    assert len(told["errors"]) == 5
    assert all(told["errors"])
    assert told["same"]
    assert told["after"] == pytest.approx(0.7)


@pytest.mark.one_browser
def test_an_hour_of_use_does_not_fill_the_memory_with_measures(
    open_page: OpenPage, widget_site: Path
) -> None:
    """The browser keeps each measure for ever; a slider moved for ten minutes makes 10 000. Of
    whatever scene: this one is soon computed."""
    page = live(open_page(widget_site / "coasting.html"), "coasting")
    kept = on_scene(
        page,
        """
        const counts = [];
        for (let k = 0; k < 210; k += 1) {
          await el.set({ "A.mass": 1 + (k % 9) / 10 });
          counts.push(performance.getEntriesByName("carts:update").length);
        }
        return counts;
        """,
        name="coasting",
    )
    assert kept[:3] == [1, 2, 3]
    assert max(kept) <= 200
    assert kept[-1] > 0
