/**
 * The picture of what acts: props of the effects, and in rows under the track an arrow for each force
 * on a cart, tails below its middle, all on the one scale of the scene.
 */

import { FEW, forcesAt, labels } from "../../../view/effects-forces.js";
import { props } from "../../../view/effects-props.js";
import { tr } from "../../../view/language.js";
import { styleOf } from "../../../view/markers.js";
import { px } from "../../../view/numbers.js";
import { arrowLength, blockArrow, cutArrow, isCut } from "../../../view/shapes.js";
import { isTold } from "../../../view/trajectory.js";
import { need, put, say, svg } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/types.js").Layout} Layout */
/** @typedef {import("../../../view/types.js").Piece} Piece */
/** @typedef {import("../../../view/types.js").Centre} Centre */

const PER_CHARACTER = 8.4; // units, of the bold names
const SLIVER = 1.5; // units; a shorter arrow cannot be seen as one and is drawn as a dot
const GAP = 8; // units between an arrow and its name

export class Effects {
  /** @type {Run | null} */
  #run = null;
  /** @type {Map<string, SVGElement>} */
  #drawn = new Map();

  /** @param {SVGElement} root @param {Layout} layout @param {number} full scale in N @param {boolean} forces whether arrows are shown */
  constructor(root, layout, full, forces) {
    this.layout = layout;
    this.full = full;
    this.forces = forces;
    this.behind = need(root, '[data-part="effects-behind"]');
    this.front = need(root, '[data-part="effects-front"]');
    for (const group of [this.behind, this.front]) {
      for (const element of group.querySelectorAll("[data-key]")) {
        this.#drawn.set(
          element.getAttribute("data-key") ?? "",
          /** @type {SVGElement} */ (element),
        );
      }
    }
  }

  /** @param {Run} run */
  show(run) {
    this.#run = run;
  }

  /** @param {number} t in s @param {import("../../../view/types.js").Face} face @param {Centre} centre */
  at(t, face, centre) {
    const run = this.#run;
    if (!run?.header.effects.length) return;
    const pieces = props(run, this.layout, t, face, centre);
    if (this.forces && isTold(run)) pieces.push(...arrows(run, this.layout, this.full, t, centre));
    const seen = new Set(pieces.map(({ key }) => key));
    for (const [key, element] of this.#drawn) {
      if (!seen.has(key)) {
        element.remove();
        this.#drawn.delete(key);
      }
    }
    for (const piece of pieces) this.#draw(piece);
  }

  /** @param {Piece} piece */
  #draw({ key, cls, behind, d, text, x, y, anchor }) {
    let element = this.#drawn.get(key);
    if (!element) {
      element = svg(d === undefined ? "text" : "path", { "data-key": key, class: cls });
      const group = behind ? this.behind : this.front;
      if (cls.startsWith("carts-leader")) group.prepend(element);
      else group.append(element);
      this.#drawn.set(key, element);
    }
    if (d !== undefined) return put(element, "d", d);
    put(element, "x", x ?? "0");
    put(element, "y", y ?? "0");
    put(element, "text-anchor", anchor ?? "start");
    say(element, text ?? "");
  }
}

/** An arrow for each force on one cart, in its row under the track, with its name and size. */
/** @param {Run} run @param {Layout} layout @param {number} full scale in N @param {number} t in s @param {Centre} centre @returns {Piece[]} */
export function arrows(run, layout, full, t, centre) {
  const styles = new Map(run.header.bodies.map(({ name }, i) => [name, `carts-${styleOf(i)}`]));
  const named = run.header.bodies.length <= FEW;
  /** @type {Piece[]} */
  const pieces = [];
  /** @type {Map<string, number>} */
  const lowest = new Map();
  for (const force of forcesAt(run, t)) {
    const key = `${force.kind} ${force.on}`;
    const x = centre(force.on);
    const y = layout.slots[key] ?? layout.track;
    const exact = arrowLength(force.value, full, layout.force);
    const length = Math.abs(exact) < SLIVER ? 0 : exact;
    const cut = isCut(force.value, full);
    const style = styles.get(force.on);
    lowest.set(force.on, Math.max(y, lowest.get(force.on) ?? y));
    const d = (cut ? cutArrow : blockArrow)(x, y, length);
    pieces.push({ key: `arrow ${key}`, cls: `carts-block-arrow carts-acts ${style}`, d });
    const row = `row ${force.kind}`;
    if (named) {
      const told = labels(force).map((one) => one + (cut ? tr(", arrow cut") : ""));
      const text = told.find((one) => fits(x, length, one, layout.width)) ?? String(told.at(-1));
      const [at, anchor] = beside(x, length, text.length * PER_CHARACTER, layout.width);
      const cls = `carts-acts-name ${style}`;
      pieces.push({ key: `name ${key}`, cls, text, x: px(at), y: px(y + 5), anchor });
    } else if (!pieces.some((piece) => piece.key === row)) {
      const text = tr("by {by}", { by: force.by });
      pieces.push({ key: row, cls: "carts-acts-row", text, x: "6", y: px(y + 5), anchor: "start" });
    }
  }
  const leaders = [...lowest].map(([name, y]) => ({
    key: `leader ${name}`,
    cls: `carts-leader carts-acts ${styles.get(name)}`,
    d: `M${px(centre(name))} ${px(layout.track)}V${px(y)}`,
  }));
  return [...leaders, ...pieces];
}

/** Whether a name has room on one side of its arrow. */
/** @param {number} x @param {number} length @param {string} text @param {number} picture width */
function fits(x, length, text, picture) {
  const needed = text.length * PER_CHARACTER + GAP + 4;
  return Math.min(x, x + length) >= needed || Math.max(x, x + length) <= picture - needed;
}

/** Where the name of an arrow from x stands: behind its tail, else beyond its head. */
/** @param {number} x @param {number} length @param {number} width of the name @param {number} picture width @returns {[number, "start" | "end"]} */
function beside(x, length, width, picture) {
  const left = Math.min(x, x + length) - GAP;
  const right = Math.max(x, x + length) + GAP;
  const toLeft = left - width >= 4;
  const toRight = right + width <= picture - 4;
  if (toLeft && (length >= 0 || !toRight)) return [left, "end"];
  if (toRight) return [right, "start"];
  return left > picture - right ? [4, "start"] : [picture - 4, "end"];
}
