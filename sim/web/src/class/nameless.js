/**
 * Files without a code word are known by their names: two that are called alike are told apart. What was
 * begun at the same moment is the same file again. The same as sim/classroom/files/nameless.py.
 */

export class Names {
  /** @type {Map<string, string>} by what a file was called and when it was begun */
  #given = new Map();
  /** @type {Set<string>} */
  #taken = new Set();
  /** @type {Map<string, number>} */
  #often = new Map();

  /** The name, with a number before its ending where another file has it. @param {string} name @param {string} begun */
  of(name, begun) {
    const file = JSON.stringify([name, begun]);
    const before = this.#given.get(file);
    if (before !== undefined) return before;
    let number = (this.#often.get(name) ?? 0) + 1;
    while (this.#taken.has(numbered(name, number))) number += 1;
    this.#often.set(name, number);
    const found = numbered(name, number);
    this.#taken.add(found);
    this.#given.set(file, found);
    return found;
  }
}

/** `a.json` as `a (2).json`; the first has no number. @param {string} name @param {number} number */
function numbered(name, number) {
  const [, stem = "", ending = ""] = /^(.+?)(\.[^.]*)?$/s.exec(name) ?? [];
  return number < 2 ? name : `${stem} (${number})${ending}`;
}
