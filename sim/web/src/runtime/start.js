// One attempt at starting Python: loads the files, starts the worker, gives it all it needs.
import { RuntimeFailure } from "./failure.js";
import { areKept, isFetching, Line } from "./line.js";
import { gunzip, loadPart } from "./payload.js";
import { Unpacker, workerOf } from "./unpack.js";
import { compile, compileFailure } from "./wasm.js";
import { LOST, SLOW_AFTER, watch } from "./watch.js";
// @ts-expect-error: the bundler puts the worker's text here
import workerText from "./worker.js?text";

/** @typedef {import("./payload.js").Index} Index */
/** @typedef {{fraction: number, stage: string}} Progress fraction: 0 to 1 of what has to be done; stage `SLOW`: nothing came for long, `SLOW_LINE`: over the network */
/** @typedef {{worker: Worker, start: "snapshot" | "plain"}} Started */

export const SLOW = "slow";
export const SLOW_LINE = "slow-line";
export const SNAPSHOT = "memory.snapshot";
const LOADER = "pyodide.js";
const WASM = "pyodide.asm.wasm";
const STDLIB = "python.zip";
const MORE = "python-more.zip";

/** What is slow where files of the folder are waited for. @param {string[]} files @param {string} folder */
export async function slowStage(files, folder) {
  const kept = !isFetching() || (await areKept(files.map((file) => new URL(file, folder))));
  return kept ? SLOW : SLOW_LINE;
}

/** Compiled before, by folder. @type {Map<string, WebAssembly.Module>} */
const modules = new Map();

/** One attempt at starting Python. */
export class Start {
  /**
   * @param {{folder: string, index: Index, packages: string[],
   *   onProgress: (progress: Progress) => void, patience?: number | undefined}} options `patience`: s without
   *   progress after which it is given up
   * @param {boolean} snapshot
   */
  constructor({ folder, index, packages, onProgress, patience = LOST }, snapshot) {
    this.folder = folder;
    this.index = index;
    this.packages = packages;
    this.onProgress = onProgress;
    this.patience = patience;
    this.snapshot = snapshot;
    /** @type {Worker | null} */
    this.worker = null;
    /** @type {Unpacker | null} */
    this.unpacker = null;
    this.over = false;
    this.line = new Line();
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
    const names = modules.has(this.folder) ? [LOADER] : [LOADER, WASM];
    if (snapshot) names.push(SNAPSHOT);
    names.push(STDLIB);
    if (packages.length && index.tableAt) names.push(MORE);
    names.push(...this.toLoad().map((name) => index.wheels[name]));
    if (names.every((name) => name in index.files)) return names;
    throw new RuntimeFailure("not-packed", index.missing || packages.join());
  }

  /** Packages that are not in memory yet. Ours is in the snapshot, but for modules that need others. */
  toLoad() {
    const { index, packages, snapshot } = this;
    if (!snapshot) return [index.package, ...packages];
    return packages.length && index.later.length ? [index.rest, ...packages] : packages;
  }

  /** @returns {Promise<Started>} */
  async run() {
    /** @type {(error: RuntimeFailure) => void} */
    let reject = () => {};
    const failed = new Promise((_, no) => {
      reject = no;
    });
    this.giveUp = () => reject(new RuntimeFailure("stalled"));
    this.guard();
    try {
      const unpacker = new Unpacker(reject);
      this.unpacker = unpacker;
      return await Promise.race([failed, this.boot(unpacker, reject)]);
    } catch (error) {
      this.worker?.terminate();
      throw error;
    } finally {
      this.over = true;
      this.slow?.stop();
      this.watch?.stop();
      this.unpacker?.stop();
    }
  }

  /**
   * The parts of a file, which come in any order. From a disk all are asked for at once.
   * @param {string} name
   * @param {(error: RuntimeFailure) => void} reject
   * @returns {Promise<Uint8Array<ArrayBuffer>>[]}
   */
  load(name, reject) {
    return this.index.files[name].parts.map(async (part, number) => {
      try {
        const bytes = await this.line.take(async () => {
          if (this.over) throw new RuntimeFailure("stopped"); // nobody waits for it any more
          return loadPart(this.folder, name, number, part);
        });
        this.done += part.size;
        if (!this.over && this.done === this.total && isFetching()) this.guard();
        this.progress(name);
        return bytes;
      } catch (error) {
        reject(/** @type {RuntimeFailure} */ (error));
        return new Promise(() => {}); // `reject` has ended this start
      }
    });
  }

  /**
   * Says that a start is slow, and at last gives it up; but not while files come over a network:
   * parts of a slow one are far apart, and who loads the page again begins anew.
   */
  guard() {
    this.slow?.stop();
    const loading = isFetching() && this.done < this.total;
    this.slow = watch(SLOW_AFTER, async () => {
      const parts = this.names.flatMap((name) => this.index.files[name].parts);
      const stage = loading
        ? await slowStage(
            parts.map((part) => part.src),
            this.folder,
          )
        : SLOW;
      if (!this.over) this.onProgress({ fraction: this.fraction, stage });
    });
    if (!loading) this.watch = watch(this.patience, () => this.giveUp?.());
  }

  /** @param {string} stage */
  progress(stage) {
    if (this.over) return;
    this.slow?.progress();
    this.watch?.progress();
    this.onProgress({ fraction: this.fraction, stage });
  }

  get fraction() {
    return (0.9 * this.done) / this.total;
  }

  /**
   * @param {Unpacker} unpacker
   * @param {(error: RuntimeFailure) => void} reject
   * @returns {Promise<any>}
   */
  async boot(unpacker, reject) {
    const load = (/** @type {string} */ name) => this.load(name, reject);
    const loading = load(LOADER);
    await Promise.all(loading); // before all else: a worker takes its time to start
    const compiling = this.module(this.names.includes(WASM) ? load(WASM) : []);
    compiling.catch((error) => reject(compileFailure(error)));
    const rest = this.names.filter((name) => name !== LOADER && name !== WASM);
    const files = rest.map((name) => ({ name, unpacked: unpacker.unpack(name, load(name)) }));
    const loader = await gunzip(await Promise.all(loading));
    if (this.over) return null;
    const { worker, address } = workerOf([loader, workerText]);
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
    worker.postMessage({
      do: "boot",
      lock: index.lock,
      entry: index.entry,
      snapshot,
      tableAt: packages.length ? index.tableAt : 0,
      load: this.toLoad(),
      modules: packages.length ? [...packages, ...index.later] : [],
    });
    for (const { name, unpacked } of files) {
      unpacked.then((bytes) => worker.postMessage({ do: "file", name, bytes }, [bytes]));
    }
    worker.postMessage({ do: "wasm", module: await compiling });
    this.progress(WASM);
    const { start } = await ready;
    this.onProgress({ fraction: 1, stage: "ready" });
    return { worker, start };
  }

  /** @param {Promise<Uint8Array<ArrayBuffer>>[]} parts */
  async module(parts) {
    const module = modules.get(this.folder) ?? (await compile(parts));
    modules.set(this.folder, module);
    return module;
  }
}
