// Starts Python in a worker and talks to it: one worker, one request under way, answers in order.
import { RuntimeFailure } from "./runtime-failure.js";
import { gunzip, loadIndex, loadPart } from "./runtime-payload.js";
import { watch } from "./runtime-watch.js";
// @ts-expect-error: the bundler puts the worker's text here
import workerText from "./worker.js?text";

/** @typedef {import("./runtime-payload.js").Index} Index */
/** @typedef {import("./runtime-failure.js").Reason} Reason */
/** @typedef {{header: any, numbers: Float64Array}} Answer */
/** @typedef {{fraction: number, stage: string}} Progress fraction: 0 to 1 of what has to be done */

const LOADER = "pyodide.js";
const SNAPSHOT = "memory.snapshot";
const MORE = "python-more.zip";

const PATIENCE = 8; // s without progress: the reader is told within 10 s
const PICK_UP = 3; // s until an idle worker must have taken up a request

/**
 * Starts Python for a page.
 *
 * Starts from the memory snapshot; where that is damaged or the browser can't use it, the plain way.
 * Rejects with a `RuntimeFailure`: message for the reader, code in `.reason`.
 * @param {{base: string, packages?: string[], onProgress?: (progress: Progress) => void}} options
 *   base: address of the folder `runtime/`; packages: of "numpy" and "scipy"
 * @returns {Promise<Runtime>}
 */
export async function startRuntime({ base, packages = [], onProgress = () => {} }) {
  if (typeof WebAssembly !== "object") throw new RuntimeFailure("no-wasm");
  if (typeof DecompressionStream !== "function") throw new RuntimeFailure("too-old");
  const folder = new URL(base.endsWith("/") ? base : `${base}/`, document.baseURI).href;
  const index = await loadIndex(folder);
  const options = { folder, index, packages: order(packages), onProgress };
  if (!(SNAPSHOT in index.files)) return new Start(options, false).run();
  try {
    return await new Start(options, true).run();
  } catch (error) {
    if (!(error instanceof RuntimeFailure) || !snapshotIsToBlame(error)) throw error;
    console.warn(`Python starts the plain way: ${error.reason} ${error.detail}`);
    return new Start(options, false).run();
  }
}

/** @param {RuntimeFailure} error */
const snapshotIsToBlame = ({ reason, file }) => reason === "snapshot-refused" || file === SNAPSHOT;

/** scipy needs numpy, before it. @param {string[]} packages */
const order = (packages) =>
  packages.includes("scipy") ? ["numpy", "scipy"] : [...new Set(packages)];

/** One attempt at starting. */
class Start {
  /**
   * @param {{folder: string, index: Index, packages: string[],
   *   onProgress: (progress: Progress) => void}} options
   * @param {boolean} snapshot
   */
  constructor({ folder, index, packages, onProgress }, snapshot) {
    this.folder = folder;
    this.index = index;
    this.packages = packages;
    this.onProgress = onProgress;
    this.snapshot = snapshot;
    /** @type {Worker | null} */
    this.worker = null;
    this.over = false;
    this.done = 0;
    /** @type {string[]} */
    this.names = this.files();
    this.total = this.names
      .flatMap((name) => index.files[name].parts)
      .reduce((sum, part) => sum + part.size, 0);
  }

  /** The files to load, the most urgent first. */
  files() {
    const { index, packages, snapshot } = this;
    const names = [LOADER, "pyodide.asm.wasm"];
    if (snapshot) names.push(SNAPSHOT);
    names.push("python.zip");
    const wheels = packages.length || !snapshot ? [index.package, ...packages] : [];
    if (packages.length) names.push(MORE);
    names.push(...wheels.map((wheel) => index.wheels[wheel]));
    if (names.every((name) => name in index.files)) return names;
    throw new RuntimeFailure("not-packed", index.missing || packages.join());
  }

  /** @returns {Promise<Runtime>} */
  async run() {
    /** @type {(error: RuntimeFailure) => void} */
    let reject = () => {};
    const failed = new Promise((_, no) => {
      reject = no;
    });
    this.watch = watch(PATIENCE, () => reject(new RuntimeFailure("stalled")));
    try {
      const parts = new Map(this.names.map((name) => [name, this.load(name, reject)]));
      return await Promise.race([failed, this.boot(parts, reject)]);
    } catch (error) {
      this.worker?.terminate();
      throw error;
    } finally {
      this.over = true;
      this.watch.stop();
    }
  }

  /**
   * All parts of a file are asked for at once and come in any order.
   * @param {string} name
   * @param {(error: RuntimeFailure) => void} reject
   * @returns {Promise<Uint8Array<ArrayBuffer>>[]}
   */
  load(name, reject) {
    return this.index.files[name].parts.map(async (part, number) => {
      try {
        const bytes = await loadPart(this.folder, name, number, part);
        this.done += part.size;
        this.progress(name);
        return bytes;
      } catch (error) {
        reject(/** @type {RuntimeFailure} */ (error));
        return new Promise(() => {}); // `reject` has ended this start
      }
    });
  }

  /** @param {string} stage */
  progress(stage) {
    if (this.over) return;
    this.watch?.progress();
    this.onProgress({ fraction: (0.9 * this.done) / this.total, stage });
  }

  /**
   * @param {Map<string, Promise<Uint8Array<ArrayBuffer>>[]>} parts
   * @param {(error: RuntimeFailure) => void} reject
   * @returns {Promise<any>}
   */
  async boot(parts, reject) {
    const loader = await gunzip(await Promise.all(parts.get(LOADER) ?? []));
    if (this.over) return null;
    const { worker, address } = startWorker(loader);
    this.worker = worker;
    const ready = new Promise((resolve) => {
      worker.onmessage = ({ data }) => {
        if (data.tell === "hello") URL.revokeObjectURL(address);
        else if (data.tell === "ready") resolve(data);
        else if (data.tell === "failed") {
          reject(new RuntimeFailure(data.reason, data.detail, data.file));
        }
        this.progress(data.stage ?? data.tell);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new RuntimeFailure("worker-refused", event.message));
      };
    });
    const { index, packages, snapshot } = this;
    const { lock, package: own, entry, later } = index;
    const wanted = { lock, package: own, entry, later };
    worker.postMessage({
      do: "boot",
      index: wanted,
      snapshot,
      packages,
      more: packages.length > 0,
    });
    for (const name of this.names.slice(1)) this.send(name, parts.get(name) ?? []);
    const { start } = await ready;
    this.onProgress({ fraction: 1, stage: "ready" });
    return new Runtime(worker, start);
  }

  /**
   * @param {string} name
   * @param {Promise<Uint8Array<ArrayBuffer>>[]} parts
   */
  async send(name, parts) {
    for (const [number, part] of parts.entries()) {
      const bytes = await part;
      if (this.over) return;
      const last = number === parts.length - 1;
      this.worker?.postMessage({ do: "part", name, bytes, last }, [bytes.buffer]);
    }
  }
}

/** @param {ArrayBuffer} loader */
function startWorker(loader) {
  const address = URL.createObjectURL(new Blob([loader, workerText], { type: "text/javascript" }));
  try {
    return { worker: new Worker(address), address };
  } catch (error) {
    throw new RuntimeFailure("worker-refused", String(error));
  }
}

/** Python, ready to answer. */
export class Runtime {
  /**
   * @param {Worker} worker
   * @param {"snapshot" | "plain"} start how it started
   */
  constructor(worker, start) {
    this.start = start;
    /** Called once when Python is gone. @type {(failure: RuntimeFailure) => void} */
    this.onlost = () => {};
    this.worker = worker;
    /** @type {Reason | ""} */
    this.gone = "";
    this.number = 0;
    /** @type {{number: number, text: string, resolve: (answer: Answer) => void,
     *   reject: (error: Error) => void}[]} */
    this.queue = [];
    worker.onmessage = ({ data }) => this.hear(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.lose("worker-lost", event.message);
    };
  }

  /**
   * Sends a request and returns its answer. Rejects if Python breaks on it or is lost.
   * @param {object} message
   * @returns {Promise<Answer>}
   */
  request(message) {
    if (this.gone) return Promise.reject(new RuntimeFailure(this.gone));
    return new Promise((resolve, reject) => {
      this.number += 1;
      this.queue.push({ number: this.number, text: JSON.stringify(message), resolve, reject });
      if (this.queue.length === 1) this.send();
    });
  }

  /** Ends Python. What is under way is rejected. */
  stop() {
    this.end("stopped", "");
  }

  send() {
    const next = this.queue[0];
    if (!next) return;
    this.watch = watch(PICK_UP, () => this.lose("worker-lost", "no sign of life"));
    this.worker.postMessage({ do: "request", number: next.number, text: next.text });
  }

  /** @param {any} data */
  hear(data) {
    const current = this.queue[0];
    if (data.number !== current?.number) return;
    this.watch?.stop();
    if (data.tell === "begun") {
      this.watch = watch(PATIENCE - PICK_UP, () => this.lose("worker-lost", "no answer"));
      return;
    }
    this.queue.shift();
    if (data.tell === "answer") {
      current.resolve({ header: JSON.parse(data.header), numbers: data.numbers });
    } else {
      current.reject(new RuntimeFailure(data.dead ? "worker-lost" : "python-failed", data.detail));
      if (data.dead) this.lose("worker-lost", data.detail);
    }
    if (!this.gone) this.send();
  }

  /** @param {Reason} reason @param {string} detail */
  lose(reason, detail) {
    if (this.end(reason, detail)) this.onlost(new RuntimeFailure(reason, detail));
  }

  /** @param {Reason} reason @param {string} detail @returns {boolean} whether it was alive */
  end(reason, detail) {
    if (this.gone) return false;
    this.gone = reason;
    this.watch?.stop();
    this.worker.terminate();
    for (const { reject } of this.queue.splice(0)) reject(new RuntimeFailure(reason, detail));
    return true;
  }
}
