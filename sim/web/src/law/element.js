/** `<carts-law>`: a law of force that a reader writes, its run, and the judge. */

import { tr } from "../../../view/language.js";
import { fromWire } from "../../../view/trajectory.js";
import { bakedOf } from "../scene/baked.js";
import { html, need, say } from "../shared/dom.js";
import { download } from "../shared/download.js";
import { KeptLine } from "../store/kept-line.js";
import { ends } from "../worlds/ends.js";
import { Pictures } from "../worlds/pictures.js";
import { alongWith } from "./along-with.js";
import { lawBar } from "./bar.js";
import { Editor } from "./editor.js";
import { lawKeeper } from "./keep.js";
import { lineOf, OwnPython } from "./own-python.js";
import { verdicts } from "./verdicts.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/types.js").Baked} Baked */
/** @typedef {import("./verdicts.js").Judged} Judged */
/** @typedef {{id: string, hash: string, ask: string, file: string, start: string, baked: any}} Facts */

const YOURS = tr("Your law");

/** @param {string} base address of the folder `runtime/` */
export function lawElement(base) {
  return class CartsLaw extends HTMLElement {
    /** @type {Facts | null} */
    #facts = null;
    /** @type {Baked | null} */
    #baked = null;
    /** @type {Pictures | null} */
    #pictures = null;
    #python = new OwnPython(base);
    #turn = 0;
    #drawn = ""; // the law whose run is drawn; empty: it is no run of the reader's
    #bar = lawBar({
      run: () => this.#do(() => this.#run()),
      judge: () => this.#do(() => this.#judge()),
      stop: () => this.#python.stop(),
      save: () => this.#save(),
      again: () => this.#again(),
    });
    /** Resolves when what was asked for last is shown. @type {Promise<unknown>} */
    complete = Promise.resolve();

    #leaving = new AbortController(); // ends what the element hears of other tabs

    connectedCallback() {
      this.#leaving = new AbortController();
      if (!this.#facts) this.#begin();
      this.keeper?.hear((text) => this.#take(text), this.#leaving.signal);
    }

    #begin() {
      /** @type {Facts} */
      const facts = JSON.parse(need(this, ".carts-law-baked").textContent ?? "");
      this.#facts = facts;
      this.#baked = bakedOf(facts.baked);
      this.keeper = lawKeeper(facts);
      this.editor = new Editor(facts.id, (text) => this.#typed(text));
      this.editor.text = facts.start;
      this.note = html("p", "carts-law-note");
      this.note.setAttribute("role", "status");
      this.fault = html("p", "carts-law-fault");
      this.fault.setAttribute("role", "alert");
      this.unsaved = new KeptLine(this);
      this.shown = html("div", "carts-law-shown");
      this.found = html("div", "carts-law-found");
      const live = need(this, ".carts-law-live");
      const told = [this.fault, this.unsaved.root, this.note, this.shown, this.found];
      live.append(this.editor.root, this.#bar.root, ...told);
      live.hidden = false;
      this.classList.add("carts-law-ready");
      this.#first();
      this.#open(false);
      this.complete = this.#restore();
    }

    disconnectedCallback() {
      this.#leaving.abort();
      this.#pictures?.leave();
      this.#python.stop();
    }

    async #restore() {
      this.#take((await this.keeper?.get()) || String(this.#facts?.start));
      this.#open(true);
      this.dataset.state = "live"; // from now on it takes a law
    }

    /** Nothing is typed over a kept law before it is here. @param {boolean} on */
    #open(on) {
      if (this.editor) this.editor.box.readOnly = !on;
      for (const one of this.querySelectorAll(".carts-law-bar button"))
        one.toggleAttribute("disabled", !on || one === this.#bar.end);
    }

    /** @param {string} text that was kept */
    #take(text) {
      if (this.editor) this.editor.text = text;
      if (this.found?.childElementCount) this.#changed();
      this.#paper();
    }

    /** @param {string} text */
    #typed(text) {
      void this.#python.wake().catch(() => {}); // Python is there when the law is
      void this.#keep(text);
      if (this.found?.childElementCount) this.#changed();
      this.#paper();
    }

    /** What was judged is another law than that in the box. */
    #changed() {
      this.found?.replaceChildren();
      this.#say(tr("Your law has changed: judge it again."));
    }

    /** @param {string} text @param {boolean} tried */
    #keep(text, tried = false) {
      return this.unsaved?.hear(this.keeper?.put(text, tried));
    }

    /** On paper stands what is in the box now, and over the picture whose it is. */
    #paper() {
      const text = this.editor?.text ?? "";
      say(need(this, ".carts-law-paper code"), text);
      if (!this.#drawn) return;
      const whose = text === this.#drawn ? YOURS : tr("Your law, before you changed it");
      for (const place of this.shown?.querySelectorAll("figcaption, th[scope=col]") ?? [])
        say(place, whose);
    }

    #again() {
      if (!this.editor || !this.#facts || !this.#baked) return;
      if (this.editor.text !== this.#facts.start) this.keeper?.setAside();
      this.editor.text = this.#facts.start;
      this.found?.replaceChildren();
      this.#typed(this.editor.text);
      this.#tell("");
      this.#first();
      this.editor.box.focus();
    }

    #save() {
      if (this.editor && this.#facts) download(this.#facts.file, this.editor.text, "text/x-python");
    }

    /** One thing at a time; what goes wrong is told, and the text stays. @param {() => Promise<void>} act */
    #do(act) {
      this.#turn += 1;
      const turn = this.#turn;
      this.#tell("");
      this.#working(true);
      this.complete = act()
        .catch((error) => {
          if (turn === this.#turn) this.#tell(error.message, lineOf(error));
        })
        .finally(() => {
          if (turn === this.#turn) this.#working(false);
        });
    }

    async #run() {
      void this.#keep(this.editor?.text ?? "", true);
      this.#say(tr("Computing …"));
      const text = this.editor?.text;
      const unequal = await this.#draw(this.#scene());
      if (this.editor?.text !== text) return this.#changed();
      if (unequal) this.#say(tr("The two carts do not push each other equally hard."));
      else this.#say(tr("Done: the new run is below."));
    }

    /** Runs the scene and shows it. @param {any} scene @returns {Promise<boolean>} whether the carts push unequally */
    async #draw(scene) {
      const { header, numbers } = await this.#python.ask({ do: "run", scene });
      const run = { header, trajectory: fromWire(header, numbers) };
      this.#show(run, /** @type {Baked} */ (this.#baked), YOURS);
      this.#drawn = scene.laws[/** @type {Facts} */ (this.#facts).file];
      this.#paper(); // it may have changed while it was computed
      return header.unequal;
    }

    async #judge() {
      void this.#keep(this.editor?.text ?? "", true);
      this.found?.replaceChildren();
      const [scene, { file }] = [this.#scene(), /** @type {Facts} */ (this.#facts)];
      const judged = await this.#python.judge({ law: file, scene }, (text) => this.#say(text));
      const meanwhile = () => this.#scene().laws[file] !== scene.laws[file];
      if (meanwhile()) return this.#changed();
      this.found?.append(verdicts(judged, (one) => this.#do(() => this.#example(one))));
      if (this.#drawn !== scene.laws[file]) await this.#draw(scene); // the picture is of what was judged
      if (!meanwhile()) this.#say(tr("Judged: what was found is below."));
    }

    /** The worst scene of one law of physics. @param {import("./verdicts.js").Verdict} verdict */
    async #example(verdict) {
      const { header, numbers } = await this.#python.ask({ do: "run", scene: verdict.scene });
      const run = { header, trajectory: fromWire(header, numbers) };
      this.#show(run, alongWith(/** @type {Baked} */ (this.#baked), run), tr("A counterexample"));
      this.shown?.scrollIntoView({ block: "nearest" });
    }

    /** The scene of the page, with the law as it is in the box. */
    #scene() {
      const { file } = /** @type {Facts} */ (this.#facts);
      const scene = /** @type {any} */ (/** @type {Baked} */ (this.#baked).fence.scene);
      return { ...scene, laws: { ...scene.laws, [file]: this.editor?.text || "\n" } };
    }

    /** @param {Run} run @param {Baked} baked @param {string} caption */
    #show(run, baked, caption) {
      this.#picture(run, baked, caption);
      this.shown?.append(ends([{ label: caption, run }], baked.view));
    }

    /** @param {Run} run @param {Baked} baked @param {string} caption */
    #picture(run, baked, caption) {
      this.#pictures?.leave();
      this.#drawn = "";
      this.#pictures = new Pictures(baked, [{ run, caption }]);
      this.shown?.replaceChildren(this.#pictures.root);
    }

    /** What the reader begins with, without its numbers: a lesson may ask for them first. */
    #first() {
      const baked = /** @type {Baked} */ (this.#baked);
      this.#picture(baked.run, baked, tr("The law that you begin with"));
    }

    /** @param {string} message @param {number} line of the law, from 1; 0: of none */
    #tell(message, line = 0) {
      say(/** @type {HTMLElement} */ (this.fault), message);
      if (message) this.#say("");
      if (line) this.editor?.go(line);
    }

    /** @param {string} text */
    #say(text) {
      say(/** @type {HTMLElement} */ (this.note), text);
    }

    /** @param {boolean} on */
    #working(on) {
      this.#bar.working(on);
      this.toggleAttribute("data-working", on);
    }
  };
}
