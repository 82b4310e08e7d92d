"""Single frames of a film, one that cannot be decoded, and a cancel that comes early: no page."""

from __future__ import annotations

import pytest

from tests.web.scene.given.widget_site import in_node

TIMES = [0.0, 0.033, 0.05, 0.1, 2.0]  # s: phones let the distance vary
FILM = """
globalThis.OffscreenCanvas = class {
  getContext = () => ({});
};
const { Film } = await import(`${source}/film/film.js`);
const broken = new Set();
const sink = {
  async *samples(time) {
    const first = data.findLastIndex((t) => t <= time);
    for (const timestamp of data.slice(Math.max(0, first))) {
      if (broken.has(timestamp)) throw new Error("cannot decode");
      yield { timestamp, close() {} };
    }
  },
};
const film = new Film(sink, { width: 9, height: 9, begin: 0, end: 2.1 });
"""
WORKER = """
const heard = [];
let answered = () => {};
globalThis.self = {
  postMessage: (message) => {
    heard.push(message);
    if (message.done) answered();
  },
};
const { Follower } = await import(`${source}/film/follow.js`);
Follower.of = () => ({ place: { x: 1, y: 1 }, box: () => ({}), take: () => ({ x: 2, y: 1 }) });
film.pixels = () => new Uint8ClampedArray(4);
film.picture = () => ({});
Film.open = async () => film;
await import(`${source}/film/worker.js`);
const ask = (message) => self.onmessage({ data: message });
const answers = (count) => new Promise((done) => {
  answered = () => heard.filter((one) => one.done).length === count && done();
});
"""
FOLLOW = 'ask({ id: 2, do: "follow", time: 0, clicks: [{ x: 1, y: 1 }, { x: 3, y: 1 }] });'


@pytest.mark.parametrize(
    ("begin", "step", "shown"),
    [
        (0.04, 1, 0.05),
        (0.04, -1, 0.0),
        (0.1, 1, 2.0),
        (2.0, -1, 0.1),
        (0.0, -1, 0.0),
        (2, 1, 2),
        (0.0, 3, 0.1),
        (2.0, -2, 0.05),
    ],
)
def test_the_frame_beside_another_is_the_next_one_of_the_file(
    begin: float, step: int, shown: float
) -> None:
    found = in_node(
        FILM + f"await film.at({begin}); give((await film.at({begin}, {step})).timestamp);", TIMES
    )
    assert found == shown


def test_after_a_frame_that_cannot_be_decoded_a_film_is_looked_through_anew() -> None:
    found = in_node(
        FILM
        + """
        broken.add(0.05);
        const tell = (one) => one.then(({ timestamp }) => timestamp, ({ message }) => message);
        give([await tell(film.at(0)), await tell(film.at(0.06)), await tell(film.at(0.1))]);
        """,
        TIMES,
    )
    assert found == [0.0, "cannot decode", 0.1]


def test_what_was_followed_before_a_broken_frame_is_kept() -> None:
    last = in_node(
        FILM
        + WORKER
        + f"""
        broken.add(0.1);
        ask({{ id: 1, do: "open" }});
        {FOLLOW}
        await answers(2);
        give(heard.at(-1));
        """,
        TIMES,
    )
    assert [row["t"] for row in last["rows"]] == TIMES[:3]
    assert last["broken"] is True


def test_a_cancel_pressed_while_following_waits_for_a_frame_counts() -> None:
    last = in_node(
        FILM
        + WORKER
        + f"""
        ask({{ id: 0, do: "open" }});
        ask({{ id: 1, do: "frame", time: 0 }});
        {FOLLOW}
        ask({{ id: 2, do: "stop" }});
        await answers(3);
        give(heard.at(-1));
        """,
        TIMES,
    )
    assert last == {"id": 2, "done": True, "rows": None}


BAR = """
const { parseHTML } = await import("linkedom");
const { document, Event } = parseHTML("<main></main>");
globalThis.document = document;
const root = document.querySelector("main");
const { inside } = await import(`${source}/film/skeleton.js`);
root.innerHTML = String(inside("one"));
"""


def test_arrow_keys_and_buttons_go_on_by_one_frame() -> None:
    moves = in_node(
        BAR
        + """
        const { Scrub } = await import(`${source}/film/scrub.js`);
        const moves = [];
        const scrub = new Scrub(root, (step) => moves.push(step));
        const press = (key) =>
          scrub.slider.dispatchEvent(Object.assign(new Event("keydown"), { key }));
        for (const key of ["ArrowRight", "ArrowUp", "ArrowLeft", "End", "PageUp"]) press(key);
        for (const button of scrub.buttons) button.click();
        scrub.show(0.5);
        scrub.show(0.6, true); // the reader's hand is ahead
        give([moves, scrub.slider.value, scrub.clock.textContent]);
        """,
        None,
    )
    assert moves == [[1, 1, -1, -1, 1], "0.5", "0.600 s"]


def test_a_clock_that_runs_is_not_told_frame_by_frame() -> None:
    """An <output> is a live region: a screen reader would be told of every frame."""
    assert in_node(BAR + 'give(root.querySelector(".carts-film-clock").tagName);', None) == "SPAN"


def test_reading_anew_leaves_the_frame_that_is_shown() -> None:
    moved, clocks = in_node(
        """
        const { Mending } = await import(`${source}/film/mending.js`);
        const { Laid } = await import(`${source}/film/laid.js`);
        const ruler = { ends: [{ x: 0, y: 0 }, { x: 9, y: 0 }], length: 0.5 };
        const setup = { points: {}, slower: 1, ruler };
        const laid = new Laid(new Mending(data), setup);
        const clocks = [laid.read("our film.mp4").clock];
        const moved = [laid.at(0.1, { A: 1 })];
        setup.ruler = { ...ruler, length: 0.6 };
        clocks.push(laid.read("our film.mp4").clock);
        moved.push(laid.at(0.1, { A: 1 }));
        setup.slower = 8;
        clocks.push(laid.read("our film.mp4").clock);
        give([moved, clocks]);
        """,
        [
            {"t": t, "marks": [{"x": 1 + t, "y": 1}, {"x": 5, "y": 1}]}
            for t in (0.0, 0.1, 0.2)
        ],
    )  # fmt: skip
    assert moved == [True, False]
    assert clocks[0] == clocks[1] != clocks[2]  # another ruler leaves the clock alone


def test_what_cannot_be_mended_is_not_offered_and_the_focus_goes_on() -> None:
    """Before, “Next lost place” could be pressed where none was lost."""
    found = in_node(
        BAR
        + """
        const { offerMending } = await import(`${source}/film/offer.js`);
        const { Mending } = await import(`${source}/film/mending.js`);
        const { Repair } = await import(`${source}/film/repair.js`);
        const mending = new Mending(data);
        const seen = [];
        const setup = { aim: "", show() {} };
        const film = { setup, say() {}, read() {} };
        film.view = { aim() {}, reveal: () => seen.push("revealed") };
        film.frames = { time: 0, want: async (time) => void (film.frames.time = time) };
        const of = (name) => root.querySelector(`.carts-film-${name}`);
        of("read").focus = () => seen.push("focus on read");
        film.changed = () => {
          offerMending(root, mending, setup.aim);
          seen.push(["next", "leave", "undo"].filter((name) => !of(name).disabled).join(" "));
        };
        const repair = new Repair(mending, film);
        film.changed();
        repair.next();
        await new Promise((done) => setTimeout(done));
        Object.defineProperty(document, "activeElement", { get: () => of("leave") });
        repair.leave();
        give(seen);
        """,
        [
            {"t": 0.0, "marks": [{"x": 1, "y": 1}, {"x": 5, "y": 1}]},
            {"t": 0.1, "marks": [None, {"x": 5, "y": 1}]},
        ],
    )
    assert found == ["next", "next leave", "revealed", "focus on read", "undo"]
