"use strict";
(() => {
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
    const [head = "", ...tail] = parts;
    return tail.reduce((first, second) => tr("{first}, {second}", { first, second }), head);
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
  }

  // ../view/numbers.js
  var SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  function exponent(value) {
    return value ? Number(Math.abs(value).toExponential(16).split("e")[1]) : 0;
  }
  function fixed(value, decimals) {
    const text = Math.abs(value).toFixed(decimals);
    return value < 0 && /[1-9]/.test(text) ? `−${text}` : text;
  }
  function short(value, figures = 3) {
    const power = exponent(value);
    if (value && (power <= -4 || power >= 6)) {
      const [digits = "", tens] = Math.abs(value).toExponential(figures - 1).split("e");
      return `${value < 0 ? "−" : ""}${trim(digits)} × 10${superscript(Number(tens))}`;
    }
    return trim(fixed(value, Math.max(0, figures - 1 - power)));
  }
  function superscript(power) {
    const digits = String(Math.abs(power)).replace(/\d/g, (d) => SUPERSCRIPT[Number(d)] ?? "");
    return power < 0 ? `⁻${digits}` : digits;
  }
  function trim(text) {
    return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  }
  function px(value, decimals = 1) {
    const factor = 10 ** decimals;
    const rounded = Math.floor(value * factor + 0.5) / factor;
    return String(rounded === 0 ? 0 : rounded);
  }

  // src/shared/dom.js
  var SVG = "http://www.w3.org/2000/svg";
  function svg(tag, attributes = {}) {
    const made = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
    return made;
  }
  function html(tag, className = "", text = "") {
    const made = document.createElement(tag);
    if (className) made.className = className;
    if (text) made.textContent = text;
    return made;
  }
  var TEXT = 3;
  function say(element, text) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text) only.nodeValue = text;
    } else if (element.textContent !== text) element.textContent = text;
  }

  // src/shared/waiting.js
  function refusal(problems) {
    const [first] = problems;
    if (!first) return new Error(tr("This value does not work."));
    const message = told(first.message);
    const text = first.hint ? `${message}: ${told(first.hint)}` : message;
    return Object.assign(new Error(text), { path: first.path, refused: true });
  }

  // ../view/graph.js
  var LEFT = 52;
  var RIGHT = 350;
  var TOP = 8;
  var BOTTOM = 127;
  function timeX(plane, t) {
    return LEFT + (t - plane.time.low) * ((RIGHT - LEFT) / (plane.time.high - plane.time.low));
  }
  function valueY(plane, value) {
    return BOTTOM - (value - plane.value.low) * ((BOTTOM - TOP) / (plane.value.high - plane.value.low));
  }

  // ../view/markers.js
  function styleOf(index) {
    return `b${index % 8}`;
  }

  // src/proof/band.js
  function drawBand(band, { root, quantity, per, camera }, plane) {
    root.querySelector('[data-part="band"]')?.remove();
    if (!band || quantity !== "x" && quantity !== "v") return;
    const seen = (value, t) => quantity === "x" ? value - camera * t : (value - camera) / per;
    const front = root.querySelector('[data-part="curves"]');
    const clip = front?.getAttribute("clip-path") ?? "none";
    const group = svg("g", { "data-part": "band", "clip-path": clip, "aria-hidden": "true" });
    Object.values(band[quantity]).forEach((bounds, cart) => {
      const d = outline(bounds, band.t, plane, seen);
      group.append(svg("path", { class: `carts-band carts-${styleOf(cart)}`, d }));
    });
    front?.before(group);
  }
  function outline(bounds, times, plane, seen) {
    const at = (k, side) => {
      const t = Number(times[k]);
      return `${px(timeX(plane, t))} ${px(valueY(plane, seen(bounds[k]?.[side] ?? 0, t)))}`;
    };
    const order = bounds.map((_, k) => k);
    const up = order.map((k) => at(k, 1));
    const down = order.reverse().map((k) => at(k, 0));
    return `M${[...up, ...down].join("L")}Z`;
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
      (side) => track[side] === "wall" && whatIs(side, track) === "wall"
    );
  }
  function thingAt(name, track, form2) {
    const thing = THINGS[whatIs(name, track)]?.()[form2];
    if (!thing || whatIs("left", track) !== whatIs("right", track)) return thing ?? "";
    return name === "left" ? tr("{thing} on the left", { thing }) : tr("{thing} on the right", { thing });
  }

  // src/proof/rows.js
  var MANY = 8;
  var MORE = 3;
  var LEAST = 3;
  var FINEST = 17;
  function rows({ final, events }, track) {
    const times = events.filter(({ kind }) => kind !== "end").map(
      ({ t, kind, bodies }) => row(tr("t: {event}", { event: named(kind, bodies, track) }), t, "s")
    );
    const ends = Object.keys(final.x).flatMap((cart) => [
      row(tr("x of {cart} at the end", { cart }), final.x[cart], "m"),
      row(tr("v of {cart} at the end", { cart }), final.v[cart], "m/s")
    ]);
    return [...times, ...ends];
  }
  function named(kind, bodies, track) {
    const names = bodies.map((name) => body(name, track));
    const [one = "", other = ""] = names;
    if (kind === "contact") return tr("{one} and {other} touch", { one, other });
    if (kind === "peak") return tr("{one} and {other} press hardest", { one, other });
    if (kind === "separate") return tr("{one} and {other} part", { one, other });
    if (kind === "release") return tr("{one} and {other} are released", { one, other });
    if (kind === "stick") return tr("{one} and {other} stay together", { one, other });
    if (kind === "stop") return tr("{one} stops", { one: inRow(names) });
    if (kind === "start") return tr("{one} starts", { one: inRow(names) });
    return `${kind} ${inRow(names)}`;
  }
  function row(label, bounds, unit) {
    const line = html("tr");
    const head = html("th", "", label);
    head.setAttribute("scope", "row");
    line.append(head);
    const { texts, count } = cells(bounds);
    for (const text of texts) line.append(html("td", "carts-proof-bound", `${text} ${unit}`));
    line.append(html("td", "", count));
    return line;
  }
  function cells(bounds) {
    const sure = sureDigits(bounds);
    if (!Number.isFinite(sure)) return { texts: [...bounds], count: tr("all") };
    const decimals = noughts(bounds);
    if (decimals >= LEAST) {
      const count = counted("0, to one decimal", "0, to {n} decimals", decimals);
      return { texts: [asPower(bounds[0], -1), asPower(bounds[1], 1)], count };
    }
    return { texts: shown(bounds, sure), count: sure ? String(sure) : tr("none") };
  }
  function noughts([low, high]) {
    if (Number(low) > 0 || Number(high) < 0) return 0;
    const size = Math.max(Math.abs(Number(low)), Math.abs(Number(high)));
    return Math.max(0, Math.floor(-Math.log10(2 * size)));
  }
  function asPower(bound, side) {
    const value = Number(bound);
    if (!value) return "0";
    const digits = 100 * Number(value.toExponential().split("e")[0]);
    const outside = (side > 0 ? Math.ceil(digits) : Math.floor(digits)) + side;
    const more = Math.abs(outside) >= 1e3 ? 1 : 0;
    return `${fixed(outside / 10 ** (2 + more), 2)} × 10${superscript(exponent(value) + more)}`;
  }
  function shown(bounds, sure) {
    const [low, high] = bounds.map(Number);
    const size = Math.max(Math.abs(low ?? 0), Math.abs(high ?? 0));
    if (sure > MANY || !size) return bounds;
    const decimals = Math.max(0, sure + MORE - Math.floor(Math.log10(size)));
    const unit = 10 ** decimals;
    return [
      ((Math.floor(Number(low) * unit) - 1) / unit).toFixed(decimals),
      ((Math.ceil(Number(high) * unit) + 1) / unit).toFixed(decimals)
    ];
  }
  function sureDigits([low, high]) {
    const [a, b] = [Number(low), Number(high)];
    if (a === b) return Infinity;
    for (let digits = FINEST; digits > 0; digits -= 1) {
      if (Number(a.toPrecision(digits)) === Number(b.toPrecision(digits))) return digits;
    }
    return 0;
  }

  // src/proof/proof.js
  var PACKAGES = ["newtons-carts-proof"];
  var Proof = class {
    #turn = 0;
    #of = "";
    // the request that was proved, or is being
    #band = null;
    #owner = {};
    // of its own: a proof is no newer run
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
        this.table
      );
      place.append(box);
    }
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
        const { header } = await this.client.ask(
          this.#owner,
          () => this.message({ kind: "certify" })
        );
        if (turn !== this.#turn) return;
        if (!header.ok) throw refusal(header.problems ?? []);
        this.#tell(header);
      } catch (error) {
        if (turn === this.#turn) say(this.note, error.message);
      }
    }
    #tell({ certificate, seconds, band }) {
      const { order, reason, final } = certificate;
      const known = Object.keys(final.x).length > 0;
      const lines = [
        known ? tr("The truth lies between these bounds, for the inputs as they are given.") : tr("No bound for the end: {why}.", { why: told(reason) }),
        order === "proved" ? tr("The order of the events is proved.") : known && tr("Their order is not: {why}.", { why: told(reason) }),
        band && tr("The inputs have a tolerance: the graphs of x and v show as a band what it allows."),
        this.view.baked.fence.camera && tr("Places and velocities are those on the track, not those that the moving camera sees."),
        tr("That took {ratio} times as long as the run.", {
          ratio: short(seconds.proof / seconds.exact, 2)
        })
      ];
      say(this.note, lines.filter(Boolean).join(" "));
      this.table.hidden = !known && certificate.events.length === 0;
      this.count.textContent = band ? tr("digits that the tolerance leaves") : tr("sure digits");
      this.body.replaceChildren(...rows(certificate, this.view.run.header.track));
      this.#show(band);
    }
  };
  function elsewhere() {
    const line = html(
      "p",
      "carts-quiet",
      tr("To check it elsewhere: save the scene block (“Take it along”) as scene.yml, then")
    );
    line.append(" ", html("code", "", "carts run scene.yml --certify --json"), ". ");
    line.append(tr("How it is proved, and a second program for it: page “Certificates”."));
    return line;
  }
  function tableWith(body2, count) {
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
    table.append(heads, body2);
    return table;
  }

  // src/proof-main.js
  globalThis.cartsProof = Proof;
})();
