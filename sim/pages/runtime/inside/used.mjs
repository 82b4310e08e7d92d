// Lists the files of the standard library that a page uses.
import { boot, helpers, install, job, write } from "./boot.mjs";

const pyodide = await boot(job);
for (const wheel of job.wheels) await install(pyodide, wheel);
const { call } = helpers(pyodide, job.programs);
call("import_named", job.modules, true);
call("import_named", job.perhaps, false);
const later = job.packages.flatMap((name) => call("import_package", name, job.absent, job.apart, true).toJs());
if (job.entry) call("warm_up", job.entry);
call("make_errors");
try {
  pyodide.runPython("undefined_name");
} catch {
  // formatting the error for JavaScript is what was wanted
}
const used = JSON.parse(call("files_used", "/lib/python314.zip"));
write(job.out, JSON.stringify({ used, later }));
