/** The run in words: a list of events, each a button that goes there; and the model card. */

import { marks } from "../../../view/effects-words.js";
import { exits } from "../../../view/exits.js";
import { counted } from "../../../view/language.js";
import { modelSentences } from "../../../view/model-words.js";
import { fixed } from "../../../view/numbers.js";
import { isTold } from "../../../view/trajectory.js";
import { bareOf, eventSentence, exitSentence, lawsOf } from "../../../view/words.js";
import { html, need, put } from "../shared/dom.js";

const MOST_EVENTS = 60;
const IN_FULL = 10; // events that stand there without scrolling

export class Story {
  /** @type {{t: number, sentence: string}[]} */
  told = [];
  #seen = Infinity; // s, as far as the run was watched
  #listed = -1; // sentences that stand there
  #last = false; // whether the model stands there

  /** @param {HTMLElement} root @param {import("../../../view/types.js").Baked} baked @param {(t: number) => void} seek */
  constructor(root, baked, seek) {
    const { fence, view } = baked;
    this.root = root;
    this.view = view;
    /** @type {import("../../../view/types.js").Header | null} */
    this.header = null;
    this.layout = /** @type {import("../../../view/types.js").Layout} */ (view.layouts[0]);
    this.telling = {
      decimals: view.decimals,
      scale: view.velocity,
      camera: fence.camera,
      forces: fence.forces === "shown",
    };
    this.list = need(root, ".carts-events");
    this.model = need(root, ".carts-model ul");
    this.list.addEventListener("click", (event) => {
      const button = /** @type {Element} */ (event.target).closest("button");
      if (button?.dataset.time) seek(Number(button.dataset.time));
    });
  }

  /** @param {import("../../../view/types.js").Run} run */
  show(run) {
    const { header } = run;
    const decimals = this.view.decimals.v ?? 2;
    const laws = lawsOf(header);
    const bare = bareOf(header);
    this.told = [
      ...(isTold(run) ? marks(header, this.telling.forces) : []),
      ...header.events.map((event) => ({
        t: event.t,
        sentence: eventSentence(event, this.telling, laws, bare, header.track),
      })),
      ...exits(run, this.layout, this.telling.camera).map((exit) => ({
        t: exit.t,
        sentence: exitSentence(exit, decimals, this.view.velocity),
      })),
    ].sort((a, b) => a.t - b.t);
    this.header = header;
    this.#listed = -1;
    this.grow(this.#seen);
  }

  /** Lists what has happened by then; what the model is made of is told at the end. @param {number} seen in s */
  grow(seen) {
    this.#seen = seen;
    const seenOnes = this.told.filter(({ t }) => t <= seen);
    const whole = seen === Infinity;
    if (!this.header || (seenOnes.length === this.#listed && whole === this.#last)) return;
    [this.#listed, this.#last] = [seenOnes.length, whole];
    const items = seenOnes.slice(0, MOST_EVENTS).map((one) => this.#item(one));
    const more = seenOnes.length - items.length;
    if (more > 0)
      items.push(
        html(
          "li",
          "carts-more-events",
          counted("… and 1 more event.", "… and {n} more events.", more),
        ),
      );
    this.list.replaceChildren(...items);
    const scrolled = items.length > IN_FULL;
    put(this.list, "class", scrolled ? "carts-events carts-events-scrolled" : "carts-events");
    if (scrolled) put(this.list, "tabindex", "0");
    else this.list.removeAttribute("tabindex");
    const open = whole && this.header.plan.length > 0; // not so before a prediction
    // What it says of a contact is what a reader of hidden forces is to find.
    const hides = this.root.querySelector(".carts-find") !== null;
    const model = open && !hides ? modelSentences(this.header, this.telling.forces) : [];
    this.model.replaceChildren(...model.map((text) => html("li", "", text)));
    need(this.root, ".carts-model").hidden = !whole || hides;
  }

  /** @param {{t: number, sentence: string}} told */
  #item({ t, sentence }) {
    const item = html("li");
    const button = html("button", "", `${fixed(t, this.view.decimals.t ?? 3)} s`);
    button.setAttribute("type", "button");
    button.className = "carts-jump";
    button.dataset.time = String(t);
    item.append(button, " ", html("span", "", sentence));
    return item;
  }

  /** What has happened after `before`, up to and including `now`; from the start on all of it. @param {number} before @param {number} now */
  between(before, now) {
    const after = before || -1;
    return this.told.filter(({ t }) => t > after && t <= now).map(({ sentence }) => sentence);
  }
}
