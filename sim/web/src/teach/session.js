/** One teacher at work on one lesson: text, drafts, Python's answers, the page and the panel. */

import { clock } from "../answers/parts.js";
import { enter, leave } from "./around.js";
import { written, zipped } from "./asked.js";
import { History } from "./history.js";
import { Looks } from "./looks.js";
import { LessonPage } from "./page.js";
import { Panel } from "./panel.js";
import { hashOf, KEPT_OUT } from "./source.js";
import { UnderWay } from "./under-way.js";

/** @typedef {import("./types.js").Look} Look */
/** @typedef {import("./types.js").Field} Field */
/** @typedef {import("./drafts.js").Draft} Draft */

const PAUSE = 250; // ms without a key until Python looks

export class Session {
  #timer = 0;
  /** Resolves when Python has seen the text as it is now, and the page shows it. */
  settled = Promise.resolve();
  /** @type {Look | null} */
  look = null;
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
    this.looks = new Looks(this);
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
    await this.#begin({ published: true, ...(await this.drafts.found()) });
  }

  /**
   * The first looks are at the text as it was built: what is typed meanwhile, or comes back as a draft, is
   * looked at after them.
   * @param {{published: boolean, draft: Draft | null, earlier: Draft[]}} given published: the page was built from this text
   */
  async #begin({ published, draft, earlier }) {
    const built = this.text;
    const back = this.#takeBack(draft);
    void this.drafts.hear((other) => this.panel.offerEarlier([other]));
    this.#working = true;
    try {
      for (let more = true; more; ) {
        const look = await this.looks.ask(() => built);
        this.panel.published(look, built);
        if (this.text === built) this.#take(look);
        if (published) this.page.adopt(look);
        else await this.page.show(look);
        more = look.more || (await this.looks.got(look));
      }
      this.panel.status(back ? `Your draft of ${clock(back.last)} is back.` : "");
      if (this.text !== built) await this.#follow();
    } catch (error) {
      const { message, detail } = /** @type {Error & {detail?: string}} */ (error);
      console.warn(message, detail ?? "");
      this.panel.offerEarlier(earlier);
      return this.panel.withoutPython(message);
    } finally {
      this.#working = false;
    }
    this.panel.offerEarlier(earlier);
    this.panel.drawn();
  }

  /** A kept draft is the text before anything can be typed: it would be lost under the first key. @param {Draft | null} draft @returns {Draft | null} null: there is none */
  #takeBack(draft) {
    if (!draft || draft.text === this.text) return null;
    if (this.told.text !== null) this.base = draft.base; // else it is the file that was opened
    this.history.change(draft.text, "");
    this.panel.kept(true);
    this.panel.own.follow();
    return draft;
  }

  show() {
    enter();
    if (!this.panel.root.isConnected) document.body.append(this.panel.root);
    this.panel.root.hidden = false;
    this.panel.focus();
  }

  close() {
    this.panel.root.hidden = true;
    leave(this);
  }

  /** The text was changed. @param {string} text @param {string} where @param {number} pause ms until Python looks */
  change(text, where, pause = PAUSE) {
    if (this.history.change(text, where)) this.#changed(pause);
  }

  undo() {
    this.panel.undo();
    this.history.undo();
    this.#changed();
  }

  redo() {
    this.panel.undo();
    this.history.redo();
    this.#changed();
  }

  /** Back to the text as it was published, as a change that can be undone. */
  reset() {
    this.panel.undo();
    this.change(this.base, "");
    void this.drafts.forget().catch(() => {});
  }

  #changed(pause = PAUSE) {
    if (!this.changed) this.panel.status(""); // a draft that was said to be back has gone
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
      await this.#follow();
    } catch (error) {
      this.panel.status(/** @type {Error} */ (error).message);
    } finally {
      this.#working = false;
    }
  }

  async #follow() {
    for (let more = true; more; ) {
      const text = this.text;
      const look = await this.looks.ask(() => this.text);
      if (text !== this.text) continue;
      this.#take(look);
      await this.page.show(look);
      more = look.more || (await this.looks.got(look)) || text !== this.text;
    }
    this.panel.drawn();
  }

  /** @param {Look} look */
  #take(look) {
    this.look = look;
    this.panel.take(look);
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

  /** The teacher's own file, where the site has no text of the lesson. @param {string} own */
  async openOwn(own) {
    this.base = own;
    this.history = new History(own);
    this.panel.status("Starting Python …");
    const hash = await hashOf(own);
    const published = hash === this.told.hash;
    return this.#begin({ published, ...(await this.drafts.ofFile(own, hash)) });
  }

  /** @returns {Promise<string>} a zip in base64 */
  zip() {
    return zipped(this.client, this.told.file, this.text, this.base);
  }
}
