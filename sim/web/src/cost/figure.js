/** The figure of errors against times, as measurements come. */

import { digitText, errorOf, levelAt, lineOf, xAt, yAt } from "../../../view/cost/figure.js";
import { METHODS } from "../../../view/cost/methods.js";
import { tr } from "../../../view/language.js";
import { px } from "../../../view/numbers.js";
import { need, put, say, svg } from "../shared/dom.js";

/** @typedef {import("../../../view/cost/figure.js").CostRow} CostRow */

export class CostFigure {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
    this.ring = need(root, ".carts-cost-ring");
    /** @type {number | undefined} m/s, half a step of a double */
    this.floor = undefined;
  }

  /** @param {CostRow[]} rows */
  show(rows) {
    for (const group of this.root.querySelectorAll("[data-method]")) {
      const method = group.getAttribute("data-method") ?? "";
      const { line, points } = lineOf(rows, method, this.floor);
      const d = METHODS[method]?.mark ?? "";
      group.replaceChildren(
        svg("path", { class: "carts-cost-line", d: line }),
        ...points.map(([x, y]) =>
          svg("path", { class: "carts-cost-point", transform: `translate(${x} ${y})`, d }),
        ),
      );
    }
  }

  /** @param {number | undefined} floor m/s @param {Record<string, number>} digits by method, as far as they are known */
  tell(floor, digits) {
    this.floor = floor;
    put(need(this.root, ".carts-cost-floor"), "d", levelAt(floor));
    say(need(this.root, ".carts-cost-floor-name"), floor ? tr("rounding of a double") : "");
    for (const place of this.root.querySelectorAll(".carts-cost-digit")) {
      say(place, digitText(digits[place.getAttribute("data-of") ?? ""]));
    }
  }

  /** Rings the row that the reader has chosen, if it has been measured. @param {CostRow | undefined} row */
  mark(row) {
    const error = row ? errorOf(row) : null;
    put(this.ring, "visibility", row && error !== null ? "visible" : "hidden");
    if (!row || error === null) return;
    put(this.ring, "cx", px(xAt(row.time_ratio)));
    put(this.ring, "cy", px(yAt(error || this.floor || 0)));
  }
}
