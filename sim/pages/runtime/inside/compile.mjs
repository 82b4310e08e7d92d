// Compiles the modules of archives with Pyodide's own Python.
import { boot, helpers, job, read, write } from "./boot.mjs";

const pyodide = await boot(job);
const { call } = helpers(pyodide, job.programs);
for (const { from, to, optimize, wheel } of job.archives) {
  const result = call("compile_archive", read(from), optimize, wheel);
  write(to, result.toJs());
  result.destroy();
}
