// Bundles viewer/src into viewer/dist, which clevis embeds.
//
//     node build.mjs           writes dist
//     node build.mjs --check   fails unless dist is what the sources make
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import * as esbuild from "esbuild";

const top = dirname(fileURLToPath(import.meta.url));
const built = await esbuild.build({
  absWorkingDir: top,
  entryPoints: { viewer: "src/main.js" },
  bundle: true,
  minify: true,
  charset: "ascii",
  format: "iife",
  target: ["chrome100", "firefox113", "safari16.4"],
  legalComments: "eof",
  outdir: "dist",
  write: false,
});
const files = Object.fromEntries(
  built.outputFiles.map((file) => [file.path.split("/").pop(), file.text]));
for (const [name, text] of Object.entries(files)) {
  if (/<\/(script|style)|<!--/i.test(text)) {
    throw new Error(`${name} would end the element that holds it`);
  }
}
const hash = (text) =>
  `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;
files["viewer.csp"] =
  `script-src ${hash(files["viewer.js"])}; style-src ${hash(files["viewer.css"])}`;

const stored = (name) => {
  try {
    return readFileSync(join(top, "dist", name), "utf8");
  } catch {
    return "";
  }
};
let different = 0;
for (const [name, text] of Object.entries(files)) {
  if (!process.argv.includes("--check")) {
    writeFileSync(join(top, "dist", name), text);
    console.log(`dist/${name}: ${text.length} bytes`);
  } else if (text !== stored(name)) {
    console.error(`dist/${name} is not what the sources make: node build.mjs`);
    different = 1;
  }
}
process.exitCode = different;
