/**
 * `<carts-challenge>`: counts the runs that a reader has tried, and says which one reached the goal.
 * No score: to have found none is an answer too.
 */

import { listed } from "../../../view/bodies.js";
import { tr } from "../../../view/language.js";
import { short } from "../../../view/numbers.js";
import { need, say } from "../shared/dom.js";
import { recall, retain } from "../shared/tab.js";
import { masses, setBy } from "./forms/run.js";
import { isMet } from "./marking/goal.js";

const SETTLED = 800; // ms: a slider that is still being pulled makes no run that was looked at

/** @typedef {{scene: string, near: number, goal: import("./marking/goal.js").Goal, labels: Record<string, {label: string, unit: string, per: number}>}} Facts */
/** @typedef {{tried: string[], found: {run: number, values: string} | null}} Tries */

export class ChallengeElement extends HTMLElement {
  /** @type {Facts} */
  #facts = JSON.parse("{}");
  /** @type {Tries} */
  #tries = { tried: [], found: null };
  #leaving = new AbortController();
  #timer = 0;

  connectedCallback() {
    this.#facts = JSON.parse(need(this, ".carts-challenge-facts").textContent ?? "{}");
    this.#tries = kept(this.#name);
    this.#leaving = new AbortController();
    const { signal } = this.#leaving;
    for (const kind of ["carts-update", "carts-watched"]) {
      document.addEventListener(kind, (event) => this.#heard(event), { signal });
    }
    this.#show();
  }

  disconnectedCallback() {
    clearTimeout(this.#timer);
    this.#leaving.abort();
  }

  /** @param {Event} event of a scene */
  #heard({ target }) {
    if (!(target instanceof HTMLElement) || target.id !== this.#facts.scene) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#count(target), SETTLED);
  }

  /** A run that stands: each setting counts once. @param {HTMLElement} scene */
  #count(scene) {
    const run = /** @type {any} */ (scene).trajectory;
    const first = scene.querySelector(".carts-end") !== null; // it is watched before it is known
    if (!run || (first && !("watched" in scene.dataset))) return;
    const set = setBy(scene);
    const key = JSON.stringify(Object.entries(set).sort());
    const { tried } = this.#tries;
    if (tried.includes(key)) return;
    tried.push(key);
    const { goal, near } = this.#facts;
    if (!this.#tries.found && isMet(goal, run, masses(scene), near)) {
      this.#tries.found = { run: tried.length, values: this.#told(set) };
    }
    retain(this.#name, this.#tries);
    this.#show();
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

  #show() {
    const { tried, found } = this.#tries;
    const tries = need(this, ".carts-challenge-tries");
    const words = found
      ? tr("Found in run {run} of {count}.", {
          run: String(found.run),
          count: String(tried.length),
        })
      : tr("Runs you have tried: {count}. Not found yet.", { count: String(tried.length) });
    tries.hidden = tried.length === 0;
    say(tries, words);
    const place = need(this, ".carts-challenge-found");
    place.hidden = !found;
    if (found) say(place, tr("✓ {values}", { values: found.values }));
  }

  get #name() {
    return `carts-challenge ${location.pathname}#${this.id}`;
  }
}

/** What this tab has tried before. @param {string} name @returns {Tries} */
function kept(name) {
  const { tried, found } = recall(name) ?? {};
  return { tried: Array.isArray(tried) ? tried : [], found: found ?? null };
}
