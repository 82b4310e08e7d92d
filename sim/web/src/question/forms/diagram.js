/**
 * The picture of an interaction diagram: boxes that are joined by dragging from one to the other, by choosing one after the
 * other, or with the arrow keys and Enter. What a line means is not known here.
 */

import { tr } from "../../../../view/language.js";
import { put, say, svg } from "../../shared/dom.js";

const APART = 7; // px between the two lines of one pair
const NEXT = /** @type {Record<string, number>} */ ({
  ArrowRight: 1,
  ArrowDown: 1,
  ArrowLeft: -1,
  ArrowUp: -1,
});

/** @typedef {{a: number, b: number, by: string, verdict: string}} Line boxes by their places, the smaller first */

export class Diagram {
  /** @type {number | null} */
  #picked = null;
  #open = false;

  /** @param {HTMLElement} root @param {string[]} names @param {(a: number, b: number) => void} join */
  constructor(root, names, join) {
    this.names = names;
    this.join = join;
    this.picture = /** @type {SVGSVGElement} */ (root.querySelector(".carts-q-diagram"));
    this.drawn = /** @type {SVGElement} */ (root.querySelector(".carts-q-drawn"));
    this.status = /** @type {HTMLElement} */ (root.querySelector(".carts-q-picked"));
    this.nodes = /** @type {SVGGElement[]} */ ([...root.querySelectorAll(".carts-q-node")]);
    put(this.picture, "role", "group");
    put(this.picture, "aria-label", tr("Choose one object, then the other."));
    for (const [k, node] of this.nodes.entries()) this.#listen(node, k);
    this.#show();
  }

  /** @param {boolean} on */
  enable(on) {
    this.#open = on;
    this.#pick(null);
  }

  /** @param {Line[]} lines */
  draw(lines) {
    const twice = (/** @type {Line} */ { a, b }) =>
      lines.filter((line) => line.a === a && line.b === b).length > 1;
    this.drawn.replaceChildren(
      ...lines.map((line) => {
        const side = twice(line) ? (line.by === "contact" ? APART : -APART) : 0;
        const d = path(this.#centre(line.a), this.#centre(line.b), side);
        return svg("path", { class: `carts-q-${line.by}`, "data-verdict": line.verdict, d });
      }),
    );
  }

  /** @param {SVGGElement} node @param {number} k */
  #listen(node, k) {
    put(node, "role", "button");
    put(node, "aria-label", this.names[k] ?? "");
    put(node, "tabindex", k ? "-1" : "0");
    node.addEventListener("pointerdown", (event) => {
      if (!this.#open || event.button > 0) return;
      node.setPointerCapture(event.pointerId);
      const move = (/** @type {PointerEvent} */ now) => this.#rubber(k, now);
      node.addEventListener("pointermove", move);
      const end = (/** @type {PointerEvent} */ now) => {
        for (const kind of ["pointerup", "pointercancel"]) {
          node.removeEventListener(kind, /** @type {EventListener} */ (end));
        }
        node.removeEventListener("pointermove", move);
        this.drawn.querySelector(".carts-q-rubber")?.remove();
        const to = this.#under(now);
        if (now.type === "pointercancel" || to < 0) return;
        if (to === k) this.#choose(k);
        else this.#done(k, to);
      };
      node.addEventListener("pointerup", end);
      node.addEventListener("pointercancel", end);
    });
    node.addEventListener("keydown", (event) => this.#key(event, k));
    node.addEventListener("click", ({ detail }) => {
      if (!detail) this.#choose(k); // by a screen reader: no pointer was there
    });
  }

  /** @param {KeyboardEvent} event @param {number} k */
  #key(event, k) {
    const step = NEXT[event.key];
    if (step) this.#focus((k + step + this.nodes.length) % this.nodes.length);
    else if (event.key === "Escape") this.#pick(null);
    else if (["Enter", " "].includes(event.key)) this.#choose(k);
    else return;
    event.preventDefault();
  }

  /** @param {number} k */
  #focus(k) {
    for (const [other, node] of this.nodes.entries())
      put(node, "tabindex", other === k ? "0" : "-1");
    this.nodes[k]?.focus();
  }

  /** The first of two, the same again, or the second. @param {number} k */
  #choose(k) {
    if (!this.#open) return;
    const first = this.#picked;
    if (first === null) this.#pick(k);
    else if (first === k) this.#pick(null);
    else this.#done(first, k);
  }

  /** @param {number} from @param {number} to */
  #done(from, to) {
    this.#pick(null);
    this.join(Math.min(from, to), Math.max(from, to));
  }

  /** @param {number | null} k */
  #pick(k) {
    this.#picked = k;
    this.#show();
  }

  #show() {
    const first = this.#picked;
    for (const [k, node] of this.nodes.entries()) put(node, "aria-pressed", String(k === first));
    const words = tr("{object} and … ? Choose the other object.", {
      object: this.names[first ?? 0] ?? "",
    });
    say(this.status, first === null ? "" : words);
  }

  /** The box under the pointer, −1 for none. @param {PointerEvent} event */
  #under({ clientX: x, clientY: y }) {
    return this.nodes.findIndex((node) => {
      const { left, right, top, bottom } = node.getBoundingClientRect();
      return left <= x && x <= right && top <= y && y <= bottom;
    });
  }

  /** A line that follows the pointer. @param {number} k @param {PointerEvent} event */
  #rubber(k, event) {
    const from = this.#centre(k);
    const box = this.picture.getBoundingClientRect();
    const scale = this.picture.viewBox.baseVal.width / box.width;
    const to = { x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale };
    const old = this.drawn.querySelector(".carts-q-rubber");
    const line = old ?? this.drawn.appendChild(svg("path", { class: "carts-q-rubber" }));
    put(line, "d", path(from, to, 0));
  }

  /** @param {number} k */
  #centre(k) {
    const place = /translate\(([\d.]+) ([\d.]+)\)/.exec(
      this.nodes[k]?.getAttribute("transform") ?? "",
    );
    return { x: Number(place?.[1]), y: Number(place?.[2]) };
  }
}

/** @param {{x: number, y: number}} from @param {{x: number, y: number}} to @param {number} side px to the side */
function path(from, to, side) {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const far = Math.hypot(dx, dy) || 1;
  const [sx, sy] = [(-dy / far) * side, (dx / far) * side];
  const at = (/** @type {number} */ x, /** @type {number} */ y) =>
    `${x.toFixed(1)} ${y.toFixed(1)}`;
  return `M${at(from.x + sx, from.y + sy)}L${at(to.x + sx, to.y + sy)}`;
}
