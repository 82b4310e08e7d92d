/**
 * The lesson in the page, made anew as the teacher changes it. An element whose block has not changed stays
 * the same element, with its run and its settings.
 */

import { html, say } from "../shared/dom.js";
import { drawBlock } from "./draw.js";
import { drawFormulas } from "./formulas.js";

/** Of the built page, what no text of the lesson makes: above it, under its title, at its foot. */
const HEAD = ".md-content__button, .carts-print-head";
const LINES = ".carts-languages, .carts-draft";
const FOOT = ".carts-teach-door, .carts-hosted, .md-source-file";
/** The class of the line where a block has no element. */
const MISSING = "carts-teach-missing";
const OURS =
  "carts-scene, carts-map, carts-cost, carts-hard, carts-measured, carts-question, carts-quiz, carts-challenge, carts-law";
const NAMES = {
  "carts-scene": "scene",
  "carts-question": "question",
  "carts-challenge": "challenge",
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
  /** The page as it was built: the text between its blocks, and its nodes while another text is shown. */
  #builtFrame = "";
  /** With a place for each block. @type {ChildNode[] | null} */
  #built = null;
  /** Keys of the elements that were built: an undone change finds them again. @type {Set<string>} */
  #own = new Set();
  /** Elements that only the build makes, by the text of their block. @type {Map<string, HTMLElement>} */
  #kept = new Map();

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

  /** Scrolls to a block, with the button above it. @param {number} index */
  reveal(index) {
    const element = this.#blocks[index];
    const above = element?.previousElementSibling;
    const first = above?.matches(".carts-teach-change") ? above : element;
    first?.scrollIntoView({ block: "start" });
  }

  /** The page as it was built is what this look at the published text shows. @param {Look} look */
  adopt(look) {
    const pieces = look.pieces.filter((piece) => piece.kind === "block");
    const texts = textsOf(pieces);
    const found = pieces.map((piece, k) => this.#byId(piece.id ?? "") ?? this.#byPlace(k));
    look.blocks.forEach((block, k) => {
      const element = found[k];
      if (!element) return;
      if (block.key) this.#made.set(block.key, element);
      if (block.key) this.#own.add(block.key);
      if (block.state === "kept") this.#kept.set(texts[k] ?? "", element);
    });
    this.#blocks = found;
    this.#builtFrame = this.#frame = look.frame ?? "";
    this.#offer();
  }

  /** @param {Look} look */
  async show(look) {
    const before = this.#blocks;
    const pieces = look.pieces.filter((piece) => piece.kind === "block");
    const texts = textsOf(pieces);
    const as = look.blocks.length === before.length; // else what stood there is another block
    const scenes = look.blocks.some((block) => block.html?.includes("<carts-scene"));
    const blocks = look.blocks.map((block, k) => {
      const kept = block.state === "kept" ? this.#kept.get(texts[k] ?? "") : undefined;
      return kept ?? this.#element(block, pieces[k]?.id ?? "", as ? before[k] : null);
    });
    look.blocks.forEach((block, k) => {
      const wrong = block.state === "wrong" || block.state === "needs";
      blocks[k] ??= html("p", MISSING);
      const missing = isMissing(blocks[k]);
      blocks[k]?.classList.toggle("carts-teach-old", wrong && !missing);
      if (missing) say(/** @type {HTMLElement} */ (blocks[k]), notYet(block.state));
    });
    const same = look.frame === null || look.frame === this.#frame;
    if (same && as) {
      // First all places, then the elements: one may go where another stood.
      blocks.forEach((element, k) => {
        if (element !== before[k]) makePlace(before[k], k);
      });
      fill(this.article, blocks);
    } else if (look.frame !== null) this.#rebuild(look.frame, blocks);
    this.#frame = look.frame ?? this.#frame;
    this.#blocks = blocks;
    const used = new Set(look.blocks.map((block) => block.key));
    for (const key of this.#made.keys())
      if (!used.has(key) && !this.#own.has(key)) this.#made.delete(key);
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
    if (this.#frame === this.#builtFrame) this.#setAside();
    if (frame === this.#builtFrame && this.#built) {
      this.article.replaceChildren(...this.#built);
      this.#built = null;
      fill(this.article, blocks);
      return;
    }
    const made = document.createElement("template");
    made.innerHTML = frame;
    fill(made.content, blocks);
    const kept = (/** @type {string} */ which) =>
      [...this.article.children].filter((child) => child.matches(which));
    const lines = kept(LINES);
    const title = made.content.querySelector("h1");
    if (title) title.after(...lines);
    else made.content.prepend(...lines);
    this.article.replaceChildren(...kept(HEAD), made.content, ...kept(FOOT));
  }

  /** The built page makes room for another text; its blocks go over into that. */
  #setAside() {
    if (!this.#builtFrame || this.#built) return;
    for (const row of this.article.querySelectorAll(".carts-teach-change")) row.remove();
    this.#blocks.forEach((element, k) => {
      if (!element || !this.article.contains(element)) return;
      makePlace(element, k);
    });
    this.#built = [...this.article.childNodes];
  }

  /** A button before each block leads to its editor. */
  #offer() {
    for (const old of this.article.querySelectorAll(".carts-teach-change")) old.remove();
    this.#blocks.forEach((element, k) => {
      if (!element?.isConnected || isMissing(element)) return;
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

  /** Pictures and tables have no id: the build says which block of the lesson they are. @param {number} index @returns {HTMLElement | null} */
  #byPlace(index) {
    return this.article.querySelector(`.carts[data-block="${index}"]`);
  }
}

/** A block leaves its place in the page. @param {HTMLElement | null | undefined} element @param {number} k which block it is */
function makePlace(element, k) {
  const place = document.createElement("carts-place");
  place.dataset.block = String(k);
  element?.replaceWith(place);
}

/** The blocks go to their places. @param {ParentNode} root @param {(HTMLElement | null)[]} blocks */
function fill(root, blocks) {
  for (const place of root.querySelectorAll("carts-place")) {
    const element = blocks[Number(/** @type {HTMLElement} */ (place).dataset.block)];
    if (element) place.replaceWith(element);
  }
}

/**
 * What stands where a block has no element yet. It is among the blocks, so that the next look finds what to
 * put another in the place of. @param {import("./types.js").Shown["state"]} state
 */
function notYet(state) {
  if (state === "wrong") return "Seen when its mistake is mended.";
  return state === "later" ? "It comes in a moment." : "Seen after the build.";
}

/** @param {HTMLElement | null | undefined} element of a block */
const isMissing = (element) => element?.classList.contains(MISSING) === true;

/** The texts of blocks; of equal ones the second is another. @param {import("./types.js").Piece[]} pieces @returns {string[]} */
function textsOf(pieces) {
  /** @type {Map<string, number>} */
  const seen = new Map();
  return pieces.map(({ text }) => {
    const count = (seen.get(text) ?? 0) + 1;
    seen.set(text, count);
    return `${count} ${text}`;
  });
}
