// A report of `clevis check --watch`: notices that it was written anew. A page
// opened from disk may read no other file, but it learns the size of a picture:
// the mark beside it, whose width is the number of the run that the report is
// of and whose height is the state of the check (docs/results.md).
import { h } from "./dom.js";

const PAUSE = 1000;  // between two looks [ms]
const KEPT = `clevis view ${location.pathname}`;
const SAID = {
  1: "Watched: this report follows the scene.",
  2: "Watched: files have changed, the check runs again.",
  3: "Watched: the files as they are were refused; this is the report before.",
};
const GONE = "No longer watched: this report is the last one.";

/** What the reader looked at before the page was loaded anew. */
function kept() {
  try {
    const text = sessionStorage.getItem(KEPT);
    sessionStorage.removeItem(KEPT);
    return JSON.parse(text);
  } catch {  // a browser that stores nothing for files
    return null;
  }
}

function keep({ stage, timeline, data }) {
  try {
    sessionStorage.setItem(KEPT, JSON.stringify({
      t: timeline.t, part: stage.state.part?.name ?? null,
      position: stage.camera.position.toArray(),
      target: stage.controls.target.toArray(), scene: data.result.scene }));
  } catch {}  // it starts at the beginning then
}

/** Looks as the reader did, as far as the report still has it. */
function restore({ data, stage, timeline, choosePart }) {
  const view = kept();
  if (!view || view.scene !== data.result.scene) return;
  const part = data.parts.findIndex(({ name }) => name === view.part);
  if (part >= 0) choosePart(part);
  timeline.go(view.t);
  stage.camera.position.fromArray(view.position);
  stage.controls.target.fromArray(view.target);
  stage.controls.update();
  stage.draw();
}

/** @param watch  what the page holds of it; null: not watched */
export function follow(watch, page) {
  if (!watch || location.protocol !== "file:") return;
  const note = h("p", { class: "watched", role: "status" }, SAID[1]);
  document.querySelector("header").append(note);
  if (page) restore(page);
  let looks = 0;
  const look = () => {
    const mark = new Image();
    mark.onload = () => {
      if (mark.naturalWidth !== watch.run) {
        if (page) keep(page);
        location.reload();
        return;
      }
      note.textContent = SAID[mark.naturalHeight] ?? SAID[1];
      setTimeout(look, PAUSE);
    };
    mark.onerror = () => {
      note.textContent = GONE;
      setTimeout(look, 5 * PAUSE);
    };
    mark.src = `${watch.mark}?${watch.run}.${++looks}`;
  };
  setTimeout(look, PAUSE);
}
