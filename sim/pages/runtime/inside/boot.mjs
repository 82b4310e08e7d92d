// Starts Pyodide in Node as if nothing outside existed: no clock, no random numbers, no environment.
// Two runs in different folders, years and time zones then leave the same bytes in memory.
import crypto from "node:crypto";
import fs from "node:fs";
import { syncBuiltinESMExports } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const MOMENT = Date.UTC(2026, 0, 1); // any fixed one will do

function stopTheWorld() {
  const RealDate = Date;
  globalThis.Date = class extends RealDate {
    constructor(...given) {
      super(...(given.length ? given : [MOMENT]));
    }
    static now() {
      return MOMENT;
    }
  };
  performance.now = () => 0;
  Math.random = () => 0.5;
  const zeros = (view) => {
    new Uint8Array(view.buffer, view.byteOffset, view.byteLength).fill(0);
    return view;
  };
  crypto.randomFillSync = zeros;
  globalThis.crypto.getRandomValues = zeros;
  syncBuiltinESMExports();
  process.argv.length = 1; // or Python would know this script's folder as its own name
}

process.on("uncaughtException", (error) => {
  console.error(error.message ?? error); // without the stack, which is Pyodide's minified text
  process.exitCode = 1;
});

/** What to read and where to write comes as JSON on standard input: no arguments, no environment. */
export const job = JSON.parse(fs.readFileSync(0, "utf8"));

/**
 * @param {{core: string, stdlib?: string}} where folder of Pyodide's files; a standard library
 *   other than Pyodide's own
 * @param {object} options for loadPyodide
 */
export async function boot({ core, stdlib }, options = {}) {
  stopTheWorld();
  const { loadPyodide } = await import(pathToFileURL(path.join(core, "pyodide.mjs")).href);
  return loadPyodide({
    indexURL: core,
    stdLibURL: stdlib ?? path.join(core, "python_stdlib.zip"),
    args: [],
    env: { HOME: "/home/pyodide", LANG: "en_US.UTF-8", PYTHONHASHSEED: "0", TZ: "UTC" },
    _sysExecutable: "python",
    stdout: (line) => console.error(line),
    ...options,
  });
}

/**
 * Loads programs into a namespace of their own, which leaves no trace in the page's Python.
 * @returns {{call: (name: string, ...given: unknown[]) => any, forget: () => void}}
 */
export function helpers(pyodide, programs) {
  const globals = pyodide.globals.get("dict")();
  for (const file of programs) {
    pyodide.runPython(new TextDecoder().decode(read(file)), { globals });
  }
  return {
    call: (name, ...given) => globals.get(name)(...given.map((value) => pyodide.toPy(value))),
    forget: () => globals.destroy(),
  };
}

/**
 * Installs a wheel with the very function that `loadPackage` uses in the page.
 * @param {string} file
 */
export async function install(pyodide, file) {
  const api = pyodide._api;
  await api.install(read(file), path.basename(file), api.sitePackages, pyodide.toPy({}));
  pyodide.runPython("import importlib; importlib.invalidate_caches()");
}

/** @param {string} file */
export const read = (file) => new Uint8Array(fs.readFileSync(file));

/** @param {string} file @param {Uint8Array|string} bytes */
export const write = (file, bytes) => fs.writeFileSync(file, bytes);
