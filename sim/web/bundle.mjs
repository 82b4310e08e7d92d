// Bundles the scripts. `node sim/web/bundle.mjs` makes all of them; `node sim/web/bundle.mjs ENTRY OUTPUT`
// one, both relative to this folder. Each is one classic file, unminified and committed, so that it can
// be read and teachers need no Node.js.
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));
const ENTRIES = {
  "dist/carts.js": "src/main.js",
  "dist/answers.js": "src/answers-main.js",
  "dist/challenge.js": "src/challenge-main.js",
  "dist/class.js": "src/class-main.js",
  "dist/hosted.js": "src/hosted-main.js",
  "dist/tools.js": "src/tools-main.js",
  "dist/tour.js": "src/tour-main.js",
  "dist/proof.js": "src/proof-main.js",
  "dist/teacher.js": "src/teacher-main.js",
  "dist/measured.js": "src/measured-main.js",
  "dist/worlds.js": "src/worlds-main.js",
  "dist/law.js": "src/law-main.js",
  "dist/film.js": "src/film-main.js",
  "dist/draw.js": "src/draw-main.js",
};

const shared = {
  absWorkingDir: here,
  bundle: true,
  format: "iife",
  target: ["chrome103", "firefox113", "safari16.4"],
  charset: "utf8",
  legalComments: "inline",
  logLevel: "warning",
};

/** `import text from "./x.js?text"`: the bundled file as text, for a worker made of a Blob. */
const asText = {
  name: "as-text",
  setup(bundler) {
    bundler.onResolve({ filter: /\?text$/ }, ({ path: name, resolveDir }) => ({
      // from here, not from the root: the bundle names its parts, and is the same everywhere
      path: path.relative(here, path.join(resolveDir, name.replace(/\?text$/, ""))),
      namespace: "as-text",
    }));
    bundler.onLoad({ filter: /.*/, namespace: "as-text" }, async ({ path: file }) => {
      const { outputFiles } = await build({
        ...shared,
        entryPoints: [path.join(here, file)],
        write: false,
      });
      return { contents: outputFiles[0].text, loader: "text", watchFiles: [path.join(here, file)] };
    });
  },
};

/**
 * When the generator draws, nothing is clicked: linkedom keeps no table of listeners for every node, which
 * would take a third of the time.
 */
const noListeners = {
  name: "no-listeners",
  setup(bundler) {
    bundler.onLoad({ filter: /linkedom[\\/]worker\.js$/ }, ({ path: file }) => {
      let contents = readFileSync(file, "utf8");
      for (const [before, after] of [
        ["wm.set(this, new Map);", ""],
        [
          "addEventListener(type, listener, options) {",
          "addEventListener() {}\n  _listen(type, listener, options) {",
        ],
      ]) {
        if (contents.split(before).length !== 2) throw new Error(`linkedom has changed: ${before}`);
        contents = contents.replace(before, after);
      }
      return { contents, loader: "js" };
    });
  },
};

/**
 * Comments in front of a line are for readers of the source: esbuild drops them, but for those in the body of
 * a class, and for types in the middle of a line, which every page would load.
 */
const noComments = {
  name: "no-comments",
  setup(bundler) {
    bundler.onLoad({ filter: /\.js$/ }, ({ path: file }) =>
      file.includes("node_modules")
        ? undefined
        : {
            contents: readFileSync(file, "utf8")
              .replace(/^ *\/\*\*(?:(?!\*\/)[\s\S])*\*\/\n/gm, "")
              .replace(/\/\*\* @type [^*]*\*\/ ?/g, ""),
            loader: "js",
          },
    );
  },
};

/** sim/effects/views.js names the view of every effect: of each folder there, whatever has one. */
function collectEffects() {
  const effects = path.join(here, "..", "effects");
  const kinds = readdirSync(effects, { withFileTypes: true })
    .filter((entry) => entry.isDirectory() && !entry.name.startsWith("_"))
    .map(({ name }) => name)
    .sort();
  const seen = kinds.filter((kind) => existsSync(path.join(effects, kind, "view.js")));
  const lines = [
    "/** The view of every effect. Written by `make bundle` from the folders beside this file. */",
    "",
    ...seen.map((kind) => `import ${kind} from "./${kind}/view.js";`),
    "",
    '/** @type {Record<string, import("../view/types.js").EffectView>} */',
    "export const VIEWS = {",
    ...kinds.map((kind) => (seen.includes(kind) ? `  ${kind},` : `  "${kind}": {},`)),
    "};",
    "",
  ];
  const file = path.join(effects, "views.js");
  const before = existsSync(file) ? readFileSync(file, "utf8") : "";
  if (before !== lines.join("\n")) writeFileSync(file, lines.join("\n"));
}

/** Beside draw.js: the licences of linkedom and of all that its one file is made of. */
function collectLicences() {
  const modules = path.join(here, "..", "..", "node_modules");
  const found = new Map();
  const visit = (name) => {
    if (found.has(name)) return;
    const folder = path.join(modules, name);
    const about = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
    const file = readdirSync(folder).find((one) => /^licen[cs]e/i.test(one));
    const text = file ? readFileSync(path.join(folder, file), "utf8").trim() : about.license;
    found.set(name, `${name} ${about.version} (${about.license})\n\n${text}\n`);
    for (const next of Object.keys(about.dependencies ?? {})) visit(next);
  };
  visit("linkedom");
  const parts = [...found.keys()].sort().map((name) => found.get(name));
  const head = "Works of others in draw.js, which draws when a site is built, and their terms.\n";
  const rule = `\n${"=".repeat(80)}\n\n`;
  writeFileSync(path.join(here, "dist", "draw-licences.txt"), [head, ...parts].join(rule));
}

async function make(entry, output) {
  const outfile = path.resolve(here, output);
  await build({
    ...shared,
    entryPoints: [entry],
    outfile,
    plugins: [asText, noListeners, noComments],
  });
}

collectEffects();
const [entry, output] = process.argv.slice(2);
if (entry) await make(entry, output);
else {
  collectLicences();
  for (const [file, source] of Object.entries(ENTRIES)) await make(source, file);
}
