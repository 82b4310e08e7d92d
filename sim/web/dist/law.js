"use strict";
(() => {
  // src/shared/older.js
  function add(owner, name, value) {
    if (!(name in owner)) {
      Object.defineProperty(owner, name, { value, configurable: true, writable: true });
    }
  }
  function findLastIndex(fits2) {
    for (let k = this.length - 1; k >= 0; k -= 1) if (fits2(this[k], k, this)) return k;
    return -1;
  }
  function findLast(fits2) {
    return this[findLastIndex.call(this, fits2)];
  }
  function at(index) {
    return this[index < 0 ? this.length + index : index];
  }
  for (const kind2 of [Array, Float64Array, Uint8Array]) {
    add(kind2.prototype, "findLast", findLast);
    add(kind2.prototype, "findLastIndex", findLastIndex);
    add(kind2.prototype, "at", at);
  }
  add(String.prototype, "at", at);
  add(
    Object,
    "hasOwn",
    (owner, name) => (
      // biome-ignore lint/suspicious/noPrototypeBuiltins: this is what stands in for Object.hasOwn
      Object.prototype.hasOwnProperty.call(owner, name)
    )
  );
  add(
    globalThis,
    "structuredClone",
    (value) => JSON.parse(JSON.stringify(value))
  );

  // ../view/language.js
  var catalogue = globalThis.cartsWords ?? {};
  var FORMS = "\0";
  var RULE = catalogue["\0"] ?? "";
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function form(one, more, n) {
    const ours = catalogue[more]?.split(FORMS);
    if (!ours) return n === 1 ? one : more;
    const english = n === 1 ? 0 : 1;
    const asked2 = RULE ? Number(RULE[n < RULE.length ? n : 100 + n % 100]) : english;
    return String(ours[Math.min(asked2, ours.length - 1)]);
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

  // ../view/trajectory.js
  function fromWire(header, numbers) {
    const { rows, columns, events } = header;
    const parts = { t: new Float64Array(0), x: {}, v: {}, a: {}, F: {}, dF: {}, E: {}, events };
    columns.forEach(([quantity, ...key], k) => {
      const column = numbers.subarray(k * rows, (k + 1) * rows);
      const name = String(quantity);
      if (!key.length) parts[name] = column;
      else {
        parts[name] ??= {};
        parts[name][key.join(" ")] = column;
      }
    });
    return parts;
  }
  function fromBaked(numbers, events) {
    const parts = { t: Float64Array.from(numbers.t), events };
    for (const quantity of ["x", "v", "a", "F", "dF", "E"]) {
      parts[quantity] = {};
      for (const [key, column] of Object.entries(numbers[quantity] ?? {})) {
        parts[quantity][key] = Float64Array.from(column);
      }
    }
    return parts;
  }
  function isTold({ trajectory }) {
    return trajectory.t.length > 1;
  }
  function rowAt(times2, t) {
    let low = 0;
    let high = times2.length;
    while (low < high) {
      const middle = low + high >> 1;
      if (times2[middle] <= t) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
  function valueAt(times2, values, slopes, t) {
    const k = rowAt(times2, t);
    if (k < 0) return Number(values[0]);
    if (k >= times2.length - 1) return Number(values[values.length - 1]);
    return hermite(times2, values, slopes, k, t);
  }
  function hermite(times2, values, slopes, k, t) {
    const at2 = ((c, i) => c[i]);
    const h = at2(times2, k + 1) - at2(times2, k);
    const s = (t - at2(times2, k)) / h;
    if (!slopes) return at2(values, k) + (at2(values, k + 1) - at2(values, k)) * s;
    const r = 1 - s;
    const found2 = at2(values, k) * (1 + 2 * s) * r * r + at2(slopes, k) * h * s * r * r + at2(values, k + 1) * (1 + 2 * r) * s * s - at2(slopes, k + 1) * h * r * s * s;
    return Number.isFinite(found2) ? found2 : at2(values, k);
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
  function put(element, name, value) {
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  }
  var TEXT = 3;
  function say(element, text) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text) only.nodeValue = text;
    } else if (element.textContent !== text) element.textContent = text;
  }
  function need(root, selector) {
    const found2 = root.querySelector(selector);
    if (!found2) throw new Error(`this page lacks ${selector}; it was built by another version`);
    return found2;
  }

  // src/scene/baked.js
  function bakedOf({ fence, view, numbers, ...header }) {
    const known2 = header;
    return { fence, view, run: { header: known2, trajectory: fromBaked(numbers, known2.events) } };
  }

  // src/shared/spreadsheet.js
  var CELL = /("(?:[^"]|"")*"|[^,\r\n"]*)(,|\r?\n|$)/g;
  var NUMBER = /^-?\d+(?:\.\d+)?(?:e[+-]?\d+)?$/i;
  function forSpreadsheet(csv, language = navigator.language) {
    if (!hasComma(language)) return csv;
    return csv.replace(CELL, (_, cell, end2) => written(cell) + (end2 === "," ? ";" : end2));
  }
  function written(cell) {
    if (NUMBER.test(cell)) return cell.replace(".", ",");
    return cell.includes(";") && !cell.startsWith('"') ? `"${cell}"` : cell;
  }
  function hasComma(language) {
    try {
      return new Intl.NumberFormat(language).format(0.5).includes(",");
    } catch {
      return false;
    }
  }

  // src/shared/download.js
  var FORGOTTEN_AFTER = 6e4;
  function download(name, text, type) {
    const saved = type === "text/csv" ? forSpreadsheet(text) : text;
    downloadBlob(name, new Blob([saved], { type }));
  }
  function downloadBlob(name, blob) {
    const link = document.createElement("a");
    const address = URL.createObjectURL(blob);
    link.href = address;
    link.download = name;
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), FORGOTTEN_AFTER);
  }

  // src/store/kept-line.js
  var KeptLine = class {
    #puts = 0;
    constructor(owner) {
      this.owner = owner;
      this.root = html("p", "carts-unsaved");
      this.root.setAttribute("role", "status");
    }
    async hear(put2) {
      this.#puts += 1;
      const turn = this.#puts;
      const kept = Boolean(await put2);
      if (turn !== this.#puts) return;
      say(this.root, kept ? "" : tr("Not saved"));
      this.owner.toggleAttribute("data-kept", kept);
    }
  };

  // ../view/numbers.js
  var SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  var NOISE = 1e-9;
  var MAX_DECIMALS = 12;
  var SLOW = 0.01;
  function exponent(value) {
    return value ? Number(Math.abs(value).toExponential(16).split("e")[1]) : 0;
  }
  function fixed(value, decimals) {
    const text = Math.abs(value).toFixed(decimals);
    return value < 0 && /[1-9]/.test(text) ? `−${text}` : text;
  }
  function decimalsFor(scale, figures = 3) {
    return Math.min(MAX_DECIMALS, Math.max(0, figures - 1 - exponent(scale)));
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
  function decimalsOf(value, figures = 6) {
    const text = Math.abs(value).toFixed(decimalsFor(value, figures));
    return trim(text).split(".")[1]?.length ?? 0;
  }
  function speedUnit(scale) {
    return scale <= SLOW ? [1e-3, "mm/s"] : [1, "m/s"];
  }
  function trim(text) {
    return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  }
  function px(value, decimals = 1) {
    const factor = 10 ** decimals;
    const rounded = Math.floor(value * factor + 0.5) / factor;
    return String(rounded === 0 ? 0 : rounded);
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
  function isWord(name) {
    return name.length > 2;
  }
  function thingAt(name, track, form2) {
    const thing = THINGS[whatIs(name, track)]?.()[form2];
    if (!thing || whatIs("left", track) !== whatIs("right", track)) return thing ?? "";
    return name === "left" ? tr("{thing} on the left", { thing }) : tr("{thing} on the right", { thing });
  }
  function listed(names) {
    const [first = "", second] = names;
    if (second === void 0) return first;
    const rest = inRow(names.slice(0, -1));
    return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
  }
  function onBy(on, by, track) {
    return tr("on {on} by {by}", { on: body(on, track), by: body(by, track) });
  }

  // ../view/shapes.js
  var REFERENCE_HEIGHT = 38;
  var TALLEST = 4;
  var LANE = 21;
  var ABOVE = 33;
  var DOT = 2.5;
  var RING = 1;
  var SHORTEST = 0.5;
  var LONGEST = 1.15;
  var FASTEST = 2.2;
  var EDGE = 5;
  var TORN = 6;
  var LINE = 14;
  var NAMED = 34;
  var LETTER = 9.5;
  var SPRING = [2, 10];
  var PUSH = 15.5;
  var FACE = 22;
  var WHEEL = 5.5;
  var LIFT = -3;
  var TURNS = 9;
  var LEAD = 5;
  var COIL = 7;
  function box(body2, view, layout, i, skin) {
    const lift = layout.stagger * (i % layout.ranks);
    const width = bodyWidth(body2);
    const wanted = REFERENCE_HEIGHT * (view.alike ? 1 : body2.mass / width / view.perHeight);
    const cut = wanted > TALLEST * REFERENCE_HEIGHT * (1 + 1e-9);
    const height = Math.min(wanted, TALLEST * REFERENCE_HEIGHT);
    const word = isWord(body2.name) ? body2.name.length * LETTER : 0;
    const named = height >= NAMED && (!word || !skin && word < width * layout.scale);
    const mass = `${short(body2.mass)} kg`;
    return {
      x: -width * layout.scale / 2,
      width: width * layout.scale,
      height,
      cut,
      nameY: named ? -(height + FACE) / 2 + 5 : null,
      label: named ? mass : `${body2.name}: ${mass}`,
      labelY: named ? -height - 5 - lift : -Math.max(height, FACE) - 5 - lift
    };
  }
  function wheels({ width }) {
    const x = px(Math.max(width / 3, width / 2 - 1.5 * WHEEL));
    return `M-${x} ${LIFT}h0M${x} ${LIFT}h0`;
  }
  function bodyWidth(body2) {
    return Math.max(body2.length - 2 * body2.bumper_length, 0.2 * body2.length);
  }
  function lane(i, tallest, layout) {
    const above = Math.max(tallest, FACE) + layout.stagger * (layout.ranks - 1) + ABOVE;
    return layout.track - above - LANE * (layout.lanes - 1 - i % layout.lanes);
  }
  function spring(start, end2) {
    const low = SPRING[0];
    const high = SPRING[1];
    const step = (end2 - start) / 4;
    let d = `M${px(start)} ${px(-(low + high) / 2)}`;
    for (let k = 0; k < 4; k += 1) {
      d += `L${px(start + (k + 0.5) * step)} ${px(k % 2 === 0 ? -high : -low)}`;
    }
    return `${d}L${px(end2)} ${px(-(low + high) / 2)}`;
  }
  function coil(start, end2, y, turns = TURNS, high = COIL) {
    const span = Math.max(0, end2 - start);
    const lead = Math.min(LEAD, span / 4);
    const step = (span - 2 * lead) / turns;
    let d = `M${px(start)} ${px(y)}L${px(start + lead)} ${px(y)}`;
    for (let k = 0; k < turns; k += 1) {
      d += `L${px(start + lead + (k + 0.5) * step)} ${px(k % 2 === 0 ? y - high : y + high)}`;
    }
    return `${d}L${px(start + span - lead)} ${px(y)}L${px(start + span)} ${px(y)}`;
  }
  function blockArrow(x, y, length) {
    if (Math.abs(length) < SHORTEST) return dot(x, y);
    const tip = x + length;
    const neck = tip - Math.sign(length) * Math.min(9, Math.abs(length));
    return `M${px(x)} ${px(y - 3)}L${px(neck)} ${px(y - 3)}L${px(neck)} ${px(y - 6.5)}L${px(tip)} ${px(y)}L${px(neck)} ${px(y + 6.5)}L${px(neck)} ${px(y + 3)}L${px(x)} ${px(y + 3)}Z`;
  }
  function cutArrow(x, y, length) {
    const half = length / 2 - Math.sign(length) * TORN / 2;
    const piece = `M${px(x)} ${px(y - 3)}h${px(half)}v6h${px(-half)}Z`;
    return piece + blockArrow(x + length - half, y, half);
  }
  function lineArrow(x, y, length) {
    if (Math.abs(length) < SHORTEST) return dot(x, y, RING);
    const tip = x + length;
    const back = tip - Math.sign(length) * Math.min(7, Math.abs(length));
    return `M${px(x)} ${px(y)}L${px(tip)} ${px(y)}M${px(back)} ${px(y - 4.5)}L${px(tip)} ${px(y)}L${px(back)} ${px(y + 4.5)}`;
  }
  function dot(x, y, radius = DOT) {
    const [r, d] = [px(radius), px(2 * radius)];
    return `M${px(x - radius)} ${px(y)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 -${d} 0Z`;
  }
  function arrowLength(value, full, length, longest = LONGEST) {
    const exact = full ? value / full * length : 0;
    return Math.max(-longest * length, Math.min(longest * length, exact));
  }
  function isCut(value, full, longest = LONGEST) {
    return full > 0 && Math.abs(value) > longest * full;
  }
  function velocityText(x, length, width) {
    const room = 72;
    if (length >= 0) return x > room ? [x - 8, "end"] : [x + length + 8, "start"];
    return x < width - room ? [x + 8, "start"] : [x + length - 8, "end"];
  }
  function keptInside(x, length, width) {
    if (x > EDGE && x < width - EDGE) {
      if (x + length > width - EDGE) return width - EDGE - x;
      if (x + length < EDGE) return EDGE - x;
    }
    return length;
  }
  function labelTop(box2) {
    return box2.labelY - LINE;
  }

  // src/predict/arrow-parts.js
  function greatest(run, pair) {
    const [left, right] = run.header.contacts.find((contact) => contact.pair === pair)?.bodies ?? [];
    const peak = run.header.events.find(
      (event) => event.kind === "peak" && event.bodies[0] === left && event.bodies[1] === right
    );
    if (typeof peak?.force === "number") return peak.force;
    return Math.max(0, ...Array.from(run.trajectory.F[pair] ?? []));
  }

  // src/worlds/ends.js
  function ends(columns, { decimals, velocity: velocity2 }) {
    const [per, unit] = speedUnit(velocity2);
    const real = columns[0].run;
    const table = html("table", "carts-worlds-ends");
    const head = html("tr");
    head.append(
      html("td"),
      ...columns.map(({ label }) => {
        const cell = html("th", "", label);
        cell.setAttribute("scope", "col");
        return cell;
      })
    );
    table.append(head);
    const rows = [
      ...real.header.bodies.map(({ name }) => ({
        label: tr("velocity of {name} at the end", { name }),
        of: (run) => `${fixed(last(run, name) / per, decimals.v ?? 2)} ${unit}`
      })),
      ...pushed(real).map(({ pair, on, by }) => ({
        label: tr("greatest push on {on} by {by}", { on, by }),
        of: (run) => `${fixed(greatestOn(run, pair, on), decimals.F ?? 1)} N`
      })),
      {
        label: tr("momentum of all carts, start → end"),
        of: (run) => {
          const [start, end2] = [momentum(run, 0), momentum(run, -1)];
          return `${fixed(start, decimals.p ?? 2)} → ${fixed(end2, decimals.p ?? 2)} N s`;
        }
      }
    ];
    for (const { label, of } of rows) {
      const row = html("tr");
      const title = html("th", "", label);
      title.setAttribute("scope", "row");
      row.append(title, ...columns.map(({ run }) => html("td", "", of(run))));
      table.append(row);
    }
    return table;
  }
  function pushed({ header }) {
    const names = new Set(header.bodies.map(({ name }) => name));
    return header.contacts.filter(({ bodies, stiffness }) => stiffness && bodies.every((name) => names.has(name))).flatMap(({ pair, bodies: [a, b] }) => [
      { pair, on: a, by: b },
      { pair, on: b, by: a }
    ]);
  }
  function greatestOn(run, pair, on) {
    const own = run.trajectory.on?.[`${pair} ${on}`];
    return own ? Math.max(0, ...Array.from(own)) : greatest(run, pair);
  }
  function last({ trajectory }, name) {
    return Number(trajectory.v[name]?.[trajectory.t.length - 1]);
  }
  function momentum({ header, trajectory }, row) {
    const k = row === 0 ? 0 : trajectory.t.length - 1;
    return header.bodies.reduce(
      (sum, { name, mass }) => sum + mass * Number(trajectory.v[name]?.[k]),
      0
    );
  }

  // ../effects/drag/view.js
  var view_default = {
    name: tr("air resistance"),
    row: 4,
    side: () => "above",
    agent: () => tr("the air"),
    around: tr("air"),
    warms: () => tr("air"),
    phrase({ numbers: { linear, quadratic } }, { everyone, on, seen }) {
      const sizes = [
        linear ? tr("{size} N per {unit}", { size: short(linear), unit: "m/s" }) : "",
        quadratic ? tr("{size} N per {unit}", { size: short(quadratic), unit: "(m/s)²" }) : ""
      ].filter(Boolean);
      return [
        everyone ? tr("drag by the air") : tr("drag on {carts} by the air", { carts: on }),
        seen(listed(sizes) || "0 N")
      ];
    }
  };

  // ../effects/friction/view.js
  var TOOTH = 4;
  var view_default2 = {
    name: tr("friction"),
    row: 3,
    side: () => "below",
    agent: () => tr("the track"),
    around: tr("track"),
    earth: true,
    warms: () => tr("track"),
    phrase({ numbers: { coefficient = 0, static: held = coefficient } }, { everyone, on, seen }) {
      const size = `μ = ${short(coefficient)}`;
      const rest = tr("(at rest up to {coefficient})", { coefficient: short(held) });
      return [
        everyone ? tr("friction by the track") : tr("friction on {carts} by the track", { carts: on }),
        seen(held > coefficient ? `${size} ${rest}` : size)
      ];
    },
    pieces: rough
  };
  function rough({ carts }, { key, header: { bodies, track }, layout, face: face2, centre }) {
    const piece = { cls: "carts-rough", behind: true };
    if (carts.length < bodies.length) {
      return carts.map((name) => {
        const length = (bodies.find((body2) => body2.name === name)?.length ?? 0) * layout.scale;
        const d2 = teeth(centre(name) - length / 2, length, layout.track);
        return { ...piece, key: `${key} ${name}`, d: d2 };
      });
    }
    const start = track.left === "wall" ? face2("left", "right") : -layout.width;
    const end2 = track.right === "wall" ? face2("right", "left") : 2 * layout.width;
    const tooth = 2 * TOOTH;
    const first = Math.max(start, -tooth + (start % tooth + tooth) % tooth);
    const d = teeth(first, Math.min(end2, layout.width) - first, layout.track);
    return [{ ...piece, key, d }];
  }
  function teeth(x, length, y) {
    const count2 = Math.max(0, Math.floor(length / (2 * TOOTH)));
    return `M${px(x)} ${px(y)}${`l${px(TOOTH)} ${px(TOOTH)}l${px(TOOTH)} ${px(-TOOTH)}`.repeat(count2)}`;
  }

  // ../effects/incline/view.js
  var STEEPEST = 22;
  var ROW = 24;
  var LENGTH = { wide: 120, narrow: 90 };
  var view_default3 = {
    name: tr("a slope"),
    row: 1,
    agent: () => tr("the Earth"),
    earth: true,
    stored: tr("as height, above the lowest point"),
    slope: ({ numbers }) => numbers.angle ?? 0,
    forceName: (on, by) => tr("part of the weight of {on}, along the track: force on {on} by {by}", { on, by }),
    label: (told3) => tr("on {on} by {by} (slope): {size} N", told3),
    phrase: ({ numbers }, { everyone, on }) => [
      everyone ? tr("a slope") : tr("a slope on {carts}", { carts: on }),
      slopeText(numbers.angle ?? 0)
    ],
    pieces({ index, carts, numbers: { angle = 0 } }, { key, header, layout }) {
      const slope = Math.abs(Math.tan(angle));
      const longest = LENGTH[layout.kind] ?? 0;
      const length = slope ? Math.min(longest, STEEPEST / slope) : longest;
      const inclines = header.effects.filter(({ kind: kind2 }) => kind2 === "incline");
      const place3 = inclines.findIndex((one) => one.index === index);
      const [x, y, rise] = [12, layout.tilt + ROW * Math.max(0, place3), length * slope];
      const whose = carts.length < header.bodies.length ? `${listed(carts)}: ` : "";
      const [tall, flat] = angle > 0 ? [x, x + length] : [x + length, x];
      const d = `M${px(tall)} ${px(y)}V${px(y - rise)}L${px(flat)} ${px(y)}Z`;
      const words = {
        text: whose + tiltText(angle),
        x: px(x + length + 10),
        y: px(y),
        anchor: "start"
      };
      return [
        { key, cls: "carts-wedge", behind: true, d },
        { key: `${key} words`, cls: "carts-tilt", behind: true, ...words }
      ];
    }
  };
  function tiltText(angle) {
    if (!angle) return tr("the track is level: 0°");
    const words = tr("track tilted {slope}", { slope: slopeText(angle) });
    return angle > 0 ? `${words} →` : `← ${words}`;
  }
  function slopeText(angle) {
    const size = short(Math.abs(angle) * 180 / Math.PI);
    if (size === "0") return tr("0°: the track is level");
    return angle > 0 ? tr("{angle}° down to the right", { angle: size }) : tr("{angle}° down to the left", { angle: size });
  }

  // ../effects/magnets/view.js
  var POLE = 14;
  var POLES = [
    ["N", "carts-north"],
    ["S", "carts-south"]
    // only where there is room
  ];
  var view_default4 = {
    name: tr("magnets"),
    link: tr("magnets"),
    apart: true,
    stored: tr("between the magnets"),
    phrase: (_, { both: both2 }) => [tr("magnets on {bodies}, like poles facing", { bodies: both2 })],
    pieces({ between }, { key, layout, face: face2 }) {
      const [a, b] = between ?? ["", ""];
      return [
        ...poles(`${key} ${a}`, face2(a, "right"), -1, layout),
        ...poles(`${key} ${b}`, face2(b, "left"), 1, layout)
      ];
    }
  };
  function poles(key, x, direction, { kind: kind2, track }) {
    const top = track - 40;
    return POLES.slice(0, kind2 === "wide" ? 2 : 1).flatMap(([pole = "", cls = ""], k) => {
      const start = x + direction * k * POLE;
      const d = `M${px(start)} ${px(top)}h${px(direction * POLE)}v16h${px(-direction * POLE)}Z`;
      const letter = { text: pole, x: px(start + direction * POLE / 2), y: px(top + 13) };
      return [
        { key: `${key} ${pole}`, cls, d },
        { key: `${key} ${pole} letter`, cls: "carts-pole", anchor: "middle", ...letter }
      ];
    });
  }

  // ../effects/push/view.js
  var LET_GO = 1.5;
  var BACK = 0.2;
  var ROOM = 16;
  var MIDDLE = 29;
  var HAND = "M-46 -6L-31 -7C-26 -9 -22 -6 -17 -3.5L-3 -3.5C1 -3.5 1 3 -3 3L-15 3C-10 3 -10 7.5 -15 7.5C-11 7.5 -11 12 -16 12C-13 12 -13 16 -18 16C-26 17 -29 14 -32 9L-46 9M-15 3h-7M-15 7.5h-6M-16 12h-5M-29 0C-24 0 -21 -1 -19 3M-38 -9h-8v20h8Z";
  var view_default5 = {
    name: tr("pushes from outside"),
    row: 2,
    side: (force) => force < 0 ? "right" : "left",
    around: (_, agent2) => agent2,
    acts: ({ numbers: { from = 0, until = Infinity } }, t) => t >= from && t < until,
    seen: (effect, t) => begun(effect, t) && t < end(effect) + (isHand(effect) ? LET_GO : 0),
    phrase: (effect, { agent: agent2, seen }) => [
      tr("a push on {cart} by {agent}", { cart: String(effect.carts[0]), agent: agent2 }),
      seen(forceText(effect.numbers.force ?? 0)),
      times(effect)
    ],
    pieces(effect, { key, header, run, t, layout, centre }) {
      const { carts, numbers } = effect;
      const name = String(carts[0]);
      const y = layout.track;
      const direction = (numbers.force ?? 0) >= 0 ? 1 : -1;
      const body2 = header.bodies.find((one) => one.name === name);
      const side = centre(name) - direction * ((body2 ? bodyWidth(body2) * layout.scale : 0) / 2);
      if (isHand(effect)) {
        const past = t - end(effect);
        if (past >= 0 && goesOn(effect, header)) return [];
        const gone = past < 0 ? 0 : direction * ROOM * Math.min(1, past / BACK);
        const left = past < 0 ? side : side - (place(run, name, t) - place(run, name, end(effect))) * layout.scale;
        return [{ key, cls: "carts-hand carts-palm", d: hand(left - gone, y - MIDDLE, direction) }];
      }
      const x = side - 3 * direction;
      const d = `M${px(x)} ${px(y - 38)}v14M${px(x)} ${px(y - 31)}h${px(-direction * 26)}`;
      return [{ key, cls: "carts-hand", behind: true, d }];
    },
    marks({ carts, numbers: { from = 0, until: end2, force = 0 } }, agent2, until, told3) {
      const who = { cart: String(carts[0]), agent: agent2 };
      const begins = told3 ? tr("The push on {cart} by {agent} begins: {force}.", { ...who, force: forceText(force) }) : tr("The push on {cart} by {agent} begins.", who);
      const marks = from <= until ? [{ t: from, sentence: begins }] : [];
      if (end2 !== void 0 && from < end2 && end2 <= until) {
        marks.push({ t: end2, sentence: tr("The push on {cart} by {agent} ends.", who) });
      }
      return marks;
    }
  };
  var isHand = ({ by }) => !by || by === "hand";
  var begun = ({ numbers: { from = 0 } }, t) => t >= from;
  var end = ({ numbers: { until = Infinity } }) => until;
  function goesOn(effect, { effects }) {
    const on = (one) => one.active && one.kind === effect.kind && one.carts[0] === effect.carts[0] && isHand(one);
    return effects.some((one) => on(one) && one !== effect && (one.numbers.from ?? 0) >= end(effect));
  }
  function place({ trajectory: { t: times2, x, v } }, name, t) {
    return valueAt(times2, x[name] ?? [], v[name] ?? [], t);
  }
  function hand(x, y, direction) {
    let across = true;
    let absolute = true;
    return HAND.replace(/[MLCvhZ]|-?[\d.]+/g, (part) => {
      if (/[a-zA-Z]/.test(part)) {
        across = part !== "v";
        absolute = part === part.toUpperCase();
        return part;
      }
      const number = Number(part);
      const shown = across ? direction * number + (absolute ? x : 0) : number + (absolute ? y : 0);
      across = absolute ? !across : across;
      return ` ${px(shown)}`;
    });
  }
  function forceText(force) {
    const size = short(Math.abs(force));
    return force >= 0 ? tr("{size} N to the right", { size }) : tr("{size} N to the left", { size });
  }
  function times({ numbers: { from = 0, until } }) {
    if (until !== void 0) {
      return tr("from {from} s to {until} s", { from: short(from), until: short(until) });
    }
    return from ? tr("from {from} s", { from: short(from) }) : "";
  }

  // ../effects/release/view.js
  var HALF = 9;
  var TURNS2 = 7;
  var HIGH = 4;
  var ABOVE2 = 28;
  var view_default6 = {
    name: tr("a release between the carts"),
    leftOut: tr("springs that are let go"),
    link: tr("spring"),
    lasts: ({ numbers }) => numbers.stiffness !== void 0,
    // else an impulse: no force to be drawn
    stored: tr("in the squeezed spring"),
    acts: ({ numbers: { at: at2 = 0, stiffness } }, t) => t < at2 || stiffness !== void 0,
    phrase: ({ numbers: { energy = 0, at: at2 = 0, stiffness } }, { both: both2, seen }) => [
      stiffness === void 0 ? tr("an exploder between {bodies}", { bodies: both2 }) : tr("a squeezed spring between {bodies} that is let go", { bodies: both2 }),
      seen(`${short(energy)} J`),
      stiffness === void 0 ? "" : seen(`${short(stiffness)} N/m`),
      tr("at {time} s", { time: short(at2) })
    ],
    pieces(effect, { key, run, t, layout, face: face2 }) {
      const [a, b] = effect.between ?? ["", ""];
      const [begun2, ended] = pushes(effect, run);
      const low = layout.track - ABOVE2;
      const ends3 = [face2(a, "right"), face2(b, "left")].map(Number);
      if (t > ended) {
        const there = edge(run, a, ended) - edge(run, a, t);
        const start2 = Number(ends3[0]) + there * layout.scale - HALF;
        const long = (edge(run, b, ended, -1) - edge(run, a, ended)) * layout.scale;
        const lying = coil(start2, start2 + long + 2 * HALF, layout.track - HIGH, TURNS2, HIGH);
        return [{ key: `${key} lying`, cls: "carts-coil carts-spent", behind: true, d: lying }];
      }
      const middle = (Number(ends3[0]) + Number(ends3[1])) / 2;
      const [start = 0, end2 = 0] = t < begun2 ? [middle, middle] : ends3;
      const wire = coil(start - HALF, end2 + HALF, low, TURNS2, HIGH);
      const plates = t < begun2 ? `M${px(start - HALF - 1)} ${px(low + 7)}v-15h20v15` : `M${px(start - HALF - 1)} ${px(low + 7)}v-14M${px(end2 + HALF + 1)} ${px(low + 7)}v-14`;
      return [
        { key, cls: "carts-coil", d: wire },
        { key: `${key} latch`, cls: "carts-latch", d: plates }
      ];
    }
  };
  function pushes({ between, numbers: { at: at2 = 0 } }, { header, trajectory }) {
    const pair = between?.join("-");
    const mine = header.events.filter(({ bodies }) => bodies.join("-") === pair);
    const begun2 = mine.find(({ kind: kind2, t }) => kind2 === "release" && t === at2);
    if (!begun2 || trajectory.t.length < 2) return [Infinity, Infinity];
    const ended = mine.find(({ kind: kind2, t }) => kind2 === "separate" && t > begun2.t);
    return [begun2.t, ended?.t ?? Infinity];
  }
  function edge({ header, trajectory }, name, t, direction = 1) {
    const half = (header.bodies.find((body2) => body2.name === name)?.length ?? 0) / 2;
    return valueAt(trajectory.t, trajectory.x[name] ?? [], trajectory.v[name] ?? [], t) + direction * half;
  }

  // ../effects/spring/view.js
  var view_default7 = {
    name: tr("springs between the carts"),
    link: tr("spring"),
    stored: tr("in the spring"),
    warms: ({ numbers }) => (numbers.damping ?? 0) > 0 ? tr("spring") : "",
    phrase({ numbers: { stiffness = 0, length = 0, damping } }, { both: both2, seen }) {
      const natural = tr("natural length {length} m", { length: short(length) });
      return [
        tr("a spring between {bodies}", { bodies: both2 }),
        damping ? tr("damped") : "",
        seen(`${short(stiffness)} N/m, ${natural}`)
      ];
    },
    pieces({ numbers, between }, { key, layout, face: face2 }) {
      const [a, b] = between ?? ["", ""];
      const [start, end2] = [face2(a, "right"), face2(b, "left")];
      const length = (numbers.length ?? 0) * layout.scale;
      const middle = (start + end2) / 2;
      const low = a === "left" ? start : b === "right" ? end2 - length : middle - length / 2;
      const y = layout.track - PUSH - COIL - 5;
      const measure = `M${px(low)} ${px(y - 3)}v6M${px(low)} ${px(y)}h${px(length)}m0 -3v6`;
      return [
        { key, cls: "carts-coil", d: coil(start, end2, layout.track - PUSH) },
        { key: `${key} natural`, cls: "carts-natural", d: measure }
      ];
    }
  };

  // ../effects/views.js
  var VIEWS = {
    drag: view_default,
    friction: view_default2,
    incline: view_default3,
    magnets: view_default4,
    push: view_default5,
    release: view_default6,
    spring: view_default7
  };

  // ../view/effects.js
  var LAST = 100;
  function viewOf(kind2) {
    return { name: kind2, row: LAST, ...VIEWS[kind2] };
  }
  function nameOf({ kind: kind2, called }) {
    const name = VIEWS[kind2]?.name ?? (called && told(called));
    if (!name) throw new Error(`nobody describes an effect of the kind “${kind2}”`);
    return name;
  }
  function agent(effect) {
    const named = effect.by || effect.agent;
    return viewOf(effect.kind).agent?.(effect) ?? (named ? told(named) : nameOf(effect));
  }
  function actsAt(effect, t) {
    return effect.active && (viewOf(effect.kind).acts?.(effect, t) ?? true);
  }
  function kindsOnOne({ effects }) {
    const kinds = new Set(effects.filter(({ between }) => !between).map(({ kind: kind2 }) => kind2));
    return [...kinds].sort((a, b) => viewOf(a).row - viewOf(b).row || (a < b ? -1 : 1));
  }
  function isLink(effect) {
    const { link, lasts } = viewOf(effect.kind);
    return effect.between !== null && link !== null && (lasts?.(effect) ?? true);
  }
  function linkedPairs({ effects }) {
    return new Set(effects.filter(isLink).map(({ between }) => String(between?.join("-"))));
  }
  function pairsApart({ effects }) {
    return effects.flatMap(
      ({ kind: kind2, active, between }) => active && between && viewOf(kind2).apart ? [between] : []
    );
  }
  function linkOf({ effects }, pair) {
    const link = effects.find(
      (effect) => effect.active && isLink(effect) && effect.between?.join("-") === pair
    );
    return link ? viewOf(link.kind).link ?? viewOf(link.kind).name : "";
  }

  // ../view/markers.js
  function styleOf(index) {
    return `b${index % 8}`;
  }

  // ../view/markup.js
  var ESCAPED = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };
  var Markup = class {
    constructor(text) {
      this.text = text;
    }
    toString() {
      return this.text;
    }
  };
  function html2(strings, ...values) {
    let written2 = strings[0] ?? "";
    values.forEach((value, k) => {
      const quote = strings[k]?.endsWith("=") ? '"' : "";
      written2 += quote + asText(value) + quote + (strings[k + 1] ?? "");
    });
    return new Markup(written2);
  }
  function asText(value) {
    if (Array.isArray(value)) return value.map(asText).join("");
    if (value instanceof Markup) return value.text;
    if (value === false || value === null || value === void 0) return "";
    return String(value).replace(/[&<>"']/g, (sign) => ESCAPED[sign] ?? sign);
  }

  // ../view/scales.js
  var STEP_SLACK = 1e-9;
  function axisDecimals(axis) {
    return Math.max(0, -exponent(axis.step));
  }
  function ticks(axis) {
    const first = Math.ceil(axis.low / axis.step - STEP_SLACK);
    const last2 = Math.floor(axis.high / axis.step + STEP_SLACK);
    const found2 = [];
    for (let k = first; k <= last2; k += 1) found2.push(k * axis.step);
    return found2;
  }
  function niceAbove(value) {
    const power = Number(`1e${exponent(value)}`);
    for (const factor of [1, 2, 5]) {
      if (value <= factor * power * (1 + STEP_SLACK)) return factor * power;
    }
    return 10 * power;
  }

  // ../view/skins.js
  var NARROW = 24;
  var GAP = 5;
  var SADDLE = 6;
  var SKINS = {
    cart: { wheels: true, lift: 0, corner: 4, lines: () => "" },
    van: { wheels: true, lift: 0, corner: 7, lines: van },
    truck: { wheels: true, lift: 0, corner: 3, lines: truck },
    trailer: { wheels: true, lift: 0, corner: 1, lines: trailer },
    box: { wheels: false, lift: 0, corner: 1, lines: crate },
    puck: { wheels: false, lift: 0, corner: 12, lines: puck },
    glider: { wheels: false, lift: GAP, corner: 4, lines: glider }
  };
  function van(box2, front) {
    return lines(box2, front, [
      [
        [0.06, 0.9],
        [0.34, 0.9],
        [0.46, 0.68],
        [0.06, 0.68],
        [0.06, 0.9]
      ],
      [
        [-0.42, 0.9],
        [-0.08, 0.9],
        [-0.08, 0.68],
        [-0.42, 0.68],
        [-0.42, 0.9]
      ],
      [
        [0.4, 0.26],
        [0.5, 0.26]
      ]
    ]);
  }
  function truck(box2, front) {
    return lines(box2, front, [
      [
        [0.22, 0],
        [0.22, 1]
      ],
      [
        [0.28, 0.9],
        [0.42, 0.9],
        [0.46, 0.66],
        [0.28, 0.66],
        [0.28, 0.9]
      ],
      [
        [-0.5, 0.16],
        [0.22, 0.16]
      ]
    ]);
  }
  function trailer(box2, front) {
    return lines(box2, front, [
      [
        [-0.5, 0.2],
        [0.5, 0.2]
      ],
      ...[-0.4, -0.27, 0.27, 0.4].map(
        (x) => [
          [x, 0.2],
          [x, 1]
        ]
      )
    ]);
  }
  function crate(box2, front) {
    return lines(box2, front, [
      [
        [-0.4, 0.1],
        [0.4, 0.1],
        [0.4, 0.9],
        [-0.4, 0.9],
        [-0.4, 0.1]
      ],
      [
        [-0.4, 0.3],
        [-0.22, 0.1]
      ],
      [
        [0.4, 0.3],
        [0.22, 0.1]
      ],
      [
        [-0.4, 0.7],
        [-0.22, 0.9]
      ],
      [
        [0.4, 0.7],
        [0.22, 0.9]
      ]
    ]);
  }
  function puck(box2, front) {
    return lines(box2, front, [
      [
        [-0.48, 0.15],
        [0.48, 0.15]
      ],
      [
        [-0.48, 0.85],
        [0.48, 0.85]
      ]
    ]);
  }
  function glider(box2, front) {
    const top = Math.min(SADDLE / box2.height, 0.4);
    return lines(box2, front, [
      [
        [-0.5, top],
        [0.5, top]
      ],
      ...[-0.42, -0.28, 0.28, 0.42].map(
        (x) => [
          [x, 0],
          [x, top]
        ]
      )
    ]);
  }
  function lines({ width, height }, front, strokes) {
    if (width < NARROW) return "";
    const at2 = ([x, y]) => `${px(front * x * width)} ${px(-y * height)}`;
    return strokes.map((points) => `M${points.map(at2).join("L")}`).join("");
  }

  // ../view/skeleton/tools.js
  var STEPS = 500;
  var AT_FIRST = [0.25, 0.5];
  var HANDLE = 8;
  function tape(layout) {
    const at2 = (x) => px(layout.origin + x * layout.scale);
    const [from, to] = ends2(layout);
    const y = px(layout.tape);
    const numbers = layout.track + layout.beam;
    const line2 = `M0 ${px(layout.track - 36)}V${px(numbers + 8)}M0 ${px(numbers + 27)}V${y}`;
    const end2 = (key, x) => html2`<g class="carts-tape-end" data-end=${key} transform="translate(${at2(x)} 0)"><path d=${line2}/><circle class="carts-pull-room" cx="0" cy=${y} r="16"/><circle cx="0" cy=${y} r=${HANDLE}/></g>`;
    const middle = at2((from + to) / 2);
    return html2`<g class="carts-tape" data-origin=${px(layout.origin, 4)} data-scale=${px(layout.scale, 4)} data-y=${y}><path data-part="tape" d="M${at2(from)} ${y}H${at2(to)}"/>${end2("from", from)}${end2("to", to)}<text data-part="length" x=${middle} y=${px(layout.tape + 5)} text-anchor="middle">${fixed(to - from, decimalsOf(stepOf(layout)))} m</text></g>`;
  }
  function stepOf({ low, high }) {
    return niceAbove((high - low) / STEPS);
  }
  function ends2(layout) {
    const { low, high } = layout;
    const step = stepOf(layout);
    const [from, to] = AT_FIRST.map((part) => Math.round((low + part * (high - low)) / step) * step);
    return [from ?? low, to ?? high];
  }

  // ../view/skeleton/stage.js
  var LABEL_ROOM = { wide: 54, narrow: 46 };
  var BREAK = "M-14 -56l7 -6l7 6l7 -6l7 6M-14 -49l7 -6l7 6l7 -6l7 6";
  var MOST_NUMBERS = 150;
  var LETTER2 = 8;
  var BEYOND = 60;
  function stage(baked, layout) {
    const { fence, run } = baked;
    const { kind: kind2, width, height } = layout;
    const forces = fence.forces === "shown";
    const hatch = `${fence.id}-${kind2}-hatch`;
    const size = html2`viewBox="0 0 ${px(width)} ${px(height)}" width=${px(width)} height=${px(height)}`;
    return html2`<svg class="carts-stage carts-stage-${kind2}" data-kind=${kind2} ${size} aria-hidden="true">
<defs>
<pattern id=${hatch} width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path class="carts-hatch" d="M0 0V8"/></pattern>
</defs>
${ground(baked, layout, hatch)}
<g data-part="effects-behind"></g>
${run.header.bodies.map(velocity)}
${run.header.bodies.map((body2, i) => cart(body2.name, i, fence.skins[body2.name] ?? "cart"))}
${run.header.bodies.map(({ name }) => html2`<text class="carts-mass" data-body=${name}></text>`)}
<path class="carts-was"/>
<g data-part="effects-front"></g>
${forces && pushes2(baked)}
<g data-part="guess"></g>
${layout.tape > 0 && tape(layout)}
${legend(baked, layout)}
</svg>`;
  }
  function velocity({ name }, i) {
    return html2`<g class="carts-velocity carts-${styleOf(i)}" data-body=${name}><path data-part="leader" class="carts-leader"/><path data-part="arrow" class="carts-line-arrow"/><text data-part="text"></text></g>
`;
  }
  function cart(name, i, skin) {
    const { corner, wheels: wheels2 } = SKINS[skin];
    const face2 = (side) => html2`<rect data-part="face-${side}" class="carts-face" x="-1.5" y="-22" width="3" height="21" rx="1.5"/>`;
    return html2`<g class="carts-cart carts-${styleOf(i)}" data-body=${name}><path data-part="spring-left" class="carts-spring"/><path data-part="spring-right" class="carts-spring"/>${face2("left")}${face2("right")}<rect data-part="box" class="carts-box" rx=${corner}/>${skin !== "cart" && html2`<path data-part="skin" class="carts-skin"/>`}${wheels2 && html2`<path data-part="wheels" class="carts-wheels"/>`}<g data-part="break" class="carts-break"><path d=${BREAK}/></g><text data-part="name" class="carts-name"></text></g>
`;
  }
  function pushes2({ run: { header } }) {
    const linked = linkedPairs(header);
    const style = (name) => {
      const i = header.bodies.findIndex((body2) => body2.name === name);
      return i < 0 ? "wall" : styleOf(i);
    };
    return header.contacts.filter(({ stiffness, pair }) => stiffness || linked.has(pair)).flatMap(
      ({ pair, bodies }) => bodies.map(
        (on) => html2`<g class="carts-push carts-${style(on)}" data-pair=${pair} data-on=${on}><path data-part="arrow" class="carts-block-arrow"/><text data-part="text" visibility="hidden"></text></g>
`
      )
    );
  }
  function ground({ fence, run: { header } }, layout, hatch) {
    const travel = fence.camera * header.until;
    const [low, high] = [layout.low + Math.min(0, travel), layout.high + Math.max(0, travel)];
    const { left, right, length } = header.track;
    const at2 = (x) => layout.origin + x * layout.scale;
    const first = left === "wall" ? 0 : low;
    const last2 = right === "wall" ? Number(length) : high;
    const slider = fence.controls.find((control) => control.set === "track.length");
    const longest = slider ? slider.high * slider.per : last2;
    const start = left === "wall" ? at2(0) : at2(low) - BEYOND;
    const end2 = right === "wall" ? at2(last2) : at2(high) + BEYOND;
    const under = layout.track + layout.beam;
    let step = niceAbove((LABEL_ROOM[layout.kind] ?? 0) / layout.scale);
    while ((high - low) / step > MOST_NUMBERS) step = niceAbove(step * 1.5);
    const numbers = { low: first, high: Math.max(last2, longest), step };
    const parts = /[1-9]/.exec(short(step))?.[0] === "2" ? 4 : 5;
    const fine = ticks({ ...numbers, step: step / parts }).map((x) => `M${px(at2(x))} ${px(under)}v4`);
    const wall = (side) => html2`<g data-wall=${side}><path class="carts-wall"/><path fill="url(#${hatch})"/><path class="carts-wall-face"/></g>
`;
    return html2`<g data-part="ground">
${left === "wall" && wall("left")}${right === "wall" && wall("right")}<rect class="carts-beam" x=${px(start)} y=${px(layout.track)} width=${px(end2 - start)} height=${px(layout.beam)}/>
<path class="carts-rule" d="M${px(start)} ${px(layout.track)}H${px(end2)}"/>
<path class="carts-fine" d=${fine.join("")}/>
${ticks(numbers).map(
      (x) => html2`<path class="carts-fine" d="M${px(at2(x))} ${px(under)}v8"/><text class="carts-number" x=${px(at2(x))} y=${px(under + 22)}>${fixed(x, axisDecimals(numbers))}</text>
`
    )}</g>`;
  }
  function legend({ fence, view }, layout) {
    const y = layout.height - 10;
    const wide = layout.kind === "wide";
    const [per, unit] = speedUnit(view.velocity);
    const text = (x2, said) => html2`<text x=${px(x2)} y=${px(y + 5)}>${said}</text>`;
    const force = fence.forces === "shown" && view.force > 0;
    const asked2 = fence.predict?.kind === "arrows" ? "" : "carts-unasked";
    const word = tr("scale:");
    const start = layout.above ? 12 : 12 + roomOf(word) + 4;
    const next = start + layout.velocity + 6;
    const x = next + 68;
    const end2 = force ? x + layout.force + 6 : next;
    const axis = wide ? tr("x in m, + is to the right") : tr("x in m, + →");
    const moving = wide ? tr("position on the track in m") : tr("track in m");
    return html2`<g class="carts-legend">
<text x="12" y=${px(layout.above ? y - 9 : y + 5)}>${word}</text>
<path class="carts-line-arrow" d=${lineArrow(start, y, layout.velocity)}/>${text(next, `${short(view.velocity / per)} ${unit}`)}
${force && html2`<g class=${asked2}><path class="carts-block-arrow" d=${blockArrow(x, y, layout.force)}/>${text(end2, `${short(view.force)} N`)}</g>`}
${wide && html2`<text class="carts-torn" data-now="no" x=${px(end2 + 70)} y=${px(y + 5)}>${tr("torn: not to scale")}</text>`}
<text x=${px(layout.width - 12)} y=${px(y + 5)} text-anchor="end">${fence.camera ? moving : axis}</text>
</g>`;
  }
  function roomOf(word) {
    return [...word].reduce((sum, sign) => sum + (sign > "˿" ? 2 * LETTER2 : LETTER2), 0);
  }

  // ../view/windows.js
  function touches(events, until) {
    const open2 = /* @__PURE__ */ new Map();
    const peaks = /* @__PURE__ */ new Map();
    const anew = /* @__PURE__ */ new Map();
    const found2 = [];
    for (const event of events) {
      const { bodies, before, t: start } = event;
      const pair = bodies.join("-");
      const touch = { pair, bodies, start, end: start };
      if (event.kind === "contact" && !event.impulse) {
        const old = open2.get(pair);
        if (old) found2.push({ ...old.touch, end: start });
        if (old) anew.set(pair, start);
        open2.set(pair, { touch, before });
      } else if (event.kind === "release" && !event.impulse) {
        open2.set(`loose ${pair}`, { touch: { ...touch, loose: true }, before });
      } else if (event.kind === "peak") {
        peaks.set(pair, event.t);
      } else if (event.kind === "separate" && anew.get(pair) === start) {
        anew.delete(pair);
      } else if (event.kind === "separate" || event.kind === "stick") {
        const keys = [`loose ${pair}`, pair].filter((key2) => open2.has(key2));
        const key = keys.length < 2 || begunWith(before, open2.get(String(keys[0]))) ? keys[0] : pair;
        const over = key && open2.get(key);
        if (!over) continue;
        open2.delete(key);
        found2.push({ ...over.touch, end: event.t });
      }
    }
    for (const { touch } of open2.values()) {
      const peak = touch.loose ? until : peaks.get(touch.pair) ?? until;
      found2.push({ ...touch, end: peak > touch.start ? peak : until, lasts: true });
    }
    return found2.filter((touch) => touch.end > touch.start).sort((a, b) => a.start - b.start);
  }
  function begunWith(before, one) {
    return Object.entries(one?.before ?? {}).every(([name, v]) => before[name] === v);
  }
  var ROUNDED = 1 + 1e-9;
  var FELT = 0.1;
  function windowsOf({ header, trajectory }) {
    const found2 = touches(header.events, header.until);
    const { t, F } = trajectory;
    for (const event of header.events) {
      const pair = event.bodies.join("-");
      const column = F[pair];
      const within = found2.some(
        (touch) => touch.pair === pair && touch.start <= event.t && event.t <= touch.end
      );
      if (event.kind !== "peak" || within || !column || t.length < 2) continue;
      const felt = (k) => Number(column[k]) > FELT * (event.force ?? 0);
      let [first, last2] = [rowAt(t, event.t), rowAt(t, event.t)];
      while (first > 0 && felt(first)) first -= 1;
      while (last2 < t.length - 1 && felt(last2)) last2 += 1;
      const window = { start: Number(t[first]), end: Number(t[last2]) };
      found2.push({ pair, bodies: event.bodies, ...window, near: true });
    }
    for (const bodies of pairsApart(header)) {
      const pair = bodies.join("-");
      const end2 = letGo(t, F[pair] ?? []);
      const within = found2.some((touch) => touch.pair === pair && touch.start <= 0);
      if (end2 && !within) found2.push({ pair, bodies, start: 0, end: end2, near: true });
    }
    return found2.sort((a, b) => a.start - b.start);
  }
  function letGo(t, force) {
    const first = Number(force[0]);
    for (let row = 1; row < force.length; row += 1) {
      const now = Number(force[row]);
      if (now > first * ROUNDED) return 0;
      if (now < FELT * first) return Number(t[row]);
    }
    return 0;
  }

  // ../view/deformation/squeezes.js
  function squeezes(carts, centres, faces) {
    const left = carts.map(() => 0);
    const right = carts.map(() => 0);
    const dents = { left: 0, right: 0 };
    for (let gap = 0; gap <= carts.length; gap += 1) {
      const [a, b] = [carts[gap - 1], carts[gap]];
      const end2 = a ? Number(centres[gap - 1]) + a.half : faces.left;
      const start = b ? Number(centres[gap]) - b.half : faces.right;
      if (end2 === null || start === null) continue;
      const overlap = Math.max(0, end2 - start);
      const share = Math.min(a?.bumper ?? 0, b ? overlap / 2 : overlap);
      const rest = Math.min(b?.bumper ?? 0, overlap - share);
      if (b) left[gap] = rest;
      if (a) right[gap - 1] = Math.min(a.bumper, overlap - rest);
      if (!a) dents.left = overlap - rest;
      if (!b) dents.right = overlap - share;
    }
    return { left, right, dents };
  }

  // src/shared/follow.js
  function followPointer(down, moved) {
    if (down.button > 0) return false;
    const leaving2 = new AbortController();
    const { signal } = leaving2;
    const follow = (now) => {
      if (now.pointerId !== down.pointerId) return;
      if (now.buttons & 1) moved(now.clientX - down.clientX, now);
      else leaving2.abort();
    };
    addEventListener("pointermove", follow, { signal });
    addEventListener("pointerup", follow, { signal });
    addEventListener("pointercancel", follow, { signal });
    return true;
  }

  // src/predict/pull.js
  function pullable(stage2, slider, full, width) {
    const group = svg("g", {});
    group.addEventListener("pointerdown", (event) => {
      const down = event;
      if (slider.disabled) return;
      event.preventDefault();
      const start = slider.valueAsNumber || 0;
      const perPixel = width / stage2.getBoundingClientRect().width * Number(slider.max) / full;
      followPointer(down, (pixels) => {
        if (slider.disabled) return;
        const before = slider.value;
        slider.valueAsNumber = start + pixels * perPixel;
        if (slider.value !== before || slider.dataset.pulled === void 0) {
          slider.dataset.pulled = "";
          slider.dispatchEvent(new Event("input", { bubbles: true }));
        }
      });
    });
    return group;
  }

  // ../view/effects-forces.js
  var FEW = 3;
  function forcesAt({ header, trajectory }, t, always = false) {
    const found2 = [];
    for (const kind2 of kindsOnOne(header)) {
      const acting = header.effects.filter(
        (effect) => effect.kind === kind2 && (always ? effect.active : actsAt(effect, t))
      );
      for (const { name } of header.bodies) {
        const own = acting.filter((effect) => effect.carts.includes(name));
        const column = trajectory.E[`${kind2} ${name}`];
        if (!own.length || !column?.length) continue;
        const peak = greatest2(column);
        const on = own.some((effect) => actsAt(effect, t));
        const exact = on ? valueAt(trajectory.t, column, null, t) : 0;
        const value = Math.abs(exact) <= NOISE * peak ? 0 : exact;
        const size = value ? fixed(Math.abs(value), decimalsFor(peak || 1)) : "0";
        found2.push({ kind: kind2, on: name, by: listed([...new Set(own.map(agent))]), value, size });
      }
    }
    return found2;
  }
  function labels({ kind: kind2, on, by, size }) {
    const told3 = { on, by, size };
    const brief = { ...told3, by: by.replaceAll("the ", "") };
    return [
      viewOf(kind2).label?.(told3) ?? tr("on {on} by {by}: {size} N", told3),
      tr("on {on} by {by}: {size} N", brief),
      tr("by {by}: {size} N", brief)
      // whose force it is tells the line from the cart
    ];
  }
  var known = /* @__PURE__ */ new WeakMap();
  function greatest2(column) {
    const before = known.get(column);
    if (before !== void 0) return before;
    let most = 0;
    for (let k = 0; k < column.length; k += 1) most = Math.max(most, Math.abs(Number(column[k])));
    known.set(column, most);
    return most;
  }

  // ../view/effects-props.js
  function isSeen(effect, t) {
    const { seen } = viewOf(effect.kind);
    return seen ? effect.active && seen(effect, t) : actsAt(effect, t);
  }
  function props(run, layout, t, face2, centre) {
    const { header } = run;
    return header.effects.filter((effect) => isSeen(effect, t)).flatMap((effect) => {
      const key = `${effect.kind} ${effect.index}`;
      return viewOf(effect.kind).pieces?.(effect, { key, header, run, t, layout, face: face2, centre }) ?? [];
    });
  }

  // src/scene/effects.js
  var PER_CHARACTER = 8.4;
  var SLIVER = 1.5;
  var GAP2 = 8;
  var Effects = class {
    #run = null;
    #drawn = /* @__PURE__ */ new Map();
    constructor(root, layout, full, forces) {
      this.layout = layout;
      this.full = full;
      this.forces = forces;
      this.behind = need(root, '[data-part="effects-behind"]');
      this.front = need(root, '[data-part="effects-front"]');
      for (const group of [this.behind, this.front]) {
        for (const element of group.querySelectorAll("[data-key]")) {
          this.#drawn.set(
            element.getAttribute("data-key") ?? "",
            element
          );
        }
      }
    }
    show(run) {
      this.#run = run;
    }
    at(t, face2, centre) {
      const run = this.#run;
      if (!run?.header.effects.length) return;
      const pieces = props(run, this.layout, t, face2, centre);
      if (this.forces && isTold(run)) pieces.push(...arrows(run, this.layout, this.full, t, centre));
      const seen = new Set(pieces.map(({ key }) => key));
      for (const [key, element] of this.#drawn) {
        if (!seen.has(key)) {
          element.remove();
          this.#drawn.delete(key);
        }
      }
      for (const piece of pieces) this.#draw(piece);
    }
    #draw({ key, cls, behind, d, text, x, y, anchor }) {
      let element = this.#drawn.get(key);
      if (!element) {
        element = svg(d === void 0 ? "text" : "path", { "data-key": key, class: cls });
        const group = behind ? this.behind : this.front;
        if (cls.startsWith("carts-leader")) group.prepend(element);
        else group.append(element);
        this.#drawn.set(key, element);
      }
      if (d !== void 0) return put(element, "d", d);
      put(element, "x", x ?? "0");
      put(element, "y", y ?? "0");
      put(element, "text-anchor", anchor ?? "start");
      say(element, text ?? "");
    }
  };
  function arrows(run, layout, full, t, centre) {
    const styles = new Map(run.header.bodies.map(({ name }, i) => [name, `carts-${styleOf(i)}`]));
    const named = run.header.bodies.length <= FEW;
    const pieces = [];
    const lowest = /* @__PURE__ */ new Map();
    for (const force of forcesAt(run, t)) {
      const key = `${force.kind} ${force.on}`;
      const x = centre(force.on);
      const y = layout.slots[key] ?? layout.track;
      const exact = arrowLength(force.value, full, layout.force);
      const length = Math.abs(exact) < SLIVER ? 0 : exact;
      const cut = isCut(force.value, full);
      const style = styles.get(force.on);
      lowest.set(force.on, Math.max(y, lowest.get(force.on) ?? y));
      const d = (cut ? cutArrow : blockArrow)(x, y, length);
      pieces.push({ key: `arrow ${key}`, cls: `carts-block-arrow carts-acts ${style}`, d });
      const row = `row ${force.kind}`;
      if (named) {
        const told3 = labels(force).map((one) => one + (cut ? tr(", arrow cut") : ""));
        const text = told3.find((one) => fits(x, length, one, layout.width)) ?? String(told3.at(-1));
        const [at2, anchor] = beside(x, length, text.length * PER_CHARACTER, layout.width);
        const cls = `carts-acts-name ${style}`;
        pieces.push({ key: `name ${key}`, cls, text, x: px(at2), y: px(y + 5), anchor });
      } else if (!pieces.some((piece) => piece.key === row)) {
        const text = tr("by {by}", { by: force.by });
        pieces.push({ key: row, cls: "carts-acts-row", text, x: "6", y: px(y + 5), anchor: "start" });
      }
    }
    const leaders = [...lowest].map(([name, y]) => ({
      key: `leader ${name}`,
      cls: `carts-leader carts-acts ${styles.get(name)}`,
      d: `M${px(centre(name))} ${px(layout.track)}V${px(y)}`
    }));
    return [...leaders, ...pieces];
  }
  function fits(x, length, text, picture) {
    const needed = text.length * PER_CHARACTER + GAP2 + 4;
    return Math.min(x, x + length) >= needed || Math.max(x, x + length) <= picture - needed;
  }
  function beside(x, length, width, picture) {
    const left = Math.min(x, x + length) - GAP2;
    const right = Math.max(x, x + length) + GAP2;
    const toLeft = left - width >= 4;
    const toRight = right + width <= picture - 4;
    if (toLeft && (length >= 0 || !toRight)) return [left, "end"];
    if (toRight) return [right, "start"];
    return left > picture - right ? [4, "start"] : [picture - 4, "end"];
  }

  // src/scene/ground.js
  var TRACK = "track.length";
  var Ground = class {
    #lines = [];
    #numbers = [];
    constructor(root, layout, { fence, run: { header } }) {
      this.layout = layout;
      this.moves = header.track.right === "wall" && fence.controls.some((control) => control.set === TRACK);
      if (!this.moves) return;
      const ground2 = need(root, '[data-part="ground"]');
      this.beam = need(ground2, ".carts-beam");
      this.rule = need(ground2, ".carts-rule");
      this.#numbers = [...ground2.querySelectorAll(".carts-number")];
      this.#lines = Array.from(ground2.querySelectorAll(".carts-fine"), (drawn) => ({
        drawn,
        pieces: (drawn.getAttribute("d") ?? "").split(/(?=M)/).filter(Boolean).map((d) => ({ x: Number.parseFloat(d.slice(1)), d }))
      }));
    }
    show({ length }) {
      if (!this.beam || !this.rule) return;
      const end2 = this.layout.origin + Number(length) * this.layout.scale;
      const inside = (x) => x <= end2 + 1;
      const start = Number(this.beam.getAttribute("x"));
      put(this.beam, "width", px(end2 - start));
      put(this.rule, "d", `M${px(start)} ${px(this.layout.track)}H${px(end2)}`);
      for (const { drawn, pieces } of this.#lines) {
        const d = pieces.filter(({ x }) => inside(x)).map((piece) => piece.d);
        put(drawn, "d", d.join(""));
      }
      for (const number of this.#numbers) {
        const seen = inside(Number(number.getAttribute("x")));
        put(number, "visibility", seen ? "visible" : "hidden");
      }
    }
  };

  // src/scene/pushes.js
  var PER_CHARACTER2 = 9.1;
  var ROW2 = 21;
  var GAP3 = 12;
  var EDGE2 = 6;
  var Pushes = class {
    #pushes = [];
    #run = null;
    #windows = [];
    constructor(root, layout, view) {
      this.root = root;
      this.layout = layout;
      this.view = view;
    }
    show(run, windows) {
      this.#run = run;
      this.#windows = windows;
      this.#pushes = [];
      run.header.contacts.forEach((contact, k) => {
        const groups = contact.bodies.map(
          (name) => this.root.querySelector(`.carts-push[data-pair="${contact.pair}"][data-on="${name}"]`)
        );
        if (groups[0] && groups[1]) {
          const row = this.layout.rows[k] ?? 0;
          this.#pushes.push({
            pair: contact.pair,
            bodies: contact.bodies,
            row,
            groups: [groups[0], groups[1]]
          });
        }
      });
    }
    at(t, face2) {
      const run = this.#run;
      if (!run) return;
      const { layout, view } = this;
      const told3 = [];
      for (const push of this.#pushes) {
        const forces = forcesOn(run, push, t).map(
          (force) => Math.abs(force) < NOISE * view.force ? 0 : force
          // springs pull: below 0
        );
        const sizes = forces.map(Math.abs);
        const size = Math.max(...sizes);
        const y = layout.track - PUSH;
        const [left, right] = push.bodies;
        const ends3 = [face2(left, "right"), face2(right, "left")];
        push.groups.forEach((group, side) => {
          const way = side === 0 ? -1 : 1;
          const draw = isCut(Number(sizes[side]), view.force) ? cutArrow : blockArrow;
          const length = arrowLength(Number(forces[side]), view.force, layout.force);
          put(need(group, '[data-part="arrow"]'), "d", draw(Number(ends3[side]), y, way * length));
        });
        const touching = this.#windows.some(
          ({ pair, loose, near, start, end: end2, lasts }) => pair === push.pair && !(loose || near) && t >= start && (t <= end2 || Boolean(lasts && size > 0))
          // carts that never part go on pushing
        );
        const link = touching ? "" : linkOf(run.header, push.pair);
        if (touching || link && size > 0) {
          told3.push({ push, sizes, x: (Number(ends3[0]) + Number(ends3[1])) / 2, link });
        }
      }
      this.#names(told3);
    }
    #names(told3) {
      const [only] = told3;
      for (const { pair, groups } of this.#pushes) {
        const on = told3.some(({ push }) => push.pair === pair);
        for (const group of groups) {
          put(need(group, '[data-part="text"]'), "visibility", on ? "visible" : "hidden");
        }
      }
      if (told3.length === 1 && only && this.#inFull(only)) return;
      const taken = [];
      const [low, high] = this.#between();
      for (const { push, sizes, x } of told3) {
        const size = Math.max(...sizes);
        const [text, other] = push.groups.map((group) => need(group, '[data-part="text"]'));
        if (!text || !other) continue;
        const label = tr("{size} on each", { size: this.#value(size) });
        const half = label.length * PER_CHARACTER2 / 2;
        const at2 = Math.min(Math.max(x, low + half), high - half);
        const free = [...new Set(this.layout.rows)].find(
          (y) => taken.every(([row, from, to]) => row !== y || at2 + half < from || at2 - half > to)
        );
        put(other, "visibility", "hidden");
        if (free === void 0) put(text, "visibility", "hidden");
        else {
          taken.push([free, at2 - half, at2 + half]);
          write(text, label, at2, free, "middle");
        }
      }
    }
    #inFull(told3) {
      return this.#named(told3, told3.link && ` (${told3.link})`) || this.#named(told3, "");
    }
    #named({ push, sizes, x }, through) {
      const [first, second] = push.groups.map((group) => need(group, '[data-part="text"]'));
      const { track } = this.#run.header;
      const labels2 = push.bodies.map((on, side) => {
        const by = push.bodies[1 - side] ?? "";
        return `${onBy(on, by, track)}${through}: ${this.#value(Number(sizes[side]))}`;
      });
      const [left, right] = labels2.map((label) => label.length * PER_CHARACTER2);
      if (!first || !second || !left || !right) return false;
      const [low, high] = this.#between();
      if (high - low >= left + right + 2 * GAP3 && !push.bodies.some(isWall)) {
        const begin = Math.min(Math.max(x + GAP3, low + left + 2 * GAP3), high - right);
        const end2 = Math.max(low + left, Math.min(x - GAP3, begin - 2 * GAP3));
        write(first, labels2[0] ?? "", end2, push.row, "end");
        write(second, labels2[1] ?? "", begin, push.row, "start");
        return true;
      }
      const longest = Math.max(left, right);
      const taken = new Set(Object.values(this.layout.slots)).size;
      if (this.layout.beam < (2 + taken) * ROW2 || high - low < longest) return false;
      const top = Math.min(...this.layout.rows);
      const way = push.bodies[0] === "left" ? 0 : push.bodies[1] === "right" ? 1 : 0.5;
      const start = Math.min(Math.max(x - way * longest, low), high - longest);
      write(first, labels2[0] ?? "", start, top, "start");
      write(second, labels2[1] ?? "", start, top + ROW2, "start");
      return true;
    }
    #between() {
      const { origin, scale, width } = this.layout;
      const track = this.#run?.header.track;
      const end2 = origin + (track?.length ?? 0) * scale;
      return [
        track?.left === "wall" ? Math.max(EDGE2, origin + GAP3) : EDGE2,
        track?.right === "wall" ? Math.min(width - EDGE2, end2 - GAP3) : width - EDGE2
      ];
    }
    #value(size) {
      const cut = isCut(size, this.view.force) ? tr(", arrow cut") : "";
      return `${fixed(size, this.view.decimals.F ?? 2)} N${cut}`;
    }
  };
  function forcesOn({ trajectory }, { pair, bodies }, t) {
    const { t: times2, F, dF, on } = trajectory;
    const [left, right] = bodies.map((name) => on?.[`${pair} ${name}`]);
    if (left && right) return [valueAt(times2, left, null, t), valueAt(times2, right, null, t)];
    const [column, slopes] = [F[pair], dF[pair]];
    const force = column && slopes ? valueAt(times2, column, slopes, t) : 0;
    return [force, force];
  }
  function write(text, label, x, y, anchor) {
    put(text, "x", px(x));
    put(text, "y", px(y));
    put(text, "text-anchor", anchor);
    say(text, label);
  }

  // ../view/deformation/bubbles.js
  var APART = 13;
  var RADIUS = 3.5;
  var SMALL = 0.6;
  function bubbles(front, back, depth, [top, foot], size = 1) {
    const columns = Math.max(2, Math.round(depth / (APART * size)));
    const rows = Math.max(2, Math.floor((foot - top) / (APART * size)));
    let d = "";
    for (let row = 0; row < rows; row += 1) {
      const y = top + (row + 0.5) * (foot - top) / rows;
      const room = back - front(y);
      const squeezed = Math.min(1, Math.abs(room) / depth);
      for (let column = 0; column < columns; column += 1) {
        const x = front(y) + room * (column + (row % 2 ? 0.7 : 0.3)) / columns;
        d += bubble(x, y, size * RADIUS * ((row + column) % 3 ? 1 : SMALL), squeezed);
      }
    }
    return d;
  }
  function bubble(x, y, radius, squeezed) {
    const wide = px(radius * squeezed);
    const across = px(2 * radius * squeezed);
    const half = `a${wide} ${px(radius)} 0 1 0`;
    return `M${px(x - Number(wide))} ${px(y)}${half} ${across} 0${half} -${across} 0`;
  }

  // ../view/deformation/walls.js
  var LEAST = 64;
  var THICK = 2e3;
  var ROOM2 = 3;
  var SEEN = 1;
  function wallAt(side, length, layout, tallest) {
    const x = side === "left" ? 0 : Number(length);
    const edge2 = layout.origin + x * layout.scale;
    return { edge: edge2, way: side === "left" ? -1 : 1, top: layout.track - Math.max(tallest, LEAST) };
  }
  function wallPaths({ edge: edge2, way, top }, { track, beam }, dent, height) {
    const high = Math.max(top, track - height - ROOM2);
    const shoulder = Math.max(top, high - dent);
    const pressed2 = `V${px(shoulder)}L${px(edge2 + way * dent)} ${px(high)}V${px(track)}H${px(edge2)}`;
    const face2 = `M${px(edge2)} ${px(top)}${dent > 0 ? pressed2 : ""}V${px(track + beam)}`;
    const was = dent < SEEN ? "" : `M${px(edge2)} ${px(shoulder)}V${px(track)}`;
    return { body: `${face2}h${way * THICK}V${px(top)}Z`, face: face2, was };
  }

  // ../view/deformation/things.js
  var SHARE = 0.5;
  var LEAST2 = 30;
  var MOST = 60;
  var SHALLOW = 0.6;
  var SOLID = 8;
  var ARM = 12;
  var PLATE = 4;
  var PLANK = 8;
  var PITCH = 9;
  var HIGH2 = 13;
  var MADE = {
    foam(place3) {
      const { x, heights, back, depth } = place3;
      const [top, foot] = endsOf(heights);
      const above = `M${px(x(top))} ${px(top)}H${px(back)}`;
      const inside = bubbles(x, back, depth, [top, foot]);
      return { own: [...face(place3), [back, foot], [back, top]], lines: above + inside };
    },
    spring(place3) {
      const { x, heights, back, depth } = place3;
      const [top, foot] = endsOf(heights);
      const [from, to] = [x(top, PLATE), back].sort((a, b) => a - b);
      const turns = Math.round(depth / PITCH);
      const wire = coil(Number(from), Number(to), (top + foot) / 2, turns, HIGH2);
      const plate = slab(place3, PLATE);
      return { own: plate, lines: area(plate) + wire };
    },
    board(place3) {
      const plank = slab(place3, PLANK);
      return { own: plank, lines: area(plank) + line(face(place3, PLANK / 2)) };
    }
  };
  function depthOf(what, { edge: edge2, way }, { width }) {
    const beyond = way > 0 ? width - edge2 : edge2;
    const depth = Math.max(LEAST2, Math.min(MOST, SHARE * beyond));
    return what === "board" ? SHALLOW * depth : depth;
  }
  function thingPaths(what, wall, layout, dent, height) {
    const place3 = pressed(what, wall, layout, dent, height);
    const { own, lines: lines2 } = MADE[what](place3);
    const inner = mounting(what, wall, layout, place3.back);
    const far = wall.edge + wall.way * THICK;
    const behind = area([...inner, [far, wall.top], [far, layout.track + layout.beam]]);
    const [begin = 0] = place3.heights.slice(-3);
    return {
      body: behind + area(own),
      hatch: behind,
      face: line(face(place3)) + line(inner),
      was: dent < SEEN ? "" : `M${px(wall.edge)} ${px(begin)}V${px(layout.track)}`,
      lines: lines2
    };
  }
  function pressed(what, wall, layout, dent, height) {
    const { edge: edge2, way, top } = wall;
    const foot = layout.track;
    const depth = depthOf(what, wall, layout);
    const back = edge2 + way * Math.max(depth, dent + SOLID);
    const place3 = (heights, give) => ({
      x: (y, behind = 0) => edge2 + way * (give(y) + behind),
      heights,
      back,
      depth
    });
    if (what === "spring" || dent === 0) return place3([top, foot], () => dent);
    const high = Math.max(top, foot - height - ROOM2);
    const shoulder = Math.max(top, Math.min(high, what === "board" ? top + ARM : high - dent));
    const part = (y) => y < high ? (y - shoulder) / (high - shoulder) : 1;
    return place3([top, shoulder, high, foot], (y) => dent * Math.max(0, part(y)));
  }
  function mounting(what, { edge: edge2, way, top }, { track, beam }, back) {
    const held = edge2 + way * PLANK;
    const arm = what === "board" ? [
      [back, top + ARM],
      [held, top + ARM],
      [held, top]
    ] : [[back, top]];
    return [[edge2, track + beam], [edge2, track], [back, track], ...arm];
  }
  function endsOf(heights) {
    return [Math.min(...heights), Math.max(...heights)];
  }
  function face({ x, heights }, behind = 0) {
    return heights.map((y) => [x(y, behind), y]);
  }
  function slab(place3, thick) {
    return [...face(place3), ...face(place3, thick).reverse()];
  }
  function line(points) {
    return `M${points.map(([x, y]) => `${px(x)} ${px(y)}`).join("L")}`;
  }
  function area(points) {
    return `${line(points)}Z`;
  }

  // src/scene/walls.js
  var THING = '[data-part="thing"]';
  var Walls = class {
    #walls = [];
    constructor(root, layout, { run: { header }, view }) {
      this.layout = layout;
      this.tallest = view.tallest;
      this.was = need(root, ".carts-was");
      this.#walls = Array.from(root.querySelectorAll("[data-wall]"), (group) => {
        const side = group.getAttribute("data-wall") === "left" ? "left" : "right";
        const wall = wallAt(side, header.track.length, layout, view.tallest);
        return { side, what: "wall", wall, group };
      });
    }
    show(track) {
      for (const one of this.#walls) {
        one.what = whatIs(one.side, track);
        one.wall = wallAt(one.side, track.length, this.layout, this.tallest);
        const drawn = one.group.querySelector(THING);
        if (one.what === "wall") drawn?.remove();
        else if (!drawn) one.group.append(svg("path", { "data-part": "thing" }));
      }
    }
    faces(shift) {
      const at2 = (side) => {
        const found2 = this.#walls.find((one) => one.side === side);
        return found2 ? found2.wall.edge - shift : null;
      };
      return { left: at2("left"), right: at2("right") };
    }
    at(pressed2, shift) {
      const lines2 = this.#walls.map((one) => this.#draw(one, pressed2[one.side]));
      put(this.was, "d", lines2.join(""));
      put(this.was, "transform", `translate(${px(-shift)} 0)`);
    }
    #draw({ what, wall, group }, { dent, height }) {
      const { body: body2, hatch, face: face2, was, lines: lines2 } = what === "wall" ? { ...wallPaths(wall, this.layout, dent, height), hatch: null, lines: "" } : thingPaths(what, wall, this.layout, dent, height);
      put(need(group, ".carts-wall"), "d", body2);
      put(need(group, "[fill]"), "d", hatch ?? body2);
      put(need(group, ".carts-wall-face"), "d", face2);
      if (lines2) {
        const thing = need(group, THING);
        put(thing, "class", what === "spring" ? "carts-coil" : "carts-fine");
        put(thing, "d", lines2);
      }
      return was;
    }
  };

  // src/scene/stage.js
  var HANDLE2 = 9;
  var Stage = class {
    #run;
    #carts = [];
    #walls;
    #ground;
    #pushes;
    #effects;
    constructor(root, baked) {
      const layout = baked.view.layouts.find((one) => one.kind === root.dataset.kind);
      if (!layout) throw new Error(`no layout for ${root.dataset.kind}`);
      this.root = root;
      this.torn = false;
      this.layout = layout;
      this.view = baked.view;
      this.camera = baked.fence.camera;
      this.skins = baked.fence.skins;
      this.starts = baked.run.header.bodies.map(({ velocity: velocity2 }) => velocity2);
      this.#run = baked.run;
      this.#walls = new Walls(root, layout, baked);
      this.#ground = new Ground(root, layout, baked);
      this.#pushes = new Pushes(root, layout, baked.view);
      this.#effects = new Effects(root, layout, baked.view.force, baked.fence.forces === "shown");
    }
    show(run, windows) {
      this.#run = run;
      const { layout, view } = this;
      const boxes = run.header.bodies.map(
        (body2, i) => box(body2, view, layout, i, this.skins[body2.name])
      );
      this.torn = boxes.some((box2) => box2.cut);
      const tallest = Math.max(...boxes.map((box2) => box2.height));
      this.#carts = run.header.bodies.map((body2, i) => {
        const group = need(this.root, `.carts-cart[data-body="${body2.name}"]`);
        const box2 = boxes[i];
        drawBox(group, body2.name, box2);
        const skin = SKINS[this.skins[body2.name] ?? ""];
        const front = Number(this.starts[i]) < 0 ? -1 : 1;
        const lift = skin?.lift ?? 0;
        if (skin) put(need(group, '[data-part="skin"]'), "d", skin.lines(box2, front));
        return {
          half: body2.length * layout.scale / 2,
          edge: -box2.x,
          bumper: Math.max(0, body2.length * layout.scale / 2 + box2.x),
          height: box2.height + lift,
          lift,
          top: layout.track - lift + labelTop(box2),
          lane: lane(i, tallest, layout),
          group,
          mass: this.#mass(body2.name, box2, lift),
          velocity: need(this.root, `.carts-velocity[data-body="${body2.name}"]`)
        };
      });
      this.#walls.show(run.header.track);
      this.#ground.show(run.header.track);
      this.#pushes.show(run, windows);
      this.#effects.show(run);
    }
    at(t) {
      const { header, trajectory } = this.#run;
      const shift = this.camera * t;
      put(
        need(this.root, '[data-part="ground"]'),
        "transform",
        `translate(${px(-shift * this.layout.scale)} 0)`
      );
      const centres = header.bodies.map((body2) => {
        const x = valueAt(
          trajectory.t,
          trajectory.x[body2.name] ?? [],
          trajectory.v[body2.name] ?? [],
          t
        );
        return this.layout.origin + (x - shift) * this.layout.scale;
      });
      const walls = this.#walls.faces(shift * this.layout.scale);
      const { left, right, dents } = squeezes(this.#carts, centres, walls);
      this.#walls.at(
        {
          left: { dent: dents.left, height: this.#carts[0]?.height ?? 0 },
          right: { dent: dents.right, height: this.#carts.at(-1)?.height ?? 0 }
        },
        shift * this.layout.scale
      );
      this.#carts.forEach((cart2, i) => {
        const centre = Number(centres[i]);
        const faces = [
          -cart2.half + Number(left[i]),
          cart2.half - Number(right[i])
        ];
        const foot = this.layout.track - cart2.lift;
        put(cart2.group, "transform", `translate(${px(centre)} ${px(foot)})`);
        put(cart2.mass, "x", px(centre));
        put(need(cart2.group, '[data-part="spring-left"]'), "d", spring(-cart2.edge, faces[0]));
        put(need(cart2.group, '[data-part="spring-right"]'), "d", spring(cart2.edge, faces[1]));
        put(need(cart2.group, '[data-part="face-left"]'), "transform", `translate(${px(faces[0])} 0)`);
        put(
          need(cart2.group, '[data-part="face-right"]'),
          "transform",
          `translate(${px(faces[1])} 0)`
        );
        this.#velocity(cart2, header.bodies[i]?.name ?? "", centre, t);
      });
      const face2 = (name, side) => {
        const i = header.bodies.findIndex((body2) => body2.name === name);
        if (i < 0) {
          const wall = name === "left" ? 0 : header.track.length ?? 0;
          const dent = name === "left" ? -dents.left : dents.right;
          return this.layout.origin + (wall - shift) * this.layout.scale + dent;
        }
        const half = this.#carts[i]?.half ?? 0;
        const centre = Number(centres[i]);
        return side === "left" ? centre - half + Number(left[i]) : centre + half - Number(right[i]);
      };
      this.#pushes.at(t, face2);
      this.#effects.at(
        t,
        face2,
        (name) => Number(centres[header.bodies.findIndex((body2) => body2.name === name)])
      );
    }
    guess(guesses) {
      const { header } = this.#run;
      const group = need(this.root, '[data-part="guess"]');
      const full = this.view.force || 10;
      const parts = guesses.flatMap(({ pair, on, side, size, slider }) => {
        const i = header.bodies.findIndex((body3) => body3.name === on);
        const body2 = header.bodies[i];
        const half = (body2?.length ?? 0) / 2;
        const wall = on === "left" ? 0 : header.track.length ?? 0;
        const x = body2 ? body2.position + (side === "left" ? half : -half) : wall;
        const way = side === "left" ? -1 : 1;
        const length = way * arrowLength(size ?? 0, full, this.layout.force);
        const from = this.layout.origin + x * this.layout.scale;
        const y = this.layout.track - PUSH;
        const draw = isCut(size ?? 0, full) ? cutArrow : blockArrow;
        const style = `carts-${i < 0 ? "wall" : styleOf(i)}`;
        const arrow = svg("path", {
          class: `carts-guessed ${style}`,
          d: draw(from, y, length),
          "data-pair": pair,
          "data-on": on
        });
        const tip = from + length + way * HANDLE2;
        const handle = pullable(this.root, slider, way * this.layout.force, this.layout.width);
        handle.setAttribute("class", `carts-pull ${style}`);
        handle.append(
          svg("circle", { cx: px(tip), cy: px(y), r: 16, class: "carts-pull-room" }),
          svg("circle", { cx: px(tip), cy: px(y), r: 8 }),
          svg("path", {
            d: `M${px(tip - 2.5)} ${px(y - 2.5)}l-2.5 2.5l2.5 2.5M${px(tip + 2.5)} ${px(y - 2.5)}l2.5 2.5l-2.5 2.5`
          })
        );
        return size === null ? [handle] : [arrow, handle];
      });
      group.replaceChildren(...parts);
    }
    #mass(name, box2, lift) {
      const mass = need(this.root, `.carts-mass[data-body="${name}"]`);
      put(mass, "y", px(this.layout.track - lift + box2.labelY));
      say(mass, box2.label);
      return mass;
    }
    #velocity(cart2, name, x, t) {
      const { trajectory } = this.#run;
      const { layout, view } = this;
      const v = valueAt(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], t) - this.camera;
      const seen = Math.abs(v) < NOISE * view.velocity ? 0 : v;
      const exact = arrowLength(seen, view.velocity, layout.velocity, FASTEST);
      const length = keptInside(x, exact, layout.width);
      const [at2, anchor] = velocityText(x, length, layout.width);
      put(need(cart2.velocity, '[data-part="arrow"]'), "d", lineArrow(x, cart2.lane, length));
      put(
        need(cart2.velocity, '[data-part="leader"]'),
        "d",
        `M${px(x)} ${px(cart2.lane)}V${px(cart2.top)}`
      );
      const shortened = length !== exact || isCut(seen, view.velocity, FASTEST);
      const cut = shortened ? tr(", arrow cut") : "";
      const [per, unit] = speedUnit(view.velocity);
      const speed = `${fixed(seen / per, view.decimals.v ?? 2)} ${unit}${cut}`;
      const text = need(cart2.velocity, '[data-part="text"]');
      const outside = x < 0 || x > layout.width;
      put(text, "x", px(outside ? x < 0 ? 8 : layout.width - 8 : at2));
      put(text, "y", px(cart2.lane + 5));
      put(text, "text-anchor", outside ? x < 0 ? "start" : "end" : anchor);
      say(text, outside ? tr("{name} is outside: {speed}", { name, speed }) : speed);
    }
  };
  function drawBox(group, name, box2) {
    const rect = need(group, '[data-part="box"]');
    put(rect, "x", px(box2.x));
    put(rect, "y", px(-box2.height));
    put(rect, "width", px(box2.width));
    put(rect, "height", px(box2.height));
    const wheels2 = group.querySelector('[data-part="wheels"]');
    if (wheels2) put(wheels2, "d", wheels(box2));
    const cut = need(group, '[data-part="break"]');
    put(cut, "visibility", box2.cut ? "visible" : "hidden");
    const title = need(group, '[data-part="name"]');
    put(title, "y", px(box2.nameY ?? 0));
    put(title, "visibility", box2.nameY === null ? "hidden" : "visible");
    say(title, name);
  }

  // src/scene/time/slow.js
  var WATCH = 3;
  var BEFORE = 0.15;
  var AFTER = 0.25;
  var SLOWEST = 1e-12;
  var RATES = [0.5, 0.2, 0.1];
  function rateFor(duration) {
    const wanted = duration / WATCH;
    for (let power = 1; power > SLOWEST; power /= 10) {
      for (const rate of RATES) if (rate * power <= wanted) return rate * power;
    }
    return wanted;
  }
  function slowParts(touches2) {
    const parts = [];
    for (const { start, end: end2 } of touches2) {
      const duration = end2 - start;
      const rate = rateFor(duration);
      if (rate >= 1) continue;
      const part = { from: start - BEFORE * duration, to: end2 + AFTER * duration, rate };
      const last2 = parts.at(-1);
      if (last2 && part.from <= last2.to) {
        last2.to = Math.max(last2.to, part.to);
        last2.rate = Math.min(last2.rate, rate);
      } else parts.push(part);
    }
    return parts;
  }
  function slowAt(parts, t) {
    return parts.find((part) => t >= part.from && t < part.to);
  }
  function advance(t, seconds, speed, parts, until) {
    let now = t;
    let left = seconds;
    while (left > 0 && now < until) {
      const inside = slowAt(parts, now);
      const rate = inside ? Math.min(speed, inside.rate) : speed;
      const edge2 = inside ? inside.to : parts.find((part) => part.from > now)?.from ?? until;
      const next = Math.min(edge2, until);
      if (now + left * rate < next) return now + left * rate;
      left -= (next - now) / rate;
      now = next;
    }
    return Math.min(now, until);
  }

  // src/scene/time/player.js
  var SAME = 1e-12;
  var STEP = 0.04;
  var STILL = 1;
  var LONGEST_FRAME = 0.1;
  var Player = class {
    time = 0;
    own = 0;
    // s that the reader has watched since the start
    playing = false;
    speed = 1;
    slow = true;
    until = 1;
    seen = Infinity;
    ended = () => {
    };
    // what to do at the end of the run
    stepped = () => {
    };
    parts = [];
    halts = [];
    halting = false;
    stops = [];
    stills = matchMedia("(prefers-reduced-motion: reduce)").matches;
    #waited = 0;
    // s since the last still
    #frame = 0;
    #last = 0;
    constructor(changed) {
      this.changed = changed;
    }
    get #parts() {
      return this.slow ? this.parts : [];
    }
    get rate() {
      return Math.min(this.speed, slowAt(this.#parts, this.time)?.rate ?? this.speed);
    }
    get isSlow() {
      return this.rate < this.speed;
    }
    toggle() {
      if (this.playing) this.pause();
      else this.play();
    }
    play() {
      if (this.playing) return;
      if (this.time >= this.until) this.#move(0);
      if (this.time === 0) this.own = 0;
      this.playing = true;
      this.#last = 0;
      this.#waited = 0;
      this.changed(this.time, false);
      this.#frame = requestAnimationFrame((now) => this.#tick(now));
    }
    pause() {
      if (!this.playing) return;
      this.playing = false;
      cancelAnimationFrame(this.#frame);
      this.changed(this.time, false);
    }
    seek(t) {
      this.#move(Math.min(t, this.seen));
      if (t <= 0) this.own = 0;
      this.#tell(this.time, false);
    }
    show(t) {
      this.seen = Math.max(this.seen, t);
      this.seek(t);
    }
    step(way, count2 = 1) {
      this.pause();
      const start = this.time;
      for (let k = 0; k < count2; k += 1) {
        const before = this.time;
        const target = before + way * STEP * this.rate;
        const event = way > 0 ? this.stops.find((t) => t > before + SAME) : this.stops.findLast((t) => t < before - SAME);
        const passed = event !== void 0 && (way > 0 ? event < target : event > target);
        this.#move(passed ? event : target);
        this.#tell(before, way > 0);
      }
      this.stepped(start);
    }
    #tick(now) {
      if (!this.playing) return;
      const seconds = this.#last ? Math.min(LONGEST_FRAME, (now - this.#last) / 1e3) : 0;
      this.#last = now;
      const before = this.time;
      this.own += seconds;
      this.#waited += seconds;
      if (this.stills && this.#waited < STILL) {
        this.#frame = requestAnimationFrame((next2) => this.#tick(next2));
        return;
      }
      const shown = this.stills ? this.#waited : seconds;
      this.#waited = 0;
      let next = advance(before, shown, this.speed, this.#parts, this.until);
      if (this.stills) next = this.stops.find((t) => t > before + SAME && t < next) ?? next;
      const halt = this.halting ? this.halts.find((t) => t > before + SAME && t <= next) : void 0;
      this.#move(halt ?? next);
      if (halt !== void 0 || this.time >= this.until) this.playing = false;
      this.#tell(before, true);
      if (this.playing) this.#frame = requestAnimationFrame((next2) => this.#tick(next2));
    }
    #move(t) {
      this.time = Math.min(this.until, Math.max(0, t));
      this.seen = Math.max(this.seen, this.time);
    }
    #tell(before, playing) {
      this.changed(before, playing);
      if (this.time >= this.until) this.ended();
    }
  };

  // src/worlds/pictures.js
  var SIGN = 60;
  var Pictures = class {
    constructor(baked, shown) {
      this.root = html("div", "carts-worlds-pictures");
      this.decimals = baked.view.decimals.t ?? 2;
      this.player = new Player(() => this.#at());
      const all = shown.map(({ run }) => windowsOf(run));
      this.player.until = Math.max(...shown.map(({ run }) => run.header.until));
      this.player.parts = slowParts(all.flat().sort((a, b) => a.start - b.start));
      this.stages = [];
      for (const [k, one] of shown.entries()) this.#picture(baked, one, all[k] ?? []);
      this.root.append(this.#bar());
      this.#at();
    }
    leave() {
      this.player.pause();
    }
    #picture(baked, { run, caption, impossible = false }, windows) {
      const figure = html("figure", impossible ? "carts-impossible" : "");
      const own = { ...baked, run, fence: { ...baked.fence, id: `${baked.fence.id}-other` } };
      const template = document.createElement("template");
      template.innerHTML = baked.view.layouts.map((layout) => stage(own, layout)).join("");
      const label = html("figcaption", "", caption);
      if (impossible) label.prepend(html("b", "", tr("Impossible:")), " ");
      figure.append(label, template.content);
      for (const root of figure.querySelectorAll("svg")) {
        const made = new Stage(root, baked);
        made.show(run, windows);
        this.stages.push(made);
        if (!impossible) continue;
        const { width, track } = made.layout;
        const place3 = { x: width / 2, y: track - SIGN, "text-anchor": "middle" };
        const text = svg("text", { class: "carts-impossible-sign", ...place3 });
        text.textContent = tr("impossible");
        root.prepend(text);
      }
      this.root.append(figure);
    }
    #bar() {
      const bar = html("div", "carts-worlds-bar");
      this.play = html("button", "carts-button carts-play", "");
      this.play.setAttribute("type", "button");
      this.play.addEventListener("click", () => this.player.toggle());
      this.scrub = document.createElement("input");
      Object.assign(this.scrub, { type: "range", min: "0", max: String(this.player.until) });
      this.scrub.step = String(this.player.until / 1e3);
      this.scrub.setAttribute(
        "aria-label",
        this.stages.length > 2 ? tr("Time in both pictures") : tr("Time")
      );
      this.scrub.addEventListener("input", () => {
        this.player.pause();
        this.player.seek(Number(this.scrub?.value));
      });
      this.clock = html("span", "carts-worlds-clock");
      bar.append(this.play, this.scrub, this.clock);
      return bar;
    }
    #at() {
      const t = this.player.time;
      for (const one of this.stages) one.at(t);
      if (!this.scrub || !this.clock || !this.play) return;
      this.scrub.value = String(t);
      const words = tr("{time} s", { time: fixed(t, 2) });
      this.scrub.setAttribute("aria-valuetext", words);
      say(this.clock, words);
      this.play.classList.toggle("carts-is-playing", this.player.playing);
      say(this.play, this.player.playing ? tr("Pause") : tr("Play"));
    }
  };

  // src/law/along-with.js
  function alongWith(baked, { header }) {
    const mass = header.bodies.reduce((sum, body2) => sum + body2.mass, 0);
    const camera = header.bodies.reduce((sum, body2) => sum + body2.mass * body2.velocity, 0) / mass;
    return { ...baked, fence: { ...baked.fence, camera } };
  }

  // src/answers/parts.js
  function button(text, act, name = "") {
    const made = html("button", `carts-button ${name}`.trim(), text);
    made.type = "button";
    made.addEventListener("click", act);
    return made;
  }
  var count = 0;
  function askingButton(text, question, yes, act, name, not = tr("No")) {
    const row = html("p", `carts-answers-asking ${name}`);
    const first = button(text, () => ask(true));
    const asked2 = html("span");
    const words = html("span", "", question);
    count += 1;
    words.id = `${name}-${count}`;
    const no = button(not, () => ask(false), "carts-answers-no");
    const go = () => {
      ask(false);
      act();
    };
    const does = button(yes, go, "carts-answers-yes");
    for (const one of [does, no]) one.setAttribute("aria-describedby", words.id);
    asked2.append(words, " ", does, " ", no);
    asked2.hidden = true;
    row.append(first, asked2);
    function ask(on) {
      first.hidden = on;
      asked2.hidden = !on;
      (on ? no : first).focus();
    }
    return row;
  }

  // src/shared/working.js
  var still = (event) => event.repeat && event.preventDefault();
  function passOn(from, to) {
    if (document.activeElement !== from) return;
    to.addEventListener("keydown", still);
    to.focus();
  }

  // src/law/bar.js
  function lawBar(acts) {
    const button2 = (text, act, name = "") => {
      const made = html("button", `carts-button ${name}`, text);
      made.type = "button";
      made.addEventListener("click", act);
      return made;
    };
    const root = html("div", "carts-law-bar");
    const run = button2(tr("Run"), acts.run, "carts-law-act");
    const judge = button2(tr("Judge"), acts.judge, "carts-law-act");
    const end2 = button2(tr("Stop"), acts.stop);
    end2.disabled = true;
    const again = askingButton(
      tr("Begin again"),
      tr("Back to the law that you began with? Yours stays in “My answers”."),
      tr("Begin again"),
      acts.again,
      "carts-law-again"
    );
    root.append(run, judge, end2, button2(tr("Save as a file"), acts.save), again);
    let begun2 = run;
    const working = (on) => {
      if (on) begun2 = document.activeElement === judge ? judge : run;
      for (const one of on ? [end2] : [run, judge]) one.disabled = false;
      passOn(on ? begun2 : end2, on ? end2 : begun2);
      for (const one of on ? [run, judge] : [end2]) one.disabled = true;
    };
    return { root, end: end2, working };
  }

  // src/shared/enter.js
  var isEnter = ({ key, isComposing, keyCode }) => key === "Enter" && !isComposing && keyCode !== 229;

  // src/law/editor.js
  var STEP2 = "    ";
  var LONGEST2 = 2e4;
  var Editor = class {
    constructor(id, changed) {
      this.root = html("div", "carts-law-editor");
      const label = html("label", "carts-heading", tr("Your law, in Python"));
      label.setAttribute("for", `${id}-text`);
      this.box = document.createElement("textarea");
      Object.assign(this.box, { id: `${id}-text`, rows: 10, spellcheck: false, wrap: "off" });
      this.box.maxLength = LONGEST2;
      this.box.setAttribute("autocapitalize", "off");
      this.box.setAttribute("autocomplete", "off");
      this.box.setAttribute("aria-describedby", `${id}-gets`);
      this.box.addEventListener("input", () => changed(this.box.value));
      this.box.addEventListener("keydown", (event) => this.#key(event));
      const gets = html(
        "p",
        "carts-quiet",
        tr(
          "force is asked once for each of the two carts while they touch, and returns N: above 0 it pushes away from the other. It may ask for: {names}.",
          { names: ARGUMENTS.join(", ") }
        )
      );
      gets.id = `${id}-gets`;
      this.root.append(label, this.box, gets);
    }
    get text() {
      return this.box.value;
    }
    set text(text) {
      this.box.value = text;
      this.box.rows = Math.min(24, Math.max(8, text.split("\n").length + 1));
    }
    go(line2) {
      const lines2 = this.box.value.split("\n");
      const start = lines2.slice(0, line2 - 1).reduce((sum, one) => sum + one.length + 1, 0);
      this.box.focus();
      this.box.setSelectionRange(start, start + (lines2[line2 - 1] ?? "").length);
      this.box.scrollTop = (line2 - 2) * this.box.scrollHeight / lines2.length;
      this.box.scrollLeft = 0;
    }
    #key(event) {
      if (!isEnter(event) || event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return;
      const { value, selectionStart } = this.box;
      const line2 = value.slice(value.lastIndexOf("\n", selectionStart - 1) + 1, selectionStart);
      const indent = /^ */.exec(line2)?.[0] ?? "";
      const more = /:\s*(#.*)?$/.test(line2) ? STEP2 : "";
      event.preventDefault();
      if (document.execCommand("insertText", false, `
${indent}${more}`)) return;
      this.box.setRangeText(`
${indent}${more}`, selectionStart, this.box.selectionEnd, "end");
      this.box.dispatchEvent(new Event("input", { bubbles: true }));
    }
  };
  var ARGUMENTS = [
    "overlap",
    "rate",
    "mass_self",
    "mass_other",
    "reduced_mass",
    "velocity_self",
    "velocity_other",
    "time",
    "stiffness",
    "restitution",
    "name_self",
    "name_other",
    "side"
  ];

  // src/answers/entry.js
  var MOST_EARLIER = 500;
  function isEmpty(value) {
    if (typeof value === "string") return !value.trim();
    if (value === null || value === void 0) return true;
    return typeof value === "object" && Object.keys(value).length === 0;
  }
  function keepEarlier(old, value) {
    if (!old || typeof old !== "object" || typeof value !== "object" || value === null) return value;
    const opened2 = old.locked && old.locked !== value.locked;
    if (opened2 && sameAnswer(old, value)) return { ...together(old, value), locked: old.locked };
    const same = old.hash === value.hash && old.type === value.type;
    if (old.locked && !value.locked && same) {
      return withEarlier(old, old.earlier, value.earlier, alone(value));
    }
    const other = opened2 || old.hash && value.hash && old.hash !== value.hash;
    return withEarlier(value, old.earlier, value.earlier, other ? alone(old) : []);
  }
  function merged(a, b) {
    if (!a) return b;
    if (!b) return a;
    const [old, young] = String(a.last ?? "") <= String(b.last ?? "") ? [a, b] : [b, a];
    const first = [a.first, b.first].filter(Boolean).sort()[0] ?? null;
    if (sameAnswer(old, young)) return { ...together(old, young), first };
    const cleared = isEmpty(young.value) && !isEmpty(old.value);
    const [loser, winner] = cleared ? [young, old] : [old, young];
    return withEarlier({ ...winner, first }, old.earlier, young.earlier, alone(loser));
  }
  function setAside(entry) {
    return withEarlier(entry, entry.earlier, alone(entry));
  }
  function together(old, young) {
    const said = Object.entries(young).filter(([, part]) => (part ?? "") !== "");
    const both2 = { ...young, ...old, ...Object.fromEntries(said) };
    return withEarlier(both2, old.earlier, young.earlier);
  }
  function sameAnswer(a, b) {
    return a.hash === b.hash && JSON.stringify(a.value) === JSON.stringify(b.value);
  }
  function alone({ earlier: _, ...entry }) {
    return isEmpty(entry.value) ? [] : [entry];
  }
  function withEarlier(entry, ...lists) {
    const found2 = /* @__PURE__ */ new Map();
    for (const one of lists.flatMap((list) => list ?? [])) {
      const name = JSON.stringify([one.hash, one.value]);
      const before = found2.get(name);
      found2.set(name, before ? together(before, one) : one);
    }
    const all = [...found2.values()];
    all.sort((x, y) => String(x.last ?? "").localeCompare(String(y.last ?? "")));
    return all.length ? { ...entry, earlier: all.slice(-MOST_EARLIER) } : entry;
  }

  // src/answers/outline.js
  var found = null;
  function outline() {
    const text = found ? null : document.getElementById("carts-lesson")?.textContent;
    if (text) found = JSON.parse(text);
    return found;
  }
  function itemOf(entry) {
    const form2 = entry?.form ?? "worksheet";
    return outline()?.items.find((item) => item.id === entry?.id && item.form === form2) ?? null;
  }
  function placeOf(entry) {
    if (entry?.type === "challenge") return entry.id;
    return entry?.type === "found-force" ? entry.id.replace(/-forces$/, "") : "";
  }
  function isHere(entry) {
    const place3 = placeOf(entry);
    return Boolean(itemOf(entry) ?? (place3 && document.getElementById(place3)));
  }
  function isCurrent(entry) {
    const item = itemOf(entry);
    return !item || !entry.hash || entry.hash === item.hash;
  }
  function stamped(entry) {
    const page2 = outline();
    if (!page2 || !isHere(entry)) return entry;
    const { form: form2 = "worksheet", hash = "" } = itemOf(entry) ?? {};
    return { form: form2, lesson: page2.lesson, lessonHash: page2.hash, hash, ...entry };
  }

  // src/shared/code-word.js
  var STUDENT = "student";

  // src/shared/tab.js
  var TAB = () => sessionStorage;
  var BROWSER = () => localStorage;
  function recall(key, where = TAB) {
    try {
      return JSON.parse(where().getItem(key) ?? "null");
    } catch {
      return null;
    }
  }
  function retain(key, value, where = TAB) {
    try {
      where().setItem(key, JSON.stringify(value));
    } catch {
    }
  }

  // src/store/text-store.js
  var beginning = (site) => `carts:${site}:`;
  function textStore(site) {
    try {
      localStorage.setItem(`${beginning(site)}probe`, "1");
      localStorage.removeItem(`${beginning(site)}probe`);
    } catch {
      return null;
    }
    return keptAsText(site);
  }
  function keptAsText(site) {
    const before = beginning(site);
    const get = (key) => {
      try {
        return JSON.parse(localStorage.getItem(before + key) ?? "null");
      } catch {
        return null;
      }
    };
    return {
      kind: "kept",
      how: "text",
      get: async (key) => get(key),
      put: async (key, value) => localStorage.setItem(before + key, JSON.stringify(keepEarlier(get(key), value))),
      remove: async (key) => localStorage.removeItem(before + key),
      entries: async () => Object.keys(localStorage).filter((name) => name.startsWith(before)).map((name) => [name.slice(before.length), get(name.slice(before.length))])
    };
  }

  // src/store/brought-over.js
  var PATIENCE = 5e3;
  var marked = (site) => `carts-database:${site}`;
  async function takeTexts(store, site) {
    void remember(store, site);
    const texts = keptAsText(site);
    const found2 = await texts.entries().catch(() => []);
    if (found2.length === 0) return;
    const take = () => takeOver(store, texts).catch(() => {
    });
    const taken = Promise.resolve(navigator.locks?.request(`carts-texts:${site}`, take) ?? take());
    const late = new Promise((resolve) => setTimeout(resolve, PATIENCE));
    await Promise.race([taken.catch(take), late]);
  }
  async function remember(store, site) {
    const { code = "" } = await store.get(STUDENT).catch(() => null) ?? {};
    if (recall(marked(site), BROWSER)?.code !== code) retain(marked(site), { code }, BROWSER);
  }
  async function instead(texts, site) {
    const before = recall(marked(site), BROWSER);
    if (!before) return texts;
    if (before.code && !await texts.get(STUDENT)) {
      await texts.put(STUDENT, { code: before.code, last: "" }).catch(() => {
      });
    }
    return { ...texts, behind: true };
  }
  async function takeOver(store, texts) {
    for (const [key, text] of await texts.entries()) {
      if (text === null) continue;
      const value = both(await store.get(key), text);
      if (value === null) continue;
      await store.put(key, value);
      await texts.remove(key);
    }
  }
  function both(kept, text) {
    if (kept === void 0 || kept === null) return text;
    if ("type" in Object(kept) && "type" in Object(text)) return merged(kept, text);
    if (!("last" in Object(kept) && "last" in Object(text))) return null;
    return String(kept.last) > String(text.last) ? kept : text;
  }

  // src/store/newest-first.js
  var GONE = /* @__PURE__ */ Symbol("forgotten");
  function newestFirst(put2) {
    const flights = /* @__PURE__ */ new Map();
    function start(key, value, alone2) {
      const now = put2(key, value, alone2);
      flights.set(key, { now, next: null });
      const over = () => {
        if (flights.get(key)?.now === now && !flights.get(key)?.next) flights.delete(key);
      };
      now.then(over, over);
      return now;
    }
    return (key, value, alone2 = false) => {
      const flight = flights.get(key);
      if (!flight) return start(key, value, alone2);
      if (flight.next) {
        flight.next.value = value;
        flight.next.alone &&= alone2;
        flight.next.anew ||= value === GONE;
        return flight.next.written;
      }
      const next = { value, alone: alone2, anew: value === GONE, written: Promise.resolve() };
      const begin = () => start(key, next.value, next.alone || next.anew);
      next.written = flight.now.then(begin, begin);
      flight.next = next;
      return next.written;
    };
  }

  // src/store/indexed-store.js
  var SETTLED = "settled";
  var STORE = "answers";
  var PATIENCE2 = 2e4;
  var SETTLE_AFTER = 400;
  function open(name) {
    return new Promise((resolve, reject) => {
      const request = indexedDB.open(name, 1);
      request.onupgradeneeded = () => request.result.createObjectStore(STORE);
      request.onsuccess = () => {
        request.result.onversionchange = () => request.result.close();
        resolve(request.result);
      };
      request.onerror = () => reject(request.error);
      request.onblocked = () => reject(new Error("another page holds an older version"));
      setTimeout(() => reject(new Error("no answer")), PATIENCE2);
    });
  }
  async function reopening(name) {
    let base = await open(name);
    return async (mode, durability = "relaxed") => {
      try {
        return base.transaction(STORE, mode, { durability });
      } catch {
        base = await open(name);
        return base.transaction(STORE, mode, { durability });
      }
    };
  }
  async function indexed(name) {
    const begin = await reopening(name);
    const read = async (ask) => answered(ask((await begin("readonly")).objectStore(STORE)));
    const put2 = newestFirst(
      (key, value, alone2) => write2(begin, (answers) => {
        if (value === GONE) answers.delete(key);
        else if (alone2) {
          answers.put(value, key);
          answers.transaction.commit();
        } else {
          const request = answers.get(key);
          request.onsuccess = () => answers.put(keepEarlier(request.result, value), key);
        }
      })
    );
    return {
      kind: "kept",
      how: "indexed",
      get: (key) => read((answers) => answers.get(key)),
      put: put2,
      remove: (key) => put2(key, GONE),
      entries: async () => {
        const answers = (await begin("readonly")).objectStore(STORE);
        const [keys, values] = await Promise.all([
          answered(answers.getAllKeys()),
          answered(answers.getAll())
        ]);
        return keys.map((key, k) => [String(key), values[k]]);
      }
    };
  }
  function answered(request) {
    return new Promise((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
  }
  var settling;
  async function write2(begin, act) {
    await transaction(begin, act, "relaxed");
    clearTimeout(settling);
    settling = setTimeout(() => {
      const mark = (answers) => void answers.put(Date.now(), SETTLED);
      transaction(begin, mark, "strict").catch(() => {
      });
    }, SETTLE_AFTER);
  }
  async function transaction(begin, act, durability) {
    const work = await begin("readwrite", durability);
    return new Promise((resolve, reject) => {
      act(work.objectStore(STORE));
      work.oncomplete = () => resolve();
      work.onerror = () => reject(work.error);
      work.onabort = () => reject(work.error);
    });
  }

  // src/store/shelter.js
  function shelter(site) {
    const page2 = globalThis;
    const name = /* @__PURE__ */ Symbol.for(`carts-shelter:${site}`);
    page2[name] ??= /* @__PURE__ */ new Map();
    return page2[name];
  }
  function sheltered(store, site) {
    const refused = shelter(site);
    return {
      ...store,
      put: async (key, value, alone2) => {
        try {
          await store.put(key, value, alone2);
          refused.delete(key);
        } catch (error) {
          refused.set(key, keepEarlier(refused.get(key), value));
          throw error;
        }
      },
      remove: async (key) => {
        refused.delete(key);
        await store.remove(key);
      },
      entries: async () => [...new Map([...await store.entries(), ...refused])]
    };
  }
  function memory(site) {
    const kept = shelter(site);
    return {
      kind: "memory",
      how: "memory",
      get: async (key) => kept.get(key),
      put: async (key, value) => void kept.set(key, keepEarlier(kept.get(key), value)),
      remove: async (key) => void kept.delete(key),
      entries: async () => [...kept]
    };
  }

  // src/store/staying.js
  var asked = false;
  function letItStay() {
    const storage = navigator.storage;
    if (asked || !storage?.persist || location.protocol === "file:") return;
    if (CSS.supports("-moz-appearance", "none")) return;
    asked = true;
    storage.persist().catch(() => {
    });
  }

  // src/store/tabs.js
  function telling(store, site) {
    const channel = channelOf(`carts:${site}`);
    return {
      ...store,
      student: "",
      put: async (key, value, alone2) => {
        await store.put(key, value, alone2);
        channel?.postMessage({ key, gone: false });
      },
      remove: async (key) => {
        await store.remove(key);
        channel?.postMessage({ key, gone: true });
      },
      hear: (act, signal) => {
        channel?.addEventListener(
          "message",
          ({ data }) => act(String(data.key), data.gone),
          signal && { signal }
        );
      }
    };
  }
  function channelOf(name) {
    try {
      return new BroadcastChannel(name);
    } catch {
      return null;
    }
  }

  // src/store/storage.js
  var opened = /* @__PURE__ */ new Map();
  function openAll(site) {
    const found2 = opened.get(site) ?? openOnce(site);
    opened.set(site, found2);
    return found2;
  }
  async function openStore(site) {
    const all = await openAll(site);
    return forStudent(all, await readStudent(all));
  }
  async function readStudent(all) {
    const found2 = await all.get(STUDENT).catch(() => null);
    return typeof found2?.code === "string" ? found2.code : "";
  }
  function forStudent(all, code) {
    const before = code ? `@${code}/` : "";
    const mine = (key) => before ? key.startsWith(before) : !key.startsWith("@") && key !== STUDENT && key !== SETTLED;
    return {
      kind: all.kind,
      how: all.how,
      student: code,
      get: (key) => all.get(before + key),
      put: (key, value, alone2) => {
        letItStay();
        return all.put(before + key, stamped(value), alone2);
      },
      remove: (key) => all.remove(before + key),
      hear: (act, signal) => all.hear((key, gone) => mine(key) && act(key.slice(before.length), gone), signal),
      entries: async () => (await all.entries()).filter(([key]) => mine(key)).map(([key, value]) => [key.slice(before.length), value])
    };
  }
  async function openOnce(site) {
    try {
      const store = telling(sheltered(await indexed(`carts:${site}`), site), site);
      await takeTexts(store, site);
      return store;
    } catch {
      const texts = textStore(site);
      return telling(texts ? await instead(sheltered(texts, site), site) : memory(site), site);
    }
  }
  function place2() {
    const { cartsSite, cartsPage } = document.documentElement.dataset;
    const meta = (name) => document.querySelector(`meta[name="${name}"]`)?.getAttribute("content");
    const path = location.pathname.split("/").slice(-2).join("/");
    return {
      site: cartsSite ?? meta("carts-site") ?? "site",
      page: cartsPage ?? meta("carts-page") ?? path
    };
  }

  // src/store/kept.js
  var Kept = class {
    #key = "";
    #store;
    constructor(id) {
      const { site, page: page2 } = place2();
      this.#key = `${page2}#${id}`;
      this.#store = openStore(site);
    }
    async lasts() {
      return (await this.#store).kind === "kept";
    }
    async named() {
      return (await this.#store).student !== "";
    }
    async get() {
      const store = await this.#store;
      return await store.get(this.#key).catch(() => null) ?? null;
    }
    async put(entry) {
      await (await this.#store).put(this.#key, entry);
      document.dispatchEvent(new CustomEvent("carts-kept", { detail: this.#key }));
    }
    async forget() {
      await (await this.#store).remove(this.#key);
      document.dispatchEvent(new CustomEvent("carts-forgotten", { detail: this.#key }));
    }
    async hear(act, signal) {
      (await this.#store).hear(async (key, gone) => {
        if (key !== this.#key) return;
        const found2 = await this.get();
        if (found2 || gone) act(found2);
      }, signal);
    }
  };

  // src/law/keep.js
  function lawKeeper({ id, hash, ask }) {
    const kept = new Kept(id);
    let entry = { id, hash, type: "law", value: null, first: null, last: null, tries: 0 };
    const taken = (found2) => {
      if (found2?.type !== "law" || typeof found2.value !== "string") return null;
      if (isCurrent(found2)) entry = found2;
      return found2.value;
    };
    return {
      hear(act, signal) {
        const heard = (found2) => {
          const text = taken(found2);
          if (text !== null) act(text);
        };
        void kept.hear(heard, signal);
      },
      get: async () => taken(await kept.get()),
      setAside() {
        entry = setAside(entry);
      },
      async put(text, tried = false) {
        const now = (/* @__PURE__ */ new Date()).toISOString();
        const tries = (entry.tries ?? 0) + (tried ? 1 : 0);
        entry = { ...entry, hash, value: text, said: text, asked: ask.slice(0, 300), tries };
        entry = { ...entry, first: entry.first ?? now, last: now };
        try {
          await kept.put(entry);
          return await kept.lasts();
        } catch {
          return false;
        }
      }
    };
  }

  // src/runtime/line.js
  var PAUSES = [1e3, 2e3, 4e3];
  var AT_ONCE = 2;
  var isOnWeb = () => /^https?:$/.test(globalThis.location?.protocol ?? "");
  var isFetching = () => isOnWeb() && !globalThis.__cartsInside;
  async function areKept(addresses) {
    if (!globalThis.navigator?.serviceWorker?.controller) return false;
    const asked2 = addresses.map((one) => caches.match(one, { ignoreSearch: true }));
    return (await Promise.all(asked2).catch(() => [null])).every(Boolean);
  }
  async function persistently(ask, pauses = isOnWeb() ? PAUSES : []) {
    for (const pause of pauses) {
      try {
        return await ask();
      } catch {
        await new Promise((resolve) => setTimeout(resolve, pause));
      }
    }
    return ask();
  }
  var Line = class {
    constructor(atOnce = isFetching() ? AT_ONCE : Number.POSITIVE_INFINITY) {
      this.free = atOnce;
      this.waiting = [];
    }
    async take(task) {
      if (this.free > 0) this.free -= 1;
      else await new Promise((resolve) => this.waiting.push(() => resolve(void 0)));
      try {
        return await task();
      } finally {
        const next = this.waiting.shift();
        if (next) next();
        else this.free += 1;
      }
    }
  };

  // src/runtime/failure.js
  var MESSAGES = {
    "not-packed": tr("This page was built without Python. It shows only the runs that came with it."),
    "payload-missing": tr(
      "A file of this page is missing, so Python can't start. Copy the whole folder again."
    ),
    "payload-damaged": tr(
      "A file of this page is damaged, so Python can't start. Copy the whole folder again."
    ),
    "no-wasm": tr(
      "This browser has no WebAssembly, so Python can't start here. Try another browser."
    ),
    "wasm-refused": tr(
      "This browser, or the rules of this network, do not allow Python to start. Try another browser."
    ),
    "too-old": tr(
      "This browser is too old to run Python. Try Chrome or Edge 103, Firefox 113, Safari 16.4, or newer."
    ),
    "no-memory": tr(
      "This computer has too little memory free for Python. Close other programs and load the page again."
    ),
    "no-worker": tr("This browser has no workers, so Python can't start here. Try another browser."),
    "worker-refused": tr("This browser does not let the page start Python. Try another browser."),
    "worker-lost": tr("Python stopped. It may have run out of memory."),
    "snapshot-refused": tr("Python could not start the quick way."),
    "python-failed": tr(
      "Python could not start. Copy the whole folder again or try another browser."
    ),
    "request-failed": tr("This cannot be computed with these values."),
    stalled: tr("Python does not answer. Close other programs and load the page again."),
    stopped: tr("Python was stopped.")
  };
  var CAME_NOT = tr("The network was interrupted, or this site was renewed: load the page again.");
  var ON_WEB = {
    "payload-missing": CAME_NOT,
    "payload-damaged": CAME_NOT,
    "python-failed": tr("Python could not start. Load the page again, or try another browser.")
  };
  var told2 = (reason) => isOnWeb() && ON_WEB[reason] || MESSAGES[reason];
  var RuntimeFailure = class extends Error {
    constructor(reason, detail = "", file = "") {
      super(told2(reason) ?? told2("python-failed"));
      this.name = "RuntimeFailure";
      this.reason = reason;
      this.detail = detail;
      this.file = file;
    }
  };

  // src/runtime/leaving.js
  var STAYS = 3e3;
  var leaving = false;
  var waiting = [];
  function stay() {
    leaving = false;
    for (const go of waiting) go();
    waiting = [];
  }
  addEventListener("beforeunload", () => {
    leaving = true;
    setTimeout(stay, STAYS);
  });
  addEventListener("pagehide", () => {
    leaving = true;
  });
  addEventListener("pageshow", stay);
  if (navigator.userAgent.includes("Firefox/")) addEventListener("unload", () => {
  });
  var isLeaving = () => leaving;
  function staying() {
    return leaving ? new Promise((resolve) => waiting.push(resolve)) : Promise.resolve();
  }

  // src/runtime/watch.js
  var SECOND = 1e3;
  var SLOW_AFTER = 3;
  var PATIENCE3 = 8;
  var AT_WORK = 60;
  var LOST = 60;
  var HELD = 180;
  function watch(patience, late) {
    let [left, spent] = [patience, 0];
    const timer = setInterval(() => {
      left -= 1;
      spent += 1;
      if (left > 0) return;
      clearInterval(timer);
      late();
    }, SECOND);
    return {
      get spent() {
        return spent;
      },
      progress() {
        left = patience;
      },
      stop() {
        clearInterval(timer);
      }
    };
  }

  // src/runtime/payload.js
  var page = self;
  var indexes = /* @__PURE__ */ new Map();
  var runScript = (src, name) => persistently(() => runOnce(src, name));
  function runOnce(src, name) {
    return new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = src;
      script.async = true;
      const missing = () => reject(new RuntimeFailure("payload-missing", src, name));
      const settle = (then) => () => {
        held?.stop();
        script.remove();
        then();
      };
      const held = isOnWeb() ? watch(HELD, settle(missing)) : null;
      script.onload = settle(resolve);
      script.onerror = settle(() => {
        if (isLeaving()) staying().then(() => runOnce(src, name).then(resolve, reject));
        else missing();
      });
      document.head.append(script);
    });
  }
  function indexOf(base) {
    return new URL(`index.js${new URL(base).search}`, base).href;
  }
  function patiently(promise) {
    if (isOnWeb()) return promise;
    return new Promise((resolve, reject) => {
      const waiting2 = watch(PATIENCE3, () => reject(new RuntimeFailure("stalled", "index.js")));
      promise.then(resolve, reject).finally(waiting2.stop);
    });
  }
  function loadIndex(base) {
    const known2 = indexes.get(base);
    if (known2) return known2;
    const inside = Boolean(page.__cartsInside);
    const read = inside ? Promise.resolve() : patiently(runScript(indexOf(base), "index.js"));
    const loading = read.then(() => {
      const index = page.__cartsRuntime;
      if (!inside) delete page.__cartsRuntime;
      if (!index) throw new RuntimeFailure("payload-damaged", "index.js", "index.js");
      if (!index.files) throw new RuntimeFailure("not-packed", index.missing);
      return index;
    });
    loading.catch(() => indexes.delete(base));
    indexes.set(base, loading);
    return loading;
  }
  async function loadPart(base, name, number, part) {
    const address = new URL(part.src, base);
    try {
      return await checkedPart(address.href, name, number, part);
    } catch (error) {
      const damaged = error instanceof RuntimeFailure && error.reason === "payload-damaged";
      if (!damaged || !isFetching()) throw error;
      address.searchParams.set("again", "1");
      return checkedPart(address.href, name, number, part);
    }
  }
  async function checkedPart(address, name, number, part) {
    const inside = Boolean(page.__cartsInside);
    if (!inside) await runScript(address, name);
    const key = `${name}.${number}`;
    const text = page.__cartsParts?.[key];
    if (text === void 0) throw new RuntimeFailure("payload-damaged", part.src, name);
    if (!inside) delete page.__cartsParts[key];
    const bytes = decode(text, part.src, name);
    if (bytes.length !== part.size || !await matches(bytes, part.sha256)) {
      throw new RuntimeFailure("payload-damaged", part.src, name);
    }
    return bytes;
  }
  function decode(text, src, name) {
    try {
      const fast = Uint8Array;
      return fast.fromBase64 ? fast.fromBase64(text) : Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    } catch {
      throw new RuntimeFailure("payload-damaged", src, name);
    }
  }
  async function matches(bytes, sha256) {
    if (!globalThis.crypto?.subtle) return true;
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("") === sha256;
  }
  async function gunzip(parts) {
    const zip = new DecompressionStream("gzip");
    const writer = zip.writable.getWriter();
    const written2 = Promise.all([...parts.map((part) => writer.write(part)), writer.close()]);
    const [bytes] = await Promise.all([new Response(zip.readable).arrayBuffer(), written2]);
    return bytes;
  }

  // as-text:src/runtime/unpacker.js
  var unpacker_default = '"use strict";\n(() => {\n  // src/runtime/unpacker.js\n  var writers = /* @__PURE__ */ new Map();\n  function begin(name) {\n    const zip = new DecompressionStream("gzip");\n    const tell = (bytes) => self.postMessage({ name, bytes }, { transfer: [bytes] });\n    const damaged = (error) => self.postMessage({ name, error: String(error) });\n    new Response(zip.readable).arrayBuffer().then(tell, damaged);\n    return zip.writable.getWriter();\n  }\n  self.onmessage = ({ data: { name, bytes, last } }) => {\n    const writer = writers.get(name) ?? begin(name);\n    writers.set(name, writer);\n    writer.write(bytes).catch(() => {\n    });\n    if (last) writer.close().catch(() => {\n    });\n  };\n})();\n';

  // src/runtime/unpack.js
  function workerOf(texts) {
    const address = URL.createObjectURL(new Blob(texts, { type: "text/javascript" }));
    try {
      return { worker: new Worker(address), address };
    } catch (error) {
      throw new RuntimeFailure("worker-refused", String(error));
    }
  }
  var Unpacker = class {
    constructor(reject) {
      const { worker, address } = workerOf([unpacker_default]);
      this.worker = worker;
      this.address = address;
      this.waiting = /* @__PURE__ */ new Map();
      worker.onmessage = ({ data }) => {
        if (data.bytes) this.waiting.get(data.name)?.(data.bytes);
        else reject(new RuntimeFailure("payload-damaged", data.error, data.name));
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new RuntimeFailure("worker-refused", event.message));
      };
    }
    async unpack(name, parts) {
      const unpacked = new Promise((resolve) => this.waiting.set(name, resolve));
      for (const [number, part] of parts.entries()) {
        const bytes = await part;
        this.worker.postMessage({ name, bytes, last: number === parts.length - 1 }, [bytes.buffer]);
      }
      return unpacked;
    }
    stop() {
      this.worker.terminate();
      URL.revokeObjectURL(this.address);
    }
  };

  // src/runtime/memory.js
  var isOutOfMemory = (error) => error instanceof RangeError || /memory|allocat/i.test(String(error));

  // src/runtime/wasm.js
  var NOTHING = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]);
  function requireWasm() {
    if (typeof WebAssembly !== "object") throw new RuntimeFailure("no-wasm");
    try {
      new WebAssembly.Module(NOTHING);
    } catch (error) {
      const old = !("findLast" in Array.prototype);
      throw new RuntimeFailure(old ? "too-old" : "wasm-refused", String(error));
    }
  }
  function compileFailure(error) {
    const reason = isOutOfMemory(error) ? "no-memory" : "too-old";
    return new RuntimeFailure(reason, String(error), "pyodide.asm.wasm");
  }
  async function compile(parts) {
    const zip = new DecompressionStream("gzip");
    const headers = { "Content-Type": "application/wasm" };
    const compiled = WebAssembly.compileStreaming(new Response(zip.readable, { headers }));
    const written2 = write3(zip.writable.getWriter(), parts);
    const [module] = await Promise.all([compiled, written2]);
    return module;
  }
  async function write3(writer, parts) {
    for (const part of parts) await writer.write(await part);
    await writer.close();
  }

  // as-text:src/runtime/worker.js
  var worker_default = '"use strict";\n(() => {\n  // src/runtime/memory.js\n  var isOutOfMemory = (error) => error instanceof RangeError || /memory|allocat/i.test(String(error));\n  var isNotAllocated = (error) => error instanceof RangeError && /memory|allocat/i.test(error.message);\n\n  // src/runtime/picture.js\n  function putPicture(memory, picture) {\n    const words = new Uint32Array(picture.buffer, picture.byteOffset, picture.byteLength >> 2);\n    const [size, filled, sum, count] = words;\n    if (memory.length !== size) throw new Error(`${memory.length} bytes of memory, not ${size}`);\n    const stretches = words.subarray(4, 4 + 2 * count);\n    if (sumBetween(memory, stretches, filled) !== sum) throw new Error("another machine code");\n    let from = 4 * (4 + 2 * count);\n    let last = filled;\n    for (let i = 0; i < stretches.length; i += 2) {\n      const [start, end] = stretches.subarray(i, i + 2);\n      if (start > last) memory.fill(0, last, start);\n      memory.set(picture.subarray(from, from + end - start), start);\n      from += end - start;\n      last = Math.max(last, end);\n    }\n  }\n  function sumBetween(memory, stretches, filled) {\n    const words = new Uint32Array(memory.buffer, memory.byteOffset, memory.byteLength >> 2);\n    let sum = 0;\n    let at = 0;\n    for (let i = 0; i <= stretches.length && at < filled; i += 2) {\n      const start = Math.min(stretches[i] ?? filled, filled);\n      for (let word = at >> 2; word < start >> 2; word += 1) sum = sum + words[word] >>> 0;\n      at = stretches[i + 1] ?? filled;\n    }\n    return sum;\n  }\n\n  // src/runtime/wheel.js\n  var END = 101010256;\n  var ENTRY = 33639248;\n  var END_BYTES = 22;\n  var ENTRY_BYTES = 46;\n  var LOCAL_BYTES = 30;\n  function entries(archive) {\n    const view = new DataView(archive.buffer, archive.byteOffset, archive.byteLength);\n    const end = archive.length - END_BYTES;\n    if (end < 0 || view.getUint32(end, true) !== END) return null;\n    const found = /* @__PURE__ */ new Map();\n    const text = new TextDecoder();\n    let at = view.getUint32(end + 16, true);\n    for (let left = view.getUint16(end + 10, true); left > 0; left -= 1) {\n      if (view.getUint32(at, true) !== ENTRY || view.getUint16(at + 10, true) !== 0) return null;\n      const [name, extra, comment] = [28, 30, 32].map((place) => view.getUint16(at + place, true));\n      const local = view.getUint32(at + 42, true);\n      const skipped = view.getUint16(local + 26, true) + view.getUint16(local + 28, true);\n      const from = local + LOCAL_BYTES + skipped;\n      const bytes = archive.subarray(from, from + view.getUint32(at + 24, true));\n      found.set(text.decode(archive.subarray(at + ENTRY_BYTES, at + ENTRY_BYTES + name)), bytes);\n      at += ENTRY_BYTES + name + extra + comment;\n    }\n    return found;\n  }\n  function unpackByOurselves(python2) {\n    const api = python2._api;\n    const usual = api.package_loader;\n    const unpack = (given) => {\n      const { buffer, extract_dir } = given;\n      const files2 = entries(buffer);\n      if (!files2) return usual.unpack_buffer.callKwargs(given);\n      const folder = String(extract_dir);\n      const made = /* @__PURE__ */ new Set();\n      for (const [name, bytes] of files2) {\n        const path = `${folder}/${name}`;\n        const parent = path.slice(0, path.lastIndexOf("/"));\n        if (!made.has(parent)) python2.FS.mkdirTree(parent);\n        made.add(parent);\n        python2.FS.writeFile(path, bytes, { canOwn: true });\n      }\n      return [...files2.keys()].filter((name) => name.endsWith(".so")).map((name) => `${folder}/${name}`);\n    };\n    api.package_loader = {\n      get_install_dir: (where) => usual.get_install_dir(where),\n      unpack_buffer: { callKwargs: unpack }\n    };\n  }\n\n  // src/runtime/worker.js\n  var scope = self;\n  var BASE = "https://runtime.invalid/";\n  var WASM = "pyodide.asm.wasm";\n  var STDLIB = "python.zip";\n  var SNAPSHOT = "memory.snapshot";\n  var MORE = "python-more.zip";\n  var stdlib;\n  var files = /* @__PURE__ */ new Map();\n  var python;\n  var answer;\n  var current = 0;\n  var seen = Number.NEGATIVE_INFINITY;\n  var tell = (message, transfer = []) => scope.postMessage(message, transfer);\n  var fail = (reason, error, name = "") => tell({ tell: "failed", reason, detail: String(error), file: name });\n  var progress = (stage) => tell({ tell: "progress", stage });\n  function file(name) {\n    const known = files.get(name);\n    if (known) return known;\n    let take = (_) => {\n    };\n    const come = new Promise((resolve) => {\n      take = resolve;\n    });\n    const made = { come, take };\n    files.set(name, made);\n    return made;\n  }\n  var bytesOf = (name) => file(name).come;\n  scope.fetch = async (address) => {\n    const name = String(address).split("/").pop() ?? "";\n    if (name === WASM) return new Response();\n    if (name === STDLIB) return stdlib;\n    return new Response(await bytesOf(name));\n  };\n  async function wholeStdlib(tableAt) {\n    if (!tableAt) return new Response(await bytesOf(STDLIB));\n    const [first, more] = await Promise.all([bytesOf(STDLIB), bytesOf(MORE)]);\n    const whole = new Uint8Array(tableAt + more.length);\n    whole.set(first.subarray(0, tableAt));\n    whole.set(more, tableAt);\n    return new Response(whole);\n  }\n  var giveWasm = () => {\n  };\n  var wasm = new Promise((resolve) => {\n    giveWasm = resolve;\n  });\n  function useCompiledWasm() {\n    const api = WebAssembly;\n    api.instantiateStreaming = async (_, imports) => {\n      const module = await wasm;\n      try {\n        return { module, instance: await WebAssembly.instantiate(module, imports) };\n      } catch (error) {\n        fail(isOutOfMemory(error) ? "no-memory" : "too-old", error);\n        throw error;\n      }\n    };\n  }\n  scope.addEventListener("unhandledrejection", ({ reason }) => {\n    if (isNotAllocated(reason)) fail("no-memory", reason);\n  });\n  async function boot({ lock, snapshot, tableAt, load, modules, entry }) {\n    try {\n      useCompiledWasm();\n      stdlib = wholeStdlib(tableAt);\n      const { loadPyodide, createPyodideModule } = scope.__pyodide;\n      python = await loadPyodide({\n        indexURL: BASE,\n        packageBaseUrl: BASE,\n        stdLibURL: BASE + STDLIB,\n        lockFileContents: lock,\n        createPyodideModule,\n        _loadSnapshot: snapshot ? bytesOf(SNAPSHOT) : void 0,\n        _putPicture: putPicture,\n        args: [],\n        env: { HOME: "/home/pyodide" }\n      });\n      python._api.config._loadSnapshot = void 0;\n      progress("python");\n      if (snapshot) reseed();\n      tellOfImports();\n    } catch (error) {\n      if (isNotAllocated(error)) return fail("no-memory", error);\n      return fail(snapshot ? "snapshot-refused" : "python-failed", error);\n    }\n    try {\n      if (load.length) await loadPackages(load);\n      for (const name of modules) {\n        importIfPossible(name);\n        progress(name);\n      }\n      const module = python.pyimport(entry);\n      module.listen?.(alive);\n      answer = module.answer;\n    } catch (error) {\n      return fail("python-failed", error);\n    }\n    files.clear();\n    return tell({ tell: "ready", start: snapshot ? "snapshot" : "plain" });\n  }\n  function reseed() {\n    python.runPython(`\nimport sys\nif "random" in sys.modules:\n    sys.modules["random"].seed()\n`);\n  }\n  function alive() {\n    if (performance.now() - seen < 1e3) return;\n    seen = performance.now();\n    if (current) tell({ tell: "alive", number: current });\n    else progress("packages");\n  }\n  function tellOfImports() {\n    const locals = python.toPy({ alive });\n    python.runPython(\n      `\nimport sys\nclass Alive:\n    @staticmethod\n    def find_spec(name, path=None, target=None, alive=alive):\n        alive()\nsys.meta_path.insert(0, Alive)\n`,\n      { globals: locals }\n    );\n  }\n  async function loadPackages(names) {\n    unpackByOurselves(python);\n    const alive2 = setInterval(() => progress("packages"), 1e3);\n    try {\n      await python.loadPackage(names, { messageCallback: () => {\n      } });\n    } finally {\n      clearInterval(alive2);\n    }\n    progress("packages");\n  }\n  function importIfPossible(name) {\n    try {\n      python.pyimport(name).destroy();\n    } catch (error) {\n      if (\n        /** @type {any} */\n        error?.type !== "ModuleNotFoundError"\n      ) throw error;\n    }\n  }\n  function respond({ number, text }) {\n    tell({ tell: "begun", number });\n    current = number;\n    try {\n      const [header, numbers] = answer(text);\n      tell({ tell: "answer", number, header, numbers }, [numbers.buffer]);\n    } catch (error) {\n      tell({ tell: "broken", number, detail: String(error), dead: isDead() });\n    }\n  }\n  function isDead() {\n    try {\n      return python.runPython("1") !== 1;\n    } catch {\n      return true;\n    }\n  }\n  scope.onmessage = ({ data }) => {\n    if (data.do === "boot") boot(data);\n    else if (data.do === "file") file(data.name).take(new Uint8Array(data.bytes));\n    else if (data.do === "wasm") giveWasm(data.module);\n    else if (data.do === "request") respond(data);\n  };\n  tell({ tell: "hello" });\n})();\n';

  // src/runtime/start.js
  var SLOW2 = "slow";
  var SLOW_LINE = "slow-line";
  var SNAPSHOT = "memory.snapshot";
  var LOADER = "pyodide.js";
  var WASM = "pyodide.asm.wasm";
  var STDLIB = "python.zip";
  var MORE = "python-more.zip";
  async function slowStage(files, folder) {
    const kept = !isFetching() || await areKept(files.map((file) => new URL(file, folder)));
    return kept ? SLOW2 : SLOW_LINE;
  }
  var modules = /* @__PURE__ */ new Map();
  var Start = class {
    constructor({ folder, index, packages, onProgress, patience = LOST }, snapshot) {
      this.folder = folder;
      this.index = index;
      this.packages = packages;
      this.onProgress = onProgress;
      this.patience = patience;
      this.snapshot = snapshot;
      this.worker = null;
      this.unpacker = null;
      this.over = false;
      this.line = new Line();
      this.done = 0;
      this.names = this.files();
      this.total = this.names.flatMap((name) => index.files[name].parts).reduce((sum, part) => sum + part.size, 0);
    }
    files() {
      const { index, packages, snapshot } = this;
      const names = modules.has(this.folder) ? [LOADER] : [LOADER, WASM];
      if (snapshot) names.push(SNAPSHOT);
      names.push(STDLIB);
      if (packages.length && index.tableAt) names.push(MORE);
      names.push(...this.toLoad().map((name) => index.wheels[name]));
      if (names.every((name) => name in index.files)) return names;
      throw new RuntimeFailure("not-packed", index.missing || packages.join());
    }
    toLoad() {
      const { index, packages, snapshot } = this;
      if (!snapshot) return [index.package, ...packages];
      return packages.length && index.later.length ? [index.rest, ...packages] : packages;
    }
    async run() {
      let reject = () => {
      };
      const failed = new Promise((_, no) => {
        reject = no;
      });
      this.giveUp = () => reject(new RuntimeFailure("stalled"));
      this.guard();
      try {
        const unpacker = new Unpacker(reject);
        this.unpacker = unpacker;
        return await Promise.race([failed, this.boot(unpacker, reject)]);
      } catch (error) {
        this.worker?.terminate();
        throw error;
      } finally {
        this.over = true;
        this.slow?.stop();
        this.watch?.stop();
        this.unpacker?.stop();
      }
    }
    load(name, reject) {
      return this.index.files[name].parts.map(async (part, number) => {
        try {
          const bytes = await this.line.take(async () => {
            if (this.over) throw new RuntimeFailure("stopped");
            return loadPart(this.folder, name, number, part);
          });
          this.done += part.size;
          if (!this.over && this.done === this.total && isFetching()) this.guard();
          this.progress(name);
          return bytes;
        } catch (error) {
          reject(error);
          return new Promise(() => {
          });
        }
      });
    }
    guard() {
      this.slow?.stop();
      const loading = isFetching() && this.done < this.total;
      this.slow = watch(SLOW_AFTER, async () => {
        const parts = this.names.flatMap((name) => this.index.files[name].parts);
        const stage2 = loading ? await slowStage(
          parts.map((part) => part.src),
          this.folder
        ) : SLOW2;
        if (!this.over) this.onProgress({ fraction: this.fraction, stage: stage2 });
      });
      if (!loading) this.watch = watch(this.patience, () => this.giveUp?.());
    }
    progress(stage2) {
      if (this.over) return;
      this.slow?.progress();
      this.watch?.progress();
      this.onProgress({ fraction: this.fraction, stage: stage2 });
    }
    get fraction() {
      return 0.9 * this.done / this.total;
    }
    async boot(unpacker, reject) {
      const load = (name) => this.load(name, reject);
      const loading = load(LOADER);
      await Promise.all(loading);
      const compiling = this.module(this.names.includes(WASM) ? load(WASM) : []);
      compiling.catch((error) => reject(compileFailure(error)));
      const rest = this.names.filter((name) => name !== LOADER && name !== WASM);
      const files = rest.map((name) => ({ name, unpacked: unpacker.unpack(name, load(name)) }));
      const loader = await gunzip(await Promise.all(loading));
      if (this.over) return null;
      const { worker, address } = workerOf([loader, worker_default]);
      this.worker = worker;
      const ready = new Promise((resolve) => {
        worker.onmessage = ({ data }) => {
          if (data.tell === "hello") URL.revokeObjectURL(address);
          else if (data.tell === "ready") resolve(data);
          else if (data.tell === "failed") {
            reject(new RuntimeFailure(data.reason, data.detail, data.file));
          }
          this.progress(data.stage ?? data.tell);
        };
        worker.onerror = (event) => {
          event.preventDefault();
          reject(new RuntimeFailure("worker-refused", event.message));
        };
      });
      const { index, packages, snapshot } = this;
      worker.postMessage({
        do: "boot",
        lock: index.lock,
        entry: index.entry,
        snapshot,
        tableAt: packages.length ? index.tableAt : 0,
        load: this.toLoad(),
        modules: packages.length ? [...packages, ...index.later] : []
      });
      for (const { name, unpacked } of files) {
        unpacked.then((bytes) => worker.postMessage({ do: "file", name, bytes }, [bytes]));
      }
      worker.postMessage({ do: "wasm", module: await compiling });
      this.progress(WASM);
      const { start } = await ready;
      this.onProgress({ fraction: 1, stage: "ready" });
      return { worker, start };
    }
    async module(parts) {
      const module = modules.get(this.folder) ?? await compile(parts);
      modules.set(this.folder, module);
      return module;
    }
  };

  // src/runtime/runtime.js
  var PICK_UP = 3;
  var LONG = ["certify", "class", "cost", "hard", "law", "measured", "relevance", "teach"];
  async function startRuntime({ base, packages = [], patience, onProgress = () => {
  } }) {
    requireWasm();
    if (typeof Worker !== "function") throw new RuntimeFailure("no-worker");
    if (typeof DecompressionStream !== "function") throw new RuntimeFailure("too-old");
    const folder = new URL(base, document.baseURI).href;
    let read = false;
    const late = watch(SLOW_AFTER, async () => {
      const stage2 = await slowStage(["index.js"], folder);
      if (!read) onProgress({ fraction: 0, stage: stage2 });
    });
    const index = await loadIndex(folder).finally(late.stop);
    read = true;
    const options = { folder, index, packages: order(packages), onProgress, patience };
    const start = (snapshot) => new Start(options, snapshot).run();
    if (!(SNAPSHOT in index.files)) return new Runtime(await start(false));
    try {
      return new Runtime(await start(true));
    } catch (error) {
      if (!(error instanceof RuntimeFailure) || !snapshotIsToBlame(error)) throw error;
      console.warn(`Python starts the plain way: ${error.reason} ${error.detail}`);
      return new Runtime(await start(false));
    }
  }
  var snapshotIsToBlame = ({ reason, file }) => reason === "snapshot-refused" || file === SNAPSHOT;
  var order = (packages) => [
    ...new Set(packages.flatMap((name) => name === "scipy" ? ["numpy", "scipy"] : [name]))
  ];
  var Runtime = class {
    constructor({ worker, start }) {
      this.start = start;
      this.onlost = () => {
      };
      this.worker = worker;
      this.gone = "";
      this.number = 0;
      this.queue = [];
      worker.onmessage = ({ data }) => this.hear(data);
      worker.onerror = (event) => {
        event.preventDefault();
        this.lose("worker-lost", event.message);
      };
    }
    request(message) {
      if (this.gone) return Promise.reject(new RuntimeFailure(this.gone));
      return new Promise((resolve, reject) => {
        this.number += 1;
        const patience = LONG.includes(String(message.kind)) ? AT_WORK : PATIENCE3;
        const text = JSON.stringify(message);
        this.queue.push({ number: this.number, text, patience, resolve, reject });
        if (this.queue.length === 1) this.send();
      });
    }
    stop() {
      this.end("stopped", "");
    }
    send() {
      const next = this.queue[0];
      if (!next) return;
      this.watch = watch(PICK_UP, () => this.lose("worker-lost", "no sign of life"));
      this.worker.postMessage({ do: "request", number: next.number, text: next.text });
    }
    hear(data) {
      const current = this.queue[0];
      if (!current || data.number !== current.number) return;
      if (data.tell === "alive") return void this.watch?.progress();
      this.watch?.stop();
      if (data.tell === "begun") {
        const { patience } = current;
        this.watch = watch(patience - PICK_UP, () => this.lose("worker-lost", "no answer"));
        return;
      }
      this.queue.shift();
      if (data.tell === "answer") {
        current.resolve({ header: JSON.parse(data.header), numbers: data.numbers });
      } else {
        current.reject(new RuntimeFailure(data.dead ? "worker-lost" : "request-failed", data.detail));
        if (data.dead) this.lose("worker-lost", data.detail);
      }
      if (!this.gone) this.send();
    }
    lose(reason, detail) {
      if (this.end(reason, detail)) this.onlost(new RuntimeFailure(reason, detail));
    }
    end(reason, detail) {
      if (this.gone) return false;
      this.gone = reason;
      this.watch?.stop();
      this.worker.terminate();
      for (const { reject } of this.queue.splice(0)) reject(new RuntimeFailure(reason, detail));
      return true;
    }
  };

  // src/shared/waiting.js
  function refusal(problems) {
    const [first] = problems;
    if (!first) return new Error(tr("This value does not work."));
    const message = told(first.message);
    const text = first.hint ? `${message}: ${told(first.hint)}` : message;
    return Object.assign(new Error(text), { path: first.path, refused: true });
  }

  // src/law/own-python.js
  var PACKAGES = ["newtons-carts-law"];
  var LIMIT = 4;
  var STARTS = 2;
  var LONGEST3 = 20;
  var OwnPython = class {
    #runtime = null;
    #end = () => {
    };
    #limit = LIMIT;
    constructor(base) {
      this.base = base;
    }
    wake() {
      if (this.#runtime) return this.#runtime;
      const clock = watch(LONGEST3, () => {
      });
      const started = () => {
        clock.stop();
        this.#limit = Math.max(LIMIT, Math.min(STARTS * clock.spent, LONGEST3));
      };
      this.#runtime = startRuntime({ base: this.base, packages: PACKAGES });
      this.#runtime.then(started, started);
      return this.#runtime;
    }
    async ask(message) {
      const started = this.wake();
      const late = new Promise((_, reject) => {
        this.#end = reject;
      });
      late.catch(() => {
      });
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
        answer.catch(() => {
        });
        const { header, numbers } = await Promise.race([answer, late]);
        if (!header.ok) throw refusal(header.problems ?? []);
        return { header, numbers };
      } catch (error) {
        if (runtime.gone) this.#runtime = null;
        throw error;
      } finally {
        timer.stop();
      }
    }
    async judge(whose, tell) {
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
    stop() {
      const runtime = this.#runtime;
      this.#runtime = null;
      void runtime?.then(
        (one) => one.stop(),
        () => {
        }
      );
      this.#end(new Error(tr("Stopped.")));
    }
  };
  function lineOf({ path = [] }) {
    const [laws, , line2] = path;
    return laws === "laws" ? Number(line2) || 0 : 0;
  }

  // src/law/verdicts.js
  function verdicts(judged, show) {
    const root = html("div", "carts-law-verdicts");
    root.append(html("p", "carts-heading", tr("What the judge found")));
    root.append(html("p", "", told(judged.sentence)));
    const list = html("ul");
    for (const one of judged.verdicts) {
      const item = html("li", one.holds ? "carts-law-holds" : "carts-law-broken");
      item.dataset.check = one.check;
      const word = one.holds ? tr("no counterexample") : tr("broken");
      item.append(html("b", "", word), ` ${told(one.says)}`);
      if (!one.holds) item.append(...counterexample(one, show));
      list.append(item);
    }
    root.append(list);
    return root;
  }
  function counterexample(verdict, show) {
    const button2 = html("button", "carts-button", tr("Show this scene"));
    button2.setAttribute("type", "button");
    button2.setAttribute("aria-label", `${tr("Show this scene")}: ${told(verdict.says)}`);
    button2.addEventListener("click", () => show(verdict));
    const details = html("details");
    const text = html("pre", "", verdict.yaml ?? "");
    text.tabIndex = 0;
    details.append(html("summary", "", tr("As a scene file")), text);
    return [html("p", "", told(verdict.sentence)), button2, details];
  }

  // src/law/element.js
  var YOURS = tr("Your law");
  function lawElement(base) {
    return class CartsLaw extends HTMLElement {
      #facts = null;
      #baked = null;
      #pictures = null;
      #python = new OwnPython(base);
      #turn = 0;
      #drawn = "";
      // the law whose run is drawn; empty: it is no run of the reader's
      #bar = lawBar({
        run: () => this.#do(() => this.#run()),
        judge: () => this.#do(() => this.#judge()),
        stop: () => this.#python.stop(),
        save: () => this.#save(),
        again: () => this.#again()
      });
      complete = Promise.resolve();
      #leaving = new AbortController();
      // ends what the element hears of other tabs
      connectedCallback() {
        this.#leaving = new AbortController();
        if (!this.#facts) this.#begin();
        this.keeper?.hear((text) => this.#take(text), this.#leaving.signal);
      }
      #begin() {
        const facts = JSON.parse(need(this, ".carts-law-baked").textContent ?? "");
        this.#facts = facts;
        this.#baked = bakedOf(facts.baked);
        this.keeper = lawKeeper(facts);
        this.editor = new Editor(facts.id, (text) => this.#typed(text));
        this.editor.text = facts.start;
        this.note = html("p", "carts-law-note");
        this.note.setAttribute("role", "status");
        this.fault = html("p", "carts-law-fault");
        this.fault.setAttribute("role", "alert");
        this.unsaved = new KeptLine(this);
        this.shown = html("div", "carts-law-shown");
        this.found = html("div", "carts-law-found");
        const live = need(this, ".carts-law-live");
        const told3 = [this.fault, this.unsaved.root, this.note, this.shown, this.found];
        live.append(this.editor.root, this.#bar.root, ...told3);
        live.hidden = false;
        this.classList.add("carts-law-ready");
        this.#first();
        this.#open(false);
        this.complete = this.#restore();
      }
      disconnectedCallback() {
        this.#leaving.abort();
        this.#pictures?.leave();
        this.#python.stop();
      }
      async #restore() {
        this.#take(await this.keeper?.get() || String(this.#facts?.start));
        this.#open(true);
        this.dataset.state = "live";
      }
      #open(on) {
        if (this.editor) this.editor.box.readOnly = !on;
        for (const one of this.querySelectorAll(".carts-law-bar button"))
          one.toggleAttribute("disabled", !on || one === this.#bar.end);
      }
      #take(text) {
        if (this.editor) this.editor.text = text;
        if (this.found?.childElementCount) this.#changed();
        this.#paper();
      }
      #typed(text) {
        void this.#python.wake().catch(() => {
        });
        void this.#keep(text);
        if (this.found?.childElementCount) this.#changed();
        this.#paper();
      }
      #changed() {
        this.found?.replaceChildren();
        this.#say(tr("Your law has changed: judge it again."));
      }
      #keep(text, tried = false) {
        return this.unsaved?.hear(this.keeper?.put(text, tried));
      }
      #paper() {
        const text = this.editor?.text ?? "";
        say(need(this, ".carts-law-paper code"), text);
        if (!this.#drawn) return;
        const whose = text === this.#drawn ? YOURS : tr("Your law, before you changed it");
        for (const place3 of this.shown?.querySelectorAll("figcaption, th[scope=col]") ?? [])
          say(place3, whose);
      }
      #again() {
        if (!this.editor || !this.#facts || !this.#baked) return;
        if (this.editor.text !== this.#facts.start) this.keeper?.setAside();
        this.editor.text = this.#facts.start;
        this.found?.replaceChildren();
        this.#typed(this.editor.text);
        this.#tell("");
        this.#first();
        this.editor.box.focus();
      }
      #save() {
        if (this.editor && this.#facts) download(this.#facts.file, this.editor.text, "text/x-python");
      }
      #do(act) {
        this.#turn += 1;
        const turn = this.#turn;
        this.#tell("");
        this.#working(true);
        this.complete = act().catch((error) => {
          if (turn === this.#turn) this.#tell(error.message, lineOf(error));
        }).finally(() => {
          if (turn === this.#turn) this.#working(false);
        });
      }
      async #run() {
        void this.#keep(this.editor?.text ?? "", true);
        this.#say(tr("Computing …"));
        const text = this.editor?.text;
        const unequal = await this.#draw(this.#scene());
        if (this.editor?.text !== text) return this.#changed();
        if (unequal) this.#say(tr("The two carts do not push each other equally hard."));
        else this.#say(tr("Done: the new run is below."));
      }
      async #draw(scene) {
        const { header, numbers } = await this.#python.ask({ do: "run", scene });
        const run = { header, trajectory: fromWire(header, numbers) };
        this.#show(run, this.#baked, YOURS);
        this.#drawn = scene.laws[this.#facts.file];
        this.#paper();
        return header.unequal;
      }
      async #judge() {
        void this.#keep(this.editor?.text ?? "", true);
        this.found?.replaceChildren();
        const [scene, { file }] = [this.#scene(), this.#facts];
        const judged = await this.#python.judge({ law: file, scene }, (text) => this.#say(text));
        const meanwhile = () => this.#scene().laws[file] !== scene.laws[file];
        if (meanwhile()) return this.#changed();
        this.found?.append(verdicts(judged, (one) => this.#do(() => this.#example(one))));
        if (this.#drawn !== scene.laws[file]) await this.#draw(scene);
        if (!meanwhile()) this.#say(tr("Judged: what was found is below."));
      }
      async #example(verdict) {
        const { header, numbers } = await this.#python.ask({ do: "run", scene: verdict.scene });
        const run = { header, trajectory: fromWire(header, numbers) };
        this.#show(run, alongWith(this.#baked, run), tr("A counterexample"));
        this.shown?.scrollIntoView({ block: "nearest" });
      }
      #scene() {
        const { file } = this.#facts;
        const scene = this.#baked.fence.scene;
        return { ...scene, laws: { ...scene.laws, [file]: this.editor?.text || "\n" } };
      }
      #show(run, baked, caption) {
        this.#picture(run, baked, caption);
        this.shown?.append(ends([{ label: caption, run }], baked.view));
      }
      #picture(run, baked, caption) {
        this.#pictures?.leave();
        this.#drawn = "";
        this.#pictures = new Pictures(baked, [{ run, caption }]);
        this.shown?.replaceChildren(this.#pictures.root);
      }
      #first() {
        const baked = this.#baked;
        this.#picture(baked.run, baked, tr("The law that you begin with"));
      }
      #tell(message, line2 = 0) {
        say(this.fault, message);
        if (message) this.#say("");
        if (line2) this.editor?.go(line2);
      }
      #say(text) {
        say(this.note, text);
      }
      #working(on) {
        this.#bar.working(on);
        this.toggleAttribute("data-working", on);
      }
    };
  }

  // src/runtime/page-python.js
  function besideScript(folder) {
    const script = document.currentScript;
    const own = new URL(script?.src || document.baseURI);
    return new URL(`${folder}${own.search}`, own).href;
  }

  // src/law-main.js
  customElements.define("carts-law", lawElement(besideScript("runtime/")));
})();
