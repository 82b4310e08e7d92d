/** What a reader chose to compare: the scene, the method, and how long its steps are or how exact they shall be. */

import { need } from "../shared/dom.js";
import { ADAPTIVE } from "./measuring.js";

export class Choice {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
  }

  /** @param {string} part @returns {HTMLSelectElement} */
  of(part) {
    return /** @type {HTMLSelectElement} */ (need(this.root, `.carts-cost-${part}`));
  }

  get scene() {
    return this.of("scene").value;
  }

  get adaptive() {
    return ADAPTIVE.includes(this.of("method").value);
  }

  /** The method with both of its numbers, of which it uses one. */
  get all() {
    const number = (/** @type {string} */ part) => Number(this.of(part).value);
    return { method: this.of("method").value, rtol: number("rtol"), parts: number("step") };
  }

  /** What Python is asked for, and the number that counts is shown. @param {number} [parts] of a point of the map */
  asked(parts) {
    const { method, rtol, parts: chosen } = this.all;
    this.of("step").hidden = this.adaptive;
    this.of("rtol").hidden = !this.adaptive;
    return this.adaptive ? { method, rtol } : { method, parts: parts ?? chosen };
  }

  /** @param {() => void} scene another one @param {() => void} method another one, or its number */
  follow(scene, method) {
    this.of("scene").addEventListener("change", scene);
    for (const part of ["method", "step", "rtol"]) this.of(part).addEventListener("change", method);
  }
}
