/** What each cart did, as a coloured strip; a boundary is dragged or moved by keys, and the fit runs again. */

import { tr } from "../../../view/language.js";
import { fixed } from "../../../view/numbers.js";
import { html, put } from "../shared/dom.js";
import { hint, word } from "./kinds.js";
import { lanes, limits, move, ofCart, told } from "./spans.js";

/** @typedef {import("../../../view/measured/types.js").Segment} Segment */
/** @typedef {import("../../../view/measured/types.js").Given} Given */

const WIDE = 24; // px of a handle, as a finger needs
const USUAL = 320; // px of a strip that is not shown yet
const WAITS = 500; // ms after the last key
const NAMED = 12; // a span with this share (1/n) of the time has its name in it
const STEPS = 500; // of the whole time: the smallest that a key moves

const seconds = (/** @type {number} */ t) => fixed(t, 2);

export class Strip {
  /** What the reader has set. @type {Given[]} */
  given = [];
  /** @type {Segment[]} */
  #segments = [];
  #step = 0.01;
  #timer = 0;

  /** @param {HTMLElement} place @param {() => void} changed by the reader */
  constructor(place, changed) {
    this.place = place;
    this.changed = changed;
    new ResizeObserver(() => this.#stack()).observe(place);
  }

  /** Other readings: nothing is found or set. */
  clear() {
    this.given = [];
    this.show(null);
  }

  /** @param {{names: string[], segments?: Segment[]} | null} found @param {number[]} times s, of the readings */
  show(found, times = []) {
    clearTimeout(this.#timer);
    const held = /** @type {HTMLElement | null} */ (this.place.querySelector(":focus"));
    const at = Number(held?.getAttribute("aria-valuenow"));
    this.#segments = structuredClone(found?.segments ?? []);
    this.place.hidden = !this.#segments.length;
    if (this.place.hidden) return this.place.replaceChildren();
    const frame = (Number(times.at(-1)) - Number(times[0])) / (times.length - 1);
    this.#step = Math.max(frame || 0, this.#length / STEPS);
    const made = html("div", "carts-measured-strip");
    for (const name of found?.names ?? []) {
      const row = html("div", "carts-measured-strip-row");
      row.dataset.cart = name;
      row.append(this.#bar(name), ...this.#edges(name));
      made.append(html("span", "carts-measured-strip-name", name), row);
    }
    this.place.replaceChildren(html("p", "carts-quiet", hint()), made);
    if (this.given.length) this.place.append(this.#asFound());
    this.#put();
    this.#stack();
    if (held) this.#focus(held.dataset.cart ?? "", at);
  }

  get #begin() {
    return Math.min(...this.#segments.map((one) => one.from));
  }

  get #length() {
    return Math.max(...this.#segments.map((one) => one.until)) - this.#begin;
  }

  /** @param {string} cart */
  #bar(cart) {
    const bar = html("div", "carts-measured-strip-bar");
    bar.setAttribute("role", "img");
    for (const { kind } of ofCart(this.#segments, cart)) {
      const part = html("span");
      part.dataset.kind = kind;
      bar.append(part);
    }
    return bar;
  }

  /** @param {string} cart @returns {HTMLElement[]} a slider for each boundary */
  #edges(cart) {
    return ofCart(this.#segments, cart)
      .slice(1)
      .map((_, k) => {
        const edge = html("span", "carts-measured-edge");
        edge.dataset.cart = cart;
        edge.tabIndex = 0;
        edge.setAttribute("role", "slider");
        edge.addEventListener("pointerdown", (event) => {
          edge.setPointerCapture(event.pointerId);
          edge.focus();
          event.preventDefault();
        });
        edge.addEventListener("pointermove", (event) => {
          if (edge.hasPointerCapture(event.pointerId)) this.#drag(cart, k, event.clientX);
        });
        edge.addEventListener("pointerup", () => {
          this.#stack();
          if ("moved" in edge.dataset) this.#commit(cart, k);
        });
        edge.addEventListener("keydown", (event) => this.#key(event, cart, k));
        return edge;
      });
  }

  /** @param {string} cart @param {number} k @param {number} x px in the window */
  #drag(cart, k, x) {
    const box = this.#row(cart).getBoundingClientRect();
    this.#move(cart, k, this.#begin + ((x - box.left) / box.width) * this.#length);
  }

  /** @param {KeyboardEvent} event @param {string} cart @param {number} k */
  #key(event, cart, k) {
    const [low, high] = limits(this.#segments, cart, k, this.#step);
    const now = Number(ofCart(this.#segments, cart)[k]?.until);
    const steps = {
      ArrowLeft: -1,
      ArrowDown: -1,
      ArrowRight: 1,
      ArrowUp: 1,
      PageDown: -10,
      PageUp: 10,
    };
    const by = steps[/** @type {keyof typeof steps} */ (event.key)];
    const to = event.key === "Home" ? low : event.key === "End" ? high : now + by * this.#step;
    if (!Number.isFinite(to)) return;
    event.preventDefault();
    this.#move(cart, k, to);
    this.#stack();
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#commit(cart, k), WAITS);
  }

  /** @param {string} cart @param {number} k @param {number} t s */
  #move(cart, k, t) {
    const [low, high] = limits(this.#segments, cart, k, this.#step);
    move(this.#segments, cart, k, Math.min(high, Math.max(low, t)));
    const edge = this.#row(cart).querySelectorAll(".carts-measured-edge")[k];
    if (edge instanceof HTMLElement) edge.dataset.moved = "";
    this.#put();
  }

  /** @param {string} cart @param {number} k */
  #commit(cart, k) {
    this.given = told(this.given, this.#segments, cart, k);
    this.changed();
  }

  #asFound() {
    const button = html("button", "carts-button carts-measured-as-found", tr("As found"));
    button.setAttribute("type", "button");
    button.addEventListener("click", () => {
      this.given = [];
      this.changed();
    });
    return button;
  }

  /** @param {string} cart @returns {HTMLElement} */
  #row(cart) {
    const rows = [...this.place.querySelectorAll(".carts-measured-strip-row")];
    return /** @type {HTMLElement} */ (
      rows.find((row) => /** @type {HTMLElement} */ (row).dataset.cart === cart)
    );
  }

  /** Everything at its place, and in words. */
  #put() {
    for (const cart of new Set(this.#segments.map((one) => one.cart))) {
      const own = ofCart(this.#segments, cart);
      const row = this.#row(cart);
      const spans = own.map(
        ({ kind, from, until }) => `${word(kind)} ${seconds(from)} – ${seconds(until)} s`,
      );
      const bar = /** @type {HTMLElement} */ (row.firstElementChild);
      put(bar, "aria-label", `${cart}: ${spans.join(", ")}`);
      for (const [k, { kind, from, until }] of own.entries()) {
        const part = /** @type {HTMLElement} */ (bar.children[k]);
        const named = kind === "contact" || NAMED * (until - from) > this.#length;
        part.textContent = named ? word(kind) : "";
        part.title = spans[k] ?? "";
        part.style.left = `${(100 * (from - this.#begin)) / this.#length}%`;
        part.style.width = `${(100 * (until - from)) / this.#length}%`;
      }
      for (const [k, edge] of [...row.querySelectorAll(".carts-measured-edge")].entries())
        this.#value(/** @type {HTMLElement} */ (edge), cart, k);
    }
  }

  /** @param {HTMLElement} edge @param {string} cart @param {number} k */
  #value(edge, cart, k) {
    const own = ofCart(this.#segments, cart);
    const [low, high] = limits(this.#segments, cart, k, this.#step);
    const at = Number(own[k]?.until);
    const [first, second] = [word(own[k]?.kind ?? ""), word(own[k + 1]?.kind ?? "")];
    edge.style.left = `${(100 * (at - this.#begin)) / this.#length}%`;
    put(edge, "aria-label", tr("{cart}: from {first} to {second}", { cart, first, second }));
    put(edge, "aria-valuemin", String(low));
    put(edge, "aria-valuemax", String(high));
    put(edge, "aria-valuenow", String(at));
    put(
      edge,
      "aria-valuetext",
      tr("{first} until {time} s, then {second}", { first, second, time: seconds(at) }),
    );
  }

  /** Handles that would lie over each other stand below each other. */
  #stack() {
    for (const row of this.place.querySelectorAll(".carts-measured-strip-row")) {
      const width = row.getBoundingClientRect().width || USUAL;
      const edges = /** @type {HTMLElement[]} */ ([
        ...row.querySelectorAll(".carts-measured-edge"),
      ]);
      const rows = lanes(
        edges.map((edge) => (Number.parseFloat(edge.style.left) / 100) * width),
        WIDE,
      );
      for (const [k, edge] of edges.entries()) edge.style.setProperty("--lane", String(rows[k]));
      /** @type {HTMLElement} */ (row).style.setProperty(
        "--lanes",
        String(Math.max(0, ...rows) + 1),
      );
    }
  }

  /** The handle that was held, after all was drawn anew. @param {string} cart @param {number} at s */
  #focus(cart, at) {
    const off = (/** @type {Element} */ edge) =>
      Math.abs(Number(edge.getAttribute("aria-valuenow")) - at);
    const within = this.#row(cart) ?? this.place; // “As found” is gone: the first boundary then
    const edges = [...within.querySelectorAll(".carts-measured-edge")];
    const nearest = edges.sort((a, b) => off(a) - off(b))[0];
    if (nearest instanceof HTMLElement) nearest.focus();
  }
}
