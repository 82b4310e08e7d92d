/** From a film to readings: open it, set marks and ruler, follow, mend, read; then the model is laid over it. */

import { fixed } from "../../../view/numbers.js";
import { need, say } from "../shared/dom.js";
import { Along, readings } from "./along.js";
import { Frames } from "./frames.js";
import { Helper } from "./helper.js";
import { Mending } from "./mending.js";
import { crosses, marked, NAMES } from "./over.js";
import { Repair } from "./repair.js";
import { Setup } from "./setup.js";
import { View } from "./view.js";
import * as words from "./words.js";

/** @typedef {import("./along.js").Point} Point */
/** @typedef {import("./helper.js").Refusal} Refusal */
/** @typedef {"opening" | "marking" | "following" | "followed" | "failed"} Phase */

const ENDS = ["one", "other"];
const ALL = /** @type {import("./words.js").Aim[]} */ (["A", "B", "one", "other"]);
const TYPED = 600; // ms
const CARTS = /** @type {import("./words.js").Aim[]} */ (["A", "B"]);

export class Session {
  /** @type {Mending | null} */
  #mending = null;
  #typing = 0; // another ruler, or slower: read anew when no more keys come
  /** @type {Repair | null} */
  #repair = null;
  /** Where the model's carts are, m, and when, s of the readings. @type {{time: number, places: Record<string, number>}} */
  #model = { time: 0, places: {} };
  /** @type {Along | null} */
  #along = null;

  /** @param {HTMLElement} root @param {File} file @param {(name: string, text: string) => void} take */
  constructor(root, file, take) {
    this.root = root;
    this.file = file;
    this.take = take;
    this.helper = new Helper();
    this.setup = new Setup(root, () => this.#changed());
    this.view = new View(need(root, ".carts-film-view"), (point) => void this.#set(point));
    this.frames = new Frames(
      this.helper,
      (picture, time) => this.#shown(picture, time),
      (refused) => this.#fail(refused),
    );
    this.slider = /** @type {HTMLInputElement} */ (need(root, ".carts-film-time"));
    this.slider.addEventListener("input", () => this.#seek());
    for (const input of this.setup.inputs) {
      input.addEventListener("input", () => {
        clearTimeout(this.#typing);
        if (this.phase === "followed") this.#typing = setTimeout(() => this.read(), TYPED);
      });
    }
    this.#on("follow", () => void this.follow());
    this.#on("cancel", () => this.helper.stop());
    this.#on("next", () => this.#repair?.next());
    this.#on("leave", () => this.#repair?.leave());
    this.#on("read", () => this.read());
    this.#on("again", () => this.#again());
    /** Resolves when the first frame is shown, or the film is refused. */
    this.ready = this.#open();
  }

  /** @param {string} name @param {() => void} act */
  #on(name, act) {
    need(this.root, `.carts-film-${name}`).addEventListener("click", act);
  }

  /** @param {Phase} phase */
  #become(phase) {
    this.phase = phase;
    this.root.dataset.phase = phase;
    const busy = phase === "following";
    this.setup.show(phase === "marking" ? ALL : phase === "followed" ? CARTS : []);
    this.slider.disabled = busy || phase === "opening" || phase === "failed";
    need(this.root, ".carts-film-cancel").hidden = !busy;
    need(this.root, ".carts-film-part").hidden = !busy;
    need(this.root, ".carts-film-mend").hidden = phase !== "followed";
    need(this.root, ".carts-film-follow").hidden = phase === "followed";
  }

  /** @param {string} text */
  #say(text) {
    say(need(this.root, ".carts-film-say"), text);
  }

  async #open() {
    this.#become("opening");
    this.#say(words.opening());
    try {
      const { facts } = await this.helper.ask({ do: "open", file: this.file });
      this.facts = facts;
      Object.assign(this.slider, { min: facts.begin, max: facts.end, value: facts.begin });
      await this.frames.want(facts.begin);
      if (this.phase === "opening") this.#become("marking");
      this.#changed();
    } catch (refused) {
      this.#fail(/** @type {Refusal} */ (refused));
    }
  }

  /** @param {Refusal} refused */
  #fail({ code, detail }) {
    this.#become("failed");
    this.#say(words.refusal(code, detail));
  }

  #seek() {
    if (this.phase === "marking" && this.setup.marked) this.setup.forgetMarks();
    void this.frames.want(this.slider.valueAsNumber);
    if (this.phase === "marking") this.#changed();
  }

  /** @param {ImageBitmap} picture @param {number} time */
  #shown(picture, time) {
    this.slider.value = String(time);
    const clock = `${fixed(time, 3)} s`;
    this.slider.setAttribute("aria-valuetext", clock);
    say(need(this.root, ".carts-film-clock"), clock);
    this.view.show(picture, this.#marks());
  }

  /** What is drawn over the frame. */
  #marks() {
    const rows = this.#mending?.rows ?? [];
    const row = this.#mending ? (rows[this.#mending.at(this.frames.time)] ?? null) : null;
    const meant = this.#mending?.at(this.#filmed(this.#model.time));
    const places = row && row === rows[meant ?? -1] ? this.#model.places : {}; // of this frame only
    return [...marked(this.setup.points, row), ...crosses(places, this.#along, rows)];
  }

  /** Says what is to be done next. */
  #changed() {
    if (this.phase === "followed") this.setup.show(CARTS);
    if (this.phase !== "marking") return;
    this.setup.show(ALL);
    const follow = /** @type {HTMLButtonElement} */ (need(this.root, ".carts-film-follow"));
    follow.disabled = !this.setup.placed || !this.setup.ruler;
    const open = this.setup.points[this.setup.aim] === undefined || !this.setup.placed;
    this.#say(open ? words.asked(this.setup.aim) : words.askLength());
    this.view.mark(this.#marks());
  }

  /** A place was chosen in the frame. @param {Point} point */
  async #set(point) {
    if (this.phase === "followed") return this.#repair?.set(point);
    if (this.phase !== "marking") return;
    if (ENDS.includes(this.setup.aim)) this.setup.set(point);
    else {
      const { aim } = this.setup;
      const when = this.slider.value;
      const asked = { do: "mark", time: this.frames.time, click: point };
      const { mark } = await this.helper.ask(asked).catch(() => ({ mark: null }));
      if (this.setup.aim !== aim || this.slider.value !== when) return; // of another frame now
      if (!mark) return this.#say(words.nothingThere());
      this.setup.set(mark);
    }
    this.#changed();
  }

  /** Follows both marks from the frame that is shown to the end of the film. */
  async follow() {
    if (this.phase !== "marking" || !this.setup.ruler) return;
    const bar = /** @type {HTMLProgressElement} */ (need(this.root, ".carts-film-part"));
    bar.value = 0;
    this.#become("following");
    this.#say(words.following(0));
    const clicks = this.setup.marks.map(({ x, y }) => ({ x, y }));
    const asked = { do: "follow", time: this.frames.time, clicks };
    try {
      const { rows } = await this.helper.ask(asked, (part) => {
        bar.value = part;
        this.#say(words.following(part));
      });
      if (rows) this.#followed(rows);
      else {
        this.#become("marking");
        this.#changed();
        this.#say(words.cancelled());
      }
    } catch (refused) {
      this.#fail(/** @type {Refusal} */ (refused));
    }
  }

  /** @param {import("./along.js").Row[]} rows */
  #followed(rows) {
    const { setup, view, frames } = this;
    const say = (/** @type {string} */ text) => this.#say(text);
    const changed = () => view.mark(this.#marks());
    const read = () => this.read();
    this.#mending = new Mending(rows);
    this.#repair = new Repair(this.#mending, { setup, view, frames, say, changed, read });
    this.#become("followed");
    this.setup.aim = "A";
    this.setup.show(CARTS);
    this.#say(words.followed(rows.length, this.#mending.counts(NAMES)));
    this.read();
    this.view.mark(this.#marks());
  }

  /** Back to the first clicks; the ruler stays. */
  #again() {
    this.#mending = null;
    this.#along = null;
    need(this.root, ".carts-film-key").hidden = true;
    this.setup.forgetMarks();
    this.#become("marking");
    this.#changed();
  }

  /** Hands the readings over, as a file of readings would. */
  read() {
    const [ruler, rows] = [this.setup.ruler, this.#mending?.rows];
    if (!ruler || !rows) return;
    this.#along = new Along(rows, ruler);
    this.#model = { time: 0, places: {} };
    const { slower } = this.setup;
    const name = this.file.name.replace(/\.\w+$/, "");
    const remarks = [`Newton's Carts, from the film ${this.file.name.replace(/\s+/g, " ")}`];
    this.take(`${name}.csv`, readings(rows, ruler, { names: NAMES, slower, remarks }));
  }

  /** The time of the film when the readings say this one. @param {number} time s */
  #filmed(time) {
    return (this.#mending?.rows[0]?.t ?? 0) + time * this.setup.slower;
  }

  /** Shows the film where the model is; one that stands still leaves the film alone. @param {number} time s, of the readings @param {Record<string, number>} places m */
  at(time, places) {
    if (this.phase !== "followed") return;
    const moved = time !== this.#model.time;
    this.#model = { time, places };
    need(this.root, ".carts-film-key").hidden = false;
    if (moved) void this.frames.want(this.#filmed(time));
    this.view.mark(this.#marks());
  }

  end() {
    clearTimeout(this.#typing);
    this.helper.end();
    this.view.end();
    this.root.remove();
  }
}
