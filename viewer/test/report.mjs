// Reports in a real Chromium.
//
//     node report.mjs [--brief] [--pictures FOLDER] REPORT.html RESULT_DIR [REPORT.html RESULT_DIR]...
//
// Each loads without a word on the console and without a request, plays, scrubs
// by keyboard, picks, prints; axe finds nothing serious; the colour at the
// worst point of a part is that of its stress in result.json. --brief leaves out
// what is the same in every report: axe, decimal commas, strips in charts.
// Prints a fault per line; exit code 1 if there is one, 77 without a browser.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { cpus, loadavg } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { browser, open } from "./browser.mjs";

const { values: { brief, pictures }, positionals } = parseArgs({
  allowPositionals: true,
  options: { brief: { type: "boolean" }, pictures: { type: "string" } } });
const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const MOST_BYTES = 5e6, FIRST_FRAME = 2000;  // [ms]
// Colours are told in 256 steps, of which 8 bits a channel keep most.
const SAME_COLOUR = 6;
// A window with fewer pixels to draw without a graphics card.
const SMALL = { width: 800, height: 600 };

const faults = [];
async function check(what, test) {
  try {
    await test();
    if (!brief) console.log(`ok: ${what}`);
  } catch (failure) {
    faults.push(what);
    console.log(`FAULT: ${what}: ${failure.message}`);
  }
}
/** A check of what every report has alike. */
const checkOnce = (what, test) => brief ? undefined : check(what, test);

const chromium = await browser();
if (!chromium) {
  console.log("skipped: no chromium; Debian's package chromium brings it");
  process.exit(77);
}

async function tryReport(file, folder) {
  const html = readFileSync(file);
  const isCheck = (() => {
    try {
      return JSON.parse(readFileSync(join(folder, "result.json")));
    } catch {
      return null;
    }
  })();
  const { page, session, said, requests } = await open(chromium,
                                              pathToFileURL(resolve(file)).href,
                                            brief ? SMALL : undefined);
  const picture = async (name) => pictures &&
    writeFileSync(join(pictures, name), await page.screenshot());
  const clock = () => page.$eval(".clock", (element) => element.textContent);

  await check(`at most ${MOST_BYTES / 1e6} MB`, () => {
    console.log(`size: ${html.length} bytes`);
    assert.ok(html.length <= MOST_BYTES);
  });
  await check("first frame within 2 s", async () => {
    const first = Number(await page.evaluate(() =>
      document.documentElement.dataset.firstFrame));
    const busy = loadavg()[0] > 0.5 * cpus().length;
    console.log(`first frame: ${first} ms${busy ? ", on a busy machine" : ""}`);
    assert.ok(first > 0);
    // a busy machine tells by the processor's time, of the page's own process
    const { metrics } = await session.send("Performance.getMetrics");
    const worked = 1e3 * metrics.find(({ name }) => name === "ThreadTime").value;
    console.log(`processor time of the page: ${Math.round(worked)} ms`);
    assert.ok((busy ? worked : first) <= FIRST_FRAME);
  });
  await check("opens at the worst instant of the part that decides", async () => {
    const order = ["fail", "not judged", "pass"];
    const wanted = (part) => part.safety_factor / (part.limits?.safety_factor ?? 1);
    const moving = await page.evaluate(() => globalThis.clevisReport.data.parts
      .filter((part) => part.is_motion).map((part) => part.name));
    const [worst] = (isCheck?.parts ?? []).filter(({ name }) => moving.includes(name))
      .sort((a, b) => order.indexOf(a.verdict) - order.indexOf(b.verdict) ||
                      wanted(a) - wanted(b));
    const t = await page.evaluate(() => globalThis.clevisReport.timeline.t);
    const first = await page.evaluate(() => globalThis.clevisReport.timeline.times[0]);
    const expected = worst?.peak_outside_singular_zones?.instant_s ??
                     worst?.peak_von_mises.instant_s ?? first;
    assert.ok(Math.abs(t - expected) <= 1e-6 * Math.abs(expected),
              `t = ${t} s, ${worst?.name} is worst at ${expected} s`);
  });
  await check("verdicts show the stress that is judged", async () => {
    const shown = await page.evaluate(() => globalThis.clevisReport.data.parts
      .map((part) => part.governing.value_MPa));
    const rows = await page.evaluate(() => [...document.querySelectorAll("table")]
      .filter((table) => table.caption?.textContent.startsWith("Verdict by part"))
      .flatMap((table) => [...table.tBodies[0].rows].map((row) => row.cells[2].textContent)));
    const judged = (isCheck?.parts ?? []).map(({ vibration, ...part }) =>
      vibration?.governs && vibration.band_MPa ? vibration.peak_MPa
        : (part.peak_outside_singular_zones ?? part.peak_von_mises).value_MPa);
    assert.deepEqual([...shown].sort(), [...judged].sort());
    const near = (text, value) => Math.abs(parseFloat(text.replace(",", ".")) - value) <= 1e-3 * value;
    for (const value of judged) {
      assert.ok(rows.some((text) => near(text, value)), `${value} MPa not in ${rows}`);
    }
  });
  await check("bars with a limit are explained", async () => {
    const [limits, keys] = await page.evaluate(() => [
      document.querySelectorAll(".bar .limit").length,
      document.querySelector(".keys")?.textContent ?? ""]);
    assert.equal(keys.includes("limit"), limits > 0);
    assert.equal(keys.includes("band"), (isCheck?.parts.length ?? 0) > 0);
  });
  await check("parts that could not be computed are drawn by their meshes", async () => {
    const drawn = await page.evaluate(() => {
      const { data, stage } = globalThis.clevisReport;
      return stage.shapes.map((shape) => {
        const { position } = shape.geometry.attributes;
        const x = Array.from({ length: position.count }, (_, v) => position.getX(v));
        const body = data.motion.bodies.findIndex((b) => b.name === shape.part.body);
        const others = body < 0 ? 0 : stage.mechanism.bodies[body].children
          .filter((child) => child !== shape.mesh).length;
        return { name: shape.part.name, others, seen: shape.mesh.visible &&
          shape.mesh.parent !== null && !shape.known.value &&
          Math.max(...x) - Math.min(...x) > 0.1 * shape.size };
      });
    });
    assert.deepEqual(drawn, (isCheck?.failures ?? []).map(({ part }) =>
      ({ name: part, others: 0, seen: true })));
  });
  await picture("report.png");
  const moves = await page.evaluate(() =>
    globalThis.clevisReport.data.motion.bodies.length > 0);
  if (moves) {
    await check("plays and pauses", async () => {
      const start = await clock();
      await page.click("button[aria-label=Play]");
      await page.waitForFunction((before) =>
        document.querySelector(".clock").textContent !== before, {}, start);
      await page.click("button[aria-label=Pause]");
      const paused = await clock();
      await new Promise((done) => setTimeout(done, 300));
      assert.equal(await clock(), paused);
    });
    await check("scrubs by keyboard, and the drawing follows", async () => {
      const pose = () => page.evaluate(() => globalThis.clevisReport.stage.mechanism
        .bodies.map((body) => body.matrixWorld.toArray()).flat());
      await page.focus(".stage");
      await page.keyboard.press("Home");
      const first = await pose();
      await page.keyboard.press("End");
      const last = await pose();
      assert.notDeepEqual(first, last);
      const end = await clock();
      await page.keyboard.press("ArrowLeft");  // bodies may rest by then
      assert.notEqual(await clock(), end);
      await page.focus(".timeline input[type=range]");
      await page.keyboard.press("Home");
      assert.deepEqual(await pose(), first);
    });
    await checkOnce("decimal commas of a German reader", async () => {
      await page.evaluate(() => {  // instants may all be whole seconds
        const { timeline } = globalThis.clevisReport;
        const [first, last] = [timeline.times[0], timeline.times.at(-1)];
        timeline.go(first + 0.123456 * (last - first));
      });
      const comma = await page.evaluate(() =>
        new Intl.NumberFormat().format(1.5).includes(","));
      assert.equal(/\d,\d/.test(await clock()), comma);
      assert.ok(comma, "the browser's locale is not German");
    });
  }

  await checkOnce("bands of peaks are shaded strips in the chart over time", async () => {
    const seen = await page.evaluate(() => {
      const { data, plots } = globalThis.clevisReport;
      const chart = plots.find((plot) => plot.bands.length > 0);
      const wanted = data.parts.some((part) => part.is_motion && part.times.length > 1 &&
        !part.result.peak_outside_singular_zones);
      if (!chart) return { wanted, strips: null };
      chart.element.scrollIntoView();
      const { plot, bands } = chart;
      const at = (value) => plot.valToPos(value, "y", true);
      const { canvas } = plot.ctx;
      const copy = Object.assign(document.createElement("canvas"),
        { width: canvas.width, height: canvas.height })
        .getContext("2d", { willReadFrequently: true });
      copy.drawImage(canvas, 0, 0);
      // a curve alone covers a column of pixels or two, a strip all of them
      const covered = (y) => [0.02, 0.2, 0.4, 0.6, 0.8, 0.98].filter((part) => {
        const x = Math.round(plot.bbox.left + part * plot.bbox.width);
        const alpha = copy.getImageData(x, Math.round(y), 1, 1).data[3];
        return alpha >= 60;  // a strip has 64, a line of the grid 18
      }).length >= 5;
      return { wanted, strips: bands.map(({ low, high }) => ({
        inside: covered(Math.max(at(high), (at(low) + at(high)) / 2 - 1)),
        isOnScale: at(high) >= plot.bbox.top })) };
    });
    if (!seen.wanted) return;
    assert.ok(seen.strips, "no chart has bands");
    for (const strip of seen.strips) assert.ok(strip.inside && strip.isOnScale, JSON.stringify(strip));
  });

  await check("limits are level lines in the chart of peaks", async () => {
    const { wanted, lines } = await page.evaluate(() => {
      const { data, plots } = globalThis.clevisReport;
      const moving = data.parts.filter((part) => part.is_motion && part.times.length > 1);
      const far = 4 * Math.max(...moving.map(({ peak }) => peak.band_MPa[1]));
      const limits = moving.filter(({ result }) => result.limits?.safety_factor)
        .map(({ result, definition }) =>
          definition.material.yield_strength_MPa / result.limits.safety_factor);
      const chart = plots.find(({ title }) => title.startsWith("Peak von Mises") &&
        !title.includes("blow"));
      const { series = [], data: values = [] } = chart?.plot ?? {};
      return { wanted: [...new Set(limits.filter((limit) => limit <= far))],
               lines: values.filter((_, k) => series[k].label.startsWith("limit"))
                 .map((all) => [Math.min(...all), Math.max(...all)]) };
    });
    assert.equal(lines.length, wanted.length);
    for (const limit of wanted) {
      assert.ok(lines.some(([low, high]) => low === limit && high === limit), limit);
    }
  });

  await check("blows are told with their stress", async () => {
    const shown = await page.evaluate(() =>
      [...document.querySelectorAll("table")].map((table) => ({
        caption: table.caption?.textContent ?? "",
        rows: [...table.tBodies[0].rows].map((row) => row.cells[1]?.textContent) })));
    const number = (text) => Number(text.replaceAll(".", "").replace(",", "."));
    for (const part of isCheck?.parts ?? []) {
      for (const blow of part.impacts ?? []) {
        const table = shown.find(({ caption }) =>
          caption === `Blow ${blow.name} on ${part.name}`);
        assert.ok(table, `no table of blow ${blow.name}`);
        for (const [k, { stress_MPa: stress }] of blow.models.entries()) {
          if (stress == null) continue;
          assert.ok(Math.abs(number(table.rows[k]) / stress - 1) < 1e-3,
            `${table.rows[k]} is shown for ${stress} MPa`);
        }
      }
    }
  });

  /** The colour that the screen shows, as three bytes. */
  async function screenColour({ x, y }) {
    const box = await (await page.$(".stage")).boundingBox();
    const scrolled = await page.evaluate(() => [scrollX, scrollY]);
    const shot = await page.screenshot({ encoding: "base64",
      clip: { x: Math.round(box.x + scrolled[0] + x) - 1,
              y: Math.round(box.y + scrolled[1] + y) - 1, width: 3, height: 3 } });
    return page.evaluate(async (data) => {
      // the page's policy lets images in from data: addresses
      const image = new Image();
      image.src = `data:image/png;base64,${data}`;
      await image.decode();
      const context = Object.assign(document.createElement("canvas"),
        { width: 3, height: 3 }).getContext("2d", { willReadFrequently: true });
      context.drawImage(image, 0, 0);
      return Array.from(context.getImageData(1, 1, 1, 1).data.slice(0, 3));
    }, shot);
  }

  /** The legend's colour of a stress, as it is drawn there. */
  const legendColour = (stress) => page.evaluate((value) => {
    const canvas = document.querySelector(".colours");
    const [low, high] = globalThis.clevisReport.stage.shared.range.value;
    const y = Math.round((canvas.height - 1) * (1 - (value - low) / (high - low)));
    const context = Object.assign(document.createElement("canvas"),
      { width: 1, height: canvas.height })
      .getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    return Array.from(context.getImageData(0, y, 1, 1).data.slice(0, 3));
  }, stress);

  for (const [index, part] of (isCheck?.parts ?? []).entries()) {
    await check(`colour at the worst point of ${part.name}`, async () => {
      // looked at from outside along the surface's normal, close by, without
      // light, joints and marks, at the worst instant
      const view = await page.evaluate((p) => {
        const { data, stage, pickPart } = globalThis.clevisReport;
        const part = data.parts[p];
        pickPart(part);
        stage.show({ part, scale: 0 });
        stage.shading = 0;
        document.querySelector(".overlay").style.display = "none";
        // a stress without bound has fallen within a pixel: the peak beside it
        const outside = part.result.peak_outside_singular_zones;
        if (!outside) return stage.lookAt(part, part.peak_point);
        const away = (p) => Math.hypot(...[0, 1, 2].map((d) =>
          part.positions[3 * p + d] - outside.at_mm[d]));
        let nearest = 0;
        for (let p = 1; p < part.points; ++p) {
          if (away(p) < away(nearest)) nearest = p;
        }
        stage.shared.range.value = [0, outside.value_MPa];
        return stage.lookAt(part, nearest);
      }, index);
      const shown = await screenColour(view.screen);
      const stress = view.stress;
      const outside = part.peak_outside_singular_zones;
      const expected = outside?.value_MPa ?? part.peak_von_mises.field_maximum_MPa ??
                       part.peak_von_mises.value_MPa;
      // away from the worst point the lattice is coarser
      assert.ok(Math.abs(stress - expected) <= (outside ? 0.1 : 2e-3) * expected,
                `${stress} MPa stored, ${expected} MPa in result.json`);
      const wanted = await legendColour(stress);
      const away = Math.max(...shown.map((v, c) => Math.abs(v - wanted[c])));
      assert.ok(away <= SAME_COLOUR, `${shown} on the screen, ${wanted} in the ` +
                `legend at ${stress} MPa`);
    });
  }
  if (isCheck?.parts.length > 0) {
    await page.evaluate(() => {
      const { stage } = globalThis.clevisReport;
      document.querySelector(".overlay").style.display = "";
      stage.shading = 1;
      stage.show({ part: null, scale: 1 });
      stage.fit();
    });
    await check("a click picks the point under it", async () => {
      const place = await page.evaluate(() => {
        const { data, stage } = globalThis.clevisReport;
        const part = data.parts[0];
        stage.show({ part });
        stage.fit();
        const view = stage.lookAt(part, part.peak_point);
        return view.screen;
      });
      const box = await (await page.$(".stage")).boundingBox();
      await page.evaluate(() => {
        document.querySelector(".overlay").style.display = "none";
      });
      await page.mouse.click(box.x + place.x, box.y + place.y);
      const text = await page.$eval(".picked", (element) => element.textContent);
      assert.match(text, new RegExp(`Point of ${isCheck.parts[0].name}`));
      assert.match(text, /MPa/);
      await page.evaluate(() => {
        document.querySelector(".overlay").style.display = "";
        const { stage } = globalThis.clevisReport;
        stage.show({ part: null });
        stage.fit();
      });
    });
    await check("the mark of a worst point tells its numbers", async () => {
      await page.$eval(".marker", (button) => button.click());
      const text = await page.$eval(".picked", (element) => element.textContent);
      assert.match(text, new RegExp(`Worst point of ${isCheck.parts[0].name}`));
    });
    await picture("picked.png");
  }
  await checkOnce("axe finds nothing serious", async () => {
    // beside the page's policy, which lets no other script in
    await page.evaluate(readFileSync(axe, "utf8"));
    const { violations } = await page.evaluate(() => globalThis.axe.run());
    const serious = violations.filter(({ impact }) =>
      ["serious", "critical"].includes(impact));
    assert.deepEqual(serious.map(({ id, nodes }) =>
      `${id}: ${nodes.slice(0, 2).map((node) => node.html).join(" | ")}`), []);
  });
  await check("prints on A4 with pictures", async () => {
    const pdf = Buffer.from(await page.pdf({ preferCSSPageSize: true }));
    if (pictures) writeFileSync(join(pictures, "report.pdf"), pdf);
    const text = pdf.toString("latin1");
    const images = (text.match(/\/Subtype ?\/Image/g) ?? []).length;
    const [, width, height] = text.match(
      /\/MediaBox ?\[0 0 ([\d.]+) ([\d.]+)\]/);
    assert.ok(Math.abs(width - 595) < 2 && Math.abs(height - 842) < 2,
              `${width} x ${height} pt`);
    const wanted = Math.max(1, isCheck?.parts.length ?? 1);
    assert.ok(images >= wanted, `${images} pictures of ${wanted}`);
  });
  await check("nothing on the console", () => assert.deepEqual(said, []));
  await check("no request", () => assert.deepEqual(requests, []));
  await page.close();
}

for (let at = 0; at < positionals.length; at += 2) {
  const [file, folder] = positionals.slice(at, at + 2);
  if (positionals.length > 2) console.log(file);
  await tryReport(file, folder);
}
await chromium.close();
process.exit(faults.length > 0 ? 1 : 0);
