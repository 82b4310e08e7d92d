"""A run that takes long is told of, and gone when it is there: no browser, no real Python."""

from __future__ import annotations

import pytest

from tests.web.scene.given.widget_site import in_node

ASK = """
const usual = setInterval;
globalThis.setInterval = (act, ms) => usual(act, ms / 20); // twentieths of a second for seconds
const { Runs } = await import(source + "/scene/runs.js");
const reply = { header: { ok: false, problems: [] }, numbers: [] };
const later = (act) => setTimeout(act, 20 * data.seconds);
const client = {
  state: data.state,
  ask: (_, message) => new Promise((answer) => later(() => answer({ ...reply, sent: message() }))),
};
const told = [];
const long = (on) => told.push(on);
const runs = new Runs({}, client, { scene: () => ({}), draw() {}, say() {}, long });
await runs.ask().catch(() => {}); // the answer itself refuses
give(told);
"""


@pytest.mark.parametrize(
    ("state", "seconds", "told"),
    [("ready", 20, [True, False]), ("ready", 1, []), ("starting", 20, [])],
)
def test_a_long_run_is_told_of_while_it_lasts(state: str, seconds: int, told: list[bool]) -> None:
    """Of a start that takes long others tell."""
    assert in_node(ASK, {"state": state, "seconds": seconds}) == told
