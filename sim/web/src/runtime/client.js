/**
 * The page's one worker, shared by all scenes. One request is in flight; of each scene only the
 * newest waiting request is kept; a worker that dies is started again, three times at most.
 */

/** @typedef {{header: import("../../../view/types.js").Header, numbers: Float64Array, sent: Record<string, any>}} Reply */
/** @typedef {{request: (message: Record<string, unknown>) => Promise<{header: any, numbers: Float64Array}>, stop: () => void, onlost: (reason: any) => void}} Runtime */
/** @typedef {(more: string[]) => Promise<Runtime>} Start `more`: packages beside those of the scenes */
/** @typedef {"idle" | "starting" | "ready" | "failed"} State */
/** @typedef {() => Record<string, unknown>} Message made when it is sent, so that it is the newest */
/** @typedef {{owner: object, message: Message, settle: {resolve: (reply: Reply) => void, reject: (error: Error) => void}[]}} Job */

const RESTARTS = 3;

/** Events: `state`, after each change of it; `slow`, when a start has shown no progress for seconds; `slow-line`, when
 * that is the network's. */
export class Client extends EventTarget {
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
  /** @type {string[]} packages beside those of the scenes: Python has them, and gets them again after a restart */
  #more = [];
  /** @type {Promise<void>} when all that was asked for is there, or refused */
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
    if (this.#has(names)) return Promise.resolve();
    const needed = this.#growing.then(() => this.#grow(names));
    this.#growing = needed.catch(() => {}); // one that is refused takes nothing from those after it
    return needed;
  }

  /** @param {string[]} names */
  #has(names) {
    return names.every((name) => this.#more.includes(name));
  }

  /** @param {string[]} names */
  async #grow(names) {
    if (this.#has(names)) return; // somebody before has asked for them
    this.wake();
    await this.#settled();
    if (this.state === "failed") throw this.error;
    const more = [...new Set([...this.#more, ...names])];
    this.#use(await this.start(more));
    this.#more = more;
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
      if (runtime !== this.#runtime || this.#flying !== job) return false; // a late reply: dropped
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
      },
    );
  }

  async #boot() {
    const more = this.#more;
    this.#become("starting");
    try {
      const runtime = await this.start(more);
      if (more !== this.#more) return runtime.stop(); // one with more packages came meanwhile
      this.#use(runtime);
      this.#become("ready");
      this.#next();
    } catch (error) {
      if (more === this.#more) this.#fail(error);
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
    this.error =
      reason instanceof Error ? reason : new Error(String(reason ?? "the worker stopped"));
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
}
