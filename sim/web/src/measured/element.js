/** `<carts-measured>`: readings of real carts, the model laid over them by hand, and its fit by Python. */

import { tr } from "../../../view/language.js";
import { missing } from "../../../view/measured/units.js";
import { need } from "../shared/dom.js";
import { Asking } from "./asking.js";
import { wireButtons } from "./buttons.js";
import { happened, PACKAGES, whenLive } from "./early.js";
import { Hands } from "./hands.js";
import { empty, keeper, readings, usual } from "./keep.js";
import { Picture } from "./picture.js";
import { Settings } from "./settings.js";
import { Source } from "./source.js";
import { Strip } from "./strip.js";

/** @typedef {import("../../../view/measured/types.js").Read} Read */
/** @typedef {import("../../../view/measured/types.js").Drawn} Drawn */
/** @typedef {import("../../../view/measured/types.js").Kept} Kept */
/** @typedef {import("../../../view/measured/types.js").Facts} Facts */

/** The element class for a client. @param {import("../runtime/client.js").Client} client @param {string} base address of this script */
export function measuredElement(client, base) {
  return class CartsMeasured extends HTMLElement {
    /** @type {Facts | null} */
    #facts = null;
    /** @type {Kept} */
    #kept = /** @type {Kept} */ ({});
    /** @type {Read | null} */
    #read = null;
    report = /** @type {import("../../../view/measured/types.js").Report | null} */ (null); // of the last fit
    /** Resolves when what was asked for last is shown. @type {Promise<unknown>} */
    complete = Promise.resolve();
    #asking = new Asking(
      client,
      () => ({ ...this.#given, ...this.settings?.asked, segments: this.strip?.given ?? [] }),
      () => this.setAttribute("data-state", "live"),
    );
    #tried = false; // a fit of these readings, refused or not: a boundary that is moved asks for it again
    #leaving = new AbortController(); // ends what the element hears of the worker

    connectedCallback() {
      this.#leaving = new AbortController();
      if (this.#facts) return whenLive(this, client, this.#leaving.signal);
      this.#facts = JSON.parse(need(this, ".carts-measured-baked").textContent ?? "");
      const facts = /** @type {Facts} */ (this.#facts);
      this.keeper = keeper(facts.id, this);
      this.picture = new Picture(this);
      this.hands = new Hands(this, () => this.#moved());
      this.settings = new Settings(this, (again) => this.#changed(again));
      this.source = new Source(
        need(this, ".carts-measured-source"),
        (name, texts, same) => this.#take(name, texts, same),
        () => this.#keep(),
        (text) => this.#refuse(text ? [{ line: null, reason: text, hint: "" }] : []),
        (zip) => this.#asking.ask("unzip", { zip }),
        base,
      );
      this.strip = new Strip(
        need(this, ".carts-measured-spans"),
        () => void (this.#tried ? this.fit(this.#kept.fitted === "compared") : this.#early()),
      );
      this.picture.watch = (time, places) => this.source?.films.at(time, places);
      wireButtons(this, {
        own: () => this.source?.take("", []),
        save: () => this.source?.save(this.#name, this.#given.texts),
        fit: () => void this.fit(),
        compare: () => void this.fit(true),
        tracker: () => this.#asking.ask("tracker"),
        early: () => void client.need(PACKAGES).catch(() => {}),
      });
      if (facts.read) this.#show(facts.read, null);
      this.complete = this.#restore();
    }

    disconnectedCallback() {
      this.#leaving.abort();
      this.picture?.player.pause();
      this.source?.films.end();
    }

    /** What was done here before, or the lesson's readings. */
    async #restore() {
      this.#kept = { ...empty(/** @type {Facts} */ (this.#facts)), ...(await this.keeper?.get()) };
      this.settings?.fill(this.#kept);
      if (this.strip) this.strip.given = this.#kept.segments ?? [];
      this.source?.open(this.#kept);
      return this.#given.texts.length ? this.#anew() : whenLive(this, client, this.#leaving.signal);
    }

    /** Reads, and does again what was done with the readings before. */
    async #anew() {
      const { hand, fitted, texts } = this.#kept;
      await this.#reading();
      if (this.#kept.texts !== texts) return; // others were opened meanwhile
      if (fitted) await this.#fit(fitted === "compared");
      else if (hand && this.hands && this.#read?.kind === "length") {
        this.hands.value = hand;
        await this.#byHand();
      }
    }

    get #given() {
      return readings(this.#kept, /** @type {Facts} */ (this.#facts));
    }

    get #name() {
      return this.#kept.name || this.#facts?.name || "";
    }

    /** @param {string} name @param {string[]} texts none: the lesson's own @param {import("./films.js").Same} same what was so before */
    #take(name, texts, same = "") {
      const other = same !== "clock";
      Object.assign(this.#kept, { name, texts }, other && { fitted: "", hand: null });
      this.settings?.clear(usual(texts, /** @type {Facts} */ (this.#facts)), same);
      if (other) this.strip?.clear();
      this.complete = this.#anew();
    }

    /** @param {boolean} again whether the readings are others now */
    #changed(again) {
      this.#kept.fitted = "";
      if (!again) return this.#moved();
      this.strip?.clear();
      this.complete = this.#reading();
    }

    #moved() {
      if (this.#read?.kind === "length") this.complete = this.#byHand();
    }

    #keep() {
      const segments = this.strip?.given ?? [];
      this.#kept = { ...this.#kept, ...this.settings?.kept, ...this.source?.typed, segments };
      this.keeper?.put(structuredClone(this.#kept));
    }

    /** Asks for something and shows it, if nothing newer was asked for meanwhile. @param {string} what @param {Record<string, unknown>} more @param {(found: any) => void} show @returns {Promise<boolean>} whether it was shown */
    async #newest(what, more, show) {
      try {
        const found = await this.#asking.newest(what, more);
        if (!found) return false;
        this.#refuse(found.refused ?? [], what);
        const story = found.report ?? found; // a refused fit has one too
        if (story.segments) this.strip?.show(story, this.#read?.tracks[0].t);
        if (found.refused) return false;
        this.picture?.note("");
        show(found);
        return true;
      } catch (error) {
        this.#note(/** @type {Error} */ (error).message);
        return false;
      }
    }

    async #reading() {
      this.#keep();
      if (!this.#given.texts.length) return;
      await this.#newest("read", {}, (found) => this.#show(found, found));
      this.dispatchEvent(new CustomEvent("carts-measured"));
    }

    /** The strip before any fit: of itself over the reader's own readings only. */
    async #early() {
      const read = /** @type {Read} */ (this.#read);
      this.#keep();
      const found = await happened(client, this.#asking);
      if (found?.segments && this.#read === read && !this.#tried)
        this.strip?.show(found, read.tracks[0].t);
    }

    /** Points, and where units are known the model. @param {Read} found @param {Drawn | null} drawn */
    #show(found, drawn) {
      const read = { ...found, chosen: this.settings?.chosen ?? null };
      this.#read = read;
      this.#tried = false;
      this.settings?.offer(read);
      this.report = read.report ?? null;
      const left = drawn ? missing(read) : "";
      if (left) this.#refuse([{ line: null, reason: left, hint: "" }]);
      const motion = read.kind === "length" && !left && drawn !== null;
      this.strip?.show(null);
      this.picture?.readings(this.#name, read, motion);
      if (!motion) return;
      this.hands?.reach(read.tracks, read.names);
      this.settings?.named(read.names);
      if (this.hands) this.hands.value = drawn.parameters;
      this.picture?.draw(read, drawn);
      if (this.#kept.texts.length && !this.#kept.fitted) void this.#early();
    }

    /** The model as the sliders say. */
    async #byHand() {
      if (!this.hands) return;
      this.#kept.hand = this.hands.value;
      this.#kept.fitted = "";
      this.#keep();
      await this.#newest("model", { hand: this.hands.value }, (drawn) => {
        this.picture?.forget();
        this.picture?.draw(/** @type {Read} */ (this.#read), drawn);
      });
    }

    /** Fits the model and shows what it says. @param {boolean} compare with every effect */
    fit(compare = false) {
      this.complete = this.#fit(compare).then(() => this.picture?.turn());
      return this.complete;
    }

    /** @param {boolean} compare */
    async #fit(compare) {
      this.#tried = true;
      this.picture?.busy(tr("Starting numpy and scipy …"));
      try {
        await client.need(PACKAGES);
        await this.#asking.ask("ready");
        this.picture?.busy(tr("Fitting …"));
        performance.mark("carts:measured-asked");
        if (!(await this.#newest("fit", { compare }, (found) => this.#fitted(found)))) return;
        performance.mark("carts:measured-fit");
        this.#kept.fitted = compare ? "compared" : "fitted";
        this.#keep();
        this.dispatchEvent(new CustomEvent("carts-fitted"));
      } catch (error) {
        this.#note(/** @type {Error} */ (error).message);
      } finally {
        this.picture?.busy("");
      }
    }

    /** @param {Drawn & {report: NonNullable<CartsMeasured["report"]>}} found */
    #fitted(found) {
      this.report = found.report;
      if (this.hands) this.hands.value = found.parameters;
      this.#kept.hand = found.parameters;
      this.picture?.draw(/** @type {Read} */ (this.#read), found);
      this.picture?.told(found.report);
    }

    /** @param {import("../../../view/measured/types.js").Fault[]} faults @param {string} what was asked of Python, if anything was */
    #refuse(faults, what = "") {
      this.picture?.refuse(this.#name, faults, what);
    }

    /** @param {string} text */
    #note(text) {
      this.picture?.note(tr("Python cannot do this here: {text}", { text }));
      if (client.state === "failed") this.dataset.state = "failed";
    }
  };
}
