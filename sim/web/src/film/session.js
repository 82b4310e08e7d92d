/** From a film to readings: open it, set marks and ruler, follow, mend, read; then the model is laid over it. */

import { joined } from "../../../view/language.js";
import { fixed } from "../../../view/numbers.js";
import { need, say } from "../shared/dom.js";
import { onEnter } from "../shared/enter.js";
import { click } from "./click.js";
import { Frames } from "./frames.js";
import { Helper } from "./helper.js";
import { Laid } from "./laid.js";
import { Mending } from "./mending.js";
import { offerMending } from "./offer.js";
import { marked, NAMES } from "./over.js";
import { Repair } from "./repair.js";
import { Scrub } from "./scrub.js";
import { FEWEST, Setup } from "./setup.js";
import { View } from "./view.js";
import * as words from "./words.js";

/** @typedef {import("./along.js").Point} Point */
/** @typedef {import("./helper.js").Refusal} Refusal */
/** @typedef {import("../measured/films.js").Take} Take */
/** @typedef {"opening" | "marking" | "following" | "followed" | "failed"} Phase */

const ALL = /** @type {import("./words.js").Aim[]} */ (["A", "B", "one", "other"]);
const TYPED = 600; // ms
const CARTS = /** @type {import("./words.js").Aim[]} */ (["A", "B"]);

export class Session {
  /** @type {Laid | null} what was followed */
  #laid = null;
  #clock = ""; // of the readings that were taken last
  #typing = 0; // another ruler, or slower: read anew when no more keys come
  /** @type {Repair | null} */
  #repair = null;

  /** @param {HTMLElement} root @param {File} file @param {Take} take */
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
      (refused) => this.#unseen(refused),
    );
    this.scrub = new Scrub(root, (step) => this.#seek(step));
    for (const input of this.setup.inputs) {
      input.addEventListener("input", () => {
        clearTimeout(this.#typing);
        if (this.phase === "followed") this.#typing = setTimeout(() => this.read(), TYPED);
      });
    }
    this.#on("follow", () => void this.follow());
    onEnter(this.setup.boxes.length, () => void this.follow());
    this.#on("cancel", () => this.helper.stop());
    this.#on("next", () => this.#repair?.next());
    this.#on("leave", () => this.#repair?.leave());
    this.#on("undo", () => this.#repair?.undo());
    this.#on("read", () => this.read());
    this.#on("again", () => this.#again());
    /** Resolves when the first frame is shown, or the film is refused. */
    this.ready = this.#open();
  }

  /** @param {string} name @param {() => void} act */
  #on(name, act) {
    this.#button(name).addEventListener("click", act);
  }

  /** @param {string} name @returns {HTMLButtonElement} */
  #button(name) {
    return need(this.root, `.carts-film-${name}`);
  }

  /** @param {Phase} phase */
  #become(phase) {
    this.phase = phase;
    this.root.dataset.phase = phase;
    const busy = phase === "following";
    this.setup.offered = phase === "marking" ? ALL : phase === "followed" ? CARTS : [];
    this.setup.show();
    this.scrub.disabled = busy || phase === "opening" || phase === "failed";
    this.#button("cancel").hidden = !busy;
    need(this.root, ".carts-film-part").hidden = !busy;
    need(this.root, ".carts-film-mend").hidden = phase !== "followed";
    this.#button("follow").hidden = phase === "followed";
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
      this.scrub.reach(facts);
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

  /** A frame of a film that was opened cannot be decoded; others can. @param {Refusal} refused */
  #unseen(refused) {
    if (this.phase === "opening" || refused.code === "lost") return this.#fail(refused);
    this.scrub.show(this.frames.time);
    this.#say(words.frameBroken());
  }

  /** @param {number} step so many frames on; 0: to where the slider is */
  #seek(step) {
    if (this.phase === "marking" && this.setup.marked) this.setup.forgetMarks();
    void (step ? this.frames.beside(step) : this.frames.want(this.scrub.time));
    if (this.phase === "marking") this.#changed();
  }

  /** @param {ImageBitmap} picture @param {number} time */
  #shown(picture, time) {
    this.scrub.show(time, this.frames.newer);
    this.view.show(picture, this.#marks());
  }

  /** What is drawn over the frame. */
  #marks() {
    return this.#laid?.marks(this.frames.time) ?? marked(this.setup.points, null);
  }

  /** Says what is to be done next. */
  #changed() {
    const { setup } = this;
    setup.show();
    if (this.#repair) offerMending(this.root, this.#repair.mending, setup.aim);
    if (this.phase !== "marking") return;
    const { placed, ruler, next } = setup;
    this.#button("follow").disabled = !placed || !ruler;
    this.#say(next);
    this.view.mark(this.#marks());
  }

  /** A place was chosen in the frame. @param {Point} point */
  async #set(point) {
    if (this.phase === "followed") return this.#repair?.set(point);
    if (this.phase !== "marking") return;
    const problem = await click(this, point);
    if (this.phase !== "marking") return;
    this.#changed();
    if (problem) this.#say(problem);
  }

  /** Follows both marks from the frame that is shown to the end of the film. */
  async follow() {
    if (this.phase !== "marking" || !this.setup.placed || !this.setup.ruler) return;
    const bar = /** @type {HTMLProgressElement} */ (need(this.root, ".carts-film-part"));
    bar.value = 0;
    this.#become("following");
    this.#say(words.following(0));
    const clicks = this.setup.marks.map(({ x, y }) => ({ x, y }));
    const asked = { do: "follow", time: this.frames.time, clicks };
    try {
      const { rows, broken } = await this.helper.ask(asked, (part) => {
        bar.value = part;
        this.#say(words.following(part));
      });
      if (rows && rows.length >= FEWEST) return this.#followed(rows, broken);
      this.#become("marking");
      this.#changed();
      if (!rows) return this.#say(words.cancelled());
      this.#say(joined([brokenAt(rows, broken), words.tooFew(rows.length, FEWEST)]));
    } catch (refused) {
      this.#fail(/** @type {Refusal} */ (refused));
    }
  }

  /** @param {import("./along.js").Row[]} rows @param {boolean} broken what comes after them cannot be read */
  #followed(rows, broken) {
    const { setup, view, frames } = this;
    const mending = new Mending(rows);
    const say = (/** @type {string} */ text) => this.#say(text);
    const changed = () => {
      offerMending(this.root, mending, setup.aim);
      view.mark(this.#marks());
    };
    const read = () => this.read();
    this.#laid = new Laid(mending, setup);
    this.#repair = new Repair(mending, { setup, view, frames, say, changed, read });
    setup.aim = ""; // a click that only means to look changes nothing
    this.#become("followed");
    const said = words.followed(rows.length, mending.counts(NAMES));
    this.#say(joined([brokenAt(rows, broken), said]));
    this.read();
    changed();
  }

  /** Back to the first clicks; the ruler stays. */
  #again() {
    this.#laid = null;
    need(this.root, ".carts-film-key").hidden = true;
    this.setup.forgetMarks();
    this.#become("marking");
    this.#changed();
  }

  /** Hands the readings over, as a file of readings would. */
  read() {
    const found = this.#laid?.read(this.file.name);
    if (!found) return;
    const { name, text, clock } = found;
    const same = this.#clock && (clock === this.#clock ? "clock" : "carts");
    this.#clock = clock;
    this.take(name, [text], same);
  }

  /** Shows the film where the model is; one that stands still leaves the film alone. @param {number} time s, of the readings @param {Record<string, number>} places m */
  at(time, places) {
    if (this.phase !== "followed" || !this.#laid) return;
    need(this.root, ".carts-film-key").hidden = false;
    if (this.#laid.at(time, places)) void this.frames.want(this.#laid.filmed(time));
    this.view.mark(this.#marks());
  }

  end() {
    clearTimeout(this.#typing);
    this.helper.end();
    this.view.end();
    this.root.remove();
  }
}

/** Where a film broke off, if it did. @param {import("./along.js").Row[]} rows @param {boolean} broken */
function brokenAt(rows, broken) {
  return broken ? words.brokenAt(fixed(Number(rows.at(-1)?.t), 2)) : "";
}
