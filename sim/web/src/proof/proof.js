/**
 * Digits that are proved, in “How is this computed?”: a button, and then two bounds for the end of every
 * cart and for every event. Python proves them (`sim/certify`), in a package that comes with the first
 * press. Where inputs have a tolerance the graphs show a band of what it allows.
 */

import { told, tr } from "../../../view/language.js";
import { short } from "../../../view/numbers.js";
import { html, say } from "../shared/dom.js";
import { refusal } from "../shared/waiting.js";
import { drawBand } from "./band.js";
import { rows } from "./rows.js";

/** @typedef {import("./rows.js").Certificate} Certificate */
/** @typedef {import("./band.js").Band} Band */

const PACKAGES = ["newtons-carts-proof"];

export class Proof {
  #turn = 0;
  #of = ""; // the request that was proved, or is being
  /** @type {Band | null} */
  #band = null;
  #owner = {}; // of its own: a proof is no newer run

  /**
   * @param {import("../scene/scene-view.js").SceneView} view @param {Element} place where it stands
   * @param {import("../runtime/client.js").Client} client
   * @param {(more: object) => Record<string, unknown>} message a request for the scene as it is now
   */
  constructor(view, place, client, message) {
    this.view = view;
    this.client = client;
    this.message = message;
    this.button = html("button", "carts-button carts-proof-go", tr("Prove these digits"));
    this.button.setAttribute("type", "button");
    this.button.addEventListener("click", () => void this.#prove());
    this.note = html("p", "carts-how-note carts-proof-note");
    this.note.setAttribute("role", "status");
    this.body = html("tbody");
    this.table = html("div", "carts-scroll");
    this.table.hidden = true;
    this.count = html("th", "");
    this.count.setAttribute("scope", "col");
    this.table.append(tableWith(this.body, this.count), elsewhere());
    const box = html("div", "carts-proof");
    box.append(
      html("p", "carts-how-head", tr("How many of these digits are sure?")),
      this.button,
      this.note,
      this.table,
    );
    place.append(box);
  }

  /** Another run is there: what was proved is no longer of it, unless its values are the same. */
  forget() {
    if (this.#of === this.#asked()) return;
    this.#of = "";
    this.#turn += 1;
    const was = !this.table.hidden;
    this.table.hidden = true;
    this.#show(null);
    say(this.note, was ? tr("The values have changed: prove them again.") : "");
  }

  #asked() {
    return JSON.stringify(this.message({ kind: "certify" }));
  }

  /** @param {Band | null} band null: none */
  #show(band) {
    if (!band && !this.#band) return;
    this.#band = band;
    this.view.redraw((graph, plane) => drawBand(band, graph, plane));
  }

  async #prove() {
    this.#of = "";
    this.forget();
    this.#of = this.#asked();
    const turn = this.#turn;
    say(this.note, tr("Computed once more, with bounds that are rounded outwards …"));
    try {
      await this.client.need(PACKAGES);
      const { header } = await this.client.ask(this.#owner, () =>
        this.message({ kind: "certify" }),
      );
      if (turn !== this.#turn) return;
      if (!header.ok) throw refusal(header.problems ?? []);
      this.#tell(/** @type {any} */ (header));
    } catch (error) {
      if (turn === this.#turn) say(this.note, /** @type {Error} */ (error).message);
    }
  }

  /** @param {{certificate: Certificate, seconds: {exact: number, proof: number}, band: Band | null}} answer */
  #tell({ certificate, seconds, band }) {
    const { order, reason, final } = certificate;
    const known = Object.keys(final.x).length > 0;
    const lines = [
      known
        ? tr("The truth lies between these bounds, for the inputs as they are given.")
        : tr("No bound for the end: {why}.", { why: told(reason) }),
      order === "proved"
        ? tr("The order of the events is proved.")
        : known && tr("Their order is not: {why}.", { why: told(reason) }),
      band &&
        tr("The inputs have a tolerance: the graphs of x and v show as a band what it allows."),
      this.view.baked.fence.camera &&
        tr("Places and velocities are those on the track, not those that the moving camera sees."),
      tr("That took {ratio} times as long as the run.", {
        ratio: short(seconds.proof / seconds.exact, 2),
      }),
    ];
    say(this.note, lines.filter(Boolean).join(" "));
    this.table.hidden = !known && certificate.events.length === 0;
    this.count.textContent = band ? tr("digits that the tolerance leaves") : tr("sure digits");
    this.body.replaceChildren(...rows(certificate, this.view.run.header.track));
    this.#show(band);
  }
}

/** How somebody else comes to the same bounds. */
function elsewhere() {
  const line = html(
    "p",
    "carts-quiet",
    tr("To check it elsewhere: save the scene block (“Take it along”) as scene.yml, then"),
  );
  line.append(" ", html("code", "", "carts run scene.yml --certify --json"), ". ");
  line.append(tr("How it is proved, and a second program for it: page “Certificates”."));
  return line;
}

/** @param {Element} body @param {Element} count the last head: what the digits are counted for */
function tableWith(body, count) {
  const table = html("table", "carts-table carts-proof-told");
  const head = html("tr");
  for (const text of ["", tr("not less than"), tr("not more than")]) {
    const cell = html(text ? "th" : "td", "", text);
    if (text) cell.setAttribute("scope", "col");
    head.append(cell);
  }
  head.append(count);
  const heads = html("thead");
  heads.append(head);
  table.append(heads, body);
  return table;
}
