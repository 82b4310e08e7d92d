// Runs before the page's own scripts and says when each step of Python's start begins and ends, in the
// page and in its workers, in ms since the page was asked for: `window.steps`, [name, begin, end] each.
(() => {
  const now = () => performance.timeOrigin + performance.now();
  const steps = [];
  window.steps = steps;
  const step = (name, begin) => steps.push([name, begin - performance.timeOrigin, performance.now()]);
  const timed = (home, method, name) => {
    const real = home[method];
    if (!real) return;
    home[method] = function (...given) {
      const begin = now();
      const made = real.apply(this, given);
      if (made?.then) made.then(() => step(name, begin));
      else step(name, begin);
      return made;
    };
  };
  timed(Uint8Array, "fromBase64", "base64");
  timed(SubtleCrypto.prototype, "digest", "sha256");
  timed(WebAssembly, "compileStreaming", "compile");
  const append = Element.prototype.append;
  Element.prototype.append = function (...added) {
    for (const script of added.filter(({ tagName }) => tagName === "SCRIPT")) {
      const begin = now();
      script.addEventListener("load", () => step("script", begin));
    }
    return append.apply(this, added);
  };
  const inWorker = `{
    const now = () => performance.timeOrigin + performance.now();
    const post = self.postMessage.bind(self);
    const step = (name, begin) => post({ step: [name, begin, now()] });
    step("worker runs", now());
    const real = WebAssembly.instantiate;
    WebAssembly.instantiate = async (...given) => {
      const begin = now();
      const made = await real.apply(WebAssembly, given);
      step("instance", begin);
      return made;
    };
  }\n`;
  const RealBlob = Blob;
  window.Blob = class extends RealBlob {
    constructor(parts, options) {
      super(options?.type === "text/javascript" ? [inWorker, ...parts] : parts, options);
    }
  };
  const RealWorker = Worker;
  window.Worker = class extends RealWorker {
    constructor(address) {
      const begin = now();
      super(address);
      this.addEventListener("message", (event) => {
        const { step: its, tell, stage, bytes } = event.data;
        if (its?.[0] === "worker runs") step("worker", begin);
        else if (its) steps.push([its[0], ...its.slice(1).map((at) => at - performance.timeOrigin)]);
        if (its) event.stopImmediatePropagation();
        else if (bytes) step("unpacked", begin);
        else step([tell, stage].filter(Boolean).join(" "), begin);
      });
    }
  };
})();
