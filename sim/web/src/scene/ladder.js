/**
 * What does this scene call for? The ladder in “What is in this model”: what each effect changes, or
 * would change, largest first, with the reading accuracy of a graph as the line between. Every rung
 * is the scene really run once more, so nothing is made or asked before a reader opens it.
 */

import { told, tr } from "../../../view/language.js";
import { short } from "../../../view/numbers.js";
import { isTold } from "../../../view/trajectory.js";
import { capital } from "../../../view/words.js";
import { html, need, say } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/language.js").Said} Said */
/**
 * @typedef {{effect: string, listed: boolean, visible: boolean, sentence: Said, source: Said,
 *   changes: {quantity: string, at: number, amount: number, relative: number | null} | null}} Rung
 */

const REST = 400; // ms without another run before it is asked again

export class Ladder {
  /** @type {Run | null} */
  #run = null;
  #turn = 0;
  #timer = 0;
  #owner = {}; // of its own: an estimate is no newer run

  /**
   * @param {HTMLElement} root @param {import("../runtime/client.js").Client} client
   * @param {() => Record<string, unknown>} message a request about the scene as it is now
   */
  constructor(root, client, message) {
    this.client = client;
    this.message = message;
    this.details = /** @type {HTMLDetailsElement} */ (need(root, ".carts-model"));
    this.details.addEventListener("toggle", () => this.#opened(0));
  }

  /** Another run is there: what stands open is told anew. @param {Run} run */
  follow(run) {
    this.#run = run;
    this.#turn += 1;
    this.#opened(REST);
  }

  /** @param {number} wait in ms */
  #opened(wait) {
    clearTimeout(this.#timer);
    if (!this.details.open || !this.#run || !isTold(this.#run)) return;
    this.#timer = setTimeout(() => void this.#ask(), wait);
  }

  async #ask() {
    const turn = this.#turn;
    const place = this.#place();
    const note = need(place, ".carts-ladder-note");
    say(note, tr("The scene is run once with each effect and once without …"));
    try {
      const { header } = await this.client.ask(this.#owner, this.message);
      if (turn !== this.#turn) return;
      const { ok, rungs, reads } = /** @type {any} */ (header);
      if (!ok) throw new Error("refused");
      need(place, ".carts-ladder").replaceChildren(...lines(rungs, reads));
      say(note, "");
    } catch {
      if (turn !== this.#turn) return;
      need(place, ".carts-ladder").replaceChildren();
      say(note, tr("What effects would change cannot be computed here."));
    }
  }

  #place() {
    const there = this.details.querySelector(".carts-ladder-box");
    if (there) return there;
    const box = html("div", "carts-ladder-box");
    const note = html("p", "carts-ladder-note carts-quiet");
    note.setAttribute("role", "status");
    box.append(
      html("p", "carts-how-head", tr("What does this scene call for? Largest first:")),
      html("ol", "carts-ladder"),
      note,
    );
    this.details.append(box);
    return box;
  }
}

/** @param {Rung[]} rungs @param {number} reads of a graph's height */
function lines(rungs, reads) {
  const known = rungs.filter(({ changes, listed }) => changes || listed); // else nothing to tell here
  const shown = known.filter(({ visible }) => visible).map(line);
  const hidden = known.filter(({ visible }) => !visible).map(line);
  const between = html(
    "li",
    "carts-ladder-line",
    tr("What is less than {part} % of its height, a graph cannot show:", {
      part: short(100 * reads),
    }),
  );
  return [...shown, between, ...hidden];
}

/** @param {Rung} rung */
function line({ sentence, source, listed }) {
  const item = html("li", listed ? "carts-ladder-listed" : "");
  item.append(capital(told(sentence)));
  if (source) item.append(" ", html("span", "carts-quiet", `(${told(source)})`));
  return item;
}
