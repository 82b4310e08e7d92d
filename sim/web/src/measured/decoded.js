/** The text in a file of readings, as sim/measured/sheet/cells.py finds it; a test holds the two together. */

/** The bytes as text: UTF-8 or UTF-16, else what spreadsheets of a western or a Chinese Windows write. @param {ArrayBuffer} bytes */
export function decoded(bytes) {
  const start = new Uint8Array(bytes, 0, Math.min(2, bytes.byteLength));
  const mark = start[0] === 0xff && start[1] === 0xfe ? "utf-16le" : "";
  const wide = start[0] === 0xfe && start[1] === 0xff ? "utf-16be" : mark;
  return (
    strictly(wide || "utf-8", bytes) ??
    (isChinese(new Uint8Array(bytes)) ? strictly("gb18030", bytes) : undefined) ??
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

/** Whether most signs beyond ASCII would be usual Chinese characters, or signs that go with them, of two bytes each. @param {Uint8Array} bytes */
function isChinese(bytes) {
  let usual = 0;
  let beyond = 0;
  for (let at = 0; at < bytes.length; at += 1) {
    const first = bytes[at] ?? 0;
    if (first < 0x80) continue;
    const second = bytes[at + 1] ?? 0;
    beyond += 1;
    const known = (first >= 0xb0 && first <= 0xd7) || first === 0xa1 || first === 0xa3;
    if (known && second > 0xa0) usual += 1;
    at += second >= 0x30 && second <= 0x39 ? 3 : 1; // rare characters have four
  }
  return 2 * usual > beyond;
}
