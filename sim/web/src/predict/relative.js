/**
 * Prediction without newtons: which of the two arrows is longer? Nobody can know a force in newtons
 * before the run, but everybody has an idea which body is pushed harder.
 */

import { inRow, tr } from "../../../view/language.js";
import { html, need, say } from "../shared/dom.js";
import { ALIKE, asked, greatest, LONG, pulled } from "./arrow-parts.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {{pair: string, on: string, name: string, side: "left" | "right", style: string, share: number | null, slider: HTMLInputElement}} Row share: of the longest arrow */

export class RelativeArrows {
  /** @type {Row[]} */
  #rows;
  #told = ""; // names of the arrows that were said to be missing

  /**
   * @param {HTMLElement} root @param {import("../../../view/types.js").Baked} baked
   * @param {(guesses: import("./arrows.js").Guess[]) => void} draw @param {() => void} changed
   */
  constructor(root, baked, draw, changed) {
    this.full = baked.view.force || 10; // N, of the longest arrow of the picture
    this.draw = draw;
    this.relation = need(root, ".carts-relation");
    const { header } = baked.run;
    const elements = /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll(".carts-guess"));
    this.#rows = [...elements].map((element) => {
      /** @type {Row} */
      const row = { ...asked(element, header), share: null };
      row.slider.addEventListener("input", () => {
        row.share = row.slider.valueAsNumber;
        this.#show();
        changed();
      });
      return row;
    });
  }

  get value() {
    return this.#rows.map(({ pair, on, share }) => ({ pair, on, share }));
  }

  set value(value) {
    for (const saved of Array.isArray(value) ? value : []) {
      const row = this.#rows.find(({ pair, on }) => pair === saved.pair && on === saved.on);
      if (!row || typeof saved.share !== "number") continue;
      row.share = saved.share;
      row.slider.valueAsNumber = saved.share;
    }
    this.#show();
  }

  /** @returns {string} */
  get said() {
    return this.#pairs.map((rows) => relation(rows, (row) => row.share)).join(" ");
  }

  /** @param {boolean} on */
  enable(on) {
    for (const { slider } of this.#rows) slider.disabled = !on;
  }

  /** Handles in the picture. */
  ready() {
    this.#show();
  }

  /** An arrow that was left alone may be forgotten, or an idea: that there is no such force. */
  problem() {
    const missing = this.#rows.filter(({ share }) => share === null);
    const names = inRow(missing.map(({ name }) => name));
    const told = names === this.#told;
    this.#told = names;
    if (!names) return null;
    if (!told) {
      return tr("Not set yet: {names}. Is there no such force? Then lock once more.", { names });
    }
    for (const row of missing) row.share = 0;
    this.#show();
    return null;
  }

  /** Both pairs of arrows, the longest of each as long as the other: lengths are compared, not newtons. @param {Run} run */
  compare(run) {
    this.draw([]);
    return this.#pairs.map((rows) => {
      const actual = greatest(run, rows[0]?.pair ?? "");
      const most = Math.max(...rows.map(({ share }) => share ?? 0));
      const grid = html("div", "carts-compare");
      const yours = relation(rows, (row) => row.share);
      const seen = relation(rows, () => actual);
      grid.setAttribute("role", "img");
      grid.setAttribute(
        "aria-label",
        tr("You: {yours} The run: {seen}", { yours: yours || "–", seen }),
      );
      grid.append(
        html("span"),
        ...rows.map((row) => html("b", `${row.style} ${row.side}`, row.name)),
        html("span", "", tr("you")),
        ...rows.map((row) => cell(row, most ? (row.share ?? 0) / most : 0, "carts-guessed")),
        html("span", "", tr("the run")),
        ...rows.map((row) => cell(row, actual ? 1 : 0, "carts-block-arrow")),
      );
      const place = html("div");
      const words = html("p", "", tr("You: {yours} The run: {seen}", { yours, seen }));
      words.setAttribute("aria-hidden", "true");
      place.append(grid, words);
      return place;
    });
  }

  get #pairs() {
    const pairs = [...new Set(this.#rows.map(({ pair }) => pair))];
    return pairs.map((pair) => this.#rows.filter((row) => row.pair === pair));
  }

  #show() {
    for (const { slider, share } of this.#rows) {
      const part = `${Math.round(100 * (share ?? 0))} %`;
      slider.setAttribute("aria-valuetext", share ? part : tr("no arrow"));
    }
    say(this.relation, this.said);
    this.draw(
      this.#rows.map(({ pair, on, side, share, slider }) => {
        return { pair, on, side, size: share === null ? null : share * this.full, slider };
      }),
    );
  }
}

/** Which of two forces is larger, as a sentence; empty while one is missing. @param {Row[]} rows @param {(row: Row) => number | null} of */
function relation(rows, of) {
  const [one, other] = rows;
  if (!one || !other) return "";
  const [a, b] = [of(one), of(other)];
  if (a === null || b === null) return "";
  const most = Math.max(a, b);
  if (!most) return tr("no force on either.");
  if (Math.abs(a - b) <= ALIKE * most) return tr("both forces are equally large.");
  const [large, small] = a > b ? [one, other] : [other, one];
  if (!Math.min(a, b)) return tr("only the {force}.", { force: large.name });
  return tr("the {large} is larger than the {small}.", { large: large.name, small: small.name });
}

/** @param {Row} row @param {number} part of the longest arrow @param {string} look */
function cell({ style, side }, part, look) {
  const made = html("span", `carts-compare-arrow ${style} ${side}`);
  made.append(pulled(part * LONG, look, side));
  return made;
}
