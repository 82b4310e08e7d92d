/** The scrubber is the time axis: a tick for every event, a band for every contact. */

import { marks } from "../../../../view/effects-words.js";
import { fixed, px } from "../../../../view/numbers.js";
import { axisDecimals, span, ticks } from "../../../../view/scales.js";
import { isTold } from "../../../../view/trajectory.js";
import { fit, need, put, svg } from "../../shared/dom.js";

const MOST_EVENTS = 60;
const BAND = { class: "carts-contact-band", y: 0, height: 18 };

export class Timeline {
  #until = 0; // s, as far as the axis goes
  #seen = Infinity; // s, as far as the run was watched
  /** @type {{start: number, end: number}[]} */
  #touches = [];
  /** @type {{t: number, kind: string}[]} */
  #events = [];

  /** @param {HTMLElement} root of the scene @param {(t: number) => void} seek */
  constructor(root, seek) {
    this.scrub = /** @type {HTMLInputElement} */ (need(root, ".carts-scrub"));
    this.bands = need(root, '.carts-ticks [data-part="contacts"]');
    this.marks = need(root, '.carts-ticks [data-part="events"]');
    this.numbers = need(root, '.carts-ticks [data-part="numbers"]');
    this.scrub.addEventListener("input", () => seek(this.scrub.valueAsNumber));
  }

  /** @param {import("../../../../view/types.js").Run} run @param {import("../../../../view/windows.js").Touch[]} windows */
  show(run, windows) {
    const { header } = run;
    const pushes = isTold(run) ? marks(header, false) : [];
    this.#touches = windows;
    this.#events = [
      ...header.events.slice(0, MOST_EVENTS).filter((event) => event.kind !== "end"),
      ...pushes.map(({ t }) => ({ t, kind: "push" })),
    ];
    if (this.#until !== header.until) this.#renumber(header.until);
    this.#mark();
  }

  /** @param {number} seen s, as far as the run was watched */
  grow(seen) {
    this.#seen = seen;
    if (this.#until) this.#mark();
  }

  /** Bands and ticks of what was seen. */
  #mark() {
    const at = (/** @type {number} */ t) => `${px((100 * t) / this.#until, 3)}%`;
    const touches = this.#touches.filter(({ start }) => start <= this.#seen);
    const events = this.#events.filter(({ t }) => t <= this.#seen);
    fit(this.bands, touches.length, () => svg("rect", BAND));
    touches.forEach(({ start, end }, k) => {
      const band = /** @type {Element} */ (this.bands.children[k]);
      put(band, "x", at(start));
      put(band, "width", at(Math.min(end, this.#seen) - start));
    });
    fit(this.marks, events.length, () => svg("line", { y1: 1, y2: 17 }));
    events.forEach(({ t, kind }, k) => {
      const mark = /** @type {Element} */ (this.marks.children[k]);
      put(mark, "class", `carts-event carts-event-${kind}`);
      put(mark, "x1", at(t));
      put(mark, "x2", at(t));
    });
  }

  /** @param {number} t in s @param {string} spoken */
  at(t, spoken) {
    this.scrub.valueAsNumber = t;
    put(this.scrub, "aria-valuetext", spoken);
  }

  /** @param {number} until */
  #renumber(until) {
    this.#until = until;
    put(this.scrub, "max", String(until));
    const axis = span(0, until, 6);
    const times = ticks(axis);
    this.numbers.replaceChildren(
      ...times.flatMap((t, i) => {
        const x = `${px((100 * t) / until, 3)}%`;
        const text = svg("text", { class: "carts-number", x, y: 32 });
        text.textContent = fixed(t, axisDecimals(axis)) + (i === times.length - 1 ? " s" : "");
        return [svg("line", { class: "carts-fine", x1: x, x2: x, y1: 14, y2: 20 }), text];
      }),
    );
  }
}
