"use strict";
(() => {
  // src/runtime/client.js
  var RESTARTS = 3;
  var Client = class extends EventTarget {
    state = "idle";
    error = null;
    #runtime = null;
    #waiting = [];
    #flying = null;
    #restarts = 0;
    #lastId = 0;
    #more = [];
    #growing = Promise.resolve();
    constructor(start) {
      super();
      this.start = start;
    }
    wake() {
      if (this.state === "idle") void this.#boot();
    }
    need(names) {
      if (this.#has(names)) return Promise.resolve();
      const needed = this.#growing.then(() => this.#grow(names));
      this.#growing = needed.catch(() => {
      });
      return needed;
    }
    #has(names) {
      return names.every((name) => this.#more.includes(name));
    }
    async #grow(names) {
      if (this.#has(names)) return;
      this.wake();
      await this.#settled();
      if (this.state === "failed") throw this.error;
      const more = [.../* @__PURE__ */ new Set([...this.#more, ...names])];
      this.#use(await this.start(more));
      this.#more = more;
      this.#become("ready");
      this.#next();
    }
    #settled() {
      if (this.state !== "starting") return Promise.resolve();
      return new Promise((resolve) => {
        this.addEventListener("state", () => resolve(this.#settled()), { once: true });
      });
    }
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
          if (error?.reason !== "request-failed") return this.#lost(runtime, error);
          if (!landed()) return;
          for (const { reject } of job.settle) reject(error);
          this.#next();
        }
      );
    }
    async #boot() {
      const more = this.#more;
      this.#become("starting");
      try {
        const runtime = await this.start(more);
        if (more !== this.#more) return runtime.stop();
        this.#use(runtime);
        this.#become("ready");
        this.#next();
      } catch (error) {
        if (more === this.#more) this.#fail(error);
      }
    }
    #lost(runtime, reason) {
      if (runtime !== this.#runtime) return;
      this.#runtime = null;
      runtime.stop();
      this.#takeBack();
      this.#restarts += 1;
      if (this.#restarts > RESTARTS) this.#fail(reason);
      else void this.#boot();
    }
    #use(runtime) {
      const older = this.#runtime;
      runtime.onlost = (reason) => this.#lost(runtime, reason);
      this.#runtime = runtime;
      older?.stop();
      this.#takeBack();
    }
    #takeBack() {
      const job = this.#flying;
      this.#flying = null;
      if (!job) return;
      const newer = this.#waiting.find(({ owner }) => owner === job.owner);
      if (newer) newer.settle.unshift(...job.settle);
      else this.#waiting.unshift(job);
    }
    #fail(reason) {
      this.error = reason instanceof Error ? reason : new Error(String(reason ?? "the worker stopped"));
      this.#become("failed");
      for (const { settle } of this.#waiting.splice(0)) {
        for (const { reject } of settle) reject(this.error);
      }
    }
    #become(state) {
      this.state = state;
      this.dispatchEvent(new Event("state"));
    }
  };

  // ../view/language.js
  var catalogue = globalThis.cartsWords ?? {};
  var FORMS = "\0";
  var RULE = catalogue["\0"] ?? "";
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function counted(one, more, n, values = {}) {
    return filled(form(one, more, n), { n, ...values });
  }
  function form(one, more, n) {
    const ours = catalogue[more]?.split(FORMS);
    if (!ours) return n === 1 ? one : more;
    const english = n === 1 ? 0 : 1;
    const asked = RULE ? Number(RULE[n < RULE.length ? n : 100 + n % 100]) : english;
    return String(ours[Math.min(asked, ours.length - 1)]);
  }
  function told(sentence) {
    if (typeof sentence === "string") return catalogue[sentence] ?? sentence;
    const values = Object.entries(sentence.values).map(([name, value]) => [name, told(value)]);
    const { code, one } = sentence;
    const n = Number(String(sentence.values.n).replace(/,/g, ""));
    const template = one ? form(one, code, n) : catalogue[code] ?? code;
    return filled(template, Object.fromEntries(values));
  }
  function inRow(parts) {
    const [head2 = "", ...tail] = parts;
    return tail.reduce((first, second) => tr("{first}, {second}", { first, second }), head2);
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole2, name) => String(values[name] ?? whole2));
  }

  // src/runtime/line.js
  var PAUSES = [1e3, 2e3, 4e3];
  var AT_ONCE = 2;
  var isOnWeb = () => /^https?:$/.test(globalThis.location?.protocol ?? "");
  var isFetching = () => isOnWeb() && !globalThis.__cartsInside;
  async function areKept(addresses) {
    if (!globalThis.navigator?.serviceWorker?.controller) return false;
    const asked = addresses.map((one) => caches.match(one, { ignoreSearch: true }));
    return (await Promise.all(asked).catch(() => [null])).every(Boolean);
  }
  async function persistently(ask, pauses = isOnWeb() ? PAUSES : []) {
    for (const pause of pauses) {
      try {
        return await ask();
      } catch {
        await new Promise((resolve) => setTimeout(resolve, pause));
      }
    }
    return ask();
  }
  var Line = class {
    constructor(atOnce = isFetching() ? AT_ONCE : Number.POSITIVE_INFINITY) {
      this.free = atOnce;
      this.waiting = [];
    }
    async take(task) {
      if (this.free > 0) this.free -= 1;
      else await new Promise((resolve) => this.waiting.push(() => resolve(void 0)));
      try {
        return await task();
      } finally {
        const next = this.waiting.shift();
        if (next) next();
        else this.free += 1;
      }
    }
  };

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
      "This browser is too old to run Python. Try Chrome or Edge 103, Firefox 113, Safari 16.4, or newer."
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
    "request-failed": tr("This cannot be computed with these values."),
    stalled: tr("Python does not answer. Close other programs and load the page again."),
    stopped: tr("Python was stopped.")
  };
  var CAME_NOT = tr("The network was interrupted, or this site was renewed: load the page again.");
  var ON_WEB = {
    "payload-missing": CAME_NOT,
    "payload-damaged": CAME_NOT,
    "python-failed": tr("Python could not start. Load the page again, or try another browser.")
  };
  var told2 = (reason) => isOnWeb() && ON_WEB[reason] || MESSAGES[reason];
  var RuntimeFailure = class extends Error {
    constructor(reason, detail = "", file = "") {
      super(told2(reason) ?? told2("python-failed"));
      this.name = "RuntimeFailure";
      this.reason = reason;
      this.detail = detail;
      this.file = file;
    }
  };

  // src/runtime/leaving.js
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
  var SLOW_AFTER = 3;
  var PATIENCE = 8;
  var AT_WORK = 60;
  var LOST = 60;
  var HELD = 180;
  function watch(patience, late) {
    let [left, spent] = [patience, 0];
    const timer = setInterval(() => {
      left -= 1;
      spent += 1;
      if (left > 0) return;
      clearInterval(timer);
      late();
    }, SECOND);
    return {
      get spent() {
        return spent;
      },
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
  var runScript = (src, name) => persistently(() => runOnce(src, name));
  function runOnce(src, name) {
    return new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = src;
      script.async = true;
      const missing = () => reject(new RuntimeFailure("payload-missing", src, name));
      const settle = (then) => () => {
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
  function indexOf(base) {
    return new URL(`index.js${new URL(base).search}`, base).href;
  }
  function patiently(promise) {
    if (isOnWeb()) return promise;
    return new Promise((resolve, reject) => {
      const waiting2 = watch(PATIENCE, () => reject(new RuntimeFailure("stalled", "index.js")));
      promise.then(resolve, reject).finally(waiting2.stop);
    });
  }
  function loadIndex(base) {
    const known = indexes.get(base);
    if (known) return known;
    const inside4 = Boolean(page.__cartsInside);
    const read = inside4 ? Promise.resolve() : patiently(runScript(indexOf(base), "index.js"));
    const loading = read.then(() => {
      const index = page.__cartsRuntime;
      if (!inside4) delete page.__cartsRuntime;
      if (!index) throw new RuntimeFailure("payload-damaged", "index.js", "index.js");
      if (!index.files) throw new RuntimeFailure("not-packed", index.missing);
      return index;
    });
    loading.catch(() => indexes.delete(base));
    indexes.set(base, loading);
    return loading;
  }
  async function loadPart(base, name, number, part) {
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
  async function checkedPart(address, name, number, part) {
    const inside4 = Boolean(page.__cartsInside);
    if (!inside4) await runScript(address, name);
    const key = `${name}.${number}`;
    const text2 = page.__cartsParts?.[key];
    if (text2 === void 0) throw new RuntimeFailure("payload-damaged", part.src, name);
    if (!inside4) delete page.__cartsParts[key];
    const bytes = decode(text2, part.src, name);
    if (bytes.length !== part.size || !await matches(bytes, part.sha256)) {
      throw new RuntimeFailure("payload-damaged", part.src, name);
    }
    return bytes;
  }
  function decode(text2, src, name) {
    try {
      const fast = Uint8Array;
      return fast.fromBase64 ? fast.fromBase64(text2) : Uint8Array.from(atob(text2), (letter) => letter.charCodeAt(0));
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
    const written3 = Promise.all([...parts.map((part) => writer.write(part)), writer.close()]);
    const [bytes] = await Promise.all([new Response(zip.readable).arrayBuffer(), written3]);
    return bytes;
  }

  // as-text:src/runtime/unpacker.js
  var unpacker_default = '"use strict";\n(() => {\n  // src/runtime/unpacker.js\n  var writers = /* @__PURE__ */ new Map();\n  function begin(name) {\n    const zip = new DecompressionStream("gzip");\n    const tell = (bytes) => self.postMessage({ name, bytes }, { transfer: [bytes] });\n    const damaged = (error) => self.postMessage({ name, error: String(error) });\n    new Response(zip.readable).arrayBuffer().then(tell, damaged);\n    return zip.writable.getWriter();\n  }\n  self.onmessage = ({ data: { name, bytes, last } }) => {\n    const writer = writers.get(name) ?? begin(name);\n    writers.set(name, writer);\n    writer.write(bytes).catch(() => {\n    });\n    if (last) writer.close().catch(() => {\n    });\n  };\n})();\n';

  // src/runtime/unpack.js
  function workerOf(texts) {
    const address = URL.createObjectURL(new Blob(texts, { type: "text/javascript" }));
    try {
      return { worker: new Worker(address), address };
    } catch (error) {
      throw new RuntimeFailure("worker-refused", String(error));
    }
  }
  var Unpacker = class {
    constructor(reject) {
      const { worker, address } = workerOf([unpacker_default]);
      this.worker = worker;
      this.address = address;
      this.waiting = /* @__PURE__ */ new Map();
      worker.onmessage = ({ data }) => {
        if (data.bytes) this.waiting.get(data.name)?.(data.bytes);
        else reject(new RuntimeFailure("payload-damaged", data.error, data.name));
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new RuntimeFailure("worker-refused", event.message));
      };
    }
    async unpack(name, parts) {
      const unpacked = new Promise((resolve) => this.waiting.set(name, resolve));
      for (const [number, part] of parts.entries()) {
        const bytes = await part;
        this.worker.postMessage({ name, bytes, last: number === parts.length - 1 }, [bytes.buffer]);
      }
      return unpacked;
    }
    stop() {
      this.worker.terminate();
      URL.revokeObjectURL(this.address);
    }
  };

  // src/runtime/memory.js
  var isOutOfMemory = (error) => error instanceof RangeError || /memory|allocat/i.test(String(error));

  // src/runtime/wasm.js
  var NOTHING = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]);
  function requireWasm() {
    if (typeof WebAssembly !== "object") throw new RuntimeFailure("no-wasm");
    try {
      new WebAssembly.Module(NOTHING);
    } catch (error) {
      const old = !("findLast" in Array.prototype);
      throw new RuntimeFailure(old ? "too-old" : "wasm-refused", String(error));
    }
  }
  function compileFailure(error) {
    const reason = isOutOfMemory(error) ? "no-memory" : "too-old";
    return new RuntimeFailure(reason, String(error), "pyodide.asm.wasm");
  }
  async function compile(parts) {
    const zip = new DecompressionStream("gzip");
    const headers = { "Content-Type": "application/wasm" };
    const compiled = WebAssembly.compileStreaming(new Response(zip.readable, { headers }));
    const written3 = write(zip.writable.getWriter(), parts);
    const [module] = await Promise.all([compiled, written3]);
    return module;
  }
  async function write(writer, parts) {
    for (const part of parts) await writer.write(await part);
    await writer.close();
  }

  // as-text:src/runtime/worker.js
  var worker_default = '"use strict";\n(() => {\n  // src/runtime/memory.js\n  var isOutOfMemory = (error) => error instanceof RangeError || /memory|allocat/i.test(String(error));\n  var isNotAllocated = (error) => error instanceof RangeError && /memory|allocat/i.test(error.message);\n\n  // src/runtime/picture.js\n  function putPicture(memory, picture) {\n    const words = new Uint32Array(picture.buffer, picture.byteOffset, picture.byteLength >> 2);\n    const [size, filled, sum, count] = words;\n    if (memory.length !== size) throw new Error(`${memory.length} bytes of memory, not ${size}`);\n    const stretches = words.subarray(4, 4 + 2 * count);\n    if (sumBetween(memory, stretches, filled) !== sum) throw new Error("another machine code");\n    let from = 4 * (4 + 2 * count);\n    let last = filled;\n    for (let i = 0; i < stretches.length; i += 2) {\n      const [start, end] = stretches.subarray(i, i + 2);\n      if (start > last) memory.fill(0, last, start);\n      memory.set(picture.subarray(from, from + end - start), start);\n      from += end - start;\n      last = Math.max(last, end);\n    }\n  }\n  function sumBetween(memory, stretches, filled) {\n    const words = new Uint32Array(memory.buffer, memory.byteOffset, memory.byteLength >> 2);\n    let sum = 0;\n    let at = 0;\n    for (let i = 0; i <= stretches.length && at < filled; i += 2) {\n      const start = Math.min(stretches[i] ?? filled, filled);\n      for (let word = at >> 2; word < start >> 2; word += 1) sum = sum + words[word] >>> 0;\n      at = stretches[i + 1] ?? filled;\n    }\n    return sum;\n  }\n\n  // src/runtime/wheel.js\n  var END = 101010256;\n  var ENTRY = 33639248;\n  var END_BYTES = 22;\n  var ENTRY_BYTES = 46;\n  var LOCAL_BYTES = 30;\n  function entries(archive) {\n    const view = new DataView(archive.buffer, archive.byteOffset, archive.byteLength);\n    const end = archive.length - END_BYTES;\n    if (end < 0 || view.getUint32(end, true) !== END) return null;\n    const found = /* @__PURE__ */ new Map();\n    const text = new TextDecoder();\n    let at = view.getUint32(end + 16, true);\n    for (let left = view.getUint16(end + 10, true); left > 0; left -= 1) {\n      if (view.getUint32(at, true) !== ENTRY || view.getUint16(at + 10, true) !== 0) return null;\n      const [name, extra, comment] = [28, 30, 32].map((place) => view.getUint16(at + place, true));\n      const local = view.getUint32(at + 42, true);\n      const skipped = view.getUint16(local + 26, true) + view.getUint16(local + 28, true);\n      const from = local + LOCAL_BYTES + skipped;\n      const bytes = archive.subarray(from, from + view.getUint32(at + 24, true));\n      found.set(text.decode(archive.subarray(at + ENTRY_BYTES, at + ENTRY_BYTES + name)), bytes);\n      at += ENTRY_BYTES + name + extra + comment;\n    }\n    return found;\n  }\n  function unpackByOurselves(python2) {\n    const api = python2._api;\n    const usual = api.package_loader;\n    const unpack = (given) => {\n      const { buffer, extract_dir } = given;\n      const files2 = entries(buffer);\n      if (!files2) return usual.unpack_buffer.callKwargs(given);\n      const folder = String(extract_dir);\n      const made = /* @__PURE__ */ new Set();\n      for (const [name, bytes] of files2) {\n        const path = `${folder}/${name}`;\n        const parent = path.slice(0, path.lastIndexOf("/"));\n        if (!made.has(parent)) python2.FS.mkdirTree(parent);\n        made.add(parent);\n        python2.FS.writeFile(path, bytes, { canOwn: true });\n      }\n      return [...files2.keys()].filter((name) => name.endsWith(".so")).map((name) => `${folder}/${name}`);\n    };\n    api.package_loader = {\n      get_install_dir: (where) => usual.get_install_dir(where),\n      unpack_buffer: { callKwargs: unpack }\n    };\n  }\n\n  // src/runtime/worker.js\n  var scope = self;\n  var BASE = "https://runtime.invalid/";\n  var WASM = "pyodide.asm.wasm";\n  var STDLIB = "python.zip";\n  var SNAPSHOT = "memory.snapshot";\n  var MORE = "python-more.zip";\n  var stdlib;\n  var files = /* @__PURE__ */ new Map();\n  var python;\n  var answer;\n  var current = 0;\n  var seen = Number.NEGATIVE_INFINITY;\n  var tell = (message, transfer = []) => scope.postMessage(message, transfer);\n  var fail = (reason, error, name = "") => tell({ tell: "failed", reason, detail: String(error), file: name });\n  var progress = (stage) => tell({ tell: "progress", stage });\n  function file(name) {\n    const known = files.get(name);\n    if (known) return known;\n    let take = (_) => {\n    };\n    const come = new Promise((resolve) => {\n      take = resolve;\n    });\n    const made = { come, take };\n    files.set(name, made);\n    return made;\n  }\n  var bytesOf = (name) => file(name).come;\n  scope.fetch = async (address) => {\n    const name = String(address).split("/").pop() ?? "";\n    if (name === WASM) return new Response();\n    if (name === STDLIB) return stdlib;\n    return new Response(await bytesOf(name));\n  };\n  async function wholeStdlib(tableAt) {\n    if (!tableAt) return new Response(await bytesOf(STDLIB));\n    const [first, more] = await Promise.all([bytesOf(STDLIB), bytesOf(MORE)]);\n    const whole = new Uint8Array(tableAt + more.length);\n    whole.set(first.subarray(0, tableAt));\n    whole.set(more, tableAt);\n    return new Response(whole);\n  }\n  var giveWasm = () => {\n  };\n  var wasm = new Promise((resolve) => {\n    giveWasm = resolve;\n  });\n  function useCompiledWasm() {\n    const api = WebAssembly;\n    api.instantiateStreaming = async (_, imports) => {\n      const module = await wasm;\n      try {\n        return { module, instance: await WebAssembly.instantiate(module, imports) };\n      } catch (error) {\n        fail(isOutOfMemory(error) ? "no-memory" : "too-old", error);\n        throw error;\n      }\n    };\n  }\n  scope.addEventListener("unhandledrejection", ({ reason }) => {\n    if (isNotAllocated(reason)) fail("no-memory", reason);\n  });\n  async function boot({ lock, snapshot, tableAt, load, modules, entry }) {\n    try {\n      useCompiledWasm();\n      stdlib = wholeStdlib(tableAt);\n      const { loadPyodide, createPyodideModule } = scope.__pyodide;\n      python = await loadPyodide({\n        indexURL: BASE,\n        packageBaseUrl: BASE,\n        stdLibURL: BASE + STDLIB,\n        lockFileContents: lock,\n        createPyodideModule,\n        _loadSnapshot: snapshot ? bytesOf(SNAPSHOT) : void 0,\n        _putPicture: putPicture,\n        args: [],\n        env: { HOME: "/home/pyodide" }\n      });\n      python._api.config._loadSnapshot = void 0;\n      progress("python");\n      if (snapshot) reseed();\n      tellOfImports();\n    } catch (error) {\n      if (isNotAllocated(error)) return fail("no-memory", error);\n      return fail(snapshot ? "snapshot-refused" : "python-failed", error);\n    }\n    try {\n      if (load.length) await loadPackages(load);\n      for (const name of modules) {\n        importIfPossible(name);\n        progress(name);\n      }\n      const module = python.pyimport(entry);\n      module.listen?.(alive);\n      answer = module.answer;\n    } catch (error) {\n      return fail("python-failed", error);\n    }\n    files.clear();\n    return tell({ tell: "ready", start: snapshot ? "snapshot" : "plain" });\n  }\n  function reseed() {\n    python.runPython(`\nimport sys\nif "random" in sys.modules:\n    sys.modules["random"].seed()\n`);\n  }\n  function alive() {\n    if (performance.now() - seen < 1e3) return;\n    seen = performance.now();\n    if (current) tell({ tell: "alive", number: current });\n    else progress("packages");\n  }\n  function tellOfImports() {\n    const locals = python.toPy({ alive });\n    python.runPython(\n      `\nimport sys\nclass Alive:\n    @staticmethod\n    def find_spec(name, path=None, target=None, alive=alive):\n        alive()\nsys.meta_path.insert(0, Alive)\n`,\n      { globals: locals }\n    );\n  }\n  async function loadPackages(names) {\n    unpackByOurselves(python);\n    const alive2 = setInterval(() => progress("packages"), 1e3);\n    try {\n      await python.loadPackage(names, { messageCallback: () => {\n      } });\n    } finally {\n      clearInterval(alive2);\n    }\n    progress("packages");\n  }\n  function importIfPossible(name) {\n    try {\n      python.pyimport(name).destroy();\n    } catch (error) {\n      if (\n        /** @type {any} */\n        error?.type !== "ModuleNotFoundError"\n      ) throw error;\n    }\n  }\n  function respond({ number, text }) {\n    tell({ tell: "begun", number });\n    current = number;\n    try {\n      const [header, numbers] = answer(text);\n      tell({ tell: "answer", number, header, numbers }, [numbers.buffer]);\n    } catch (error) {\n      tell({ tell: "broken", number, detail: String(error), dead: isDead() });\n    }\n  }\n  function isDead() {\n    try {\n      return python.runPython("1") !== 1;\n    } catch {\n      return true;\n    }\n  }\n  scope.onmessage = ({ data }) => {\n    if (data.do === "boot") boot(data);\n    else if (data.do === "file") file(data.name).take(new Uint8Array(data.bytes));\n    else if (data.do === "wasm") giveWasm(data.module);\n    else if (data.do === "request") respond(data);\n  };\n  tell({ tell: "hello" });\n})();\n';

  // src/runtime/start.js
  var SLOW = "slow";
  var SLOW_LINE = "slow-line";
  var SNAPSHOT = "memory.snapshot";
  var LOADER = "pyodide.js";
  var WASM = "pyodide.asm.wasm";
  var STDLIB = "python.zip";
  var MORE = "python-more.zip";
  async function slowStage(files, folder) {
    const kept = !isFetching() || await areKept(files.map((file) => new URL(file, folder)));
    return kept ? SLOW : SLOW_LINE;
  }
  var modules = /* @__PURE__ */ new Map();
  var Start = class {
    constructor({ folder, index, packages, onProgress, patience = LOST }, snapshot) {
      this.folder = folder;
      this.index = index;
      this.packages = packages;
      this.onProgress = onProgress;
      this.patience = patience;
      this.snapshot = snapshot;
      this.worker = null;
      this.unpacker = null;
      this.over = false;
      this.line = new Line();
      this.done = 0;
      this.names = this.files();
      this.total = this.names.flatMap((name) => index.files[name].parts).reduce((sum, part) => sum + part.size, 0);
    }
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
    toLoad() {
      const { index, packages, snapshot } = this;
      if (!snapshot) return [index.package, ...packages];
      return packages.length && index.later.length ? [index.rest, ...packages] : packages;
    }
    async run() {
      let reject = () => {
      };
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
    load(name, reject) {
      return this.index.files[name].parts.map(async (part, number) => {
        try {
          const bytes = await this.line.take(async () => {
            if (this.over) throw new RuntimeFailure("stopped");
            return loadPart(this.folder, name, number, part);
          });
          this.done += part.size;
          if (!this.over && this.done === this.total && isFetching()) this.guard();
          this.progress(name);
          return bytes;
        } catch (error) {
          reject(error);
          return new Promise(() => {
          });
        }
      });
    }
    guard() {
      this.slow?.stop();
      const loading = isFetching() && this.done < this.total;
      this.slow = watch(SLOW_AFTER, async () => {
        const parts = this.names.flatMap((name) => this.index.files[name].parts);
        const stage2 = loading ? await slowStage(
          parts.map((part) => part.src),
          this.folder
        ) : SLOW;
        if (!this.over) this.onProgress({ fraction: this.fraction, stage: stage2 });
      });
      if (!loading) this.watch = watch(this.patience, () => this.giveUp?.());
    }
    progress(stage2) {
      if (this.over) return;
      this.slow?.progress();
      this.watch?.progress();
      this.onProgress({ fraction: this.fraction, stage: stage2 });
    }
    get fraction() {
      return 0.9 * this.done / this.total;
    }
    async boot(unpacker, reject) {
      const load = (name) => this.load(name, reject);
      const loading = load(LOADER);
      await Promise.all(loading);
      const compiling = this.module(this.names.includes(WASM) ? load(WASM) : []);
      compiling.catch((error) => reject(compileFailure(error)));
      const rest = this.names.filter((name) => name !== LOADER && name !== WASM);
      const files = rest.map((name) => ({ name, unpacked: unpacker.unpack(name, load(name)) }));
      const loader = await gunzip(await Promise.all(loading));
      if (this.over) return null;
      const { worker, address } = workerOf([loader, worker_default]);
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
      for (const { name, unpacked } of files) {
        unpacked.then((bytes) => worker.postMessage({ do: "file", name, bytes }, [bytes]));
      }
      worker.postMessage({ do: "wasm", module: await compiling });
      this.progress(WASM);
      const { start } = await ready;
      this.onProgress({ fraction: 1, stage: "ready" });
      return { worker, start };
    }
    async module(parts) {
      const module = modules.get(this.folder) ?? await compile(parts);
      modules.set(this.folder, module);
      return module;
    }
  };

  // src/runtime/runtime.js
  var PICK_UP = 3;
  var LONG = ["certify", "class", "cost", "hard", "law", "measured", "relevance", "teach"];
  async function startRuntime({ base, packages = [], patience, onProgress = () => {
  } }) {
    requireWasm();
    if (typeof Worker !== "function") throw new RuntimeFailure("no-worker");
    if (typeof DecompressionStream !== "function") throw new RuntimeFailure("too-old");
    const folder = new URL(base, document.baseURI).href;
    let read = false;
    const late = watch(SLOW_AFTER, async () => {
      const stage2 = await slowStage(["index.js"], folder);
      if (!read) onProgress({ fraction: 0, stage: stage2 });
    });
    const index = await loadIndex(folder).finally(late.stop);
    read = true;
    const options = { folder, index, packages: order(packages), onProgress, patience };
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
    request(message) {
      if (this.gone) return Promise.reject(new RuntimeFailure(this.gone));
      return new Promise((resolve, reject) => {
        this.number += 1;
        const patience = LONG.includes(String(message.kind)) ? AT_WORK : PATIENCE;
        const text2 = JSON.stringify(message);
        this.queue.push({ number: this.number, text: text2, patience, resolve, reject });
        if (this.queue.length === 1) this.send();
      });
    }
    stop() {
      this.end("stopped", "");
    }
    send() {
      const next = this.queue[0];
      if (!next) return;
      this.watch = watch(PICK_UP, () => this.lose("worker-lost", "no sign of life"));
      this.worker.postMessage({ do: "request", number: next.number, text: next.text });
    }
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
    lose(reason, detail) {
      if (this.end(reason, detail)) this.onlost(new RuntimeFailure(reason, detail));
    }
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

  // src/question/opening.js
  var NAMES = {
    pre: tr("the test before the lesson"),
    post: tr("the test after the lesson"),
    delayed: tr("the last test")
  };

  // src/shared/dom.js
  function html(tag, className = "", text2 = "") {
    const made2 = document.createElement(tag);
    if (className) made2.className = className;
    if (text2) made2.textContent = text2;
    return made2;
  }
  var TEXT = 3;
  function say(element, text2) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text2) only.nodeValue = text2;
    } else if (element.textContent !== text2) element.textContent = text2;
  }
  function need(root, selector) {
    const found = root.querySelector(selector);
    if (!found) throw new Error(`this page lacks ${selector}; it was built by another version`);
    return found;
  }

  // src/shared/tab.js
  var TAB = () => sessionStorage;
  var BROWSER = () => localStorage;
  function recall(key, where = TAB) {
    try {
      return JSON.parse(where().getItem(key) ?? "null");
    } catch {
      return null;
    }
  }
  function recallOnce(key, where = TAB) {
    const kept = recall(key, where);
    try {
      where().removeItem(key);
    } catch {
    }
    return kept;
  }
  function retain(key, value, where = TAB) {
    try {
      where().setItem(key, JSON.stringify(value));
    } catch {
    }
  }

  // src/shared/code-word.js
  var STUDENT = "student";

  // src/answers/entry.js
  var MOST_EARLIER = 500;
  function isEmpty(value) {
    if (typeof value === "string") return !value.trim();
    if (value === null || value === void 0) return true;
    return typeof value === "object" && Object.keys(value).length === 0;
  }
  function keepEarlier(old, value) {
    if (!old || typeof old !== "object" || typeof value !== "object" || value === null) return value;
    const opened2 = old.locked && old.locked !== value.locked;
    if (opened2 && sameAnswer(old, value)) return { ...together(old, value), locked: old.locked };
    const same = old.hash === value.hash && old.type === value.type;
    if (old.locked && !value.locked && same) {
      return withEarlier(old, old.earlier, value.earlier, alone(value));
    }
    const other = opened2 || old.hash && value.hash && old.hash !== value.hash;
    return withEarlier(value, old.earlier, value.earlier, other ? alone(old) : []);
  }
  function merged(a, b) {
    if (!a) return b;
    if (!b) return a;
    const [old, young] = String(a.last ?? "") <= String(b.last ?? "") ? [a, b] : [b, a];
    const first = [a.first, b.first].filter(Boolean).sort()[0] ?? null;
    if (sameAnswer(old, young)) return { ...together(old, young), first };
    const cleared = isEmpty(young.value) && !isEmpty(old.value);
    const [loser, winner] = cleared ? [young, old] : [old, young];
    return withEarlier({ ...winner, first }, old.earlier, young.earlier, alone(loser));
  }
  function together(old, young) {
    const said = Object.entries(young).filter(([, part]) => (part ?? "") !== "");
    const both2 = { ...young, ...old, ...Object.fromEntries(said) };
    return withEarlier(both2, old.earlier, young.earlier);
  }
  function sameAnswer(a, b) {
    return a.hash === b.hash && JSON.stringify(a.value) === JSON.stringify(b.value);
  }
  function alone({ earlier: _, ...entry }) {
    return isEmpty(entry.value) ? [] : [entry];
  }
  function withEarlier(entry, ...lists) {
    const found = /* @__PURE__ */ new Map();
    for (const one of lists.flatMap((list) => list ?? [])) {
      const name = JSON.stringify([one.hash, one.value]);
      const before = found.get(name);
      found.set(name, before ? together(before, one) : one);
    }
    const all = [...found.values()];
    all.sort((x, y) => String(x.last ?? "").localeCompare(String(y.last ?? "")));
    return all.length ? { ...entry, earlier: all.slice(-MOST_EARLIER) } : entry;
  }

  // src/store/text-store.js
  var beginning = (site) => `carts:${site}:`;
  function textStore(site) {
    try {
      localStorage.setItem(`${beginning(site)}probe`, "1");
      localStorage.removeItem(`${beginning(site)}probe`);
    } catch {
      return null;
    }
    return keptAsText(site);
  }
  function keptAsText(site) {
    const before = beginning(site);
    const get = (key) => {
      try {
        return JSON.parse(localStorage.getItem(before + key) ?? "null");
      } catch {
        return null;
      }
    };
    return {
      kind: "kept",
      how: "text",
      get: async (key) => get(key),
      put: async (key, value) => localStorage.setItem(before + key, JSON.stringify(keepEarlier(get(key), value))),
      remove: async (key) => localStorage.removeItem(before + key),
      entries: async () => Object.keys(localStorage).filter((name) => name.startsWith(before)).map((name) => [name.slice(before.length), get(name.slice(before.length))])
    };
  }

  // src/store/brought-over.js
  var PATIENCE2 = 5e3;
  var marked = (site) => `carts-database:${site}`;
  async function takeTexts(store, site) {
    void remember(store, site);
    const texts = keptAsText(site);
    const found = await texts.entries().catch(() => []);
    if (found.length === 0) return;
    const take = () => takeOver(store, texts).catch(() => {
    });
    const taken2 = Promise.resolve(navigator.locks?.request(`carts-texts:${site}`, take) ?? take());
    const late = new Promise((resolve) => setTimeout(resolve, PATIENCE2));
    await Promise.race([taken2.catch(take), late]);
  }
  async function remember(store, site) {
    const { code = "" } = await store.get(STUDENT).catch(() => null) ?? {};
    if (recall(marked(site), BROWSER)?.code !== code) retain(marked(site), { code }, BROWSER);
  }
  async function instead(texts, site) {
    const before = recall(marked(site), BROWSER);
    if (!before) return texts;
    if (before.code && !await texts.get(STUDENT)) {
      await texts.put(STUDENT, { code: before.code, last: "" }).catch(() => {
      });
    }
    return { ...texts, behind: true };
  }
  async function takeOver(store, texts) {
    for (const [key, text2] of await texts.entries()) {
      if (text2 === null) continue;
      const value = both(await store.get(key), text2);
      if (value === null) continue;
      await store.put(key, value);
      await texts.remove(key);
    }
  }
  function both(kept, text2) {
    if (kept === void 0 || kept === null) return text2;
    if ("type" in Object(kept) && "type" in Object(text2)) return merged(kept, text2);
    if (!("last" in Object(kept) && "last" in Object(text2))) return null;
    return String(kept.last) > String(text2.last) ? kept : text2;
  }

  // src/store/newest-first.js
  var GONE = /* @__PURE__ */ Symbol("forgotten");
  function newestFirst(put) {
    const flights = /* @__PURE__ */ new Map();
    function start(key, value, alone2) {
      const now = put(key, value, alone2);
      flights.set(key, { now, next: null });
      const over2 = () => {
        if (flights.get(key)?.now === now && !flights.get(key)?.next) flights.delete(key);
      };
      now.then(over2, over2);
      return now;
    }
    return (key, value, alone2 = false) => {
      const flight = flights.get(key);
      if (!flight) return start(key, value, alone2);
      if (flight.next) {
        flight.next.value = value;
        flight.next.alone &&= alone2;
        flight.next.anew ||= value === GONE;
        return flight.next.written;
      }
      const next = { value, alone: alone2, anew: value === GONE, written: Promise.resolve() };
      const begin2 = () => start(key, next.value, next.alone || next.anew);
      next.written = flight.now.then(begin2, begin2);
      flight.next = next;
      return next.written;
    };
  }

  // src/store/indexed-store.js
  var SETTLED = "settled";
  var STORE = "answers";
  var PATIENCE3 = 2e4;
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
      setTimeout(() => reject(new Error("no answer")), PATIENCE3);
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
    const read = async (ask) => answered(ask((await begin2("readonly")).objectStore(STORE)));
    const put = newestFirst(
      (key, value, alone2) => write2(begin2, (answers) => {
        if (value === GONE) answers.delete(key);
        else if (alone2) {
          answers.put(value, key);
          answers.transaction.commit();
        } else {
          const request = answers.get(key);
          request.onsuccess = () => answers.put(keepEarlier(request.result, value), key);
        }
      })
    );
    return {
      kind: "kept",
      how: "indexed",
      get: (key) => read((answers) => answers.get(key)),
      put,
      remove: (key) => put(key, GONE),
      entries: async () => {
        const answers = (await begin2("readonly")).objectStore(STORE);
        const [keys, values] = await Promise.all([
          answered(answers.getAllKeys()),
          answered(answers.getAll())
        ]);
        return keys.map((key, k) => [String(key), values[k]]);
      }
    };
  }
  function answered(request) {
    return new Promise((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
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

  // src/store/shelter.js
  function shelter(site) {
    const page2 = globalThis;
    const name = /* @__PURE__ */ Symbol.for(`carts-shelter:${site}`);
    page2[name] ??= /* @__PURE__ */ new Map();
    return page2[name];
  }
  function sheltered(store, site) {
    const refused = shelter(site);
    return {
      ...store,
      put: async (key, value, alone2) => {
        try {
          await store.put(key, value, alone2);
          refused.delete(key);
        } catch (error) {
          refused.set(key, keepEarlier(refused.get(key), value));
          throw error;
        }
      },
      remove: async (key) => {
        refused.delete(key);
        await store.remove(key);
      },
      entries: async () => [...new Map([...await store.entries(), ...refused])]
    };
  }
  function memory(site) {
    const kept = shelter(site);
    return {
      kind: "memory",
      how: "memory",
      get: async (key) => kept.get(key),
      put: async (key, value) => void kept.set(key, keepEarlier(kept.get(key), value)),
      remove: async (key) => void kept.delete(key),
      entries: async () => [...kept]
    };
  }

  // src/store/tabs.js
  function telling(store, site) {
    const channel2 = channelOf(`carts:${site}`);
    return {
      ...store,
      student: "",
      put: async (key, value, alone2) => {
        await store.put(key, value, alone2);
        channel2?.postMessage({ key, gone: false });
      },
      remove: async (key) => {
        await store.remove(key);
        channel2?.postMessage({ key, gone: true });
      },
      hear: (act, signal) => {
        channel2?.addEventListener(
          "message",
          ({ data }) => act(String(data.key), data.gone),
          signal && { signal }
        );
      }
    };
  }
  function channelOf(name) {
    try {
      return new BroadcastChannel(name);
    } catch {
      return null;
    }
  }

  // src/store/storage.js
  var opened = /* @__PURE__ */ new Map();
  function openAll(site) {
    const found = opened.get(site) ?? openOnce(site);
    opened.set(site, found);
    return found;
  }
  async function openOnce(site) {
    try {
      const store = telling(sheltered(await indexed(`carts:${site}`), site), site);
      await takeTexts(store, site);
      return store;
    } catch {
      const texts = textStore(site);
      return telling(texts ? await instead(sheltered(texts, site), site) : memory(site), site);
    }
  }
  function place() {
    const { cartsSite, cartsPage } = document.documentElement.dataset;
    const meta = (name) => document.querySelector(`meta[name="${name}"]`)?.getAttribute("content");
    const path2 = location.pathname.split("/").slice(-2).join("/");
    return {
      site: cartsSite ?? meta("carts-site") ?? "site",
      page: cartsPage ?? meta("carts-page") ?? path2
    };
  }

  // src/teach/door.js
  var OPEN = "carts-teach";
  var draftMark = () => `carts-draft ${place().page}`;
  function tellDraft(link) {
    link.dataset.words ??= link.textContent ?? "";
    const kept = recall(draftMark(), BROWSER) ? " (your draft is kept)" : "";
    link.textContent = link.dataset.words + kept;
  }

  // src/teach/drafts.js
  var Drafts = class {
    constructor(told3) {
      const { site, page: page2 } = place();
      this.hash = told3.hash;
      this.before = `${page2}#`;
      this.key = this.before + this.hash;
      this.own = null;
      this.kept = null;
      this.store = openAll(`${site}~teacher`);
    }
    async #all() {
      const all = await (await this.store).entries().catch(() => []);
      return all.filter(([key, value]) => key.startsWith(this.before) && isDraft(value)).map(([key, value]) => ({ ...value, key })).sort((a, b) => a.last < b.last ? 1 : -1);
    }
    async found() {
      const all = await this.#all();
      const draft = all.find(({ hash }) => hash === this.hash) ?? null;
      this.key = draft?.key ?? this.key;
      return { draft, earlier: all.filter((one) => one !== draft) };
    }
    async ofFile(own, hash) {
      const published = hash !== "" && hash === this.hash;
      const found = await this.#all();
      const draft = found.find(({ base }) => base === own) ?? found.find((one) => published && one.hash === hash) ?? null;
      this.hash = draft?.hash ?? (hash || sumOf(own));
      this.key = draft?.key ?? this.before + this.hash;
      this.own = own;
      return { draft, earlier: found.filter((one) => one !== draft && holds(own, one)) };
    }
    async keep(text2, base) {
      const store = await this.store;
      this.kept = { text: text2, base, last: (/* @__PURE__ */ new Date()).toISOString(), hash: this.hash };
      await store.put(this.key, this.kept, true);
      if (this.own === null) retain(draftMark(), true, BROWSER);
      return store.kind === "kept";
    }
    async hear(act) {
      const store = await this.store;
      const others = /* @__PURE__ */ new Map();
      store.hear(async (key, gone) => {
        if (gone || key !== this.key && !others.has(key)) return;
        if (key === this.key) {
          this.key = `${this.before}${this.hash}~${Math.random().toString(36).slice(2)}`;
          if (this.kept) await store.put(this.key, this.kept, true).catch(() => {
          });
        }
        const found = await store.get(key).catch(() => null);
        if (!isDraft(found) || this.own !== null && !holds(this.own, found)) return;
        const known = others.get(key);
        if (known) return void Object.assign(known, found);
        const draft = { ...found, key };
        others.set(key, draft);
        act(draft);
      });
    }
    async forget(key = this.key) {
      if (key === this.key) this.kept = null;
      await (await this.store).remove(key);
      if (this.own === null && !(await this.#all()).length) recallOnce(draftMark(), BROWSER);
    }
  };
  function sumOf(text2) {
    let sum = 7;
    for (const sign of text2) sum = Math.imul(sum, 31) + Number(sign.codePointAt(0)) >>> 0;
    return `${text2.length}-${sum.toString(16)}`;
  }
  function isDraft(value) {
    return typeof value?.text === "string" && typeof value?.base === "string";
  }
  function holds(own, { base }) {
    const lines3 = new Set(linesOf(own));
    const inBlocks = [...base.matchAll(/^(`{3,}|~{3,})[\s\S]*?^\1/gm)].flatMap(
      ([block]) => linesOf(block)
    );
    const there = inBlocks.filter((line) => lines3.has(line));
    const words = inBlocks.filter((line) => /\bword["']?\s*:/.test(line));
    return headingOf(base) === headingOf(own) && words.every((line) => lines3.has(line)) && 2 * there.length >= inBlocks.length;
  }
  var headingOf = (text2) => /^# +(.+?)\s*$/m.exec(text2)?.[1];
  var linesOf = (text2) => text2.split(/\r\n?|\n/).map((line) => line.trim()).filter(Boolean);

  // src/answers/parts.js
  function button(text2, act, name = "") {
    const made2 = html("button", `carts-button ${name}`.trim(), text2);
    made2.type = "button";
    made2.addEventListener("click", act);
    return made2;
  }
  var count = 0;
  function askingButton(text2, question, yes, act, name, not = tr("No")) {
    const row = html("p", `carts-answers-asking ${name}`);
    const first = button(text2, () => ask(true));
    const asked = html("span");
    const words = html("span", "", question);
    count += 1;
    words.id = `${name}-${count}`;
    const no = button(not, () => ask(false), "carts-answers-no");
    const go = () => {
      ask(false);
      act();
    };
    const does = button(yes, go, "carts-answers-yes");
    for (const one of [does, no]) one.setAttribute("aria-describedby", words.id);
    asked.append(words, " ", does, " ", no);
    asked.hidden = true;
    row.append(first, asked);
    function ask(on) {
      first.hidden = on;
      asked.hidden = !on;
      (on ? no : first).focus();
    }
    return row;
  }
  function clock(time) {
    const date = new Date(time ?? "");
    return Number.isNaN(date.getTime()) ? "" : date.toLocaleString(document.documentElement.lang || [], {
      dateStyle: "medium",
      timeStyle: "short"
    });
  }

  // src/teach/around.js
  var TEACHING = "carts-teaching";
  var WAITS = "carts-runs";
  function enter() {
    document.querySelector(".carts-teach-draft")?.remove();
    document.documentElement.classList.remove(WAITS);
    document.body.classList.add(TEACHING);
  }
  function leave(session2) {
    document.body.classList.remove(TEACHING);
    document.documentElement.classList.add(WAITS);
    const address = new URL(location.href);
    address.searchParams.delete("teacher");
    if (address.hash === "#teacher") address.hash = "";
    history.replaceState(null, "", address.href.replace(/#$/, ""));
    tellDraft(session2.link);
    session2.link.focus({ preventScroll: true });
    if (!session2.changed) return;
    const line = draftLine(session2);
    session2.page.article.before(line);
    line.querySelector("button")?.focus();
  }
  function draftLine(session2) {
    const line = html("p", "carts carts-teach-draft");
    const on = button("Go on changing", () => session2.show(), "carts-teach-on");
    line.append(html("span", "", "You see your draft, not the published lesson."), " ", on);
    const kept = session2.panel.root.dataset.kept === "true";
    const away = button("Show the published one", () => location.reload(), "carts-teach-leave");
    if (kept) line.append(" ", away);
    return line;
  }

  // src/teach/asked.js
  async function zipped(client, file, text2, published) {
    const { header } = await client.ask({}, () => ({
      kind: "teach",
      do: "zip",
      file,
      text: text2,
      published
    }));
    return header.base64;
  }
  function restored(client, text2, own) {
    return ofText(client, {}, text2, { do: "restore", own });
  }
  function written(client, owner, text2, one) {
    return ofText(client, owner, text2, { do: "set", ...one });
  }
  async function ofText(client, owner, text2, asked) {
    for (; ; ) {
      const { header, sent } = await client.ask(owner, () => ({
        kind: "teach",
        ...asked,
        text: text2()
      }));
      if (header.refused || sent.text === text2()) return header;
    }
  }

  // src/teach/history.js
  var ONE_GO = 1500;
  var History = class {
    #past = [];
    #future = [];
    #where = "";
    #when = 0;
    constructor(text2) {
      this.text = text2;
    }
    get canUndo() {
      return this.#past.length > 0;
    }
    get canRedo() {
      return this.#future.length > 0;
    }
    change(text2, where) {
      if (text2 === this.text) return false;
      const now = performance.now();
      if (!where || where !== this.#where || now - this.#when > ONE_GO) this.#past.push(this.text);
      this.#where = where;
      this.#when = now;
      this.#future = [];
      this.text = text2;
      return true;
    }
    undo() {
      this.#step(this.#past, this.#future);
    }
    redo() {
      this.#step(this.#future, this.#past);
    }
    #step(from, to) {
      const text2 = from.pop();
      if (text2 === void 0) return;
      to.push(this.text);
      this.text = text2;
      this.#where = "";
    }
  };

  // src/teach/looks.js
  var Looks = class {
    #looking = {};
    #asked = false;
    constructor(session2) {
      this.session = session2;
    }
    async ask(text2) {
      const { told: told3, client, page: page2 } = this.session;
      const { header } = await client.ask(this.#looking, () => ({
        ...{ kind: "teach", do: "look", lesson: told3.lesson, files: told3.files },
        ...{ text: text2(), have: page2.have }
      }));
      return header;
    }
    async got(look) {
      if (!look.needs.length || this.#asked) return false;
      this.#asked = true;
      try {
        await this.session.client.need(look.needs);
        return true;
      } catch {
        this.session.panel.status(
          "A scene here needs numpy and scipy, which this site has not packed. The build will pack them."
        );
        return false;
      }
    }
  };

  // ../view/numbers.js
  var SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  var NOISE = 1e-9;
  var MAX_DECIMALS = 12;
  var SLOW2 = 0.01;
  function exponent(value) {
    return value ? Number(Math.abs(value).toExponential(16).split("e")[1]) : 0;
  }
  function fixed(value, decimals) {
    const text2 = Math.abs(value).toFixed(decimals);
    return value < 0 && /[1-9]/.test(text2) ? `−${text2}` : text2;
  }
  function decimalsFor(scale, figures2 = 3) {
    return Math.min(MAX_DECIMALS, Math.max(0, figures2 - 1 - exponent(scale)));
  }
  function short(value, figures2 = 3) {
    const power = exponent(value);
    if (value && (power <= -4 || power >= 6)) {
      const [digits = "", tens] = Math.abs(value).toExponential(figures2 - 1).split("e");
      return `${value < 0 ? "−" : ""}${trim(digits)} × 10${superscript(Number(tens))}`;
    }
    return trim(fixed(value, Math.max(0, figures2 - 1 - power)));
  }
  function superscript(power) {
    const digits = String(Math.abs(power)).replace(/\d/g, (d) => SUPERSCRIPT[Number(d)] ?? "");
    return power < 0 ? `⁻${digits}` : digits;
  }
  function decimalsOf(value, figures2 = 6) {
    const text2 = Math.abs(value).toFixed(decimalsFor(value, figures2));
    return trim(text2).split(".")[1]?.length ?? 0;
  }
  function speedUnit(scale) {
    return scale <= SLOW2 ? [1e-3, "mm/s"] : [1, "m/s"];
  }
  function trim(text2) {
    return text2.includes(".") ? text2.replace(/\.?0+$/, "") : text2;
  }
  function px(value, decimals = 1) {
    const factor = 10 ** decimals;
    const rounded = Math.floor(value * factor + 0.5) / factor;
    return String(rounded === 0 ? 0 : rounded);
  }

  // ../view/scales.js
  var STEP_SLACK = 1e-9;
  var HEADROOM = 0.05;
  var NOUGHT = 1e-12;
  function axisDecimals(axis2) {
    return Math.max(0, -exponent(axis2.step));
  }
  function ticks(axis2) {
    const first = Math.ceil(axis2.low / axis2.step - STEP_SLACK);
    const last = Math.floor(axis2.high / axis2.step + STEP_SLACK);
    const found = [];
    for (let k = first; k <= last; k += 1) found.push(k * axis2.step);
    return found;
  }
  function niceAbove(value) {
    const power = Number(`1e${exponent(value)}`);
    for (const factor of [1, 2, 5]) {
      if (value <= factor * power * (1 + STEP_SLACK)) return factor * power;
    }
    return 10 * power;
  }
  function axis(low, high, count2) {
    const bottom = low < -NOUGHT ? low : 0;
    const above = high > NOUGHT ? high : 0;
    const top = above === bottom ? 1 : above;
    const room = HEADROOM * (top - bottom);
    return { low: bottom - room, high: top + room, step: niceAbove((top - bottom) / count2) };
  }
  function span(low, high, count2) {
    return { low, high, step: niceAbove((high - low) / count2) };
  }

  // ../view/map/palette.js
  var NONE = [176, 176, 176];
  var ZERO = [32, 32, 32];
  var EDGE = 0.72;
  function sequential(count2) {
    return Array.from({ length: count2 }, (_, k) => {
      const t = k / Math.max(1, count2 - 1);
      return oklch(0.3 + 0.64 * t, 0.09 + 0.05 * Math.sin(Math.PI * t), 268 - 165 * t);
    });
  }
  function diverging(centres) {
    const far = Math.max(...centres.map(Math.abs));
    return centres.map((centre) => {
      const size = Math.abs(centre / far);
      return oklch(0.97 - 0.47 * size, 0.145 * size, centre < 0 ? 250 : 52);
    });
  }
  function edge([red, green, blue]) {
    return [Math.round(EDGE * red), Math.round(EDGE * green), Math.round(EDGE * blue)];
  }
  function oklch(lightness, chroma, hue) {
    const angle = hue * Math.PI / 180;
    const [a, b] = [chroma * Math.cos(angle), chroma * Math.sin(angle)];
    const long = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
    const middle = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
    const short3 = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
    return [
      channel(4.0767416621 * long - 3.3077115913 * middle + 0.2309699292 * short3),
      channel(-1.2684380046 * long + 2.6097574011 * middle - 0.3413193965 * short3),
      channel(-0.0041960863 * long - 0.7034186147 * middle + 1.707614701 * short3)
    ];
  }
  function channel(linear) {
    const light = Math.min(1, Math.max(0, linear));
    const coded = light <= 31308e-7 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
    return Math.round(255 * coded);
  }

  // ../view/map/bands.js
  var BANDS = 12;
  var FLAT = 1e-9;
  function scaleFor(low, high) {
    const largest = Math.max(Math.abs(low), Math.abs(high));
    const flat = high - low <= FLAT * largest || largest === 0;
    const step = flat ? largest ? niceAbove(largest) : 1 : niceAbove((high - low) / BANDS);
    const first = Math.floor(low / step + STEP_SLACK);
    const last = Math.max(first + 1, Math.ceil(high / step - STEP_SLACK));
    const count2 = last - first;
    const centres = Array.from({ length: count2 }, (_, k) => (first + k + 0.5) * step);
    const around = Number(centres[0]) < 0 && Number(centres.at(-1)) > 0;
    return {
      low: first * step,
      step,
      count: count2,
      colours: around ? diverging(centres) : sequential(count2),
      zero: Math.min(count2, Math.max(0, -first))
    };
  }
  function edges({ low, step, count: count2 }) {
    const first = Math.round(low / step);
    return Array.from({ length: count2 + 1 }, (_, k) => (first + k) * step);
  }
  function edgeDecimals(scale) {
    return Math.max(...edges(scale).map((one) => decimalsOf(one)));
  }

  // ../view/markup.js
  var ESCAPED = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };
  var Markup = class {
    constructor(text2) {
      this.text = text2;
    }
    toString() {
      return this.text;
    }
  };
  function html2(strings, ...values) {
    let written3 = strings[0] ?? "";
    values.forEach((value, k) => {
      const quote = strings[k]?.endsWith("=") ? '"' : "";
      written3 += quote + asText(value) + quote + (strings[k + 1] ?? "");
    });
    return new Markup(written3);
  }
  function asText(value) {
    if (Array.isArray(value)) return value.map(asText).join("");
    if (value instanceof Markup) return value.text;
    if (value === false || value === null || value === void 0) return "";
    return String(value).replace(/[&<>"']/g, (sign) => ESCAPED[sign] ?? sign);
  }

  // ../view/skeleton/mark.js
  var liveMark = () => html2`<span class="carts-mark" role="img" aria-label=${tr("not live yet")}><span class="carts-mark-text" aria-hidden="true">${tr("live")}</span></span>`;

  // ../view/map/pixels.js
  var FINE = 400;
  var TORN = 3;
  function band(value, { low, step, count: count2 }) {
    if (Number.isNaN(value)) return count2;
    const place4 = Math.floor((value - low) / step + STEP_SLACK);
    return Math.min(count2 - 1, Math.max(0, place4));
  }
  function torn(before, a, b, after, step) {
    const apart = Math.abs(b - a);
    if (apart <= TORN * step) return false;
    const beside = [a - before, b - after].map(Math.abs).filter(Number.isFinite);
    return !(apart <= TORN * (beside.length ? Math.min(...beside) : apart));
  }
  function between(values, lines3, count2, factor, next, line, step) {
    const fine = (count2 - 1) * factor + 1;
    const found = new Float64Array(lines3 * fine);
    for (let i = 0; i < lines3; i += 1) {
      const value = (k) => k < 0 || k >= count2 ? Number.NaN : Number(values[i * line + k * next]);
      for (let left = 0; left < count2 - 1; left += 1) {
        const [a, b] = [value(left), value(left + 1)];
        const apart = torn(value(left - 1), a, b, value(left + 2), step);
        for (let k = 0; k <= factor; k += 1) {
          const part = k / factor;
          const mixed = a * (1 - part) + b * part;
          found[i * fine + left * factor + k] = !apart ? mixed : part < 0.5 ? a : b;
        }
      }
    }
    return found;
  }
  function pixels(values, columns, scale) {
    const rows = values.length / columns;
    const factor = Math.max(1, Math.ceil(FINE / (Math.max(columns, rows) - 1)));
    const width = (columns - 1) * factor + 1;
    const height = (rows - 1) * factor + 1;
    const wide = between(values, rows, columns, factor, 1, columns, scale.step);
    const fine = between(wide, width, rows, factor, width, 1, scale.step);
    const bands = new Uint8Array(width * height);
    for (let y = 0; y < height; y += 1) {
      for (let x = 0; x < width; x += 1) {
        bands[y * width + x] = band(Number(fine[x * height + (height - 1 - y)]), scale);
      }
    }
    return { places: lines(bands, width, scale), width, height };
  }
  function lines(bands, width, { count: count2, zero }) {
    const places = bands.slice();
    const line = 2 * count2 + 1;
    const compare = (at, other) => {
      const own = Number(bands[at]);
      const next = Number(bands[other]);
      if (next === own || own === count2) return;
      if (next !== count2 && own >= zero !== next >= zero && Math.abs(own - next) === 1) {
        places[at] = line;
        places[other] = line;
      } else if (places[at] !== line) places[at] = count2 + 1 + own;
    };
    for (let at = 0; at < bands.length; at += 1) {
      if ((at + 1) % width) compare(at, at + 1);
      if (at + width < bands.length) compare(at, at + width);
    }
    return places;
  }
  function palette({ colours }) {
    return [...colours, NONE, ...colours.map(edge), ZERO];
  }

  // ../view/map/words.js
  var SMALLER = 2;
  var EXACT = 12;
  function valueText(value, { low, high }) {
    if (Number.isNaN(value)) return tr("no value");
    const most = decimalsFor(Math.max(Math.abs(low), Math.abs(high)) || 1) + SMALLER;
    const text2 = fixed(value, Math.min(decimalsFor(value || 1), most));
    return /[1-9]/.test(text2) ? text2 : fixed(0, most - SMALLER);
  }
  function shown(value, { per }) {
    return Number((value / per).toPrecision(EXACT));
  }
  function axisDecimals2(axis2) {
    const [first = 0, second = 0] = axis2.values.map((value) => shown(value, axis2));
    return Math.max(decimalsOf(first), decimalsOf(second - first, 3));
  }
  function named({ label, unit }) {
    return unit ? tr("{label} in {unit}", { label, unit }) : label;
  }

  // ../view/map/figure.js
  var [LEFT, TOP, RIGHT, BOTTOM] = [58, 10, 388, 270];
  var WIDTH = 400;
  var [HEIGHT, HEIGHT_OF_CURVE] = [370, 312];
  var [BAR_TOP, BAR_HEIGHT] = [322, 12];
  var TICKS = 5;
  var MOST_NUMBERS = 7;
  var BASELINE = 4;
  var heightOf = ({ axes: axes2 }) => axes2.length === 1 ? HEIGHT_OF_CURVE : HEIGHT;
  var valueAxis = ({ low, high }) => axis(low, high, TICKS);
  function across(value, { low, high }) {
    return LEFT + (value - low) * ((RIGHT - LEFT) / (high - low));
  }
  function up(value, { low, high }) {
    return BOTTOM - (value - low) * ((BOTTOM - TOP) / (high - low));
  }
  function curve(facts, points, values) {
    const along = facts.axes[0];
    if (!along) return "";
    const [x, y] = [span(along.low, along.high, 1), valueAxis(facts)];
    let path2 = "";
    let pen = "M";
    for (const [k, point] of points.entries()) {
      const [before, last, value, next] = [k - 2, k - 1, k, k + 1].map((at) => Number(values[at]));
      if (torn(before, last, value, next, (y.high - y.low) / TICKS)) pen = "M";
      if (value >= y.low && value <= y.high) {
        path2 += `${pen}${px(across(shown(point, along), x))} ${px(up(value, y))}`;
        pen = "L";
      } else pen = "M";
    }
    return path2;
  }
  function under(facts, picture) {
    const [first, second] = facts.axes;
    const x = span(first?.low ?? 0, first?.high ?? 1, TICKS);
    const y = second ? span(second.low, second.high, TICKS) : valueAxis(facts);
    const labels = [first ? named(first) : "", second ? named(second) : named(facts)];
    const height = heightOf(facts);
    const [bottom, right] = picture ? [BOTTOM, LEFT] : [TOP, RIGHT];
    const image = html2`<image href=${picture} x=${LEFT} y=${TOP} width=${RIGHT - LEFT} height=${BOTTOM - TOP} preserveAspectRatio="none"/>
`;
    const columns = ticks(x).map((tick) => {
      const at = px(across(tick, x));
      return html2`<path class="carts-grid" d="M${at} ${bottom}V${BOTTOM + 4}"/><text class="carts-tick-x" x=${at} y=${BOTTOM + 16}>${fixed(tick, axisDecimals(x))}</text>`;
    });
    const rows = ticks(y).map((tick) => {
      const at = up(tick, y);
      return html2`<path class="carts-grid" d="M${LEFT - 4} ${px(at)}H${right}"/><text class="carts-tick-y" x=${LEFT - 7} y=${px(at + BASELINE)}>${fixed(tick, axisDecimals(y))}</text>`;
    });
    return html2`<svg class="carts-map-under" viewBox="0 0 ${WIDTH} ${height}" width=${WIDTH} height=${height} aria-hidden="true" focusable="false">
${picture !== "" && image}${columns}
${rows}
<text class="carts-unit" x=${RIGHT} y=${BOTTOM + 31} text-anchor="end">${labels[0]}</text>
<text class="carts-unit" transform="translate(13 ${(TOP + BOTTOM) / 2}) rotate(-90)" text-anchor="middle">${labels[1]}</text>
${second && bar(facts)}
</svg>`;
  }
  function bar(facts) {
    const scale = scaleFor(facts.low, facts.high);
    const width = (RIGHT - LEFT) / scale.count;
    const numbers = edges(scale);
    const every = Math.ceil(scale.count / MOST_NUMBERS);
    const zero = Math.max(
      0,
      numbers.findIndex((number) => Math.abs(number) < 0.5 * scale.step)
    );
    const parts = numbers.map((number, k) => {
      const x = px(LEFT + k * width, 2);
      const colour = scale.colours[k];
      const band2 = colour && html2`<rect x=${x} y=${BAR_TOP} width=${px(width, 2)} height=${BAR_HEIGHT} fill=${hex(colour)}/>`;
      const notch = (k - zero) % every === 0 && html2`<path class="carts-map-notch" d="M${x} ${BAR_TOP}v${BAR_HEIGHT}"/><text class="carts-tick-x" x=${x} y=${BAR_TOP + BAR_HEIGHT + 12}>${fixed(number, edgeDecimals(scale))}</text>`;
      return html2`${band2}${notch}`;
    });
    return html2`${parts}
<text class="carts-unit" x=${RIGHT} y=${BAR_TOP + BAR_HEIGHT + 26} text-anchor="end">${named(facts)}</text>`;
  }
  var hex = (colour) => `#${colour.map((part) => part.toString(16).padStart(2, "0")).join("")}`;

  // ../view/map/table.js
  var COLUMNS = 6;
  var ROWS = 11;
  function spread(count2, most) {
    const wanted = Math.min(most, count2);
    return Array.from(
      { length: wanted },
      (_, k) => Math.floor(k * (count2 - 1) / (wanted - 1) + 0.5)
    );
  }
  function tableOf(columns, rows, axisText2, valueText2) {
    if (rows === 1) {
      const lines4 = spread(columns, 2 * ROWS - 1).map((k) => [axisText2(0, k), valueText2(k)]);
      return { head: [], lines: lines4 };
    }
    const across2 = spread(columns, COLUMNS);
    const lines3 = spread(rows, ROWS).map((row) => [
      axisText2(1, row),
      ...across2.map((k) => valueText2(row * columns + k))
    ]);
    return { head: across2.map((k) => axisText2(0, k)), lines: lines3 };
  }

  // ../view/map/skeleton.js
  function inside(facts, draw, picture) {
    const { id, title, why } = draw;
    return html2`<div class="carts-map-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
<div class="carts-map-body">
<div class="carts-map-figure" role="group" aria-label=${named(facts)}>
${under(facts, picture)}
${over(facts, draw)}
</div>
${side(facts, draw)}
</div>
${table(facts, draw)}
<details class="carts-more carts-map-model"><summary>${tr("How this was computed")}</summary><p class="carts-map-why">${why}</p></details>
<noscript><p class="carts-noscript">${tr("The picture and the table show the values. Asking single points needs JavaScript.")}</p></noscript>
</div>`;
  }
  var valueAt = ({ values }, place4) => values[place4] ?? Number.NaN;
  function axisText(facts, axis2, place4) {
    const along = facts.axes[axis2];
    return along ? fixed(shown(Number(along.values[place4]), along), axisDecimals2(along)) : "";
  }
  function over(facts, draw) {
    const height = heightOf(facts);
    const all = draw.values.map((value) => value ?? Number.NaN);
    const line = facts.axes.length === 1 ? curve(facts, facts.axes[0]?.values ?? [], all) : "";
    return html2`<svg class="carts-map-over" viewBox="0 0 ${WIDTH} ${height}" width=${WIDTH} height=${height} aria-hidden="true" focusable="false">
<rect class="carts-map-edge" x=${LEFT} y=${TOP} width=${RIGHT - LEFT} height=${BOTTOM - TOP}/>
<path data-part="curve" class="carts-curve" d=${line}/>
<g data-part="cross"><path data-part="lines" class="carts-map-cross" d=""/><circle data-part="point" class="carts-map-point" r="6" cx="0" cy="0" visibility="hidden"/></g>
</svg>`;
  }
  function side(facts, { id }) {
    const { label, unit, axes: axes2, here, of, controls } = facts;
    const points = axes2.map(({ set, label: name, unit: measured, values }, k) => {
      const place4 = here[k] ?? 0;
      const text2 = axisText(facts, k, place4);
      const range = html2`min="0" max=${values.length - 1} step="1" value=${place4}`;
      return slider({ id, set, label: name, unit: measured, range, text: text2 }, " carts-map-axis");
    });
    const further = controls.map(({ set, label: name, unit: measured, low, high, step, value }) => {
      const decimals = Math.max(...[step, low, value].map((one) => decimalsOf(one)));
      const range = html2`min=${low} max=${high} step=${step} value=${value}`;
      return slider(
        { id, set, label: name, unit: measured, range, text: fixed(value, decimals) },
        ""
      );
    });
    const ids = axes2.map(({ set }) => `${id}-${set.replaceAll(".", "-")} `).join("");
    const at = valueText(facts.at ?? Number.NaN, facts);
    return html2`<div class="carts-map-side">
<p class="carts-map-start"><button type="button" class="carts-button carts-map-open" hidden>${tr("Open the map")}</button> <span class="carts-map-wait" hidden>${tr("The map is a picture until you open it. Then every point can be asked for its value.")}</span></p>
<p class="carts-heading">${tr("One point of the map")}</p>
${points}<p class="carts-map-value"><span>${label}</span> <output class="carts-map-number" for=${ids}>${facts.at === null ? at : `${at} ${unit}`}</output></p>
<progress class="carts-map-progress" max="1" value="1" aria-label=${tr("points computed")}></progress>
${of && html2`<p class="carts-map-start"><button type="button" class="carts-button carts-map-run" disabled>${tr("Run this point")}</button> <a href="#${of}">${tr("the scene")}</a></p>`}
${controls.length > 0 && html2`<p class="carts-heading">${tr("All points of the map")}</p>`}
${further}</div>`;
  }
  function slider({ id, set, label, unit, range, text: text2 }, more) {
    const box = `${id}-${set.replaceAll(".", "-")}`;
    const spoken = tr("{label}, slider", { label });
    return html2`<div class="carts-control${more}" data-set=${set}>
<label for=${box}>${label}</label>
<input type="range" class="carts-slider" ${range} aria-label=${spoken} aria-valuetext=${`${text2} ${unit}`.trim()} disabled>
<span class="carts-typed"><input type="text" class="carts-number-box" id=${box} inputmode="decimal" autocomplete="off" spellcheck="false" value=${text2.replace("−", "-")} aria-label=${named({ label, unit })} disabled> <span class="carts-unit-text">${unit}</span></span>
<p class="carts-error" hidden></p>
</div>
`;
  }
  function table(facts, draw) {
    const [first, second] = facts.axes;
    const columns = first?.values.length ?? 0;
    const { head: head2, lines: lines3 } = tableOf(
      columns,
      second?.values.length ?? 1,
      (axis2, place4) => axisText(facts, axis2, place4),
      (place4) => valueText(valueAt(draw, place4), facts)
    );
    const heads2 = second ? head2 : [facts.label];
    const across2 = html2`<tr><td></td><th scope="colgroup" colspan=${heads2.length}>${first && named(first)}</th></tr>`;
    const rows = lines3.map(
      ([name, ...cells]) => html2`<tr><th scope="row">${name}</th>${cells.map((cell) => html2`<td>${cell}</td>`)}</tr>`
    );
    const summary = tr("Table: {quantity}", { quantity: named(facts) });
    return html2`<details class="carts-more carts-map-table"><summary>${summary}</summary>
<div class="carts-scroll"><table class="carts-table"><thead>
${second && across2}
<tr><th scope="col">${named(second ?? first ?? facts)}</th>${heads2.map((cell) => html2`<th scope="col">${cell}</th>`)}</tr></thead>
<tbody>${rows}</tbody></table></div></details>`;
  }

  // ../view/bodies.js
  var THINGS = {
    foam: () => ({ body: tr("the foam"), brief: tr("foam") }),
    spring: () => ({ body: tr("the spring"), brief: tr("spring") }),
    board: () => ({ body: tr("the board"), brief: tr("board") })
  };
  function isWall(name) {
    return name === "left" || name === "right";
  }
  function whatIs(name, { left_is = "wall", right_is = "wall" }) {
    return name === "left" ? left_is : right_is;
  }
  function body(name, track) {
    if (!isWall(name)) return name;
    const thing = thingAt(name, track, "body");
    if (thing) return thing;
    if (!hasTwoWalls(track)) return tr("the wall");
    return name === "left" ? tr("the left wall") : tr("the right wall");
  }
  function hasTwoWalls(track) {
    return ["left", "right"].every(
      (side2) => track[side2] === "wall" && whatIs(side2, track) === "wall"
    );
  }
  function isWord(name) {
    return name.length > 2;
  }
  function kind(name, track) {
    return THINGS[whatIs(name, track)]?.().brief ?? tr("wall");
  }
  function thingAt(name, track, form2) {
    const thing = THINGS[whatIs(name, track)]?.()[form2];
    if (!thing || whatIs("left", track) !== whatIs("right", track)) return thing ?? "";
    return name === "left" ? tr("{thing} on the left", { thing }) : tr("{thing} on the right", { thing });
  }
  function forceOn(on, by) {
    return tr("force on {on} by {by}", { on, by });
  }
  function listed(names) {
    const [first = "", second] = names;
    if (second === void 0) return first;
    const rest = inRow(names.slice(0, -1));
    return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
  }

  // ../view/measured/units.js
  var QUANTITY = {
    time: ["t", "s"],
    length: ["x", "m"],
    force: ["F", "N"],
    acceleration: ["a", "m/s²"]
  };
  var open2 = ({ assumed, chosen }) => assumed.filter((kind2) => !chosen?.[kind2]);
  var howRead = ({ assumed, chosen, read }) => [
    ...assumed.flatMap(
      (kind2) => chosen?.[kind2] ? tr("{letter} in {unit} (as chosen)", { letter: QUANTITY[kind2][0], unit: chosen[kind2] }) : []
    ),
    ...read.map(told)
  ];
  function heads(read) {
    const left = open2(read);
    const named3 = (kind2, cart2 = "") => {
      const [letter, unit] = QUANTITY[kind2];
      const what = cart2 ? tr("{letter} of {cart}", { letter, cart: cart2 }) : letter;
      return left.some((one) => one === kind2) ? what : tr("{letter} in {unit}", { letter: what, unit });
    };
    return {
      time: named3("time"),
      value: named3(read.kind),
      tracks: read.names.map((name) => named3(read.kind, name))
    };
  }
  function semicolons([first = "", ...rest]) {
    return rest.reduce((before, then) => tr("{first}; {then}", { first: before, then }), first);
  }

  // ../view/measured/table.js
  var PLACES = 4;
  function tableOf2(read, residuals) {
    const { names, tracks } = read;
    const { time, tracks: its } = heads(read);
    const head2 = [time, ...its];
    if (residuals) head2.push(...names.map((cart2) => tr("residual of {cart} in mm", { cart: cart2 })));
    const found = /* @__PURE__ */ new Map();
    for (const [k, track] of tracks.entries()) {
      for (const [n, t] of track.t.entries()) {
        const cells = found.get(t) ?? Array.from({ length: head2.length - 1 }, () => "");
        cells[k] = fixed(Number(track.value[n]), PLACES);
        if (residuals) cells[2 + k] = fixed(1e3 * Number(residuals[k]?.[n]), 2);
        found.set(t, cells);
      }
    }
    const rows = [...found].sort(([a], [b]) => a - b).map(([t, cells]) => [fixed(t, PLACES), ...cells]);
    return { head: head2, rows };
  }

  // ../view/measured/skeleton.js
  var MOST_ROWS = 60;
  var UNITS = [
    ["length", () => tr("lengths are in")],
    ["time", () => tr("times are in")],
    ["force", () => tr("forces are in")]
  ];
  var HANDS = [
    ["touch", () => tr("first touch at"), "s"],
    ["va", () => tr("velocity of {cart} before", { cart: "A" }), "m/s"],
    ["vb", () => tr("velocity of {cart} before", { cart: "B" }), "m/s"],
    ["ratio", () => tr("mass of {b} ÷ mass of {a}", { a: "A", b: "B" }), ""],
    ["e", () => tr("bounciness e"), ""],
    ["duration", () => tr("the contact lasts"), "s"]
  ];
  var SIGNED = ["touch", "va", "vb"];
  var LAWS = { bumper: () => tr("bumper"), paper: () => tr("paper") };
  function inside2(facts) {
    const { id, title } = facts;
    const hint = html2`<text class="carts-measured-hint" x="320" y="130" text-anchor="middle">${tr("Open a file or a film, drop it here, or type readings.")}</text>`;
    return html2`<div class="carts-measured-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
${source(facts)}
<div class="carts-measured-world" hidden><svg class="carts-measured-stage" viewBox="0 0 640 96" width="640" height="96" role="img" aria-label=${tr("the model’s carts; rings are the measured places")}></svg>
<div class="carts-transport carts-measured-transport"><button type="button" class="carts-button carts-play carts-measured-play">${tr("Play")}</button><input type="range" class="carts-measured-scrub" min="0" max="1" step="any" value="0" aria-label=${tr("time")}><span class="carts-measured-clock"></span></div></div>
<div class="carts-measured-figures">
<p class="carts-measured-legend"></p>
<div class="carts-measured-spans" hidden></div>
<svg class="carts-measured-figure" viewBox="0 0 640 284" width="640" height="284" role="img" aria-label=${tr("readings over time; the numbers are in the table below")}>${!facts.read && hint}</svg>
<svg class="carts-measured-left" viewBox="0 0 640 134" width="640" height="134" role="img" aria-label=${tr("residuals: measured minus model")} hidden></svg>
<p class="carts-measured-spread" role="status"></p>
</div>
${model(facts)}
<div class="carts-measured-result" hidden></div>
<div class="carts-measured-back" hidden>
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-scene">${tr("Save the fitted scene")}</button> <button type="button" class="carts-button carts-measured-tracker">${tr("Save the model’s run for Tracker")}</button> <button type="button" class="carts-button carts-measured-print">${tr("Print this alone")}</button></p>
<details class="carts-more"><summary>${tr("The fitted scene as a block of a lesson")}</summary><textarea class="carts-measured-fence" rows="10" readonly spellcheck="false" aria-label=${tr("block of a lesson")}></textarea></details>
</div>
${table2(facts)}
<noscript><p class="carts-noscript">${tr("The readings are shown. Fitting them here needs JavaScript; on the command line “carts fit” does the same.")}</p></noscript>
</div>`;
  }
  function source({ name, units, offered, read }) {
    const choices = UNITS.map(([kind2, text2], k) => {
      const options = offered[kind2].map(
        (unit) => html2`<option value=${unit}${units?.[kind2] === unit && html2` selected`}>${unit}</option>`
      );
      const said = read && !read.assumed.some((one) => one === kind2) && html2` hidden`;
      return html2`${k > 0 && " "}<label${said}>${text2()} <select autocomplete="off" class="carts-measured-unit" data-kind=${kind2} disabled><option value="">${tr("choose …")}</option>${options}</select></label>`;
    });
    const own = html2`<button type="button" class="carts-button carts-measured-own" disabled>${tr("The lesson’s readings")}</button> `;
    return html2`<div class="carts-measured-source">
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-open" disabled>${tr("Open a file")}</button><input type="file" class="carts-measured-file" accept=".txt,.csv,.tsv,.trk,.trz,.zip,text/plain,text/csv,application/zip" multiple hidden tabindex="-1" aria-label=${tr("files with readings")}> ${film()}${name && own}<button type="button" class="carts-button carts-measured-save" disabled>${tr("Save these readings")}</button></p>
<details class="carts-more carts-measured-paste"><summary>${tr("Paste readings")}</summary><label>${tr("Text from Tracker, a spreadsheet or a sensor")} <textarea rows="6" spellcheck="false" autocomplete="off" disabled></textarea></label><p class="carts-measured-row"><button type="button" class="carts-button carts-measured-take" disabled>${tr("Read this text")}</button></p></details>
<details class="carts-more carts-measured-type"><summary>${tr("Type readings")}</summary><div class="carts-scroll" role="group" aria-label=${tr("table to type readings into")}><table class="carts-table carts-measured-grid"><thead><tr><th scope="col">t</th><th scope="col">${tr("{letter} of {cart}", { letter: "x", cart: "A" })}</th><th scope="col">${tr("{letter} of {cart}", { letter: "x", cart: "B" })}</th></tr></thead><tbody></tbody></table></div><p class="carts-measured-row"><button type="button" class="carts-button carts-measured-more" disabled>${tr("More rows")}</button> <button type="button" class="carts-button carts-measured-typed-take" disabled>${tr("Read this table")}</button></p></details>
<p class="carts-measured-row">${choices}</p>
<p class="carts-measured-row"><label class="carts-measured-runs" hidden>${tr("run")} <select autocomplete="off" class="carts-measured-run"></select></label> <label>${tr("use readings from")} <input type="text" autocomplete="off" class="carts-measured-from" disabled> s</label> <label>${tr("until")} <input type="text" autocomplete="off" class="carts-measured-until" disabled> s</label></p>
<p class="carts-measured-said" role="status">${name && `${name}: ${read ? semicolons(howRead(read)) : ""}`}</p>
<div role="alert"><ul class="carts-measured-faults carts-measured-unread"></ul></div>
</div>`;
  }
  function film() {
    return html2`<button type="button" class="carts-button carts-measured-film" disabled>${tr("Choose a film")}</button><input type="file" class="carts-measured-film-file" accept="video/*,.mp4,.m4v,.mov,.webm" hidden tabindex="-1" aria-label=${tr("film of the carts")}> <button type="button" class="carts-button carts-measured-camera" hidden disabled>${tr("Film with the camera")}</button> `;
  }
  function model({ id, law }) {
    const hands = HANDS.map(
      ([key, text2, unit]) => html2`<div class="carts-measured-hand" data-hand=${key}><label for="${id}-${key}">${text2()}</label><input type="range" class="carts-measured-slide" aria-label=${text2()} disabled><span class="carts-measured-typed"><input type="text" id="${id}-${key}" inputmode=${SIGNED.includes(key) ? "text" : "decimal"} autocomplete="off" disabled> ${unit}</span></div>`
    );
    const laws = Object.entries(LAWS).map(
      ([name, text2]) => html2`<option value=${name}${law === name && html2` selected`}>${text2()}</option>`
    );
    return html2`<div class="carts-measured-model" hidden>
<p class="carts-heading">${tr("Set the model by hand, or let it be fitted")}</p>
<div class="carts-measured-hands">${hands}</div>
<p class="carts-measured-row"><label>${tr("contact law")} <select autocomplete="off" class="carts-measured-law">${laws}</select></label> <label>${tr("fit also")} <select autocomplete="off" class="carts-measured-effect"><option value="none">${tr("nothing else")}</option><option value="friction">${tr("friction of each cart")}</option><option value="tilt">${tr("a tilt of the track")}</option><option value="both">${tr("friction and a tilt")}</option><option value="called">${tr("what the readings call for")}</option></select></label></p>
<p class="carts-measured-row carts-measured-masses carts-measured-rare"></p>
<p class="carts-measured-row carts-measured-rare"><label>${tr("marks are apart, when the bumpers just touch:")} <input type="text" inputmode="decimal" autocomplete="off" class="carts-measured-distance"> m</label> <span class="carts-quiet">${tr("if you know it")}</span></p>
<p class="carts-measured-row carts-measured-rare"><label><input type="checkbox" class="carts-measured-together"> ${tr("I saw that the carts stayed together")}</label> <span class="carts-quiet">${tr("where a sensor lost one of them")}</span></p>
<div role="alert"><ul class="carts-measured-faults carts-measured-unfitted"></ul></div>
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-fit">${tr("Fit the model")}</button> <button type="button" class="carts-button carts-measured-compare">${tr("Compare with friction and tilt")}</button> <span class="carts-measured-busy" role="status"></span></p>
</div>`;
  }
  function table2({ read }) {
    const { head: head2, rows } = read ? tableOf2(read, null) : { head: [], rows: [] };
    const heads2 = head2.map((cell) => html2`<th scope="col">${cell}</th>`);
    const lines3 = rows.slice(0, MOST_ROWS).map((row) => html2`<tr>${row.map((cell) => html2`<td>${cell}</td>`)}</tr>`);
    const more = rows.length - lines3.length;
    return html2`<details class="carts-more carts-measured-table"><summary>${tr("Table of the readings")}</summary><div class="carts-scroll" role="group" tabindex="0" aria-label=${tr("readings")}><table class="carts-table"><thead><tr>${heads2}</tr></thead><tbody>${lines3}</tbody></table></div>${more > 0 && html2`<p class="carts-measured-rest">${counted("and 1 more row", "and {n} more rows", more)}</p>`}</details>`;
  }

  // ../effects/drag/view.js
  var view_default = {
    name: tr("air resistance"),
    row: 4,
    side: () => "above",
    agent: () => tr("the air"),
    around: tr("air"),
    warms: () => tr("air"),
    phrase({ numbers: { linear, quadratic } }, { everyone, on, seen: seen2 }) {
      const sizes = [
        linear ? tr("{size} N per {unit}", { size: short(linear), unit: "m/s" }) : "",
        quadratic ? tr("{size} N per {unit}", { size: short(quadratic), unit: "(m/s)²" }) : ""
      ].filter(Boolean);
      return [
        everyone ? tr("drag by the air") : tr("drag on {carts} by the air", { carts: on }),
        seen2(listed(sizes) || "0 N")
      ];
    }
  };

  // ../effects/friction/view.js
  var TOOTH = 4;
  var view_default2 = {
    name: tr("friction"),
    row: 3,
    side: () => "below",
    agent: () => tr("the track"),
    around: tr("track"),
    earth: true,
    warms: () => tr("track"),
    phrase({ numbers: { coefficient = 0, static: held = coefficient } }, { everyone, on, seen: seen2 }) {
      const size = `μ = ${short(coefficient)}`;
      const rest = tr("(at rest up to {coefficient})", { coefficient: short(held) });
      return [
        everyone ? tr("friction by the track") : tr("friction on {carts} by the track", { carts: on }),
        seen2(held > coefficient ? `${size} ${rest}` : size)
      ];
    },
    pieces: rough
  };
  function rough({ carts }, { key, header: { bodies, track }, layout, face, centre }) {
    const piece = { cls: "carts-rough", behind: true };
    if (carts.length < bodies.length) {
      return carts.map((name) => {
        const length = (bodies.find((body2) => body2.name === name)?.length ?? 0) * layout.scale;
        const d2 = teeth(centre(name) - length / 2, length, layout.track);
        return { ...piece, key: `${key} ${name}`, d: d2 };
      });
    }
    const start = track.left === "wall" ? face("left", "right") : -layout.width;
    const end2 = track.right === "wall" ? face("right", "left") : 2 * layout.width;
    const tooth = 2 * TOOTH;
    const first = Math.max(start, -tooth + (start % tooth + tooth) % tooth);
    const d = teeth(first, Math.min(end2, layout.width) - first, layout.track);
    return [{ ...piece, key, d }];
  }
  function teeth(x, length, y) {
    const count2 = Math.max(0, Math.floor(length / (2 * TOOTH)));
    return `M${px(x)} ${px(y)}${`l${px(TOOTH)} ${px(TOOTH)}l${px(TOOTH)} ${px(-TOOTH)}`.repeat(count2)}`;
  }

  // ../effects/incline/view.js
  var STEEPEST = 22;
  var ROW = 24;
  var LENGTH = { wide: 120, narrow: 90 };
  var view_default3 = {
    name: tr("a slope"),
    row: 1,
    agent: () => tr("the Earth"),
    earth: true,
    stored: tr("as height, above the lowest point"),
    slope: ({ numbers }) => numbers.angle ?? 0,
    forceName: (on, by) => tr("part of the weight of {on}, along the track: force on {on} by {by}", { on, by }),
    label: (told3) => tr("on {on} by {by} (slope): {size} N", told3),
    phrase: ({ numbers }, { everyone, on }) => [
      everyone ? tr("a slope") : tr("a slope on {carts}", { carts: on }),
      slopeText(numbers.angle ?? 0)
    ],
    pieces({ index, carts, numbers: { angle = 0 } }, { key, header, layout }) {
      const slope = Math.abs(Math.tan(angle));
      const longest = LENGTH[layout.kind] ?? 0;
      const length = slope ? Math.min(longest, STEEPEST / slope) : longest;
      const inclines = header.effects.filter(({ kind: kind2 }) => kind2 === "incline");
      const place4 = inclines.findIndex((one) => one.index === index);
      const [x, y, rise] = [12, layout.tilt + ROW * Math.max(0, place4), length * slope];
      const whose = carts.length < header.bodies.length ? `${listed(carts)}: ` : "";
      const [tall, flat] = angle > 0 ? [x, x + length] : [x + length, x];
      const d = `M${px(tall)} ${px(y)}V${px(y - rise)}L${px(flat)} ${px(y)}Z`;
      const words = {
        text: whose + tiltText(angle),
        x: px(x + length + 10),
        y: px(y),
        anchor: "start"
      };
      return [
        { key, cls: "carts-wedge", behind: true, d },
        { key: `${key} words`, cls: "carts-tilt", behind: true, ...words }
      ];
    }
  };
  function tiltText(angle) {
    if (!angle) return tr("the track is level: 0°");
    const words = tr("track tilted {slope}", { slope: slopeText(angle) });
    return angle > 0 ? `${words} →` : `← ${words}`;
  }
  function slopeText(angle) {
    const size = short(Math.abs(angle) * 180 / Math.PI);
    if (size === "0") return tr("0°: the track is level");
    return angle > 0 ? tr("{angle}° down to the right", { angle: size }) : tr("{angle}° down to the left", { angle: size });
  }

  // ../effects/magnets/view.js
  var POLE = 14;
  var POLES = [
    ["N", "carts-north"],
    ["S", "carts-south"]
    // only where there is room
  ];
  var view_default4 = {
    name: tr("magnets"),
    link: tr("magnets"),
    apart: true,
    stored: tr("between the magnets"),
    phrase: (_, { both: both2 }) => [tr("magnets on {bodies}, like poles facing", { bodies: both2 })],
    pieces({ between: between2 }, { key, layout, face }) {
      const [a, b] = between2 ?? ["", ""];
      return [
        ...poles(`${key} ${a}`, face(a, "right"), -1, layout),
        ...poles(`${key} ${b}`, face(b, "left"), 1, layout)
      ];
    }
  };
  function poles(key, x, direction, { kind: kind2, track }) {
    const top = track - 40;
    return POLES.slice(0, kind2 === "wide" ? 2 : 1).flatMap(([pole = "", cls = ""], k) => {
      const start = x + direction * k * POLE;
      const d = `M${px(start)} ${px(top)}h${px(direction * POLE)}v16h${px(-direction * POLE)}Z`;
      const letter = { text: pole, x: px(start + direction * POLE / 2), y: px(top + 13) };
      return [
        { key: `${key} ${pole}`, cls, d },
        { key: `${key} ${pole} letter`, cls: "carts-pole", anchor: "middle", ...letter }
      ];
    });
  }

  // ../view/shapes.js
  var DOT = 2.5;
  var RING = 1;
  var SHORTEST = 0.5;
  var PUSH = 15.5;
  var TURNS = 9;
  var LEAD = 5;
  var COIL = 7;
  function bodyWidth(body2) {
    return Math.max(body2.length - 2 * body2.bumper_length, 0.2 * body2.length);
  }
  function coil(start, end2, y, turns = TURNS, high = COIL) {
    const span2 = Math.max(0, end2 - start);
    const lead = Math.min(LEAD, span2 / 4);
    const step = (span2 - 2 * lead) / turns;
    let d = `M${px(start)} ${px(y)}L${px(start + lead)} ${px(y)}`;
    for (let k = 0; k < turns; k += 1) {
      d += `L${px(start + lead + (k + 0.5) * step)} ${px(k % 2 === 0 ? y - high : y + high)}`;
    }
    return `${d}L${px(start + span2 - lead)} ${px(y)}L${px(start + span2)} ${px(y)}`;
  }
  function blockArrow(x, y, length) {
    if (Math.abs(length) < SHORTEST) return dot(x, y);
    const tip = x + length;
    const neck = tip - Math.sign(length) * Math.min(9, Math.abs(length));
    return `M${px(x)} ${px(y - 3)}L${px(neck)} ${px(y - 3)}L${px(neck)} ${px(y - 6.5)}L${px(tip)} ${px(y)}L${px(neck)} ${px(y + 6.5)}L${px(neck)} ${px(y + 3)}L${px(x)} ${px(y + 3)}Z`;
  }
  function lineArrow(x, y, length) {
    if (Math.abs(length) < SHORTEST) return dot(x, y, RING);
    const tip = x + length;
    const back = tip - Math.sign(length) * Math.min(7, Math.abs(length));
    return `M${px(x)} ${px(y)}L${px(tip)} ${px(y)}M${px(back)} ${px(y - 4.5)}L${px(tip)} ${px(y)}L${px(back)} ${px(y + 4.5)}`;
  }
  function dot(x, y, radius = DOT) {
    const [r, d] = [px(radius), px(2 * radius)];
    return `M${px(x - radius)} ${px(y)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 -${d} 0Z`;
  }

  // ../view/trajectory.js
  function fromBaked(numbers, events) {
    const parts = { t: Float64Array.from(numbers.t), events };
    for (const quantity of ["x", "v", "a", "F", "dF", "E"]) {
      parts[quantity] = {};
      for (const [key, column] of Object.entries(numbers[quantity] ?? {})) {
        parts[quantity][key] = Float64Array.from(column);
      }
    }
    return parts;
  }
  function rowAt(times2, t) {
    let low = 0;
    let high = times2.length;
    while (low < high) {
      const middle = low + high >> 1;
      if (times2[middle] <= t) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
  function valueAt2(times2, values, slopes, t) {
    const k = rowAt(times2, t);
    if (k < 0) return Number(values[0]);
    if (k >= times2.length - 1) return Number(values[values.length - 1]);
    return hermite(times2, values, slopes, k, t);
  }
  function hermite(times2, values, slopes, k, t) {
    const at = ((c, i) => c[i]);
    const h = at(times2, k + 1) - at(times2, k);
    const s = (t - at(times2, k)) / h;
    if (!slopes) return at(values, k) + (at(values, k + 1) - at(values, k)) * s;
    const r = 1 - s;
    const found = at(values, k) * (1 + 2 * s) * r * r + at(slopes, k) * h * s * r * r + at(values, k + 1) * (1 + 2 * r) * s * s - at(slopes, k + 1) * h * r * s * s;
    return Number.isFinite(found) ? found : at(values, k);
  }

  // ../effects/push/view.js
  var LET_GO = 1.5;
  var BACK = 0.2;
  var ROOM = 16;
  var MIDDLE = 29;
  var HAND = "M-46 -6L-31 -7C-26 -9 -22 -6 -17 -3.5L-3 -3.5C1 -3.5 1 3 -3 3L-15 3C-10 3 -10 7.5 -15 7.5C-11 7.5 -11 12 -16 12C-13 12 -13 16 -18 16C-26 17 -29 14 -32 9L-46 9M-15 3h-7M-15 7.5h-6M-16 12h-5M-29 0C-24 0 -21 -1 -19 3M-38 -9h-8v20h8Z";
  var view_default5 = {
    name: tr("pushes from outside"),
    row: 2,
    side: (force) => force < 0 ? "right" : "left",
    around: (_, agent2) => agent2,
    acts: ({ numbers: { from = 0, until = Infinity } }, t) => t >= from && t < until,
    seen: (effect, t) => begun(effect, t) && t < end(effect) + (isHand(effect) ? LET_GO : 0),
    phrase: (effect, { agent: agent2, seen: seen2 }) => [
      tr("a push on {cart} by {agent}", { cart: String(effect.carts[0]), agent: agent2 }),
      seen2(forceText(effect.numbers.force ?? 0)),
      times(effect)
    ],
    pieces(effect, { key, header, run, t, layout, centre }) {
      const { carts, numbers } = effect;
      const name = String(carts[0]);
      const y = layout.track;
      const direction = (numbers.force ?? 0) >= 0 ? 1 : -1;
      const body2 = header.bodies.find((one) => one.name === name);
      const side2 = centre(name) - direction * ((body2 ? bodyWidth(body2) * layout.scale : 0) / 2);
      if (isHand(effect)) {
        const past = t - end(effect);
        if (past >= 0 && goesOn(effect, header)) return [];
        const gone = past < 0 ? 0 : direction * ROOM * Math.min(1, past / BACK);
        const left = past < 0 ? side2 : side2 - (place2(run, name, t) - place2(run, name, end(effect))) * layout.scale;
        return [{ key, cls: "carts-hand carts-palm", d: hand(left - gone, y - MIDDLE, direction) }];
      }
      const x = side2 - 3 * direction;
      const d = `M${px(x)} ${px(y - 38)}v14M${px(x)} ${px(y - 31)}h${px(-direction * 26)}`;
      return [{ key, cls: "carts-hand", behind: true, d }];
    },
    marks({ carts, numbers: { from = 0, until: end2, force = 0 } }, agent2, until, told3) {
      const who = { cart: String(carts[0]), agent: agent2 };
      const begins = told3 ? tr("The push on {cart} by {agent} begins: {force}.", { ...who, force: forceText(force) }) : tr("The push on {cart} by {agent} begins.", who);
      const marks = from <= until ? [{ t: from, sentence: begins }] : [];
      if (end2 !== void 0 && from < end2 && end2 <= until) {
        marks.push({ t: end2, sentence: tr("The push on {cart} by {agent} ends.", who) });
      }
      return marks;
    }
  };
  var isHand = ({ by }) => !by || by === "hand";
  var begun = ({ numbers: { from = 0 } }, t) => t >= from;
  var end = ({ numbers: { until = Infinity } }) => until;
  function goesOn(effect, { effects }) {
    const on = (one) => one.active && one.kind === effect.kind && one.carts[0] === effect.carts[0] && isHand(one);
    return effects.some((one) => on(one) && one !== effect && (one.numbers.from ?? 0) >= end(effect));
  }
  function place2({ trajectory: { t: times2, x, v } }, name, t) {
    return valueAt2(times2, x[name] ?? [], v[name] ?? [], t);
  }
  function hand(x, y, direction) {
    let across2 = true;
    let absolute = true;
    return HAND.replace(/[MLCvhZ]|-?[\d.]+/g, (part) => {
      if (/[a-zA-Z]/.test(part)) {
        across2 = part !== "v";
        absolute = part === part.toUpperCase();
        return part;
      }
      const number = Number(part);
      const shown2 = across2 ? direction * number + (absolute ? x : 0) : number + (absolute ? y : 0);
      across2 = absolute ? !across2 : across2;
      return ` ${px(shown2)}`;
    });
  }
  function forceText(force) {
    const size = short(Math.abs(force));
    return force >= 0 ? tr("{size} N to the right", { size }) : tr("{size} N to the left", { size });
  }
  function times({ numbers: { from = 0, until } }) {
    if (until !== void 0) {
      return tr("from {from} s to {until} s", { from: short(from), until: short(until) });
    }
    return from ? tr("from {from} s", { from: short(from) }) : "";
  }

  // ../effects/release/view.js
  var HALF = 9;
  var TURNS2 = 7;
  var HIGH = 4;
  var ABOVE = 28;
  var view_default6 = {
    name: tr("a release between the carts"),
    leftOut: tr("springs that are let go"),
    link: tr("spring"),
    lasts: ({ numbers }) => numbers.stiffness !== void 0,
    // else an impulse: no force to be drawn
    stored: tr("in the squeezed spring"),
    acts: ({ numbers: { at = 0, stiffness } }, t) => t < at || stiffness !== void 0,
    phrase: ({ numbers: { energy = 0, at = 0, stiffness } }, { both: both2, seen: seen2 }) => [
      stiffness === void 0 ? tr("an exploder between {bodies}", { bodies: both2 }) : tr("a squeezed spring between {bodies} that is let go", { bodies: both2 }),
      seen2(`${short(energy)} J`),
      stiffness === void 0 ? "" : seen2(`${short(stiffness)} N/m`),
      tr("at {time} s", { time: short(at) })
    ],
    pieces(effect, { key, run, t, layout, face }) {
      const [a, b] = effect.between ?? ["", ""];
      const [begun2, ended2] = pushes(effect, run);
      const low = layout.track - ABOVE;
      const ends2 = [face(a, "right"), face(b, "left")].map(Number);
      if (t > ended2) {
        const there = edge2(run, a, ended2) - edge2(run, a, t);
        const start2 = Number(ends2[0]) + there * layout.scale - HALF;
        const long = (edge2(run, b, ended2, -1) - edge2(run, a, ended2)) * layout.scale;
        const lying = coil(start2, start2 + long + 2 * HALF, layout.track - HIGH, TURNS2, HIGH);
        return [{ key: `${key} lying`, cls: "carts-coil carts-spent", behind: true, d: lying }];
      }
      const middle = (Number(ends2[0]) + Number(ends2[1])) / 2;
      const [start = 0, end2 = 0] = t < begun2 ? [middle, middle] : ends2;
      const wire = coil(start - HALF, end2 + HALF, low, TURNS2, HIGH);
      const plates = t < begun2 ? `M${px(start - HALF - 1)} ${px(low + 7)}v-15h20v15` : `M${px(start - HALF - 1)} ${px(low + 7)}v-14M${px(end2 + HALF + 1)} ${px(low + 7)}v-14`;
      return [
        { key, cls: "carts-coil", d: wire },
        { key: `${key} latch`, cls: "carts-latch", d: plates }
      ];
    }
  };
  function pushes({ between: between2, numbers: { at = 0 } }, { header, trajectory }) {
    const pair = between2?.join("-");
    const mine = header.events.filter(({ bodies }) => bodies.join("-") === pair);
    const begun2 = mine.find(({ kind: kind2, t }) => kind2 === "release" && t === at);
    if (!begun2 || trajectory.t.length < 2) return [Infinity, Infinity];
    const ended2 = mine.find(({ kind: kind2, t }) => kind2 === "separate" && t > begun2.t);
    return [begun2.t, ended2?.t ?? Infinity];
  }
  function edge2({ header, trajectory }, name, t, direction = 1) {
    const half = (header.bodies.find((body2) => body2.name === name)?.length ?? 0) / 2;
    return valueAt2(trajectory.t, trajectory.x[name] ?? [], trajectory.v[name] ?? [], t) + direction * half;
  }

  // ../effects/spring/view.js
  var view_default7 = {
    name: tr("springs between the carts"),
    link: tr("spring"),
    stored: tr("in the spring"),
    warms: ({ numbers }) => (numbers.damping ?? 0) > 0 ? tr("spring") : "",
    phrase({ numbers: { stiffness = 0, length = 0, damping } }, { both: both2, seen: seen2 }) {
      const natural = tr("natural length {length} m", { length: short(length) });
      return [
        tr("a spring between {bodies}", { bodies: both2 }),
        damping ? tr("damped") : "",
        seen2(`${short(stiffness)} N/m, ${natural}`)
      ];
    },
    pieces({ numbers, between: between2 }, { key, layout, face }) {
      const [a, b] = between2 ?? ["", ""];
      const [start, end2] = [face(a, "right"), face(b, "left")];
      const length = (numbers.length ?? 0) * layout.scale;
      const middle = (start + end2) / 2;
      const low = a === "left" ? start : b === "right" ? end2 - length : middle - length / 2;
      const y = layout.track - PUSH - COIL - 5;
      const measure = `M${px(low)} ${px(y - 3)}v6M${px(low)} ${px(y)}h${px(length)}m0 -3v6`;
      return [
        { key, cls: "carts-coil", d: coil(start, end2, layout.track - PUSH) },
        { key: `${key} natural`, cls: "carts-natural", d: measure }
      ];
    }
  };

  // ../effects/views.js
  var VIEWS = {
    drag: view_default,
    friction: view_default2,
    incline: view_default3,
    magnets: view_default4,
    push: view_default5,
    release: view_default6,
    spring: view_default7
  };

  // ../view/effects.js
  var LAST = 100;
  function viewOf(kind2) {
    return { name: kind2, row: LAST, ...VIEWS[kind2] };
  }
  function nameOf({ kind: kind2, called }) {
    const name = VIEWS[kind2]?.name ?? (called && told(called));
    if (!name) throw new Error(`nobody describes an effect of the kind “${kind2}”`);
    return name;
  }
  function agent(effect) {
    const named3 = effect.by || effect.agent;
    return viewOf(effect.kind).agent?.(effect) ?? (named3 ? told(named3) : nameOf(effect));
  }
  function kindsOnOne({ effects }) {
    const kinds = new Set(effects.filter(({ between: between2 }) => !between2).map(({ kind: kind2 }) => kind2));
    return [...kinds].sort((a, b) => viewOf(a).row - viewOf(b).row || (a < b ? -1 : 1));
  }
  function isLink(effect) {
    const { link, lasts } = viewOf(effect.kind);
    return effect.between !== null && link !== null && (lasts?.(effect) ?? true);
  }
  function linkedPairs({ effects }) {
    return new Set(effects.filter(isLink).map(({ between: between2 }) => String(between2?.join("-"))));
  }
  function effectOf(target, { effects }) {
    const owner = target.slice(0, target.lastIndexOf("."));
    return effects.find(
      ({ kind: kind2, index }) => [kind2, `effects.${index}`, `effects.${index}.${kind2}`].includes(owner)
    );
  }

  // ../view/words.js
  var QUANTITIES = {
    x: [tr("Position"), "x", "m"],
    v: [tr("Velocity"), "v", "m/s"],
    a: [tr("Acceleration"), "a", "m/s²"],
    F: [tr("Contact force"), "F", "N"],
    R: [tr("Resultant force"), "R", "N"],
    p: [tr("Momentum"), "p", "kg m/s"],
    energy: [tr("Kinetic energy"), "E", "J"]
  };
  var IMPULSE_ONLY = tr("too large and too short to draw: see the impulses under “What happens”");
  var JUMP_ONLY = tr("where v jumps, the acceleration is too large and too short to draw");
  function motion(velocity2, decimals, scale) {
    if (isRest(velocity2, scale)) return tr("at rest");
    const [per, unit] = speedUnit(scale);
    const speed = `${fixed(Math.abs(velocity2) / per, decimals)} ${unit}`;
    return velocity2 > 0 ? tr("{speed} to the right", { speed }) : tr("{speed} to the left", { speed });
  }
  function isRest(velocity2, scale) {
    return Math.abs(velocity2) < NOISE * scale;
  }
  function lower(name) {
    return name.slice(0, 1).toLowerCase() + name.slice(1);
  }

  // ../view/effects-forces.js
  function outside(header) {
    const { effects, track } = header;
    const sides = ["left", "right"];
    const walls = sides.filter((side2) => track[side2] === "wall").map((side2) => kind(side2, track));
    const kinds = kindsOnOne(header).map(viewOf);
    const media = kinds.map(({ around }) => typeof around === "string" ? around : "");
    const others = effects.map((effect) => {
      const { around } = viewOf(effect.kind);
      return typeof around === "function" ? around(effect, agent(effect)) : "";
    });
    const earth = walls.length || kinds.some((view) => view.earth) ? tr("Earth") : "";
    const parts = [...walls, ...media, ...others, earth];
    return [...new Set(parts.filter(Boolean))].join(" + ");
  }

  // ../view/forces.js
  function verticalNote(header) {
    return header.bodies.some(({ name }) => slopeOf(header, name)) ? tr(
      "On a slope the support balances only the part of the weight across the track; the rest of the weight acts along it. Weight and support are no third-law pair: the partner of the weight pulls on the Earth."
    ) : tr(
      "Weight and support are equal and opposite here, but both act on one cart: they balance. They are no third-law pair: the partner of the weight pulls on the Earth."
    );
  }
  function slopeOf({ effects }, name) {
    return effects.filter(({ active, carts }) => active && carts.includes(name)).reduce((sum, effect) => sum + (viewOf(effect.kind).slope?.(effect) ?? 0), 0);
  }

  // ../view/markers.js
  var MARKERS = {
    b0: "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0Z",
    b1: "M-3.5 -3.5H3.5V3.5H-3.5Z",
    b2: "M0 -5L5 0L0 5L-5 0Z",
    b3: "M-4.5 3.5L0 -4.5L4.5 3.5Z",
    b4: "M-4.5 -3.5L0 4.5L4.5 -3.5Z",
    b5: "M-4 -1.5H-1.5V-4H1.5V-1.5H4V1.5H1.5V4H-1.5V1.5H-4Z",
    b6: "M-4.5 -2.5H4.5V2.5H-4.5Z",
    b7: "M-2.5 -4.5H2.5V4.5H-2.5Z",
    wall: "M-3 -3L3 3M-3 3L3 -3",
    total: "M-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0Z"
  };
  function styleOf(index) {
    return `b${index % 8}`;
  }

  // ../view/skeleton/beside.js
  function near(baked) {
    return showsForces(baked) && frame(baked, "carts-views carts-near", lens(baked));
  }
  function views(baked) {
    const forces = showsForces(baked) && freeBody(baked);
    return frame(
      baked,
      "carts-views",
      html2`${forces}
${bars(baked)}`
    );
  }
  function showsForces({ fence, run }) {
    const linked = linkedPairs(run.header);
    const touches = run.header.contacts.some(({ stiffness, pair }) => stiffness || linked.has(pair));
    return fence.forces === "shown" && touches;
  }
  function frame({ fence }, kinds, inside4) {
    return html2`<div class=${kinds}${fence.predict && html2` hidden`}>
${inside4}
</div>`;
  }
  var closed = ({ fence }, view) => !fence.opened.includes(view) && html2` hidden`;
  function freeBody(baked) {
    const { bodies } = baked.run.header;
    const rows = [
      [tr("resultant force"), "R", "N", "F"],
      [tr("mass"), "m", "kg", "mass"],
      [tr("acceleration"), "a = R/m", "m/s²", "a"],
      [tr("change of velocity"), "Δv", speedUnit(baked.view.velocity)[1], "dv"]
    ];
    const alone2 = bodies.map(
      ({ name }, i) => html2`<div class="carts-alone carts-${styleOf(i)}" data-body=${name}><svg viewBox="0 0 260 60" width="260" height="60" aria-hidden="true"><rect class="carts-box" x="20" y="8" width="220" height="44" rx="4"/><text class="carts-name" x="130" y="24">${name}</text><g data-part="forces"></g></svg><ul></ul></div>
`
    );
    const lines3 = rows.map(
      ([name, symbol, unit, quantity]) => html2`<tr><th scope="row">${name} <i>${symbol}</i>${quantity === "dv" && html2` <span class="carts-touch-note"></span>`}, ${unit}</th>${bodies.map((body2) => html2`<td data-body=${body2.name} data-quantity=${quantity}>–</td>`)}</tr>
`
    );
    return html2`<section class="carts-view carts-free-body" data-view="free-body"${closed(baked, "free-body")}>
<p class="carts-view-title"><span class="carts-heading">${tr("Forces on each cart")}</span> <label><input type="checkbox" class="carts-vertical"> ${tr("weight and support")}</label></p>
<div class="carts-bodies">
${alone2}</div>
<p class="carts-vertical-note">${verticalNote(baked.run.header)}</p>
<div class="carts-scroll"><table class="carts-table carts-pairs"><thead><tr><th scope="col"><span class="carts-hidden">${tr("quantity")}</span></th>${bodies.map(({ name }) => html2`<th scope="col">${name}</th>`)}</tr></thead><tbody>
${lines3}</tbody></table></div>
<p class="carts-quiet">${tr("The two forces of a contact have the same size at every instant. How much a velocity changes depends on the mass too.")}</p>
</section>`;
  }
  function lens(baked) {
    const sides = [0, 1].map(
      (k) => html2`<g data-side=${k}><rect data-part="body" class="carts-box" y="22" width="720" height="66"/><path data-part="spring" class="carts-spring"/><rect data-part="face" class="carts-face" x="-3" y="34" width="6" height="61" rx="2"/><text data-part="name" class="carts-name" y="42"></text><path data-part="arrow" class="carts-block-arrow"/></g>`
    );
    return html2`<section class="carts-view carts-lens" data-view="lens"${closed(baked, "lens")}>
<p class="carts-view-title"><span class="carts-heading">${tr("Lens on the contact, ×{times}", { times: 10 })}</span> <span class="carts-lens-note"></span></p>
<svg viewBox="0 0 360 110" width="360" height="110" aria-hidden="true"><path class="carts-rule" d="M0 96H360"/><path data-part="between" class="carts-coil"/>${sides}<path data-part="was" class="carts-was"/><path data-part="bar" class="carts-rule"/><text data-part="bar-text" y="17"></text><text data-part="when" x="8" y="108"></text></svg>
</section>`;
  }
  function bars(baked) {
    const rows = momenta(baked.run.header).map(
      ([label, style]) => html2`<tr class="carts-${style}"><th scope="row">${label}</th><td data-when="before">–</td><td class="carts-bars" aria-hidden="true"><svg viewBox="0 0 128 20" width="128" height="20"><path class="carts-zero" d="M64 0V20"/><rect data-part="before"/><rect data-part="now"/></svg></td><td data-when="now">–</td><td data-when="change">–</td></tr>
`
    );
    return html2`<section class="carts-view" data-view="bars"${closed(baked, "bars")}>
<p class="carts-heading">${tr("Momentum before and now")}</p>
<div class="carts-scroll"><table class="carts-table"><thead><tr><th scope="col"><i>p</i>${tr(" in {unit}", { unit: "kg m/s" })}</th><th scope="col">${tr("before,")} <span class="carts-touch-note"></span></th><th scope="col" aria-hidden="true"></th><th scope="col">${tr("now")}</th><th scope="col">${tr("change")}</th></tr></thead><tbody>
${rows}</tbody></table></div>
<p class="carts-quiet">${tr("Hollow: before. Filled: now. + is to the right.")}</p>
</section>`;
  }
  function momenta(header) {
    const around = outside(header);
    const rows = header.bodies.map(({ name }, i) => [name, styleOf(i)]);
    if (around) rows.push([around, "wall"]);
    if (rows.length > 1) rows.push([around ? tr("all together") : tr("all carts"), "total"]);
    return rows;
  }

  // ../view/effects-words.js
  function sizeName({ effects }) {
    return effects.some(isLink) ? tr("Size of the force between them") : tr("Size of the contact force");
  }

  // ../view/graph.js
  var LEFT2 = 52;
  var RIGHT2 = 350;
  var TOP2 = 8;
  var BOTTOM2 = 127;
  var WIDTH2 = 360;
  var HEIGHT2 = 160;

  // ../view/skeleton/graph.js
  var WITH_SIGN = html2` <button type="button" class="carts-sign" aria-pressed="false" disabled title=${tr("Show the direction: + means to the right")}>${tr("with sign")}</button>`;
  var LEDGER = html2` <button type="button" class="carts-sign carts-stack" aria-pressed="false" disabled title=${tr("Kinetic energy, squeezed bumpers and warmth on top of each other")}>${tr("as a ledger")}</button>`;
  var TOGGLES = { F: WITH_SIGN, energy: LEDGER };
  function graph({ fence, view, run }, quantity) {
    const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", "", ""];
    const isForce = quantity === "F";
    const name = isForce ? sizeName(run.header) : title;
    const camera = fence.camera && ["x", "v"].includes(quantity) ? tr("seen from the camera, ") : "";
    const measured = quantity === "v" ? speedUnit(view.velocity)[1] : unit;
    const label = tr("{quantity} against time", { quantity: name });
    const table3 = tr("Table: {quantity}", { quantity: lower(name) });
    return html2`<div class="carts-graph" data-quantity=${quantity} role="group" aria-label=${label}>
<p class="carts-graph-title"><span class="carts-graph-name">${name} ${camera}<i>${isForce ? "|F|" : symbol}</i>${tr(" in {unit}", { unit: measured })}</span>${TOGGLES[quantity]}</p>
${plot(`${fence.id}-${quantity}-clip`, isForce, fence.watch === "first")}
<p class="carts-key"></p>
${isForce && html2`<p class="carts-area-note carts-quiet">\u00a0</p>`}
<details class="carts-more"><summary>${table3}</summary>
<div class="carts-scroll"><table class="carts-table"><thead><tr><th scope="col">${tr("t in s")}</th></tr></thead><tbody></tbody></table></div></details>
</div>`;
  }
  function plot(clip, isForce, growing) {
    const inside4 = html2`clip-path="url(#${clip})"`;
    const shade = html2`<path class="carts-impulse" d=""/>`;
    const room = html2`<rect x=${LEFT2} y=${TOP2 - 4} width=${RIGHT2 - LEFT2 + 1} height=${BOTTOM2 - TOP2 + 8}/>`;
    const seen2 = `${clip}-seen`;
    return html2`<svg class="carts-plot" viewBox="0 0 ${WIDTH2} ${HEIGHT2}" width=${WIDTH2} height=${HEIGHT2} aria-hidden="true">
<defs><clipPath id=${clip}>${room}</clipPath>${growing && html2`<clipPath id=${seen2} class="carts-seen">${room}</clipPath>`}</defs>
<g data-part="times"></g>
<g data-part="values"></g>
<text class="carts-unit" x=${RIGHT2} y=${HEIGHT2 - 3} text-anchor="end">${tr("time t in s")}</text>
<g data-part="areas" clip-path="url(#${growing ? seen2 : clip})">${isForce && [shade, shade]}</g>
<g data-part="curves" ${inside4}></g>
<g data-part="cursor" ${inside4}><path class="carts-cursor" d="M0 ${TOP2}V${BOTTOM2}" transform="translate(${LEFT2} 0)"/></g>
</svg>`;
  }

  // ../view/skeleton/panel.js
  function panel(baked) {
    const { fence } = baked;
    const { controls, switches, presets } = fence;
    const names = Object.keys(presets);
    const buttons = names.map(
      (name) => html2`<button type="button" class="carts-button carts-preset" data-preset=${name} disabled>${name}</button>`
    );
    const all = fence.watch === "first" && names.length > 1;
    const left = all && html2` <span class="carts-presets-left" role="status">${tr("Watch each of them once.")}</span>`;
    const back = controls.length || switches.length || names.length;
    return html2`<div class="carts-side">
${names.length > 0 && html2`<p class="carts-presets" role="group" aria-label=${tr("Ready-made settings")}>${buttons}${left}</p>`}
<div class="carts-panel">
${cartCards(baked)}
${otherCards(baked)}
${effectCard(baked)}
</div>
<div class="carts-warnings" hidden></div>
<details class="carts-more carts-take"><summary>${tr("Take it along")}</summary></details>
${back > 0 && html2`<p class="carts-reset-row"><button type="button" class="carts-button carts-undo" disabled>${tr("Undo")}</button> <button type="button" class="carts-button carts-reset" disabled>${tr("Reset all values")}</button></p>`}
</div>`;
  }
  function cartCards(baked) {
    const { fence, run } = baked;
    return run.header.bodies.map(({ name }, i) => {
      const style = `carts-${styleOf(i)}`;
      const title = isWord(name) ? name : tr("Cart {name}", { name });
      const own = fence.controls.filter(({ set }) => ownerOf(set) === name);
      return html2`<div class="carts-card ${style}" role="group" aria-label=${title} data-body=${name}>
<p class="carts-heading"><svg class="carts-swatch" viewBox="0 0 26 12" width="26" height="12" aria-hidden="true"><path class="carts-curve ${style}" d="M0 6H26"/><path class="carts-dot ${style}" d=${MARKERS[styleOf(i)]} transform="translate(13 6)"/></svg>${title}</p>
${own.map((one) => control(one, fence.id))}
<dl class="carts-readouts">${readouts(baked)}</dl></div>
`;
    });
  }
  function readouts({ fence, view }) {
    const { camera, forces } = fence;
    const speed = speedUnit(view.velocity)[1];
    const rows = [
      [tr("mass"), "m", "mass", "kg"],
      [camera ? tr("position seen from the camera") : tr("position"), "x", "x", "m"],
      [camera ? tr("velocity seen from the camera") : tr("velocity"), "v", "v", speed]
    ];
    if (forces === "shown") {
      rows.push([tr("resultant force"), "R", "F", "N"], [tr("acceleration"), "a", "a", "m/s²"]);
    }
    return rows.map(
      ([name, symbol, quantity, unit]) => html2`<div><dt><span class="carts-word">${name} </span><i>${symbol}</i></dt><dd><span class="carts-value" data-quantity=${quantity}></span> ${unit}</dd></div>`
    );
  }
  function otherCards({ fence, run: { header } }) {
    const owners = header.bodies.map(({ name }) => name);
    const contact = fence.controls.filter(({ set }) => ownerOf(set) === "contact");
    const rest = fence.controls.filter(
      ({ set }) => ![...owners, "contact", "effects"].includes(ownerOf(set)) && !effectOf(set, header)
    );
    const cards = [
      [tr("Contact"), contact],
      [tr("Scene"), rest]
    ];
    return cards.filter(([, own]) => own.length).map(
      ([title, own]) => html2`<div class="carts-card" role="group" aria-label=${title}>
<p class="carts-heading">${title}</p>
${own.map((one) => control(one, fence.id))}</div>
`
    );
  }
  function effectCard({ fence, run: { header } }) {
    const own = fence.controls.filter(({ set }) => effectOf(set, header));
    if (!own.length && !fence.switches.length) return null;
    const title = tr("What acts");
    const boxes = fence.switches.map(
      ({ set, label, value }) => html2`<div class="carts-switch"><label><input type="checkbox" data-switch=${set} autocomplete="off"${value && html2` checked`} disabled> <span>${label}</span></label><p class="carts-error" hidden></p></div>`
    );
    return html2`<div class="carts-card carts-effect-card" role="group" aria-label=${title}>
<p class="carts-heading">${title}</p>
${boxes}
${own.map((one) => control(one, fence.id))}</div>`;
  }
  function control({ set, label, short: short3, unit, low, high, step, value }, id) {
    const decimals = Math.max(...[step, low, value].map((one) => decimalsOf(one)));
    const text2 = fixed(value, decimals).replace("−", "-");
    const box = `${id}-${set.replaceAll(".", "-")}`;
    const slider2 = tr("{label}, slider", { label });
    const measured = unit ? tr(" in {unit}", { unit }) : "";
    return html2`<div class="carts-control" data-set=${set}>
<label for=${box}>${short3}</label>
<input type="range" class="carts-slider" min=${low} max=${high} step=${step} value=${value} aria-label=${slider2} aria-valuetext="${text2} ${unit}" disabled>
<span class="carts-typed"><input type="text" class="carts-number-box" id=${box} inputmode="decimal" autocomplete="off" spellcheck="false" value=${text2} aria-label="${label}${measured}" disabled> <span class="carts-unit-text">${unit}</span></span>
<p class="carts-error" hidden></p>
</div>
`;
  }
  var ownerOf = (set) => set.split(".")[0] ?? "";

  // ../view/pad.js
  var LEFT3 = 40;
  var STEP = 77.5;
  var POINTS = 5;
  var HIGHEST = 10;
  var TOP3 = 10;
  var BOTTOM3 = 130;
  function pad(quantity) {
    const low = quantity === "F" ? 0 : -HIGHEST;
    const per = (BOTTOM3 - TOP3) / (HIGHEST - low);
    return { low, zero: TOP3 + HIGHEST * per, per };
  }
  function path({ zero, per }, heights) {
    const step = (POINTS - 1) * STEP / (heights.length - 1);
    const points = Array.from(
      heights,
      (height, k) => `${px(LEFT3 + k * step)} ${px(zero - per * height)}`
    );
    return `M${points.join("L")}`;
  }

  // ../view/skeleton/predict.js
  var FULL = 10;
  var STEP2 = 0.05;
  var CERTAINTY = [
    ["guess", tr("a guess")],
    ["think", tr("I think so")],
    ["sure", tr("I am sure")]
  ];
  var TIMES = {
    contact: [
      tr("at first touch"),
      tr("after a quarter"),
      tr("in the middle"),
      tr("after three quarters"),
      tr("at the end")
    ],
    run: [
      tr("at the start"),
      tr("after a quarter"),
      tr("in the middle"),
      tr("after three quarters"),
      tr("at the end")
    ]
  };
  var KNOBS = Array.from({ length: POINTS }, (_, k) => k);
  var FORMS2 = { arrows, curve: curve2, choice, text };
  function predict(baked, spec) {
    const { id } = baked.fence;
    const lock = spec.talk ? tr("Lock my prediction") : tr("Lock my prediction and show the run");
    return html2`<div class="carts-predict" data-kind=${spec.kind} role="group" aria-labelledby="${id}-ask">
<p class="carts-heading">${tr("Predict first")}</p>
<p class="carts-ask" id="${id}-ask">${spec.ask}</p>
${FORMS2[spec.kind](baked, spec)}
${spec.sure && certainty(id)}
<p class="carts-lock-row"><button type="button" class="carts-button carts-lock" disabled>${lock}</button> <span class="carts-saved" role="status"></span></p>
<p class="carts-error carts-predict-error" role="alert" hidden></p>
<div class="carts-talk" tabindex="-1" role="group" aria-label=${tr("Talk with your partner")} hidden><p><b>${tr("Locked.")}</b> ${tr("Now tell your partner what you expect, and why. Listen to the other reason too. You may change your prediction once; both are kept.")}</p><p class="carts-lock-row"><button type="button" class="carts-button carts-talk-change">${tr("Change it once")}</button> <button type="button" class="carts-button carts-talk-run">${tr("Keep it and show the run")}</button></p></div>
<div class="carts-compared" tabindex="-1" hidden></div>
<label class="carts-why" hidden>${tr("Explain: what did you see, and why is it so?")} <textarea rows="3" maxlength="20000" autocomplete="off" placeholder=" "></textarea></label>
<div class="carts-write" aria-hidden="true"><hr><hr><hr><hr></div>
<p class="carts-lock-row carts-again-row" hidden><button type="button" class="carts-button carts-again">${tr("Start again")}</button><span class="carts-forget" hidden>${tr("Forget this prediction and what was written below it?")} <button type="button" class="carts-button carts-forget-yes">${tr("Forget it")}</button> <button type="button" class="carts-button carts-forget-no">${tr("Keep it")}</button></span></p>
</div>`;
  }
  function certainty(id) {
    const label = tr("How sure are you?");
    const choices = CERTAINTY.map(
      ([word, says]) => html2`<label><input type="radio" autocomplete="off" name="${id}-sure" value=${word} disabled> ${says}</label> `
    );
    return html2`<p class="carts-certainty" role="radiogroup" aria-label=${label}><span>${label}</span> ${choices}</p>`;
  }
  function arrows({ fence, view, run: { header } }, { pairs, scale }) {
    const numbers = scale === "newtons";
    const full = numbers ? view.force || FULL : 1;
    const step = numbers ? niceAbove(full / 100) : STEP2;
    const asked = pairs.flatMap(([left, right]) => [
      { pair: `${left}-${right}`, on: left, by: right },
      { pair: `${left}-${right}`, on: right, by: left }
    ]);
    const rows = asked.map(({ pair, on, by }, k) => {
      const i = header.bodies.findIndex(({ name }) => name === on);
      const force = forceOn(body(on, header.track), body(by, header.track));
      const label = tr("{force}, length of the arrow", { force });
      const id = `${fence.id}-guess-${k + 1}`;
      return html2`<div class="carts-guess carts-${i < 0 ? "wall" : styleOf(i)}" data-pair=${pair} data-on=${on}><label for=${id}>${force}</label><input type="range" autocomplete="off" min="0" max=${full} step=${step} value="0" aria-label=${label}${!numbers && html2` id=${id}`} disabled>${numbers && html2`<span class="carts-typed"><input type="text" class="carts-number-box" id=${id} inputmode="decimal" autocomplete="off" value="" disabled> <span class="carts-unit-text">N</span></span><p class="carts-error" hidden></p>`}</div>
`;
    });
    const how = tr(
      "Pull each arrow in the picture, or here, until it is as long as you think. Only which one is longer counts, not how many newtons."
    );
    const paper = tr(
      "On paper: draw an arrow from each dot. The stronger you think the force is, the longer."
    );
    return html2`${!numbers && html2`<p class="carts-quiet carts-pull-how">${how}</p>`}<p class="carts-quiet carts-draw-how">${paper}</p><div class="carts-guesses">
${rows}</div>${!numbers && html2`<p class="carts-relation" role="status"></p>`}`;
  }
  function curve2({ run: { header } }, { cart: cart2, quantity }) {
    const i = header.bodies.findIndex(({ name }) => name === cart2);
    const place4 = pad(quantity);
    const knobs = KNOBS.map(
      (k) => html2`<circle class="carts-knob" data-index=${k} cx=${LEFT3 + STEP * k} cy=${place4.zero} r="7"/>`
    );
    const mode = place4.low < 0 ? "text" : "decimal";
    const heights = TIMES[quantity === "F" ? "contact" : "run"].map(
      (name) => html2`<label>${name} <input type="text" class="carts-height" inputmode=${mode} autocomplete="off" disabled></label>`
    );
    const flat = path(place4, [0, 0, 0, 0, 0]);
    return html2`<div class="carts-sketch">
<svg class="carts-pad" viewBox="0 0 360 170" width="360" height="170" aria-hidden="true"><path class="carts-grid" d="M40 10V130M40 130H350M117.5 10V130M195 10V130M272.5 10V130M350 10V130M40 70H350M40 10H350"/>${axes(quantity)}<path data-part="answer" class="carts-curve carts-${styleOf(Math.max(0, i))}" d=""/><path data-part="sketch" class="carts-sketch-line" d=${flat}/>${knobs}</svg>
<div class="carts-heights"><p>${quantity === "F" ? tr("Move the five points, or type heights from 0 to 10.") : tr("Move the five points, or type heights from −10 to 10: right is positive.")}</p>${heights}</div>
</div>`;
  }
  function axes(quantity) {
    if (quantity === "F")
      return html2`<text x="40" y="147">${tr("touch")}</text><text x="350" y="147" text-anchor="end">${tr("apart")}</text><text x="195" y="164" text-anchor="middle">${tr("time during the contact")}</text><text class="carts-pad-up" x="34" y="16" text-anchor="end">${tr("large")}</text><text x="28" y="134" text-anchor="end">0</text>`;
    const middle = quantity === "v" ? tr("at rest") : tr("start");
    return html2`<text data-way="1" x="46" y="24">${tr("to the right")}</text><text data-way="-1" x="46" y="126">${tr("to the left")}</text><text data-way="0" x="311" y="61" text-anchor="middle">${middle}</text><text x="195" y="164" text-anchor="middle">${tr("time from start to end")}</text>`;
  }
  function choice({ fence: { id } }, { options }) {
    const rows = options.map(
      (option, k) => html2`<label><input type="radio" autocomplete="off" name="${id}-predict" value=${k} disabled> <span>${option}</span></label>`
    );
    return html2`<div class="carts-options" role="radiogroup" aria-labelledby="${id}-ask">${rows}</div>`;
  }
  function text({ fence: { id } }) {
    return html2`<textarea class="carts-words" rows="3" maxlength="20000" autocomplete="off" aria-labelledby="${id}-ask" disabled></textarea>`;
  }

  // ../view/skins.js
  var NARROW = 24;
  var GAP = 5;
  var SADDLE = 6;
  var SKINS = {
    cart: { wheels: true, lift: 0, corner: 4, lines: () => "" },
    van: { wheels: true, lift: 0, corner: 7, lines: van },
    truck: { wheels: true, lift: 0, corner: 3, lines: truck },
    trailer: { wheels: true, lift: 0, corner: 1, lines: trailer },
    box: { wheels: false, lift: 0, corner: 1, lines: crate },
    puck: { wheels: false, lift: 0, corner: 12, lines: puck },
    glider: { wheels: false, lift: GAP, corner: 4, lines: glider }
  };
  function van(box, front) {
    return lines2(box, front, [
      [
        [0.06, 0.9],
        [0.34, 0.9],
        [0.46, 0.68],
        [0.06, 0.68],
        [0.06, 0.9]
      ],
      [
        [-0.42, 0.9],
        [-0.08, 0.9],
        [-0.08, 0.68],
        [-0.42, 0.68],
        [-0.42, 0.9]
      ],
      [
        [0.4, 0.26],
        [0.5, 0.26]
      ]
    ]);
  }
  function truck(box, front) {
    return lines2(box, front, [
      [
        [0.22, 0],
        [0.22, 1]
      ],
      [
        [0.28, 0.9],
        [0.42, 0.9],
        [0.46, 0.66],
        [0.28, 0.66],
        [0.28, 0.9]
      ],
      [
        [-0.5, 0.16],
        [0.22, 0.16]
      ]
    ]);
  }
  function trailer(box, front) {
    return lines2(box, front, [
      [
        [-0.5, 0.2],
        [0.5, 0.2]
      ],
      ...[-0.4, -0.27, 0.27, 0.4].map(
        (x) => [
          [x, 0.2],
          [x, 1]
        ]
      )
    ]);
  }
  function crate(box, front) {
    return lines2(box, front, [
      [
        [-0.4, 0.1],
        [0.4, 0.1],
        [0.4, 0.9],
        [-0.4, 0.9],
        [-0.4, 0.1]
      ],
      [
        [-0.4, 0.3],
        [-0.22, 0.1]
      ],
      [
        [0.4, 0.3],
        [0.22, 0.1]
      ],
      [
        [-0.4, 0.7],
        [-0.22, 0.9]
      ],
      [
        [0.4, 0.7],
        [0.22, 0.9]
      ]
    ]);
  }
  function puck(box, front) {
    return lines2(box, front, [
      [
        [-0.48, 0.15],
        [0.48, 0.15]
      ],
      [
        [-0.48, 0.85],
        [0.48, 0.85]
      ]
    ]);
  }
  function glider(box, front) {
    const top = Math.min(SADDLE / box.height, 0.4);
    return lines2(box, front, [
      [
        [-0.5, top],
        [0.5, top]
      ],
      ...[-0.42, -0.28, 0.28, 0.42].map(
        (x) => [
          [x, 0],
          [x, top]
        ]
      )
    ]);
  }
  function lines2({ width, height }, front, strokes) {
    if (width < NARROW) return "";
    const at = ([x, y]) => `${px(front * x * width)} ${px(-y * height)}`;
    return strokes.map((points) => `M${points.map(at).join("L")}`).join("");
  }

  // ../view/skeleton/tools.js
  var STEPS = 500;
  var AT_FIRST = [0.25, 0.5];
  var HANDLE = 8;
  function tools({ fence, view }) {
    const layout = view.layouts[0];
    const watch2 = fence.opened.includes("stopwatch");
    if (!layout?.tape && !watch2) return null;
    return html2`<div class="carts-tools">
${watch2 && stopwatch()}
${layout && layout.tape > 0 && ruler(layout)}
</div>`;
  }
  function stopwatch() {
    const name = tr("Stopwatch");
    return html2`<div class="carts-tool" role="group" aria-label=${name} data-tool="stopwatch"><span class="carts-heading">${name}</span> <span class="carts-tool-read"><output aria-live="off">0.00</output> s</span> <button type="button" class="carts-button" data-act="stop" data-stop=${tr("Stop")} data-start=${tr("Start")}>${tr("Start")}</button> <button type="button" class="carts-button" data-act="zero">${tr("Zero")}</button></div>`;
  }
  function ruler(layout) {
    const name = tr("Ruler");
    const step = stepOf(layout);
    const decimals = decimalsOf(step);
    const [from, to] = ends(layout);
    const end2 = (key, label, x) => html2`<input type="range" data-end=${key} min=${px(layout.low, decimals)} max=${px(layout.high, decimals)} step=${step} value=${px(x, decimals)} autocomplete="off" aria-label=${label} aria-valuetext="${fixed(x, decimals)} m">`;
    return html2`<div class="carts-tool" role="group" aria-label=${name} data-tool="ruler" data-decimals=${decimals}><span class="carts-heading">${name}</span> ${end2("from", tr("left end of the ruler"), from)}${end2("to", tr("right end of the ruler"), to)} <span class="carts-tool-read"><output>${fixed(to - from, decimals)}</output> m</span></div>`;
  }
  function tape(layout) {
    const at = (x) => px(layout.origin + x * layout.scale);
    const [from, to] = ends(layout);
    const y = px(layout.tape);
    const numbers = layout.track + layout.beam;
    const line = `M0 ${px(layout.track - 36)}V${px(numbers + 8)}M0 ${px(numbers + 27)}V${y}`;
    const end2 = (key, x) => html2`<g class="carts-tape-end" data-end=${key} transform="translate(${at(x)} 0)"><path d=${line}/><circle class="carts-pull-room" cx="0" cy=${y} r="16"/><circle cx="0" cy=${y} r=${HANDLE}/></g>`;
    const middle = at((from + to) / 2);
    return html2`<g class="carts-tape" data-origin=${px(layout.origin, 4)} data-scale=${px(layout.scale, 4)} data-y=${y}><path data-part="tape" d="M${at(from)} ${y}H${at(to)}"/>${end2("from", from)}${end2("to", to)}<text data-part="length" x=${middle} y=${px(layout.tape + 5)} text-anchor="middle">${fixed(to - from, decimalsOf(stepOf(layout)))} m</text></g>`;
  }
  function stepOf({ low, high }) {
    return niceAbove((high - low) / STEPS);
  }
  function ends(layout) {
    const { low, high } = layout;
    const step = stepOf(layout);
    const [from, to] = AT_FIRST.map((part) => Math.round((low + part * (high - low)) / step) * step);
    return [from ?? low, to ?? high];
  }

  // ../view/skeleton/stage.js
  var LABEL_ROOM = { wide: 54, narrow: 46 };
  var BREAK = "M-14 -56l7 -6l7 6l7 -6l7 6M-14 -49l7 -6l7 6l7 -6l7 6";
  var MOST_NUMBERS2 = 150;
  var LETTER = 8;
  var BEYOND = 60;
  function stage(baked, layout) {
    const { fence, run } = baked;
    const { kind: kind2, width, height } = layout;
    const forces = fence.forces === "shown";
    const hatch = `${fence.id}-${kind2}-hatch`;
    const size = html2`viewBox="0 0 ${px(width)} ${px(height)}" width=${px(width)} height=${px(height)}`;
    return html2`<svg class="carts-stage carts-stage-${kind2}" data-kind=${kind2} ${size} aria-hidden="true">
<defs>
<pattern id=${hatch} width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path class="carts-hatch" d="M0 0V8"/></pattern>
</defs>
${ground(baked, layout, hatch)}
<g data-part="effects-behind"></g>
${run.header.bodies.map(velocity)}
${run.header.bodies.map((body2, i) => cart(body2.name, i, fence.skins[body2.name] ?? "cart"))}
${run.header.bodies.map(({ name }) => html2`<text class="carts-mass" data-body=${name}></text>`)}
<path class="carts-was"/>
<g data-part="effects-front"></g>
${forces && pushes2(baked)}
<g data-part="guess"></g>
${layout.tape > 0 && tape(layout)}
${legend(baked, layout)}
</svg>`;
  }
  function velocity({ name }, i) {
    return html2`<g class="carts-velocity carts-${styleOf(i)}" data-body=${name}><path data-part="leader" class="carts-leader"/><path data-part="arrow" class="carts-line-arrow"/><text data-part="text"></text></g>
`;
  }
  function cart(name, i, skin) {
    const { corner, wheels } = SKINS[skin];
    const face = (side2) => html2`<rect data-part="face-${side2}" class="carts-face" x="-1.5" y="-22" width="3" height="21" rx="1.5"/>`;
    return html2`<g class="carts-cart carts-${styleOf(i)}" data-body=${name}><path data-part="spring-left" class="carts-spring"/><path data-part="spring-right" class="carts-spring"/>${face("left")}${face("right")}<rect data-part="box" class="carts-box" rx=${corner}/>${skin !== "cart" && html2`<path data-part="skin" class="carts-skin"/>`}${wheels && html2`<path data-part="wheels" class="carts-wheels"/>`}<g data-part="break" class="carts-break"><path d=${BREAK}/></g><text data-part="name" class="carts-name"></text></g>
`;
  }
  function pushes2({ run: { header } }) {
    const linked = linkedPairs(header);
    const style = (name) => {
      const i = header.bodies.findIndex((body2) => body2.name === name);
      return i < 0 ? "wall" : styleOf(i);
    };
    return header.contacts.filter(({ stiffness, pair }) => stiffness || linked.has(pair)).flatMap(
      ({ pair, bodies }) => bodies.map(
        (on) => html2`<g class="carts-push carts-${style(on)}" data-pair=${pair} data-on=${on}><path data-part="arrow" class="carts-block-arrow"/><text data-part="text" visibility="hidden"></text></g>
`
      )
    );
  }
  function ground({ fence, run: { header } }, layout, hatch) {
    const travel = fence.camera * header.until;
    const [low, high] = [layout.low + Math.min(0, travel), layout.high + Math.max(0, travel)];
    const { left, right, length } = header.track;
    const at = (x) => layout.origin + x * layout.scale;
    const first = left === "wall" ? 0 : low;
    const last = right === "wall" ? Number(length) : high;
    const slider2 = fence.controls.find((control2) => control2.set === "track.length");
    const longest = slider2 ? slider2.high * slider2.per : last;
    const start = left === "wall" ? at(0) : at(low) - BEYOND;
    const end2 = right === "wall" ? at(last) : at(high) + BEYOND;
    const under2 = layout.track + layout.beam;
    let step = niceAbove((LABEL_ROOM[layout.kind] ?? 0) / layout.scale);
    while ((high - low) / step > MOST_NUMBERS2) step = niceAbove(step * 1.5);
    const numbers = { low: first, high: Math.max(last, longest), step };
    const parts = /[1-9]/.exec(short(step))?.[0] === "2" ? 4 : 5;
    const fine = ticks({ ...numbers, step: step / parts }).map((x) => `M${px(at(x))} ${px(under2)}v4`);
    const wall = (side2) => html2`<g data-wall=${side2}><path class="carts-wall"/><path fill="url(#${hatch})"/><path class="carts-wall-face"/></g>
`;
    return html2`<g data-part="ground">
${left === "wall" && wall("left")}${right === "wall" && wall("right")}<rect class="carts-beam" x=${px(start)} y=${px(layout.track)} width=${px(end2 - start)} height=${px(layout.beam)}/>
<path class="carts-rule" d="M${px(start)} ${px(layout.track)}H${px(end2)}"/>
<path class="carts-fine" d=${fine.join("")}/>
${ticks(numbers).map(
      (x) => html2`<path class="carts-fine" d="M${px(at(x))} ${px(under2)}v8"/><text class="carts-number" x=${px(at(x))} y=${px(under2 + 22)}>${fixed(x, axisDecimals(numbers))}</text>
`
    )}</g>`;
  }
  function legend({ fence, view }, layout) {
    const y = layout.height - 10;
    const wide = layout.kind === "wide";
    const [per, unit] = speedUnit(view.velocity);
    const text2 = (x2, said) => html2`<text x=${px(x2)} y=${px(y + 5)}>${said}</text>`;
    const force = fence.forces === "shown" && view.force > 0;
    const asked = fence.predict?.kind === "arrows" ? "" : "carts-unasked";
    const word = tr("scale:");
    const start = layout.above ? 12 : 12 + roomOf(word) + 4;
    const next = start + layout.velocity + 6;
    const x = next + 68;
    const end2 = force ? x + layout.force + 6 : next;
    const axis2 = wide ? tr("x in m, + is to the right") : tr("x in m, + →");
    const moving = wide ? tr("position on the track in m") : tr("track in m");
    return html2`<g class="carts-legend">
<text x="12" y=${px(layout.above ? y - 9 : y + 5)}>${word}</text>
<path class="carts-line-arrow" d=${lineArrow(start, y, layout.velocity)}/>${text2(next, `${short(view.velocity / per)} ${unit}`)}
${force && html2`<g class=${asked}><path class="carts-block-arrow" d=${blockArrow(x, y, layout.force)}/>${text2(end2, `${short(view.force)} N`)}</g>`}
${wide && html2`<text class="carts-torn" data-now="no" x=${px(end2 + 70)} y=${px(y + 5)}>${tr("torn: not to scale")}</text>`}
<text x=${px(layout.width - 12)} y=${px(y + 5)} text-anchor="end">${fence.camera ? moving : axis2}</text>
</g>`;
  }
  function roomOf(word) {
    return [...word].reduce((sum, sign) => sum + (sign > "˿" ? 2 * LETTER : LETTER), 0);
  }

  // ../view/skeleton/time.js
  var LONG2 = 60;
  var SPEEDS = [1, 10, 100];
  var START = "M3 3v10M13 3L6 8l7 5z";
  var BACK2 = "M12.5 3v10M10 3L3 8l7 5z";
  var FORWARD = "M3.5 3v10M6 3l7 5-7 5z";
  function timeline({ run: { header } }) {
    return html2`<div class="carts-timeline">
<svg class="carts-ticks" width="100%" height="34" aria-hidden="true"><g data-part="contacts"></g><g data-part="events"></g><g data-part="numbers"></g></svg>
<input type="range" class="carts-scrub" min="0" max=${header.until} step="any" value="0" aria-label=${tr("Time")} disabled>
</div>`;
  }
  function transport({ fence, run: { header } }) {
    const slow = fence.slow !== "never" && header.contacts.some(({ stiffness }) => stiffness);
    const speed = openingSpeed(header.until);
    const speeds = SPEEDS.map(
      (n) => html2`<option value=${n}${n === speed && html2` selected`}>${n}×</option>`
    );
    return html2`<div class="carts-transport">
${button2("start", START, tr("Back to the start"), tr("Back to the start (Home)"))}
${button2("back", BACK2, tr("Step back"), tr("Step back (left arrow key)"))}
<button type="button" class="carts-button carts-play" title=${tr("Play or pause (space bar)")} disabled><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path class="carts-icon-play" d="M4 2.5L13 8l-9 5.5z"/><path class="carts-icon-pause" d="M4 3h3v10H4zM9 3h3v10H9z"/></svg><span>${tr("Play")}</span></button>
${button2("forward", FORWARD, tr("Step forward"), tr("Step forward (right arrow key)"))}
<label class="carts-speed-label">${tr("Speed")} <select autocomplete="off" class="carts-speed" disabled><option value="0.01">1/100</option><option value="0.1">1/10</option>${speeds}</select></label> <a class="carts-jump carts-down" href="#${fence.id}-graphs">${tr("Graphs")} ↓</a>
${slow && html2`<label class="carts-slow-label"><input type="checkbox" class="carts-slow" checked disabled> ${tr("slow motion in contacts")}</label>`}
<p class="carts-clocks"><span>${tr("cart time")} <span class="carts-clock">0.000</span> s</span>${slow && html2`<span class="carts-slow-note" aria-hidden="true"><b class="carts-rate">1×</b> ${tr("speed, your time")} <span class="carts-own-clock">0.0</span> s</span>`}</p>
${fence.watch === "first" && html2`<button type="button" class="carts-button carts-end" disabled>${tr("Show me the end")}</button>`}
</div>`;
  }
  function button2(name, icon, label, title) {
    return html2`<button type="button" class="carts-button carts-${name}" aria-label=${label} title=${title} disabled><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d=${icon}/></svg></button>`;
  }
  function openingSpeed(until) {
    if (until <= LONG2) return 1;
    return until >= 10 * LONG2 ? 100 : 10;
  }

  // ../view/skeleton/scene.js
  var FORCE_QUANTITIES = ["F", "R", "a"];
  function inside3(baked, found = false) {
    const { fence, view, run } = baked;
    const { id, predict: asked } = fence;
    const quantities = fence.show.filter(
      (quantity) => fence.forces === "shown" || !FORCE_QUANTITIES.includes(quantity)
    );
    const paper = asked ? tr("Make your prediction on paper. The run needs JavaScript.") : tr("The picture shows the start. Playing the run needs JavaScript.");
    return html2`<div class="carts-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${run.header.title ?? tr("Carts on an air track")}</p><button type="button" class="carts-sign carts-project" title=${tr("Full screen for the class (key P)")} aria-pressed="false" disabled>${tr("projector")}</button>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
<div class="carts-world" tabindex="0" role="group" aria-label=${tr("Carts on the track")} aria-describedby="${id}-described ${id}-keys">
${view.layouts.map((layout) => stage(baked, layout))}
<p class="carts-torn" data-now="no"${!view.mayTear && html2` hidden`}>${tr("A torn box is not to scale: its cart is heavier.")}</p>
${run.header.effects.length > 0 && html2`<p class="carts-acting"></p>`}
${fence.camera !== 0 && html2`<p class="carts-camera">${cameraText(fence.camera)}</p>`}
</div>
<p class="carts-hidden" id="${id}-described">${description(baked)}</p>
<p class="carts-hidden" id="${id}-keys">${tr("The space bar plays and pauses, the arrow keys step.")}</p>
${timeline(baked)}
${transport(baked)}
${tools(baked)}
<noscript><p class="carts-noscript">${paper}</p></noscript>
${asked && predict(baked, asked)}
${near(baked)}
${panel(baked)}
${views(baked)}
<div class="carts-results" id="${id}-graphs"${asked && html2` hidden`}>
<div class="carts-graphs-bar"><details class="carts-more carts-choose"><summary>${tr("Choose what to see")}</summary><div class="carts-choices"></div></details><label>${tr("Time axis")} <select class="carts-window" disabled><option value="">${tr("whole run")}</option></select></label></div>
<div class="carts-graphs">
${quantities.map((quantity) => graph(baked, quantity))}
<div class="carts-story"><p class="carts-heading">${tr("What happens")}</p>
<ol class="carts-events" aria-label=${tr("What happens")}></ol></div>
</div>
${asksForForces(baked) && find()}${found && html2`<p class="carts-found" hidden></p>`}
</div>
<details class="carts-more carts-model"${asksForForces(baked) && html2` hidden`}><summary>${tr("What is in this model")}</summary><ul></ul></details>
<details class="carts-more carts-how"><summary>${tr("How is this computed?")}</summary><div class="carts-how-body"></div><noscript><p>${tr("Every run is computed exactly, formula by formula. How this one was needs JavaScript.")}</p></noscript></details>
<div class="carts-hidden carts-announcer" aria-live="polite"></div>
</div>`;
  }
  function asksForForces({ fence, run }) {
    return fence.forces === "hidden" && run.header.contacts.some(({ stiffness }) => stiffness);
  }
  function find() {
    const [before, after] = tr(
      "While they touch, the mean force on a cart is {formula}. Read its velocity before and after off the graph or its table, and the times off “What happens”."
    ).split("{formula}");
    return html2`<details class="carts-more carts-find" open><summary>${tr("The forces are hidden. Find those on both carts, and you see them all")}</summary><p>${before}<i>F</i> = <i>m</i> · Δ<i>v</i> / Δ<i>t</i>${after}</p><form class="carts-find-form"><label>${tr("Mean force on")} <select class="carts-find-which" disabled></select></label> <span class="carts-find-value"><input type="text" inputmode="decimal" autocomplete="off" aria-label=${tr("mean force in N, plus is to the right")} disabled> N</span> <button type="submit" class="carts-button" disabled>${tr("Check")}</button></form><p class="carts-find-note" role="status"></p></details>`;
  }
  function description({ fence: { camera }, view, run: { header } }) {
    const carts = header.bodies.map(({ name, mass, position, velocity: velocity2 }) => {
      const told3 = { cart: name, mass: short(mass), place: fixed(position, 2) };
      if (velocity2 === camera) return tr("{cart}, {mass} kg, is at {place} m and is at rest.", told3);
      const seen2 = motion(velocity2 - camera, view.decimals.v ?? 2, view.velocity);
      return tr("{cart}, {mass} kg, is at {place} m and moves at {velocity}.", {
        ...told3,
        velocity: seen2
      });
    });
    return tr("At the start: {carts}", { carts: carts.join(" ") });
  }
  function cameraText(camera) {
    return tr(
      "Seen from a camera that moves at {velocity} along the track. Positions and velocities are measured from the camera.",
      { velocity: motion(camera, 2, Math.abs(camera)) }
    );
  }

  // src/map/paint.js
  function paint(canvas, { values, columns }, scale) {
    const { places, width, height } = pixels(values, columns, scale);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const context = canvas.getContext("2d");
    if (!context) return;
    const image = context.createImageData(width, height);
    const words = new Uint32Array(image.data.buffer);
    const colours = packed(scale);
    for (let at = 0; at < places.length; at += 1) words[at] = Number(colours[Number(places[at])]);
    context.putImageData(image, 0, 0);
  }
  function packed(scale) {
    return Uint32Array.from(palette(scale), ([r, g, b]) => 255 << 24 | b << 16 | g << 8 | r);
  }

  // src/scene/baked.js
  function bakedOf({ fence, view, numbers, ...header }) {
    const known = header;
    return { fence, view, run: { header: known, trajectory: fromBaked(numbers, known.events) } };
  }

  // src/teach/draw.js
  var DRAW = { "carts-scene": drawScene, "carts-map": drawMap, "carts-measured": drawMeasured };
  function drawBlock(element) {
    if (element.firstElementChild?.localName === "script") DRAW[element.localName]?.(element);
  }
  function drawScene(element) {
    const raw = JSON.parse(need(element, "script.carts-baked").textContent ?? "");
    const shown2 = element.querySelector("template.carts-shown");
    if (shown2) {
      const open3 = { ...raw, ...JSON.parse(shown2.dataset.baked ?? "{}") };
      shown2.innerHTML = inside3(bakedOf(open3), true).text;
    }
    element.insertAdjacentHTML("afterbegin", inside3(bakedOf(raw)).text);
  }
  function drawMap(element) {
    const facts = JSON.parse(need(element, ".carts-map-baked").textContent ?? "");
    const draw = facts.draw;
    if (!draw) return;
    let picture = "";
    if (facts.axes.length === 2) {
      const canvas = document.createElement("canvas");
      const columns = facts.axes[0]?.values.length ?? 0;
      const values = Float64Array.from(draw.values, (value) => value ?? Number.NaN);
      paint(canvas, { values, columns }, scaleFor(facts.low, facts.high));
      picture = canvas.toDataURL();
    }
    element.insertAdjacentHTML("afterbegin", inside(facts, draw, picture).text);
  }
  function drawMeasured(element) {
    const facts = JSON.parse(need(element, ".carts-measured-baked").textContent ?? "");
    element.insertAdjacentHTML("afterbegin", inside2(facts).text);
  }

  // src/teach/formulas.js
  async function drawFormulas(root, assets) {
    const waiting2 = [...root.querySelectorAll(".arithmatex")].filter(
      (element) => !element.querySelector(".katex")
    );
    if (!waiting2.length) return;
    const page2 = globalThis;
    if (!page2.katex) await loadKatex(assets);
    const { setAttribute } = Element.prototype;
    Element.prototype.setAttribute = function(name, value) {
      if (name === "style") this.style.cssText = value;
      else setAttribute.call(this, name, value);
    };
    try {
      for (const element of waiting2) {
        const source2 = (element.textContent ?? "").trim();
        const displayMode = source2.startsWith("\\[");
        const tex = source2.replace(/^\\[[(]|\\[\])]$/g, "");
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
  var HEAD = ".md-content__button, .carts-print-head";
  var LINES = ".carts-languages, .carts-draft";
  var FOOT = ".carts-teach-door, .carts-hosted, .md-source-file";
  var MISSING = "carts-teach-missing";
  var OURS = "carts-scene, carts-map, carts-cost, carts-hard, carts-measured, carts-question, carts-quiz, carts-challenge, carts-law";
  var NAMES2 = {
    "carts-scene": "scene",
    "carts-question": "question",
    "carts-challenge": "challenge",
    "carts-map": "map",
    "carts-measured": "bench"
  };
  var LessonPage = class {
    #made = /* @__PURE__ */ new Map();
    #blocks = [];
    #frame = "";
    #builtFrame = "";
    #built = null;
    #own = /* @__PURE__ */ new Set();
    #kept = /* @__PURE__ */ new Map();
    constructor(article, assets, change) {
      this.article = article;
      this.assets = assets;
      this.change = change;
    }
    get have() {
      return [...this.#made.keys()];
    }
    reveal(index) {
      const element = this.#blocks[index];
      const above = element?.previousElementSibling;
      const first = above?.matches(".carts-teach-change") ? above : element;
      first?.scrollIntoView({ block: "start" });
    }
    adopt(look) {
      const pieces = look.pieces.filter((piece) => piece.kind === "block");
      const texts = textsOf(pieces);
      const found = pieces.map((piece, k) => this.#byId(piece.id ?? "") ?? this.#byPlace(k));
      look.blocks.forEach((block, k) => {
        const element = found[k];
        if (!element) return;
        if (block.key) this.#made.set(block.key, element);
        if (block.key) this.#own.add(block.key);
        if (block.state === "kept") this.#kept.set(texts[k] ?? "", element);
      });
      this.#blocks = found;
      this.#builtFrame = this.#frame = look.frame ?? "";
      this.#offer();
    }
    async show(look) {
      const before = this.#blocks;
      const pieces = look.pieces.filter((piece) => piece.kind === "block");
      const texts = textsOf(pieces);
      const as = look.blocks.length === before.length;
      const scenes = look.blocks.some((block) => block.html?.includes("<carts-scene"));
      const blocks = look.blocks.map((block, k) => {
        const kept = block.state === "kept" ? this.#kept.get(texts[k] ?? "") : void 0;
        return kept ?? this.#element(block, pieces[k]?.id ?? "", as ? before[k] : null);
      });
      look.blocks.forEach((block, k) => {
        const wrong = block.state === "wrong" || block.state === "needs";
        blocks[k] ??= html("p", MISSING);
        const missing = isMissing(blocks[k]);
        blocks[k]?.classList.toggle("carts-teach-old", wrong && !missing);
        if (missing) say(blocks[k], notYet(block.state));
      });
      const same = look.frame === null || look.frame === this.#frame;
      if (same && as) {
        blocks.forEach((element, k) => {
          if (element !== before[k]) makePlace(before[k], k);
        });
        fill(this.article, blocks);
      } else if (look.frame !== null) this.#rebuild(look.frame, blocks);
      this.#frame = look.frame ?? this.#frame;
      this.#blocks = blocks;
      const used = new Set(look.blocks.map((block) => block.key));
      for (const key of this.#made.keys())
        if (!used.has(key) && !this.#own.has(key)) this.#made.delete(key);
      this.#offer();
      if (scenes) await this.#bringToLife();
      await drawFormulas(this.article, this.assets);
    }
    #element(block, id, old) {
      const known = block.key ? this.#made.get(block.key) : void 0;
      if (known) return known;
      if (block.key && block.html) {
        const made2 = document.createElement("template");
        made2.innerHTML = block.html;
        const element = made2.content.firstElementChild;
        drawBlock(element);
        this.#made.set(block.key, element);
        return element;
      }
      return id && this.#byId(id) || old || null;
    }
    #rebuild(frame2, blocks) {
      if (this.#frame === this.#builtFrame) this.#setAside();
      if (frame2 === this.#builtFrame && this.#built) {
        this.article.replaceChildren(...this.#built);
        this.#built = null;
        fill(this.article, blocks);
        return;
      }
      const made2 = document.createElement("template");
      made2.innerHTML = frame2;
      fill(made2.content, blocks);
      const kept = (which) => [...this.article.children].filter((child) => child.matches(which));
      const lines3 = kept(LINES);
      const title = made2.content.querySelector("h1");
      if (title) title.after(...lines3);
      else made2.content.prepend(...lines3);
      this.article.replaceChildren(...kept(HEAD), made2.content, ...kept(FOOT));
    }
    #setAside() {
      if (!this.#builtFrame || this.#built) return;
      for (const row of this.article.querySelectorAll(".carts-teach-change")) row.remove();
      this.#blocks.forEach((element, k) => {
        if (!element || !this.article.contains(element)) return;
        makePlace(element, k);
      });
      this.#built = [...this.article.childNodes];
    }
    #offer() {
      for (const old of this.article.querySelectorAll(".carts-teach-change")) old.remove();
      this.#blocks.forEach((element, k) => {
        if (!element?.isConnected || isMissing(element)) return;
        const name = NAMES2[element.localName] ?? "block";
        const button3 = html("button", "carts-button", `Change this ${name}`);
        button3.setAttribute("type", "button");
        button3.addEventListener("click", () => this.change(k));
        const row = html("p", "carts carts-teach-change");
        row.append(button3);
        element.before(row);
      });
    }
    async #bringToLife() {
      if (customElements.get("carts-scene")) return;
      const script = document.createElement("script");
      script.src = new URL("carts.js", this.assets).href;
      document.head.append(script);
    }
    #byId(id) {
      const found = id ? document.getElementById(id) : null;
      return found?.matches(OURS) ? found : null;
    }
    #byPlace(index) {
      return this.article.querySelector(`.carts[data-block="${index}"]`);
    }
  };
  function makePlace(element, k) {
    const place4 = document.createElement("carts-place");
    place4.dataset.block = String(k);
    element?.replaceWith(place4);
  }
  function fill(root, blocks) {
    for (const place4 of root.querySelectorAll("carts-place")) {
      const element = blocks[Number(place4.dataset.block)];
      if (element) place4.replaceWith(element);
    }
  }
  function notYet(state) {
    if (state === "wrong") return "Seen when its mistake is mended.";
    return state === "later" ? "It comes in a moment." : "Seen after the build.";
  }
  var isMissing = (element) => element?.classList.contains(MISSING) === true;
  function textsOf(pieces) {
    const seen2 = /* @__PURE__ */ new Map();
    return pieces.map(({ text: text2 }) => {
      const count2 = (seen2.get(text2) ?? 0) + 1;
      seen2.set(text2, count2);
      return `${count2} ${text2}`;
    });
  }

  // src/shared/spreadsheet.js
  var CELL = /("(?:[^"]|"")*"|[^,\r\n"]*)(,|\r?\n|$)/g;
  var NUMBER = /^-?\d+(?:\.\d+)?(?:e[+-]?\d+)?$/i;
  function forSpreadsheet(csv, language = navigator.language) {
    if (!hasComma(language)) return csv;
    return csv.replace(CELL, (_, cell, end2) => written2(cell) + (end2 === "," ? ";" : end2));
  }
  function written2(cell) {
    if (NUMBER.test(cell)) return cell.replace(".", ",");
    return cell.includes(";") && !cell.startsWith('"') ? `"${cell}"` : cell;
  }
  function hasComma(language) {
    try {
      return new Intl.NumberFormat(language).format(0.5).includes(",");
    } catch {
      return false;
    }
  }

  // src/shared/download.js
  var FORGOTTEN_AFTER = 6e4;
  function download(name, text2, type) {
    const saved = type === "text/csv" ? forSpreadsheet(text2) : text2;
    downloadBlob(name, new Blob([saved], { type }));
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

  // src/teach/earlier-draft.js
  var NOT_DELETED = "This browser refused to delete it.";
  function earlierDraft(session2, draft) {
    const row = html("p", "carts-teach-earlier");
    const which = draft.hash === session2.drafts.hash ? "another draft of this lesson" : "a draft of an earlier version of this lesson";
    row.append(
      `You have ${which}, of ${clock(draft.last)}. `,
      button("Open it", () => session2.change(draft.text, ""), "carts-teach-older"),
      " ",
      button("Save it", () => download(session2.name, draft.text, "text/markdown")),
      " ",
      button("Delete it", () => {
        void session2.drafts.forget(draft.key).then(
          () => row.remove(),
          () => row.append(" ", NOT_DELETED)
        );
      })
    );
    return row;
  }

  // src/teach/head.js
  function head(session2, panel2) {
    const root = html("div", "carts-teach-head");
    const heading = html("h2", "", "Change this lesson");
    heading.tabIndex = -1;
    const fold = () => {
      const folded = panel2.classList.toggle("carts-teach-folded");
      document.body.classList.toggle("carts-teaching-folded", folded);
      small.setAttribute("aria-expanded", String(!folded));
      small.textContent = folded ? "Show" : "Make room";
    };
    const small = button("Make room", fold, "carts-teach-fold");
    small.setAttribute("aria-expanded", "true");
    root.append(
      heading,
      small,
      button("Close", () => session2.close(), "carts-teach-close")
    );
    return { root, heading };
  }

  // src/shared/bring.js
  function bring(name, address) {
    const known = () => globalThis[name] ?? null;
    if (known()) return Promise.resolve(known());
    return new Promise((resolve) => {
      const script = document.createElement("script");
      script.src = address;
      script.onload = () => resolve(known());
      script.onerror = () => {
        script.remove();
        resolve(null);
      };
      document.head.append(script);
    });
  }

  // src/teach/source.js
  var KEPT_OUT = "(stands in the teacher's own file)";
  async function loadLesson(address) {
    const packed2 = await bring("__cartsLesson", address);
    if (packed2 === null) throw new Error("the lesson's text is missing in this site");
    delete globalThis.__cartsLesson;
    const bytes = Uint8Array.from(atob(packed2), (letter) => letter.charCodeAt(0));
    const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
    return JSON.parse(decoder.decode(await gunzip([bytes])));
  }
  async function hashOf(text2) {
    if (!globalThis.crypto?.subtle) return "";
    const bytes = new TextEncoder().encode(text2);
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  }

  // src/teach/own-file.js
  var LESSON = /\.(md|markdown|txt)$/i;
  function ownFile(words, take) {
    const label = html("label", "carts-teach-own");
    const told3 = html("span", "carts-error");
    told3.setAttribute("role", "alert");
    const input = document.createElement("input");
    input.type = "file";
    input.accept = ".md,text/markdown";
    input.addEventListener("change", async () => {
      const file = input.files?.[0];
      if (!file) return;
      const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
      const bytes = await file.arrayBuffer().catch(() => null);
      input.value = "";
      let wrong = bytes ? "" : `${file.name} cannot be read.`;
      if (!LESSON.test(file.name)) wrong = `${file.name} is no lesson: its name would end in .md.`;
      say(told3, wrong);
      if (bytes && !wrong) say(told3, await take(decoder.decode(bytes), file.name) || "");
    });
    label.append(html("span", "", words), " ", input, " ", told3);
    return label;
  }
  var OwnFile = class {
    #offer = html("p");
    constructor(session2, tell) {
      this.session = session2;
      this.tell = tell;
      this.root = html("div");
      this.follow();
    }
    follow() {
      const asks = this.root.firstChild !== null;
      if (asks === this.session.withheld) return;
      if (asks) this.root.replaceChildren();
      else this.root.append(this.#field());
    }
    #field() {
      const words = `Notes and marking guides for teachers are not in this page. To have them in what you save, choose your own file of the lesson (${this.session.name}):`;
      return ownFile(words, (own, name) => this.#take(own, name));
    }
    async #take(own, name) {
      this.#offer.remove();
      this.tell("Putting notes and marking guides back …");
      try {
        const { missing, same, none } = await putBack(this.session, own);
        this.tell(none ? "" : taken(missing, same));
        if (none) return strange(name, this.session.name);
      } catch (error) {
        const { message } = error;
        this.tell(`Notes and marking guides could not be put back: ${message}`);
        const open3 = () => {
          this.#offer.remove();
          openInstead(this.session, own);
        };
        this.#offer.replaceChildren(
          "Your changes here are then not in the text: ",
          button("Open that file in place of this text", open3, "carts-teach-instead")
        );
        if (this.session.withheld) this.root.append(this.#offer);
      }
      return "";
    }
  };
  async function putBack(session2, own) {
    const same = await hashOf(own) === session2.told.hash;
    const { text: text2, missing } = await restored(session2.client, () => session2.text, own);
    const none = text2 === session2.text;
    if (same) session2.base = own;
    if (!none) session2.change(text2, "");
    return { missing, same, none };
  }
  function openInstead(session2, own) {
    session2.change(own, "");
    const { error } = session2.client;
    if (error) session2.panel.withoutPython(error.message);
  }
  function strange(name, needed) {
    if (name !== needed) return `This is the file ${name}; needed: ${needed}. Nothing was changed.`;
    return "No notes or marking guides of this lesson stand in this file. Nothing was changed.";
  }
  function taken(missing, same) {
    if (missing) return `${missing} notes or marking guides do not stand in this file.`;
    return same ? "Your file is the published one: notes and marking guides are back." : "Notes and marking guides are back. Your file differs from the published one.";
  }

  // src/teach/fields.js
  var PAUSE = 300;
  var made = 0;
  var Fields = class {
    #rows = /* @__PURE__ */ new Map();
    #form = "";
    constructor(set) {
      this.set = set;
      this.root = html("div", "carts-teach-fields");
    }
    show(fields, findings) {
      const form2 = JSON.stringify(fields.map(({ path: path2, kind: kind2, group }) => [path2, kind2, group]));
      if (form2 !== this.#form) this.#build(fields);
      this.#form = form2;
      for (const field of fields) {
        const row = this.#rows.get(JSON.stringify(field.path));
        if (!row) continue;
        if (row.field.value !== field.value) row.refused = false;
        row.field = field;
        const [line, col] = field.place;
        const wrong = findings.find((one) => one.line === line && one.col === col);
        if (wrong) this.#say(row, [withoutPath(wrong), wrong.hint].filter(Boolean).join(" – "));
        else if (row.wrong) this.#say(row, "");
        row.wrong = wrong !== void 0;
        const held = row.refused || row.timer || row.asked || row.control === document.activeElement;
        if (!held && row.control.value !== field.value) {
          row.control.value = field.value;
          this.#say(row, "");
        }
      }
    }
    flush() {
      for (const { timer, refused, take } of this.#rows.values()) if (timer || refused) take();
    }
    undo() {
      for (const row of this.#rows.values()) {
        if (!row.refused) continue;
        row.refused = false;
        row.control.value = row.field.value;
        this.#say(row, "");
      }
    }
    #build(fields) {
      const before = new Map(this.#rows);
      const focused = [...this.#rows].find(([, { control: control2 }]) => control2 === document.activeElement);
      this.#rows.clear();
      this.root.replaceChildren();
      let group = "";
      let place4 = this.root;
      for (const field of fields) {
        if (field.group !== group || !field.group && place4 !== this.root) {
          group = field.group;
          place4 = this.root;
          if (group) {
            place4 = html("fieldset");
            place4.append(html("legend", "", group));
            this.root.append(place4);
          }
        }
        place4.append(this.#row(field, before.get(JSON.stringify(field.path))));
      }
      if (focused) this.#rows.get(focused[0])?.control.focus();
    }
    #row(field, before) {
      const line = html("label", field.kind === "area" ? "carts-teach-wide" : "");
      const control2 = controlFor(field);
      control2.value = field.value;
      const note = html("span", "carts-teach-note");
      made += 1;
      note.id = `carts-teach-note-${made}`;
      note.setAttribute("role", "status");
      control2.setAttribute("aria-describedby", note.id);
      line.append(html("span", "carts-teach-label", field.label), control2);
      const take = () => {
        clearTimeout(row.timer);
        row.timer = 0;
        if (control2.value !== row.field.value) return void this.#take(row);
        if (row.refused) this.#say(row, "");
        row.refused = false;
        delete control2.dataset.waits;
      };
      const row = { control: control2, note, field, timer: 0, asked: 0, wrong: false, refused: false, take };
      if (before?.refused) {
        control2.value = before.control.value;
        row.refused = true;
        this.#say(row, before.note.textContent ?? "");
      }
      control2.addEventListener("input", () => {
        control2.dataset.waits = "";
        clearTimeout(row.timer);
        row.timer = setTimeout(take, PAUSE);
      });
      control2.addEventListener("change", take);
      this.#rows.set(JSON.stringify(field.path), row);
      const whole2 = html("div", "carts-teach-field");
      whole2.append(line, note);
      return whole2;
    }
    async #take(row) {
      row.asked += 1;
      row.control.dataset.waits = "";
      try {
        const why = await this.set(row.field, row.control.value, row);
        row.refused = why !== "";
        this.#say(row, why);
      } catch (error) {
        row.refused = true;
        this.#say(row, error.message);
      } finally {
        row.asked -= 1;
        if (!row.asked && !row.timer) delete row.control.dataset.waits;
      }
    }
    #say({ control: control2, note }, text2) {
      note.textContent = text2;
      control2.setAttribute("aria-invalid", String(text2 !== ""));
    }
  };
  var withoutPath = ({ message }) => message.replace(/^[\w.-]+: /, "");
  function named2(fields, finding) {
    const { line, col, message } = finding;
    const field = fields.find(({ place: place4 }) => place4[0] === line && place4[1] === col);
    if (!field) return message;
    return `${[field.group, field.label].filter(Boolean).join(", ")}: ${withoutPath(finding)}`;
  }
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
    show(text2, first, wrong) {
      const plain2 = text2.replace(/\r\n?/g, "\n");
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
    goTo(line, col) {
      const lines3 = this.area.value.split("\n");
      const before = lines3.slice(0, line - this.first).join("\n").length;
      const at = Math.min(before + (line > this.first ? 1 : 0) + col - 1, this.area.value.length);
      this.area.focus();
      this.area.setSelectionRange(at, at);
    }
    #count() {
      const count2 = this.area.value.replace(/\n$/, "").split("\n").length;
      this.area.rows = Math.max(2, count2 + (this.area.value.endsWith("\n") ? 1 : 0));
      const rows = [];
      for (let k = 0; k < count2; k += 1) {
        const line = this.first + k;
        const bad = this.wrong.has(line);
        const row = html("span", bad ? "carts-teach-wrong" : "", `${bad ? "▸" : ""}${line}`);
        rows.push(row);
      }
      this.numbers.replaceChildren(...rows);
    }
  };

  // src/teach/piece-title.js
  var EMPTY = "+ text here";
  function titleOf({ kind: kind2, text: text2, title, id }) {
    if (kind2 === "top") return seen(/^title: *(.*)/m.exec(text2)?.[1] ?? "");
    if (kind2 === "block") {
      const said = (title ?? "").replace(TABLE, "") || title?.split("\n")[0];
      return short2(seen(unbarred(said || id || text2.split("\n")[0] || "")));
    }
    const heading = /^#+ +(.+)/m.exec(text2)?.[1];
    const lines3 = heading ? [heading] : text2.split("\n").map(unmarked);
    return short2(lines3.map(seen).find(Boolean) ?? EMPTY);
  }
  var TABLE = /^ *\|.*\n *\|[ :|-]+(?:\n *\|.*)*\s*/;
  var unbarred = (line) => {
    if (!/^ *\|.*\| *$/.test(line)) return line;
    const cells = line.split("|").map((cell) => cell.trim());
    return cells.filter((cell) => /[^:-]/.test(cell)).join(", ");
  };
  var short2 = (words) => words.length > 70 ? `${words.slice(0, 70)}…` : words;
  var unmarked = (line) => unbarred(line.replace(/^ *(?:#+(?: |$)|(?:> ?)+|(?:[-+*]|\d+\.) )/, ""));
  function seen(line) {
    return line.replace(/^(?:!!!|\?{3}\+?) .*?"(.*)".*$/, "$1").replace(/^(?:!!!|\?{3}\+?) (\w+).*$/, "$1").replace(/<!--.*?-->|\{:?[^}]*\}/g, "").replace(/!?\[([^\]]*)\]\([^)]*\)/g, "$1").replace(/[*_`$]/g, "").trim();
  }

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
      this.piece = { kind: "text", text: "", line: 1 };
      this.findings = [];
      this.root.addEventListener("toggle", () => {
        if (!this.root.open) return;
        this.#fill();
        acts.opened();
      });
    }
    get area() {
      return this.piece.kind === "text" ? this.prose : this.text.area;
    }
    flush() {
      this.#fields.flush();
    }
    undo() {
      this.#fields.undo();
    }
    show(piece, findings, changed) {
      this.piece = piece;
      this.findings = findings;
      say(this.kind, piece.kind === "block" ? KINDS[piece.name ?? ""] ?? "Block" : place3(piece));
      const title = titleOf(piece);
      say(this.title, title);
      this.root.classList.toggle("carts-teach-empty", title === EMPTY);
      const count2 = findings.length;
      const wrong = count2 ? `${count2} ${count2 === 1 ? "mistake" : "mistakes"}` : "";
      say(this.mark, [changed ? "changed" : "", wrong].filter(Boolean).join(", "));
      this.root.classList.toggle("carts-teach-has-mistake", count2 > 0);
      if (this.root.open) this.#fill();
    }
    #fill() {
      const { piece, findings } = this;
      if (!this.#filled) {
        this.#filled = true;
        const inside4 = html("div", "carts-teach-inside");
        if (piece.kind === "block") inside4.append(this.#fields.root, this.mistakes, this.asText);
        else if (piece.kind === "text") inside4.append(this.prose, this.mistakes);
        else inside4.append(this.text.root, this.mistakes);
        if (!piece.fields?.length) this.asText.open = true;
        this.root.append(inside4);
      }
      this.#fields.show(piece.fields ?? [], findings);
      if (piece.kind === "text") {
        const plain2 = piece.text.replace(/\r\n?/g, "\n");
        if (this.prose.value !== plain2) this.prose.value = plain2;
        this.prose.rows = Math.max(3, Math.ceil(plain2.length / 50) + plain2.split("\n").length / 2);
      } else this.text.show(piece.text, piece.line, new Set(findings.map((finding) => finding.line)));
      this.#list(findings);
    }
    #list(findings) {
      const rows = findings.map((finding) => {
        const row = html("li");
        const go = html("button", "carts-button", `line ${finding.line}`);
        go.setAttribute("type", "button");
        go.addEventListener("click", () => this.goTo(finding));
        row.append(
          go,
          " ",
          html("span", "carts-teach-message", named2(this.piece.fields ?? [], finding))
        );
        if (finding.hint) row.append(" ", html("span", "carts-teach-hint", finding.hint));
        row.dataset.place = `${finding.file}:${finding.line}:${finding.col}`;
        return row;
      });
      this.mistakes.replaceChildren(...rows);
      this.mistakes.hidden = rows.length === 0;
      if (rows.length && !this.piece.fields?.length) this.asText.open = true;
    }
    goTo({ line, col }) {
      this.root.open = true;
      this.asText.open = true;
      if (this.piece.kind === "text") this.prose.focus();
      else this.text.goTo(line, col);
    }
  };
  var place3 = (piece) => piece.kind === "top" ? "Facts" : "Text";

  // src/shared/working.js
  var still = (event) => event.repeat && event.preventDefault();
  function passOn(from, to) {
    if (document.activeElement !== from) return;
    to.addEventListener("keydown", still);
    to.focus();
  }

  // src/teach/saves.js
  var WITHHELD = "Notes and marking guides are not in it: before it takes the place of your own file, choose that file in the yellow box and save again.";
  function toolbar(session2, tell) {
    const root = html("div", "carts-teach-tools");
    const undo = button("Undo", () => session2.undo(), "carts-teach-undo");
    const redo = button("Redo", () => session2.redo(), "carts-teach-redo");
    const saved = (name, words, lacking) => {
      const faulty = Boolean(session2.look?.findings.length);
      const said = [
        lacking.length ? `${name} was made without what you typed last. ${lacking.join(" ")}` : words
      ];
      if (session2.withheld) said.push(WITHHELD);
      if (faulty) said.push("There are mistakes in it: the build would stop at them.");
      tell(said.join(" "), faulty ? "fault" : said.length > 1 || lacking.length ? "warning" : "");
    };
    const save = button(
      "Save lesson",
      async () => {
        const lacking = await session2.typed();
        const { name } = session2;
        download(name, session2.text, "text/markdown");
        saved(name, `Saved as ${name}: look in your folder “Downloads”.`, lacking);
      },
      "carts-teach-save"
    );
    const zip = button(
      "Save as zip",
      async () => {
        const name = session2.name.replace(/\.md$/, ".zip");
        const lacking = await session2.typed();
        try {
          const bytes = Uint8Array.from(atob(await session2.zip()), (letter) => letter.charCodeAt(0));
          downloadBlob(name, new Blob([bytes], { type: "application/zip" }));
          saved(name, `Saved as ${name}, with a list of what was changed.`, lacking);
        } catch (error) {
          tell(error.message);
        }
      },
      "carts-teach-zip"
    );
    const reset = askingButton(
      "Back to the published lesson",
      "Go back to the lesson as it was published?",
      "Yes, go back",
      () => session2.reset(),
      "carts-teach-reset"
    );
    root.append(undo, redo, save, zip, reset);
    const back = need(reset, "button");
    const draw = () => {
      undo.disabled = !session2.history.canUndo;
      redo.disabled = !session2.history.canRedo;
      if (!session2.changed) passOn(back, undo);
      back.disabled = !session2.changed;
    };
    draw();
    return { root, draw };
  }

  // src/teach/panel.js
  var Panel = class {
    #editors = [];
    #pieces = [];
    #published = /* @__PURE__ */ new Set();
    #base = "";
    #whole = null;
    constructor(session2) {
      this.session = session2;
      this.root = html("aside", "carts carts-teach");
      this.root.setAttribute("aria-label", "Change this lesson");
      const { root, heading } = head(session2, this.root);
      this.heading = heading;
      this.note = html("p", "carts-teach-status");
      this.note.setAttribute("role", "status");
      this.state = html("p", "carts-teach-state");
      this.state.setAttribute("role", "status");
      this.tools = toolbar(session2, (text2, kind2) => this.status(text2, kind2));
      this.own = new OwnFile(session2, (text2) => this.status(text2));
      this.notices = html("div", "carts-teach-notices");
      this.list = html("div", "carts-teach-pieces");
      const body2 = html("div", "carts-teach-body");
      body2.append(this.own.root, this.notices, this.list);
      const bar2 = html("div", "carts-teach-bar");
      bar2.append(this.tools.root, this.note, this.state);
      this.root.append(root, bar2, body2);
    }
    get #unchanged() {
      return this.session.told.text === null ? "As in your file." : "As published.";
    }
    focus() {
      this.heading.focus();
    }
    flush() {
      for (const editor of this.#editors) editor.flush();
    }
    undo() {
      for (const editor of this.#editors) editor.undo();
    }
    status(text2, kind2 = "") {
      this.note.dataset.kind = kind2;
      say(this.note, text2);
    }
    kept(kept) {
      const words = kept ? "Draft kept in this browser." : "This browser keeps no drafts: save often.";
      say(this.state, this.session.changed ? words : this.#unchanged);
      this.root.dataset.kept = String(kept);
    }
    follow() {
      this.root.dataset.state = this.#whole ? "unchecked" : "looking";
      this.#whole?.show(whole(this.session.text), [], false);
      this.tools.draw();
      this.own.follow();
    }
    drawn() {
      this.root.dataset.state = "ready";
    }
    published({ pieces }, base) {
      this.#base = base;
      this.#published = new Set(pieces.map((piece) => piece.text));
    }
    take(look) {
      const { pieces, findings } = look;
      if (this.#base !== this.session.base && this.session.text === this.session.base)
        this.published(look, this.session.base);
      if (shape(pieces) !== shape(this.#pieces)) this.#build(pieces);
      this.#pieces = pieces;
      const file = this.session.told.file;
      pieces.forEach((piece, k) => {
        const next = pieces[k + 1]?.line ?? Number.POSITIVE_INFINITY;
        const own = findings.filter(
          ({ line, file: where2 }) => where2 === file && line >= piece.line && line < next
        );
        const last = k === pieces.length - 1;
        const others = last ? findings.filter(({ file: where2 }) => where2 !== file) : [];
        const changed = this.#published.size > 0 && !this.#published.has(piece.text);
        this.#editors[k]?.show(piece, [...own, ...others], changed);
      });
      const count2 = findings.length;
      this.root.dataset.mistakes = String(count2);
      const words = count2 === 1 ? "1 mistake" : `${count2} mistakes`;
      const faulty = this.#editors.filter((editor) => editor.findings.length);
      const closed2 = faulty.length > 0 && !faulty.some((editor) => editor.root.open);
      const where = closed2 ? ` The first is in “${faulty[0]?.title.textContent}”: open it.` : "";
      if (count2)
        this.status(`${words}: the page shows these parts as they were before.${where}`, "fault");
      else if (this.note.dataset.kind === "fault") this.status("");
      if (!this.state.textContent) say(this.state, this.#unchanged);
      this.tools.draw();
    }
    #build(pieces) {
      const open3 = new Set(
        this.#editors.filter((e) => e.root.open).map((e) => e.piece.id || e.piece.line)
      );
      const typing = this.#editors.find((editor) => editor.area === document.activeElement);
      const before = typing ? this.#editors.indexOf(typing) : -1;
      let at = typing?.area.selectionStart ?? 0;
      for (let k = 0; k < before; k += 1) at += plain(this.#pieces[k]?.text ?? "").length;
      this.#editors = pieces.map((piece, k) => {
        const editor = new PieceEditor({
          typed: (text2) => this.#typed(k, text2),
          set: (field, value, owner) => this.session.set(this.#blockOf(k), field, value, owner),
          opened: () => this.session.page.reveal(this.#blockOf(k))
        });
        editor.piece = piece;
        editor.root.open = open3.has(piece.id || piece.line);
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
    #typed(k, typed) {
      const piece = this.#pieces[k];
      if (!piece) return;
      const ends2 = piece.text.includes("\r\n") ? typed.replaceAll("\n", "\r\n") : typed;
      const texts = this.#pieces.map(({ text: text2 }, other) => other === k ? ends2 : text2);
      this.#pieces = this.#pieces.map((one, other) => other === k ? { ...one, text: ends2 } : one);
      this.session.change(texts.join(""), `piece ${k}`);
    }
    #blockOf(k) {
      if (this.#pieces[k]?.kind !== "block") return -1;
      return this.#pieces.slice(0, k).filter((piece) => piece.kind === "block").length;
    }
    openBlock(index) {
      const editor = this.#editors.filter(({ piece }) => piece.kind === "block")[index];
      if (!editor) return;
      editor.root.open = true;
      editor.root.scrollIntoView({ block: "start" });
      editor.summary.focus();
    }
    askForFile() {
      this.root.dataset.state = "asks";
      this.tools.root.hidden = true;
      const words = `This lesson has a test, so its text is not in the site. Choose your own file (${this.session.name}):`;
      this.notices.replaceChildren(
        ownFile(words, (text2) => {
          this.tools.root.hidden = false;
          this.notices.replaceChildren();
          void this.session.openOwn(text2);
        })
      );
    }
    offerEarlier(drafts) {
      this.notices.append(...drafts.map((draft) => earlierDraft(this.session, draft)));
    }
    withoutPython(why) {
      this.status(`${why} The text is not checked here, and the page does not follow.`);
      const editor = new PieceEditor({
        typed: (text2) => this.session.change(text2, "all"),
        set: async () => "",
        opened: () => {
        }
      });
      editor.show(whole(this.session.text), [], false);
      this.#whole = editor;
      editor.root.open = true;
      this.list.replaceChildren(editor.root);
      this.root.dataset.state = "unchecked";
    }
  };
  var whole = (text2) => ({ kind: "top", text: text2, line: 1 });
  var shape = (pieces) => pieces.map(({ kind: kind2, name, id }) => `${kind2} ${name} ${id}`).join("\n");
  var plain = (text2) => text2.replace(/\r\n?/g, "\n");

  // src/teach/under-way.js
  var PATIENCE4 = 8e3;
  var UnderWay = class {
    #values = /* @__PURE__ */ new Map();
    get some() {
      return this.#values.size > 0;
    }
    add(name, done) {
      const told3 = done.then(
        (why) => why && `${name}: ${why}`,
        (error) => `${name}: ${error.message}`
      );
      this.#values.set(told3, name);
      void told3.then(() => this.#values.delete(told3));
    }
    async all(patience = PATIENCE4) {
      if (!this.some) return [];
      let timer = 0;
      const late = new Promise((resolve) => {
        timer = setTimeout(resolve, patience);
      });
      const one = ([told4, name]) => Promise.race([told4, late.then(() => `${name}: Python has not answered yet.`)]);
      const told3 = await Promise.all([...this.#values].map(one));
      clearTimeout(timer);
      return [...new Set(told3.filter(Boolean))];
    }
  };

  // src/teach/session.js
  var PAUSE2 = 250;
  var Session = class {
    #timer = 0;
    settled = Promise.resolve();
    look = null;
    #working = false;
    #typed = new UnderWay();
    constructor({ told: told3, client, assets, drafts, link }) {
      this.told = told3;
      this.client = client;
      this.drafts = drafts;
      this.link = link;
      this.base = told3.text ?? "";
      this.history = new History(this.base);
      const article = link.closest("article") ?? document.body;
      this.page = new LessonPage(article, assets, (k) => this.panel.openBlock(k));
      this.panel = new Panel(this);
      this.looks = new Looks(this);
    }
    get text() {
      return this.history.text;
    }
    get withheld() {
      return this.text.includes(KEPT_OUT);
    }
    get changed() {
      return this.text !== this.base;
    }
    get name() {
      return this.told.file.split("/").at(-1) ?? "lesson.md";
    }
    async open() {
      this.show();
      scrollTo(0, 0);
      if (this.told.text === null) return this.panel.askForFile();
      this.panel.status("Starting Python …");
      await this.#begin({ published: true, ...await this.drafts.found() });
    }
    async #begin({ published, draft, earlier }) {
      const built = this.text;
      const back = this.#takeBack(draft);
      void this.drafts.hear((other) => this.panel.offerEarlier([other]));
      this.#working = true;
      try {
        for (let more = true; more; ) {
          const look = await this.looks.ask(() => built);
          this.panel.published(look, built);
          if (this.text === built) this.#take(look);
          if (published) this.page.adopt(look);
          else await this.page.show(look);
          more = look.more || await this.looks.got(look);
        }
        this.panel.status(back ? `Your draft of ${clock(back.last)} is back.` : "");
        if (this.text !== built) await this.#follow();
      } catch (error) {
        const { message, detail } = error;
        console.warn(message, detail ?? "");
        this.panel.offerEarlier(earlier);
        return this.panel.withoutPython(message);
      } finally {
        this.#working = false;
      }
      this.panel.offerEarlier(earlier);
      this.panel.drawn();
    }
    #takeBack(draft) {
      if (!draft || draft.text === this.text) return null;
      if (this.told.text !== null) this.base = draft.base;
      this.history.change(draft.text, "");
      this.panel.kept(true);
      this.panel.own.follow();
      return draft;
    }
    show() {
      enter();
      if (!this.panel.root.isConnected) document.body.append(this.panel.root);
      this.panel.root.hidden = false;
      this.panel.focus();
    }
    close() {
      this.panel.root.hidden = true;
      leave(this);
    }
    change(text2, where, pause = PAUSE2) {
      if (this.history.change(text2, where)) this.#changed(pause);
    }
    undo() {
      this.panel.undo();
      this.history.undo();
      this.#changed();
    }
    redo() {
      this.panel.undo();
      this.history.redo();
      this.#changed();
    }
    reset() {
      this.panel.undo();
      this.change(this.base, "");
      void this.drafts.forget().catch(() => {
      });
    }
    #changed(pause = PAUSE2) {
      if (!this.changed) this.panel.status("");
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
    async lookNow() {
      if (this.#working) return;
      this.#working = true;
      try {
        await this.#follow();
      } catch (error) {
        this.panel.status(error.message);
      } finally {
        this.#working = false;
      }
    }
    async #follow() {
      for (let more = true; more; ) {
        const text2 = this.text;
        const look = await this.looks.ask(() => this.text);
        if (text2 !== this.text) continue;
        this.#take(look);
        await this.page.show(look);
        more = look.more || await this.looks.got(look) || text2 !== this.text;
      }
      this.panel.drawn();
    }
    #take(look) {
      this.look = look;
      this.panel.take(look);
    }
    set(block, field, value, owner) {
      const done = this.#set(block, field, value, owner);
      this.#typed.add([field.group, field.label].filter(Boolean).join(", "), done);
      return done;
    }
    async #set(block, field, value, owner) {
      const { path: path2 } = field;
      const answer = await written(this.client, owner, () => this.text, { block, path: path2, value });
      if (answer.refused) return answer.refused;
      this.change(answer.text, `${block} ${path2.join(".")}`, 0);
      return "";
    }
    typed() {
      this.panel.flush();
      if (this.#typed.some) this.panel.status("Taking over what you typed …");
      return this.#typed.all();
    }
    async openOwn(own) {
      this.base = own;
      this.history = new History(own);
      this.panel.status("Starting Python …");
      const hash = await hashOf(own);
      const published = hash === this.told.hash;
      return this.#begin({ published, ...await this.drafts.ofFile(own, hash) });
    }
    zip() {
      return zipped(this.client, this.told.file, this.text, this.base);
    }
  };

  // src/teacher-main.js
  var PACKAGE = "newtons-carts-teacher";
  var session = null;
  async function begin() {
    const link = document.querySelector(".carts-teach-door a");
    const address = new URL(link.dataset.lesson ?? "", document.baseURI).href;
    const assets = new URL("../", address).href;
    const told3 = await loadLesson(address);
    const base = new URL(`runtime/${new URL(address).search}`, assets).href;
    const client = new Client((more) => startRuntime({ base, packages: [PACKAGE, ...more] }));
    const made2 = new Session({ told: told3, client, assets, drafts: new Drafts(told3), link });
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
    if (session) void session.then((open3) => open3.show());
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
