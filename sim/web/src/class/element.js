/** `<carts-class>`: the files of a class, read and reported by Python in the page's worker. */

import { counted, tr } from "../../../view/language.js";
import { html, say } from "../shared/dom.js";
import { Classroom } from "./classroom.js";
import { drops } from "./drops.js";
import { holdingFocus } from "./held-focus.js";
import { asTable, isTable, readAll } from "./intake.js";
import { fileList, typedCodes } from "./list.js";
import { papers, spokenHere } from "./papers.js";
import { reader } from "./reader.js";
import { actions } from "./saves.js";
import { stay } from "./staying.js";
import { tableList } from "./tables.js";

/** @typedef {import("./classroom.js").Found} Found */

const PACKAGES = ["numpy", "scipy"]; // for intervals and tests; the first table does without
const SOON = 700; // ms until a first table is made of what has been read so far

/** @param {number} count @param {number} all with those of before @param {string} seconds */
const readIn = (count, all, seconds) =>
  count === all
    ? counted("1 file read in {seconds} s.", "{n} files read in {seconds} s.", count, { seconds })
    : counted(
        "1 file read in {seconds} s, {all} in all.",
        "{n} files read in {seconds} s, {all} in all.",
        count,
        { seconds, all },
      );

/** The element class for a client. @param {import("../runtime/client.js").Client} client */
export function classElement(client) {
  const here = spokenHere();
  return class CartsClass extends HTMLElement {
    classroom = new Classroom();
    /** Whether Python has scipy by now. */
    inference = false;
    /** Resolves when everything that was dropped is read and shown. @type {Promise<void>} */
    complete = Promise.resolve();
    /** @type {Promise<void> | null} */
    #statistics = null;
    #read = 0;
    #drawn = 0;
    #lifetime = 0;
    #status = html("p", "carts-class-status");
    #bar = /** @type {HTMLProgressElement} */ (html("progress", "carts-class-progress"));
    #report = html("div", "carts-class-report");
    /** @type {(() => void)[]} */
    #parts = [];
    /** @type {ReturnType<typeof reader> | null} */
    #reader = null;

    #leaving = new AbortController(); // ends what the element hears of the window

    connectedCallback() {
      this.#leaving = new AbortController();
      stay(this.classroom, this.#leaving.signal);
      if (this.#parts.length) return;
      this.classList.add("carts", "carts-class");
      const change = () => void this.show();
      const field = drops(this.classroom, (files, group) => this.take(files, group), change);
      const list = fileList(this.classroom, change);
      const codes = typedCodes(this.classroom, change);
      const tables = tableList(this.classroom, change);
      this.#reader = reader(this.classroom, change);
      const doing = actions({
        element: this,
        report: this.#report,
        ask: (what) =>
          this.#ask({
            ...this.classroom.toldOfAll(),
            ...{ do: "save", what, inference: this.inference, ...here },
          }),
        say: (text) => say(this.#status, text),
        clear: () => this.clear(),
      });
      const paper = papers({
        noAnswers: () => !this.classroom.files.length && !this.classroom.typed,
        keys: () => this.classroom.keys,
        ask: (wanted) =>
          this.#ask({ ...this.classroom.told(), inference: this.inference, ...wanted }),
        say: (text) => say(this.#status, text),
      });
      this.#parts = [field.draw, list.draw, tables.draw, codes.draw, paper.draw, doing.draw];
      this.#status.setAttribute("role", "status");
      this.#bar.hidden = true;
      this.#bar.setAttribute("aria-label", tr("Files read"));
      const controls = html("div", "carts-class-controls");
      controls.append(
        field.root,
        this.#status,
        this.#bar,
        list.root,
        tables.root,
        codes.root,
        this.#reader.root,
        paper.root,
        doing.root,
      );
      this.replaceChildren(controls, paper.shown, this.#report);
      this.#redraw();
      this.dataset.state = "ready";
    }

    disconnectedCallback() {
      this.#leaving.abort();
    }

    /** Reads files into a group. @param {File[]} files @param {number} group */
    take(files, group) {
      const lifetime = this.#lifetime;
      this.complete = this.complete.then(() => this.#take(files, group, lifetime));
      return this.complete;
    }

    /** @param {File[]} files @param {number} group @param {number} lifetime in which they were dropped: what was deleted since does not come back */
    async #take(files, group, lifetime) {
      for (const file of files.filter(isTable)) {
        const table = await asTable(file, group);
        if (lifetime !== this.#lifetime) return;
        if (typeof table === "string") this.classroom.refused.push([file.name, table]);
        else this.classroom.tables.push(table);
      }
      if (lifetime !== this.#lifetime) return;
      const answers = files.filter((file) => !isTable(file));
      const begun = performance.now();
      say(this.#status, client.state === "ready" ? tr("Reading …") : tr("Starting Python …"));
      Object.assign(this.#bar, { hidden: false, max: answers.length, value: 0 });
      let soon = 0;
      try {
        await readAll(
          answers,
          (message) => this.#ask(message),
          async (found, done) => {
            if (lifetime !== this.#lifetime) throw new Error("cleared");
            soon ||= performance.now() + SOON;
            this.classroom.take(found, group);
            this.#bar.value = done;
            say(this.#status, tr("{done} of {all} files read", { done, all: answers.length }));
            if (!this.#drawn && this.classroom.files.length && performance.now() > soon)
              await this.show();
          },
        );
        await this.show();
        if (lifetime !== this.#lifetime) return;
        performance.mark("carts:class-done");
        const took = ((performance.now() - begun) / 1000).toFixed(1);
        this.#read += files.length;
        say(this.#status, readIn(files.length, this.#read, took));
        void this.#addStatistics();
      } catch (error) {
        if (lifetime !== this.#lifetime) return;
        say(this.#status, /** @type {Error} */ (error).message);
      } finally {
        this.#bar.hidden = true;
      }
    }

    /** Loads scipy once; then the report has intervals and tests. */
    #addStatistics() {
      this.#statistics ??= client.need(PACKAGES).then(
        async () => {
          await this.#ask({ kind: "class", do: "ready" });
          this.inference = true;
          await this.show();
        },
        (error) => {
          this.#statistics = null;
          const short = tr("Means are shown; intervals and tests are not there: {message}", error);
          say(this.#status, short);
        },
      );
      return this.#statistics.then(() => {
        if (this.inference && !this.classroom.empty) this.dataset.state = "complete";
      });
    }

    /** Asks for the report on what is here and shows it. */
    async show() {
      this.#redraw();
      const { classroom } = this;
      if (classroom.empty) return this.#report.replaceChildren();
      const lifetime = this.#lifetime;
      try {
        const header = await this.#reported();
        if (lifetime !== this.#lifetime) return;
        const made = document.createElement("template");
        made.innerHTML = header.html; // escaped where it was made
        const open = [...this.#report.querySelectorAll("details[open] > summary")].map(
          (summary) => summary.textContent,
        );
        this.#report.replaceChildren(made.content);
        for (const details of this.#report.querySelectorAll("details")) {
          details.open = open.includes(details.querySelector("summary")?.textContent ?? "");
        }
        this.#drawn += 1;
        if (this.#drawn === 1) performance.mark("carts:class-means");
        this.#reader?.draw(header.words);
        this.#redraw();
      } catch (error) {
        say(this.#status, /** @type {Error} */ (error).message);
      }
    }

    /** The report on the answers, and below it that on tables. @returns {Promise<{html: string, words: any[]}>} */
    async #reported() {
      const { classroom } = this;
      const asked = { do: "report", inference: this.inference, ...here };
      const none = { html: "", words: [] };
      const answers = classroom.noAnswers
        ? none
        : (await client.ask(this, () => ({ ...this.classroom.told(), ...asked }))).header;
      const tables = classroom.tables.length
        ? await this.#ask({ ...classroom.toldOfTables(), ...asked })
        : none;
      const { html: first, words } = /** @type {any} */ (answers);
      return { html: first + tables.html, words };
    }

    /** Forgets everything that was dropped and typed. */
    clear() {
      this.#lifetime += 1;
      this.#read = 0;
      const kept = this.classroom;
      Object.assign(kept, new Classroom());
      this.#drawn = 0;
      this.#report.replaceChildren();
      this.#reader?.draw([]);
      this.#redraw();
      this.dataset.state = "ready";
      say(
        this.#status,
        tr("Everything is deleted from this page. The files themselves are where they were."),
      );
    }

    #redraw() {
      holdingFocus(this, () => {
        for (const draw of this.#parts) draw();
      });
    }

    /** @param {Record<string, unknown>} message @returns {Promise<Record<string, any>>} */
    async #ask(message) {
      const { header } = await client.ask({}, () => message);
      return /** @type {any} */ (header);
    }
  };
}
