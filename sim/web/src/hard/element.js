/** `<carts-hard>`: the table of hard cases; runs them again, one by one, in the reader's browser. */

import * as words from "../../../view/hard/words.js";
import { LIVE } from "../scene/element-words.js";
import { html, need, say } from "../shared/dom.js";
import { refusal } from "../shared/waiting.js";
import { showWorking } from "../shared/working.js";

/** @typedef {{scene: object, expected: words.Wanted, within: number[], events: boolean, packages: string[]}} Case */
/** @typedef {{exact: {got: words.Got, seconds: number}, stepped: {method: string, verdict: string, got: words.Got}[]}} Answer */

/** The element class for a client. @param {import("../runtime/client.js").Client} client */
export function hardElement(client) {
  return class CartsHard extends HTMLElement {
    /** @type {Record<string, Case> | null} */
    #cases = null;
    /** Answers by the name of the case. @type {Record<string, Answer>} */
    answers = {};
    /** Resolves when the newest turn is complete or was stopped. @type {Promise<void>} */
    complete = Promise.resolve();
    #turn = 0;

    connectedCallback() {
      if (this.#cases) return;
      this.#cases = JSON.parse(need(this, ".carts-hard-baked").textContent ?? "");
      const go = /** @type {HTMLButtonElement} */ (need(this, ".carts-hard-go"));
      go.disabled = false;
      go.addEventListener("click", () => {
        this.complete = this.#run();
      });
      need(this, ".carts-hard-stop").addEventListener("click", () => this.stop());
      for (const block of this.querySelectorAll("pre")) offerCopy(block);
    }

    disconnectedCallback() {
      this.stop();
    }

    /** Leaves it where it is; what was run stays. */
    stop() {
      if (!this.#turn) return;
      this.#turn = 0;
      this.#working(false);
      this.#say(words.stoppedWords(Object.keys(this.answers).length));
    }

    async #run() {
      const turn = Math.random() + 1;
      this.#turn = turn;
      this.answers = {};
      this.#working(true);
      const all = Object.entries(this.#cases ?? {});
      // Those that need packages come last: the others need not wait for them.
      all.sort(([, a], [, b]) => a.packages.length - b.packages.length);
      let [good, seconds] = [0, 0];
      try {
        for (const [k, [name, one]] of all.entries()) {
          if (one.packages.length) {
            this.#say(words.LOADING);
            await client.need(one.packages);
          }
          if (this.#turn !== turn) return;
          const message = { kind: "hard", ...asked(one) };
          const { header } = await client.ask(this, () => message);
          if (this.#turn !== turn) return;
          if (!header.ok) throw refusal(header.problems ?? []);
          this.#live();
          /** @type {Answer} */
          const answer = /** @type {any} */ (header);
          this.answers[name] = answer;
          this.#show(name, one, answer);
          seconds += answer.exact.seconds;
          good += isGood(one, answer.exact.got) ? 1 : 0;
          const bar = /** @type {HTMLProgressElement} */ (need(this, ".carts-hard-progress"));
          bar.value = k + 1;
          this.#say(words.progressWords(k + 1, all.length));
        }
        this.#say(words.doneWords(good, all.length, seconds));
      } catch (error) {
        if (this.#turn === turn) this.#fail(/** @type {Error & {reason?: string}} */ (error));
      } finally {
        if (this.#turn === turn) this.#working(false);
        if (this.#turn === turn) this.#turn = 0;
      }
    }

    /** @param {string} name @param {Case} one @param {Answer} answer */
    #show(name, one, answer) {
      const row = need(this, `[data-case="${name}"]`);
      say(need(row, '[data-part="exact"]'), words.exactCell(one.expected, answer.exact));
      for (const [k, cell] of [...row.querySelectorAll('[data-part="stepped"]')].entries()) {
        const stepped = answer.stepped[k];
        if (!stepped) continue;
        const [verdict, distance] = words.steppedCell(one.expected, stepped);
        cell.setAttribute("data-verdict", stepped.verdict);
        say(need(cell, "b"), verdict);
        say(need(cell, "span"), distance);
      }
      row.classList.add("carts-hard-fresh");
    }

    /** @param {boolean} on */
    #working(on) {
      showWorking(this, "hard", on);
      if (!on) return;
      need(this, ".carts-note").hidden = true; // of what went wrong before
      for (const row of this.querySelectorAll(".carts-hard-fresh"))
        row.classList.remove("carts-hard-fresh");
    }

    #live() {
      this.dataset.state = "live";
      need(this, ".carts-mark").setAttribute("aria-label", LIVE);
    }

    /** @param {Error & {reason?: string}} error */
    #fail(error) {
      this.dataset.reason = error.reason ?? "failed";
      const note = need(this, ".carts-note");
      say(note, words.keptWords(error.message));
      note.hidden = false;
      this.#say("");
    }

    /** @param {string} text */
    #say(text) {
      say(need(this, ".carts-hard-say"), text);
    }
  };
}

/** @param {Case} one the request without what only the page needs */
function asked({ scene, expected, events }) {
  return { scene, expected, events };
}

/** Is every number as near as its source says? @param {Case} one @param {words.Got} got */
function isGood({ expected, within }, got) {
  return expected.every(([, right], k) => {
    return Math.abs(Number(got[k] ?? Number.NaN) - right) <= Number(within[k]);
  });
}

/** @param {HTMLElement} block a scene or a command */
function offerCopy(block) {
  const button = html("button", "carts-sign carts-hard-copy", words.COPY);
  button.setAttribute("type", "button");
  button.addEventListener("click", async () => {
    const selection = getSelection();
    selection?.selectAllChildren(block); // where copying is not allowed, it is at least marked
    const copied = await navigator.clipboard?.writeText(block.textContent ?? "").then(
      () => true,
      () => false,
    );
    if (copied) say(button, words.COPIED);
  });
  block.before(button);
}
