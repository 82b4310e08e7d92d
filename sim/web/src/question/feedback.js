/** Check, hints, and what the page says to an answer. The texts lie in templates beside the question. */

import { tr } from "../../../view/language.js";
import { short } from "../../../view/numbers.js";
import { html, need } from "../shared/dom.js";
import { onEnter } from "../shared/enter.js";
import { mark } from "./marking/mark.js";

const WORDS = {
  right: tr("Right."),
  partly: tr("Partly right. Look again."),
  wrong: tr("Not yet. Think again."),
  open: tr("Written down."),
  empty: tr("Answer first."),
  unclear: tr("This cannot be read."),
};
const TOLD = tr("Not quite right. Read why.");
const SHOW_AFTER = 3; // tries until the explanation is shown all the same

/** @typedef {{value: any, own: number | null, tries: number}} Tried an answer that was checked */

export class Feedback {
  /**
   * @param {HTMLElement} root the question, with its facts
   * @param {() => Tried | null} attempt
   * @param {(shown: string[], verdict: string) => void} marked what was found: parts that are marked one by one, and the whole
   */
  constructor(root, attempt, marked = () => {}) {
    this.marked = marked;
    this.root = root;
    this.place = need(root, ".carts-q-feedback");
    const check = /** @type {HTMLElement | null} */ (root.querySelector(".carts-q-check"));
    // Of a single box: in a table cells are still empty.
    const box = /** @type {HTMLElement | null} */ (root.querySelector("input.carts-q-typed"));
    onEnter(box, () => check?.click());
    check?.addEventListener("click", () => {
      const tried = attempt();
      if (!tried) return;
      this.place.removeAttribute("aria-live");
      this.marked(...this.#show(tried));
    });
    const hints = /** @type {HTMLElement[]} */ ([...need(root, ".carts-q-hints").children]);
    const more = /** @type {HTMLButtonElement | null} */ (root.querySelector(".carts-q-hint"));
    more?.addEventListener("click", () => {
      const next = hints.find((hint) => hint.hidden);
      if (next) next.hidden = false;
      more.disabled = !hints.some((hint) => hint.hidden);
    });
  }

  /** The answer has changed: what was said is about another one. */
  stale() {
    this.place.replaceChildren();
    delete this.root.dataset.verdict;
  }

  /** Says once more what was said to this answer, as when a page is opened again; not aloud. @param {Tried} tried @returns {string[]} the parts marked one by one */
  again(tried) {
    this.place.setAttribute("aria-live", "off");
    return this.#show(tried)[0];
  }

  /** @param {Tried} tried @returns {[string[], string]} the parts marked one by one, and the whole */
  #show({ value, own, tries }) {
    const facts = /** @type {any} */ (this.root).facts;
    const found = mark(facts, value, own);
    this.root.dataset.verdict = found.verdict;
    const names = new Set(found.shown);
    if (tries >= SHOW_AFTER) names.add("explain");
    const told = names.has("explain") && this.root.querySelector('template[data-for="explain"]');
    let words = WORDS[found.verdict];
    if (told && ["wrong", "partly"].includes(found.verdict)) words = TOLD;
    else if (found.verdict === "wrong" && !found.shown.length && !found.beliefs.length)
      words = unknown(facts, value, own) || words;
    this.place.replaceChildren(html("p", "carts-q-verdict", words));
    if (own !== null && tries >= SHOW_AFTER && found.verdict !== "right") {
      this.place.append(
        html(
          "p",
          "",
          tr("Your run says {value} {unit}.", {
            value: short(own),
            unit: facts.unit,
          }),
        ),
      );
    }
    for (const name of names) {
      const template = this.root.querySelector(`template[data-for="${CSS.escape(name)}"]`);
      if (template instanceof HTMLTemplateElement) {
        const part = html("div", "carts-q-said");
        part.append(template.content.cloneNode(true));
        this.place.append(part);
      }
    }
    return [found.shown, found.verdict];
  }
}

/**
 * What can be said to a wrong answer to which the lesson says nothing; empty where that is nothing.
 * @param {any} facts @param {any} value @param {number | null} own
 */
function unknown(facts, value, own) {
  if (facts.type === "short") {
    return tr("This page does not know that answer. Say it in fewer words, or think again.");
  }
  const turned = typeof value === "number" && mark(facts, -value, own).verdict === "right";
  return turned ? tr("The size is right. What about its sign?") : "";
}
