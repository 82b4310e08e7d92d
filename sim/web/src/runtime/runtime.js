// Starts Python in a worker and talks to it: one worker, one request under way, answers in order.
import { RuntimeFailure } from "./failure.js";
import { loadIndex } from "./payload.js";
import { SLOW, SLOW_LINE, SNAPSHOT, Start, slowStage } from "./start.js";
import { requireWasm } from "./wasm.js";
import { AT_WORK, PATIENCE, SLOW_AFTER, watch } from "./watch.js";

/** @typedef {import("./failure.js").Reason} Reason */
/** @typedef {import("./start.js").Progress} Progress */
/** @typedef {{header: any, numbers: Float64Array}} Answer */

const PICK_UP = 3; // s until an idle worker must have taken up a request
const LONG = ["certify", "class", "cost", "hard", "law", "measured", "relevance", "teach"]; // kinds of requests that no picture waits for

/**
 * Starts Python for a page.
 *
 * Starts from the memory snapshot; where that is damaged or the browser can't use it, the plain way.
 * Rejects with a `RuntimeFailure`: message for the reader, code in `.reason`.
 * @param {{base: string, packages?: string[], patience?: number, onProgress?: (progress: Progress) => void}} options
 *   base: address of the folder `runtime/`, on a web server with a stamp (sim/pages/offline/stamps.py);
 *   packages: of "numpy", "scipy" and "newtons-carts-class"
 * @returns {Promise<Runtime>}
 */
export async function startRuntime({ base, packages = [], patience, onProgress = () => {} }) {
  requireWasm();
  if (typeof Worker !== "function") throw new RuntimeFailure("no-worker");
  if (typeof DecompressionStream !== "function") throw new RuntimeFailure("too-old");
  const folder = new URL(base, document.baseURI).href;
  let read = false;
  const late = watch(SLOW_AFTER, async () => {
    const stage = await slowStage(["index.js"], folder);
    if (!read) onProgress({ fraction: 0, stage });
  });
  const index = await loadIndex(folder).finally(late.stop);
  read = true;
  const options = { folder, index, packages: order(packages), onProgress, patience };
  const start = (/** @type {boolean} */ snapshot) => new Start(options, snapshot).run();
  if (!(SNAPSHOT in index.files)) return new Runtime(await start(false));
  try {
    return new Runtime(await start(true));
  } catch (error) {
    if (!(error instanceof RuntimeFailure) || !snapshotIsToBlame(error)) throw error;
    console.warn(`Python starts the plain way: ${error.reason} ${error.detail}`);
    return new Runtime(await start(false));
  }
}

/** @param {RuntimeFailure} error */
const snapshotIsToBlame = ({ reason, file }) => reason === "snapshot-refused" || file === SNAPSHOT;

/** scipy needs numpy, before it. @param {string[]} packages */
const order = (packages) => [
  ...new Set(packages.flatMap((name) => (name === "scipy" ? ["numpy", "scipy"] : [name]))),
];

export { SLOW, SLOW_LINE };

/** Python, ready to answer. */
export class Runtime {
  /** @param {import("./start.js").Started} started */
  constructor({ worker, start }) {
    /** How it started: "snapshot" or "plain". */
    this.start = start;
    /** Called once when Python is gone. @type {(failure: RuntimeFailure) => void} */
    this.onlost = () => {};
    this.worker = worker;
    /** @type {Reason | ""} */
    this.gone = "";
    this.number = 0;
    /** @type {{number: number, text: string, patience: number, resolve: (answer: Answer) => void,
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
   * @param {Record<string, unknown>} message
   * @returns {Promise<Answer>}
   */
  request(message) {
    if (this.gone) return Promise.reject(new RuntimeFailure(this.gone));
    return new Promise((resolve, reject) => {
      this.number += 1;
      const patience = LONG.includes(String(message.kind)) ? AT_WORK : PATIENCE;
      const text = JSON.stringify(message);
      this.queue.push({ number: this.number, text, patience, resolve, reject });
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
    if (!current || data.number !== current.number) return;
    if (data.tell === "alive") return void this.watch?.progress();
    this.watch?.stop();
    if (data.tell === "begun") {
      const { patience } = current;
      this.watch = watch(patience - PICK_UP, () => this.lose("worker-lost", "no answer"));
      return;
    }
    this.queue.shift();
    if (data.tell === "answer") {
      current.resolve({ header: JSON.parse(data.header), numbers: data.numbers });
    } else {
      current.reject(new RuntimeFailure(data.dead ? "worker-lost" : "request-failed", data.detail));
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
