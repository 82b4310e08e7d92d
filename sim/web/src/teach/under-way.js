/** Values on their way into the text: Python writes them there, one at a time, and may be busy with a look. */

const PATIENCE = 8000; // ms that a press of a button waits: a Python that hangs must not keep the text

export class UnderWay {
  /** @type {Map<Promise<string>, string>} what is told of each, and its name */
  #values = new Map();

  get some() {
    return this.#values.size > 0;
  }

  /** @param {string} name @param {Promise<string>} done with why not; empty: the value is in the text */
  add(name, done) {
    const told = done.then(
      (why) => why && `${name}: ${why}`,
      (error) => `${name}: ${/** @type {Error} */ (error).message}`,
    );
    this.#values.set(told, name);
    void told.then(() => this.#values.delete(told));
  }

  /** Resolves when they stand in the text, with what is told of those that do not. @returns {Promise<string[]>} */
  async all(patience = PATIENCE) {
    if (!this.some) return [];
    let timer = 0;
    const late = new Promise((resolve) => {
      timer = setTimeout(resolve, patience);
    });
    const one = (/** @type {[Promise<string>, string]} */ [told, name]) =>
      Promise.race([told, late.then(() => `${name}: Python has not answered yet.`)]);
    const told = await Promise.all([...this.#values].map(one));
    clearTimeout(timer);
    return [...new Set(told.filter(Boolean))];
  }
}
