/** What the reader has chosen. A saved copy of the page holds it, and opens the same. */
import { button } from './dom';

type Value = string | number | boolean | string[] | number[];

/** Whether a stored value is of the kind that is asked for: the page may be of another version. */
function likeness(a: unknown, b: unknown): boolean {
  return Array.isArray(a) === Array.isArray(b) && typeof a === typeof b;
}

export class View {
  private readonly values: Record<string, Value>;

  constructor(text: string | null | undefined) {
    let parsed: unknown = {};
    try {
      parsed = JSON.parse(text || '{}');
    } catch {
      // A damaged view is none.
    }
    this.values = typeof parsed === 'object' && parsed !== null ? (parsed as Record<string, Value>) : {};
  }

  get<T extends Value>(key: string, otherwise: T): T {
    const stored = this.values[key];
    return stored !== undefined && likeness(stored, otherwise) ? (stored as T) : otherwise;
  }

  /** The stored value where it is one of those allowed. */
  choice<T extends string | number>(key: string, allowed: readonly T[], otherwise: T): T {
    const stored = this.get(key, otherwise as string | number);
    return allowed.includes(stored as T) ? (stored as T) : otherwise;
  }

  set(key: string, value: Value): void {
    this.values[key] = value;
  }

  /** JSON that can stand inside a script element. */
  text(): string {
    return JSON.stringify(this.values).replace(/</g, '\\u003c');
  }
}

const own = typeof document === 'undefined' ? null : document;
// A page that is served keeps its view when it is made anew.
const kept = own && location.protocol === 'http:' ? sessionStorage.getItem('view') : null;
export const view = new View(own?.getElementById('page-view')?.textContent ?? kept);
const program = own?.currentScript?.textContent ?? '';

/** The page as it was written, with the view of now. */
export function savedPage(): string {
  const blocks = document.getElementById('page-blocks')!.cloneNode(true) as HTMLElement;
  blocks.querySelector('#page-view')?.remove();
  const chosen = document.createElement('script');
  chosen.type = 'application/json';
  chosen.id = 'page-view';
  chosen.textContent = view.text();
  blocks.append(chosen);
  const script = document.createElement('script');
  script.textContent = program;
  const head = [...document.head.children].filter((one) => one.id !== 'page-blocks').map((one) => one.outerHTML);
  return `<!doctype html>\n<html lang="en">\n<head>\n${head.join('\n')}\n</head>\n<body>\n${blocks.outerHTML}\n${script.outerHTML}\n</body>\n</html>\n`;
}

export function saveButton(name: string): HTMLElement {
  const save = (): void => {
    const address = URL.createObjectURL(new Blob([savedPage()], { type: 'text/html;charset=utf-8' }));
    const link = document.createElement('a');
    link.href = address;
    link.download = `${name.replace(/[^\w.-]+/g, '_')}.html`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
  };
  return button('Save this view', save, { class: 'save', title: 'A copy of this page that opens with the designs, axes, colours and time that are shown now' });
}
