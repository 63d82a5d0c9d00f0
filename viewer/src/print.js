// On paper: everything open, and a picture of each part at its worst instant.
import { h } from "./dom.js";
import { number } from "./format.js";

/** Pictures of the whole, then of each part alone, as image elements. */
function pictures(stage, parts, timeline) {
  const before = { ...stage.state };
  const take = (caption) => {
    // a canvas: an image element would still be loading when paper is laid out
    const drawn = stage.renderer.domElement;
    const copy = h("canvas", { width: drawn.width, height: drawn.height,
                               role: "img", "aria-label": caption });
    copy.getContext("2d").drawImage(drawn, 0, 0);
    return h("figure", { class: "print-only" }, copy,
             h("figcaption", {}, caption));
  };
  const list = [];
  for (const part of parts.length > 1 ? parts : []) {
    const t = part.is_motion ? part.times[part.peak_frame] : before.t;
    stage.show({ part, t });
    stage.fit();
    list.push(take(`${part.name}, ${part.peak.case}: von Mises stress up to ` +
      `${number(part.peak.value_MPa)} MPa at ${part.peak.group}; colours from ` +
      `${number(stage.shared.range.value[0])} to ` +
      `${number(stage.shared.range.value[1])} MPa`));
  }
  stage.show(before);
  stage.fit();
  timeline.start();
  return list;
}

export function addPrinting(stage, parts, timeline) {
  let opened = [], added = [];
  addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll("details:not([open])")];
    for (const details of opened) details.open = true;
    added = pictures(stage, parts, timeline);
    document.querySelector(".controls").after(...added);
  });
  addEventListener("afterprint", () => {
    for (const details of opened) details.open = false;
    for (const figure of added) figure.remove();
  });
}
