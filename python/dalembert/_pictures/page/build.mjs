// `npm ci && npm run build`: makes bundle.js of the sources beside it and three.js, and notes of which sources, for the tests.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const SOURCES = ["axes.js", "data.js", "floor.js", "grip.js", "link.js", "live.js", "monitor.js", "motion.js", "notebook.js", "page.js", "panels.js", "panes.js", "picture.js", "plot.js", "shapes.js", "times.js", "view.js", "package.json", "package-lock.json"];

await build({
  entryPoints: ["page.js"],
  outfile: "bundle.js",
  bundle: true,
  minify: true,
  format: "iife",
  globalName: "dalembert",
  charset: "ascii",
  legalComments: "eof",
});
const sum = (names) => createHash("sha256").update(Buffer.concat(names.map((name) => readFileSync(name)))).digest("hex");
writeFileSync("bundle.sums", `sources ${sum(SOURCES)}\nbundle ${sum(["bundle.js"])}\n`);
