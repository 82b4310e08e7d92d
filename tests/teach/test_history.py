"""Steps of typing are told apart by time that passes, also when the clock is set back."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node


def test_a_clock_that_is_set_back_makes_no_endless_step() -> None:
    script = """
    const { History } = await import(`${source}/teach/history.js`);
    let [day, passed] = [1e12, 1000];
    Date.now = () => day;
    performance.now = () => passed;
    const history = new History("");
    history.change("a", "piece");
    day -= 3_600_000;
    passed += 60_000; // a minute later
    history.change("ab", "piece");
    history.undo();
    give(history.text);
    """
    assert in_node(script, None) == "a"
