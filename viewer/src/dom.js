// Elements of the page. Texts become text nodes, never markup: names come from
// the user's files.

/** An element with attributes and children; `on…` attributes are listeners. */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  return fill(element, attributes, children);
}

/** The same of SVG. */
export function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  return fill(element, attributes, children);
}

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) {
      element.addEventListener(name.slice(2), value);
    } else {
      element.setAttribute(name, value === true ? "" : value);
    }
  }
  element.append(...children.flat(Infinity).filter((child) =>
    child !== undefined && child !== null && child !== false));
  return element;
}

/** A table; the first column heads its rows. */
export function table(caption, titles, rows) {
  const cell = (tag, scope) => (content) =>
    h(tag, { scope, class: typeof content === "number" ? "number" : null },
      content instanceof Node ? content : String(content ?? ""));
  return h("div", { class: "wide", role: "region", tabindex: "0",
                    "aria-label": caption },
    h("table", {},
      h("caption", {}, caption),
      h("thead", {}, h("tr", {}, titles.map(cell("th", "col")))),
      h("tbody", {}, rows.map(([first, ...rest]) =>
        h("tr", {}, cell("th", "row")(first), rest.map(cell("td")))))));
}
