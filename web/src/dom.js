/// An element with attributes (functions are listeners) and children.
export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value !== false) node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children);
  return node;
}

export const byId = (id) => document.getElementById(id);

/// A labelled control.
export const labelled = (text, control) => element("label", {}, element("span", {}, text), control);

/// A choice of one of several fields; `change` is called with its number.
export function choice(id, fields, change) {
  const options = fields.map((f, n) => element("option", { value: n }, f.label));
  return element("select", { id, change: (e) => change(Number(e.target.value)) }, ...options);
}
