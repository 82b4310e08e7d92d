/** Everything that is drawn of the readings and of the model: figure, residuals, carts, table, faults. */

import { told, tr } from "../../../view/language.js";
import { heads, howRead, semicolons } from "../../../view/measured/units.js";
import { fixed } from "../../../view/numbers.js";
import { Player } from "../scene/time/player.js";
import { need, say } from "../shared/dom.js";
import { Figure } from "./figure.js";
import { showResult, showTable } from "./result.js";
import { Source } from "./source.js";
import { Stage } from "./stage.js";

/** @typedef {import("../../../view/measured/types.js").Read} Read */
/** @typedef {import("../../../view/measured/types.js").Drawn} Drawn */

const QUARTER = 0.25; // a collision is over before it is seen
const FINE = 0.01; // m; smaller residuals are told with two decimals of a millimetre

export class Picture {
  #begin = 0;
  /** Called with the time in s and where the model's carts are then, in m. @type {(time: number, places: Record<string, number>) => void} */
  watch = () => {};

  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
    this.figure = new Figure(this.#part("figure"), this.#part("left"));
    this.stage = new Stage(this.#part("stage"));
    this.player = new Player(() => this.#frame());
    this.player.speed = QUARTER;
    this.player.slow = false;
    this.scrub = /** @type {HTMLInputElement} */ (this.#part("scrub"));
    this.scrub.addEventListener("input", () => {
      this.player.pause();
      this.player.seek(this.scrub.valueAsNumber);
    });
    this.#part("play").addEventListener("click", () => this.player.toggle());
  }

  /** @param {string} name @returns {HTMLElement} */
  #part(name) {
    return need(this.root, `.carts-measured-${name}`);
  }

  /** Hides what belongs to an earlier fit. */
  forget() {
    this.#part("result").hidden = true;
    this.#part("back").hidden = true;
  }

  /** What was read, and whether a model can be laid over it. @param {string} name @param {Read} read @param {boolean} motion */
  readings(name, read, motion) {
    this.forget();
    say(this.#part("said"), semicolons([Source.called(name), ...howRead(read)].filter(Boolean)));
    this.#part("legend").replaceChildren(...legend(read));
    this.#part("model").hidden = !motion;
    this.#part("world").hidden = !motion;
    this.#part("left").toggleAttribute(
      "hidden",
      !motion && !(read.forces && read.kind === "force"),
    );
    if (read.kind !== "length") this.#forces(read);
    else if (!motion) this.#points(read);
  }

  /** @param {Read} read */
  #points(read) {
    this.figure.show(read.tracks, heads(read), null);
    showTable(need(this.root, ".carts-measured-table table"), read, null);
    say(this.#part("spread"), "");
  }

  /** Two sensors, or two phones, against each other. @param {Read} read */
  #forces(read) {
    const { forces, kind } = read;
    const summed = kind === "force"; // accelerations of unlike masses have no sum of use
    const tracks = forces ? forces.F.map((F) => ({ t: forces.t, value: F })) : read.tracks;
    this.figure.show(tracks, heads(read), null);
    if (forces && summed) {
      const sum = forces.t.map((_, k) => Number(forces.F[0]?.[k]) + Number(forces.F[1]?.[k]));
      this.figure.rest([{ t: forces.t, value: sum }], [sum], tr("sum in N"), 1);
    }
    showTable(need(this.root, ".carts-measured-table table"), read, null);
    say(this.#part("spread"), forces && summed ? tr("Lower picture: the sum of both forces.") : "");
    if (read.report) showResult(this.#part("result"), read.report);
  }

  /** The model over the readings. @param {Read} read @param {Drawn} drawn */
  draw(read, drawn) {
    this.figure.show(read.tracks, heads(read), drawn.curve, drawn.parameters.touch);
    this.figure.rest(read.tracks, drawn.residuals, tr("rest in mm"), 1000);
    this.stage.show(read.tracks, drawn.curve, drawn.parameters.distance, read.names);
    showTable(need(this.root, ".carts-measured-table table"), read, drawn.residuals);
    const all = read.tracks[0].t.length + read.tracks[1].t.length;
    const spread = `${fixed(1000 * drawn.spread, drawn.spread < FINE ? 2 : 0)} mm`;
    const count = drawn.counted ?? all;
    const size =
      count < all
        ? tr("{spread} (of the {count} readings that the fit counts)", { spread, count })
        : spread;
    say(
      this.#part("spread"),
      tr(
        "Lower picture: residuals, the rest (measured minus model). Their root mean square is {size}.",
        { size },
      ),
    );
    this.#begin = Number(drawn.curve.t[0]);
    this.player.until = Number(drawn.curve.t.at(-1)) - this.#begin;
    this.scrub.max = String(this.player.until);
    this.player.seek(Math.min(this.player.time, this.player.until)); // an earlier file may be longer
  }

  #frame() {
    const t = this.#begin + this.player.time;
    this.stage.at(t);
    this.watch(t, this.stage.places(t));
    this.figure.at(t);
    this.scrub.value = String(this.player.time);
    this.scrub.setAttribute("aria-valuetext", `${fixed(t, 2)} s`);
    say(this.#part("clock"), `t = ${fixed(t, 3)} s`);
    this.#part("play").classList.toggle("carts-is-playing", this.player.playing);
    say(this.#part("play"), this.player.playing ? tr("Pause") : tr("Play"));
  }

  /** What a fit says. @param {import("../../../view/measured/types.js").Report} report */
  told(report) {
    showResult(this.#part("result"), report);
    this.#part("back").hidden = false;
    const fence = /** @type {HTMLTextAreaElement} */ (this.#part("fence"));
    fence.value = told(report.fence);
  }

  /** Readings that cannot be read say so where they come from, a fit that cannot be made where it was asked for. @param {string} name of the readings @param {import("../../../view/measured/types.js").Fault[]} faults @param {string} what was asked of Python; "read": the picture is still that of earlier ones */
  refuse(name, faults, what) {
    const whose = what === "read" ? Source.notRead(name) : "";
    const fit = what !== "" && what !== "read";
    const rows = faults.map((fault, k) => {
      const row = document.createElement("li");
      const help = Source.hinted(name, fault);
      const where = fault.line === null ? "" : Source.place(name, fault.line);
      const text = where ? tr("{name}: {text}", { name: where, text: help }) : help;
      row.textContent = `${k ? "" : whose}${text}`;
      return row;
    });
    this.#part("unfitted").replaceChildren(...(fit ? rows : []));
    if (!fit) this.#part("unread").replaceChildren(...rows);
  }

  /** To a refused fit, if there is one: what was found above may have pushed it out of sight. */
  turn() {
    this.#part("unfitted").firstElementChild?.scrollIntoView({ block: "center" });
  }

  /** @param {string} textContent "" where there is nothing to say (any more) */
  note(textContent) {
    Object.assign(need(this.root, ".carts-note"), { hidden: !textContent, textContent });
  }

  /** @param {string} text */
  busy(text) {
    say(this.#part("busy"), text);
  }
}

/** What a curve shows. @type {Record<Read["kind"], (name: string) => string>} */
const NAMES = {
  length: (name) => name,
  force: (cart) => tr("force on {cart}", { cart }),
  acceleration: (cart) => tr("phone on {cart}", { cart }),
};

/** @param {Read} read @returns {HTMLElement[]} */
function legend(read) {
  return read.names.flatMap((name, k) => {
    const mark = document.createElement("span");
    mark.className = `carts-measured-key carts-b${k}`;
    const text = document.createElement("span");
    text.textContent = NAMES[read.kind](name);
    return [mark, text];
  });
}
