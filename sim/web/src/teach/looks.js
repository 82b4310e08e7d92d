/** Python's looks at the text of a lesson, and what they need beside bare Python. */

/** @typedef {import("./types.js").Look} Look */

export class Looks {
  #looking = {};
  #asked = false;

  /** @param {import("./session.js").Session} session */
  constructor(session) {
    this.session = session;
  }

  /** @param {() => string} text asked for when it is sent @returns {Promise<Look>} */
  async ask(text) {
    const { told, client, page } = this.session;
    const { header } = await client.ask(this.#looking, () => ({
      ...{ kind: "teach", do: "look", lesson: told.lesson, files: told.files },
      ...{ text: text(), have: page.have },
    }));
    return /** @type {any} */ (header);
  }

  /** Loads what a scene needs beside bare Python, once. @param {Look} look @returns {Promise<boolean>} whether to look again */
  async got(look) {
    if (!look.needs.length || this.#asked) return false;
    this.#asked = true;
    try {
      await this.session.client.need(look.needs);
      return true;
    } catch {
      this.session.panel.status(
        "A scene here needs numpy and scipy, which this site has not packed. The build will pack them.",
      );
      return false;
    }
  }
}
