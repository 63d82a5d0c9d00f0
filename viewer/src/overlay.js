// What stands over the picture: markers of the worst points, names of joints,
// the legend.
import { Vector3 } from "three";
import { colourBytes } from "./colour.js";
import { h } from "./dom.js";
import { number } from "./format.js";

/** A button at the worst point of each part. */
export class Markers {
  constructor(holder, stage, parts, onPick) {
    this.stage = stage;
    this.items = parts.map((part) => {
      const { value_MPa: value, case: when, at_mm: at } = part.peak;
      const button = h("button", { type: "button", class: "marker",
        "aria-label": `Worst point of ${part.name}: ${number(value)} MPa, ${when}`,
        title: `${part.name}: ${number(value)} MPa, ${when}`,
        onclick: () => onPick(part) });
      holder.append(button);
      return { part, at, button };
    });
  }

  place() {
    for (const { part, at, button } of this.items) {
      const seen = this.stage.seen(part, at);
      button.hidden = !seen.visible;
      button.style.transform = `translate(${seen.x}px, ${seen.y}px)`;
    }
  }
}

/** The names of joints. */
export class JointNames {
  constructor(holder, stage, motion) {
    this.stage = stage;
    this.items = motion.joints.map((joint) => {
      const label = h("span", { class: "joint-name", "aria-hidden": "true" },
                      joint.name);
      holder.append(label);
      return label;
    });
    this.shown = true;
  }

  place() {
    const { clientWidth, clientHeight } = this.stage.renderer.domElement;
    const visible = this.shown && this.stage.state.part === null;
    this.stage.mechanism.joints.forEach((mesh, j) => {
      const at = mesh.getWorldPosition(new Vector3()).project(this.stage.camera);
      const label = this.items[j];
      label.hidden = !visible;
      label.style.transform = `translate(${(at.x + 1) / 2 * clientWidth + 8}px, ` +
        `${(1 - at.y) / 2 * clientHeight - 20}px)`;
    });
  }
}

/** The colours with their stresses; the user sets the range. */
export class Legend {
  constructor(largest, onRange) {
    this.onRange = onRange;
    this.whole = [0, largest];
    const size = 256;
    const canvas = h("canvas", { width: 1, height: size, class: "colours",
                                 "aria-hidden": "true" });
    const image = new ImageData(new Uint8ClampedArray(colourBytes(size)), 1, size);
    const turned = new ImageData(1, size);
    for (let i = 0; i < size; ++i) {
      turned.data.set(image.data.subarray(4 * i, 4 * i + 4), 4 * (size - 1 - i));
    }
    canvas.getContext("2d").putImageData(turned, 0, 0);
    const field = (label) => h("input", { type: "number", min: 0, step: "any",
      "aria-label": label, onchange: () => this.#read() });
    this.high = field("Stress at the upper end of the colours [MPa]");
    this.low = field("Stress at the lower end of the colours [MPa]");
    this.element = h("fieldset", { class: "legend" },
      h("legend", {}, "von Mises [MPa]"), this.high, canvas, this.low,
      h("button", { type: "button",
        onclick: () => this.set(...this.whole) }, "Whole range"));
    this.set(...this.whole);
  }

  #read() {
    const low = Number(this.low.value), high = Number(this.high.value);
    if (Number.isFinite(low) && high > low) this.set(low, high);
    else this.set(...this.range);
  }

  set(low, high) {
    this.range = [low, high];
    this.low.value = Number(low.toPrecision(4));
    this.high.value = Number(high.toPrecision(4));
    this.onRange(this.range);
  }
}
