/** The text of a lesson and its earlier states. What is typed in one go is one step. */

const ONE_GO = 1500; // ms

export class History {
  /** @type {string[]} */
  #past = [];
  /** @type {string[]} */
  #future = [];
  #where = "";
  #when = 0;

  /** @param {string} text */
  constructor(text) {
    this.text = text;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** @param {string} text @param {string} where it was changed: further changes there are the same step */
  change(text, where) {
    if (text === this.text) return false;
    const now = performance.now();
    if (!where || where !== this.#where || now - this.#when > ONE_GO) this.#past.push(this.text);
    this.#where = where;
    this.#when = now;
    this.#future = [];
    this.text = text;
    return true;
  }

  undo() {
    this.#step(this.#past, this.#future);
  }

  redo() {
    this.#step(this.#future, this.#past);
  }

  /** @param {string[]} from @param {string[]} to */
  #step(from, to) {
    const text = from.pop();
    if (text === undefined) return;
    to.push(this.text);
    this.text = text;
    this.#where = "";
  }
}
