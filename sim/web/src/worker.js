// Python's side of the page: runs in a classic worker made of a Blob, right after Pyodide's own script.
// Files arrive in parts from the page and are gunzipped while they come; nothing is ever fetched.

/** @type {any} */
const scope = self;
const BASE = "https://runtime.invalid/"; // Pyodide wants an address; no request ever leaves for it
const WASM = "pyodide.asm.wasm";
const STDLIB = "python.zip";
const SNAPSHOT = "memory.snapshot";
const MORE = "python-more.zip";

// One archive, not two on the path: a package looks for its modules only where it was found itself.
const APPEND_MORE = `
import importlib, os, zipfile
with zipfile.ZipFile("/lib/${MORE}") as more, zipfile.ZipFile("/lib/python314.zip", "a") as whole:
    for entry in more.infolist():
        whole.writestr(entry, more.read(entry))
os.remove("/lib/${MORE}")
importlib.invalidate_caches()
`;

/** @type {Map<string, {writer: WritableStreamDefaultWriter, response: Response}>} */
const files = new Map();

/** @type {any} */
let python;
/** @type {(request: string) => [string, Float64Array]} */
let answer;

/** @param {object} message @param {Transferable[]} [transfer] */
const tell = (message, transfer = []) => scope.postMessage(message, transfer);

/** @param {string} reason @param {unknown} error @param {string} [name] the file to blame */
const fail = (reason, error, name = "") =>
  tell({ tell: "failed", reason, detail: String(error), file: name });

/** @param {string} stage */
const progress = (stage) => tell({ tell: "progress", stage });

/** The file as it will be once all of it has come. @param {string} name */
function file(name) {
  let found = files.get(name);
  if (!found) {
    const zip = new DecompressionStream("gzip");
    const type = name.endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
    const response = new Response(zip.readable, { headers: { "Content-Type": type } });
    found = { writer: zip.writable.getWriter(), response };
    files.set(name, found);
  }
  return found;
}

/** @param {{name: string, bytes: Uint8Array, last: boolean}} part */
function take({ name, bytes, last }) {
  const { writer } = file(name);
  const damaged = (/** @type {unknown} */ error) => fail("payload-damaged", error, name);
  writer.write(bytes).catch(damaged);
  if (last) writer.close().catch(damaged);
}

/** @param {string} name */
const bytesOf = async (name) => new Uint8Array(await file(name).response.arrayBuffer());

/** Pyodide asks for its files here. @param {string | URL | Request} address */
scope.fetch = async (address) => {
  const name = String(address).split("/").pop() ?? "";
  if (name === WASM) return new Response(); // compiled already, see compileWasm
  return file(name).response;
};

/**
 * Starts compiling while the bytes still come, and tells what went wrong: Pyodide itself would only
 * write to the console and wait for ever.
 */
function compileWasm() {
  const compiled = WebAssembly.compileStreaming(file(WASM).response);
  compiled.catch((error) => fail("too-old", error));
  /** @type {any} */
  const wasm = WebAssembly;
  wasm.instantiateStreaming = async (/** @type {unknown} */ _, /** @type {any} */ imports) => {
    const module = await compiled;
    return { module, instance: await WebAssembly.instantiate(module, imports) };
  };
}

/** Refused by a Content-Security-Policy or absent: say so before anything large is loaded. */
function wasmRefusal() {
  if (typeof WebAssembly !== "object") return "no-wasm";
  try {
    new WebAssembly.Module(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0])); // the empty module
    return "";
  } catch {
    return "wasm-refused";
  }
}

/**
 * @param {{index: any, snapshot: boolean, packages: string[], more: boolean}} plan
 */
async function boot({ index, snapshot, packages, more }) {
  const refusal = wasmRefusal();
  if (refusal) return fail(refusal, "");
  try {
    compileWasm();
    const { loadPyodide, createPyodideModule } = scope.__pyodide;
    python = await loadPyodide({
      indexURL: BASE,
      packageBaseUrl: BASE,
      stdLibURL: BASE + STDLIB,
      lockFileContents: index.lock,
      createPyodideModule,
      _loadSnapshot: snapshot ? bytesOf(SNAPSHOT) : undefined,
      args: [],
      env: { HOME: "/home/pyodide" },
    });
    python._api.config._loadSnapshot = undefined; // 31 MB that nothing needs any more
    progress("python");
    if (snapshot) reseed();
  } catch (error) {
    return fail(snapshot ? "snapshot-refused" : "python-failed", error);
  }
  try {
    await load(index, snapshot, packages, more);
    answer = python.pyimport(index.entry).answer;
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

/**
 * Our package, where it is not in memory yet, and what the page's scenes need besides.
 * @param {any} index
 * @param {boolean} snapshot
 * @param {string[]} packages
 * @param {boolean} more
 */
async function load(index, snapshot, packages, more) {
  if (more) {
    python.FS.writeFile(`/lib/${MORE}`, await bytesOf(MORE));
    python.runPython(APPEND_MORE);
  }
  if (snapshot && !packages.length) return;
  const alive = setInterval(() => progress("packages"), 1000);
  try {
    await python.loadPackage([index.package, ...packages], { messageCallback: () => {} });
  } finally {
    clearInterval(alive);
  }
  for (const name of [...packages, ...index.later]) {
    importIfPossible(name);
    progress(name);
  }
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
  else if (data.do === "part") take(data);
  else if (data.do === "request") respond(data);
};
tell({ tell: "hello" });
