/** `<carts-scene>`: adopts the baked page, then lets Python compute what the reader asks for. */

import { forgetForces, showForces } from "../predict/find-forces.js";
import { need } from "../shared/dom.js";
import { readBaked } from "./baked.js";
import * as words from "./element-words.js";
import { askFirst, wireInside } from "./inside.js";
import { Live } from "./live.js";
import { Prepared } from "./prepared.js";
import { Runs } from "./runs.js";
import { SceneView } from "./scene-view.js";
import { followLink } from "./take-along/share.js";
import { forgetWatched, Watch } from "./time/watch.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("./values.js").Settings} Settings */

/** The element class. @param {import("../runtime/client.js").Client} client @param {string} folder address of prepared runs */
export function sceneElement(client, folder) {
  return class CartsScene extends HTMLElement {
    /** @type {SceneView | null} */
    #view = null;
    /** @type {import("../../../view/types.js").Baked | null} */
    #baked = null;
    /** @type {import("../predict/predict.js").Predict | null} */
    #predict = null;
    /** @type {Run | null} the run that “reset” goes back to */
    #lesson = null;
    #runs = new Runs(this, client, {
      scene: () => this.#baked?.fence.scene,
      draw: (run) => this.#draw(run),
      say: (message) => words.note(this, message),
      long: (on) => words.passing(this, words.LONG_RUN, on),
    });
    /** @type {ReturnType<typeof wireInside> | null} */
    #inside = null;
    /** @type {Watch | null} */
    #watch = null;
    asBaked = ""; // the inside of the element as the generator wrote it, for “Start again”
    #live = new Live(this, client, {
      first: () => this.#first(),
      told: () => this.#told,
      link: () => void followLink(this, this.#runs, (text) => words.noteBeside(this, text)),
      failed: () => this.#inside?.controls.enable(this.#runs.stepwise && this.#free),
      stepwise: () => this.#runs.stepwise,
    });
    #leaving = new AbortController(); // ends what the element hears of page and worker
    #restored = Promise.resolve(); // when the reader's earlier prediction is back

    connectedCallback() {
      this.#listen();
      if (this.#view) return;
      if (this.querySelector(".carts-predict")) this.asBaked = this.innerHTML;
      this.#adopt();
      this.#live.still();
    }

    disconnectedCallback() {
      this.#leaving.abort();
    }

    #listen() {
      this.#leaving = new AbortController();
      const { signal } = this.#leaving;
      this.#live.listen(signal);
      this.#runs.answerOthers(signal);
      addEventListener("beforeprint", () => this.#view?.print(true), { signal });
      addEventListener("afterprint", () => this.#view?.print(false), { signal });
    }

    /** Takes over the picture and the controls that the generator wrote. */
    #adopt() {
      const baked = readBaked(this);
      const view = new SceneView(this, baked);
      this.#baked = baked;
      this.#view = view;
      this.#runs.prepared ??= new Prepared(this, baked.fence, folder);
      const inside = wireInside(this, baked, view, client, {
        reset: () => this.#reset(),
        undo: () => this.#runs.undo(),
        preset: (changes, name) => this.#watch?.preset(name, () => this.#runs.preset(changes)),
        found: (said) => void this.#showForces(said),
        settings: () => this.#values.good,
        stops: (target) => this.#runs.stops(target),
        told: () => this.#free,
        change: (target, value, at) =>
          void this.set({ [target]: value }, at).catch((error) => this.#complain(target, error)),
      });
      this.#inside = inside;
      this.#predict = askFirst(this, baked, view, {
        locked: (now) => void this.#reveal(now),
        forgotten: (now) => void this.#startAgain(now),
      });
      this.#watch = new Watch(this, baked, view.player, inside.presets, {
        first: () => this.#told && inside.controls.enable(this.#runs.able),
        all: () => this.#watched(),
      });
      if (!this.#predict) this.#lesson = baked.run;
      if (this.#lesson) inside.find?.show(baked.run);
      void inside.follow(baked.run);
      if (this.#watch.over) view.show(baked.run);
      view.enable(!this.#predict);
      inside.controls.enable(!this.#predict);
      this.#restored = this.#predict?.restore() ?? Promise.resolve();
      this.#live.follow();
    }

    /** The start state and an empty prediction, as on the first visit. @param {boolean} lead whether the focus goes there */
    async #startAgain(lead) {
      this.#reset();
      this.#values.forget();
      this.#lesson = null;
      forgetWatched(this);
      forgetForces(this.id);
      this.innerHTML = this.asBaked;
      this.classList.add("carts-asks");
      this.#adopt();
      await this.#restored;
      if (lead) need(this, ".carts-predict :is(input, textarea):enabled").focus();
    }

    /** A force was found: now they are all shown, at the same values and the same instant. */
    async #showForces(/** @type {string[]} */ said) {
      const [t, values] = [this.time, { ...this.#values.good }];
      this.#view?.player.pause();
      showForces(this, said);
      this.#adopt();
      await this.#restored;
      if (!this.#told) return;
      if (Object.keys(values).length) await this.set({}).catch(() => {});
      this.time = t;
    }

    /** Resolves when Python has answered for this scene; rejects when it cannot start. */
    get ready() {
      return this.#live.ready;
    }

    get trajectory() {
      return (this.#told && this.#view?.run.trajectory) || null;
    }

    get plan() {
      return this.#told ? words.planOf(this.#view?.run) : [];
    }

    get time() {
      return this.#view?.player.time ?? 0;
    }

    set time(t) {
      if (!this.#told) return;
      this.#view?.player.pause();
      this.#view?.player.show(Number(t));
    }

    /**
     * Changes values and resolves when the new run is drawn. Rejects with a message for the reader
     * and leaves the run as it is when a value makes no sense.
     * @param {Settings} changes @param {number} at time of the input, for the measure
     */
    async set(changes, at = performance.now()) {
      if (!this.#told) throw new Error(words.ASK_FIRST);
      this.#values.ask(changes);
      await this.#runs.compute(changes, at);
    }

    get #values() {
      return this.#runs.values;
    }

    get #told() {
      return !this.#predict || this.#lesson !== null;
    }

    /** Whether the reader may change values: after a prediction its run is watched first. */
    get #free() {
      return this.#told && (!this.#predict || Boolean(this.#watch?.over));
    }

    /** Resolves when it is drawn: as it is, or step by step if the reader wants that. @param {Run} run */
    #draw(run) {
      const shown = this.#inside?.follow(run);
      this.#inside?.show(this.#values, run.header);
      this.#inside?.find?.show(run);
      words.offerUndo(this, this.#told && this.#values.canUndo);
      return shown;
    }

    #reset() {
      this.#runs.reset();
      this.#inside?.how.reset();
      this.#view?.player.pause();
      if (this.#lesson) this.#draw(this.#lesson);
      this.#watch?.back();
    }

    /** Python's own answer takes the place of the baked run. */
    async #first() {
      const run = await this.#runs.ask();
      if (run && this.#told && !this.#view?.player.playing) this.#draw(run);
    }

    /** The run without a prediction, for a whole class: it plays, and nothing is kept. */
    async reveal() {
      if (!this.#told) await this.#reveal(false, false);
    }

    /** What the class has seen is no student's prediction: the scene asks again. */
    async conceal() {
      if (this.#told && this.#predict && !this.#predict.isLocked) await this.#startAgain(false);
    }

    /** After the lock: the run, and the prediction beside it. @param {boolean} now locked by the reader just now @param {boolean} own whether there is one */
    async #reveal(now, own = true) {
      this.#predict?.complain("");
      try {
        const run = await this.#runs.ask();
        if (!run) return;
        this.#lesson = run;
        this.classList.remove("carts-asks");
        need(this, ".carts-results").hidden = false;
        this.#draw(run);
        this.#view?.enable(true);
        if (now) this.#view?.announcer.leadTo(need(this, ".carts-play"), "");
        if (this.#predict?.watched) this.#watch?.finish(true);
        else if (!this.#watch?.first) this.#watched();
        else if (now || !own) this.#view?.player.play(); // opened again, it waits to be played
      } catch (error) {
        const { message } = /** @type {Error} */ (error);
        this.#predict?.complain(`${message} ${words.PREDICTION_KEPT}`);
      }
    }

    /** All was seen: now it stands beside the prediction. */
    #watched() {
      if (!this.#predict || !this.#lesson) return;
      this.#inside?.controls.enable(this.#runs.able);
      if (!this.#predict.isLocked) return;
      this.#predict.compare(this.#lesson);
      this.#view?.announcer.tell([this.#predict.spoken]);
    }

    /** @param {string} target @param {Error} error */
    #complain(target, error) {
      this.#inside?.controls.complain(target, error.message);
      this.dispatchEvent(new CustomEvent("carts-error", { bubbles: true, detail: error }));
    }
  };
}
