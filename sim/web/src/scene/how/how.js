/**
 * “How is this computed?” of one scene. Until a reader opens it nothing is made, asked or measured.
 * The default is exact; with a stepping method the scene plays that run, and the exact one behind it.
 */

import { fromWire, isTold } from "../../../../view/trajectory.js";
import { besideScript } from "../../runtime/page-python.js";
import { bring } from "../../shared/bring.js";
import { html, need, say } from "../../shared/dom.js";
import { refusal } from "../../shared/waiting.js";
import { WATCHED } from "../time/watch.js";
import { HowPanel } from "./panel.js";
import * as words from "./words.js";

/** @typedef {import("../../../../view/types.js").Run} Run */

const PACKAGES = ["numpy", "scipy"];
const PROOF = besideScript("proof.js"); // read when a reader opens the box, and not before
const REST = 400; // ms without another run before it is measured

export class How {
  /** @type {HowPanel | null} */
  #panel = null;
  /** @type {Run | null} */
  #exact = null;
  /** @type {HTMLElement | null} */
  #sign = null;
  #turn = 0;
  #timer = 0;
  #measuring = {}; // an owner of its own: a measurement is no newer run
  /** @type {import("../../proof/proof.js").Proof | null} */
  #proof = null;

  /**
   * @param {HTMLElement} root @param {import("../scene-view.js").SceneView} view
   * @param {import("../../runtime/client.js").Client} client
   * @param {(more: object) => Record<string, unknown>} message a request for the scene as it is now
   * @param {AbortSignal} signal another inside takes the place of this one, which the element outlives
   */
  constructor(root, view, client, message, signal) {
    this.root = root;
    this.view = view;
    this.client = client;
    this.message = message;
    this.details = /** @type {HTMLDetailsElement} */ (need(root, ".carts-how"));
    this.details.addEventListener("toggle", () => this.#opened());
    root.addEventListener(WATCHED, () => this.#opened(), { signal });
  }

  /** A new exact run: it is shown, or its scene step by step. @param {Run} run */
  async follow(run) {
    this.#exact = run;
    this.#turn += 1;
    this.#proof?.forget();
    this.#opened();
    if (this.#panel?.choice) await this.#step();
    else this.#showExact();
  }

  /** Back to exact, from the next run on. */
  reset() {
    this.#panel?.reset();
    this.#turn += 1;
  }

  #showExact() {
    this.#sign?.remove();
    this.#sign = null;
    if (this.#exact) this.view.show(this.#exact);
  }

  /** Where it is open, it tells of the run that is there now. */
  #opened() {
    clearTimeout(this.#timer);
    const run = this.#exact ?? this.view.run;
    if (!this.details.open) return;
    const place = need(this.details, ".carts-how-body");
    const watched = this.view.player.seen === Infinity;
    if (!isTold(run) || !watched) {
      this.#panel = this.#proof = null;
      place.replaceChildren(html("p", "", isTold(run) ? words.UNWATCHED : words.LOCKED));
      return;
    }
    if (!this.#panel) {
      this.#panel = new HowPanel(place, canHaveScipy(), () => void this.#chosen());
      void this.#offerProof(this.#panel, place);
    }
    this.#panel.show(run, this.view.baked.view.decimals.t ?? 2);
    if (this.#panel.choice) return;
    say(this.#panel.cost, this.client.state === "failed" ? words.NO_PYTHON : words.MEASURING);
    this.#timer = setTimeout(() => void this.#measure(), this.view.player.playing ? REST : 0);
  }

  /** @param {HowPanel} panel @param {Element} place */
  async #offerProof(panel, place) {
    /** @type {typeof import("../../proof/proof.js").Proof | null} */
    const Proof = await bring("cartsProof", PROOF);
    if (!Proof || panel !== this.#panel) return;
    this.#proof = new Proof(this.view, place, this.client, this.message);
  }

  async #measure() {
    const turn = this.#turn;
    try {
      const { header } = await this.client.ask(this.#measuring, () => this.message({}));
      if (turn !== this.#turn || !this.#panel) return;
      const answer = /** @type {any} */ (header);
      const used = /** @type {any} */ (this.#exact?.header)?.evaluations?.solvers ?? {};
      const formulas = words.formulasWords(used);
      if (header.ok) say(this.#panel.cost, `${formulas} ${words.costWords(answer)}`.trim());
    } catch {
      if (this.#panel) say(this.#panel.cost, words.NO_PYTHON);
    }
  }

  /** The reader chose a method or a step. */
  async #chosen() {
    this.#turn += 1;
    if (this.#panel?.choice) return this.#step();
    this.#panel?.reset();
    this.#showExact();
    this.#opened();
  }

  async #step() {
    const panel = this.#panel;
    const exact = this.#exact ?? this.view.run;
    this.#exact = exact;
    const turn = this.#turn;
    if (!panel?.choice) return;
    try {
      if ("rtol" in panel.choice && !pageHasScipy()) {
        say(panel.note, words.LOADING);
        await this.client.need(PACKAGES);
      }
      const { header, numbers } = await this.client.ask(this, () =>
        this.message({ ...panel.choice }),
      );
      if (turn !== this.#turn) return;
      if (!header.ok) throw refusal(header.problems ?? []);
      /** @type {words.Compared} */
      const how = /** @type {any} */ (header).how;
      this.view.show({ header, trajectory: fromWire(header, numbers) }, exact);
      panel.tell(words.comparedWords(how));
      say(panel.note, "");
      this.#tellBeside(words.signWords(how));
    } catch (error) {
      if (turn !== this.#turn) return;
      this.#showExact();
      panel.tell([]);
      say(panel.note, `${/** @type {Error} */ (error).message} ${words.FAILED}`);
    }
  }

  /** @param {string} text below the carts */
  #tellBeside(text) {
    if (!this.#sign) {
      this.#sign = html("p", "carts-how-sign");
      this.#sign.setAttribute("role", "status");
      need(this.root, ".carts-world").append(this.#sign);
    }
    say(this.#sign, text);
  }
}

/** Whether Python in this page starts with scipy. */
function pageHasScipy() {
  return document.querySelector('carts-scene[data-packages~="scipy"]') !== null;
}

/** Only pages that ship scipy anyway offer the methods that need it. */
function canHaveScipy() {
  return pageHasScipy() || document.querySelector("carts-cost") !== null;
}
