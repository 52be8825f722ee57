/** Light and dark: the system's choice until the reader makes one. */
import { h } from './dom';
import { view } from './view';

type Theme = 'light' | 'dark';
const listeners: (() => void)[] = [];
const system = window.matchMedia('(prefers-color-scheme: dark)');

export function theme(): Theme {
  const chosen = document.documentElement.dataset['theme'];
  if (chosen === 'light' || chosen === 'dark') return chosen;
  return system.matches ? 'dark' : 'light';
}

export function onTheme(listener: () => void): void {
  listeners.push(listener);
}

/** A colour of the style sheet. */
export function color(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

function tell(): void {
  for (const listener of listeners) listener();
}

export function themeButton(): HTMLElement {
  const saved = view.choice('theme', ['light', 'dark', ''], '');
  if (saved) document.documentElement.dataset['theme'] = saved;
  const button = h('button', { type: 'button', class: 'theme', click: () => set() });
  const label = (): void => {
    button.textContent = theme() === 'dark' ? 'Light' : 'Dark';
    button.setAttribute('aria-label', `Switch to ${theme() === 'dark' ? 'light' : 'dark'} colours`);
  };
  const set = (): void => {
    document.documentElement.dataset['theme'] = theme() === 'dark' ? 'light' : 'dark';
    view.set('theme', theme());
    label();
    tell();
  };
  system.addEventListener('change', () => {
    label();
    tell();
  });
  label();
  return button;
}
