/** One teacher at work on one lesson: text, drafts, Python's answers, the page and the panel. */

import { clock } from "../answers/parts.js";
import { restored, written, zipped } from "./asked.js";
import { History } from "./history.js";
import { LessonPage } from "./page.js";
import { Panel } from "./panel.js";
import { hashOf, KEPT_OUT } from "./source.js";
import { UnderWay } from "./under-way.js";

/** @typedef {import("./types.js").Look} Look */
/** @typedef {import("./types.js").Field} Field */

const PAUSE = 250; // ms without a key until Python looks
const BODY = "carts-teaching";

export class Session {
  #looking = {};
  #timer = 0;
  /** Resolves when Python has seen the text as it is now, and the page shows it. */
  settled = Promise.resolve();
  /** @type {Look | null} */
  look = null;
  #asked = false;
  #working = false;
  #typed = new UnderWay();

  /**
   * @param {{told: import("./source.js").Told, client: import("../runtime/client.js").Client, assets: string,
   *   drafts: import("./drafts.js").Drafts, link: HTMLElement}} given
   */
  constructor({ told, client, assets, drafts, link }) {
    this.told = told;
    this.client = client;
    this.drafts = drafts;
    this.link = link;
    this.base = told.text ?? "";
    this.history = new History(this.base);
    const article = /** @type {HTMLElement} */ (link.closest("article") ?? document.body);
    this.page = new LessonPage(article, assets, (k) => this.panel.openBlock(k));
    this.panel = new Panel(this);
  }

  get text() {
    return this.history.text;
  }

  /** Whether notes or marking guides are missing from the text as it is now. */
  get withheld() {
    return this.text.includes(KEPT_OUT);
  }

  get changed() {
    return this.text !== this.base;
  }

  get name() {
    return this.told.file.split("/").at(-1) ?? "lesson.md";
  }

  /** Opens the panel; shows the published text first, so that the page's own elements are known. */
  async open() {
    this.show();
    scrollTo(0, 0); // the link is at the foot, the panel begins with the first part
    if (this.told.text === null) return this.panel.askForFile();
    this.panel.status("Starting Python …");
    await this.#begin();
  }

  /** @param {boolean} published whether the text is the one that the page was built from */
  async #begin(published = true) {
    const built = this.text;
    const draft = this.#takeBack(await this.drafts.current());
    try {
      for (let more = true; more; ) {
        const look = await this.#ask(draft && built);
        if (draft) this.panel.published(look, built);
        else this.#take(look);
        if (published) this.page.adopt(look);
        else await this.page.show(look);
        more = look.more || (await this.#got(look));
      }
      if (draft) this.#take(await this.#ask());
    } catch (error) {
      const { message, detail } = /** @type {Error & {detail?: string}} */ (error);
      console.warn(message, detail ?? "");
      return this.panel.withoutPython(message);
    }
    this.panel.status(draft ? `Your draft of ${clock(draft.last)} is back.` : "");
    if (draft) await this.lookNow();
    this.panel.offerEarlier(await this.drafts.earlier());
    this.panel.root.dataset.state = "ready";
  }

  /** A kept draft is the text before anything can be typed: it would be lost under the first key. @param {import("./drafts.js").Draft | null} draft @returns {import("./drafts.js").Draft | null} null: there is none */
  #takeBack(draft) {
    if (!draft || draft.text === this.text) return null;
    this.base = draft.base;
    this.history.change(draft.text, "");
    this.panel.kept(true);
    return draft;
  }

  show() {
    document.body.classList.add(BODY);
    if (!this.panel.root.isConnected) document.body.append(this.panel.root);
    this.panel.root.hidden = false;
    this.panel.focus();
  }

  close() {
    this.panel.root.hidden = true;
    document.body.classList.remove(BODY);
    const address = new URL(location.href);
    address.searchParams.delete("teacher");
    if (address.hash === "#teacher") address.hash = "";
    history.replaceState(null, "", address.href.replace(/#$/, ""));
    this.link.focus();
  }

  /** The text was changed. @param {string} text @param {string} where @param {number} pause ms until Python looks */
  change(text, where, pause = PAUSE) {
    if (this.history.change(text, where)) this.#changed(pause);
  }

  undo() {
    this.history.undo();
    this.#changed();
  }

  redo() {
    this.history.redo();
    this.#changed();
  }

  /** Back to the text as it was published, as a change that can be undone. */
  reset() {
    this.change(this.base, "");
    void this.drafts.forget().catch(() => {});
  }

  #changed(pause = PAUSE) {
    this.panel.follow();
    void this.#keep();
    clearTimeout(this.#timer);
    this.settled = new Promise((resolve) => {
      this.#timer = setTimeout(() => resolve(this.lookNow()), pause);
    });
  }

  async #keep() {
    try {
      const kept = this.changed
        ? await this.drafts.keep(this.text, this.base)
        : await this.drafts.forget().then(() => true);
      this.panel.kept(kept);
    } catch {
      this.panel.kept(false);
    }
  }

  /** Python looks at the text as it is now; then page and panel show it. */
  async lookNow() {
    if (this.#working) return;
    this.#working = true;
    try {
      for (let more = true; more; ) {
        const text = this.text;
        const look = await this.#ask();
        if (text !== this.text) continue;
        this.#take(look);
        await this.page.show(look);
        more = look.more || (await this.#got(look)) || text !== this.text;
      }
      this.panel.drawn();
    } catch (error) {
      this.panel.status(/** @type {Error} */ (error).message);
    } finally {
      this.#working = false;
    }
  }

  /** @param {Look} look */
  #take(look) {
    this.look = look;
    this.panel.take(look);
  }

  /** @param {string | null} text null: as it is when it is sent @returns {Promise<Look>} */
  async #ask(text = null) {
    const { lesson, files } = this.told;
    const { header } = await this.client.ask(this.#looking, () => ({
      ...{ kind: "teach", do: "look", lesson, files },
      ...{ text: text ?? this.text, have: this.page.have },
    }));
    return /** @type {any} */ (header);
  }

  /** Loads what a scene needs beside bare Python, once. @param {Look} look */
  async #got(look) {
    if (!look.needs.length || this.#asked) return false;
    this.#asked = true;
    try {
      await this.client.need(look.needs);
      return true;
    } catch {
      this.panel.status(
        "A scene here needs numpy and scipy, which this site has not packed. The build will pack them.",
      );
      return false;
    }
  }

  /** One value of a block. @param {number} block @param {Field} field @param {string} value @param {object} owner @returns {Promise<string>} why not; empty: done */
  set(block, field, value, owner) {
    const done = this.#set(block, field, value, owner);
    this.#typed.add([field.group, field.label].filter(Boolean).join(", "), done);
    return done;
  }

  /** @param {number} block @param {Field} field @param {string} value @param {object} owner */
  async #set(block, field, value, owner) {
    const { path } = field;
    const answer = await written(this.client, owner, () => this.text, { block, path, value });
    if (answer.refused) return answer.refused;
    this.change(answer.text, `${block} ${path.join(".")}`, 0); // the field has waited
    return "";
  }

  /** Resolves when what stands in the fields stands in the text, with what is told of values that do not. @returns {Promise<string[]>} */
  typed() {
    this.panel.flush();
    if (this.#typed.some) this.panel.status("Taking over what you typed …");
    return this.#typed.all();
  }

  /** The teacher's own file: the whole lesson, with what was kept out of the site. @param {string} own */
  async takeOwn(own) {
    if (this.told.text === null) {
      this.base = own;
      this.history = new History(own);
      this.panel.status("Starting Python …");
      return this.#begin((await hashOf(own)) === this.told.hash);
    }
    const { text, missing } = await restored(this.client, () => this.text, own);
    const same = (await hashOf(own)) === this.told.hash;
    if (same) this.base = own;
    this.change(text, "");
    this.panel.ownTaken(missing, same);
  }

  /** @returns {Promise<string>} a zip in base64 */
  zip() {
    return zipped(this.client, this.told.file, this.text, this.base);
  }
}
