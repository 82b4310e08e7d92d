/** Asks for frames to be shown: the newest wish counts, and the next frame is asked for when one is there. */

export class Frames {
  /** @type {number | null} */
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
    this.#wish = time;
    this.#running ??= this.#run();
    return this.#running;
  }

  async #run() {
    try {
      while (this.#wish !== null) {
        const wish = this.#wish;
        this.#wish = null;
        const found = await this.helper.ask({ do: "frame", time: wish });
        this.time = found.time;
        this.show(found.picture, found.time);
      }
    } catch (refused) {
      this.failed(refused);
    } finally {
      this.#running = null;
    }
  }
}
