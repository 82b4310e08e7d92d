/** Prediction: how long is the force arrow on each body when the bumpers are squeezed the most? */

import { inRow, tr } from "../../../view/language.js";
import { fixed, short } from "../../../view/numbers.js";
import { arrowLength, isCut } from "../../../view/shapes.js";
import { html, need, say } from "../shared/dom.js";
import { readTyped, withoutNewtons } from "../shared/typed.js";
import { asked, greatest, LONG, pulled } from "./arrow-parts.js";

/** @typedef {{pair: string, on: string, side: "left" | "right", size: number | null, slider: HTMLInputElement}} Guess size in N, null: not set yet; side of the pair */
/** @typedef {{pair: string, on: string, name: string, side: "left" | "right", style: string, size: number | null,
 *   good: number | null, slider: HTMLInputElement, box: HTMLInputElement, error: HTMLElement}} Row */

const MOST = 10; // full scales; a longer arrow than the slider's is typed, and drawn cut

export class ArrowsForm {
  /** @type {Row[]} */
  #rows;

  /**
   * @param {HTMLElement} root @param {import("../../../view/types.js").Baked} baked
   * @param {(guesses: Guess[]) => void} draw @param {() => void} changed
   */
  constructor(root, baked, draw, changed) {
    this.full = baked.view.force || 10;
    this.decimals = baked.view.decimals.F ?? 2;
    this.draw = draw;
    const { header } = baked.run;
    const elements = /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll(".carts-guess"));
    this.#rows = [...elements].map((element) => {
      const row = {
        ...asked(element, header),
        size: null,
        good: null, // the last size that was not taken back: half-typed numbers do not count
        box: /** @type {HTMLInputElement} */ (need(element, 'input[type="text"]')),
        error: need(element, ".carts-error"),
      };
      row.slider.addEventListener("input", () =>
        this.#take(row, row.slider.valueAsNumber, changed),
      );
      row.box.addEventListener("input", () => this.#typed(row, changed, false));
      row.box.addEventListener("change", () => this.#typed(row, changed, true));
      return row;
    });
  }

  get value() {
    return this.#rows.map(({ pair, on, size }) => ({ pair, on, size }));
  }

  /** @returns {string} */
  get said() {
    const rows = this.#rows.filter(({ size }) => size !== null);
    return rows.map((row) => `${row.name}: ${fixed(row.size ?? 0, this.decimals)} N`).join("; ");
  }

  set value(value) {
    for (const saved of Array.isArray(value) ? value : []) {
      const row = this.#rows.find(({ pair, on }) => pair === saved.pair && on === saved.on);
      if (row && typeof saved.size === "number") this.#show(row, saved.size);
    }
    this.#picture();
  }

  /** @param {boolean} on */
  enable(on) {
    for (const { slider, box } of this.#rows) {
      slider.disabled = !on;
      box.disabled = !on;
    }
  }

  /** Handles in the picture. */
  ready() {
    this.#picture();
  }

  problem() {
    const missing = this.#rows.filter((row) => row.size === null);
    if (!missing.length) return null;
    const refused = missing.filter((row) => row.box.value.trim());
    if (refused.length) {
      const names = inRow(refused.map(({ name }) => name));
      const problem = tr("This number does not work yet: {names}.", { names });
      return `${problem} ${this.#range()}`;
    }
    return tr("Set every arrow first: {names}. Zero counts too: type 0.", {
      names: inRow(missing.map(({ name }) => name)),
    });
  }

  /** For each contact two lines of arrows, yours and the run's, on one scale. @param {import("../../../view/types.js").Run} run */
  compare(run) {
    this.draw([]);
    const pairs = [...new Set(this.#rows.map(({ pair }) => pair))];
    const tables = pairs.map((pair) => {
      const rows = this.#rows.filter((row) => row.pair === pair);
      const actual = greatest(run, pair);
      const grid = html("div", "carts-compare");
      const newtons = (/** @type {number} */ size) => `${fixed(size, this.decimals)} N`;
      const spoken = rows.map((row) =>
        tr("{force}: you {yours}, the run {actual}.", {
          force: row.name,
          yours: newtons(row.size ?? 0),
          actual: newtons(actual),
        }),
      );
      grid.setAttribute("role", "img");
      grid.setAttribute("aria-label", spoken.join(" "));
      grid.append(
        html("span"),
        ...rows.map((row) => html("b", `${row.style} ${row.side}`, row.name)),
      );
      for (const [who, style] of /** @type {const} */ ([
        [tr("you"), "carts-guessed"],
        [tr("the run"), "carts-block-arrow"],
      ])) {
        grid.append(html("span", "", who));
        for (const row of rows) {
          const size = style === "carts-guessed" ? (row.size ?? 0) : actual;
          const cell = html("span", `carts-compare-arrow ${row.style} ${row.side}`);
          cell.append(
            arrow(size, this.full, style, row.side),
            ` ${newtons(size)}${isCut(size, this.full) ? tr(", arrow cut") : ""}`,
          );
          grid.append(cell);
        }
      }
      return grid;
    });
    const text = tr(
      "The run’s arrows are those at greatest compression, with the values that you predicted for. Play it in slow motion and look at other instants too.",
    );
    return [...tables, html("p", "", text)];
  }

  /** While typing only what makes sense is taken. @param {Row} row @param {() => void} changed @param {boolean} done */
  #typed(row, changed, done) {
    const read = readTyped(withoutNewtons(row.box.value));
    let problem = "";
    if ("problem" in read) problem = read.problem;
    else if ("text" in read) problem = tr("Type a number; the unit is N.");
    else if (read.value < 0 || read.value > MOST * this.full) problem = this.#range();
    if (done && problem) {
      const size = row.good === null ? "" : fixed(row.good, this.decimals);
      const kept = tr("{size} N is kept.", { size });
      say(row.error, size ? `${problem} ${kept}` : problem);
      row.error.hidden = false;
      this.#restore(row, changed);
    }
    if (!("value" in read) || problem) return;
    if (done) this.#show(row, read.value);
    else this.#set(row, read.value);
    this.#picture();
    changed();
  }

  #range() {
    return tr("0 to {most} N, please.", { most: short(MOST * this.full) });
  }

  /** Goes back to the last good size; what was typed stays in the box to be mended. */
  /** @param {Row} row @param {() => void} changed */
  #restore(row, changed) {
    if (row.size === row.good) return;
    if (row.good === null) row.size = null;
    else this.#set(row, row.good);
    this.#picture();
    changed();
  }

  /** @param {Row} row @param {number} size @param {() => void} changed */
  #take(row, size, changed) {
    this.#show(row, size);
    this.#picture();
    changed();
  }

  /** @param {Row} row @param {number} size */
  #set(row, size) {
    row.size = size;
    row.slider.valueAsNumber = size;
    row.slider.setAttribute(
      "aria-valuetext",
      tr("{size} newtons", { size: fixed(size, this.decimals) }),
    );
  }

  /** @param {Row} row @param {number} size */
  #show(row, size) {
    this.#set(row, size);
    row.good = size;
    row.box.value = fixed(size, this.decimals);
    row.error.hidden = true;
  }

  #picture() {
    this.draw(
      this.#rows.map(({ pair, on, side, size, slider }) => ({ pair, on, side, size, slider })),
    );
  }
}

/** @param {number} size @param {number} full @param {string} className @param {"left" | "right"} side */
function arrow(size, full, className, side) {
  return pulled(arrowLength(size, full, LONG), className, side, isCut(size, full));
}
