// What a picture of the memory need not say: zeros, and what the machine code itself puts there.

const BLOCK = 256; // bytes; with smaller ones the picture is hardly smaller, and has more stretches
const WORDS = BLOCK / 4;

/**
 * The picture with only those stretches of memory that a fresh instance does not have. What is written:
 * Pyodide's own head as it is, then in 32-bit words: bytes of memory, where the part ends that the machine code
 * fills, the sum of all words there that are not in the picture, number of stretches, start and end of each;
 * then what is in them. `sim/web/src/runtime/picture.js` reads it.
 *
 * @param {Uint8Array} snapshot as Pyodide makes it
 * @param {Uint8Array} fresh the memory of an instance in which nothing has run
 */
export function sparse(snapshot, fresh) {
  const head = new Uint32Array(snapshot.buffer, snapshot.byteOffset, 2)[1];
  const memory = snapshot.slice(head);
  const now = new Uint32Array(memory.buffer);
  const before = new Uint32Array(fresh.buffer, fresh.byteOffset, fresh.length / 4);
  const filled = (Math.floor(before.findLastIndex((word) => word !== 0) / WORDS) + 1) * BLOCK;
  const stretches = [];
  let sum = 0;
  for (let at = 0; at < memory.length; at += BLOCK) {
    const [from, to] = [at / 4, at / 4 + WORDS];
    const block = now.subarray(from, to);
    if (block.some((word, i) => word !== (at < filled ? before[from + i] : 0))) {
      const last = stretches.at(-1);
      if (last?.[1] === at) last[1] = at + BLOCK;
      else stretches.push([at, at + BLOCK]);
    } else if (at < filled) {
      for (const word of block) sum = (sum + word) >>> 0;
    }
  }
  const words = new Uint32Array([memory.length, filled, sum, stretches.length, ...stretches.flat()]);
  const parts = [snapshot.subarray(0, head), new Uint8Array(words.buffer)];
  return Buffer.concat([...parts, ...stretches.map(([from, to]) => memory.subarray(from, to))]);
}

/** Keeps the memory of the next instance that has one of its own, as it is before anything runs in it. */
export function catchFresh() {
  const { instantiate } = WebAssembly;
  const caught = { memory: new Uint8Array() };
  WebAssembly.instantiate = async (...given) => {
    const made = await instantiate.apply(WebAssembly, given);
    const { memory } = (made.instance ?? made).exports;
    if (memory && !caught.memory.length) caught.memory = new Uint8Array(memory.buffer).slice();
    return made;
  };
  return caught;
}
