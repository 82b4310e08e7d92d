"use strict";
(() => {
  // src/runtime/client.js
  var RESTARTS = 3;
  var Client = class extends EventTarget {
    /** @type {State} */
    state = "idle";
    /** @type {(Error & {reason?: string}) | null} */
    error = null;
    /** @type {Runtime | null} */
    #runtime = null;
    /** @type {Job[]} */
    #waiting = [];
    /** @type {Job | null} */
    #flying = null;
    #restarts = 0;
    #lastId = 0;
    /** @type {string[]} packages that were asked for after the start */
    #asked = [];
    /** @type {string[]} those of them that Python has, and gets again after a restart */
    #more = [];
    /** @type {Promise<void>} when they are there */
    #growing = Promise.resolve();
    /** @param {Start} start */
    constructor(start) {
      super();
      this.start = start;
    }
    /** Starts Python if nobody has yet. */
    wake() {
      if (this.state === "idle") void this.#boot();
    }
    /**
     * Has packages that no scene of the page called for. A second Python starts with them and takes
     * over; meanwhile the first goes on answering. Rejects where the site does not carry them.
     * @param {string[]} names @returns {Promise<void>}
     */
    need(names) {
      if (names.every((name) => this.#asked.includes(name))) return this.#growing;
      const before = this.#asked;
      this.#asked = [.../* @__PURE__ */ new Set([...before, ...names])];
      const needed = this.#growing.catch(() => {
      }).then(() => this.#grow(this.#asked));
      this.#growing = needed;
      needed.catch(() => {
        this.#asked = before;
      });
      return needed;
    }
    /** @param {string[]} names */
    async #grow(names) {
      this.wake();
      await this.#settled();
      if (this.state === "failed") throw this.error;
      this.#use(await this.start(names));
      this.#more = names;
      this.#become("ready");
      this.#next();
    }
    /** Resolves when Python is not just starting. @returns {Promise<void>} */
    #settled() {
      if (this.state !== "starting") return Promise.resolve();
      return new Promise((resolve) => {
        this.addEventListener("state", () => resolve(this.#settled()), { once: true });
      });
    }
    /**
     * Asks for a run. A newer request of the same owner takes the place of one that still waits;
     * both promises then get the newer answer.
     * @param {object} owner @param {Message} message @returns {Promise<Reply>}
     */
    ask(owner, message) {
      if (this.state === "failed") return Promise.reject(this.error);
      this.wake();
      return new Promise((resolve, reject) => {
        const settle = { resolve, reject };
        const older = this.#waiting.find((job) => job.owner === owner);
        if (older) {
          older.message = message;
          older.settle.push(settle);
        } else this.#waiting.push({ owner, message, settle: [settle] });
        this.#next();
      });
    }
    #next() {
      if (this.#flying || !this.#runtime) return;
      const job = this.#waiting.shift();
      if (!job) return;
      this.#flying = job;
      const runtime = this.#runtime;
      this.#lastId += 1;
      const sent = { ...job.message(), id: this.#lastId };
      const landed = () => {
        if (runtime !== this.#runtime || this.#flying !== job) return false;
        this.#flying = null;
        return true;
      };
      runtime.request(sent).then(
        (reply) => {
          if (!landed()) return;
          this.#restarts = 0;
          for (const { resolve } of job.settle) resolve({ ...reply, sent });
          this.#next();
        },
        (error) => {
          if (error?.reason !== "python-failed") return this.#lost(runtime, error);
          if (!landed()) return;
          for (const { reject } of job.settle) reject(error);
          this.#next();
        }
      );
    }
    async #boot() {
      this.#become("starting");
      try {
        this.#use(await this.start(this.#more));
        this.#become("ready");
        this.#next();
      } catch (error) {
        this.#fail(error);
      }
    }
    /** @param {Runtime} runtime @param {unknown} reason */
    #lost(runtime, reason) {
      if (runtime !== this.#runtime) return;
      this.#runtime = null;
      runtime.stop();
      this.#takeBack();
      this.#restarts += 1;
      if (this.#restarts > RESTARTS) this.#fail(reason);
      else void this.#boot();
    }
    /** From now on this one answers, in the place of another if there is one. @param {Runtime} runtime */
    #use(runtime) {
      const older = this.#runtime;
      runtime.onlost = (reason) => this.#lost(runtime, reason);
      this.#runtime = runtime;
      older?.stop();
      this.#takeBack();
    }
    /** The request under way waits again, in front: whoever could answer it is gone. */
    #takeBack() {
      const job = this.#flying;
      this.#flying = null;
      if (!job) return;
      const newer = this.#waiting.find(({ owner }) => owner === job.owner);
      if (newer) newer.settle.unshift(...job.settle);
      else this.#waiting.unshift(job);
    }
    /** @param {unknown} reason */
    #fail(reason) {
      this.error = reason instanceof Error ? reason : new Error(String(reason ?? "the worker stopped"));
      this.#become("failed");
      for (const { settle } of this.#waiting.splice(0)) {
        for (const { reject } of settle) reject(this.error);
      }
    }
    /** @param {State} state */
    #become(state) {
      this.state = state;
      this.dispatchEvent(new Event("state"));
    }
  };

  // ../view/language.js
  var catalogue = (
    /** @type {any} */
    globalThis.cartsWords ?? {}
  );
  function tr(sentence, values = {}) {
    const said = catalogue[sentence] ?? sentence;
    return said.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
  }

  // src/runtime/failure.js
  var MESSAGES = {
    "not-packed": tr("This page was built without Python. It shows only the runs that came with it."),
    "payload-missing": tr(
      "A file of this page is missing, so Python can't start. Copy the whole folder again."
    ),
    "payload-damaged": tr(
      "A file of this page is damaged, so Python can't start. Copy the whole folder again."
    ),
    "no-wasm": tr(
      "This browser has no WebAssembly, so Python can't start here. Try another browser."
    ),
    "wasm-refused": tr(
      "This browser, or the rules of this network, do not allow Python to start. Try another browser."
    ),
    "too-old": tr(
      "This browser is too old to run Python. Try Chrome or Edge 111, Firefox 113, Safari 16.4, or newer."
    ),
    "no-memory": tr(
      "This computer has too little memory free for Python. Close other programs and load the page again."
    ),
    "no-worker": tr("This browser has no workers, so Python can't start here. Try another browser."),
    "worker-refused": tr("This browser does not let the page start Python. Try another browser."),
    "worker-lost": tr("Python stopped. It may have run out of memory."),
    "snapshot-refused": tr("Python could not start the quick way."),
    "python-failed": tr(
      "Python could not start. Copy the whole folder again or try another browser."
    ),
    stalled: tr("Python does not answer. Close other programs and load the page again."),
    stopped: tr("Python was stopped.")
  };
  var RuntimeFailure = class extends Error {
    /**
     * @param {Reason} reason
     * @param {string} [detail]
     * @param {string} [file] the payload that is missing or damaged
     */
    constructor(reason, detail = "", file = "") {
      super(MESSAGES[reason] ?? MESSAGES["python-failed"]);
      this.name = "RuntimeFailure";
      this.reason = reason;
      this.detail = detail;
      this.file = file;
    }
  };

  // src/shared/leaving.js
  var STAYS = 3e3;
  var leaving = false;
  var waiting = [];
  function stay() {
    leaving = false;
    for (const go of waiting) go();
    waiting = [];
  }
  addEventListener("beforeunload", () => {
    leaving = true;
    setTimeout(stay, STAYS);
  });
  addEventListener("pagehide", () => {
    leaving = true;
  });
  addEventListener("pageshow", stay);
  if (navigator.userAgent.includes("Firefox/")) addEventListener("unload", () => {
  });
  var isLeaving = () => leaving;
  function staying() {
    return leaving ? new Promise((resolve) => waiting.push(resolve)) : Promise.resolve();
  }

  // src/runtime/watch.js
  var SECOND = 1e3;
  var PATIENCE = 8;
  function watch(patience, late) {
    let left = patience;
    const timer = setInterval(() => {
      left -= 1;
      if (left > 0) return;
      clearInterval(timer);
      late();
    }, SECOND);
    return {
      progress() {
        left = patience;
      },
      stop() {
        clearInterval(timer);
      }
    };
  }

  // src/runtime/payload.js
  var page = self;
  var indexes = /* @__PURE__ */ new Map();
  function runScript(src, name) {
    return new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = src;
      script.async = true;
      const settle = (then) => () => {
        script.remove();
        then();
      };
      script.onload = settle(resolve);
      script.onerror = settle(() => {
        if (isLeaving()) staying().then(() => runScript(src, name).then(resolve, reject));
        else reject(new RuntimeFailure("payload-missing", src, name));
      });
      document.head.append(script);
    });
  }
  function indexOf(base) {
    return new URL(`index.js${new URL(base).search}`, base).href;
  }
  function patiently(promise) {
    return new Promise((resolve, reject) => {
      const waiting2 = watch(PATIENCE, () => reject(new RuntimeFailure("stalled", "index.js")));
      promise.then(resolve, reject).finally(waiting2.stop);
    });
  }
  function loadIndex(base) {
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
  async function loadPart(base, name, number, part) {
    const inside = Boolean(page.__cartsInside);
    if (!inside) await runScript(new URL(part.src, base).href, name);
    const key = `${name}.${number}`;
    const text = page.__cartsParts?.[key];
    if (text === void 0) throw new RuntimeFailure("payload-damaged", part.src, name);
    if (!inside) delete page.__cartsParts[key];
    const bytes = decode(text, part.src, name);
    if (bytes.length !== part.size || !await matches(bytes, part.sha256)) {
      throw new RuntimeFailure("payload-damaged", part.src, name);
    }
    return bytes;
  }
  function decode(text, src, name) {
    try {
      const fast = Uint8Array;
      return fast.fromBase64 ? fast.fromBase64(text) : Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    } catch {
      throw new RuntimeFailure("payload-damaged", src, name);
    }
  }
  async function matches(bytes, sha256) {
    if (!globalThis.crypto?.subtle) return true;
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("") === sha256;
  }
  async function gunzip(parts) {
    const zip = new DecompressionStream("gzip");
    const writer = zip.writable.getWriter();
    const written = Promise.all([...parts.map((part) => writer.write(part)), writer.close()]);
    const [bytes] = await Promise.all([new Response(zip.readable).arrayBuffer(), written]);
    return bytes;
  }

  // src/runtime/wasm.js
  var NOTHING = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]);
  function requireWasm() {
    if (typeof WebAssembly !== "object") throw new RuntimeFailure("no-wasm");
    try {
      new WebAssembly.Module(NOTHING);
    } catch (error) {
      throw new RuntimeFailure("wasm-refused", String(error));
    }
  }
  function compileFailure(error) {
    const short = error instanceof RangeError || /memory|allocat/i.test(String(error));
    return new RuntimeFailure(short ? "no-memory" : "too-old", String(error), "pyodide.asm.wasm");
  }
  async function compile(parts) {
    const zip = new DecompressionStream("gzip");
    const headers = { "Content-Type": "application/wasm" };
    const compiled = WebAssembly.compileStreaming(new Response(zip.readable, { headers }));
    const written = write(zip.writable.getWriter(), parts);
    const [module] = await Promise.all([compiled, written]);
    return module;
  }
  async function write(writer, parts) {
    for (const part of parts) await writer.write(await part);
    await writer.close();
  }

  // as-text:src/runtime/worker.js
  var worker_default = '"use strict";\n(() => {\n  // src/runtime/worker.js\n  var scope = self;\n  var BASE = "https://runtime.invalid/";\n  var WASM = "pyodide.asm.wasm";\n  var STDLIB = "python.zip";\n  var SNAPSHOT = "memory.snapshot";\n  var MORE = "python-more.zip";\n  var stdlib;\n  var files = /* @__PURE__ */ new Map();\n  var python;\n  var answer;\n  var tell = (message, transfer = []) => scope.postMessage(message, transfer);\n  var fail = (reason, error, name = "") => tell({ tell: "failed", reason, detail: String(error), file: name });\n  var progress = (stage) => tell({ tell: "progress", stage });\n  function file(name) {\n    let found = files.get(name);\n    if (!found) {\n      const zip = new DecompressionStream("gzip");\n      found = { writer: zip.writable.getWriter(), response: new Response(zip.readable) };\n      files.set(name, found);\n    }\n    return found;\n  }\n  function take({ name, bytes, last }) {\n    const { writer } = file(name);\n    const damaged = (error) => fail("payload-damaged", error, name);\n    writer.write(bytes).catch(damaged);\n    if (last) writer.close().catch(damaged);\n  }\n  var bytesOf = async (name) => new Uint8Array(await file(name).response.arrayBuffer());\n  scope.fetch = async (address) => {\n    const name = String(address).split("/").pop() ?? "";\n    if (name === WASM) return new Response();\n    if (name === STDLIB) return stdlib;\n    return file(name).response;\n  };\n  async function wholeStdlib(tableAt) {\n    if (!tableAt) return file(STDLIB).response;\n    const [first, more] = await Promise.all([bytesOf(STDLIB), bytesOf(MORE)]);\n    const whole = new Uint8Array(tableAt + more.length);\n    whole.set(first.subarray(0, tableAt));\n    whole.set(more, tableAt);\n    return new Response(whole);\n  }\n  var giveWasm = () => {\n  };\n  var wasm = new Promise((resolve) => {\n    giveWasm = resolve;\n  });\n  function useCompiledWasm() {\n    const api = WebAssembly;\n    api.instantiateStreaming = async (_, imports) => {\n      const module = await wasm;\n      try {\n        return { module, instance: await WebAssembly.instantiate(module, imports) };\n      } catch (error) {\n        const short = error instanceof RangeError || /memory|allocat/i.test(String(error));\n        fail(short ? "no-memory" : "too-old", error);\n        throw error;\n      }\n    };\n  }\n  async function boot({ lock, snapshot, tableAt, load, modules, entry }) {\n    try {\n      useCompiledWasm();\n      stdlib = wholeStdlib(tableAt);\n      const { loadPyodide, createPyodideModule } = scope.__pyodide;\n      python = await loadPyodide({\n        indexURL: BASE,\n        packageBaseUrl: BASE,\n        stdLibURL: BASE + STDLIB,\n        lockFileContents: lock,\n        createPyodideModule,\n        _loadSnapshot: snapshot ? bytesOf(SNAPSHOT) : void 0,\n        args: [],\n        env: { HOME: "/home/pyodide" }\n      });\n      python._api.config._loadSnapshot = void 0;\n      progress("python");\n      if (snapshot) reseed();\n    } catch (error) {\n      return fail(snapshot ? "snapshot-refused" : "python-failed", error);\n    }\n    try {\n      if (load.length) await loadPackages(load);\n      for (const name of modules) {\n        importIfPossible(name);\n        progress(name);\n      }\n      answer = python.pyimport(entry).answer;\n    } catch (error) {\n      return fail("python-failed", error);\n    }\n    files.clear();\n    return tell({ tell: "ready", start: snapshot ? "snapshot" : "plain" });\n  }\n  function reseed() {\n    python.runPython(`\nimport sys\nif "random" in sys.modules:\n    sys.modules["random"].seed()\n`);\n  }\n  async function loadPackages(names) {\n    const alive = setInterval(() => progress("packages"), 1e3);\n    try {\n      await python.loadPackage(names, { messageCallback: () => {\n      } });\n    } finally {\n      clearInterval(alive);\n    }\n    progress("packages");\n  }\n  function importIfPossible(name) {\n    try {\n      python.pyimport(name).destroy();\n    } catch (error) {\n      if (\n        /** @type {any} */\n        error?.type !== "ModuleNotFoundError"\n      ) throw error;\n    }\n  }\n  function respond({ number, text }) {\n    tell({ tell: "begun", number });\n    try {\n      const [header, numbers] = answer(text);\n      tell({ tell: "answer", number, header, numbers }, [numbers.buffer]);\n    } catch (error) {\n      tell({ tell: "broken", number, detail: String(error), dead: isDead() });\n    }\n  }\n  function isDead() {\n    try {\n      return python.runPython("1") !== 1;\n    } catch {\n      return true;\n    }\n  }\n  scope.onmessage = ({ data }) => {\n    if (data.do === "boot") boot(data);\n    else if (data.do === "part") take(data);\n    else if (data.do === "wasm") giveWasm(data.module);\n    else if (data.do === "request") respond(data);\n  };\n  tell({ tell: "hello" });\n})();\n';

  // src/runtime/start.js
  var SNAPSHOT = "memory.snapshot";
  var LOADER = "pyodide.js";
  var WASM = "pyodide.asm.wasm";
  var STDLIB = "python.zip";
  var MORE = "python-more.zip";
  var modules = /* @__PURE__ */ new Map();
  var Start = class {
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
      this.worker = null;
      this.over = false;
      this.done = 0;
      this.names = this.files();
      this.total = this.names.flatMap((name) => index.files[name].parts).reduce((sum, part) => sum + part.size, 0);
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
      const ours = !snapshot || packages.length > 0 && index.later.length > 0;
      return ours ? [index.package, ...packages] : packages;
    }
    /** @returns {Promise<Started>} */
    async run() {
      let reject = () => {
      };
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
          reject(
            /** @type {RuntimeFailure} */
            error
          );
          return new Promise(() => {
          });
        }
      });
    }
    /** @param {string} stage */
    progress(stage) {
      if (this.over) return;
      this.watch?.progress();
      this.onProgress({ fraction: 0.9 * this.done / this.total, stage });
    }
    /**
     * @param {Map<string, Promise<Uint8Array<ArrayBuffer>>[]>} parts
     * @param {(error: RuntimeFailure) => void} reject
     * @returns {Promise<any>}
     */
    async boot(parts, reject) {
      const compiling = this.module(parts.get(WASM) ?? []);
      compiling.catch((error) => reject(compileFailure(error)));
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
      worker.postMessage({
        do: "boot",
        lock: index.lock,
        entry: index.entry,
        snapshot,
        tableAt: packages.length ? index.tableAt : 0,
        load: this.toLoad(),
        modules: packages.length ? [...packages, ...index.later] : []
      });
      for (const [name, its] of parts) if (name !== LOADER && name !== WASM) this.send(name, its);
      worker.postMessage({ do: "wasm", module: await compiling });
      this.progress(WASM);
      const { start } = await ready;
      this.onProgress({ fraction: 1, stage: "ready" });
      return { worker, start };
    }
    /** @param {Promise<Uint8Array<ArrayBuffer>>[]} parts */
    async module(parts) {
      const module = modules.get(this.folder) ?? await compile(parts);
      modules.set(this.folder, module);
      return module;
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
  };
  function startWorker(loader) {
    const address = URL.createObjectURL(new Blob([loader, worker_default], { type: "text/javascript" }));
    try {
      return { worker: new Worker(address), address };
    } catch (error) {
      throw new RuntimeFailure("worker-refused", String(error));
    }
  }

  // src/runtime/runtime.js
  var PICK_UP = 3;
  async function startRuntime({ base, packages = [], onProgress = () => {
  } }) {
    requireWasm();
    if (typeof Worker !== "function") throw new RuntimeFailure("no-worker");
    if (typeof DecompressionStream !== "function") throw new RuntimeFailure("too-old");
    const folder = new URL(base, document.baseURI).href;
    const index = await loadIndex(folder);
    const options = { folder, index, packages: order(packages), onProgress };
    const start = (snapshot) => new Start(options, snapshot).run();
    if (!(SNAPSHOT in index.files)) return new Runtime(await start(false));
    try {
      return new Runtime(await start(true));
    } catch (error) {
      if (!(error instanceof RuntimeFailure) || !snapshotIsToBlame(error)) throw error;
      console.warn(`Python starts the plain way: ${error.reason} ${error.detail}`);
      return new Runtime(await start(false));
    }
  }
  var snapshotIsToBlame = ({ reason, file }) => reason === "snapshot-refused" || file === SNAPSHOT;
  var order = (packages) => [
    ...new Set(packages.flatMap((name) => name === "scipy" ? ["numpy", "scipy"] : [name]))
  ];
  var Runtime = class {
    /** @param {import("./start.js").Started} started */
    constructor({ worker, start }) {
      this.start = start;
      this.onlost = () => {
      };
      this.worker = worker;
      this.gone = "";
      this.number = 0;
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
  };

  // src/shared/features.js
  function missingFeatures() {
    const needed = [
      ["WebAssembly", typeof WebAssembly === "object"],
      [tr("workers"), typeof Worker === "function"],
      [tr("decompression"), typeof DecompressionStream === "function"]
    ];
    return needed.filter(([, there]) => !there).map(([name]) => name);
  }

  // src/teach/door.js
  var OPEN = "carts-teach";

  // src/answers/entry.js
  var MOST_EARLIER = 500;
  function isEmpty(value) {
    if (typeof value === "string") return !value.trim();
    if (value === null || value === void 0) return true;
    return typeof value === "object" && Object.keys(value).length === 0;
  }
  function keepEarlier(old, value) {
    if (!old || typeof old !== "object" || typeof value !== "object" || value === null) return value;
    const earlier = union(old.earlier, value.earlier);
    const other = old.hash && value.hash && old.hash !== value.hash && !isEmpty(old.value);
    const all = other ? union(earlier, [alone(old)]) : earlier;
    return all.length ? { ...value, earlier: all } : value;
  }
  function alone({ earlier: _, ...entry }) {
    return entry;
  }
  function union(a, b) {
    const found = /* @__PURE__ */ new Map();
    for (const entry of [...a ?? [], ...b ?? []]) {
      found.set(JSON.stringify([entry.hash, entry.value]), entry);
    }
    const all = [...found.values()];
    all.sort((x, y) => String(x.last ?? "").localeCompare(String(y.last ?? "")));
    return all.slice(-MOST_EARLIER);
  }

  // src/shared/newest-first.js
  function newestFirst(put) {
    const flights = /* @__PURE__ */ new Map();
    function start(key, value, alone2) {
      const now = put(key, value, alone2);
      flights.set(key, { now, next: null });
      const over = () => {
        if (flights.get(key)?.now === now && !flights.get(key)?.next) flights.delete(key);
      };
      now.then(over, over);
      return now;
    }
    return (key, value, alone2 = false) => {
      const flight = flights.get(key);
      if (!flight) return start(key, value, alone2);
      if (flight.next) {
        flight.next.value = value;
        flight.next.alone &&= alone2;
        return flight.next.written;
      }
      const next = { value, alone: alone2, written: Promise.resolve() };
      const begin2 = () => start(key, next.value, next.alone);
      next.written = flight.now.then(begin2, begin2);
      flight.next = next;
      return next.written;
    };
  }

  // src/shared/indexed-store.js
  var SETTLED = "settled";
  var STORE = "answers";
  var PATIENCE2 = 2e4;
  var SETTLE_AFTER = 400;
  function open(name) {
    return new Promise((resolve, reject) => {
      const request = indexedDB.open(name, 1);
      request.onupgradeneeded = () => request.result.createObjectStore(STORE);
      request.onsuccess = () => {
        request.result.onversionchange = () => request.result.close();
        resolve(request.result);
      };
      request.onerror = () => reject(request.error);
      request.onblocked = () => reject(new Error("another page holds an older version"));
      setTimeout(() => reject(new Error("no answer")), PATIENCE2);
    });
  }
  async function reopening(name) {
    let base = await open(name);
    return async (mode, durability = "relaxed") => {
      try {
        return base.transaction(STORE, mode, { durability });
      } catch {
        base = await open(name);
        return base.transaction(STORE, mode, { durability });
      }
    };
  }
  async function indexed(name) {
    const begin2 = await reopening(name);
    const read = async (ask) => {
      const work = await begin2("readonly");
      return new Promise((resolve, reject) => {
        const request = ask(work.objectStore(STORE));
        request.onsuccess = () => resolve(request.result);
        request.onerror = () => reject(request.error);
      });
    };
    return {
      kind: "kept",
      how: "indexed",
      get: (key) => read((answers) => answers.get(key)),
      put: newestFirst(
        (key, value, alone2) => write2(begin2, (answers) => {
          if (alone2) {
            answers.put(value, key);
            answers.transaction.commit();
            return;
          }
          const request = answers.get(key);
          request.onsuccess = () => answers.put(keepEarlier(request.result, value), key);
        })
      ),
      remove: (key) => write2(begin2, (answers) => answers.delete(key)),
      entries: async () => {
        const [keys, values] = await Promise.all([
          read((answers) => answers.getAllKeys()),
          read((answers) => answers.getAll())
        ]);
        return keys.map((key, k) => [String(key), values[k]]);
      }
    };
  }
  var settling;
  async function write2(begin2, act) {
    await transaction(begin2, act, "relaxed");
    clearTimeout(settling);
    settling = setTimeout(() => {
      const mark = (answers) => void answers.put(Date.now(), SETTLED);
      transaction(begin2, mark, "strict").catch(() => {
      });
    }, SETTLE_AFTER);
  }
  async function transaction(begin2, act, durability) {
    const work = await begin2("readwrite", durability);
    return new Promise((resolve, reject) => {
      act(work.objectStore(STORE));
      work.oncomplete = () => resolve();
      work.onerror = () => reject(work.error);
      work.onabort = () => reject(work.error);
    });
  }

  // src/shared/shelter.js
  function shelter() {
    const page2 = (
      /** @type {any} */
      globalThis
    );
    const name = /* @__PURE__ */ Symbol.for("carts-shelter");
    page2[name] ??= /* @__PURE__ */ new Map();
    return page2[name];
  }
  function sheltered(store) {
    return {
      ...store,
      put: async (key, value, alone2) => {
        try {
          await store.put(key, value, alone2);
          shelter().delete(key);
        } catch (error) {
          shelter().set(key, keepEarlier(shelter().get(key), value));
          throw error;
        }
      },
      remove: async (key) => {
        shelter().delete(key);
        await store.remove(key);
      },
      entries: async () => [...new Map([...await store.entries(), ...shelter()])]
    };
  }
  function memory() {
    const kept = shelter();
    return {
      kind: "memory",
      how: "memory",
      get: async (key) => kept.get(key),
      put: async (key, value) => void kept.set(key, keepEarlier(kept.get(key), value)),
      remove: async (key) => void kept.delete(key),
      entries: async () => [...kept]
    };
  }

  // src/shared/text-store.js
  function textStore(site) {
    const before = `carts:${site}:`;
    try {
      localStorage.setItem(`${before}probe`, "1");
      localStorage.removeItem(`${before}probe`);
    } catch {
      return null;
    }
    const get = (key) => JSON.parse(localStorage.getItem(before + key) ?? "null");
    return {
      kind: "kept",
      how: "text",
      get: async (key) => get(key),
      put: async (key, value) => localStorage.setItem(before + key, JSON.stringify(keepEarlier(get(key), value))),
      remove: async (key) => localStorage.removeItem(before + key),
      entries: async () => Object.keys(localStorage).filter((name) => name.startsWith(before)).map((name) => [name.slice(before.length), get(name.slice(before.length))])
    };
  }

  // src/shared/storage.js
  var opened = /* @__PURE__ */ new Map();
  function openAll(site) {
    const found = opened.get(site) ?? openOnce(site);
    opened.set(site, found);
    return found;
  }
  async function openOnce(site) {
    try {
      return sheltered(await indexed(`carts:${site}`));
    } catch {
      const texts = textStore(site);
      return texts ? sheltered(texts) : memory();
    }
  }
  function place() {
    const { cartsSite, cartsPage } = document.documentElement.dataset;
    const meta = (name) => document.querySelector(`meta[name="${name}"]`)?.getAttribute("content");
    const path = location.pathname.split("/").slice(-2).join("/");
    return {
      site: cartsSite ?? meta("carts-site") ?? "site",
      page: cartsPage ?? meta("carts-page") ?? path
    };
  }

  // src/teach/drafts.js
  var Drafts = class {
    /** @param {import("./source.js").Told} told */
    constructor(told) {
      const { site, page: page2 } = place();
      this.hash = told.hash;
      this.before = `${page2}#`;
      this.store = openAll(`${site}~teacher`);
    }
    /** @returns {Promise<Draft | null>} of this version of the lesson */
    async current() {
      const found = await (await this.store).get(this.before + this.hash).catch(() => null);
      return isDraft(found) ? found : null;
    }
    /** @returns {Promise<Draft[]>} of earlier versions, the newest first */
    async earlier() {
      const all = await (await this.store).entries().catch(() => []);
      return all.filter(([key, value]) => key.startsWith(this.before) && isDraft(value)).map(([, value]) => (
        /** @type {Draft} */
        value
      )).filter((draft) => draft.hash !== this.hash).sort((a, b) => a.last < b.last ? 1 : -1);
    }
    /** Resolves with whether the browser keeps it beyond this visit. @param {string} text @param {string} base */
    async keep(text, base) {
      const store = await this.store;
      const draft = { text, base, last: (/* @__PURE__ */ new Date()).toISOString(), hash: this.hash };
      await store.put(this.before + this.hash, draft, true);
      return store.kind === "kept";
    }
    /** @param {string} hash */
    async forget(hash = this.hash) {
      await (await this.store).remove(this.before + hash);
    }
  };
  function isDraft(value) {
    return typeof value?.text === "string" && typeof value?.base === "string";
  }

  // src/teach/history.js
  var ONE_GO = 1500;
  var History = class {
    /** @type {string[]} */
    #past = [];
    /** @type {string[]} */
    #future = [];
    #where = "";
    #when = 0;
    /** @param {string} text */
    constructor(text) {
      this.text = text;
    }
    get canUndo() {
      return this.#past.length > 0;
    }
    get canRedo() {
      return this.#future.length > 0;
    }
    /** @param {string} text @param {string} where it was changed: further changes there are the same step */
    change(text, where) {
      if (text === this.text) return false;
      const now = Date.now();
      if (!where || where !== this.#where || now - this.#when > ONE_GO) this.#past.push(this.text);
      this.#where = where;
      this.#when = now;
      this.#future = [];
      this.text = text;
      return true;
    }
    undo() {
      this.#step(this.#past, this.#future);
    }
    redo() {
      this.#step(this.#future, this.#past);
    }
    /** @param {string[]} from @param {string[]} to */
    #step(from, to) {
      const text = from.pop();
      if (text === void 0) return;
      to.push(this.text);
      this.text = text;
      this.#where = "";
    }
  };

  // src/shared/dom.js
  function html(tag, className = "", text = "") {
    const made2 = document.createElement(tag);
    if (className) made2.className = className;
    if (text) made2.textContent = text;
    return made2;
  }
  function say(element, text) {
    if (element.textContent !== text) element.textContent = text;
  }

  // src/teach/formulas.js
  async function drawFormulas(root, assets) {
    const waiting2 = [...root.querySelectorAll(".arithmatex")].filter(
      (element) => !element.querySelector(".katex")
    );
    if (!waiting2.length) return;
    const page2 = (
      /** @type {any} */
      globalThis
    );
    if (!page2.katex) await loadKatex(assets);
    const { setAttribute } = Element.prototype;
    Element.prototype.setAttribute = function(name, value) {
      if (name === "style") this.style.cssText = value;
      else setAttribute.call(this, name, value);
    };
    try {
      for (const element of waiting2) {
        const source = (element.textContent ?? "").trim();
        const displayMode = source.startsWith("\\[");
        const tex = source.replace(/^\\[[(]|\\[\])]$/g, "");
        page2.katex.render(tex, element, { displayMode, throwOnError: false });
      }
    } finally {
      Element.prototype.setAttribute = setAttribute;
    }
  }
  function loadKatex(assets) {
    const style = document.createElement("link");
    style.rel = "stylesheet";
    style.href = new URL("katex/katex.min.css", assets).href;
    const script = document.createElement("script");
    script.src = new URL("katex/katex.min.js", assets).href;
    document.head.append(style, script);
    return new Promise((resolve, reject) => {
      script.onload = resolve;
      script.onerror = reject;
    });
  }

  // src/teach/page.js
  var STAYS2 = ".md-content__button, .carts-teach-door, .md-source-file, .carts-print-head";
  var OURS = "carts-scene, carts-map, carts-cost, carts-hard, carts-measured, carts-question, carts-quiz";
  var NAMES = {
    "carts-scene": "scene",
    "carts-question": "question",
    "carts-map": "map",
    "carts-measured": "bench"
  };
  var LessonPage = class {
    /** The elements of blocks by the key of their HTML. @type {Map<string, HTMLElement>} */
    #made = /* @__PURE__ */ new Map();
    /** The element of each block, in their order. @type {(HTMLElement | null)[]} */
    #blocks = [];
    #frame = "";
    /** @param {HTMLElement} article @param {string} assets @param {(index: number) => void} change asked for in the page */
    constructor(article, assets, change) {
      this.article = article;
      this.assets = assets;
      this.change = change;
    }
    /** @returns {string[]} keys of what the page has */
    get have() {
      return [...this.#made.keys()];
    }
    /** @param {number} index @returns {HTMLElement | null} */
    block(index) {
      return this.#blocks[index] ?? null;
    }
    /** The page as it was built is what this look at the published text shows. @param {Look} look */
    adopt(look) {
      const found = look.pieces.filter((piece) => piece.kind === "block").map((piece) => this.#byId(piece.id ?? ""));
      look.blocks.forEach((block, k) => {
        const element = found[k];
        if (element && block.key) this.#made.set(block.key, element);
      });
      this.#blocks = found;
      this.#frame = look.frame ?? "";
      this.#offer();
    }
    /** @param {Look} look */
    async show(look) {
      const before = this.#blocks;
      const ids = look.pieces.filter((piece) => piece.kind === "block").map((piece) => piece.id);
      const scenes = look.blocks.some((block) => block.html?.includes("<carts-scene"));
      const blocks = look.blocks.map((block, k) => this.#element(block, ids[k] ?? "", before[k]));
      look.blocks.forEach((block, k) => {
        const wrong = block.state === "wrong" || block.state === "needs";
        blocks[k]?.classList.toggle("carts-teach-old", wrong);
      });
      const same = look.frame === null || look.frame === this.#frame;
      if (same && blocks.length === before.length) {
        blocks.forEach((element, k) => {
          if (element && element !== before[k]) before[k]?.replaceWith(element);
        });
      } else if (look.frame !== null) this.#rebuild(look.frame, blocks);
      this.#frame = look.frame ?? this.#frame;
      this.#blocks = blocks;
      const used = new Set(look.blocks.map((block) => block.key));
      for (const key of this.#made.keys()) if (!used.has(key)) this.#made.delete(key);
      this.#offer();
      if (scenes) await this.#bringToLife();
      await drawFormulas(this.article, this.assets);
    }
    /** @param {import("./types.js").Shown} block @param {string} id @param {HTMLElement | null | undefined} old */
    #element(block, id, old) {
      const known = block.key ? this.#made.get(block.key) : void 0;
      if (known) return known;
      if (block.key && block.html) {
        const made2 = document.createElement("template");
        made2.innerHTML = block.html;
        const element = (
          /** @type {HTMLElement} */
          made2.content.firstElementChild
        );
        this.#made.set(block.key, element);
        return element;
      }
      return id && this.#byId(id) || old || null;
    }
    /** @param {string} frame @param {(HTMLElement | null)[]} blocks */
    #rebuild(frame, blocks) {
      const made2 = document.createElement("template");
      made2.innerHTML = frame;
      for (const place3 of made2.content.querySelectorAll("carts-place")) {
        const index = Number(
          /** @type {HTMLElement} */
          place3.dataset.block
        );
        const element = blocks[index];
        place3.replaceWith(element ?? html("p", "carts-teach-missing", "Seen after the build."));
      }
      const kept = [...this.article.children].filter((child) => child.matches(STAYS2));
      const foot = kept.filter((child) => child.matches(".carts-teach-door, .md-source-file"));
      const head = kept.filter((child) => !foot.includes(child));
      this.article.replaceChildren(...head, made2.content, ...foot);
    }
    /** A button before each block leads to its editor. */
    #offer() {
      for (const old of this.article.querySelectorAll(".carts-teach-change")) old.remove();
      this.#blocks.forEach((element, k) => {
        if (!element?.isConnected) return;
        const name = (
          /** @type {Record<string, string>} */
          NAMES[element.localName] ?? "block"
        );
        const button2 = html("button", "carts-button", `Change this ${name}`);
        button2.setAttribute("type", "button");
        button2.addEventListener("click", () => this.change(k));
        const row = html("p", "carts carts-teach-change");
        row.append(button2);
        element.before(row);
      });
    }
    /** A page that had no scene has not loaded their script. */
    async #bringToLife() {
      if (customElements.get("carts-scene")) return;
      const script = document.createElement("script");
      script.src = new URL("carts.js", this.assets).href;
      document.head.append(script);
    }
    /** @param {string} id @returns {HTMLElement | null} */
    #byId(id) {
      const found = id ? document.getElementById(id) : null;
      return found?.matches(OURS) ? found : null;
    }
  };

  // src/answers/parts.js
  function button(text, act, name = "") {
    const made2 = (
      /** @type {HTMLButtonElement} */
      html("button", `carts-button ${name}`.trim(), text)
    );
    made2.type = "button";
    made2.addEventListener("click", act);
    return made2;
  }
  function askingButton(text, question, yes, act, name) {
    const row = html("p", `carts-answers-asking ${name}`);
    const first = button(text, () => ask(true));
    const asked = html("span", "", `${question} `);
    const no = button(tr("No"), () => ask(false), "carts-answers-no");
    asked.append(button(yes, act, "carts-answers-yes"), " ", no);
    asked.hidden = true;
    row.append(first, asked);
    function ask(on) {
      first.hidden = on;
      asked.hidden = !on;
      (on ? no : first).focus();
    }
    return row;
  }

  // src/shared/download.js
  var FORGOTTEN_AFTER = 6e4;
  function download(name, text, type) {
    downloadBlob(name, new Blob([text], { type }));
  }
  function downloadBlob(name, blob) {
    const link = document.createElement("a");
    const address = URL.createObjectURL(blob);
    link.href = address;
    link.download = name;
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), FORGOTTEN_AFTER);
  }

  // src/teach/fields.js
  var PAUSE = 300;
  var made = 0;
  var Fields = class {
    /** @type {Map<string, {control: HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement, note: HTMLElement, field: Field, timer: number}>} */
    #rows = /* @__PURE__ */ new Map();
    #form = "";
    /** @param {(field: Field, value: string, owner: object) => Promise<string>} set */
    constructor(set) {
      this.set = set;
      this.root = html("div", "carts-teach-fields");
    }
    /** @param {Field[]} fields @param {import("./types.js").Finding[]} findings of the block */
    show(fields, findings) {
      const form = JSON.stringify(fields.map(({ path, kind, group }) => [path, kind, group]));
      if (form !== this.#form) this.#build(fields);
      this.#form = form;
      for (const field of fields) {
        const row = this.#rows.get(JSON.stringify(field.path));
        if (!row) continue;
        row.field = field;
        const [line, col] = field.place;
        const wrong = findings.some((one) => one.line === line && one.col === col);
        row.control.setAttribute("aria-invalid", String(wrong));
        if (row.control !== document.activeElement && row.control.value !== field.value) {
          row.control.value = field.value;
          this.#say(row, "");
        }
      }
    }
    /** @param {Field[]} fields */
    #build(fields) {
      const focused = [...this.#rows].find(([, { control }]) => control === document.activeElement);
      this.#rows.clear();
      this.root.replaceChildren();
      let group = "";
      let place3 = this.root;
      for (const field of fields) {
        if (field.group !== group || !field.group && place3 !== this.root) {
          group = field.group;
          place3 = this.root;
          if (group) {
            place3 = html("fieldset");
            place3.append(html("legend", "", group));
            this.root.append(place3);
          }
        }
        place3.append(this.#row(field));
      }
      if (focused) this.#rows.get(focused[0])?.control.focus();
    }
    /** @param {Field} field */
    #row(field) {
      const line = html("label", field.kind === "area" ? "carts-teach-wide" : "");
      const control = controlFor(field);
      control.value = field.value;
      const note = html("span", "carts-teach-note");
      made += 1;
      note.id = `carts-teach-note-${made}`;
      note.setAttribute("role", "status");
      control.setAttribute("aria-describedby", note.id);
      line.append(html("span", "carts-teach-label", field.label), control);
      const row = { control, note, field, timer: 0 };
      const take = () => {
        clearTimeout(row.timer);
        row.timer = 0;
        if (control.value !== row.field.value) void this.#take(row);
      };
      control.addEventListener("input", () => {
        clearTimeout(row.timer);
        row.timer = setTimeout(take, PAUSE);
      });
      control.addEventListener("change", take);
      this.#rows.set(JSON.stringify(field.path), row);
      const whole = html("div", "carts-teach-field");
      whole.append(line, note);
      return whole;
    }
    /** @param {{control: any, note: HTMLElement, field: Field}} row */
    async #take(row) {
      try {
        this.#say(row, await this.set(row.field, row.control.value, row));
      } catch (error) {
        this.#say(
          row,
          /** @type {Error} */
          error.message
        );
      }
    }
    /** @param {{control: HTMLElement, note: HTMLElement}} row @param {string} text */
    #say({ control, note }, text) {
      note.textContent = text;
      control.setAttribute("aria-invalid", String(text !== ""));
    }
  };
  function controlFor(field) {
    if (field.kind === "choice") {
      const select = document.createElement("select");
      select.append(...field.options.map((option) => new Option(option)));
      return select;
    }
    if (field.kind === "area") {
      const area = document.createElement("textarea");
      area.rows = Math.min(6, Math.max(2, Math.ceil(field.value.length / 48)));
      return area;
    }
    const input = document.createElement("input");
    input.type = "text";
    return input;
  }

  // src/teach/gutter.js
  var Gutter = class {
    /** @param {string} label @param {(text: string) => void} typed */
    constructor(label, typed) {
      this.root = html("div", "carts-teach-code");
      this.numbers = html("div", "carts-teach-numbers");
      this.numbers.setAttribute("aria-hidden", "true");
      this.area = document.createElement("textarea");
      this.area.setAttribute("aria-label", label);
      this.area.setAttribute("wrap", "off");
      this.area.spellcheck = false;
      this.area.addEventListener("input", () => {
        this.#count();
        typed(this.area.value);
      });
      this.root.append(this.numbers, this.area);
      this.first = 1;
      this.wrong = /* @__PURE__ */ new Set();
    }
    /** @param {string} text @param {number} first number of its first line @param {Set<number>} wrong lines */
    show(text, first, wrong) {
      const plain2 = text.replace(/\r\n?/g, "\n");
      if (this.area.value !== plain2) {
        const { selectionStart, selectionEnd } = this.area;
        this.area.value = plain2;
        this.area.setSelectionRange(selectionStart, selectionEnd);
      }
      this.first = first;
      this.wrong = wrong;
      this.area.setAttribute("aria-invalid", String(wrong.size > 0));
      this.#count();
    }
    /** @param {number} line number @param {number} col from 1 */
    goTo(line, col) {
      const lines = this.area.value.split("\n");
      const before = lines.slice(0, line - this.first).join("\n").length;
      const at = Math.min(before + (line > this.first ? 1 : 0) + col - 1, this.area.value.length);
      this.area.focus();
      this.area.setSelectionRange(at, at);
    }
    #count() {
      const count = this.area.value.replace(/\n$/, "").split("\n").length;
      this.area.rows = Math.max(2, count + (this.area.value.endsWith("\n") ? 1 : 0));
      const rows = [];
      for (let k = 0; k < count; k += 1) {
        const line = this.first + k;
        const bad = this.wrong.has(line);
        const row = html("span", bad ? "carts-teach-wrong" : "", `${bad ? "▸" : ""}${line}`);
        rows.push(row);
      }
      this.numbers.replaceChildren(...rows);
    }
  };

  // src/teach/piece.js
  var KINDS = {
    scene: "Scene",
    question: "Question",
    quiz: "Form",
    map: "Map",
    cost: "Costs",
    measured: "Real carts"
  };
  var PieceEditor = class {
    #fields;
    #filled = false;
    /**
     * @param {{typed: (text: string) => void, set: (field: import("./types.js").Field, value: string, owner: object) => Promise<string>, opened: () => void}} acts
     */
    constructor(acts) {
      this.root = document.createElement("details");
      this.root.className = "carts-teach-piece";
      this.summary = html("summary");
      this.kind = html("span", "carts-teach-kind");
      this.title = html("span", "carts-teach-title");
      this.mark = html("span", "carts-teach-mark");
      this.summary.append(this.kind, " ", this.title, " ", this.mark);
      this.root.append(this.summary);
      this.#fields = new Fields(acts.set);
      this.text = new Gutter("Text of this block", acts.typed);
      this.prose = document.createElement("textarea");
      this.prose.className = "carts-teach-prose";
      this.prose.setAttribute("aria-label", "Text in Markdown");
      this.prose.addEventListener("input", () => acts.typed(this.prose.value));
      this.asText = document.createElement("details");
      this.asText.className = "carts-teach-text";
      this.asText.append(html("summary", "", "As text"), this.text.root);
      this.mistakes = html("ul", "carts-teach-mistakes");
      this.piece = /** @type {Piece} */
      { kind: "text", text: "", line: 1 };
      this.findings = [];
      this.root.addEventListener("toggle", () => {
        if (!this.root.open) return;
        this.#fill();
        acts.opened();
      });
    }
    /** @returns {HTMLTextAreaElement} */
    get area() {
      return this.piece.kind === "text" ? this.prose : this.text.area;
    }
    /** @param {Piece} piece @param {Finding[]} findings @param {boolean} changed */
    show(piece, findings, changed) {
      this.piece = piece;
      this.findings = findings;
      say(this.kind, piece.kind === "block" ? KINDS[piece.name ?? ""] ?? "Block" : place2(piece));
      say(this.title, piece.kind === "block" ? titleOf(piece) : firstWords(piece.text));
      const count = findings.length;
      const wrong = count ? `${count} ${count === 1 ? "mistake" : "mistakes"}` : "";
      say(this.mark, [changed ? "changed" : "", wrong].filter(Boolean).join(", "));
      this.root.classList.toggle("carts-teach-has-mistake", count > 0);
      if (this.root.open) this.#fill();
    }
    /** What is inside is made when it is opened first, and kept up to date while it is open. */
    #fill() {
      const { piece, findings } = this;
      if (!this.#filled) {
        this.#filled = true;
        const inside = html("div", "carts-teach-inside");
        if (piece.kind === "block") inside.append(this.#fields.root, this.mistakes, this.asText);
        else if (piece.kind === "text") inside.append(this.prose, this.mistakes);
        else inside.append(this.text.root, this.mistakes);
        if (!piece.fields?.length) this.asText.open = true;
        this.root.append(inside);
      }
      this.#fields.show(piece.fields ?? [], findings);
      if (piece.kind === "text") {
        const plain2 = piece.text.replace(/\r\n?/g, "\n");
        if (this.prose.value !== plain2) this.prose.value = plain2;
        this.prose.rows = Math.max(3, Math.ceil(plain2.length / 50) + plain2.split("\n").length / 2);
      } else this.text.show(piece.text, piece.line, new Set(findings.map((finding) => finding.line)));
      this.#list(findings);
    }
    /** @param {Finding[]} findings */
    #list(findings) {
      const rows = findings.map((finding) => {
        const row = html("li");
        const go = html("button", "carts-button", `line ${finding.line}`);
        go.setAttribute("type", "button");
        go.addEventListener("click", () => this.goTo(finding));
        row.append(go, " ", html("span", "carts-teach-message", finding.message));
        if (finding.hint) row.append(" ", html("span", "carts-teach-hint", finding.hint));
        row.dataset.place = `${finding.file}:${finding.line}:${finding.col}`;
        return row;
      });
      this.mistakes.replaceChildren(...rows);
      this.mistakes.hidden = rows.length === 0;
      if (rows.length && !this.piece.fields?.length) this.asText.open = true;
    }
    /** @param {Finding} finding */
    goTo({ line, col }) {
      this.root.open = true;
      this.asText.open = true;
      if (this.piece.kind === "text") this.prose.focus();
      else this.text.goTo(line, col);
    }
  };
  var place2 = (piece) => piece.kind === "top" ? "Facts" : "Text";
  function titleOf(piece) {
    const words = piece.title || piece.id || piece.text.split("\n")[0] || "";
    return words.length > 70 ? `${words.slice(0, 70)}…` : words;
  }
  function firstWords(text) {
    const heading = /^#+ +([^{\n]+)/m.exec(text)?.[1];
    const words = (heading ?? text).replace(/[*_`#>]|^!!! \w+ /gm, "").trim().split("\n")[0] ?? "";
    return words.length > 70 ? `${words.slice(0, 70)}…` : words || "(empty lines)";
  }

  // src/teach/saves.js
  function toolbar(session2, tell) {
    const root = html("div", "carts-teach-tools");
    const undo = button("Undo", () => session2.undo(), "carts-teach-undo");
    const redo = button("Redo", () => session2.redo(), "carts-teach-redo");
    const warn = () => session2.look?.findings.length ? " There are mistakes in it: the build would stop at them." : "";
    const save = button(
      "Save lesson",
      () => {
        download(session2.name, session2.text, "text/markdown");
        tell(`Saved as ${session2.name}: look in your folder “Downloads”.${warn()}`);
      },
      "carts-teach-save"
    );
    const zip = button(
      "Save as zip",
      async () => {
        const name = session2.name.replace(/\.md$/, ".zip");
        try {
          const bytes = Uint8Array.from(atob(await session2.zip()), (letter) => letter.charCodeAt(0));
          downloadBlob(name, new Blob([bytes], { type: "application/zip" }));
          tell(`Saved as ${name}, with a list of what was changed.${warn()}`);
        } catch (error) {
          tell(
            /** @type {Error} */
            error.message
          );
        }
      },
      "carts-teach-zip"
    );
    const reset = askingButton(
      "Published lesson",
      "Go back to the lesson as it was published?",
      "Yes, go back",
      () => session2.reset(),
      "carts-teach-reset"
    );
    root.append(undo, redo, save, zip, reset);
    const draw = () => {
      undo.disabled = !session2.history.canUndo;
      redo.disabled = !session2.history.canRedo;
    };
    draw();
    return { root, draw };
  }
  function ownFile(words, take) {
    const label = html("label", "carts-teach-own");
    const input = document.createElement("input");
    input.type = "file";
    input.accept = ".md,text/markdown";
    input.addEventListener("change", async () => {
      const file = input.files?.[0];
      if (!file) return;
      const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
      take(decoder.decode(await file.arrayBuffer()), file.name);
    });
    label.append(html("span", "", words), " ", input);
    return label;
  }

  // src/teach/panel.js
  var Panel = class {
    /** @type {PieceEditor[]} */
    #editors = [];
    /** @type {import("./types.js").Piece[]} */
    #pieces = [];
    /** @type {Set<string>} texts of the published pieces */
    #published = /* @__PURE__ */ new Set();
    #base = "";
    /** @param {import("./session.js").Session} session */
    constructor(session2) {
      this.session = session2;
      this.root = html("aside", "carts carts-teach");
      this.root.setAttribute("aria-label", "Change this lesson");
      this.heading = html("h2", "", "Change this lesson");
      this.heading.tabIndex = -1;
      const small = button("Make room", () => this.#fold(small), "carts-teach-fold");
      small.setAttribute("aria-expanded", "true");
      const close = button("Close", () => session2.close(), "carts-teach-close");
      const head = html("div", "carts-teach-head");
      head.append(this.heading, small, close);
      this.note = html("p", "carts-teach-status");
      this.note.setAttribute("role", "status");
      this.state = html("p", "carts-teach-state");
      this.state.setAttribute("role", "status");
      this.tools = toolbar(session2, (text) => this.status(text));
      this.notices = html("div", "carts-teach-notices");
      this.list = html("div", "carts-teach-pieces");
      const body = html("div", "carts-teach-body");
      body.append(this.tools.root, this.note, this.state, this.notices, this.list);
      this.root.append(head, body);
      if (session2.withheld) this.#withheld();
    }
    /** @param {HTMLButtonElement} small */
    #fold(small) {
      const folded = this.root.classList.toggle("carts-teach-folded");
      document.body.classList.toggle("carts-teaching-folded", folded);
      small.setAttribute("aria-expanded", String(!folded));
      small.textContent = folded ? "Show" : "Make room";
    }
    get #unchanged() {
      return this.session.told.text === null ? "As in your file." : "As published.";
    }
    focus() {
      this.heading.focus();
    }
    /** @param {string} text */
    status(text) {
      say(this.note, text);
    }
    /** Whether the draft is on this computer. @param {boolean} kept */
    kept(kept) {
      const words = kept ? "Draft kept in this browser." : "This browser keeps no drafts: save often.";
      say(this.state, this.session.changed ? words : this.#unchanged);
      this.root.dataset.kept = String(kept);
    }
    /** The text was changed: what can be told before Python has looked. */
    follow() {
      this.root.dataset.state = "looking";
      this.tools.draw();
    }
    /** The page shows the text as it is. */
    drawn() {
      this.root.dataset.state = "ready";
    }
    /** @param {Look} look */
    take(look) {
      const { pieces, findings } = look;
      if (this.#base !== this.session.base && this.session.text === this.session.base) {
        this.#base = this.session.base;
        this.#published = new Set(pieces.map((piece) => piece.text));
      }
      if (shape(pieces) !== shape(this.#pieces)) this.#build(pieces);
      this.#pieces = pieces;
      const file = this.session.told.file;
      pieces.forEach((piece, k) => {
        const next = pieces[k + 1]?.line ?? Number.POSITIVE_INFINITY;
        const own = findings.filter(
          ({ line, file: where }) => where === file && line >= piece.line && line < next
        );
        const last = k === pieces.length - 1;
        const others = last ? findings.filter(({ file: where }) => where !== file) : [];
        const changed = this.#published.size > 0 && !this.#published.has(piece.text);
        this.#editors[k]?.show(piece, [...own, ...others], changed);
      });
      const count = findings.length;
      this.root.dataset.mistakes = String(count);
      const words = count === 1 ? "1 mistake" : `${count} mistakes`;
      if (count) this.status(`${words}: the page shows these parts as they were before.`);
      else if (this.note.textContent?.includes("the page shows these parts")) this.status("");
      if (!this.state.textContent) say(this.state, this.#unchanged);
      this.tools.draw();
    }
    /** @param {import("./types.js").Piece[]} pieces */
    #build(pieces) {
      const open2 = new Set(
        this.#editors.filter((e) => e.root.open).map((e) => e.piece.id || e.piece.line)
      );
      const typing = this.#editors.find((editor) => editor.area === document.activeElement);
      const before = typing ? this.#editors.indexOf(typing) : -1;
      let at = typing?.area.selectionStart ?? 0;
      for (let k = 0; k < before; k += 1) at += plain(this.#pieces[k]?.text ?? "").length;
      this.#editors = pieces.map((piece, k) => {
        const editor = new PieceEditor({
          typed: (text) => this.#typed(k, text),
          set: (field, value, owner) => this.session.set(this.#blockOf(k), field, value, owner),
          opened: () => this.session.page.block(this.#blockOf(k))?.scrollIntoView({ block: "start" })
        });
        editor.piece = piece;
        editor.root.open = open2.has(piece.id || piece.line);
        return editor;
      });
      this.list.replaceChildren(...this.#editors.map((editor) => editor.root));
      if (before < 0) return;
      for (const [k, piece] of pieces.entries()) {
        const { length } = plain(piece.text);
        if (at <= length) return this.#caret(k, at);
        at -= length;
      }
    }
    /** @param {number} k @param {number} at */
    #caret(k, at) {
      const editor = this.#editors[k];
      if (!editor) return;
      editor.root.open = true;
      queueMicrotask(() => {
        editor.asText.open = true;
        editor.area.focus();
        editor.area.setSelectionRange(at, at);
      });
    }
    /** @param {number} k @param {string} typed */
    #typed(k, typed) {
      const piece = this.#pieces[k];
      if (!piece) return;
      const ends = piece.text.includes("\r\n") ? typed.replaceAll("\n", "\r\n") : typed;
      const texts = this.#pieces.map(({ text }, other) => other === k ? ends : text);
      this.#pieces = this.#pieces.map((one, other) => other === k ? { ...one, text: ends } : one);
      this.session.change(texts.join(""), `piece ${k}`);
    }
    /** The number of a piece's block among the blocks. @param {number} k */
    #blockOf(k) {
      if (this.#pieces[k]?.kind !== "block") return -1;
      return this.#pieces.slice(0, k).filter((piece) => piece.kind === "block").length;
    }
    /** Opens the editor of a block. @param {number} index among the blocks */
    openBlock(index) {
      const editor = this.#editors.filter(({ piece }) => piece.kind === "block")[index];
      if (!editor) return;
      editor.root.open = true;
      editor.root.scrollIntoView({ block: "start" });
      editor.summary.focus();
    }
    #withheld() {
      const words = `Notes and marking guides for teachers are not in this page. To have them in what you save, choose your own file of the lesson (${this.session.name}):`;
      this.notices.append(ownFile(words, (text) => void this.session.takeOwn(text)));
    }
    /** @param {number} missing @param {boolean} same whether it is the published file */
    ownTaken(missing, same) {
      this.notices.replaceChildren();
      if (missing) {
        this.status(`${missing} notes or marking guides do not stand in this file.`);
        this.#withheld();
      } else if (same)
        this.status("Your file is the published one: notes and marking guides are back.");
      else
        this.status("Notes and marking guides are back. Your file differs from the published one.");
    }
    /** A lesson whose text is not in the site. */
    askForFile() {
      this.root.dataset.state = "asks";
      this.tools.root.hidden = true;
      const words = `This lesson has a test, so its text is not in the site. Choose your own file (${this.session.name}):`;
      this.notices.replaceChildren(
        ownFile(words, (text) => {
          this.tools.root.hidden = false;
          this.notices.replaceChildren();
          void this.session.takeOwn(text);
        })
      );
    }
    /** @param {import("./drafts.js").Draft[]} drafts */
    offerEarlier(drafts) {
      for (const draft of drafts) {
        const row = html("p", "carts-teach-earlier");
        const date = new Date(draft.last).toLocaleString([], {
          dateStyle: "medium",
          timeStyle: "short"
        });
        row.append(
          `You have a draft of an earlier version of this lesson, of ${date}. `,
          button("Open it", () => this.session.change(draft.text, ""), "carts-teach-older"),
          " ",
          button("Save it", () => download(this.session.name, draft.text, "text/markdown")),
          " ",
          button("Delete it", () => {
            void this.session.drafts.forget(draft.hash);
            row.remove();
          })
        );
        this.notices.append(row);
      }
    }
    /** The whole text can still be changed and saved. @param {string} why */
    withoutPython(why) {
      this.status(`${why} The text is not checked here, and the page does not follow.`);
      const editor = new PieceEditor({
        typed: (text) => this.session.change(text, "all"),
        set: async () => "",
        opened: () => {
        }
      });
      editor.show({ kind: "top", text: this.session.text, line: 1 }, [], false);
      editor.root.open = true;
      this.list.replaceChildren(editor.root);
      this.root.dataset.state = "unchecked";
    }
  };
  var shape = (pieces) => pieces.map(({ kind, name, id }) => `${kind} ${name} ${id}`).join("\n");
  var plain = (text) => text.replace(/\r\n?/g, "\n");

  // src/teach/source.js
  async function loadLesson(address) {
    const page2 = (
      /** @type {any} */
      globalThis
    );
    await new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = address;
      script.onload = resolve;
      script.onerror = () => reject(new Error("the lesson's text is missing in this site"));
      document.head.append(script);
    });
    const packed = page2.__cartsLesson;
    delete page2.__cartsLesson;
    const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
    const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
    return JSON.parse(decoder.decode(await gunzip([bytes])));
  }
  async function hashOf(text) {
    if (!globalThis.crypto?.subtle) return "";
    const bytes = new TextEncoder().encode(text);
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  }

  // src/teach/session.js
  var PAUSE2 = 250;
  var BODY = "carts-teaching";
  var Session = class {
    #looking = {};
    #timer = 0;
    /** Resolves when Python has seen the text as it is now, and the page shows it. */
    settled = Promise.resolve();
    /** @type {Look | null} */
    look = null;
    #asked = false;
    #working = false;
    /**
     * @param {{told: import("./source.js").Told, client: import("../runtime/client.js").Client, assets: string,
     *   drafts: import("./drafts.js").Drafts, link: HTMLElement}} given
     */
    constructor({ told, client, assets, drafts, link }) {
      this.told = told;
      this.client = client;
      this.drafts = drafts;
      this.link = link;
      this.base = told.text ?? "";
      this.history = new History(this.base);
      this.withheld = told.withheld;
      const article = (
        /** @type {HTMLElement} */
        link.closest("article") ?? document.body
      );
      this.page = new LessonPage(article, assets, (k) => this.panel.openBlock(k));
      this.panel = new Panel(this);
    }
    get text() {
      return this.history.text;
    }
    get changed() {
      return this.text !== this.base;
    }
    get name() {
      return this.told.file.split("/").at(-1) ?? "lesson.md";
    }
    /** Opens the panel; shows the published text first, so that the page's own elements are known. */
    async open() {
      this.show();
      scrollTo(0, 0);
      if (this.told.text === null) return this.panel.askForFile();
      this.panel.status("Starting Python …");
      await this.#begin();
    }
    /** @param {boolean} published whether the text is the one that the page was built from */
    async #begin(published = true) {
      try {
        let look = await this.#ask();
        this.#take(look);
        const show = async () => published ? this.page.adopt(look) : await this.page.show(look);
        for (await show(); look.more || await this.#got(look); await show()) {
          look = await this.#ask();
          this.#take(look);
        }
      } catch (error) {
        const { message, detail } = (
          /** @type {Error & {detail?: string}} */
          error
        );
        console.warn(message, detail ?? "");
        return this.panel.withoutPython(message);
      }
      const draft = await this.drafts.current();
      if (draft && draft.text !== this.text) {
        this.base = draft.base;
        this.withheld = this.withheld && draft.base === this.told.text;
        this.history.change(draft.text, "");
        this.panel.status(`Your draft of ${when(draft.last)} is back.`);
        this.panel.kept(true);
        await this.lookNow();
      } else this.panel.status("");
      this.panel.offerEarlier(await this.drafts.earlier());
      this.panel.root.dataset.state = "ready";
    }
    show() {
      document.body.classList.add(BODY);
      if (!this.panel.root.isConnected) document.body.append(this.panel.root);
      this.panel.root.hidden = false;
      this.panel.focus();
    }
    close() {
      this.panel.root.hidden = true;
      document.body.classList.remove(BODY);
      const address = new URL(location.href);
      address.searchParams.delete("teacher");
      if (address.hash === "#teacher") address.hash = "";
      history.replaceState(null, "", address.href.replace(/#$/, ""));
      this.link.focus();
    }
    /** The text was changed. @param {string} text @param {string} where @param {number} pause ms until Python looks */
    change(text, where, pause = PAUSE2) {
      if (this.history.change(text, where)) this.#changed(pause);
    }
    undo() {
      this.history.undo();
      this.#changed();
    }
    redo() {
      this.history.redo();
      this.#changed();
    }
    /** Back to the text as it was published, as a change that can be undone. */
    reset() {
      this.change(this.base, "");
      void this.drafts.forget().catch(() => {
      });
    }
    #changed(pause = PAUSE2) {
      this.panel.follow();
      void this.#keep();
      clearTimeout(this.#timer);
      this.settled = new Promise((resolve) => {
        this.#timer = setTimeout(() => resolve(this.lookNow()), pause);
      });
    }
    async #keep() {
      try {
        const kept = this.changed ? await this.drafts.keep(this.text, this.base) : await this.drafts.forget().then(() => true);
        this.panel.kept(kept);
      } catch {
        this.panel.kept(false);
      }
    }
    /** Python looks at the text as it is now; then page and panel show it. */
    async lookNow() {
      if (this.#working) return;
      this.#working = true;
      try {
        for (let more = true; more; ) {
          const text = this.text;
          const look = await this.#ask();
          if (text !== this.text) continue;
          this.#take(look);
          await this.page.show(look);
          more = look.more || await this.#got(look) || text !== this.text;
        }
        this.panel.drawn();
      } catch (error) {
        this.panel.status(
          /** @type {Error} */
          error.message
        );
      } finally {
        this.#working = false;
      }
    }
    /** @param {Look} look */
    #take(look) {
      this.look = look;
      this.panel.take(look);
    }
    /** @returns {Promise<Look>} */
    async #ask() {
      const { lesson, files } = this.told;
      const { header } = await this.client.ask(this.#looking, () => ({
        kind: "teach",
        do: "look",
        text: this.text,
        lesson,
        files,
        have: this.page.have
      }));
      return (
        /** @type {any} */
        header
      );
    }
    /** Loads what a scene needs beside bare Python, once. @param {Look} look */
    async #got(look) {
      if (!look.needs.length || this.#asked) return false;
      this.#asked = true;
      try {
        await this.client.need(look.needs);
        return true;
      } catch {
        this.panel.status(
          "A scene here needs numpy and scipy, which this site has not packed. The build will pack them."
        );
        return false;
      }
    }
    /** One value of a block. @param {number} block @param {Field} field @param {string} value @param {object} owner @returns {Promise<string>} why not; empty: done */
    async set(block, field, value, owner) {
      for (; ; ) {
        const { header, sent } = await this.client.ask(owner, () => ({
          kind: "teach",
          do: "set",
          text: this.text,
          block,
          path: field.path,
          value
        }));
        const answer = (
          /** @type {any} */
          header
        );
        if (answer.refused) return answer.refused;
        if (sent.text !== this.text) continue;
        this.change(answer.text, `${block} ${field.path.join(".")}`, 0);
        return "";
      }
    }
    /** The teacher's own file: the whole lesson, with what was kept out of the site. @param {string} own */
    async takeOwn(own) {
      if (this.told.text === null) {
        this.base = own;
        this.history = new History(own);
        this.panel.status("Starting Python …");
        return this.#begin(await hashOf(own) === this.told.hash);
      }
      const { header } = await this.client.ask({}, () => ({
        kind: "teach",
        do: "restore",
        text: this.text,
        own
      }));
      const { text, missing } = (
        /** @type {any} */
        header
      );
      const same = await hashOf(own) === this.told.hash;
      if (same) this.base = own;
      this.withheld = missing > 0;
      this.change(text, "");
      this.panel.ownTaken(missing, same);
    }
    /** @returns {Promise<string>} a zip in base64 */
    async zip() {
      const { header } = await this.client.ask({}, () => ({
        kind: "teach",
        do: "zip",
        file: this.told.file,
        text: this.text,
        published: this.base
      }));
      return (
        /** @type {any} */
        header.base64
      );
    }
  };
  function when(time) {
    const date = new Date(time);
    return date.toLocaleString([], { dateStyle: "medium", timeStyle: "short" });
  }

  // src/teacher-main.js
  var PACKAGE = "newtons-carts-teacher";
  var session = null;
  async function begin() {
    const link = (
      /** @type {HTMLElement} */
      document.querySelector(".carts-teach-door a")
    );
    const address = new URL(link.dataset.lesson ?? "", document.baseURI).href;
    const assets = new URL("../", address).href;
    const told = await loadLesson(address);
    const base = new URL(`runtime/${new URL(address).search}`, assets).href;
    const client = new Client((more) => startRuntime({ base, packages: [PACKAGE, ...more] }));
    const made2 = new Session({ told, client, assets, drafts: new Drafts(told), link });
    await made2.open();
    return made2;
  }
  document.addEventListener(OPEN, () => {
    const missing = missingFeatures();
    if (missing.length) {
      const link = document.querySelector(".carts-teach-door a");
      if (link) link.textContent = `This browser is too old for it (missing: ${missing.join(", ")})`;
      return;
    }
    if (session) void session.then((open2) => open2.show());
    else {
      session = begin();
      session.catch((error) => {
        session = null;
        const link = document.querySelector(".carts-teach-door a");
        if (link) link.textContent = `Teacher mode cannot be opened: ${error.message}`;
      });
    }
  });
})();
