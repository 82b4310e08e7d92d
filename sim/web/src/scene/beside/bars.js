/** Momentum of each cart before the latest touch and now, as numbers with bars on one scale. */

import { tr } from "../../../../view/language.js";
import { fixed, NOISE, px } from "../../../../view/numbers.js";
import { seriesOf } from "../../../../view/series.js";
import { valueAt } from "../../../../view/trajectory.js";
import { latestTouch } from "../../../../view/windows.js";
import { need, put, say } from "../../shared/dom.js";

/** @typedef {import("../../../../view/types.js").Run} Run */

const HALF = 60; // units of a bar of the full scale, to either side of zero

export class Bars {
  /** @type {Run | null} */
  #run = null;
  /** @type {import("../../../../view/series.js").Series[]} */
  #curves = [];
  /** @type {import("../../../../view/windows.js").Touch[]} */
  #windows = [];
  #full = 1;
  #first = 0; // of the lesson's own run, so that runs can be compared

  /** @param {HTMLElement} root @param {import("../../../../view/types.js").Baked} baked */
  constructor(root, baked) {
    this.root = root;
    this.camera = baked.fence.camera;
    this.decimals = baked.view.decimals.p ?? 2;
    this.rows = /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll("tbody tr"));
    this.since = need(root, ".carts-touch-note");
  }

  /** @param {Run} run @param {import("../../../../view/windows.js").Touch[]} windows */
  show(run, windows) {
    this.#run = run;
    this.#windows = windows.filter(({ near }) => !near);
    this.#curves = seriesOf("p", run.header, run.trajectory, this.camera);
    let most = this.#first;
    for (const { values } of this.#curves) {
      for (let k = 0; k < values.length; k += 1) most = Math.max(most, Math.abs(Number(values[k])));
    }
    if (!this.#first) this.#first = most;
    this.#full = most || 1;
  }

  /** @param {number} t in s */
  at(t) {
    const run = this.#run;
    if (!run) return;
    const start = latestTouch(this.#windows, t)?.start ?? 0;
    say(this.since, tr("at {time} s", { time: fixed(start, 2) }));
    this.rows.forEach((row, k) => {
      const curve = this.#curves[k];
      row.hidden = !curve;
      if (!curve) return;
      const at = (/** @type {number} */ when) => {
        const value = valueAt(run.trajectory.t, curve.values, curve.slopes, when);
        return Math.abs(value) < NOISE * this.#full ? 0 : value;
      };
      const [before, now] = [at(start), at(t)];
      say(need(row, "th"), curve.label);
      const texts = [before, now, now - before].map((value) => fixed(value, this.decimals));
      row.querySelectorAll("td[data-when]").forEach((cell, i) => {
        say(cell, texts[i] ?? "");
      });
      bar(need(row, '[data-part="before"]'), before / this.#full);
      bar(need(row, '[data-part="now"]'), now / this.#full);
    });
  }
}

/** @param {Element} rect @param {number} part of the full scale */
function bar(rect, part) {
  const length = HALF * Math.min(1, Math.abs(part));
  put(rect, "x", px(part < 0 ? HALF + 4 - length : HALF + 4));
  put(rect, "width", px(length));
}
