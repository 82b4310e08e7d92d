/**
 * `<carts-challenge>`: counts the runs that a reader has tried, and says which one reached the goal.
 * No score: to have found none is an answer too.
 */

import { listed } from "../../../view/bodies.js";
import { tr } from "../../../view/language.js";
import { short } from "../../../view/numbers.js";
import { need, say } from "../shared/dom.js";
import { asText } from "../shared/settings.js";
import { recall, retain } from "../shared/tab.js";
import { triedKeeper } from "./challenge-kept.js";
import { masses, setBy } from "./forms/run.js";
import { isMet } from "./marking/goal.js";
import { plainText } from "./plain-text.js";

const SETTLED = 800; // ms: a slider that is still being pulled makes no run that was looked at

/** @typedef {{scene: string, near: number, goal: import("./marking/goal.js").Goal, labels: Record<string, {label: string, unit: string, per: number}>}} Facts */
/** @typedef {{before: number, tried: string[], found: {run: number, values: string} | null}} Tries `before`: how many at earlier visits */

export class ChallengeElement extends HTMLElement {
  /** @type {Facts} */
  #facts = JSON.parse("{}");
  /** @type {Tries} */
  #tries = { before: 0, tried: [], found: null };
  /** @type {ReturnType<typeof triedKeeper> | null} */
  #keeper = null;
  #leaving = new AbortController();
  #timer = 0;
  #restored = Promise.resolve(); // when what was tried at earlier visits is known

  connectedCallback() {
    this.#facts = JSON.parse(need(this, ".carts-challenge-facts").textContent ?? "{}");
    this.#tries = kept(this.#name);
    this.#leaving = new AbortController();
    const { signal } = this.#leaving;
    for (const kind of ["carts-update", "carts-watched"]) {
      document.addEventListener(kind, (event) => this.#heard(event), { signal });
    }
    this.#show();
    this.#keeper ??= triedKeeper(this.id);
    this.#keeper.hear(() => void this.#restore(), signal);
    this.#restored = this.#restore();
  }

  disconnectedCallback() {
    clearTimeout(this.#timer);
    this.#leaving.abort();
  }

  /** What was tried in another tab, or on another day. */
  async #restore() {
    const earlier = await this.#keeper?.get();
    if (!earlier || earlier.runs <= this.#runs) return;
    this.#tries.before = earlier.runs - this.#tries.tried.length;
    if (earlier.found) this.#tries.found ??= { run: earlier.found, values: earlier.values };
    this.#show();
  }

  get #runs() {
    return this.#tries.before + this.#tries.tried.length;
  }

  /** @param {Event} event of a scene */
  #heard({ target }) {
    if (!(target instanceof HTMLElement) || target.id !== this.#facts.scene) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      void this.#restored.then(() => this.#count(target));
    }, SETTLED);
  }

  /** A run that stands: each setting counts once. @param {HTMLElement} scene */
  #count(scene) {
    const run = /** @type {any} */ (scene).trajectory;
    const first = scene.querySelector(".carts-end") !== null; // it is watched before it is known
    if (!run || (first && !("watched" in scene.dataset))) return;
    const set = setBy(scene);
    const again = this.#tries.before > 0 && Object.keys(set).length === 0;
    if (again) return; // as the lesson sets it: that was the first at the first visit
    const key = asText(set);
    const { tried } = this.#tries;
    if (tried.includes(key)) return;
    tried.push(key);
    const { goal, near } = this.#facts;
    if (!this.#tries.found && isMet(goal, run, masses(scene), near)) {
      this.#tries.found = { run: this.#runs, values: this.#told(set) };
    }
    retain(this.#name, this.#tries);
    const said = this.#show();
    const { found } = this.#tries;
    const told = { runs: this.#runs, found: found?.run ?? 0, values: found?.values ?? "" };
    void this.#keeper?.put(plainText(need(this, ".carts-q-ask")), told, said);
  }

  /** What was set, in words. @param {Record<string, unknown>} set */
  #told(set) {
    const parts = Object.entries(set).map(([path, value]) => {
      const { label, unit, per } = this.#facts.labels[path] ?? { label: path, unit: "", per: 1 };
      const shown = typeof value === "number" ? `${short(value / per)} ${unit}` : String(value);
      return `${label} ${shown}`.trim();
    });
    return parts.length ? listed(parts) : tr("as the lesson sets it");
  }

  /** @returns {string} what stands there now */
  #show() {
    const { found } = this.#tries;
    const count = String(this.#runs);
    const tries = need(this, ".carts-challenge-tries");
    const words = found
      ? tr("Found in run {run} of {count}.", { run: String(found.run), count })
      : tr("Runs you have tried: {count}. None of them does it.", { count });
    tries.hidden = this.#runs === 0;
    say(tries, words);
    const place = need(this, ".carts-challenge-found");
    place.hidden = !found;
    if (found) say(place, tr("✓ {values}", { values: found.values }));
    return [words, found?.values ?? ""].join(" ").trim();
  }

  get #name() {
    return `carts-challenge ${location.pathname}#${this.id}`;
  }
}

/** What this tab has tried before. @param {string} name @returns {Tries} */
function kept(name) {
  const { before, tried, found } = recall(name) ?? {};
  return {
    before: Number.isInteger(before) ? before : 0,
    tried: Array.isArray(tried) ? tried : [],
    found: found ?? null,
  };
}
