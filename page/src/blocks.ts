/** What the page holds: its data, and blocks of bytes by their names. */
import type { Page } from './data';

/** Reads the page's data; throws where there are none. */
export function readPage(): Page {
  const element = document.getElementById('page-data');
  if (!element) throw new Error('the page holds no data');
  return JSON.parse(element.textContent ?? '') as Page;
}

/** The bytes of a block of the page; null where it does not hold it. */
export function blockBytes(id: string | undefined): Uint8Array | null {
  const element = id ? document.getElementById(id) : null;
  return element ? fromBase64(element.textContent ?? '') : null;
}

function fromBase64(text: string): Uint8Array {
  const binary = atob(text.trim());
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
  return bytes;
}
