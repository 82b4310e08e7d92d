/** `<carts-quiz>`: a form that opens and closes by its rules and is handed in as a whole. */

import { counted, tr } from "../../../view/language.js";
import { isEmpty } from "../answers/entry.js";
import { clock } from "../answers/parts.js";
import { need, say } from "../shared/dom.js";
import { onEnter } from "../shared/enter.js";
import { encode, fits } from "./handin.js";
import { isOver, reasons, wordSum } from "./opening.js";
import { shuffleOptions } from "./shuffle.js";

const STATE = "_form"; // the id under which the form itself is kept, beside its answers

/** The element class for the page's answers. @param {import("../answers/book.js").Book} book */
export function quizElement(book) {
  return class CartsQuiz extends HTMLElement {
    #leaving = new AbortController(); // ends what the form hears of the answers

    connectedCallback() {
      this.#leaving = new AbortController();
      const { signal } = this.#leaving;
      book.addEventListener("change", () => this.#follow(), { signal });
      if (this.facts) return;
      this.facts = JSON.parse(need(this, "script.carts-quiz-facts").textContent ?? "{}");
      this.#listen();
      void book.ready.then(() => {
        if (this.facts.shuffle && book.student) shuffleOptions(this, book.student);
        this.#follow();
      });
    }

    disconnectedCallback() {
      this.#leaving.abort();
    }

    #listen() {
      const word = /** @type {HTMLInputElement} */ (need(this, ".carts-quiz-word"));
      need(this, ".carts-quiz-open").addEventListener(
        "click",
        () => void this.#tryWord(word.value),
      );
      onEnter(word, () => void this.#tryWord(word.value));
      need(this, ".carts-quiz-hand-in").addEventListener("click", () => this.#ask(true));
      need(this, ".carts-quiz-no").addEventListener("click", () => this.#ask(false));
      need(this, ".carts-quiz-yes").addEventListener("click", () => void this.#handIn());
      this.addEventListener("carts-answer", () => this.#count());
    }

    /** @returns {any} opened, handed, words: what is known of the form itself */
    get state() {
      const found = book.get(this.facts.form, STATE);
      return (
        found ?? {
          id: STATE,
          type: "form",
          value: null,
          words: [],
          first: null,
          last: null,
          tries: 0,
        }
      );
    }

    #questions() {
      return /** @type {any[]} */ ([...this.querySelectorAll("carts-question")]);
    }

    /** Shows the form, or why it is closed. */
    #follow() {
      const { handed, words } = this.state;
      const now = new Date();
      const all = {
        now,
        words: words ?? [],
        answered: this.#worksheetDone(),
        handed: handedForms(book),
      };
      const over = isOver(this.facts.close, now);
      const why = handed ? [] : over ? [tr("This form is closed.")] : reasons(this.facts.open, all);
      const review = handed && this.facts.review && reasons(this.facts.review, all).length === 0;
      const wantsWord = handed
        ? !review && this.facts.review?.word
        : !over && this.facts.open.word && !all.words.includes(this.facts.open.word);
      const open = !why.length && (!handed || review);
      need(this, ".carts-quiz-items").hidden = !open;
      need(this, ".carts-quiz-gate").hidden = open && !wantsWord;
      const again = handed && wantsWord ? [tr("To look at your answers again:")] : why;
      say(need(this, ".carts-quiz-why"), again.join(" "));
      need(this, ".carts-quiz-ask").hidden = !wantsWord;
      need(this, ".carts-quiz-foot").hidden = !open || Boolean(handed);
      for (const question of this.#questions()) question.close(Boolean(handed));
      if (open && !handed) this.#count();
      this.#done(handed, Boolean(review));
    }

    #worksheetDone() {
      const { done, of } = book.progress();
      return of > 0 && done === of;
    }

    /** @param {string} typed */
    async #tryWord(typed) {
      const sum = wordSum(this.facts.id, typed);
      const { open, review } = this.facts;
      if (![open.word, review?.word].includes(sum)) {
        say(need(this, ".carts-quiz-why"), tr("That is not the word. Ask your teacher."));
        return;
      }
      const state = this.state;
      const now = new Date().toISOString();
      await this.#keep({
        ...state,
        words: [...(state.words ?? []), sum],
        first: state.first ?? now,
        last: now,
      });
    }

    #count() {
      const left = this.#questions().filter((question) => !question.answered).length;
      say(
        need(this, ".carts-quiz-left"),
        left ? tr("{count} not answered yet", { count: left }) : tr("All answered."),
      );
    }

    /** @param {boolean} on */
    #ask(on) {
      const left = this.#questions().filter((question) => !question.answered).length;
      const missing = counted(
        "1 question is not answered.",
        "{n} questions are not answered.",
        left,
      );
      const unread = this.#questions().filter((question) => question.unread).length;
      const unclear = counted("1 number cannot be read.", "{n} numbers cannot be read.", unread);
      const words = [
        left ? missing : "",
        unread ? unclear : "",
        book.student ? "" : tr("You have typed no code word yet: My answers."),
        tr("After handing in you cannot change anything."),
      ];
      say(need(this, ".carts-quiz-sure-text"), words.filter(Boolean).join(" "));
      need(this, ".carts-quiz-sure").hidden = !on;
      need(this, ".carts-quiz-hand-in").hidden = on;
      // A key that is still held down hands nothing in.
      need(this, on ? ".carts-quiz-no" : ".carts-quiz-hand-in").focus();
    }

    async #handIn() {
      const now = new Date().toISOString();
      const state = this.state;
      const code = this.#code();
      const value = { handed: now, code, hash: this.facts.hash };
      await this.#keep({
        ...state,
        value,
        handed: now,
        code,
        first: state.first ?? now,
        last: now,
      });
      this.#ask(false);
      this.#follow();
      const done = need(this, ".carts-quiz-done");
      done.tabIndex = -1;
      done.focus();
      this.dispatchEvent(
        new CustomEvent("carts-handed-in", { bubbles: true, detail: this.facts.form }),
      );
    }

    /** The code for paper, or nothing where the form is too long or has other kinds of items. */
    #code() {
      const options = this.facts.items.map((/** @type {any} */ item) => item[1]);
      if (!fits(options)) return "";
      const chosen = this.#questions().map((question) => {
        return isEmpty(question.value) ? 0 : question.facts.options.indexOf(question.value) + 1;
      });
      return encode(options, chosen, `${this.facts.form}:${this.facts.hash}`);
    }

    /** @param {any} state */
    async #keep(state) {
      try {
        await book.put(this.facts.form, state);
      } catch {
        // The page's bar warns that this browser refuses to keep anything.
      }
    }

    /** @param {string | null | undefined} handed @param {boolean} review */
    #done(handed, review) {
      const place = need(this, ".carts-quiz-done");
      place.hidden = !handed;
      if (!handed) return;
      const { code } = this.state;
      const words = [
        tr("Handed in on {when}.", { when: clock(handed) }),
        code ? tr("Hand-in code: {code}.", { code }) : "",
        tr("Save your file under “My answers”."),
        review ? "" : tr("The questions are hidden until your teacher opens them again."),
      ];
      say(place, words.filter(Boolean).join(" "));
    }
  };
}

/** When each form of this page was handed in. @param {import("../answers/book.js").Book} book */
export function handedForms(book) {
  /** @type {Record<string, string>} */
  const found = {};
  for (const form of ["pre", "post", "delayed"]) {
    const handed = book.get(form, STATE)?.handed;
    if (handed) found[form] = handed;
  }
  return found;
}
