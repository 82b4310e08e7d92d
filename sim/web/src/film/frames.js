/** Asks for frames to be shown: the newest wish counts, and the next frame is asked for when one is there. */

export class Frames {
  /** @type {{time?: number, step: number} | null} */
  #wish = null;
  /** @type {Promise<void> | null} */
  #running = null;
  time = 0; // s of the film, of the frame that is shown

  /** @param {import("./helper.js").Helper} helper @param {(picture: ImageBitmap, time: number) => void} show @param {(refused: any) => void} failed */
  constructor(helper, show, failed) {
    this.helper = helper;
    this.show = show;
    this.failed = failed;
  }

  /** @param {number} time s of the film @returns {Promise<void>} resolves when nothing more is wished for */
  want(time) {
    return this.#go({ time, step: 0 });
  }

  /** The frame beside the one that is shown, or that is wished for. @param {number} step 1: after it, −1: before it */
  beside(step) {
    return this.#go({ ...this.#wish, step: (this.#wish?.step ?? 0) + step });
  }

  /** Whether another frame is on its way. */
  get coming() {
    return this.#running !== null;
  }

  /** Whether the frame that comes is not the one that is wished for any more. */
  get newer() {
    return this.#wish !== null;
  }

  /** @param {{time?: number, step: number}} wish @returns {Promise<void>} */
  #go(wish) {
    this.#wish = wish;
    this.#running ??= this.#run();
    return this.#running;
  }

  async #run() {
    while (this.#wish) {
      const { time = this.time, step } = this.#wish;
      this.#wish = null;
      try {
        const found = await this.helper.ask({ do: "frame", time, step });
        this.time = found.time;
        this.show(found.picture, found.time);
      } catch (refused) {
        this.failed(refused);
      }
    }
    this.#running = null;
  }
}
