// Bundles the page's script. `node sim/web/bundle.mjs [entry [output]]`, both relative to this folder.
// One classic file, unminified and committed, so that it can be read and teachers need no Node.js.
import path from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));
const [entry = "src/main.js", output = "dist/carts.js"] = process.argv.slice(2);

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

await build({
  ...shared,
  entryPoints: [entry],
  outfile: path.resolve(here, output),
  plugins: [asText],
});
