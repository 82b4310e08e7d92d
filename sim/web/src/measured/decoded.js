/** The text in a file of readings, as sim/measured/sheet/cells.py finds it; a test holds the two together. */

/** The bytes as text: UTF-8 or UTF-16, else what spreadsheets of a western, a Chinese or a Taiwanese Windows write. @param {ArrayBuffer} bytes */
export function decoded(bytes) {
  const start = new Uint8Array(bytes, 0, Math.min(2, bytes.byteLength));
  const mark = start[0] === 0xff && start[1] === 0xfe ? "utf-16le" : "";
  const wide = start[0] === 0xfe && start[1] === 0xff ? "utf-16be" : mark;
  return (
    strictly(wide || "utf-8", bytes) ??
    strictly(chinese(new Uint8Array(bytes)), bytes) ??
    new TextDecoder("windows-1252").decode(bytes)
  );
}

/** @param {string} encoding @param {ArrayBuffer} bytes @returns {string | undefined} nothing: it is of another encoding */
function strictly(encoding, bytes) {
  try {
    return new TextDecoder(encoding, { fatal: true }).decode(bytes);
  } catch {
    return undefined;
  }
}

/** The encoding in which most signs beyond ASCII would be usual Chinese characters, or signs that go with them: sim/scene/encoded.py says which and why. @param {Uint8Array} bytes */
function chinese(bytes) {
  let [beyond, inGbk, inBig5, high] = [0, 0, 0, 0];
  for (let at = 0; at < bytes.length; at += 1) {
    const first = bytes[at] ?? 0;
    if (first < 0x80) continue;
    const second = bytes[at + 1] ?? 0;
    const both = second > 0xa0;
    beyond += 1;
    if (((first >= 0xb0 && first <= 0xd7) || first === 0xa1 || first === 0xa3) && both) inGbk += 1;
    if (first >= 0xa1 && first <= 0xc6) {
      if (both || (second >= 0x40 && second <= 0x7e)) inBig5 += 1;
      if (both) high += 1;
    }
    at += second >= 0x30 && second <= 0x39 ? 3 : 1; // rare characters have four
  }
  if (inBig5 > inGbk && 5 * inBig5 >= 4 * beyond && 4 * high >= beyond) return "big5";
  return 2 * inGbk > beyond ? "gb18030" : "windows-1252";
}
