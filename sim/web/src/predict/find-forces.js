/**
 * Where a scene hides the forces: the reader finds those of one contact, each from its own cart,
 * F = m Δv / Δt, and then sees them all: one force tells nothing of the other before. What was found
 * is kept with the answers, so it is there again at the next visit; half of a pair counts for its run.
 */

import { body, isWall } from "../../../view/bodies.js";
import { tr } from "../../../view/language.js";
import { short } from "../../../view/numbers.js";
import { capital } from "../../../view/words.js";
import { html, need, say } from "../shared/dom.js";
import { readTyped, withoutNewtons } from "../shared/typed.js";
import { Kept } from "../store/kept.js";
import { anyTouch, massOf, meanForces, velocity } from "./mean-forces.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("./mean-forces.js").Mean} Mean */

const NEAR = 0.05; // of the value: speeds are read to two figures
const MANY = 3; // tries until the numbers are offered
const TYPE = "found-force";

export class FindForces {
  /** @type {Mean[]} */
  #means = [];
  /** @type {Run | null} */
  #run = null;
  #tries = 0;
  #tried = ""; // the number that was checked last, and for which force: once more it is no other try
  /** @type {Map<string, string>} what was found: sentences by the names of cart and other */
  #found = new Map();

  /** @param {HTMLElement} root @param {string} id of the scene @param {(said: string[]) => void} found what to do then, with the sentences on what was found */
  constructor(root, id, found) {
    this.id = `${id}-forces`;
    this.kept = new Kept(this.id);
    this.found = found;
    this.which = /** @type {HTMLSelectElement} */ (need(root, ".carts-find-which"));
    this.box = /** @type {HTMLInputElement} */ (need(root, ".carts-find-value input"));
    this.button = /** @type {HTMLButtonElement} */ (need(root, ".carts-find-form button"));
    this.note = need(root, ".carts-find-note");
    need(root, ".carts-find-form").addEventListener("submit", (event) => {
      event.preventDefault();
      void this.#check();
    });
  }

  /** @param {Run} run a run that may be told: of a scene with a prediction after the lock, for both forces tell the answer */
  show(run) {
    const first = !this.#run;
    this.#run = run;
    if (first) void this.#restore();
    this.#means = meanForces(run);
    this.#found = this.#ofThisRun(this.#found);
    const names = this.#means.map(({ cart, other }) =>
      tr("{cart}, while it touches {other}", { cart, other: body(other, run.header.track) }),
    );
    const same = [...this.which.options].map((one) => one.text).join() === names.join();
    if (!same) this.which.replaceChildren(...names.map((name) => new Option(name)));
    for (const control of [this.which, this.box, this.button]) control.disabled = !names.length;
    if (names.length && this.#found.size) return this.#tell();
    say(this.note, names.length ? "" : whyNone(run));
  }

  /** The forces are shown at once where one was found before. */
  async #restore() {
    const kept = await this.kept.get();
    if (kept?.type !== TYPE) return;
    if (!Array.isArray(kept.found)) return this.found([]); // kept when one force was enough
    this.#found = this.#ofThisRun(new Map(kept.found));
    if (this.#found.size) this.#tell();
  }

  /** Both forces of a contact; of halves those that belong to this run: with one of another they would be no pair. @param {Map<string, string>} found */
  #ofThisRun(found) {
    if (isWhole(found)) return found;
    const now = new Map(this.#means.map((mean) => [keyOf(mean), this.#said(mean)]));
    return new Map([...found].filter(([key, said]) => now.get(key) === said));
  }

  /** @param {Mean} mean */
  #said({ cart, other, value }) {
    const track = /** @type {Run} */ (this.#run).header.track;
    const told = { cart, other: body(other, track), force: short(value) };
    return tr("mean force on {cart} by {other}: {force} N", told);
  }

  /** Shows all forces once those on both bodies of a contact were found; else says what is left. */
  #tell() {
    if (!this.#found.size) return; // the run is another one meanwhile
    if (isWhole(this.#found)) return this.found([...this.#found.values()]);
    const [cart = "", other = ""] = JSON.parse([...this.#found.keys()].at(-1) ?? "[]");
    const text = tr("Right. Now find the force on {other} too, from its own mass and velocities.", {
      other,
    });
    say(this.note, text);
    const next = this.#means.findIndex((mean) => mean.cart === other && mean.other === cart);
    if (next >= 0) this.which.selectedIndex = next;
  }

  async #check() {
    const mean = this.#means[this.which.selectedIndex];
    const read = readTyped(withoutNewtons(this.box.value));
    if (!mean || !this.#run) return;
    if (!("value" in read)) {
      return say(this.note, "problem" in read ? read.problem : tr("Type the number only, in N."));
    }
    const tried = `${keyOf(mean)} ${mean.value} ${read.value}`;
    if (tried !== this.#tried) this.#tries += 1;
    this.#tried = tried;
    const off = read.value / mean.value - 1;
    if (Math.abs(off) > NEAR) return say(this.note, this.#advice(mean, read.value));
    this.#found.set(keyOf(mean), this.#said(mean));
    await this.#keep(this.box.value);
    this.box.value = "";
    this.#tell();
  }

  /** @param {Mean} mean @param {number} typed in N */
  #advice(mean, typed) {
    const ratio = typed / mean.value;
    if (Math.abs(ratio + 1) <= NEAR) {
      return tr("The size is right. Which way does the force point? + is to the right.");
    }
    const mass = massOf(/** @type {Run} */ (this.#run), mean.cart);
    const others = isWall(mean.other) ? [] : [massOf(/** @type {Run} */ (this.#run), mean.other)];
    if (others.some((other) => Math.abs(Math.abs((ratio * mass) / other) - 1) <= NEAR)) {
      return tr(
        "That would fit the mass of {other}. The velocity of {cart} goes with the mass of {cart}.",
        { other: mean.other, cart: mean.cart },
      );
    }
    const steps = tr(
      "Not yet. Δv is the velocity of {cart} after minus before, with signs; Δt is how long the two touch.",
      { cart: mean.cart },
    );
    if (this.#tries < MANY) return steps;
    const v = (/** @type {number} */ t) =>
      short(velocity(/** @type {Run} */ (this.#run), mean.cart, t));
    const here = tr(
      "Here: m = {mass} kg, v before {before} m/s, v after {after} m/s, Δt = {time} s.",
      {
        mass: short(mass),
        before: v(mean.start),
        after: v(mean.end),
        time: short(mean.end - mean.start),
      },
    );
    return `${steps} ${here}`;
  }

  /** @param {string} typed */
  async #keep(typed) {
    const now = new Date().toISOString();
    const before = await this.kept.get();
    const elsewhere = Array.isArray(before?.found) ? before.found : []; // in another tab
    this.#found = new Map([...this.#ofThisRun(new Map(elsewhere)), ...this.#found]);
    const entry = {
      id: this.id,
      type: TYPE,
      value: typed,
      first: before?.first ?? now,
      last: now,
      said: [...this.#found.values()].join("; "),
      found: [...this.#found],
      tries: this.#tries,
      asked: tr("Find a force of this scene"),
    };
    await this.kept.put(entry).catch(() => {}); // refused: at the next visit it is found again
  }
}

/** Why a run has no force to find. @param {Run} run */
export function whyNone(run) {
  return anyTouch(run)
    ? tr(
        "In this run another force acts while two touch: there, m Δv/Δt is not the force of one body on the other.",
      )
    : tr("In this run no two touch for a time that can be read off.");
}

/** @param {Mean} mean */
const keyOf = ({ cart, other }) => JSON.stringify([cart, other]);

/** Whether the forces on both bodies of a contact were found; of a wall there is one. @param {Map<string, string>} found */
function isWhole(found) {
  return [...found.keys()].some((key) => {
    const [cart = "", other = ""] = JSON.parse(key);
    return isWall(other) || found.has(JSON.stringify([other, cart]));
  });
}

/** The next reader of a scene finds them too. @param {string} id of the scene */
export function forgetForces(id) {
  delete document.getElementById(id)?.dataset.found;
  new Kept(`${id}-forces`).forget().catch(() => {}); // refused: the next reader finds them found
}

/** The inside that shows the forces takes the place of the one that hides them. @param {HTMLElement} element @param {string[]} said what the reader found */
export function showForces(element, said) {
  const template = /** @type {HTMLTemplateElement} */ (need(element, "template.carts-shown"));
  const script = need(element, "script.carts-baked");
  const baked = JSON.parse(script.textContent ?? "");
  const differs = JSON.parse(template.dataset.baked ?? "");
  const frame = need(element, ".carts-frame");
  frame.replaceWith(template.content);
  script.textContent = JSON.stringify({ ...baked, ...differs });
  template.remove();
  element.dataset.found = ""; // for questions that wait for them
  element.dispatchEvent(new Event("carts-found", { bubbles: true }));
  const note = element.querySelector(".carts-found");
  if (!note) return;
  note.replaceChildren(
    html("b", "", tr("You found the forces.")),
    " ",
    said.map((sentence) => `${capital(sentence)}. `).join(""),
    tr(
      "Now they are shown at each instant. Yours are the means: the steady forces that would do the same in the same time.",
    ),
  );
  /** @type {HTMLElement} */ (note).hidden = false;
}
