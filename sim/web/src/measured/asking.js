/** What is asked of Python about the readings. A newer request takes the place of an older one of its kind. */

export class Asking {
  /** @type {Record<string, object>} */
  #owners = { read: {}, model: {}, ready: {}, segments: {}, fit: {}, tracker: {} };
  #generation = 0;

  /**
   * @param {import("../runtime/client.js").Client} client
   * @param {() => Record<string, unknown>} common readings and settings, as they are when it is asked
   * @param {() => void} answered
   */
  constructor(client, common, answered) {
    this.client = client;
    this.common = common;
    this.answered = answered;
  }

  /** @param {string} what @param {Record<string, unknown>} more @returns {Promise<any>} */
  async ask(what, more = {}) {
    const { header } = await this.client.ask(this.#owners[what] ?? {}, () => ({
      kind: "measured",
      do: what,
      ...this.common(),
      ...more,
    }));
    this.answered();
    return header;
  }

  /** The same; null if something newer was asked for meanwhile. @param {string} what @param {Record<string, unknown>} more @returns {Promise<any>} */
  async newest(what, more) {
    this.#generation += 1;
    const generation = this.#generation;
    const found = await this.ask(what, more);
    return generation === this.#generation ? found : null;
  }
}
