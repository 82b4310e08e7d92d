/**
 * `<carts-worlds>`: after a run was watched, the same scene in worlds in which a belief would be true.
 * Nothing of it is shown, asked or computed before; the real run always stands beside.
 */

import { told, tr } from "../../../view/language.js";
import { fromWire } from "../../../view/trajectory.js";
import { readBaked } from "../scene/baked.js";
import { WATCHED } from "../scene/time/watch.js";
import { askScene } from "../shared/ask-scene.js";
import { html, need, say } from "../shared/dom.js";
import { asText } from "../shared/settings.js";
import { RESET, refusal } from "../shared/waiting.js";
import { ends } from "./ends.js";
import { Pictures } from "./pictures.js";
import { isYours } from "./yours.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {{name: string, numbers: Record<string, number>, says: string}} World */

export class WorldsElement extends HTMLElement {
  #leaving = new AbortController();
  /** @type {Pictures | null} */
  #pictures = null;
  #turn = 0;
  #values = "[]"; // that the reader has set, as the scene tells them

  connectedCallback() {
    this.#leaving = new AbortController();
    const { signal } = this.#leaving;
    document.addEventListener(WATCHED, ({ target }) => target === this.scene && this.#open(), {
      signal,
    });
    for (const kind of ["carts-update", RESET]) {
      const hear = (/** @type {Event} */ event) =>
        event.target === this.scene && this.#heard(event);
      document.addEventListener(kind, hear, { signal });
    }
    const waits = this.scene.querySelector(".carts-predict, .carts-end") !== null;
    if (!waits || "watched" in this.scene.dataset) this.#open();
    const again = new MutationObserver(() => {
      if (this.scene.classList.contains("carts-asks")) this.#close();
    });
    again.observe(this.scene, { attributeFilter: ["class"] }); // “Start again”
    signal.addEventListener("abort", () => again.disconnect());
  }

  disconnectedCallback() {
    this.#leaving.abort();
    this.#pictures?.leave();
  }

  /** @returns {HTMLElement} */
  get scene() {
    return need(document, `carts-scene[id="${this.dataset.for}"]`);
  }

  /** @returns {World[]} as the lesson names them */
  get worlds() {
    return JSON.parse(need(this, "script").textContent ?? "{}").worlds;
  }

  #open() {
    if (!this.hasAttribute("hidden")) return;
    const names = html("div", "carts-worlds-names");
    for (const world of this.worlds) {
      const button = html("button", "carts-button", tr("… {what}?", { what: world.says }));
      button.setAttribute("type", "button");
      button.setAttribute("aria-pressed", "false");
      button.addEventListener("click", () => void this.#show(world, button));
      names.append(button);
    }
    const note = html("p", "carts-worlds-note");
    note.setAttribute("role", "status");
    this.append(
      html("p", "carts-heading", tr("What if …")),
      html("p", "", tr("Worlds that do not exist. Watch what would happen there, beside ours.")),
      names,
      note,
      html("div", "carts-worlds-show"),
    );
    this.toggleAttribute("hidden", false);
  }

  /** Nothing is known once more. */
  #close() {
    this.toggleAttribute("hidden", true);
    this.#turn += 1;
    this.#pictures?.leave();
    for (const part of [...this.children]) if (part.localName !== "script") part.remove();
  }

  /** Other values are set: what is shown here, or being computed, is of the old ones. @param {Event} event */
  #heard(event) {
    const { detail } = /** @type {CustomEvent} */ (event);
    const values = asText(detail ?? {});
    if (values === this.#values) return;
    this.#values = values;
    if (!this.querySelector('[aria-pressed="true"]')) return;
    this.#turn += 1;
    this.#clear();
    say(need(this, ".carts-worlds-note"), tr("The values have changed: press again."));
  }

  /** No world is shown. */
  #clear() {
    this.#pictures?.leave();
    this.#pictures = null;
    need(this, ".carts-worlds-show").replaceChildren();
    for (const one of this.querySelectorAll(".carts-worlds-names button")) {
      one.setAttribute("aria-pressed", "false");
    }
  }

  /** @param {World} world @param {Element} button */
  async #show(world, button) {
    this.#turn += 1;
    const turn = this.#turn;
    const note = need(this, ".carts-worlds-note");
    const place = need(this, ".carts-worlds-show");
    say(note, tr("Computing …"));
    for (const one of this.querySelectorAll(".carts-worlds-names button")) {
      one.setAttribute("aria-pressed", String(one === button));
    }
    try {
      const worlds = this.worlds.map(({ name, numbers }) => ({ [name]: numbers }));
      const real = await this.#ask({ kind: "run" });
      const other = await this.#ask({ kind: "worlds", worlds, world: world.name });
      const baked = readBaked(this.scene);
      const own = await isYours(baked, other);
      if (turn !== this.#turn) return;
      this.#pictures?.leave();
      this.#pictures = new Pictures(baked, [
        { run: real, caption: tr("Our world") },
        { run: other, caption: world.says, impossible: true },
      ]);
      place.replaceChildren(
        this.#pictures.root,
        ...(own ? [yours()] : []),
        ends(
          [
            { label: tr("Our world"), run: real },
            { label: tr("Impossible"), run: other },
          ],
          baked.view,
        ),
        broken(other),
      );
      say(note, "");
      this.#pictures.player.play();
    } catch (error) {
      if (turn !== this.#turn) return;
      this.#clear(); // what is shown is another world than the one asked for
      say(note, /** @type {Error} */ (error).message);
    }
  }

  /** @param {Record<string, unknown>} message @returns {Promise<Run>} */
  async #ask(message) {
    const { header, numbers } = await askScene(this.scene, message);
    if (!header.ok) throw refusal(header.problems ?? []);
    return { header, trajectory: fromWire(header, numbers) };
  }
}

function yours() {
  return html("p", "carts-worlds-yours", tr("This is the world of your arrows."));
}

/** What the world breaks, and what remains to be asked. @param {Run} run */
function broken({ header }) {
  const { broken: sentences } = /** @type {any} */ (header);
  const box = html("div", "carts-worlds-broken");
  box.append(html("p", "carts-heading", tr("What breaks there")));
  const list = html("ul");
  list.append(
    ...sentences.map((/** @type {import("../../../view/language.js").Said} */ sentence) =>
      html("li", "", told(sentence)),
    ),
  );
  box.append(list, html("p", "", tr("Which of the two have you seen with real carts?")));
  return box;
}
