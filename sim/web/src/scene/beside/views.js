/** The views beside picture and graphs; only those that are seen are drawn. */

import { tr } from "../../../../view/language.js";
import { isTold } from "../../../../view/trajectory.js";
import { Bars } from "./bars.js";
import { FreeBody } from "./free-body.js";
import { Lens } from "./lens.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {import("../../../../view/windows.js").Touch} Touch */
/** @typedef {{root: HTMLElement, show: (run: Run, windows: Touch[]) => void, at: (t: number) => void}} View */

/** @type {Record<string, [string, new (root: HTMLElement, baked: import("../../../../view/types.js").Baked, redraw: () => void) => View]>} */
const KINDS = {
  "free-body": [tr("forces on each cart"), FreeBody],
  lens: [tr("lens on the contact"), Lens],
  bars: [tr("momentum before and now"), Bars],
};

export class Views {
  /** @type {View[]} */
  #views = [];
  /** @type {{run: Run, windows: Touch[], t: number} | null} */
  #now = null;

  /** @param {HTMLElement} root @param {import("../../../../view/types.js").Baked} baked */
  constructor(root, baked) {
    /** @type {NodeListOf<HTMLElement>} */
    this.frames = root.querySelectorAll(".carts-views");
    for (const section of root.querySelectorAll(".carts-view")) {
      const element = /** @type {HTMLElement} */ (section);
      const kind = KINDS[element.dataset.view ?? ""];
      if (kind) this.#views.push(new kind[1](element, baked, () => this.#again()));
    }
  }

  /** @returns {{key: string, label: string, seen: boolean}[]} what a reader can choose from */
  get choices() {
    return this.#views.map(({ root }) => {
      const key = root.dataset.view ?? "";
      return { key, label: KINDS[key]?.[0] ?? key, seen: !root.hidden };
    });
  }

  /** @param {string} key @param {boolean} seen */
  choose(key, seen) {
    for (const { root } of this.#views) if (root.dataset.view === key) root.hidden = !seen;
    this.#again();
  }

  /** @param {Run} run @param {Touch[]} windows @param {number} t in s */
  show(run, windows, t) {
    if (!isTold(run)) return;
    for (const frame of this.frames) frame.hidden = false;
    this.#now = { run, windows, t };
    for (const view of this.#views) view.show(run, windows);
  }

  /** @param {number} t in s */
  at(t) {
    if (!this.#now) return;
    this.#now.t = t;
    for (const view of this.#views) if (!view.root.hidden) view.at(t);
  }

  #again() {
    if (this.#now) this.at(this.#now.t);
  }
}
