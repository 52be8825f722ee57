/** Numbers as people read them. */
import type { Common, Program } from './data';
import { h } from './dom';

/** Four significant digits; never 1e+03 for a thousand. */
export function numberText(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size >= 1000 && size < 1e7) return value.toFixed(0);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return value.toExponential(2);
  return String(Number(value.toPrecision(4)));
}

/** A number rounded to what its uncertainty allows: two digits of it. */
export function withUncertainty(value: number, half: number): string {
  if (!(half > 0) || !Number.isFinite(half)) return numberText(value);
  const decimals = Math.max(0, Math.min(12, 1 - Math.floor(Math.log10(half))));
  return `${value.toFixed(decimals)} ± ${half.toFixed(decimals)}`;
}

/** "0.25 m", "45°". */
export function quantity(value: number | null | undefined, unit: string): string {
  const text = numberText(value);
  if (text === '–' || unit === '') return text;
  return unit === '°' ? text + unit : `${text}\u00a0${unit}`;
}

export class Keys {
  constructor(private readonly page: Pick<Common, 'keys'>) {}

  /** "launch length". */
  words(key: string): string {
    return this.page.keys[key]?.words ?? key;
  }

  unit(key: string): string {
    return this.page.keys[key]?.unit ?? '';
  }

  /** "launch length [m]". */
  label(key: string): string {
    const unit = this.unit(key);
    return unit === '' ? this.words(key) : `${this.words(key)} [${unit}]`;
  }

  /** What a surrogate models: a metric's label, or a statistic of it over the events in words. */
  modelled(name: string, metric: string): string {
    return name === metric ? this.label(metric) : name.split(metric).join(this.words(metric));
  }

  definition(key: string): string | undefined {
    return this.page.keys[key]?.definition;
  }

  quantity(key: string, value: number | string | null | undefined): string {
    return typeof value === 'string' ? value : quantity(value, this.unit(key));
  }
}

/** An element that shows a number and carries all its digits. */
export function valueElement(value: number | null | undefined, text = numberText(value)): HTMLElement {
  if (value === null || value === undefined) return h('span', { class: 'none' }, '–');
  return h('data', { value: String(value), title: String(value) }, text);
}

/** "parapet 0.1.0 (81e30a8d018a)". */
export function programText({ version, git_revision }: Program): string {
  return `parapet ${version}${git_revision ? ` (${git_revision})` : ''}`;
}

/** "3 designs", "1 design". */
export function count(n: number, noun: string): string {
  return `${n} ${noun}${n === 1 ? '' : 's'}`;
}
