// The least page that runs Python: what a widget does, without a widget.
import { startRuntime } from "../../../sim/web/src/runtime/runtime.js";

const { packages = "", request = '{"id": 1, "kind": "run"}' } = document.body.dataset;
const base = new URL("runtime/", document.currentScript?.src ?? document.baseURI).href;
window.startRuntime = startRuntime;
window.runtimeBase = base;
window.progress = [];

// What a reader waits, in ms in which this page was awake: a busy machine's clock is not the page's.
window.waited = 0;
setInterval(() => {
  window.waited += 100;
}, 100);

window.booted = startRuntime({
  base,
  packages: packages.split(" ").filter(Boolean),
  patience: window.bootPatience,
  onProgress: (progress) => {
    if (progress.stage.startsWith("slow")) window.slowAfter = window.waited;
    else window.waited = 0;
    window.progress.push(progress);
  },
}).then(
  async (runtime) => {
    window.runtime = runtime;
    const { header, numbers } = await runtime.request(JSON.parse(request));
    return { start: runtime.start, header, numbers: [...numbers], ms: performance.now() };
  },
  ({ message, reason, detail }) => ({ message, reason, detail, waited: window.waited }),
);
