/**
 * The lesson in the page, made anew as the teacher changes it. An element whose block has not changed stays
 * the same element, with its run and its settings.
 */

import { html } from "../shared/dom.js";
import { drawBlock } from "./draw.js";
import { drawFormulas } from "./formulas.js";

const STAYS = ".md-content__button, .carts-teach-door, .md-source-file, .carts-print-head";
const OURS =
  "carts-scene, carts-map, carts-cost, carts-hard, carts-measured, carts-question, carts-quiz";
const NAMES = {
  "carts-scene": "scene",
  "carts-question": "question",
  "carts-map": "map",
  "carts-measured": "bench",
};

/** @typedef {import("./types.js").Look} Look */

export class LessonPage {
  /** The elements of blocks by the key of their HTML. @type {Map<string, HTMLElement>} */
  #made = new Map();
  /** The element of each block, in their order. @type {(HTMLElement | null)[]} */
  #blocks = [];
  #frame = "";

  /** @param {HTMLElement} article @param {string} assets @param {(index: number) => void} change asked for in the page */
  constructor(article, assets, change) {
    this.article = article;
    this.assets = assets;
    this.change = change;
  }

  /** @returns {string[]} keys of what the page has */
  get have() {
    return [...this.#made.keys()];
  }

  /** @param {number} index @returns {HTMLElement | null} */
  block(index) {
    return this.#blocks[index] ?? null;
  }

  /** The page as it was built is what this look at the published text shows. @param {Look} look */
  adopt(look) {
    const found = look.pieces
      .filter((piece) => piece.kind === "block")
      .map((piece) => this.#byId(piece.id ?? ""));
    look.blocks.forEach((block, k) => {
      const element = found[k];
      if (element && block.key) this.#made.set(block.key, element);
    });
    this.#blocks = found;
    this.#frame = look.frame ?? "";
    this.#offer();
  }

  /** @param {Look} look */
  async show(look) {
    const before = this.#blocks;
    const ids = look.pieces.filter((piece) => piece.kind === "block").map((piece) => piece.id);
    const scenes = look.blocks.some((block) => block.html?.includes("<carts-scene"));
    const blocks = look.blocks.map((block, k) => this.#element(block, ids[k] ?? "", before[k]));
    look.blocks.forEach((block, k) => {
      const wrong = block.state === "wrong" || block.state === "needs";
      blocks[k]?.classList.toggle("carts-teach-old", wrong);
    });
    const same = look.frame === null || look.frame === this.#frame;
    if (same && blocks.length === before.length) {
      blocks.forEach((element, k) => {
        if (element && element !== before[k]) before[k]?.replaceWith(element);
      });
    } else if (look.frame !== null) this.#rebuild(look.frame, blocks);
    this.#frame = look.frame ?? this.#frame;
    this.#blocks = blocks;
    const used = new Set(look.blocks.map((block) => block.key));
    for (const key of this.#made.keys()) if (!used.has(key)) this.#made.delete(key);
    this.#offer();
    if (scenes) await this.#bringToLife();
    await drawFormulas(this.article, this.assets);
  }

  /** @param {import("./types.js").Shown} block @param {string} id @param {HTMLElement | null | undefined} old */
  #element(block, id, old) {
    const known = block.key ? this.#made.get(block.key) : undefined;
    if (known) return known;
    if (block.key && block.html) {
      const made = document.createElement("template");
      made.innerHTML = block.html;
      const element = /** @type {HTMLElement} */ (made.content.firstElementChild);
      drawBlock(element);
      this.#made.set(block.key, element);
      return element;
    }
    return (id && this.#byId(id)) || old || null;
  }

  /** @param {string} frame @param {(HTMLElement | null)[]} blocks */
  #rebuild(frame, blocks) {
    const made = document.createElement("template");
    made.innerHTML = frame;
    for (const place of made.content.querySelectorAll("carts-place")) {
      const index = Number(/** @type {HTMLElement} */ (place).dataset.block);
      const element = blocks[index];
      place.replaceWith(element ?? html("p", "carts-teach-missing", "Seen after the build."));
    }
    const kept = [...this.article.children].filter((child) => child.matches(STAYS));
    const foot = kept.filter((child) => child.matches(".carts-teach-door, .md-source-file"));
    const head = kept.filter((child) => !foot.includes(child));
    this.article.replaceChildren(...head, made.content, ...foot);
  }

  /** A button before each block leads to its editor. */
  #offer() {
    for (const old of this.article.querySelectorAll(".carts-teach-change")) old.remove();
    this.#blocks.forEach((element, k) => {
      if (!element?.isConnected) return;
      const name = /** @type {Record<string, string>} */ (NAMES)[element.localName] ?? "block";
      const button = html("button", "carts-button", `Change this ${name}`);
      button.setAttribute("type", "button");
      button.addEventListener("click", () => this.change(k));
      const row = html("p", "carts carts-teach-change");
      row.append(button);
      element.before(row);
    });
  }

  /** A page that had no scene has not loaded their script. */
  async #bringToLife() {
    if (customElements.get("carts-scene")) return;
    const script = document.createElement("script");
    script.src = new URL("carts.js", this.assets).href;
    document.head.append(script);
  }

  /** @param {string} id @returns {HTMLElement | null} */
  #byId(id) {
    const found = id ? document.getElementById(id) : null;
    return found?.matches(OURS) ? found : null;
  }
}
