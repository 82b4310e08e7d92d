/**
 * Each cart drawn alone with the forces on it, and below what is equal and what is not: force, mass,
 * acceleration, change of velocity. One scale in N for all, the same as in the picture.
 */

import { forcesAlong, summed, verticalForces, verticalNote } from "../../../../view/forces.js";
import { tr } from "../../../../view/language.js";
import { fixed, NOISE, px, short, speedUnit } from "../../../../view/numbers.js";
import { arrowLength, blockArrow, cutArrow, isCut } from "../../../../view/shapes.js";
import { valueAt } from "../../../../view/trajectory.js";
import { latestTouch } from "../../../../view/windows.js";
import { need, put, say, svg } from "../../shared/dom.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {import("../../../../view/forces.js").Force} Force */

const WIDTH = 260;
const HEIGHT = 60;
const BOX = { left: 20, right: 240, top: 8, bottom: 52 };
const AXIS = 38; // y of the forces along the track
const MIDDLE = WIDTH / 2;
const APART = 8; // units between weight and support, so that both are seen
const FULL = 95; // units of an arrow of the full scale

export class FreeBody {
  /** @type {Run | null} */
  #run = null;
  /** @type {import("../../../../view/windows.js").Touch[]} */
  #windows = [];
  #vertical = false;

  /** @param {HTMLElement} root @param {import("../../../../view/types.js").Baked} baked @param {() => void} redraw */
  constructor(root, baked, redraw) {
    this.root = root;
    this.view = baked.view;
    this.per = speedUnit(baked.view.velocity)[0];
    this.zero = NOISE * (baked.view.force || 1);
    this.note = need(root, ".carts-touch-note");
    const vertical = /** @type {HTMLInputElement} */ (need(root, ".carts-vertical"));
    vertical.addEventListener("change", () => {
      this.#vertical = vertical.checked;
      this.root.classList.toggle("carts-with-vertical", vertical.checked);
      redraw();
    });
  }

  /** @param {Run} run @param {import("../../../../view/windows.js").Touch[]} windows */
  show(run, windows) {
    this.#run = run;
    say(need(this.root, ".carts-vertical-note"), verticalNote(run.header));
    this.#windows = windows.filter(({ near }) => !near);
  }

  /** @param {number} t in s */
  at(t) {
    const run = this.#run;
    if (!run) return;
    const touch = latestTouch(this.#windows, t);
    const since = touch && tr("since the touch at {time} s", { time: fixed(touch.start, 2) });
    say(this.note, since || tr("since the start"));
    const room = this.#vertical ? this.#roomFor(run) : 0;
    for (const { name, mass } of run.header.bodies) {
      const along = forcesAlong(run, name, t, this.zero);
      this.#draw(name, this.#vertical ? [...along, ...verticalForces(run, name)] : along, room);
      const whole = summed(along);
      const { t: times, v, a } = run.trajectory;
      const speed = (/** @type {number} */ at) => valueAt(times, v[name] ?? [], a[name] ?? [], at);
      const change = speed(t) - speed(touch?.start ?? 0);
      const { decimals, velocity } = this.view;
      const seen = Math.abs(change) < NOISE * velocity ? 0 : change / this.per;
      this.#say(name, "F", fixed(whole, decimals.F ?? 2));
      this.#say(name, "mass", short(mass));
      this.#say(name, "a", fixed(whole / mass, decimals.a ?? 2));
      this.#say(name, "dv", fixed(seen, decimals.v ?? 2));
    }
  }

  /** @param {string} name @param {string} quantity @param {string} text */
  #say(name, quantity, text) {
    const cell = this.root.querySelector(`td[data-body="${name}"][data-quantity="${quantity}"]`);
    if (cell) say(cell, text);
  }

  /** Units above and below every box, so that all carts are drawn on one scale. @param {Run} run */
  #roomFor({ header }) {
    const weights = header.bodies.map(({ mass }) => mass * header.gravity);
    const longest = arrowLength(Math.max(...weights), this.view.force, FULL);
    return Math.ceil(Math.max(0, longest - (BOX.bottom - BOX.top) / 2) + 6);
  }

  /** @param {string} name @param {Force[]} forces @param {number} room */
  #draw(name, forces, room) {
    const card = need(this.root, `.carts-alone[data-body="${name}"]`);
    const group = need(card, '[data-part="forces"]');
    const list = need(card, "ul");
    while (group.children.length < forces.length) group.append(svg("path"));
    while (group.children.length > forces.length) group.lastElementChild?.remove();
    while (list.children.length < forces.length) list.append(document.createElement("li"));
    while (list.children.length > forces.length) list.lastElementChild?.remove();
    forces.forEach((force, k) => {
      const length = arrowLength(force.value, this.view.force, FULL);
      const cut = isCut(force.value, this.view.force);
      const path = /** @type {Element} */ (group.children[k]);
      const [x, y] = tail(force);
      put(path, "class", "carts-block-arrow");
      put(path, "d", (cut ? cutArrow : blockArrow)(x, y, length));
      put(path, "transform", force.way === "up" ? `rotate(-90 ${px(x)} ${px(y)})` : "");
      say(/** @type {Element} */ (list.children[k]), this.#sentence(force, cut));
    });
    const picture = need(card, "svg");
    put(picture, "viewBox", `0 ${-room} ${WIDTH} ${HEIGHT + 2 * room}`);
    put(picture, "height", String(HEIGHT + 2 * room));
  }

  /** @param {Force} force @param {boolean} cut */
  #sentence({ name, way, value, size: written }, cut) {
    const size = `${written ?? fixed(Math.abs(value), this.view.decimals.F ?? 2)}\u00a0N`;
    const told = { name, size };
    const ways =
      way === "up"
        ? [tr("{name}: {size} down", told), tr("{name}: {size} up", told)]
        : [tr("{name}: {size} to the left", told), tr("{name}: {size} to the right", told)];
    const said = value === 0 ? `${name}: ${size}` : ways[value < 0 ? 0 : 1];
    return `${said}${cut ? tr(", arrow cut") : ""}`;
  }
}

/** @param {Force} force @returns {[number, number]} where its arrow begins: on the body's own face */
function tail({ way, side, value }) {
  if (way === "up") {
    const middle = (BOX.top + BOX.bottom) / 2;
    return value < 0 ? [MIDDLE - APART, middle] : [MIDDLE + APART, BOX.bottom];
  }
  if (side === "middle") return [MIDDLE, AXIS];
  if (side === "below") return [MIDDLE, BOX.bottom];
  if (side === "above") return [MIDDLE, BOX.top];
  return [side === "left" ? BOX.left : BOX.right, AXIS];
}
