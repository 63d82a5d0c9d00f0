// The page of `clevis report`.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { Timeline, viewControls } from "./controls.js";
import { decisivePart, load } from "./data.js";
import { h } from "./dom.js";
import { follow } from "./follow.js";
import { JointNames, Legend, Markers } from "./overlay.js";
import { Picked } from "./picked.js";
import { charts } from "./plots.js";
import { addPrinting } from "./print.js";
import { Stage } from "./stage.js";
import { bearings, checks, inputs, mechanismTable, partSection, verdictWord,
  verdicts } from "./tables.js";

function header({ result, motion, isCheck, parts }) {
  const dates = motion.inputs.map((input) => input.modified).sort();
  const newest = dates[dates.length - 1];
  return h("header", {},
    h("h1", {}, result.scene),
    isCheck && h("p", { class: "overall" }, "Verdict: ",
                 verdictWord(result.verdict),
                 result.complete ? null : " – interrupted, parts are missing"),
    h("p", { class: "made" }, [
      newest && `Inputs of ${newest.replace("T", " ").replace("Z", " UTC")}`,
      `clevis ${motion.version}`,
      parts.length > 0 && `${parts.length} part${parts.length > 1 ? "s" : ""}`,
      motion.bodies.length > 0 && `${motion.instants_of_motion} instants`]
      .filter(Boolean).join(" · ")));
}

/** Stage, or a note where the browser draws nothing in 3-D. */
function tryStage(canvas, data) {
  try {
    return new Stage(canvas, data);
  } catch (failure) {
    canvas.replaceWith(h("p", { class: "note" },
      `This browser cannot draw in 3-D (${failure.message}); the tables and ` +
      "charts below hold all numbers."));
    return null;
  }
}

function section(title, ...content) {
  const children = content.flat().filter(Boolean);
  return children.length > 0 && h("section", {}, h("h2", {}, title), children);
}

function build(data) {
  const { motion, parts } = data;
  const canvas = h("canvas", { class: "stage", tabindex: "0", role: "img",
    "aria-label": "The mechanism in space. Arrow keys step through time, " +
      "space plays." });
  const overlay = h("div", { class: "overlay" });
  const view = h("div", { class: "picture" }, canvas, overlay);
  const root = document.getElementById("report");
  const side = h("div", { class: "side" });
  const below = h("div", { class: "controls" });
  const chartGrid = h("div", { class: "charts" });
  let pickPart = () => {};
  const moves = motion.bodies.length > 0;
  root.replaceChildren(header(data), h("main", {},
    data.isCheck && parts.length + data.result.failures.length > 0 &&
      section("Verdict", verdicts(data, (part) => pickPart(part))),
    h("section", {}, h("h2", {}, moves ? "The mechanism" : "The part"),
      h("div", { class: "stage-row" }, h("div", {}, view, below), side)),
    section("Over time", chartGrid),
    section("Parts", parts.map(partSection)),
    section("Mechanism", mechanismTable(data), bearings(data),
      (data.result.mechanism?.notes ?? data.result.motion?.notes ?? [])
        .map((note) => h("p", {}, note))),
    section("Made from", inputs(data), parts.length > 0 && checks(data),
      h("details", {}, h("summary", {}, "The scene"),
        h("pre", { tabindex: "0" }, motion.scene_text)))));
  const stage = tryStage(canvas, data);
  if (!stage) {
    for (const chart of charts(data)) {
      chartGrid.append(chart.element);
      chart.resize();
    }
    follow(data.watch, null);
    return;
  }
  pickPart = run(data, stage, { canvas, overlay, side, below, chartGrid });
}

/** Everything that moves. @returns what shows a part's worst point */
function run(data, stage, { canvas, overlay, side, below, chartGrid }) {
  const { motion, parts } = data;
  const times = [...new Set([...motion.t_s,
    ...parts.flatMap((part) => part.is_motion ? part.times : [])])]
    .map((t) => Math.fround(t)).sort((a, b) => a - b)
    .filter((t, i, all) => i === 0 || t !== all[i - 1]);
  let plots = [];
  const picked = new Picked(stage, (t) => timeline.go(t));
  const timeline = new Timeline(times.length > 0 ? times : [0], (t) => {
    stage.show({ t });
    picked.update(t);
    for (const plot of plots) plot.time = t;
  });
  const names = new JointNames(overlay, stage, motion);
  const show = viewControls(stage, data, names, (part) => {
    stage.show({ part });
    stage.fit();
  });
  const worst = (part) => Math.fround(part.times[part.peak_frame]);
  const pickPart = (part) => {
    if (part.is_motion) timeline.go(worst(part));
    picked.show(part, part.peak_point, { worst: true });
    canvas.scrollIntoView({ block: "nearest" });
  };
  const markers = new Markers(overlay, stage, parts, pickPart);
  stage.showForces = parts.length === 0;
  stage.onDraw = () => {
    markers.place();
    names.place();
  };
  if (parts.length > 0) {
    const largest = Math.max(...parts.flatMap((part) =>
      part.frames.peak_von_mises_MPa));
    side.append(new Legend(largest, (range) => {
      stage.range = range;
      stage.draw();
    }).element, picked.element);
  }
  below.append(...[motion.bodies.length > 0 && timeline.element, show.element]
    .filter(Boolean));
  addPicking(canvas, stage, picked);
  addKeys(timeline);
  stage.resize();
  // The first picture shows what the verdict says.
  const decisive = decisivePart(parts);
  if (decisive) timeline.t = worst(decisive);
  timeline.start();
  stage.fit();
  stage.live = true;
  stage.draw();
  document.documentElement.dataset.firstFrame = Math.round(performance.now());
  plots = charts(data, (t) => timeline.go(t));
  chartGrid.append(...plots.map((plot) => plot.element));
  const refit = () => {
    stage.resize();
    for (const plot of [...plots, picked.chart]) plot?.resize();
  };
  new ResizeObserver(refit).observe(canvas.parentElement);
  timeline.start();
  addPrinting(stage, parts, timeline);
  // For scripts and tests: where points are seen, and what they carry.
  globalThis.clevisReport = { data, stage, timeline, pickPart, plots };
  follow(data.watch, { data, stage, timeline, choosePart: (index) => {
    show.part.value = index;
    show.part.dispatchEvent(new Event("change"));
  } });
  return pickPart;
}

/** A click, not a drag, picks. */
function addPicking(canvas, stage, picked) {
  let down = null;
  canvas.addEventListener("pointerdown", (event) => {
    down = [event.clientX, event.clientY];
  });
  canvas.addEventListener("pointerup", (event) => {
    if (!down) return;
    const moved = Math.hypot(event.clientX - down[0], event.clientY - down[1]);
    down = null;
    if (moved > 4) return;
    const hit = stage.pick(event.offsetX, event.offsetY);
    if (hit) picked.show(hit.part, hit.point);
  });
}

/** Space plays, arrows step, wherever no control wants the key itself. */
function addKeys(timeline) {
  document.addEventListener("keydown", (event) => {
    if (event.target.closest("input, select, button, summary, pre, .wide")) {
      return;
    }
    const action = { " ": () => timeline.toggle(),
      ArrowRight: () => timeline.step(1), ArrowLeft: () => timeline.step(-1),
      Home: () => timeline.go(timeline.times[0]),
      End: () => timeline.go(timeline.times[timeline.times.length - 1]),
    }[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
}

load().then((data) => {
  build(data);
  document.documentElement.dataset.built = "";  // for scripts and tests
});
