// An open report of `clevis check --watch` in a real Chromium.
//
//     node follow.mjs REPORT.html SCENE
//
// It shows the new verdict after SCENE is saved, where the reader stood; it says
// that a scene is refused. Nothing on the console, no request but its mark's.
// Prints a fault per line; exit code 1 if there is one, 77 without a browser.
import assert from "node:assert/strict";
import { readFileSync, renameSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { browser, open } from "./browser.mjs";

const [file, scene] = process.argv.slice(2);
const chromium = await browser();
if (!chromium) {
  console.log("skipped: no chromium; Debian's package chromium brings it");
  process.exit(77);
}
const url = pathToFileURL(resolve(file)).href;
const mark = pathToFileURL(join(dirname(resolve(file)), "report_watch.svg")).href;
const { page, said, requests } = await open(chromium, url);
const timeout = 120000;
const text = readFileSync(scene, "utf8");
function save(content) {
  writeFileSync(`${scene}.swp`, content);
  renameSync(`${scene}.swp`, scene);
}
const overall = () => page.$eval(".overall", (element) => element.textContent);
const watched = (words) => page.waitForFunction((wanted) =>
  document.querySelector(".watched")?.textContent.includes(wanted), { timeout }, words);
let code = 0;
try {
  assert.match(await overall(), /pass/);
  await watched("follows the scene");
  await page.evaluate(() => {
    const { stage } = globalThis.clevisReport;
    stage.camera.position.set(123, 45, 678);
    stage.controls.target.set(1, 2, 3);
    stage.controls.update();
  });
  const seen = () => page.evaluate(() => globalThis.clevisReport.stage.camera.position.toArray());
  const before = await seen();
  save(text.replace("safety_factor = 1.5", "safety_factor = 150"));
  await page.waitForFunction(() =>
    /fail/.test(document.querySelector(".overall")?.textContent), { timeout });
  console.log("ok: it shows the new verdict");
  const after = await seen();
  assert.ok(before.every((value, k) => Math.abs(value - after[k]) < 1e-6),
            `camera at ${after}, was at ${before}`);
  console.log("ok: seen from where it was");
  save("schema = [");
  await watched("refused");
  assert.match(await overall(), /fail/);
  console.log("ok: it says that the scene is refused");
  save(text);
  await page.waitForFunction(() =>
    /pass/.test(document.querySelector(".overall")?.textContent), { timeout });
  console.log("ok: and follows again");
  assert.deepEqual(said, []);
  assert.ok(requests.length > 0);
  assert.deepEqual(requests.filter((request) => !request.startsWith(`${mark}?`)), []);
  console.log("ok: nothing on the console, no request but its mark's");
} catch (failure) {
  console.log(`FAULT: ${failure.message}; console: ${said.join(" | ")}`);
  code = 1;
}
await chromium.close();
process.exit(code);
