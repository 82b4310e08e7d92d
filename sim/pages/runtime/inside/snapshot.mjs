// Takes a picture of Python's memory with our package imported and used once.
import { boot, helpers, job, read, write } from "./boot.mjs";
import { catchFresh, sparse } from "./sparse.mjs";

const fresh = catchFresh();
const pyodide = await boot(job, { _makeSnapshot: true });
const heap = pyodide._module.HEAP8.length;
// Where `loadPackage` puts what a page loads later: those modules are then found beside these.
pyodide.unpackArchive(read(job.wheel), "wheel", { extractDir: pyodide._api.sitePackages });
const importlib = pyodide.pyimport("importlib");
importlib.invalidate_caches();
importlib.destroy();
const { call, forget } = helpers(pyodide, job.programs);
for (const name of job.packages) call("import_package", name, job.absent, job.apart, false).destroy();
call("warm_up", job.entry);
call("tidy");
forget();

// What was freed is still written there. Zeros pack better, and leave no trace of this machine.
const module = pyodide._module;
const top = module._malloc(1 << 20);
module._free(top);
const held = [];
for (let size = 1 << 20; size >= 8; size = size > 64 ? (size * 0.8) & ~7 : size - 8) {
  for (;;) {
    const at = module._malloc(size);
    if (!at || at + size > top) {
      module._free(at);
      break;
    }
    module.HEAPU8.fill(0, at, at + size);
    held.push(at);
  }
}
for (const at of held) module._free(at);

if (module.HEAP8.length !== heap) {
  // A snapshot larger than the memory Pyodide starts with can't be restored.
  throw new Error(`our package needs ${module.HEAP8.length} bytes of memory to start, more than ${heap}`);
}
write(job.out, sparse(pyodide.makeMemorySnapshot(), fresh.memory));
