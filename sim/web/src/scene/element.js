/** `<carts-scene>`: adopts the baked page, then lets Python compute what the reader asks for. */

import { fromWire } from "../../../view/trajectory.js";
import { showForces } from "../predict/find-forces.js";
import { need, say } from "../shared/dom.js";
import { deferred, drawn, frame, refusal } from "../shared/waiting.js";
import { readBaked } from "./baked.js";
import { Controls, valueIn } from "./controls.js";
import * as words from "./element-words.js";
import { askFirst, wireInside } from "./inside.js";
import { SceneView } from "./scene-view.js";
import { followLink } from "./share.js";
import { Values } from "./values.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("./values.js").Settings} Settings */

/** The element class for a client. @param {import("../runtime/client.js").Client} client */
export function sceneElement(client) {
  return class CartsScene extends HTMLElement {
    /** @type {SceneView | null} */
    #view = null;
    /** @type {import("../../../view/types.js").Baked | null} */
    #baked = null;
    /** @type {Controls | null} */
    #controls = null;
    /** @type {import("../predict/predict.js").Predict | null} */
    #predict = null;
    /** @type {Run | null} the run that “reset” goes back to */
    #lesson = null;
    #values = new Values();
    /** @type {ReturnType<typeof wireInside> | null} */
    #inside = null;
    #generation = 0;
    #asBaked = ""; // the inside of the element as the generator wrote it, for “Start again”
    #waiting = deferred();
    /** @type {Promise<void>} when the reader's earlier prediction is back */
    #restored = Promise.resolve();

    connectedCallback() {
      if (this.#view) return;
      if (this.querySelector(".carts-predict")) this.#asBaked = this.innerHTML;
      this.#waiting.promise.catch(() => {}); // readers see the state; nobody has to listen
      this.#adopt();
      client.addEventListener("state", () => this.#follow());
      for (const kind of ["pointerdown", "keydown", "focusin"]) {
        this.addEventListener(kind, () => client.wake(), { once: true, passive: true });
      }
      addEventListener("beforeprint", () => this.#view?.print(true));
      addEventListener("afterprint", () => this.#view?.print(false));
      requestAnimationFrame(() => requestAnimationFrame(() => performance.mark("carts:still")));
    }

    /** Takes over the picture and the controls that the generator wrote. */
    #adopt() {
      const baked = readBaked(this);
      const view = new SceneView(this, baked);
      this.#baked = baked;
      this.#view = view;
      const { controls, switches } = baked.fence;
      const change = (
        /** @type {string} */ target,
        /** @type {any} */ value,
        /** @type {number} */ at,
      ) => void this.set({ [target]: value }, at).catch((error) => this.#complain(target, error));
      this.#controls = new Controls(this, controls, change, switches);
      const inside = wireInside(this, baked, view, client, {
        reset: () => this.#reset(),
        undo: () => this.#undo(),
        preset: (changes) => this.#preset(changes),
        found: () => void this.#showForces(),
        settings: () => this.#values.good,
      });
      this.#inside = inside;
      view.draggable({
        ready: () => this.#told && view.player.time === 0 && !view.player.playing,
        value: (target) => valueIn(view.run.header, target),
        change: (control, value, at) => this.#controls?.take(control.set, value, at),
      });
      this.#predict = askFirst(this, baked, view, {
        locked: (now) => void this.#reveal(now),
        forgotten: () => void this.#startAgain(),
      });
      if (!this.#predict) this.#lesson = baked.run;
      if (this.#lesson) inside.find?.show(baked.run);
      void inside.find?.restore();
      void inside.how.follow(baked.run);
      view.enable(!this.#predict);
      this.#controls.enable(!this.#predict);
      this.#restored = this.#predict?.restore() ?? Promise.resolve();
      this.#follow();
    }

    /** The start state and an empty prediction, as on the first visit. */
    async #startAgain() {
      this.#reset();
      this.#values.forget();
      this.#lesson = null;
      this.innerHTML = this.#asBaked;
      this.classList.add("carts-asks");
      this.#adopt();
      await this.#restored;
      /** @type {HTMLElement | null} */ (
        this.querySelector(".carts-predict :is(input, textarea):enabled")
      )?.focus();
    }

    /** A force was found: now they are all shown, at the same values and the same instant. */
    async #showForces() {
      const [t, values] = [this.time, { ...this.#values.good }];
      this.#view?.player.pause();
      showForces(this);
      if (this.#asBaked) this.#asBaked = this.innerHTML;
      this.#adopt();
      await this.#restored;
      if (!this.#told) return;
      if (Object.keys(values).length) await this.#compute({}, performance.now()).catch(() => {});
      this.time = t;
    }

    /** Resolves when Python has answered for this scene; rejects when it cannot start. */
    get ready() {
      return this.#waiting.promise;
    }

    get trajectory() {
      return this.#told ? (this.#view?.run.trajectory ?? null) : null;
    }

    get plan() {
      return this.#told ? (this.#view?.run.header.plan ?? []) : [];
    }

    get time() {
      return this.#view?.player.time ?? 0;
    }

    set time(t) {
      if (!this.#told) return;
      this.#view?.player.pause();
      this.#view?.player.seek(Number(t));
    }

    /**
     * Changes values and resolves when the new run is drawn. Rejects with a message for the reader
     * and leaves the run as it is when a value makes no sense.
     * @param {Settings} changes @param {number} at time of the input, for the measure
     */
    async set(changes, at = performance.now()) {
      if (!this.#told) throw new Error(words.ASK_FIRST);
      this.#values.ask(changes);
      await this.#compute(changes, at);
    }

    /** @param {Settings} changes to be given up if they are refused @param {number} at */
    async #compute(changes, at) {
      const generation = this.#generation;
      const reply = await this.#ask();
      if (!reply.header.ok) {
        this.#values.giveUp(changes);
        throw refusal(reply.header.problems ?? []);
      }
      if (generation !== this.#generation) return;
      this.#values.good = reply.sent.set;
      await this.#draw({ header: reply.header, trajectory: fromWire(reply.header, reply.numbers) });
      await drawn(this, at, { ...this.#values.good });
    }

    get #told() {
      return !this.#predict || this.#lesson !== null;
    }

    #ask() {
      const scene = this.#baked?.fence.scene;
      return client.ask(this, () => ({ kind: "run", scene, set: { ...this.#values.wanted } }));
    }

    #undo() {
      this.#values.undo();
      this.#compute({}, performance.now()).catch((error) => this.#say(error.message));
    }

    /** Several values at once, from the scene as the lesson has it. @param {Settings} changes */
    #preset(changes) {
      this.#view?.player.pause();
      this.#view?.player.seek(0);
      this.#values.replace(changes);
      this.#compute(changes, performance.now()).catch((error) => this.#say(error.message));
    }

    /** @param {string} message for the reader; empty: none */
    #say(message) {
      const note = need(this, ".carts-note");
      note.hidden = !message;
      say(note, message);
    }

    /** Resolves when it is drawn: as it is, or step by step if the reader wants that. @param {Run} run */
    #draw(run) {
      const shown = this.#inside?.how.follow(run);
      this.#controls?.show(this.#values.good, run.header);
      this.#inside?.find?.show(run);
      const undo = this.querySelector(".carts-undo");
      if (undo instanceof HTMLButtonElement) undo.disabled = !this.#told || !this.#values.canUndo;
      return shown;
    }

    #reset() {
      this.#generation += 1;
      this.#values.reset();
      this.#inside?.how.reset();
      this.#view?.player.pause();
      if (this.#lesson) this.#draw(this.#lesson);
      this.#view?.player.seek(0);
    }

    /** Follows the page's worker: starting, live, failed. */
    #follow() {
      if (client.state === "starting" || client.state === "idle") {
        this.dataset.state = client.state === "idle" ? "still" : "starting";
      } else if (client.state === "failed") this.#fail();
      else if (this.dataset.state !== "live") void this.#goLive();
      else this.#mark();
    }

    #mark() {
      need(this, ".carts-mark").setAttribute("aria-label", words.LIVE);
    }

    async #goLive() {
      try {
        const { header, numbers } = await this.#ask();
        if (!header.ok) throw refusal(header.problems ?? []);
        if (this.#told && !this.#view?.player.playing) {
          this.#draw({ header, trajectory: fromWire(header, numbers) });
        }
        await frame();
        if (client.state !== "ready") return;
        this.dataset.state = "live";
        this.#mark();
        performance.mark("carts:live");
        this.#waiting.resolve(undefined);
        if (this.#told)
          void followLink(this, this.#baked?.fence.id ?? "", (text) => this.#say(text));
      } catch (error) {
        if (client.state !== "failed") this.#fail(/** @type {Error} */ (error));
      }
    }

    /** @param {Error & {reason?: string}} error */
    #fail(error = client.error ?? new Error(words.NOT_STARTED)) {
      this.dataset.state = "failed";
      this.dataset.reason = error.reason ?? "failed";
      this.#controls?.enable(false);
      const note = need(this, ".carts-note");
      note.hidden = false;
      say(note, `${error.message} ${this.#told ? words.STILL_PLAYS : words.NOT_SHOWN}`);
      this.#waiting.reject(error);
      this.dispatchEvent(new CustomEvent("carts-error", { bubbles: true, detail: error }));
    }

    /** The run without a prediction, for a whole class: nothing is kept. */
    async reveal() {
      if (!this.#told) await this.#reveal(false, false);
    }

    /** After the lock: the run, and the prediction beside it. @param {boolean} now locked by the reader just now @param {boolean} own whether there is one */
    async #reveal(now, own = true) {
      this.#predict?.complain("");
      const generation = this.#generation;
      try {
        const { header, numbers } = await this.#ask();
        if (generation !== this.#generation) return;
        if (!header.ok) throw refusal(header.problems ?? []);
        const run = { header, trajectory: fromWire(header, numbers) };
        this.#lesson = run;
        this.classList.remove("carts-asks");
        need(this, ".carts-results").hidden = false;
        this.#draw(run);
        this.#view?.enable(true);
        this.#controls?.enable(true);
        if (own) this.#predict?.compare(run);
        if (now)
          this.#view?.announcer.leadTo(need(this, ".carts-play"), this.#predict?.spoken ?? "");
      } catch (error) {
        const { message } = /** @type {Error} */ (error);
        this.#predict?.complain(`${message} ${words.PREDICTION_KEPT}`);
      }
    }

    /** @param {string} target @param {Error} error */
    #complain(target, error) {
      this.#controls?.complain(target, error.message);
      this.dispatchEvent(new CustomEvent("carts-error", { bubbles: true, detail: error }));
    }
  };
}
