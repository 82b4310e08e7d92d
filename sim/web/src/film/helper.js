/** The worker that takes a film apart, as promises. One film, one worker; both end together. */

// @ts-expect-error: the bundler puts the worker's text here
import workerText from "./worker.js?text";

let address = ""; // of the worker's text: one for all films of the page

/** @typedef {{code: string, detail: string}} Refusal */
/** @typedef {{resolve: (found: any) => void, reject: (refused: Refusal) => void, part: (part: number) => void}} Asked */

export class Helper {
  /** @type {Map<number, Asked>} */
  #asked = new Map();
  #last = 0;

  constructor() {
    address ||= URL.createObjectURL(new Blob([workerText], { type: "text/javascript" }));
    this.worker = new Worker(address);
    this.worker.onmessage = ({ data: { id, done, refused, part, ...found } }) => {
      const asked = this.#asked.get(id);
      if (!done) return asked?.part(part);
      this.#asked.delete(id);
      if (refused) asked?.reject(refused);
      else asked?.resolve(found);
    };
    this.worker.onerror = (event) => {
      event.preventDefault();
      for (const { reject } of this.#asked.values()) {
        reject({ code: "lost", detail: event.message });
      }
      this.#asked.clear();
    };
  }

  /**
   * @param {Record<string, unknown>} message @param {(part: number) => void} part called with how much is done, 0 to 1
   * @returns {Promise<any>} rejects with a Refusal
   */
  ask(message, part = () => {}) {
    this.#last += 1;
    const id = this.#last;
    return new Promise((resolve, reject) => {
      this.#asked.set(id, { resolve, reject, part });
      this.worker.postMessage({ ...message, id });
    });
  }

  /** What is being followed is given up. */
  stop() {
    this.worker.postMessage({ do: "stop", id: this.#last });
  }

  end() {
    this.worker.terminate();
    this.#asked.clear();
  }
}
