// The least page that runs Python: what a widget does, without a widget.
import { startRuntime } from "../../sim/web/src/runtime/runtime.js";

const { packages = "", request = '{"id": 1, "kind": "run"}' } = document.body.dataset;
const base = new URL("runtime/", document.currentScript?.src ?? document.baseURI).href;
window.startRuntime = startRuntime;
window.runtimeBase = base;
window.progress = [];

window.booted = startRuntime({
  base,
  packages: packages.split(" ").filter(Boolean),
  onProgress: (progress) => window.progress.push({ ...progress, ms: performance.now() }),
}).then(
  async (runtime) => {
    window.runtime = runtime;
    const { header, numbers } = await runtime.request(JSON.parse(request));
    return { start: runtime.start, header, numbers: [...numbers], ms: performance.now() };
  },
  ({ message, reason, detail }) => ({ message, reason, detail, ms: performance.now() }),
);
