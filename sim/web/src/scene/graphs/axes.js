/** Grid lines of a graph with their numbers. */

import * as g from "../../../../view/graph.js";
import { superscript } from "../../../../view/numbers.js";
import { need, put, say, svg } from "../../shared/dom.js";

/** @param {HTMLElement} root of the graph @param {g.Plane} plane */
export function drawAxes(root, plane) {
  const times = g.timeMarks(plane);
  const rows = g.valueMarks(plane);
  marks(need(root, '[data-part="times"]'), times.length, (line, text, i) => {
    const { at, textX, label } = /** @type {(typeof times)[number]} */ (times[i]);
    put(line, "class", "carts-grid");
    put(line, "d", `M${at} ${g.TOP}V${g.BOTTOM}`);
    put(text, "class", "carts-tick-x");
    put(text, "x", textX);
    put(text, "y", String(g.BOTTOM + 15));
    say(text, label);
  });
  marks(need(root, '[data-part="values"]'), rows.length, (line, text, i) => {
    const { at, textY, label, zero } = /** @type {(typeof rows)[number]} */ (rows[i]);
    put(line, "class", zero ? "carts-zero" : "carts-grid");
    put(line, "d", `M${g.LEFT} ${at}H${g.RIGHT}`);
    put(text, "class", "carts-tick-y");
    put(text, "x", String(g.LEFT - g.GAP));
    put(text, "y", textY);
    say(text, label);
  });
  power(need(root, ".carts-plot"), g.valuePower(plane));
}

/** What all numbers of the values are times, at the top of their axis. @param {Element} plot @param {number} exponent 0: one */
function power(plot, exponent) {
  const found = plot.querySelector('[data-part="power"]');
  if (!exponent) return found?.remove();
  const at = { class: "carts-unit", "data-part": "power", x: g.LEFT + 4, y: g.TOP + 10 };
  const text = found ?? plot.appendChild(svg("text", at));
  say(text, `× 10${superscript(exponent)}`);
}

/** @param {Element} group @param {number} count @param {(line: Element, text: Element, i: number) => void} draw */
function marks(group, count, draw) {
  while (group.children.length > 2 * count) group.lastElementChild?.remove();
  while (group.children.length < 2 * count) group.append(svg("path"), svg("text"));
  for (let i = 0; i < count; i += 1) {
    draw(
      /** @type {Element} */ (group.children[2 * i]),
      /** @type {Element} */ (group.children[2 * i + 1]),
      i,
    );
  }
}
