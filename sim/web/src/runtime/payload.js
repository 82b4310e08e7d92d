// Loads the runtime's files: classic scripts that hold gzip as base64, as no other kind of file can be
// read by a page on file://. Every part is checked before it is used and let go of afterwards.

import { RuntimeFailure } from "./failure.js";
import { isLeaving, staying } from "./leaving.js";
import { isFetching, isOnWeb, persistently } from "./line.js";
import { HELD, PATIENCE, watch } from "./watch.js";

/** @typedef {{src: string, sha256: string, size: number}} Part */
/** @typedef {{size: number, parts: Part[]}} Payload */
/**
 * @typedef {object} Index the table of contents, as written by sim/pages/runtime
 * @property {Record<string, Payload>} files
 * @property {Record<string, string>} wheels file name of each package
 * @property {object} lock
 * @property {string} entry
 * @property {string} package
 * @property {string} rest the package of `later`
 * @property {string[]} later modules of ours that need numpy or scipy: they are not in the snapshot
 * @property {number} tableAt where python-more.zip goes on from python.zip
 * @property {string} missing
 */

/** @type {any} */
const page = self;

/** @type {Map<string, Promise<Index>>} */
const indexes = new Map();

/**
 * Runs a classic script. What it sets is found on `self`. One that a network dropped is asked for
 * again, each time by a new element: one that failed never loads.
 * @param {string} src
 * @param {string} name
 */
const runScript = (src, name) => persistently(() => runOnce(src, name));

/**
 * One that is cancelled because the page is being left is asked for again if the page stays.
 * @param {string} src
 * @param {string} name
 * @returns {Promise<void>}
 */
function runOnce(src, name) {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = src;
    script.async = true;
    const missing = () => reject(new RuntimeFailure("payload-missing", src, name));
    const settle = (/** @type {() => void} */ then) => () => {
      held?.stop();
      script.remove();
      then();
    };
    const held = isOnWeb() ? watch(HELD, settle(missing)) : null;
    script.onload = settle(resolve);
    script.onerror = settle(() => {
      if (isLeaving()) staying().then(() => runOnce(src, name).then(resolve, reject));
      else missing();
    });
    document.head.append(script);
  });
}

/** The address of the table of contents; the stamp of the folder is its own. @param {string} base */
function indexOf(base) {
  return new URL(`index.js${new URL(base).search}`, base).href;
}

/** A disk that does not answer is given up; a network may take what it takes. @param {Promise<void>} promise */
function patiently(promise) {
  if (isOnWeb()) return promise;
  return new Promise((resolve, reject) => {
    const waiting = watch(PATIENCE, () => reject(new RuntimeFailure("stalled", "index.js")));
    promise.then(resolve, reject).finally(waiting.stop);
  });
}

/**
 * The table of contents, read once per page.
 * @param {string} base address of the runtime's folder, with a slash at its end
 * @returns {Promise<Index>}
 */
export function loadIndex(base) {
  const known = indexes.get(base);
  if (known) return known;
  const inside = Boolean(page.__cartsInside);
  const read = inside ? Promise.resolve() : patiently(runScript(indexOf(base), "index.js"));
  const loading = read.then(() => {
    const index = page.__cartsRuntime;
    if (!inside) delete page.__cartsRuntime;
    if (!index) throw new RuntimeFailure("payload-damaged", "index.js", "index.js");
    if (!index.files) throw new RuntimeFailure("not-packed", index.missing);
    return index;
  });
  loading.catch(() => indexes.delete(base));
  indexes.set(base, loading);
  return loading;
}

/**
 * One part of a file, checked. What a network, or a cache on the way, has cut short or changed is asked
 * for once more by another address.
 * @param {string} base
 * @param {string} name
 * @param {number} number
 * @param {Part} part
 * @returns {Promise<Uint8Array<ArrayBuffer>>} gzip bytes
 */
export async function loadPart(base, name, number, part) {
  const address = new URL(part.src, base);
  try {
    return await checkedPart(address.href, name, number, part);
  } catch (error) {
    const damaged = error instanceof RuntimeFailure && error.reason === "payload-damaged";
    if (!damaged || !isFetching()) throw error;
    address.searchParams.set("again", "1");
    return checkedPart(address.href, name, number, part);
  }
}

/** @param {string} address @param {string} name @param {number} number @param {Part} part */
async function checkedPart(address, name, number, part) {
  const inside = Boolean(page.__cartsInside); // a page of one file has all parts in itself
  if (!inside) await runScript(address, name);
  const key = `${name}.${number}`;
  const text = page.__cartsParts?.[key]; // a script cut short does not run: there is no text then
  if (text === undefined) throw new RuntimeFailure("payload-damaged", part.src, name);
  if (!inside) delete page.__cartsParts[key];
  const bytes = decode(text, part.src, name);
  if (bytes.length !== part.size || !(await matches(bytes, part.sha256))) {
    throw new RuntimeFailure("payload-damaged", part.src, name);
  }
  return bytes;
}

/** @param {string} text @param {string} src @param {string} name */
function decode(text, src, name) {
  try {
    /** @type {any} */
    const fast = Uint8Array;
    return fast.fromBase64
      ? fast.fromBase64(text)
      : Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    throw new RuntimeFailure("payload-damaged", src, name);
  }
}

/**
 * A page on plain http has no crypto.subtle; there gzip's own checksum must do.
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {string} sha256
 */
async function matches(bytes, sha256) {
  if (!globalThis.crypto?.subtle) return true;
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("") === sha256;
}

/**
 * @param {Uint8Array<ArrayBuffer>[]} parts
 * @returns {Promise<ArrayBuffer>}
 */
export async function gunzip(parts) {
  const zip = new DecompressionStream("gzip");
  const writer = zip.writable.getWriter();
  const written = Promise.all([...parts.map((part) => writer.write(part)), writer.close()]);
  const [bytes] = await Promise.all([new Response(zip.readable).arrayBuffer(), written]);
  return bytes;
}
