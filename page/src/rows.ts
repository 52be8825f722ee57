/** Columns of a table, and what filters and orders its rows. */
import type { Child } from './dom';

export interface Column {
  key: string;
  label: string;
  title?: string;
  /** What sorting and export use. */
  value: (row: number) => string | number | boolean | null;
  /** What is shown; default: the value as text. */
  show?: (row: number) => Child;
  numeric?: boolean;
  /** A name: never broken at its hyphens. */
  name?: boolean;
}

/** "launch length < 0.1" and the like, joined by commas; anything else is looked for as text. */
export function parseCondition(
  text: string,
  columns: Column[],
): ((row: number) => boolean) | null {
  const words = text.trim();
  if (words === '') return null;
  const tests = words.split(/\s*(?:,|\band\b)\s*/i).map((part): ((row: number) => boolean) => {
    const found = /^(.+?)\s*(<=|>=|<|>|=)\s*(.+)$/.exec(part);
    const named = found?.[1]?.toLowerCase();
    const column =
      named === undefined
        ? undefined
        : (columns.find((one) => one.key.toLowerCase() === named || one.label.toLowerCase() === named) ??
          columns.find((one) => one.label.toLowerCase().replace(/ \[.*/, '') === named) ??
          columns.find((one) => one.key.toLowerCase().startsWith(named.replace(/ /g, '_'))));
    if (!found || !column) {
      const needle = part.toLowerCase();
      return (row) =>
        columns.some((one) => String(one.value(row) ?? '').toLowerCase().includes(needle));
    }
    const [, , operator, right] = found;
    const limit = Number(right);
    return (row) => {
      const value = column.value(row);
      if (operator === '=') return String(value).toLowerCase() === right!.toLowerCase() || (value !== null && Number(value) === limit);
      if (typeof value !== 'number' || Number.isNaN(limit)) return false;
      if (operator === '<') return value < limit;
      if (operator === '<=') return value <= limit;
      return operator === '>' ? value > limit : value >= limit;
    };
  });
  return (row) => tests.every((test) => test(row));
}

/** Orders rows by a column; what has no value comes last either way. */
export function sortRows(rows: number[], column: Column, up: boolean): number[] {
  const sign = up ? 1 : -1;
  const empty = (value: unknown): boolean => value === null || value === '' || Number.isNaN(value);
  return [...rows].sort((a, b) => {
    const [x, y] = [column.value(a), column.value(b)];
    if (empty(x) || empty(y)) return empty(x) === empty(y) ? a - b : empty(x) ? 1 : -1;
    if (typeof x === 'number' && typeof y === 'number') return sign * (x - y) || a - b;
    return sign * String(x).localeCompare(String(y), 'en', { numeric: true }) || a - b;
  });
}
