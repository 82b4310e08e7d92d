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
const film = { setup, frames, view: { aim() {} }, say() {}, changed() {}, read() {} };
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
