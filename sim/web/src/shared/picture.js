/** Picture and graphs of a scene as one SVG that stands alone, and as PNG. */

import { svg } from "./dom.js";

const PROPERTIES = [
  "fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin",
  "opacity", "visibility", "font-family", "font-size", "font-weight", "font-style", "text-anchor",
  "paint-order", "x", "y", "height",
]; // biome-ignore format: a list
const WIDTH = 720;
const GAP = 12;
const LINE = 20;
const SIZE = 13; // of letters
const PIXELS = 2; // of the PNG per unit

/** @param {HTMLElement} scene @returns {string} the text of an SVG file */
export function picture(scene) {
  const paper = getComputedStyle(scene).getPropertyValue("--carts-paper") || "#fff";
  const ink = getComputedStyle(scene).color;
  const whole = svg("svg", { xmlns: "http://www.w3.org/2000/svg", width: WIDTH });
  const sheet = svg("rect", { width: WIDTH, fill: paper });
  whole.append(sheet);
  let y = GAP;
  /** @param {string} text @param {number} x @param {number} at @param {string} weight @param {number} width @returns {number} how many lines it takes */
  const write = (text, x, at, weight, width) => {
    const lines = broken(text, width, weight);
    lines.forEach((words, k) => {
      const line = svg("text", {
        x,
        y: at + LINE * k,
        fill: ink,
        "font-family": "sans-serif",
        "font-size": SIZE,
        "font-weight": weight,
      });
      line.textContent = words;
      whole.append(line);
    });
    return lines.length;
  };
  const title = scene.querySelector(".carts-title")?.textContent ?? "";
  y += LINE * write(title, GAP, y + 12, "700", WIDTH - 2 * GAP) + 4;
  const stage = [...scene.querySelectorAll(".carts-stage")].find((one) => one.clientWidth);
  if (stage) {
    const drawn = alone(stage);
    const height = place(drawn, 0, y, WIDTH);
    const sky = getComputedStyle(stage.closest(".carts-world") ?? stage).backgroundColor;
    whole.append(svg("rect", { y, width: WIDTH, height, fill: sky }), drawn);
    y += height + GAP;
  }
  const graphs = [...scene.querySelectorAll(".carts-graph")];
  const half = WIDTH / 2;
  for (let k = 0; k < graphs.length; k += 2) {
    let tallest = 0;
    graphs.slice(k, k + 2).forEach((graph, column) => {
      const plot = graph.querySelector(".carts-plot");
      if (!plot) return;
      const x = column * half;
      const name = graph.querySelector(".carts-graph-name")?.textContent ?? "";
      write(name, x + GAP, y + 12, "700", WIDTH);
      const drawn = alone(plot);
      const height = place(drawn, x, y + LINE, half - GAP);
      whole.append(drawn);
      const entries = [...graph.querySelectorAll(".carts-key > span")];
      let rows = 0;
      for (const entry of entries) {
        const at = y + LINE + height + 14 + LINE * rows;
        const sample = entry.querySelector("svg");
        if (sample) {
          const swatch = alone(sample);
          place(swatch, x + GAP, at - 10, 26);
          whole.append(swatch);
        }
        const indent = GAP + (sample ? 34 : 0);
        rows += write(entry.textContent ?? "", x + indent, at, "400", half - indent - GAP);
      }
      tallest = Math.max(tallest, LINE + height + LINE * rows);
    });
    y += tallest + GAP;
  }
  for (const part of [whole, sheet]) part.setAttribute("height", String(Math.ceil(y)));
  whole.setAttribute("viewBox", `0 0 ${WIDTH} ${Math.ceil(y)}`);
  return new XMLSerializer().serializeToString(whole);
}

/** A copy that carries its looks with it. @param {Element} original @returns {Element} */
function alone(original) {
  const copy = /** @type {Element} */ (original.cloneNode(true));
  const [from, to] = [
    [original, ...original.querySelectorAll("*")],
    [copy, ...copy.querySelectorAll("*")],
  ];
  from.forEach((part, i) => {
    const style = getComputedStyle(part);
    const made = /** @type {Element} */ (to[i]);
    if (style.display === "none" && part.closest("defs") === null)
      made.setAttribute("display", "none");
    for (const property of PROPERTIES) {
      const value = style.getPropertyValue(property);
      const geometry = ["x", "y", "height"].includes(property);
      if (geometry && (part.tagName !== "rect" || made.hasAttribute(property))) continue;
      if (value && value !== "auto") made.setAttribute(property, value.replaceAll('"', "'"));
    }
    made.removeAttribute("class");
  });
  return copy;
}

/** A text in lines of this width, broken between words, or between signs where there are no spaces. @param {string} text @param {number} width @param {string} weight @returns {string[]} */
function broken(text, width, weight) {
  const pen = document.createElement("canvas").getContext("2d");
  if (!pen) return [text];
  pen.font = `${weight} ${SIZE}px sans-serif`;
  const lines = [""];
  for (const part of text.trim().split(/(?<=\s)|(?<=[\u3000-\u9fff])/u)) {
    const longer = `${lines.at(-1)}${part}`;
    if (lines.at(-1) && pen.measureText(longer.trimEnd()).width > width) lines.push(part);
    else lines[lines.length - 1] = longer;
  }
  return lines.map((line) => line.trimEnd());
}

/** @param {Element} drawn @param {number} x @param {number} y @param {number} width @returns {number} its height */
function place(drawn, x, y, width) {
  const [, , w = 1, h = 1] = (drawn.getAttribute("viewBox") ?? "0 0 1 1").split(" ").map(Number);
  const height = (width * h) / w;
  for (const [name, value] of Object.entries({ x, y, width, height })) {
    drawn.setAttribute(name, String(value));
  }
  return height;
}

/** @param {string} text of an SVG file @returns {Promise<Blob>} */
export async function asPng(text) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = image.naturalWidth * PIXELS;
  canvas.height = image.naturalHeight * PIXELS;
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error("no picture was made"))),
      "image/png",
    );
  });
}
