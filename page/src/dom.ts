/** Elements from data. Text is only ever set as text: no string of a spec becomes markup. */

export type Child = Node | string | number | null | undefined | false;

type Attributes = Record<string, string | number | boolean | undefined | ((event: Event) => void)>;

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') {
      element.addEventListener(name, value);
    } else if (value === true) {
      element.setAttribute(name, '');
    } else if (value !== undefined && value !== false) {
      element.setAttribute(name, String(value));
    }
  }
  add(element, ...children);
}

/** h('p', {class: 'note'}, 'text', h('b', {}, 'bold')). Functions among the attributes are listeners. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

/** The same for drawings. */
export function svg(tag: string, attributes: Attributes = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  fill(element, attributes, children);
  return element;
}

export function add(element: Element, ...children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child instanceof Node ? child : String(child));
  }
}

export function clear(element: Element): void {
  element.replaceChildren();
}

/** A labelled choice; `change` gets the value. */
export function select(
  label: string,
  options: { value: string; text: string }[],
  chosen: string,
  change: (value: string) => void,
): HTMLElement {
  const list = h('select', { change: () => change(list.value) });
  for (const option of options) {
    list.append(h('option', { value: option.value, selected: option.value === chosen }, option.text));
  }
  return h('label', { class: 'field' }, h('span', {}, label), list);
}

/** A labelled tick box. */
export function checkbox(
  label: Child,
  checked: boolean,
  change: (checked: boolean) => void,
): HTMLLabelElement {
  const box = h('input', { type: 'checkbox', checked, change: () => change(box.checked) });
  return h('label', { class: 'tick' }, box, ' ', label);
}

export function button(text: string, press: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return h('button', { type: 'button', click: press, ...attributes }, text);
}

let sections = 0;

/** A section with its heading, which the navigation lists. */
export function section(id: string, title: string, ...children: Child[]): HTMLElement {
  const heading = `heading-${++sections}`;
  return h(
    'section',
    { id, 'aria-labelledby': heading },
    h('h2', { id: heading }, title),
    ...children,
  );
}
