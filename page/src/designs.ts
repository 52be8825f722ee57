/** The designs of a study by row, and the quantities that any view may ask for. */
import type { DesignsPage } from './data';
import type { Keys } from './format';

/** Variables, objectives, limits and metrics: whatever has a value at each design. */
export interface Quantity {
  key: string; // unique: "metric:launch_length_m"
  name: string;
  label: string;
  group: 'variable' | 'objective' | 'constraint' | 'metric';
  values: (number | string | null)[];
  /** Names of a choice's options, in their order. */
  options?: string[];
  /** Which way is better, where that is known. */
  goal?: 'maximize' | 'minimize';
}

export type Kind = 'front' | 'front-warned' | 'feasible' | 'warned' | 'infeasible' | 'coarse' | 'failed';

export const kinds: { kind: Kind; words: string; short: string }[] = [
  { kind: 'front', words: 'on the front', short: 'front' },
  { kind: 'front-warned', words: 'on the front, with warnings', short: 'front (warned)' },
  { kind: 'feasible', words: 'meets every constraint', short: 'feasible' },
  { kind: 'warned', words: 'meets them, with warnings', short: 'feasible (warned)' },
  { kind: 'infeasible', words: 'breaks a constraint', short: 'infeasible' },
  { kind: 'coarse', words: 'simulated coarsely', short: 'coarse' },
  { kind: 'failed', words: 'failed', short: 'failed' },
];

export class DesignTable {
  readonly quantities: Quantity[] = [];
  readonly rowOf = new Map<string, number>();
  readonly kind: Kind[];

  constructor(
    readonly page: DesignsPage,
    keys: Keys,
  ) {
    const { designs } = page;
    designs.id.forEach((id, row) => this.rowOf.set(id, row));
    const add = (group: Quantity['group'], name: string, values: Quantity['values'], extra: Partial<Quantity> = {}): void => {
      this.quantities.push({ key: `${group}:${name}`, name, label: keys.label(name), group, values, ...extra });
    };
    for (const variable of page.variables) {
      add('variable', variable.name, designs.variables[variable.name] ?? [], { options: variable.options });
    }
    for (const objective of page.objectives) {
      add('objective', objective.name, designs.objectives[objective.name] ?? [], { goal: objective.goal });
    }
    for (const [name, values] of Object.entries(designs.constraints)) add('constraint', name, values);
    const known = new Set(this.quantities.map((one) => one.name));
    for (const [key, values] of Object.entries(designs.metrics)) {
      if (!known.has(key) && values.some((value) => value !== null)) add('metric', key, values);
    }
    this.kind = designs.id.map((_, row) => this.kindOf(row));
  }

  get rows(): number {
    return this.page.designs.id.length;
  }

  find(key: string): Quantity | undefined {
    return this.quantities.find((one) => one.key === key);
  }

  private kindOf(row: number): Kind {
    const { designs, finest_spacing_m } = this.page;
    if (designs.status[row] !== 'ok') return 'failed';
    const warned = (designs.warnings[row] ?? []).length > 0;
    if (designs.front[row]) return warned ? 'front-warned' : 'front';
    const coarse = designs.counts ? !designs.counts[row] : designs.spacing_m[row]! > (finest_spacing_m ?? Infinity) * (1 + 1e-9);
    if (coarse) return 'coarse';
    if (!designs.feasible[row]) return 'infeasible';
    return warned ? 'warned' : 'feasible';
  }

  /** "0035: angle 58°, height 0.139 m". */
  words(row: number, keys: Keys): string {
    return this.quantities
      .filter((one) => one.group === 'variable' && one.values[row] !== null && one.values[row] !== undefined)
      .map((one) => `${keys.words(one.name)} ${keys.quantity(one.name, one.values[row])}`)
      .join(', ');
  }
}

/** Whether designs of a kind are on the front. */
export const onFront = (kind: Kind): boolean => kind === 'front' || kind === 'front-warned';

/** A place on an axis: the value, or the number of an option. */
export function axisValue(quantity: Quantity, row: number): number | null {
  const value = quantity.values[row];
  if (typeof value === 'string') return quantity.options ? quantity.options.indexOf(value) : null;
  return value ?? null;
}

/** Rows whose value is among the best share of those that have one. */
export function bestRows(quantity: Quantity, share: number, counts: (row: number) => boolean): Set<number> {
  const rows = quantity.values
    .map((value, row) => ({ value, row }))
    .filter((one): one is { value: number; row: number } => typeof one.value === 'number' && counts(one.row));
  const sign = quantity.goal === 'maximize' ? -1 : 1;
  rows.sort((a, b) => sign * (a.value - b.value));
  const kept = Math.ceil(share * rows.length - 1e-9);
  return new Set(rows.slice(0, kept).map((one) => one.row));
}
