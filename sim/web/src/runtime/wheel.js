// Unpacks our wheels, which are archives of files as they are: in Python's own way, through a file of a whole
// wheel and back, a page with numpy starts a ninth later.

const END = 0x06054b50; // "PK" and what follows: the end of the table of contents, an entry of it
const ENTRY = 0x02014b50;
const END_BYTES = 22;
const ENTRY_BYTES = 46;
const LOCAL_BYTES = 30;

/**
 * The files of an archive by name; null where they are compressed, as in wheels that are not packed by us.
 * @param {Uint8Array} archive @returns {Map<string, Uint8Array> | null}
 */
export function entries(archive) {
  const view = new DataView(archive.buffer, archive.byteOffset, archive.byteLength);
  const end = archive.length - END_BYTES;
  if (end < 0 || view.getUint32(end, true) !== END) return null;
  const found = new Map();
  const text = new TextDecoder();
  let at = view.getUint32(end + 16, true);
  for (let left = view.getUint16(end + 10, true); left > 0; left -= 1) {
    if (view.getUint32(at, true) !== ENTRY || view.getUint16(at + 10, true) !== 0) return null;
    const [name, extra, comment] = [28, 30, 32].map((place) => view.getUint16(at + place, true));
    const local = view.getUint32(at + 42, true);
    const skipped = view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    const from = local + LOCAL_BYTES + skipped;
    const bytes = archive.subarray(from, from + view.getUint32(at + 24, true));
    found.set(text.decode(archive.subarray(at + ENTRY_BYTES, at + ENTRY_BYTES + name)), bytes);
    at += ENTRY_BYTES + name + extra + comment;
  }
  return found;
}

/**
 * Has Pyodide's `loadPackage` unpack in this way where it can.
 * @param {any} python
 */
export function unpackByOurselves(python) {
  const api = python._api;
  const usual = api.package_loader;
  /** @param {{buffer: Uint8Array, extract_dir: string}} given @returns {string[]} its libraries */
  const unpack = (given) => {
    const { buffer, extract_dir } = given;
    const files = entries(buffer);
    if (!files) return usual.unpack_buffer.callKwargs(given);
    const folder = String(extract_dir);
    const made = new Set();
    for (const [name, bytes] of files) {
      const path = `${folder}/${name}`;
      const parent = path.slice(0, path.lastIndexOf("/"));
      if (!made.has(parent)) python.FS.mkdirTree(parent);
      made.add(parent);
      python.FS.writeFile(path, bytes, { canOwn: true });
    }
    return [...files.keys()]
      .filter((name) => name.endsWith(".so"))
      .map((name) => `${folder}/${name}`);
  };
  api.package_loader = {
    get_install_dir: (/** @type {unknown} */ where) => usual.get_install_dir(where),
    unpack_buffer: { callKwargs: unpack },
  };
}
