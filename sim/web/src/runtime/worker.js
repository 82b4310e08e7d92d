// Python's side of the page: runs in a classic worker made of a Blob, right after Pyodide's own script.
// Files arrive from the page, unpacked; nothing is ever fetched.

import { isNotAllocated, isOutOfMemory } from "./memory.js";
import { putPicture } from "./picture.js";
import { unpackByOurselves } from "./wheel.js";

/** @type {any} */
const scope = self;
const BASE = "https://runtime.invalid/"; // Pyodide wants an address; no request ever leaves for it
const WASM = "pyodide.asm.wasm";
const STDLIB = "python.zip";
const SNAPSHOT = "memory.snapshot";
const MORE = "python-more.zip";

/** @type {Promise<Response>} */
let stdlib;
/** @type {Map<string, {come: Promise<Uint8Array<ArrayBuffer>>, take: (bytes: Uint8Array<ArrayBuffer>) => void}>} */
const files = new Map();

/** @type {any} */
let python;
/** @type {(request: string) => [string, Float64Array]} */
let answer;
/** Of the request under way, 0 while Python starts. */
let current = 0;
/** When the page last heard of `alive`, in ms of a clock that nobody sets. */
let seen = Number.NEGATIVE_INFINITY;

/** @param {object} message @param {Transferable[]} [transfer] */
const tell = (message, transfer = []) => scope.postMessage(message, transfer);

/** @param {string} reason @param {unknown} error @param {string} [name] the file to blame */
const fail = (reason, error, name = "") =>
  tell({ tell: "failed", reason, detail: String(error), file: name });

/** @param {string} stage */
const progress = (stage) => tell({ tell: "progress", stage });

/** @param {string} name */
function file(name) {
  const known = files.get(name);
  if (known) return known;
  let take = (/** @type {Uint8Array<ArrayBuffer>} */ _) => {};
  /** @type {Promise<Uint8Array<ArrayBuffer>>} */
  const come = new Promise((resolve) => {
    take = resolve;
  });
  const made = { come, take };
  files.set(name, made);
  return made;
}

/** The file, once all of it has come. @param {string} name */
const bytesOf = (name) => file(name).come;

/** Pyodide asks for its files here. @param {string | URL | Request} address */
scope.fetch = async (address) => {
  const name = String(address).split("/").pop() ?? "";
  if (name === WASM) return new Response(); // see useCompiledWasm
  if (name === STDLIB) return stdlib;
  return new Response(await bytesOf(name)); // of a Blob WebKit makes none on a disk
};

/**
 * The standard library, with what numpy and scipy need of it. One archive, not two on the path: a
 * package looks for its modules only where it was found itself. The first archive's table of contents
 * gives way to the second part, which ends in one for both.
 * @param {number} tableAt where the table of contents starts, or 0 for the first part alone
 */
async function wholeStdlib(tableAt) {
  if (!tableAt) return new Response(await bytesOf(STDLIB));
  const [first, more] = await Promise.all([bytesOf(STDLIB), bytesOf(MORE)]);
  const whole = new Uint8Array(tableAt + more.length);
  whole.set(first.subarray(0, tableAt));
  whole.set(more, tableAt);
  return new Response(whole);
}

/** @type {(module: WebAssembly.Module) => void} */
let giveWasm = () => {};
/** @type {Promise<WebAssembly.Module>} */
const wasm = new Promise((resolve) => {
  giveWasm = resolve;
});

/** The page has compiled it. Tells what goes wrong: Pyodide would write a line and wait for ever. */
function useCompiledWasm() {
  /** @type {any} */
  const api = WebAssembly;
  api.instantiateStreaming = async (/** @type {unknown} */ _, /** @type {any} */ imports) => {
    const module = await wasm;
    try {
      return { module, instance: await WebAssembly.instantiate(module, imports) };
    } catch (error) {
      fail(isOutOfMemory(error) ? "no-memory" : "too-old", error);
      throw error;
    }
  };
}

/** Pyodide's own first instance is nobody's to catch: without memory for it, its start would wait for ever. */
scope.addEventListener("unhandledrejection", (/** @type {PromiseRejectionEvent} */ { reason }) => {
  if (isNotAllocated(reason)) fail("no-memory", reason);
});

/**
 * @typedef {object} Plan
 * @property {object} lock what `loadPackage` may load
 * @property {boolean} snapshot
 * @property {number} tableAt see wholeStdlib
 * @property {string[]} load packages to load
 * @property {string[]} modules to import before the first request
 * @property {string} entry the module that answers
 */

/** @param {Plan} plan */
async function boot({ lock, snapshot, tableAt, load, modules, entry }) {
  try {
    useCompiledWasm();
    stdlib = wholeStdlib(tableAt);
    const { loadPyodide, createPyodideModule } = scope.__pyodide;
    python = await loadPyodide({
      indexURL: BASE,
      packageBaseUrl: BASE,
      stdLibURL: BASE + STDLIB,
      lockFileContents: lock,
      createPyodideModule,
      _loadSnapshot: snapshot ? bytesOf(SNAPSHOT) : undefined,
      _putPicture: putPicture,
      args: [],
      env: { HOME: "/home/pyodide" },
    });
    python._api.config._loadSnapshot = undefined; // 11 MB that nothing needs any more
    progress("python");
    if (snapshot) reseed();
    tellOfImports();
  } catch (error) {
    if (isNotAllocated(error)) return fail("no-memory", error);
    return fail(snapshot ? "snapshot-refused" : "python-failed", error);
  }
  try {
    if (load.length) await loadPackages(load);
    for (const name of modules) {
      importIfPossible(name);
      progress(name);
    }
    const module = python.pyimport(entry);
    module.listen?.(alive);
    answer = module.answer;
  } catch (error) {
    return fail("python-failed", error);
  }
  files.clear();
  return tell({ tell: "ready", start: snapshot ? "snapshot" : "plain" });
}

/** A snapshot would give every reader the same "random" numbers. */
function reseed() {
  python.runPython(`
import sys
if "random" in sys.modules:
    sys.modules["random"].seed()
`);
}

/** A sign of life while an answer or an import takes long, told once a second at most. */
function alive() {
  if (performance.now() - seen < 1000) return;
  seen = performance.now();
  if (current) tell({ tell: "alive", number: current });
  else progress("packages");
}

/** A slow laptop may import scipy's modules for longer than a page waits: each is a sign of life. */
function tellOfImports() {
  const locals = python.toPy({ alive });
  python.runPython(
    `
import sys
class Alive:
    @staticmethod
    def find_spec(name, path=None, target=None, alive=alive):
        alive()
sys.meta_path.insert(0, Alive)
`,
    { globals: locals },
  );
}

/** @param {string[]} names */
async function loadPackages(names) {
  unpackByOurselves(python);
  const alive = setInterval(() => progress("packages"), 1000);
  try {
    await python.loadPackage(names, { messageCallback: () => {} });
  } finally {
    clearInterval(alive);
  }
  progress("packages");
}

/** A module of ours may need scipy on a page that has only numpy. @param {string} name */
function importIfPossible(name) {
  try {
    python.pyimport(name).destroy();
  } catch (error) {
    if (/** @type {any} */ (error)?.type !== "ModuleNotFoundError") throw error;
  }
}

/** @param {{number: number, text: string}} request */
function respond({ number, text }) {
  tell({ tell: "begun", number });
  current = number;
  try {
    const [header, numbers] = answer(text);
    tell({ tell: "answer", number, header, numbers }, [numbers.buffer]);
  } catch (error) {
    tell({ tell: "broken", number, detail: String(error), dead: isDead() });
  }
}

/** After a fatal error Pyodide refuses everything. */
function isDead() {
  try {
    return python.runPython("1") !== 1;
  } catch {
    return true;
  }
}

scope.onmessage = (/** @type {MessageEvent} */ { data }) => {
  if (data.do === "boot") boot(data);
  else if (data.do === "file") file(data.name).take(new Uint8Array(data.bytes));
  else if (data.do === "wasm") giveWasm(data.module);
  else if (data.do === "request") respond(data);
};
tell({ tell: "hello" });
