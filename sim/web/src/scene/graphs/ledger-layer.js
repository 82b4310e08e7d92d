/** The energy graph as a ledger: bands on top of each other, whose sum is the energy at the start. */

import * as g from "../../../../view/graph.js";
import { tr } from "../../../../view/language.js";
import { ledger, stacked } from "../../../../view/ledger.js";
import { askParts, ledgerWithEffects, needsParts } from "../../../../view/ledger-effects.js";
import { fixed, px } from "../../../../view/numbers.js";
import { valueAt } from "../../../../view/trajectory.js";
import { touches } from "../../../../view/windows.js";
import { need, put, say, svg } from "../../shared/dom.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {import("../../../../view/series.js").Series} Series */

const NEAR = 0.5; // units; rows nearer than this to the last drawn one are left out

/** Whether the ledger holds: for a moving camera walls and effects do work of their own. */
/** @param {import("../../../../view/types.js").Baked} baked @returns {boolean} */
export function hasLedger(baked) {
  const { left, right } = baked.run.header.track;
  return !baked.fence.camera || (left !== "wall" && right !== "wall" && !needsParts(baked));
}

export class LedgerLayer {
  /** @type {ArrayLike<number>} s, of the entries: those of an older run until the new ones come */
  times = [];
  /** @type {Run | null} the run whose parts were asked for */
  #of = null;
  /** @type {Series[]} */
  entries = [];
  /** @type {Series[]} */
  tops = [];
  waits = ""; // why it is not there yet, or not at all

  /** @param {HTMLElement} root of the graph @param {import("../../../../view/types.js").Baked} baked */
  constructor(root, baked) {
    this.areas = need(root, '[data-part="areas"]');
    this.key = need(root, ".carts-key");
    this.root = root;
    this.asks = needsParts(baked);
    this.camera = baked.fence.camera;
    this.decimals = baked.view.decimals.energy ?? 3;
  }

  /**
   * @param {Run} run @param {boolean} open whether the ledger is seen
   * @param {() => void} changed when it can be drawn, if not at once
   */
  show(run, open, changed) {
    const { events, until } = run.header;
    if (!this.asks) {
      this.#take(run.trajectory.t, ledger(run, touches(events, until), this.camera));
    } else if (open && this.#of !== run) {
      this.#of = run;
      this.waits = tr("Computing …");
      void askParts(this.root).then((parts) => {
        if (this.#of !== run) return; // a newer one is on its way
        this.waits = parts ? "" : tr("This change needs Python, which does not run here.");
        this.#take(parts?.t ?? [], parts ? ledgerWithEffects(run.header, parts) : []);
        changed();
      });
    }
  }

  /** @param {ArrayLike<number>} times in s @param {Series[]} entries */
  #take(times, entries) {
    this.times = times;
    this.entries = entries;
    this.tops = stacked(entries);
  }

  clear() {
    this.areas.replaceChildren();
  }

  /** @param {g.Plane} plane */
  draw(plane) {
    while (this.areas.children.length < this.tops.length) this.areas.append(svg("path"));
    while (this.areas.children.length > this.tops.length) this.areas.lastElementChild?.remove();
    this.tops.forEach((top, i) => {
      const path = /** @type {Element} */ (this.areas.children[i]);
      put(path, "class", `carts-band carts-${top.style}`);
      put(path, "d", band(this.times, plane, top.values, this.tops[i - 1]?.values));
    });
    this.key.replaceChildren(
      ...this.entries.map(({ style }) => {
        const entry = document.createElement("span");
        const swatch = svg("svg", { viewBox: "0 0 14 12", width: 14, height: 12 });
        swatch.setAttribute("aria-hidden", "true");
        swatch.append(svg("path", { class: `carts-band carts-${style}`, d: "M1 1H13V11H1Z" }));
        entry.className = `carts-${style}`;
        entry.append(swatch, document.createElement("b"));
        return entry;
      }),
    );
  }

  /** @param {number} t in s */
  at(t) {
    this.entries.forEach(({ label, values }, i) => {
      const now = Math.max(0, valueAt(this.times, values, null, t));
      const text = this.key.children[i]?.querySelector("b");
      if (text) say(text, `${label}: ${fixed(now, this.decimals)} J`);
    });
  }
}

/**
 * The area between two stacked curves.
 * @param {ArrayLike<number>} times @param {g.Plane} plane @param {ArrayLike<number>} top @param {ArrayLike<number> | undefined} bottom
 */
function band(times, plane, top, bottom) {
  /** @type {string[]} */
  const above = [];
  /** @type {string[]} */
  const below = [];
  let [x0, y0, z0] = [-9, -9, -9];
  for (let k = 0; k < times.length; k += 1) {
    const x = g.timeX(plane, Number(times[k]));
    const [y, z] = [Number(top[k]), Number(bottom?.[k] ?? 0)].map((v) => g.valueY(plane, v));
    const moved = Math.max(Math.abs(x - x0), Math.abs(Number(y) - y0), Math.abs(Number(z) - z0));
    if (moved < NEAR && k < times.length - 1) continue;
    [x0, y0, z0] = [x, Number(y), Number(z)];
    above.push(`${px(x)} ${px(y0)}`);
    below.unshift(`${px(x)} ${px(z0)}`);
  }
  return `M${above.join("L")}L${below.join("L")}Z`;
}
