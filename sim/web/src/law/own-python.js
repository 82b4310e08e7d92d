/**
 * A Python for one reader's law, apart from that of the scenes: what runs away in it is ended, and
 * nothing else of the page notices. It starts when it is first asked for something.
 */

import { tr } from "../../../view/language.js";
import { startRuntime } from "../runtime/runtime.js";
import { watch } from "../runtime/watch.js";
import { refusal } from "../shared/waiting.js";

/** @typedef {import("../runtime/runtime.js").Runtime} Runtime */

const PACKAGES = ["newtons-carts-law"];
const LIMIT = 4; // s of one answer, in which the page was awake; a usual law takes a tenth of that
const STARTS = 2; // and at least as many times as long as Python took to start: a slow computer takes long for both
const LONGEST = 20; // s

export class OwnPython {
  /** @type {Promise<Runtime> | null} */
  #runtime = null;
  /** @type {(error: Error) => void} */
  #end = () => {};
  #limit = LIMIT;

  /** @param {string} base address of the folder `runtime/` */
  constructor(base) {
    this.base = base;
  }

  /** Starts it, so that a reader who types need not wait later. */
  wake() {
    if (this.#runtime) return this.#runtime;
    const clock = watch(LONGEST, () => {});
    const started = () => {
      clock.stop();
      this.#limit = Math.max(LIMIT, Math.min(STARTS * clock.spent, LONGEST));
    };
    this.#runtime = startRuntime({ base: this.base, packages: PACKAGES });
    this.#runtime.then(started, started);
    return this.#runtime;
  }

  /**
   * The answer to a request; rejects with what a reader is to be told.
   * @param {Record<string, unknown>} message @returns {Promise<{header: any, numbers: Float64Array}>}
   */
  async ask(message) {
    const started = this.wake();
    /** @type {Promise<never>} */
    const late = new Promise((_, reject) => {
      this.#end = reject; // from now on: also while Python still starts
    });
    late.catch(() => {});
    const failed = started.catch((error) => {
      if (this.#runtime === started) this.#runtime = null;
      throw error;
    });
    const runtime = await Promise.race([failed, late]);
    const time = this.#limit;
    const timer = watch(time, () => {
      this.#end(new Error(tr("Your law took more than {time} s and was ended.", { time })));
      this.stop();
    });
    try {
      const answer = runtime.request({ kind: "law", ...message });
      answer.catch(() => {}); // where the limit was first, nobody waits for it any more
      const { header, numbers } = /** @type {any} */ (await Promise.race([answer, late]));
      if (!header.ok) throw refusal(header.problems ?? []);
      return { header, numbers };
    } catch (error) {
      if (runtime.gone) this.#runtime = null;
      throw error;
    } finally {
      timer.stop();
    }
  }

  /** What the judge finds, part by part. @param {{law: string, scene: any}} whose @param {(text: string) => void} tell @returns {Promise<import("./verdicts.js").Judged>} */
  async judge(whose, tell) {
    /** @type {any} */
    let before = null;
    for (let part = 0, parts = 6; part !== null; ) {
      tell(tr("The judge looks: part {part} of {parts} …", { part: part + 1, parts }));
      const { header } = await this.ask({ do: "judge", ...whose, part, before });
      before = header.judged;
      parts = header.parts;
      part = header.next;
    }
    return before;
  }

  /** Ends it, whatever it does. */
  stop() {
    const runtime = this.#runtime;
    this.#runtime = null;
    void runtime?.then(
      (one) => one.stop(),
      () => {},
    );
    this.#end(new Error(tr("Stopped.")));
  }
}

/** The line of the law that was refused; 0 where it was something else. @param {any} error */
export function lineOf({ path = [] }) {
  const [laws, , line] = path;
  return laws === "laws" ? Number(line) || 0 : 0;
}
