// Puts the picture of Python's memory where it belongs. It holds only what a fresh instance does not have:
// `sim/pages/runtime/inside/sparse.mjs` writes it and says how.

/**
 * @param {Int8Array} memory of a fresh instance
 * @param {Uint8Array} picture aligned to 4 bytes
 * Throws where that instance is not the one which the picture was made for.
 */
export function putPicture(memory, picture) {
  const words = new Uint32Array(picture.buffer, picture.byteOffset, picture.byteLength >> 2);
  const [size, filled, sum, count] = words;
  if (memory.length !== size) throw new Error(`${memory.length} bytes of memory, not ${size}`);
  const stretches = words.subarray(4, 4 + 2 * count);
  if (sumBetween(memory, stretches, filled) !== sum) throw new Error("another machine code");
  let from = 4 * (4 + 2 * count);
  let last = filled;
  for (let i = 0; i < stretches.length; i += 2) {
    const [start, end] = stretches.subarray(i, i + 2);
    if (start > last) memory.fill(0, last, start); // Pyodide's first steps have written there
    memory.set(picture.subarray(from, from + end - start), start);
    from += end - start;
    last = Math.max(last, end);
  }
}

/**
 * The sum of all words below `filled` that are in none of the stretches.
 * @param {Int8Array} memory @param {Uint32Array} stretches @param {number} filled
 */
function sumBetween(memory, stretches, filled) {
  const words = new Uint32Array(memory.buffer, memory.byteOffset, memory.byteLength >> 2);
  let sum = 0;
  let at = 0;
  for (let i = 0; i <= stretches.length && at < filled; i += 2) {
    const start = Math.min(stretches[i] ?? filled, filled);
    for (let word = at >> 2; word < start >> 2; word += 1) sum = (sum + words[word]) >>> 0;
    at = stretches[i + 1] ?? filled;
  }
  return sum;
}
