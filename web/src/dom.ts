// Elements made in code. Text always becomes a text node: names and titles of a case are shown, never interpreted.

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | null | undefined | ((event: never) => void)>;

const SVG = 'http://www.w3.org/2000/svg';

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(key.slice(2), value as EventListener);
    else if (value === true) element.setAttribute(key, '');
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(key, String(value));
  }
  for (const child of children) if (child) element.append(child);
}

/** An HTML element; attributes whose value is a function are listeners ("onclick"), those that are false or null are left out. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

/** The same for a drawing. */
export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, tag);
  fill(element, attributes, children);
  return element;
}

const NAME_MAX = 160;

/** A name from the case: kept apart from the direction of the text around it, cut where it is longer than a line can be. */
export function named(text: string | null | undefined): HTMLElement {
  const name = text ?? '';
  if (name.length <= NAME_MAX) return el('bdi', { class: 'name' }, name);
  return el('bdi', { class: 'name', title: name.slice(0, 2000) }, `${name.slice(0, NAME_MAX)}…`);
}

export function button(label: string, onclick: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return el('button', { type: 'button', onclick, ...attributes }, label);
}
