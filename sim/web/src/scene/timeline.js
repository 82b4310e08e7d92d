/** The scrubber is the time axis: a tick for every event, a band for every contact. */

import { marks } from "../../../view/effects-words.js";
import { fixed, px } from "../../../view/numbers.js";
import { axisDecimals, span, ticks } from "../../../view/scales.js";
import { isTold } from "../../../view/trajectory.js";
import { need, put, svg } from "../shared/dom.js";

const MOST_EVENTS = 60;

export class Timeline {
  #until = 0; // s, as far as the axis goes

  /** @param {HTMLElement} root of the scene @param {(t: number) => void} seek */
  constructor(root, seek) {
    this.scrub = /** @type {HTMLInputElement} */ (need(root, ".carts-scrub"));
    this.bands = need(root, '.carts-ticks [data-part="contacts"]');
    this.marks = need(root, '.carts-ticks [data-part="events"]');
    this.numbers = need(root, '.carts-ticks [data-part="numbers"]');
    this.scrub.addEventListener("input", () => seek(this.scrub.valueAsNumber));
  }

  /** @param {import("../../../view/types.js").Run} run @param {import("../../../view/windows.js").Touch[]} windows */
  show(run, windows) {
    const { header } = run;
    const pushes = isTold(run) ? marks(header, false) : [];
    const at = (/** @type {number} */ t) => `${px((100 * t) / header.until, 3)}%`;
    this.bands.replaceChildren(
      ...windows.map((w) =>
        svg("rect", {
          class: "carts-contact-band",
          x: at(w.start),
          y: 0,
          width: at(w.end - w.start),
          height: 18,
        }),
      ),
    );
    this.marks.replaceChildren(
      .../** @type {{t: number, kind: string}[]} */ (header.events)
        .slice(0, MOST_EVENTS)
        .filter((event) => event.kind !== "end")
        .concat(pushes.map(({ t }) => ({ t, kind: "push" })))
        .map((event) =>
          svg("line", {
            class: `carts-event carts-event-${event.kind}`,
            x1: at(event.t),
            x2: at(event.t),
            y1: 1,
            y2: 17,
          }),
        ),
    );
    if (this.#until !== header.until) this.#renumber(header.until);
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
