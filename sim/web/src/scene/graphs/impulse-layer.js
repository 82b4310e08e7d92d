/** The shaded impulse in the force graph, with its number and m Δv of both bodies beside it. */

import { dashed } from "../../../../view/bodies.js";
import * as g from "../../../../view/graph.js";
import { area, changes } from "../../../../view/impulse.js";
import { tr } from "../../../../view/language.js";
import { fixed, px } from "../../../../view/numbers.js";
import { rowAt } from "../../../../view/trajectory.js";
import { latestTouch, touches } from "../../../../view/windows.js";
import { need, put, say } from "../../shared/dom.js";

export class ImpulseLayer {
  /** @param {HTMLElement} root of the graph @param {import("../../../../view/types.js").View} view */
  constructor(root, view) {
    this.shade = need(root, '[data-part="areas"]');
    this.note = need(root, ".carts-area-note");
    this.decimals = Math.max(3, view.decimals.p ?? 3);
    /** @type {import("../../../../view/windows.js").Touch[]} */
    this.windows = [];
  }

  /** @param {import("../../../../view/types.js").Run} run */
  show({ header }) {
    // Carts that never part push each other to the end, far beyond the greatest force of their hit.
    this.windows = touches(header.events, header.until).map((touch) =>
      touch.lasts ? { ...touch, end: header.until } : touch,
    );
  }

  /** @param {import("../../../../view/types.js").Run} run @param {g.Plane} plane @param {number} t in s @param {boolean} signed */
  at(run, plane, t, signed) {
    const touch = latestTouch(this.windows, t);
    const paths = this.shade.children;
    for (const path of paths) put(path, "d", "");
    if (!touch) {
      const hint = tr("Move into a touch: the shaded area is the impulse.");
      return say(this.note, this.windows.length ? hint : "");
    }
    const end = Math.min(t, touch.end);
    const outline = (/** @type {number} */ sign) => under(run, touch, plane, end, sign);
    put(/** @type {Element} */ (paths[0]), "d", outline(1));
    if (signed) put(/** @type {Element} */ (paths[1]), "d", outline(-1));
    const impulse = area(run, touch.pair, touch.start, end);
    const names = dashed(touch.bodies, run.header.track);
    const amount = fixed(impulse, this.decimals);
    const parts = changes(run, this.windows, touch, end)
      .filter(({ change }) => change !== null)
      .map(({ name, change }) =>
        tr("m\u00a0Δv of {name}: {change}", { name, change: fixed(change ?? 0, this.decimals) }),
      );
    const shaded =
      t >= touch.end
        ? tr("{names}, shaded area: {amount}", { names, amount })
        : tr("{names}, shaded area so far: {amount}", { names, amount });
    const values = [shaded, ...parts].join("; ");
    const told = parts.length ? tr("{values}, all in N\u00a0s.", { values }) : `${values} N\u00a0s`;
    say(this.note, told);
  }
}

/** What lies between the curve, as the graph draws it, and no force: closed. @param {import("../../../../view/types.js").Run} run @param {import("../../../../view/windows.js").Touch} touch @param {g.Plane} plane @param {number} end in s @param {number} sign of the force */
function under({ trajectory: { t, F, dF } }, touch, plane, end, sign) {
  const force = F[touch.pair];
  const first = rowAt(t, touch.start);
  if (!force || first < 0) return "";
  const length = Math.min(rowAt(t, end) + 2, t.length) - first;
  /** @param {import("../../../../view/types.js").Column} column @param {number} factor */
  const part = (column, factor) =>
    Float64Array.from({ length }, (_, k) => factor * Number(column[first + k]));
  const [values, slope] = [part(force, sign), dF[touch.pair]];
  const slopes = slope ? part(slope, sign) : null;
  const curve = { label: "", style: "", over: false, values, slopes };
  const drawn = g.path(curve, part(t, 1), plane, end);
  const zero = px(g.valueY(plane, 0));
  return `M${px(g.timeX(plane, Number(t[first])))} ${zero}L${drawn.slice(1)}V${zero}Z`;
}
