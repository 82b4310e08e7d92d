"""Of two films wanted one after the other the newer one stays; the camera is let go of."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

BENCH = """
globalThis.location = { protocol: "file:" };
const part = () => new EventTarget();
const bench = { querySelector: part };
const { Films } = await import(`${source}/measured/films.js`);
const films = new Films(bench, "https://school.example/measured.js?1", () => {}, () => {});
const said = [];
const made = (name) => (said.push(`${name} begins`), { end: () => said.push(`${name} ends`) });
"""


def test_of_two_films_chosen_quickly_one_worker_stays() -> None:
    said = in_node(
        BENCH
        + """
        globalThis.cartsFilm = { open: (_, file) => made(file.name) };
        await Promise.all([films.open({ name: "one" }), films.open({ name: "two" })]);
        give(said);
        """,
        None,
    )
    assert said == ["two begins"]


def test_a_camera_that_is_allowed_after_a_film_was_chosen_ends_at_once() -> None:
    said = in_node(
        BENCH
        + """
        let allow;
        const camera = () => new Promise((done) => (allow = () => done(made("camera").end)));
        globalThis.cartsFilm = { open: (_, file) => made(file.name), camera };
        const filming = films.camera();
        await new Promise((done) => setTimeout(done));
        await films.open({ name: "chosen" });
        allow();
        await filming;
        give(said);
        """,
        None,
    )
    assert said == ["chosen begins", "camera begins", "camera ends"]


def test_a_camera_whose_picture_cannot_be_recorded_is_let_go_of() -> None:
    said = in_node(
        """
        globalThis.document = { documentElement: { lang: "en" } };
        const said = [];
        const stream = { getTracks: () => [{ stop: () => said.push("stopped") }] };
        Object.defineProperty(globalThis, "navigator", {
          value: { mediaDevices: { getUserMedia: async () => stream } },
        });
        globalThis.MediaRecorder = class {
          static isTypeSupported = () => false;
          constructor() {
            throw new Error("NotSupportedError");
          }
        };
        const { filmWithCamera } = await import(`${source}/film/camera.js`);
        const end = await filmWithCamera({}, () => {}, () => said.push("told"));
        end();
        give(said);
        """,
        None,
    )
    assert said == ["stopped", "told"]


REPAIR = """
globalThis.document = { documentElement: { lang: "en" } };
const { Frames } = await import(`${source}/film/frames.js`);
const { Mending } = await import(`${source}/film/mending.js`);
const { Repair } = await import(`${source}/film/repair.js`);
const asked = [];
const helper = { ask: ({ time }) => new Promise((done) => asked.push(() => done({ time }))) };
const frames = new Frames(helper, () => {}, () => {});
const mending = new Mending(data);
const setup = { aim: "A", show() {} };
const film = { setup, frames, view: { aim() {}, reveal() {} }, say() {}, changed() {}, read() {} };
const repair = new Repair(mending, film);
const turn = () => new Promise((done) => setTimeout(done));
const decoded = async () => {
  while (asked.length) {
    asked.shift()();
    await turn();
  }
};
repair.next();
await decoded();
repair.leave();
repair.leave(); // pressed twice
repair.set({ x: 99, y: 99 }); // and a click, while the next frame is decoded
const early = structuredClone(mending.rows);
await decoded();
repair.leave();
give([early, mending.rows, mending.lost]);
"""


def test_pressed_twice_leave_it_out_takes_no_place_that_was_found() -> None:
    place = {"x": 1, "y": 1}
    rows = [
        {"t": 0.0, "marks": [place, place]},
        {"t": 0.1, "marks": [None, place]},
        {"t": 0.2, "marks": [place, None]},
    ]
    early, late, lost = in_node(REPAIR, rows)
    assert early == late == rows
    assert lost == []


PLACES = """
globalThis.document = { documentElement: { lang: "en" } };
const { Mending } = await import(`${source}/film/mending.js`);
const { Repair } = await import(`${source}/film/repair.js`);
const said = [];
const mending = new Mending(data);
const setup = { aim: "", show() {} };
const film = { setup, view: { aim() {}, reveal() {} }, changed() {} };
film.read = () => said.push("read");
film.frames = { time: 0, want: async (time) => void (film.frames.time = time) };
film.say = (text) => said.push(text);
const repair = new Repair(mending, film);
const turn = () => new Promise((done) => setTimeout(done));
"""
FOUND = {"t": 0.0, "marks": [{"x": 1, "y": 1}, {"x": 5, "y": 1}]}
LOST = {"t": 0.1, "marks": [None, {"x": 6, "y": 1}]}


def test_a_click_after_following_changes_nothing_until_a_mark_is_chosen() -> None:
    said, rows = in_node(
        PLACES + "repair.set({ x: 9, y: 9 }); repair.leave(); give([said, mending.rows]);", [FOUND]
    )
    assert rows == [FOUND]
    assert said == ["Press the button of a mark first; a click then sets its place anew."] * 2


def test_a_place_that_was_set_anew_is_told_and_can_be_taken_back() -> None:
    said, changed, back, undoable = in_node(
        PLACES
        + """
        setup.aim = "B";
        repair.set({ x: 9, y: 9 });
        const changed = structuredClone(mending.rows);
        repair.undo();
        repair.undo(); // there is one step, no more
        give([said, changed, mending.rows, mending.undoable]);
        """,
        [FOUND],
    )
    assert changed[0]["marks"] == [{"x": 1, "y": 1}, {"x": 9, "y": 9}]
    assert back == [FOUND] and not undoable
    assert said == ["B at 0.000 s was set anew.", "B at 0.000 s is as it was."]


def test_a_lost_place_whose_click_is_taken_back_is_asked_for_again() -> None:
    said, rows, aim = in_node(
        PLACES
        + """
        repair.next();
        await turn();
        repair.set({ x: 9, y: 9 });
        const { aim } = setup; // no place is left: nothing is aimed at
        repair.undo();
        await turn();
        give([said, mending.rows, aim]);
        """,
        [FOUND, LOST],
    )
    click = "Lost at 0.100 s. Click where the mark of cart A is."
    assert said == [click, "No lost place is left.", "read", click]
    assert rows == [FOUND, LOST]
    assert aim == ""


SHOWN = """
const { Frames } = await import(`${source}/film/frames.js`);
const [asked, shown, failed] = [[], [], []];
const helper = {
  ask: async ({ time, step }) => {
    asked.push([time, step]);
    if (time === 13) throw new Error("broken");
    return { time: time + step };
  },
};
const frames = new Frames(helper, (_, time) => shown.push(time), () => failed.push(frames.time));
"""


def test_a_step_goes_on_from_the_frame_that_is_shown() -> None:
    asked = in_node(
        SHOWN
        + """
        await frames.want(4);
        await frames.beside(1);
        await frames.beside(-1);
        give(asked);
        """,
        None,
    )
    assert asked == [[4, 0], [4, 1], [5, -1]]


def test_after_a_frame_that_cannot_be_decoded_others_are_shown() -> None:
    shown, failed, newer = in_node(
        SHOWN
        + """
        await frames.want(4);
        const broken = frames.want(13);
        frames.want(6); // while that one is decoded
        const { newer } = frames;
        await broken;
        give([shown, failed, newer]);
        """,
        None,
    )
    assert shown == [4, 6]
    assert failed == [4]
    assert newer
