/**
 * The few functions of newer browsers that our scripts call. With them the run that a page brought along
 * plays wherever the script itself can be read.
 */

/** @param {any} owner @param {string} name @param {Function} value */
function add(owner, name, value) {
  if (!(name in owner)) {
    Object.defineProperty(owner, name, { value, configurable: true, writable: true });
  }
}

/** @this {any} @param {(value: any, index: number, all: any) => unknown} fits */
function findLastIndex(fits) {
  for (let k = this.length - 1; k >= 0; k -= 1) if (fits(this[k], k, this)) return k;
  return -1;
}

/** @this {any} @param {(value: any, index: number, all: any) => unknown} fits */
function findLast(fits) {
  return this[findLastIndex.call(this, fits)];
}

/** @this {any} @param {number} index */
function at(index) {
  return this[index < 0 ? this.length + index : index];
}

for (const kind of [Array, Float64Array, Uint8Array]) {
  add(kind.prototype, "findLast", findLast);
  add(kind.prototype, "findLastIndex", findLastIndex);
  add(kind.prototype, "at", at);
}
add(String.prototype, "at", at);
add(Object, "hasOwn", (/** @type {object} */ owner, /** @type {string} */ name) =>
  // biome-ignore lint/suspicious/noPrototypeBuiltins: this is what stands in for Object.hasOwn
  Object.prototype.hasOwnProperty.call(owner, name),
);
add(globalThis, "structuredClone", (/** @type {unknown} */ value) =>
  JSON.parse(JSON.stringify(value)),
);
